#!/usr/bin/env python3
"""The wrapped filters end to end: import, run, arrays as numpy, table, errors."""
import sys

import numpy
from vtkmodules.test import Testing
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource

import anisotropic_remeshing
from anisotropic_remeshing import (
    vtkAnisotropicRemesher,
    vtkGaussMapEmbedding,
    vtkRestrictedVoronoiDiagram,
)


def array(data, name):
    """A view of a named array of points, cells or rows."""
    found = data.GetArray(name)
    assert found is not None, f"no array {name}"
    return vtk_to_numpy(found)


def area_of(mesh):
    """Area of a mesh of triangles."""
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    corners = points[vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)]
    sides = corners[:, 1:] - corners[:, :1]
    return 0.5 * numpy.linalg.norm(numpy.cross(sides[:, 0], sides[:, 1]), axis=1).sum()


class TestRemesher(Testing.vtkTest):
    def setUp(self):
        self.sphere = vtkSphereSource()
        self.sphere.SetThetaResolution(60)
        self.sphere.SetPhiResolution(40)
        self.sphere.SetOutputPointsPrecision(1)
        self.sphere.GenerateNormalsOff()
        self.sphere.Update()
        self.surface = self.sphere.GetOutput()

    def remesher(self, points=200):
        remesher = vtkAnisotropicRemesher()
        remesher.SetInputConnection(self.sphere.GetOutputPort())
        remesher.SetNumberOfPoints(points)
        remesher.SetNumberOfLloydIterations(5)
        remesher.SetNumberOfNewtonIterations(5)
        return remesher

    def test_package(self):
        for name in anisotropic_remeshing.__all__:
            self.assertTrue(hasattr(anisotropic_remeshing, name), name)

    def test_run(self):
        remesher = self.remesher()
        remesher.Update()
        mesh = remesher.GetOutput()
        sites = remesher.GetSitesOutput()
        area = area_of(self.surface)
        for output in (mesh, sites):
            cell_area = array(output.GetPointData(), "CellArea")
            self.assertEqual(cell_area.dtype, numpy.float64)
            self.assertAlmostEqual(cell_area.sum() / area, 1.0, delta=1e-12)
        self.assertEqual(mesh.GetNumberOfPoints(), 200)
        self.assertEqual(mesh.GetNumberOfPolys(), 396)  # V - E + F = 2, 3 F = 2 E
        embedding = array(sites.GetPointData(), "Embedding")
        self.assertEqual(embedding.shape, (200, 6))
        self.assertTrue((array(sites.GetPointData(), "SiteId") == numpy.arange(200)).all())
        normals = array(mesh.GetPointData(), "Normals")
        points = vtk_to_numpy(mesh.GetPoints().GetData())
        radial = points / numpy.linalg.norm(points, axis=1)[:, None]
        self.assertGreater((normals * radial).sum(axis=1).min(), 0.99)

        cells = remesher.GetVoronoiCellsOutput().GetCellData()
        self.assertEqual(set(array(cells, "SiteId")), set(range(200)))
        edges = array(remesher.GetEdgesOutput().GetCellData(), "SiteId")
        self.assertEqual(edges.shape[1], 2)

    def test_table(self):
        remesher = self.remesher()
        remesher.Update()
        rows = remesher.GetConvergenceOutput().GetRowData()
        energy = array(rows, "Energy")
        self.assertEqual(len(energy), remesher.GetNumberOfIterations() + 1)
        self.assertTrue((numpy.diff(energy) <= 0.0).all())
        self.assertTrue((array(rows, "Iteration") == numpy.arange(len(energy))).all())
        self.assertEqual(array(rows, "StepLength")[0], 0.0)
        self.assertAlmostEqual(remesher.GetEnergy() / energy[-1], 1.0, delta=1e-12)
        self.assertGreater(remesher.GetPhaseSeconds("lloyd"), 0.0)
        self.assertNotEqual(remesher.GetUsedBackend(), "")

    def test_pipeline(self):
        """Embedding, remesher and diagram, one after the other."""
        embedding = vtkGaussMapEmbedding()
        embedding.SetInputConnection(self.sphere.GetOutputPort())
        embedding.SetAnisotropy(0.1)
        remesher = self.remesher()
        remesher.SetInputConnection(embedding.GetOutputPort())
        remesher.SetEmbeddingArray("Embedding")
        diagram = vtkRestrictedVoronoiDiagram()
        diagram.SetInputConnection(embedding.GetOutputPort())
        diagram.SetEmbeddingArray("Embedding")
        diagram.SetSitesConnection(remesher.GetOutputPort(vtkAnisotropicRemesher.SITES))
        diagram.Update()
        for name in ("CellArea", "CellMass", "CellEnergy", "Embedding", "Centroid"):
            self.assertTrue(
                (array(diagram.GetSitesOutput().GetPointData(), name)
                 == array(remesher.GetSitesOutput().GetPointData(), name)).all(), name)

    def test_own_embedding(self):
        """A numpy array as embedding: x stretched fourfold draws the sites out along the rest."""
        points = vtk_to_numpy(self.surface.GetPoints().GetData())
        stretched = numpy_to_vtk(points * (4.0, 1.0, 1.0), deep=True)
        stretched.SetName("Stretched")
        self.surface.GetPointData().AddArray(stretched)
        remesher = self.remesher()
        remesher.SetInputDataObject(self.surface)
        remesher.SetEmbeddingArray("Stretched")
        remesher.Update()
        self.assertEqual(remesher.GetDimension(), 3)
        spread = numpy.ptp(array(remesher.GetSitesOutput().GetPointData(), "Embedding"), axis=0)
        self.assertGreater(spread[0], 3.5 * spread[1])

    def test_errors(self):
        remesher = self.remesher(points=3)
        errors = []
        executive = []
        remesher.AddObserver("ErrorEvent", lambda *_: errors.append(1))
        remesher.GetExecutive().AddObserver("ErrorEvent", lambda *_: executive.append(1))
        remesher.Update()
        self.assertEqual((len(errors), len(executive)), (1, 1))
        for port in range(3):
            self.assertEqual(remesher.GetOutputDataObject(port).GetNumberOfPoints(), 0)
        remesher.SetNumberOfPoints(50)
        remesher.Update()
        self.assertEqual((len(errors), len(executive)), (1, 1))
        self.assertEqual(remesher.GetOutput().GetNumberOfPoints(), 50)

    def test_abort(self):
        remesher = self.remesher()
        progress = []

        def watch(caller, _):
            progress.append(caller.GetProgress())
            if caller.GetProgress() > 0.5:
                caller.SetAbortExecute(1)

        tag = remesher.AddObserver("ProgressEvent", watch)
        remesher.Update()
        self.assertEqual(progress, sorted(progress))
        # Newer executives end with a 1 of their own.
        self.assertLess(max(value for value in progress if value < 1), 0.95)
        self.assertEqual(remesher.GetOutput().GetNumberOfPoints(), 0)
        remesher.RemoveObserver(tag)
        remesher.SetAbortExecute(0)
        remesher.Modified()
        remesher.Update()
        self.assertEqual(remesher.GetOutput().GetNumberOfPoints(), 200)

    def test_print(self):
        self.assertIn("NumberOfPoints: 200", str(self.remesher()))


if __name__ == "__main__":
    sys.exit(Testing.main([(TestRemesher, "test")]))
