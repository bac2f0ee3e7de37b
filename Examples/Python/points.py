"""The same surface with few and with many points: twice as many halve the distance, about.

    points.py [--points N] [--picture FILE.png]
"""
import anisotropic_remeshing as ar
import shapes


def main(options):
    surface = shapes.surface(*shapes.knot())
    results = [ar.remesh(surface, options.points * factor) for factor in (1, 4, 16)]
    captions = [f"{len(result.points)} points: RMS distance {result.distance.rms:.2g}"
                for result in results]
    print("\n".join(captions))
    if options.picture:
        import panels
        panels.draw(options, [panels.mesh(result.mesh, caption)
                                      for result, caption in zip(results, captions)],
                    view=(0.3, -1.0, 1.6))


if __name__ == "__main__":
    main(shapes.options(__doc__, 400))
