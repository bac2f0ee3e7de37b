#!/usr/bin/env python3
"""The functions of the package: what goes in and comes out, errors, warnings, progress."""
import contextlib
import gc
import inspect
import io
import logging
import os
import sys
import tempfile
import threading
import time
import types
import unittest
import unittest.mock
import warnings

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData, vtkTable
from vtkmodules.vtkFiltersSources import vtkSphereSource

import anisotropic_remeshing as ar
from anisotropic_remeshing import _run

QUICK = {"lloyd_iterations": 2, "newton_iterations": 2}


def sphere():
    source = vtkSphereSource()
    source.SetThetaResolution(40)
    source.SetPhiResolution(30)
    source.Update()
    return source.GetOutput()


def arrays_of(surface):
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return vtk_to_numpy(surface.GetPoints().GetData()), triangles


def stand_in(package, name, base=object, **members):
    """A class as if it were of a package."""
    return type(name, (base,), {"__module__": package + ".module", **members})


class TestInputs(unittest.TestCase):
    """Whatever a surface comes as, the mesh is the same, and comes back likewise."""

    @classmethod
    def setUpClass(cls):
        cls.surface = sphere()
        cls.points, cls.triangles = arrays_of(cls.surface)
        cls.expected = ar.remesh((cls.points, cls.triangles), 100, **QUICK)

    def check(self, result):
        self.assertTrue((result.points == self.expected.points).all())
        self.assertTrue((result.triangles == self.expected.triangles).all())

    def test_arrays(self):
        result = self.expected
        self.assertEqual(result.points.shape, (100, 3))
        self.assertEqual(result.triangles.shape, (196, 3))
        points, triangles = result.mesh
        self.assertTrue((points == result.points).all() and (triangles == result.triangles).all())
        corners, cells = result.cells
        self.assertGreater(len(cells), 100)
        self.assertTrue(all(3 <= len(cell) and cell.max() < len(corners) for cell in cells))
        self.assertEqual(result.sites.shape, (100, 3))
        self.assertEqual(result.edges[1].shape[1], 2)
        self.assertEqual(len(result.convergence["Energy"]), 5)
        self.assertEqual(set(result.convergence),
                         {"Iteration", "Energy", "GradientNorm", "StepLength", "Seconds"})

    def test_kinds_of_arrays(self):
        self.check(ar.remesh((self.points.tolist(), self.triangles.tolist()), 100, **QUICK))
        self.check(ar.remesh((self.points, self.triangles.astype("i4")[:, ::1]), 100, **QUICK))
        self.check(ar.remesh([self.points, list(self.triangles)], 100, **QUICK))
        counted = numpy.insert(self.triangles, 0, 3, axis=1).ravel()
        self.check(ar.remesh((self.points, counted), 100, **QUICK))
        backwards = self.points[::-1][::-1]  # not contiguous
        self.check(ar.remesh((backwards, self.triangles), 100, **QUICK))
        mixed = [[0, 1, 2], [2, 1, 3, 4]]
        ring = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [2, 1, 0], [1, 2, 0.0]])
        self.assertEqual(ar.compare((ring, mixed)).summary["number_of_triangles"], 3)

    def test_vtk(self):
        result = ar.remesh(self.surface, 100, normals="none", estimate_normals=True, **QUICK)
        self.check(result)
        for data in (result.mesh, result.cells, result.sites, result.edges):
            self.assertIs(type(data), type(vtkPolyData()))  # VTK's own, or Python's of the same kind
        self.assertIs(type(result.convergence), type(vtkTable()))
        self.assertEqual(result.mesh.GetPointData().GetArray("CellArea").GetNumberOfTuples(), 100)
        source = vtkSphereSource()
        source.GenerateNormalsOff()
        source.SetThetaResolution(40)
        source.SetPhiResolution(30)
        self.check(ar.remesh(source, 100, **QUICK))
        self.check(ar.remesh(source.GetOutputPort(), 100, **QUICK))

    def test_blocks(self):
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, self.surface)
        result = ar.remesh(blocks, 100, estimate_normals=True, **QUICK)
        self.assertIsInstance(result.mesh, vtkMultiBlockDataSet)
        self.assertTrue(result.topology_preserved)
        self.assertIn("blocks 1", repr(result))
        with self.assertRaisesRegex(TypeError, "MultiBlock"):
            _ = result.points
        with self.assertRaisesRegex(TypeError, "blocks"):
            ar.remesh(blocks, 100, density=numpy.ones(3))

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            for ending in ("ply", "vtp", "vtk", "stl", "obj", "PLY"):
                path = os.path.join(folder, "mesh." + ending)
                self.expected.save(path)
                again = ar.compare(path)
                self.assertIsInstance(again.mesh, vtkPolyData)
                self.assertEqual(again.summary["number_of_triangles"], 196, ending)
                self.assertLess(abs(again.summary["mean_quality"]
                                    - ar.compare(self.expected).summary["mean_quality"]), 1e-4)
            self.assertEqual(len(os.listdir(folder)), 6)
            with self.assertRaisesRegex(ValueError, "vtu' cannot be written.*must end in .ply, "
                                                    ".stl, .obj, .vtp, .vtm or .vtk.$"):
                self.expected.save(os.path.join(folder, "mesh.vtu"))
            with open(os.path.join(folder, "mesh.xyz"), "w", encoding="ascii"):
                pass
            with self.assertRaisesRegex(ValueError, "xyz' cannot be read.* .vtu, .vtm or .vtk.$"):
                ar.remesh(os.path.join(folder, "mesh.xyz"))
            with self.assertRaisesRegex(FileNotFoundError, "none/mesh.ply'$"):
                self.expected.save(os.path.join(folder, "none", "mesh.ply"))
            with self.assertRaises(FileNotFoundError):
                ar.remesh(os.path.join(folder, "none.ply"))
            with open(os.path.join(folder, "bad.ply"), "w", encoding="ascii") as file:
                file.write("no mesh")
            with self.assertRaisesRegex(ar.RemeshingError, "bad.ply"):
                ar.remesh(os.path.join(folder, "bad.ply"))

    def test_vertices_and_faces(self):
        kind = stand_in("other", "Mesh")
        mesh = kind()
        mesh.vertices, mesh.faces = self.points, self.triangles
        result = ar.remesh(mesh, 100, **QUICK)
        self.check(result)
        self.assertIsInstance(result.mesh, tuple)
        del mesh.vertices
        mesh.points = self.points
        self.check(ar.remesh(mesh, 100, **QUICK))

    def test_trimesh(self):
        module = types.ModuleType("trimesh")
        module.Trimesh = stand_in("trimesh", "Trimesh", __init__=lambda self, **more:
                                  self.__dict__.update(more))
        with replaced_modules(trimesh=module):
            mesh = module.Trimesh(vertices=self.points, faces=self.triangles)
            result = ar.remesh(mesh, 100, **QUICK)
            self.check(result)
            self.assertIsInstance(result.mesh, module.Trimesh)
            self.assertEqual(result.mesh.faces.shape, (196, 3))
            self.assertFalse(result.mesh.process)

    def test_meshio(self):
        def fill(self, points, cells, **more):
            block = stand_in("meshio", "CellBlock")
            self.points, self.cells = points, []
            for kind, data in cells:
                self.cells.append(block())
                self.cells[-1].type, self.cells[-1].data = kind, data
            self.more = more

        module = types.ModuleType("meshio")
        module.Mesh = stand_in("meshio", "Mesh", __init__=fill)
        with replaced_modules(meshio=module):
            mesh = module.Mesh(self.points, [("vertex", [[0]]), ("triangle", self.triangles)])
            result = ar.remesh(mesh, 100, **QUICK)
            self.check(result)
            self.assertIsInstance(result.mesh, module.Mesh)
            self.assertIn("CellArea", result.mesh.more["point_data"])
            mixed = module.Mesh(self.points, [("triangle", self.triangles[:-1]),
                                              ("polygon", self.triangles[-1:])])
            self.check(ar.remesh(mixed, 100, **QUICK))

    def test_pyvista(self):
        module = types.ModuleType("pyvista")
        module.PolyData = stand_in("pyvista", "PolyData", vtkPolyData)

        def wrap(data):
            return "wrapped", data

        module.wrap = wrap
        with replaced_modules(pyvista=module):
            mesh = module.PolyData()
            mesh.ShallowCopy(self.surface)
            result = ar.remesh(mesh, 100, estimate_normals=True, **QUICK)
            self.check(result)
            for given in (result.mesh, result.cells, result.sites, result.edges,
                          result.convergence, ar.embed(mesh).surface, ar.compare(mesh).mesh):
                self.assertEqual(given[0], "wrapped")
            with_density = ar.remesh(mesh, 100, density=numpy.ones(mesh.GetNumberOfPoints()),
                                     estimate_normals=True, **QUICK)
            self.assertEqual(with_density.mesh[0], "wrapped")
            self.assertEqual(mesh.GetPointData().GetNumberOfArrays(), 1, "it was changed")

    def test_accessor(self):
        kept = {}

        def register(name, kind):
            return lambda accessor: kept.setdefault((name, kind), accessor)

        module = types.ModuleType("pyvista")
        module.DataSet = stand_in("pyvista", "DataSet", vtkPolyData)
        module.register_dataset_accessor = register
        module.wrap = lambda data: data
        with replaced_modules(pyvista=module):
            self.assertNotIn("anisotropic_remeshing.pyvista_accessor", sys.modules)
            import importlib

            importlib.import_module("anisotropic_remeshing.pyvista_accessor")
            del sys.modules["anisotropic_remeshing.pyvista_accessor"]
            mesh = module.DataSet()
            mesh.ShallowCopy(self.surface)
            accessor = kept["anisotropic", module.DataSet](mesh)
            self.check(accessor.remesh(100, estimate_normals=True, **QUICK))
            self.assertEqual(accessor.voronoi([[0, 0, 1.0]]).sites.GetNumberOfPoints(), 1)
            self.assertLess(accessor.compare(mesh).distance.maximum, 1e-12)
            self.assertEqual(accessor.embed().embedding.shape[1], 6)

    def test_result(self):
        """A result is a surface, too, and has sites."""
        self.assertLess(ar.compare(self.expected, self.surface).distance.rms, 0.02)
        again = ar.voronoi((self.points, self.triangles), self.expected)
        self.assertEqual(again.sites.shape, (100, 3))
        self.assertTrue((numpy.sort(again.mesh[1]) == numpy.sort(self.expected.mesh[1])).all())

    def test_views(self):
        result = ar.remesh((self.points, self.triangles), 100, **QUICK)
        array = result._outputs[0].GetPoints().GetData()
        points, triangles = result.points, result.triangles
        self.assertTrue(numpy.shares_memory(points, vtk_to_numpy(array)))
        self.assertTrue(numpy.shares_memory(result.points, points))
        self.assertTrue(numpy.shares_memory(result.triangles, triangles))
        kept_points, kept_triangles = points.copy(), triangles.copy()
        del result, array
        gc.collect()
        ar.remesh((self.points, self.triangles), 200, **QUICK)
        self.assertTrue((points == kept_points).all() and (triangles == kept_triangles).all())


@contextlib.contextmanager
def replaced_modules(**modules):
    before = {name: sys.modules.get(name) for name in modules}
    sys.modules.update(modules)
    try:
        yield
    finally:
        for name, module in before.items():
            if module is None:
                del sys.modules[name]
            else:
                sys.modules[name] = module


class TestArguments(unittest.TestCase):
    def setUp(self):
        self.surface = sphere()
        self.arrays = arrays_of(self.surface)

    def test_every_property(self):
        """Each property of the filters is an argument, with the same default."""
        special = {
            "SetMaximumNumberOfExtraPoints": "maximum_extra_points",
            "SetFeatureLabelArray": "feature_labels", "SetSeamArray": "seams",
            "SetDensityArray": "density",
            "SetEmbeddingArray": "embedding", "SetMetricArray": "metric",
            "SetInitialSitesData": "initial_sites", "SetDistanceArray": "distance",
            "SetSitesData": "sites", "SetReferenceData": "surface",
        }
        named = {"Set" + name: argument for argument, name in _run.PROPERTIES.items()}
        named.update(("Set" + name, argument) for argument, (name, _) in _run.CHOICES.items())
        named.update(special)
        base = set(dir(ar.vtkWholeSurfaceAlgorithm.__bases__[0]))
        for function, kind in ((ar.remesh, ar.vtkAnisotropicRemesher),
                               (ar.voronoi, ar.vtkRestrictedVoronoiDiagram),
                               (ar.compare, ar.vtkSurfaceMeshComparison),
                               (ar.embed, ar.vtkGaussMapEmbedding),
                               (ar.metric_from_solution, ar.vtkSolutionMetric),
                               (ar.metric_embedding, ar.vtkMetricEmbedding),
                               (ar.spectral_embedding, ar.vtkSpectralEmbedding)):
            parameters = inspect.signature(function).parameters
            algorithm = kind()
            for setter in sorted(set(dir(kind)) - base):
                if not setter.startswith("Set") or setter.endswith("Connection"):
                    continue
                self.assertIn(named.get(setter), parameters, f"{kind.__name__}.{setter}")
                argument = named[setter]
                self.assertIn(argument, function.__doc__ + ar.remesh.__doc__)
                default = parameters[argument].default
                if argument in _run.CHOICES:
                    default = _run.CHOICES[argument][1].index(default)
                if setter not in special and default is not None:
                    self.assertEqual(default, getattr(algorithm, "G" + setter[1:])(), setter)

    def test_values_arrive(self):
        algorithm = ar.vtkAnisotropicRemesher()
        for argument, value, name in (
                ("points", numpy.int64(7), "NumberOfPoints"), ("seed", 3, "Seed"),
                ("features", False, "PreserveFeatures"), ("anisotropy", 1, "Anisotropy"),
                ("feature_angle", numpy.float32(20), "FeatureAngle")):
            _run.set_property(algorithm, argument, value)
            self.assertEqual(getattr(algorithm, "Get" + name)(), value)
        for value, expected in ((None, -2), (float("inf"), -1), (5, 5)):
            _run.set_property(algorithm, "maximum_extra_points", value)
            self.assertEqual(algorithm.GetMaximumNumberOfExtraPoints(), expected)
        for value, expected in (("centroid", 0), ("fit", 3)):
            _run.set_property(algorithm, "vertex_placement", value)
            self.assertEqual(algorithm.GetVertexPlacement(), expected)

    def test_errors(self):
        points, triangles = self.arrays
        nan = points.copy()
        nan[5] = numpy.nan
        flat = (numpy.zeros((3, 3)), [[0, 1, 2]])
        for kind, text, surface, more in (
                (ar.RemeshingError, "at least 4 points", self.arrays, {"points": 0}),
                (ar.RemeshingError, "at least 4 points", self.arrays, {"points": -5}),
                (ar.RemeshingError, "Anisotropy must be", self.arrays, {"anisotropy": 7}),
                (ar.RemeshingError, "Point 5 is not finite", (nan, triangles), {}),
                (ar.RemeshingError, "empty", vtkPolyData(), {}),
                (ar.RemeshingError, "no polygons", (points, numpy.empty((0, 3), int)), {}),
                (ar.RemeshingError, "no numeric point array \"x\"", self.arrays, {"density": "x"}),
                (ValueError, "must be one of random, stratified", self.arrays, {"sampling": "x"}),
                (ValueError, "out of range", self.arrays, {"seed": 2 ** 70}),
                (ValueError, "tolerance must be above 0", self.arrays, {"tolerance": 0.0}),
                (ValueError, r"shape \(n, 3\)", (points[:, :2], triangles), {}),
                (ValueError, "but there are 1122 points|name points", (points, triangles + 9999),
                 {}),
                (ValueError, "row for each of the", self.arrays, {"density": [1.0, 2.0]}),
                (TypeError, "points must be a whole number", self.arrays, {"points": 2.5}),
                (TypeError, "anisotropy must be a number", self.arrays, {"anisotropy": "x"}),
                (TypeError, "must be integers", (points, triangles * 1.0), {}),
                (TypeError, "surface must be VTK data", None, {}),
                (TypeError, "coordinates must be", self.arrays, {"coordinates": 3}),
                (TypeError, "progress must be", self.arrays, {"progress": 3}),
                (TypeError, "unexpected keyword", self.arrays, {"anisotropie": 1})):
            with self.subTest(text), self.assertRaisesRegex(kind, text):
                ar.remesh(surface, **more)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with self.assertRaisesRegex(ar.RemeshingWarning, "has an area"):
                ar.remesh(flat)
        self.assertTrue(issubclass(ar.RemeshingError, ValueError))

    def test_nothing_is_printed(self):
        """What is wrong is raised or warned, and not also written in red."""
        with tempfile.TemporaryFile() as file:
            before = os.dup(2)
            os.dup2(file.fileno(), 2)
            try:
                for points in (0, 10):
                    with contextlib.suppress(ar.RemeshingError), warnings.catch_warnings():
                        warnings.simplefilter("ignore")
                        ar.remesh(self.arrays, points, tolerance_is_absolute=True)
                with contextlib.suppress(ar.RemeshingError):
                    ar.remesh(ar.vtkAnisotropicRemesher())  # it has no input
            finally:
                os.dup2(before, 2)
                os.close(before)
            file.seek(0)
            self.assertEqual(file.read(), b"")

    def test_warnings(self):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            result = ar.remesh(self.arrays, 100, initial_sites=self.arrays[0][:50],
                               tolerance=0.01, **QUICK)
        self.assertEqual([warning.category for warning in caught], [ar.RemeshingWarning])
        self.assertEqual(caught[0].filename, __file__)
        self.assertEqual(result.report["warnings"], [str(caught[0].message)])
        self.assertNotIn("0x", str(caught[0].message))

    def test_log(self):
        with self.assertLogs("anisotropic_remeshing", logging.INFO) as log:
            ar.remesh(self.arrays, 100, **QUICK)
        self.assertIn("done in", log.output[-1])

    def test_arrays(self):
        points, triangles = self.arrays
        options = {"anisotropy": 0, "vertex_placement": "quadric"}  # the fit slides points
        even = ar.remesh(self.arrays, 400, **options)
        dense = ar.remesh(self.arrays, 400, **options,
                          density=numpy.where(points[:, 2] > 0, 100.0, 1.0))
        self.assertGreater((dense.points[:, 2] > 0).sum(), 1.8 * (even.points[:, 2] > 0).sum())

        labels = points[triangles].mean(axis=1)[:, 2] > 0.2
        parted = ar.remesh(self.arrays, 400, feature_labels=labels, **QUICK)
        self.assertEqual(set(numpy.unique(parted.cell_data["Given labels"])), {0, 1})

        space = ar.embed(self.arrays).embedding
        self.assertEqual(space.shape, (len(points), 6))
        own = ar.remesh(self.arrays, 100, embedding=space[:, :3], **QUICK)
        self.assertEqual(own.report["dimension"], 3)
        more = ar.remesh(self.arrays, 100, coordinates=[(points[:, 0], 0.1)], **QUICK)
        self.assertEqual(more.report["dimension"], 7)
        normals = points / numpy.linalg.norm(points, axis=1)[:, None]
        given = ar.remesh(self.arrays, 100, normals=normals, **QUICK)
        self.assertNotIn("normal_smoothing_radius", given.report)

    def test_sites(self):
        result = ar.remesh(self.arrays, initial_sites=self.arrays[0][:60], **QUICK)
        self.assertEqual(result.sites.shape, (60, 3))
        diagram = ar.voronoi(self.arrays, [[0, 0, 1.0], [0, 0, -1.0]], anisotropy=0)
        areas = vtk_to_numpy(diagram._outputs[2].GetPointData().GetArray("CellArea"))
        self.assertAlmostEqual(areas[0] / areas[1], 1.0, delta=1e-5)

    def test_report(self):
        result = ar.remesh(self.arrays, 100, **QUICK)
        self.assertIs(result.topology_preserved, True)
        self.assertEqual(result.distance, (result.report["rms_distance"],
                                           result.report["maximum_distance"]))
        self.assertEqual(result.report["euler_characteristic"], 2)
        self.assertEqual(result.report["topology_report"], "")
        self.assertGreater(result.report["seconds"]["total"], 0.0)
        self.assertIsNone(ar.remesh(self.arrays, 100, measure_distance=False, **QUICK).distance)
        self.assertRegex(repr(result), "^<Remeshed: points 100, triangles 196, topology preserved")
        compared = ar.compare(result, self.arrays)
        self.assertAlmostEqual(compared.distance.rms / result.distance.rms, 1.0, delta=0.2)
        self.assertEqual(compared.summary["reference_number_of_points"], len(self.arrays[0]))
        self.assertIsNone(ar.compare(result).distance)
        self.assertIsNone(ar.compare(result).surface)
        self.assertEqual(len(compared.histograms["Quality"]), 30)


class TestProgress(unittest.TestCase):
    def setUp(self):
        self.surface = arrays_of(sphere())

    def test_callable(self):
        told = []
        thread = threading.get_ident()

        def progress(fraction, phase):
            self.assertEqual(threading.get_ident(), thread)
            told.append((fraction, phase))

        ar.remesh(self.surface, 200, progress=progress)
        fractions = [fraction for fraction, _ in told]
        self.assertEqual(fractions, sorted(fractions))
        self.assertEqual((fractions[0], fractions[-1]), (0.0, 1.0))
        self.assertGreater(len({phase for _, phase in told}), 3)

    def test_stop(self):
        with self.assertRaises(ar.RemeshingStopped):
            ar.remesh(self.surface, 200, progress=lambda fraction, _: fraction < 0.5)

        def fail(fraction, _):
            if fraction > 0.5:
                raise KeyError("own")

        with self.assertRaisesRegex(KeyError, "own"):
            ar.remesh(self.surface, 200, progress=fail)
        self.assertEqual(len(ar.remesh(self.surface, 200, **QUICK).points), 200)

    def test_line(self):
        with replaced_modules(tqdm=None), contextlib.redirect_stderr(io.StringIO()) as text:
            sys.modules["tqdm"] = None  # as if it were not installed
            ar.remesh(self.surface, 200, progress=True, **QUICK)
        self.assertGreater(len(text.getvalue().split("\n")), 4)

    def test_bar(self):
        bars = []

        class Bar:
            def __init__(self, total, **_):
                self.n, self.total, self.closed = 0, total, False
                bars.append(self)

            def set_description_str(self, text, refresh):
                self.text = text

            def update(self, step):
                self.n += step

            def close(self):
                self.closed = True

        parent, auto = types.ModuleType("tqdm"), types.ModuleType("tqdm.auto")
        auto.tqdm = Bar
        with replaced_modules(**{"tqdm": parent, "tqdm.auto": auto}):
            ar.remesh(self.surface, 200, progress=True, **QUICK)
        self.assertEqual([(bar.n, bar.total, bar.closed) for bar in bars], [(100, 100, True)])

    def test_threads(self):
        """Other threads work on while one remeshes (but with ParaView's VTK); two runs take turns and do not mix."""
        expected = ar.remesh(self.surface, 300, **QUICK).points
        ticks, done, found = [], threading.Event(), []

        def tick():
            while not done.wait(0.001):
                ticks.append(1)

        threads = [threading.Thread(target=tick)]
        threads += [threading.Thread(target=lambda: found.append(
            ar.remesh(self.surface, 300, **QUICK).points)) for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads[1:]:
            thread.join()
        done.set()
        threads[0].join()
        if _run._execution.releases_gil:
            self.assertGreater(len(ticks), 10)
        self.assertTrue(all((points == expected).all() for points in found))
        self.assertEqual(len(found), 2)


class TestOverhead(unittest.TestCase):
    def test_overhead(self):
        """What Python adds to the filter's own time at 10 000 points, arrays in and out."""
        surface = arrays_of(sphere())
        own = _run._execution.update
        inside = []

        def update(algorithm):
            start = time.perf_counter()
            own(algorithm)
            inside.append(time.perf_counter() - start)

        best = 1.0
        with unittest.mock.patch.object(_run, "_execution", types.SimpleNamespace(update=update)):
            for _ in range(3):
                start = time.perf_counter()
                points, triangles = ar.remesh(surface, 10000).mesh
                best = min(best, (time.perf_counter() - start) / inside[-1] - 1.0)
                if best < 0.05:
                    break
        self.assertEqual((len(points), len(triangles)), (10000, 19996))
        print(f"Python adds {100.0 * best:.2f} %")
        self.assertLess(best, 0.05)


class TestAbort(unittest.TestCase):
    def test_runs_again(self):
        remesher = ar.vtkAnisotropicRemesher()
        remesher.SetInputData(sphere())
        remesher.SetNumberOfPoints(200)
        tag = remesher.AddObserver("ProgressEvent", lambda caller, _: caller.AbortExecuteOn())
        remesher.Update()
        self.assertEqual(remesher.GetOutput().GetNumberOfPoints(), 0)
        remesher.RemoveObserver(tag)
        remesher.Update()
        self.assertEqual(remesher.GetOutput().GetNumberOfPoints(), 200)


if __name__ == "__main__":
    unittest.main(verbosity=2)
