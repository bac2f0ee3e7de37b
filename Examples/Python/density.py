"""Makes points dense where an array says so: here along a spiral.

    density.py [--points N] [--picture FILE.png]
"""
import numpy

import anisotropic_remeshing as ar
import shapes


def spiral(points):
    """1 on a line that winds round the sphere, and 0 from a little beside it on."""
    longitude = numpy.arctan2(points[:, 1], points[:, 0])
    turns = 1.5 * numpy.arcsin(numpy.clip(points[:, 2], -1.0, 1.0)) / numpy.pi * 2.0
    away = numpy.abs((turns - longitude / (2.0 * numpy.pi) + 0.5) % 1.0 - 0.5)
    return numpy.exp(-(away / 0.12) ** 2)


def main(options):
    points, triangles = shapes.sphere(160)
    density = 1.0 + 255.0 * spiral(points)  # 256 times: a quarter of the spacing
    result = ar.remesh((points, triangles), options.points, anisotropy=0.0, density=density)
    areas = result.point_data["CellArea"]
    print(f"{len(result.points)} points; the largest cell has {areas.max() / areas.min():.0f} "
          "times the area of the smallest")
    if options.picture:
        import panels
        panels.draw(options, [
            panels.shade((points, triangles), numpy.log(density), "density, 1 to 256"),
            panels.mesh(result.mesh, f"{len(result.points)} points")], view=(1.0, -2.0, 1.6))


if __name__ == "__main__":
    main(shapes.options(__doc__, 2500))
