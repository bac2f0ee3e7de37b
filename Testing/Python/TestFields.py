#!/usr/bin/env python3
"""The functions that compute fields on a surface: metrics, their embeddings, eigenfunctions."""
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource

import anisotropic_remeshing as ar

QUICK = {"lloyd_iterations": 2, "newton_iterations": 2}


class TestFields(unittest.TestCase):
    def setUp(self):
        source = vtkSphereSource()  # of radius 0.5
        source.SetThetaResolution(40)
        source.SetPhiResolution(30)
        source.Update()
        surface = source.GetOutput()
        triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        self.arrays = vtk_to_numpy(surface.GetPoints().GetData()), triangles

    def test_metric_from_solution(self):
        """Arrays by name, as numbers and as lists; the metric's formula for a known Hessian."""
        x, y = numpy.meshgrid(*2 * [numpy.linspace(0.0, 1.0, 21)], indexing="ij")
        points = numpy.stack([x.ravel(), y.ravel(), 0.0 * x.ravel()], axis=1)
        row, column = numpy.meshgrid(numpy.arange(20), numpy.arange(20), indexing="ij")
        first = (21 * row + column).ravel()
        square = points, numpy.concatenate([
            numpy.stack([first, first + 21, first + 22], axis=1),
            numpy.stack([first, first + 22, first + 1], axis=1)])
        hessian = numpy.zeros((len(points), 3, 3))
        hessian[:, 0, 0], hessian[:, 1, 1] = 9.0, -1.0
        values = 4.5 * points[:, 0] ** 2 - 0.5 * points[:, 1] ** 2
        for arguments in ({"arrays": values}, {"arrays": [values]}, {"hessians": hessian},
                          {"arrays": [values, values], "hessians": [hessian], "norm": "maximum"}):
            made = ar.metric_from_solution(square, points=300, **arguments)
            expected = 150.0 * numpy.sqrt(3.0) * numpy.array([3, 1 / 3, 1 / 3, 0, 0, 0])
            self.assertTrue(numpy.allclose(made.metric, expected, rtol=1e-4, atol=1e-3))
            self.assertEqual(made.wanted_points, 300)
        self.assertEqual(repr(made), "<Metric: points 441, asks for 300>")
        limited = ar.metric_from_solution(
            square, points=300, distance=points[:, 0], distance_size=0.1, distance_growth=0.5,
            metrics=[numpy.full(len(points), 0.3)], maximum_size=0.25)
        size = numpy.minimum(0.25, 0.1 + 0.5 * points[:, 0])
        self.assertTrue(numpy.allclose(limited.metric[:, :3], size[:, None] ** -2.0))
        with self.assertRaisesRegex(ar.RemeshingError, "nothing to make a metric from"):
            ar.metric_from_solution(square)
        with self.assertRaisesRegex(ValueError, "must be one of l1, l2, l4, maximum"):
            ar.metric_from_solution(square, values, norm="l3")

    def test_metric_embedding(self):
        """Sizes that grow with x: arrays by name and as numbers, what comes out, remeshing."""
        sizes = 0.1 + 0.1 * (self.arrays[0][:, 0] + 0.5)
        made = ar.metric_embedding(self.arrays, sizes, 300, dimension=5)
        points, triangles = made.surface
        self.assertTrue((points[: len(self.arrays[0])] == self.arrays[0]).all())
        self.assertEqual(made.embedding.shape, (len(points), 5))
        self.assertEqual(made.metric.shape, (len(points), 6))
        self.assertEqual(made.stretch.shape, (len(triangles), 2))
        self.assertTrue((made.stretch[:, 0] <= made.stretch[:, 1]).all())
        edges = points[triangles[:, 0]] - points[triangles[:, 1]]
        places = made.embedding[triangles[:, 0]] - made.embedding[triangles[:, 1]]
        middles = points[triangles[:, :2]].mean(axis=1)[:, 0]
        ratio = (numpy.linalg.norm(places, axis=1) / numpy.linalg.norm(edges, axis=1)
                 * (0.15 + 0.1 * middles))
        self.assertLess(abs(numpy.median(ratio) - 1.0), 0.03)
        self.assertGreater(made.share, 0.99)
        self.assertGreaterEqual(made.limit, 1.0)
        self.assertIn("dimension 5, met on 100.0%", repr(made))
        unit = ar.metric_embedding(self.arrays, sizes, unit=True, refine=False)
        self.assertEqual(unit.unit, 1.0)
        mesh = ar.remesh(self.arrays, metric=sizes, unit=True, **QUICK)
        self.assertLessEqual(abs(unit.wanted_points - len(mesh.points)), 3)
        self.assertEqual(len(unit.embedding), len(self.arrays[0]))
        mesh = ar.remesh(self.arrays, 300, embedding=unit.embedding, **QUICK)
        self.assertEqual(mesh.report["dimension"], 6)
        with self.assertRaisesRegex(ar.RemeshingError, "not positive definite .* at point 7"):
            sizes[7] = 0.0
            ar.metric_embedding(self.arrays, sizes)

    def test_spectral_embedding(self):
        """A sphere of radius 0.5: eigenvalues l (l + 1) / 0.25, and scaled functions."""
        plain = ar.spectral_embedding(self.arrays, 8, scaling="none")
        self.assertEqual(plain.embedding.shape, (len(self.arrays[0]), 8))
        known = 4.0 * numpy.array([2, 2, 2, 6, 6, 6, 6, 6])
        self.assertLess(abs(plain.eigenvalues / known - 1.0).max(), 0.02)
        for scaling, factors in (("commute_time", plain.eigenvalues ** -0.5),
                                 ("biharmonic", 1.0 / plain.eigenvalues),
                                 ("diffusion", numpy.exp(-0.1 * plain.eigenvalues))):
            scaled = ar.spectral_embedding(self.arrays, 8, scaling=scaling, time=0.1)
            self.assertTrue(numpy.allclose(scaled.embedding, plain.embedding * factors, atol=1e-9))
        mesh = ar.remesh(self.arrays, 200, embedding=scaled.embedding, **QUICK)
        self.assertEqual(mesh.report["dimension"], 8)
        with self.assertRaisesRegex(ar.RemeshingError, "eigenfunctions beside constants, but 9999"):
            ar.spectral_embedding(self.arrays, 9999)


if __name__ == "__main__":
    unittest.main(verbosity=2)
