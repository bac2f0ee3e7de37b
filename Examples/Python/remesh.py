"""Reads a surface, remeshes it, looks at the result and writes it.

    /usr/bin/python3 remesh.py INPUT.vtp OUTPUT.vtp [POINTS [ANISOTROPY]]

The package is found in a build tree with
PYTHONPATH=build/lib/python3/dist-packages.
"""
import sys

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

from anisotropic_remeshing import vtkAnisotropicRemesher


def main(source, target, points=3000, anisotropy=0.05):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(source)

    remesher = vtkAnisotropicRemesher()
    remesher.SetInputConnection(reader.GetOutputPort())
    remesher.SetNumberOfPoints(int(points))
    remesher.SetAnisotropy(float(anisotropy))
    remesher.Update()

    surface = remesher.GetOutput()
    if surface.GetNumberOfPoints() == 0:
        sys.exit(f"remesh.py: nothing to remesh in '{source}'")
    facts = surface.GetFieldData()
    print(f"{surface.GetNumberOfPoints()} points, {surface.GetNumberOfPolys()} triangles, "
          f"Euler characteristic {facts.GetArray('EulerCharacteristic').GetValue(0)}")

    # Arrays are named; numpy sees them without a copy.
    areas = vtk_to_numpy(surface.GetPointData().GetArray("CellArea"))
    print(f"area {areas.sum():.6g}; of a point's cell: {areas.min():.3g} to {areas.max():.3g}")

    # The other outputs: Voronoi cells, sites, convergence, edges.
    energy = vtk_to_numpy(remesher.GetConvergenceOutput().GetColumnByName("Energy"))
    print(f"energy {energy[0]:.6g} before, {energy[-1]:.6g} after {len(energy) - 1} iterations; "
          f"{remesher.GetVoronoiCellsOutput().GetNumberOfCells()} pieces of Voronoi cells")

    writer = vtkXMLPolyDataWriter()
    writer.SetInputConnection(remesher.GetOutputPort())
    writer.SetFileName(target)
    writer.SetDataModeToBinary()
    if not writer.Write() or writer.GetErrorCode():
        sys.exit(f"{target} cannot be written.")


if __name__ == "__main__":
    if not 3 <= len(sys.argv) <= 5:
        sys.exit(__doc__.split("\n\n")[1].strip())
    main(*sys.argv[1:])
