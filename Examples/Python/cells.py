"""Shows the Voronoi cells that a mesh is the dual of, coloured so that neighbours differ.

    cells.py [--surface FILE] [--points N] [--picture FILE.png]
"""
from vtkmodules.util.numpy_support import vtk_to_numpy

import anisotropic_remeshing as ar
import shapes


def main(options):
    surface = options.surface or shapes.surface(*shapes.knot())
    result = ar.remesh(surface, options.points, anisotropy=0.08)
    colors = vtk_to_numpy(result.cells.GetCellData().GetArray("CellColor"))
    areas = vtk_to_numpy(result.sites.GetPointData().GetArray("CellArea"))
    print(f"{result.sites.GetNumberOfPoints()} cells in {colors.max() + 1} colours; "
          f"together they have the area {areas.sum():.6g}")
    if options.picture:
        import panels
        panels.draw(options, [panels.cells(result, "Voronoi cells"),
                                      panels.mesh(result.mesh, "their dual: the mesh")],
                    view=(2.0, -3.0, 3.3), size=(500, 420))


if __name__ == "__main__":
    main(shapes.options(__doc__, 2000, surface=None))
