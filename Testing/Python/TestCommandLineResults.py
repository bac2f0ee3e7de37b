"""Tests of remesh_surface: what it writes, report, determinism.

    TestCommandLineResults.py --program build/bin/remesh_surface --work FOLDER [unittest options]

Surfaces are made here, with VTK.
"""
import os
import shutil

import numpy

from anisotropic_remeshing import vtkGaussMapEmbedding, vtkSolutionMetric, vtkSpectralEmbedding
from CommandLineTesting import (FORMATS, SMALL, CommandLineTest, content, load, main, read, sphere,
                                write)
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy


class TestResults(CommandLineTest):
    def test_formats(self):
        counts = set()
        for source in FORMATS:
            for target in FORMATS + ("PLY",):
                name = f"from_{source}.{target}"
                self.succeed(self.input("sphere." + source), name, *SMALL, "--normals", "none")
                surface = read(self.path(name))
                if target != "stl":  # which has the points of each triangle
                    counts.add((surface.GetNumberOfPoints(), surface.GetNumberOfPolys()))
        self.assertEqual(counts, {(60, 116)})

    def test_vtp_keeps_doubles(self):
        self.succeed(self.input(), "out.vtp", *SMALL)
        self.succeed(self.input(), "OUT.OBJ", *SMALL)
        surface = read(self.path("out.vtp"))
        self.assertEqual(surface.GetPoints().GetData().GetDataTypeAsString(), "double")
        lines = [line.split() for line in content(self.path("OUT.OBJ")).decode().splitlines()]
        points = [tuple(map(float, words[1:])) for words in lines if words[0] == "v"]
        self.assertEqual(points, [surface.GetPoint(i) for i in range(60)])

    def test_further_outputs(self):
        self.succeed(self.input(), "out.vtp", *SMALL, "--cells", "c.vtp", "--sites", "s.vtp",
                     "--edges", "e.vtp", "--embedded-surface", "x.vtp", "--convergence", "t.csv",
                     "--report", "r.json")
        self.assertEqual(sorted(os.listdir(self.folder)),
                         ["c.vtp", "e.vtp", "out.vtp", "r.json", "s.vtp", "t.csv", "x.vtp"])
        self.assertIsNotNone(read(self.path("c.vtp")).GetCellData().GetArray("InputCellId"))
        self.assertEqual(read(self.path("s.vtp")).GetNumberOfPoints(), 60)
        self.assertIsNotNone(read(self.path("e.vtp")).GetCellData().GetArray("EdgeType"))
        embedded = read(self.path("x.vtp"))
        self.assertEqual(embedded.GetNumberOfPoints(), sphere().GetNumberOfPoints())
        self.assertEqual(embedded.GetPointData().GetArray("Embedding").GetNumberOfComponents(), 6)
        lines = content(self.path("t.csv")).decode().splitlines()
        self.assertEqual(lines[0], "Iteration,Energy,GradientNorm,StepLength,Seconds")
        report = load(self.path("r.json"))
        self.assertEqual(len(lines), report["iterations"] + 2)
        self.assertEqual(float(lines[-1].split(",")[1]), report["energy"])

    def test_ends_when_converged(self):
        # Long before 400 steps, by the default; where it is off, as far as the energy can fall.
        energies = {}
        for name, options in (("default", []), ("all", ["--energy-tolerance", "0"]),
                              ("early", ["--energy-tolerance", "0.001"])):
            self.succeed(self.input(), "out.vtp", "--points", "200", "--newton", "400",
                         "--convergence", "t.csv", *options)
            lines = content(self.path("t.csv")).decode().splitlines()[1:]
            energies[name] = [float(line.split(",")[1]) for line in lines]
        self.assertLess(len(energies["early"]), len(energies["default"]))
        self.assertLess(len(energies["default"]), len(energies["all"]))
        self.assertLess(len(energies["default"]), 200)
        self.assertLess(energies["default"][-1], 1.005 * energies["all"][-1])
        *_, before, last = energies["default"]
        self.assertLessEqual(before - last, 5e-6 * last)

    def test_report(self):
        name = 'odd "name" \\ \u00e9\n.vtp'
        shutil.copy(self.input(), self.path(name))
        self.succeed(name, "out.vtp", *SMALL, "--report", "r.json", "--anisotropy", "0.1",
                     "--coordinates", "Height=0.5", "--coordinates", "Six=2", "--threads", "1")
        report = load(self.path("r.json"))
        self.assertLessEqual(
            {"input", "parameters", "output", "topology", "iterations", "evaluations", "energy",
             "seconds", "processor_seconds", "peak_megabytes", "threads", "backend", "warnings"},
            set(report))
        surface = sphere()
        self.assertEqual(report["input"], {
            "file": name, "points": surface.GetNumberOfPoints(),
            "cells": surface.GetNumberOfCells(), "components": 1, "dropped": 0})
        distances = [report["output"].pop(key) for key in ("rms_distance", "maximum_distance")]
        self.assertTrue(0 < distances[0] < distances[1] < 0.05, distances)
        self.assertEqual(report["output"],
            {"points": 60, "triangles": 116, "extra_points": 0, "flipped_triangles": 0,
             "stray_triangles": 0, "self_intersections": 0})
        self.assertEqual(report["topology"], {"preserved": 1, "report": ""})
        self.assertEqual(report["parameters"]["anisotropy"], 0.1)
        self.assertEqual(report["parameters"]["max_extra_points"], -2)
        self.assertEqual(report["parameters"]["coordinates"],
                         [{"name": "Height", "scale": 0.5}, {"name": "Six", "scale": 2}])
        seconds = report["seconds"]
        self.assertLessEqual({"read", "intake", "sampling", "lloyd", "newton", "repair", "diagram",
                              "placement", "distance", "write", "total"}, set(seconds))
        parts = sum(value for key, value in seconds.items() if key != "total")
        self.assertLessEqual(parts, seconds["total"])
        self.assertGreater(min(report["processor_seconds"], report["peak_megabytes"]), 0)
        self.assertEqual((report["threads"], report["warnings"]), (1, []))

    def test_deterministic(self):
        def outputs(name, *options):
            files = [f"{name}.vtp", f"{name}-c.vtp", f"{name}-s.vtp", f"{name}-e.vtp"]
            self.succeed(self.input(), files[0], "--points", "300", "--lloyd", "5", "--cells",
                         files[1], "--sites", files[2], "--edges", files[3], "--quiet", *options)
            return [content(self.path(file)) for file in files]
        first = outputs("first")
        for threads in ("1", "2"):
            for backend in ("sequential", "stdthread", "tbb"):
                with self.subTest(threads=threads, backend=backend):
                    self.assertTrue(first == outputs("x", "--threads", threads, "--backend",
                                                     backend))
        self.assertFalse(first == outputs("other", "--seed", "1"))
        self.assertFalse(first == outputs("random", "--sampling", "random"))
        self.assertTrue(first == outputs("fit", "--placement", "fit"))

    def test_no_distance(self):
        self.succeed(self.input(), "out.vtp", *SMALL, "--no-distance", "--report", "r.json")
        report = load(self.path("r.json"))
        self.assertFalse({"rms_distance", "maximum_distance"} & set(report["output"]))
        self.assertEqual(report["seconds"]["distance"], 0)
        self.assertIs(report["parameters"]["measure_distance"], False)

    def test_placement(self):
        # On the sphere of radius 0.5 all placements tell themselves apart by the mean radius.
        radii = {}
        for placement in ("centroid", "surface", "quadric", "fit"):
            self.succeed(self.input(), "out.vtp", "--points", "100", "--anisotropy", "0",
                         "--placement", placement, "--report", "r.json")
            points = vtk_to_numpy(read(self.path("out.vtp")).GetPoints().GetData())
            radii[placement] = numpy.linalg.norm(points, axis=1).mean()
            self.assertEqual(load(self.path("r.json"))["parameters"]["placement"], placement)
        self.assertLess(radii["centroid"], radii["surface"])
        self.assertLess(radii["surface"], radii["quadric"])
        self.assertLess(radii["surface"], radii["fit"])

    def test_tolerance(self):
        counts = []
        for tolerance in ("1e-2", "3e-3"):
            self.succeed(self.input(), "out.vtp", "--tolerance", tolerance, "--report", "r.json")
            report = load(self.path("r.json"))
            self.assertEqual(report["parameters"]["tolerance"], float(tolerance))
            low, high = numpy.array(sphere().GetBounds()).reshape(3, 2).T
            limit = float(tolerance) * numpy.linalg.norm(high - low)
            self.assertLessEqual(report["output"]["maximum_distance"], limit)
            self.assertLess(report["output"]["rms_distance"],
                            report["output"]["maximum_distance"])
            self.assertNotEqual(report["output"]["points"], 10000)
            counts.append(report["output"]["points"])
        self.assertLess(2 * counts[0], counts[1])
        self.fail_with(2, "at least 1e-7", self.input(), "out2.vtp", "--tolerance", "1e-9")
        # A number of points does not count then, not even one that would be too low.
        self.succeed(self.input(), "few.vtp", "--tolerance", "3e-3", "--points", "0",
                     "--embedded-surface", "x.vtp")
        self.assertEqual(content(self.path("few.vtp")), content(self.path("out.vtp")))

    def test_max_points(self):
        result = self.run_program(self.input(), "out.vtp", "--tolerance", "3e-3", "--max-points",
                                  "100", "--report", "r.json")
        self.assertEqual(result.returncode, 0)
        self.assertIn("more than the 100 points allowed", result.stderr)
        report = load(self.path("r.json"))
        self.assertEqual(report["parameters"]["max_points"], 100)
        self.assertEqual(report["output"]["points"], 100)
        self.fail_with(2, "--max-points", self.input(), "few.vtp", "--max-points", "3")

    def test_density(self):
        # Half the spacing for x > 0: four times as many points, but for the triangles between.
        surface = sphere()
        x = vtk_to_numpy(surface.GetPoints().GetData())[:, 0]
        array = numpy_to_vtk(numpy.where(x > 0, 16.0, 1.0), deep=True)
        array.SetName("Density")
        surface.GetPointData().AddArray(array)
        write(surface, self.input("dense.vtp"))
        self.succeed(self.input("dense.vtp"), "out.vtp", "--points", "500", "--density", "Density",
                     "--anisotropy", "0", "--report", "r.json")
        x = vtk_to_numpy(read(self.path("out.vtp")).GetPoints().GetData())[:, 0]
        self.assertAlmostEqual((x > 0.3).sum() / (x < -0.3).sum(), 4.0, delta=0.5)
        self.assertEqual(load(self.path("r.json"))["parameters"]["density"], "Density")
        self.fail_with(1, "above 0", self.input(), "out2.vtp", "--density", "Height")
        self.fail_with(1, "no point array 'Foo'", self.input(), "out2.vtp", "--density", "Foo")

    def test_embedding_array(self):
        self.succeed(self.input(), "out.vtp", *SMALL, "--embedding-array", "Six",
                     "--embedded-surface", "x.vtp")
        data = read(self.path("x.vtp")).GetPointData()
        self.assertTrue((vtk_to_numpy(data.GetArray("Embedding")) ==
                         vtk_to_numpy(data.GetArray("Six"))).all())

    def check_computed(self, filter_, options, array_options):
        """The same as with an array that the filter added before; the array comes out."""
        filter_.SetInputData(read(self.input()))
        filter_.Update()
        write(filter_.GetOutput(), self.path("given.vtp"))
        self.succeed("given.vtp", "given-out.vtp", *SMALL, *array_options)
        self.succeed(self.input(), "out.vtp", *SMALL, *options, "--embedded-surface", "x.vtp")
        one, other = (read(self.path(name)) for name in ("out.vtp", "given-out.vtp"))
        self.assertTrue((vtk_to_numpy(one.GetPoints().GetData()) ==
                         vtk_to_numpy(other.GetPoints().GetData())).all())
        return one, read(self.path("x.vtp")).GetPointData().GetArray("Embedding")

    def test_solution(self):
        metric = vtkSolutionMetric()
        metric.AddSolutionArray("Height")
        metric.AddSolutionArray("Six")
        metric.SetErrorNorm(vtkSolutionMetric.L4)
        metric.SetNumberOfPoints(60)
        metric.SetMaximumSize(0.5)
        mesh, embedding = self.check_computed(
            metric, ["--solution", "Height", "--solution", "Six", "--error-norm", "l4",
                     "--max-size", "0.5"], ["--metric", "Metric"])
        self.assertEqual(mesh.GetPointData().GetArray("Metric").GetNumberOfComponents(), 6)
        self.assertEqual(embedding.GetNumberOfComponents(), 6)

    def test_eigenfunctions(self):
        spectrum = vtkSpectralEmbedding()
        spectrum.SetDimension(9)
        spectrum.SetScaling(vtkSpectralEmbedding.DIFFUSION)
        spectrum.SetDiffusionTime(0.01)
        _, embedding = self.check_computed(
            spectrum, ["--eigenfunctions", "9", "--eigenfunction-scaling", "diffusion",
                       "--diffusion-time", "0.01"], ["--embedding-array", "Embedding"])
        self.assertTrue((vtk_to_numpy(embedding) == vtk_to_numpy(
            spectrum.GetOutput().GetPointData().GetArray("Embedding"))).all())

    def test_given_and_estimated_normals(self):
        surface = sphere()
        surface.GetPointData().RemoveArray("Normals")
        write(surface, self.input("bare.vtp"))
        self.succeed(self.input("bare.vtp"), "bare.vtp", *SMALL, "--embedded-surface", "bare-x.vtp")
        points = []
        for name, normals in (("none", "none"), ("named", "Normals")):
            self.succeed(self.input(), name + ".vtp", *SMALL, "--normals", normals)
            points.append(vtk_to_numpy(read(self.path(name + ".vtp")).GetPoints().GetData()))
        bare = vtk_to_numpy(read(self.path("bare.vtp")).GetPoints().GetData())
        self.assertTrue((bare == points[0]).all())
        self.assertFalse((bare == points[1]).all())
        self.succeed(self.input(), "active.vtp", *SMALL)
        self.assertEqual(content(self.path("active.vtp")), content(self.path("named.vtp")))

    def test_smoothing_radius(self):
        surface = sphere()
        surface.GetPointData().RemoveArray("Normals")
        write(surface, self.input("bare.vtp"))
        self.succeed(self.input("bare.vtp"), "out.vtp", "--tolerance", "0.01",
                     "--embedded-surface", "x.vtp", "--report", "r.json")
        radius = load(self.path("r.json"))["output"]["normal_smoothing_radius"]
        embedding = vtkGaussMapEmbedding()
        embedding.SetNormalSmoothingRadius(radius)
        embedding.SetInputData(read(self.input("bare.vtp")))
        embedding.Update()
        expected = embedding.GetOutput().GetPointData().GetArray("Embedding")
        found = read(self.path("x.vtp")).GetPointData().GetArray("Embedding")
        self.assertTrue((vtk_to_numpy(found) == vtk_to_numpy(expected)).all())
        # The radius of an earlier run, which the input still has, is not that of this one.
        radius = numpy_to_vtk(numpy.array([0.7]), deep=True)
        radius.SetName("NormalSmoothingRadius")
        surface.GetFieldData().AddArray(radius)
        write(surface, self.input("stale.vtp"))
        found = []
        radii = []
        for name in ("bare.vtp", "stale.vtp"):
            result = self.run_program(self.input(name), "out.vtp", *SMALL, "--embedded-surface",
                                      "x.vtp", "--report", "r.json")
            self.assertEqual(result.returncode, 0, result.stderr)
            radii.append(load(self.path("r.json"))["output"]["normal_smoothing_radius"])
            found.append(vtk_to_numpy(read(self.path("x.vtp")).GetPointData()
                                      .GetArray("Embedding")))
        self.assertTrue((found[0] == found[1]).all())
        taken = read(self.path("out.vtp")).GetFieldData().GetArray("NormalSmoothingRadius")
        self.assertEqual(radii, 2 * [taken.GetValue(0)])
        self.assertNotEqual(radii[0], 0.7)

    def test_isotropic(self):
        self.succeed(self.input(), "a.vtp", *SMALL, "--dimension", "3")
        self.succeed(self.input(), "b.vtp", *SMALL, "--anisotropy", "0")
        one, other = (vtk_to_numpy(read(self.path(name)).GetPoints().GetData())
                      for name in ("a.vtp", "b.vtp"))
        self.assertTrue((one == other).all())

    def test_initial_sites(self):
        self.succeed(self.input(), "a.vtp", "--points", "50", "--sites", "s.vtp", "--lloyd", "2")
        self.succeed(self.input(), "b.vtp", "--initial-sites", "s.vtp", "--lloyd", "2")
        self.assertEqual(read(self.path("b.vtp")).GetNumberOfPoints(), 50)

    def test_initial_sites_of_triangles_apart(self):
        # STL has each point as often as triangles have it; sites are what is left of them.
        self.succeed(self.input(), "a.stl", "--points", "50", "--lloyd", "2")
        self.assertEqual(os.path.getsize(self.path("a.stl")), 84 + 50 * 96)
        self.succeed(self.input(), "b.vtp", "--initial-sites", "a.stl", "--sites", "s.vtp")
        self.assertEqual(read(self.path("s.vtp")).GetNumberOfPoints(), 50)
        self.assertEqual(read(self.path("b.vtp")).GetNumberOfPoints(), 50)


if __name__ == "__main__":
    main()
