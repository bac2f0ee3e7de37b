#!/usr/bin/env python3
"""The package as a package: names, types, version, metadata, what it shows in a notebook.

    TestPackage.py SOURCE [unittest options]    SOURCE: the repository
"""
import ast
import importlib.metadata
import importlib.util
import inspect
import os
import pickle
import re
import subprocess
import sys
import unittest

try:
    import tomllib
except ImportError:  # before Python 3.11
    tomllib = None

from vtkmodules.vtkFiltersSources import vtkSphereSource

import anisotropic_remeshing as ar

SOURCE = "."
FOLDER = os.path.dirname(ar.__file__)
CLASSES = [name for name in ar.__all__ if name.startswith("vtk")]


def text_of(*names):
    with open(os.path.join(SOURCE, *names), encoding="utf-8") as file:
        return file.read()


def html_of_result(environment):
    """What a result shows of itself in a process with that environment."""
    code = ("import anisotropic_remeshing as ar\n"
            "from vtkmodules.vtkFiltersSources import vtkSphereSource\n"
            "print(ar.remesh(vtkSphereSource(), 60)._repr_html_())")
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True,
                         timeout=120, env=environment)
    assert "<td style='text-align:left'>60</td>" in out.stdout, out.stdout
    return out.stdout


class TestPackage(unittest.TestCase):
    def test_names(self):
        from anisotropic_remeshing import vtkFiltersAnisotropicRemeshing as module

        self.assertEqual(len(CLASSES), 11)
        for name in ar.__all__:
            self.assertTrue(hasattr(ar, name), name)
        for name in CLASSES:
            self.assertIs(getattr(ar, name), getattr(module, name))

    def test_pickles(self):
        self.assertEqual(ar.RemeshingError.__module__, "anisotropic_remeshing")
        error = pickle.loads(pickle.dumps(ar.RemeshingError("text")))
        self.assertEqual(error.args, ("text",))

    def test_documents(self):
        for name in ar.__all__:
            public = getattr(ar, name)
            if name.startswith("_"):
                continue
            self.assertTrue(inspect.getdoc(public), name)
            if inspect.isclass(public) and not name.startswith("vtk"):
                for member, value in inspect.getmembers(public):
                    if not member.startswith("_") and isinstance(value, property):
                        self.assertTrue(value.__doc__, f"{name}.{member}")
        for function in (ar.remesh, ar.voronoi, ar.compare, ar.embed, ar.metric_from_solution,
                         ar.metric_embedding, ar.spectral_embedding):
            for part in ("Parameters\n", "Returns\n", "Notes\n"):
                self.assertIn(part, inspect.getdoc(function), function.__name__)

    def test_version(self):
        version = re.search(r"project\(AnisotropicRemeshing VERSION ([0-9.]+)",
                            text_of("CMakeLists.txt"))[1]
        self.assertEqual(ar.__version__, version)
        self.assertEqual(importlib.metadata.version("anisotropic-remeshing"), version)
        self.assertIn(f"\nversion: {version}\n", text_of("CITATION.cff"))

    @unittest.skipIf(tomllib is None, "no tomllib")
    def test_metadata(self):
        """What CMake installs is what pip does."""
        given = tomllib.loads(text_of("pyproject.toml"))
        project = given["project"]
        metadata = importlib.metadata.metadata("anisotropic-remeshing")
        self.assertEqual(metadata["Name"], project["name"])
        self.assertEqual(metadata["Summary"], project["description"])
        self.assertEqual(metadata["Requires-Python"], project["requires-python"])
        pattern = given["tool"]["scikit-build"]["metadata"]["version"]["regex"]
        self.assertEqual(re.search(pattern, text_of("CMakeLists.txt"))["value"], ar.__version__)
        points = importlib.metadata.distribution("anisotropic-remeshing").entry_points
        self.assertEqual(
            {point.group: {point.name: point.value} for point in points}, project["entry-points"])
        for point in points:
            self.assertIsNotNone(importlib.util.find_spec(point.value))

    def test_nothing_costs(self):
        """What is not asked for is not imported."""
        code = ("import sys, anisotropic_remeshing; print([name for name in ('pyvista', 'tqdm', "
                "'vtkmodules.vtkRenderingCore', 'vtkmodules.vtkIOXML') if name in sys.modules])")
        out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True,
                             check=True, timeout=60)
        self.assertEqual(out.stdout, "[]\n")

    def test_stubs(self):
        """The types of the wrapped classes: all classes, methods and constants."""
        self.assertTrue(os.path.exists(os.path.join(FOLDER, "py.typed")))
        with open(os.path.join(FOLDER, "vtkFiltersAnisotropicRemeshing.pyi"),
                  encoding="utf-8") as file:
            tree = ast.parse(file.read())
        stubs = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
        self.assertEqual(set(stubs), set(CLASSES))
        for name, stub in stubs.items():
            told = {node.name for node in stub.body
                    if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
            told |= {node.target.id for node in stub.body if isinstance(node, ast.AnnAssign)}
            there = {member for member in vars(getattr(ar, name)) if not member.startswith("_")}
            self.assertEqual(told - {"__init__"}, there, name)
        anisotropy = next(node for node in stubs["vtkEmbeddedSurfaceAlgorithm"].body
                          if getattr(node, "name", "") == "SetAnisotropy")
        self.assertEqual(ast.unparse(anisotropy.args.args[1].annotation), "float")

    def test_html_without_display(self):
        """Where VTK cannot render, as before 9.4 without a display, it says so."""
        environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
        text = html_of_result(environment)
        if "data:image/png" not in text:
            self.assertIn("No picture: VTK cannot render here", text)

    def test_html_of_others(self):
        source = vtkSphereSource()
        for result in (ar.compare(source), ar.embed(source), ar.voronoi(source, [[0, 0, 1.0]]),
                       ar.metric_from_solution(source, chord_tolerance=0.01),
                       ar.spectral_embedding(source)):
            self.assertIn("<table>", result._repr_html_())


if __name__ == "__main__":
    SOURCE = sys.argv.pop(1)
    unittest.main(verbosity=2)
