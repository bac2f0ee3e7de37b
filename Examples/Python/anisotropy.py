"""Sweeps the anisotropy: from triangles of equal size to long ones that follow the bends.

    anisotropy.py [--points N] [--picture FILE.png]
"""
import anisotropic_remeshing as ar
import shapes

VALUES = (0.0, 0.04, 0.2)


def main(options):
    surface = shapes.surface(*shapes.knot())
    results = [ar.remesh(surface, options.points, anisotropy=value) for value in VALUES]
    captions = [f"{value:g}: RMS distance {result.distance.rms:.2g}"
                for value, result in zip(VALUES, results)]
    print("\n".join(captions))
    if options.picture:
        import panels
        panels.draw(options, [panels.mesh(result.mesh, "anisotropy " + caption)
                                      for result, caption in zip(results, captions)],
                    view=(0.3, -1.0, 1.6))


if __name__ == "__main__":
    main(shapes.options(__doc__, 1000))
