"""Lets triangles follow data on a surface: the space that is meshed evenly is your own.

    embedding.py [--points N] [--picture FILE.png]

1. Give each point a place in R^d: here the position, and the data times a length.
2. The remesher spreads points evenly there. Where the data changes fast, the surface is steep
   in that space, and triangles become short across the front and long along it.
"""
import numpy

import anisotropic_remeshing as ar
import shapes


def flame(points):
    """A front in the shape of a five-armed star: 0 inside, 1 outside."""
    angle = numpy.arctan2(points[:, 1], points[:, 0])
    front = 0.95 + 0.25 * numpy.cos(5.0 * angle) - numpy.arccos(points[:, 2].clip(-1.0, 1.0))
    return 0.5 * (1.0 - numpy.tanh(front / 0.05))


def main(options):
    points, triangles = shapes.sphere(200)
    values = flame(points)
    space = numpy.column_stack([points, 1.2 * values])  # (n, 4)
    followed = ar.remesh((points, triangles), options.points, embedding=space)
    even = ar.remesh((points, triangles), options.points, anisotropy=0.0)
    errors = []
    for result in (even, followed):
        centers = result.points[result.triangles].mean(axis=1)
        centers /= numpy.linalg.norm(centers, axis=1)[:, None]
        between = flame(result.points)[result.triangles].mean(axis=1)
        errors.append(numpy.sqrt(numpy.mean((between - flame(centers)) ** 2)))
    print(f"data at the middle of triangles is off by {errors[0]:.3g} on even triangles, "
          f"{errors[1]:.3g} on those that follow it")
    if options.picture:
        import panels
        panels.draw(options, [
            panels.shade((points, triangles), values, "the data"),
            panels.shade(even.mesh, flame(even.points), f"{len(even.points)} even points", True),
            panels.shade(followed.mesh, flame(followed.points),
                         f"{len(followed.points)} points that follow it", True)],
            view=(0.15, -0.35, 1.0), up=(0, 1, 0))


if __name__ == "__main__":
    main(shapes.options(__doc__, 1500))
