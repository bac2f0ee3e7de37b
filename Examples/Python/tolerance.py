"""Asks for a distance instead of a number of points: as many are taken as that needs.

    tolerance.py [--picture FILE.png]
"""
import anisotropic_remeshing as ar
import shapes

VALUES = (2e-2, 5e-3, 1.5e-3)


def main(options):
    surface = shapes.surface(*shapes.gear())
    results = [ar.remesh(surface, tolerance=value) for value in VALUES]
    captions = [f"{value:g}: {len(result.points)} points"
                for value, result in zip(VALUES, results)]
    for caption, result in zip(captions, results):
        print(f"tolerance {caption}, largest distance {result.distance.maximum:.3g}, "
              f"diagonal {surface.GetLength():.3g}")
    if options.picture:
        import panels
        panels.draw(options, [panels.mesh(result.mesh, "tolerance " + caption)
                                      for result, caption in zip(results, captions)],
                    view=(0.5, -1.0, 1.1))


if __name__ == "__main__":
    main(shapes.options(__doc__, 0))
