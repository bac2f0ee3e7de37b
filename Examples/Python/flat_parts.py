"""Spends fewer points where a part is flat, by a density array: the bends get those that are saved.

    /usr/bin/python3 flat_parts.py INPUT OUTPUT [POINTS [ANISOTROPY [DENSITY]]]

DENSITY (0.1) is that of flat places, 1 that of others: points lie there farther apart by its power
of -1/4. The package is found in a build tree with PYTHONPATH=build/lib/python3/dist-packages.
"""
import sys

import numpy

import anisotropic_remeshing as ar

FEATURE_ANGLE = numpy.radians(35.0)  # a sharper edge is a crease: no bend of the faces beside it
FLAT_RADIUS = 10.0  # of curvature, in diagonals of the bounding box


def bends(points, triangles):
    """For each triangle, the largest curvature over its sides, but for creases (1 / length)."""
    a, b, c = points[triangles].transpose(1, 0, 2)
    normals = numpy.cross(b - a, c - a)
    areas = numpy.maximum(0.5 * numpy.linalg.norm(normals, axis=1), 1e-300)
    normals /= 2.0 * areas[:, None]
    # Sides in order of their ends: those of the same two are next to each other.
    sides = numpy.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    owners = numpy.repeat(numpy.arange(len(triangles)), 3)
    order = numpy.lexsort(sides.T)
    same = numpy.all(sides[order[1:]] == sides[order[:-1]], axis=1)
    first, second = owners[order[:-1][same]], owners[order[1:][same]]
    ends = sides[order[1:][same]]
    cosines = numpy.einsum("ij,ij->i", normals[first], normals[second])
    angles = numpy.arccos(numpy.clip(cosines, -1.0, 1.0))
    lengths = numpy.linalg.norm(points[ends[:, 0]] - points[ends[:, 1]], axis=1)
    widths = 2.0 / 3.0 * (areas[first] + areas[second]) / numpy.maximum(lengths, 1e-300)
    curvatures = numpy.where(angles > FEATURE_ANGLE, 0.0, angles / widths)
    largest = numpy.zeros(len(triangles))
    numpy.maximum.at(largest, first, curvatures)
    numpy.maximum.at(largest, second, curvatures)
    return largest


def density_of(points, triangles, flat):
    """For each point, 1 if it is of a triangle that bends, else `flat`."""
    diagonal = numpy.linalg.norm(numpy.ptp(points, axis=0))
    density = numpy.full(len(points), flat)
    density[triangles[bends(points, triangles) * diagonal > 1.0 / FLAT_RADIUS]] = 1.0
    return density


def main(source, target, points=3000, anisotropy=0.5, flat=0.1):
    surface = ar.compare(source)  # its polygons as triangles
    result = ar.remesh(source, int(points), anisotropy=float(anisotropy),
                       density=density_of(surface.points, surface.triangles, float(flat)))
    print(f"{len(result.points)} points, RMS distance {result.distance.rms:.4g}, "
          f"largest {result.distance.maximum:.4g}")
    result.save(target)


if __name__ == "__main__":
    if not 3 <= len(sys.argv) <= 6:
        sys.exit(__doc__.split("\n\n")[1].strip())
    try:
        main(*sys.argv[1:])
    except (ValueError, OSError) as error:
        sys.exit(f"flat_parts.py: {error}")
