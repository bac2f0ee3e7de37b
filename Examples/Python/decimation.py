"""Compares a new mesh with one that VTK's decimation leaves, at as many points.

    decimation.py [--surface FILE] [--points N] [--picture FILE.png]
"""
from vtkmodules.vtkFiltersCore import vtkQuadricDecimation

import anisotropic_remeshing as ar
import shapes


def decimate(surface, points):
    """VTK's quadric decimation, to the triangles that so many points of a closed surface have."""
    filter = vtkQuadricDecimation()
    filter.SetInputDataObject(surface)
    filter.SetTargetReduction(1.0 - 2.0 * points / surface.GetNumberOfPolys())
    filter.Update()
    return filter.GetOutput()


def main(options):
    surface = (shapes.surface(*shapes.knot()) if options.surface is None
               else ar.embed(options.surface).surface)
    meshes = {"VTK's decimation": decimate(surface, options.points),
              "anisotropic remesher": ar.remesh(surface, options.points).mesh}
    captions = {}
    for name, mesh in meshes.items():
        numbers = ar.compare(mesh, surface).summary
        captions[name] = (f"{name}: RMS distance {100.0 * numbers['relative_rms_distance']:.3f} % "
                          f"of the diagonal")
        print(f"{captions[name]}, {numbers['number_of_points']} points, "
              f"mean normal deviation {numbers['mean_normal_deviation']:.2f} degrees, "
              f"smallest angle {numbers['least_minimum_angle']:.1f} degrees")
    if options.picture:
        import panels
        panels.draw(options,
                    [panels.mesh(mesh, captions[name]) for name, mesh in meshes.items()],
                    view=(2.0, -3.0, 3.3), size=(500, 420))


if __name__ == "__main__":
    main(shapes.options(__doc__, 1500, surface=None))
