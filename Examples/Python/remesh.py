"""Reads a surface, remeshes it, looks at the result and writes it.

    /usr/bin/python3 remesh.py INPUT OUTPUT [POINTS [ANISOTROPY]]

Files are .vtp, .ply, .stl, .obj or .vtk. The package is found in a build tree with
PYTHONPATH=build/lib/python3/dist-packages.
"""
import sys

import anisotropic_remeshing as ar


def main(source, target, points=3000, anisotropy=0.05):
    result = ar.remesh(source, int(points), anisotropy=float(anisotropy))
    print(f"{len(result.points)} points, {len(result.triangles)} triangles, "
          f"Euler characteristic {result.report['euler_characteristic']}")

    # Arrays are named, and numpy's, without a copy.
    areas = result.point_data["CellArea"]
    print(f"area {areas.sum():.6g}; of a point's cell: {areas.min():.3g} to {areas.max():.3g}")

    # How good it is, and how far from the surface.
    quality = ar.compare(result, source)
    print(f"mean quality {quality.summary['mean_quality']:.3f}, "
          f"RMS distance {quality.distance.rms:.3g}, largest {quality.distance.maximum:.3g}")
    result.save(target)


if __name__ == "__main__":
    if not 3 <= len(sys.argv) <= 5:
        sys.exit(__doc__.split("\n\n")[1].strip())
    try:
        main(*sys.argv[1:])
    except (ValueError, OSError) as error:
        sys.exit(f"remesh.py: {error}")
