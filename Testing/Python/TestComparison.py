#!/usr/bin/env python3
"""The wrapped comparison: VTK's own mesh quality, distances by formula, summary and histograms."""
import sys

import numpy
from vtkmodules.test import Testing
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPlaneSource, vtkSphereSource

from anisotropic_remeshing import vtkAnisotropicRemesher, vtkSurfaceMeshComparison

try:
    from vtkmodules.vtkFiltersVerdict import vtkMeshQuality
except ImportError:
    vtkMeshQuality = None


def sphere(radius, resolution=40):
    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.SetOutputPointsPrecision(1)
    source.Update()
    return source.GetOutput()


def compare(mesh, reference=None):
    comparison = vtkSurfaceMeshComparison()
    comparison.SetInputData(mesh)
    if reference is not None:
        comparison.SetReferenceData(reference)
    comparison.SetNumberOfSamples(20000)
    comparison.Update()
    return comparison


def summary(comparison):
    table = comparison.GetSummaryOutput()
    assert table.GetNumberOfRows() == 1
    return {table.GetColumnName(i): table.GetValue(0, i).ToDouble()
            for i in range(table.GetNumberOfColumns())}


def cells(comparison, name):
    return vtk_to_numpy(comparison.GetOutput().GetCellData().GetArray(name))


class TestComparison(Testing.vtkTest):
    def test_quality_is_vtks(self):
        if vtkMeshQuality is None:
            self.skipTest("this VTK has no vtkMeshQuality")
        comparison = compare(sphere(1.0, 23))
        for name, choose in (("MinimumAngle", "SetTriangleQualityMeasureToMinAngle"),
                             ("RadiusRatio", "SetTriangleQualityMeasureToRadiusRatio"),
                             ("EdgeRatio", "SetTriangleQualityMeasureToEdgeRatio")):
            quality = vtkMeshQuality()
            quality.SetInputData(comparison.GetOutput())
            getattr(quality, choose)()
            quality.Update()
            expected = vtk_to_numpy(quality.GetOutput().GetCellData().GetArray("Quality"))
            numpy.testing.assert_allclose(cells(comparison, name), expected, rtol=1e-9)

    def test_spheres(self):
        measured = compare(sphere(1.0), sphere(1.1))
        numbers = summary(measured)
        self.assertAlmostEqual(numbers["MaximumDistance"], 0.1, delta=1e-12)
        self.assertLessEqual(numbers["MaximumDistance"], numbers["MaximumDistanceBound"])
        self.assertLess(numbers["MaximumDistanceBound"], 0.1011)
        self.assertAlmostEqual(numbers["RMSDistance"], 0.1, delta=1e-3)
        self.assertEqual(numbers["NumberOfFlippedTriangles"], 0)
        self.assertEqual(numbers["EulerCharacteristic"], 2)
        self.assertEqual(numbers["NumberOfComponents"], 1)
        signed = vtk_to_numpy(measured.GetOutput().GetPointData().GetArray("SignedDistance"))
        self.assertTrue((signed < 0.0).all())
        reference = measured.GetReferenceOutput().GetPointData()
        self.assertTrue((vtk_to_numpy(reference.GetArray("SignedDistance")) > 0.0).all())

    def test_inside_out(self):
        mesh = sphere(1.0)
        corners = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        turned = type(mesh)()
        turned.SetPoints(mesh.GetPoints())
        turned.SetPolys(type(mesh.GetPolys())())
        for a, b, c in corners:
            turned.GetPolys().InsertNextCell(3, [a, c, b])
        measured = compare(turned, mesh)
        self.assertTrue((cells(measured, "Flipped") == 1).all())
        numpy.testing.assert_allclose(cells(measured, "NormalDeviation"), 180.0)
        self.assertEqual(summary(measured)["NumberOfFlippedTriangles"], len(corners))

    def test_quadrilaterals(self):
        plane = vtkPlaneSource()
        plane.SetResolution(5, 4)
        plane.Update()
        measured = compare(plane.GetOutput(), plane.GetOutput())
        self.assertEqual(measured.GetOutput().GetNumberOfCells(), 40)
        numbers = summary(measured)
        self.assertEqual(numbers["NumberOfBoundaryLoops"], 1)
        self.assertEqual(numbers["NumberOfBoundaryEdges"], 18)
        self.assertAlmostEqual(numbers["MaximumDistance"], 0.0, delta=1e-15)
        cube = vtkCubeSource()  # six separate squares
        cube.Update()
        numbers = summary(compare(cube.GetOutput(), cube.GetOutput()))
        self.assertEqual(numbers["NumberOfComponents"], 6)
        self.assertEqual(numbers["ReferenceNumberOfComponents"], 1)
        self.assertEqual(numbers["ReferenceEulerCharacteristic"], 2)

    def test_remesher(self):
        """After the remesher, in one pipeline."""
        source = vtkSphereSource()
        source.SetThetaResolution(60)
        source.SetPhiResolution(40)
        remesher = vtkAnisotropicRemesher()
        remesher.SetInputConnection(source.GetOutputPort())
        remesher.SetNumberOfPoints(200)
        remesher.SetNumberOfLloydIterations(5)
        remesher.SetNumberOfNewtonIterations(5)
        comparison = vtkSurfaceMeshComparison()
        comparison.SetInputConnection(remesher.GetOutputPort())
        comparison.SetReferenceConnection(source.GetOutputPort())
        comparison.SetNumberOfBins(12)
        comparison.Update()
        numbers = summary(comparison)
        self.assertEqual(numbers["NumberOfPoints"], 200)
        self.assertEqual(numbers["EulerCharacteristic"], 2)
        self.assertEqual(numbers["NumberOfFlippedTriangles"], 0)
        self.assertTrue(0.0 < numbers["RelativeRMSDistance"] < 0.02, numbers)
        histograms = comparison.GetHistogramsOutput()
        self.assertEqual(histograms.GetNumberOfRows(), 12)
        for name in ("QualityTriangles", "MinimumAngleTriangles", "NormalDeviationTriangles"):
            counts = vtk_to_numpy(histograms.GetColumnByName(name))
            self.assertEqual(counts.sum(), numbers["NumberOfTriangles"])
        quality = cells(comparison, "Quality")
        self.assertAlmostEqual(numbers["MeanQuality"], quality.mean(), delta=1e-12)
        self.assertEqual(numbers["MinimumQuality"], quality.min())
        counts = vtk_to_numpy(histograms.GetColumnByName("QualityTriangles"))
        expected, _ = numpy.histogram(quality, bins=12, range=(0.0, 1.0))
        self.assertTrue((counts == expected).all())

    def test_error(self):
        messages = []
        comparison = vtkSurfaceMeshComparison()
        comparison.AddObserver("ErrorEvent", lambda *_: messages.append("error"))
        comparison.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
        mesh = sphere(1.0)
        points = vtk_to_numpy(mesh.GetPoints().GetData()).copy()
        points[7, 1] = numpy.nan
        spoilt = type(mesh)()
        spoilt.DeepCopy(mesh)
        spoilt.GetPoints().SetData(numpy_to_vtk(points, deep=True))
        comparison.SetInputData(mesh)
        comparison.SetReferenceData(spoilt)
        comparison.Update()
        self.assertEqual(messages, ["error"])
        self.assertEqual(comparison.GetOutput().GetNumberOfPoints(), 0)


if __name__ == "__main__":
    sys.exit(Testing.main([(TestComparison, "test")]))
