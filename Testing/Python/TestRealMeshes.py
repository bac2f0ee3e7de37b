"""Scans and smooth parts from an optional folder of meshes: closed ones stay closed.

    TestRealMeshes.py FOLDER

Without the folder the test is skipped (status 125).
"""
import os
import sys

from vtkmodules.vtkFiltersCore import vtkFeatureEdges
from vtkmodules.vtkIOPLY import vtkPLYReader

from anisotropic_remeshing import vtkAnisotropicRemesher

NAMES = {"spot.ply": 2, "rocker_arm.ply": 0, "armadillo.ply": 2}  # Euler characteristics
SKIPPED = 125


def fact(data, name):
    return int(data.GetFieldData().GetArray(name).GetTuple1(0))


def open_edges(surface):
    edges = vtkFeatureEdges()
    edges.SetInputData(surface)
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.Update()
    return edges.GetOutput().GetNumberOfLines()


def check(path, euler, anisotropy):
    reader = vtkPLYReader()
    reader.SetFileName(path)
    remesher = vtkAnisotropicRemesher()
    remesher.SetInputConnection(reader.GetOutputPort())
    remesher.SetNumberOfPoints(3000)
    remesher.SetAnisotropy(anisotropy)
    remesher.Update()
    mesh = remesher.GetOutput()
    found = (mesh.GetNumberOfPoints(), fact(mesh, "EulerCharacteristic"),
             fact(mesh, "NumberOfNonManifoldEdges"), open_edges(mesh))
    print(os.path.basename(path), anisotropy, *found)
    return found == (3000, euler, 0, 0)


def main():
    folder = sys.argv[1]
    paths = {os.path.join(folder, name): euler for name, euler in NAMES.items()}
    if not all(os.path.exists(path) for path in paths):
        print("skipped: no meshes in", folder)
        return SKIPPED
    wrong = [(path, s) for path, euler in paths.items() for s in (0.0, 0.02)
             if not check(path, euler, s)]
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
