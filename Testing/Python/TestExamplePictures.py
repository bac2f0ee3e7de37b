"""Runs the examples in Examples/Python that draw pictures, small, and looks at what comes out.

    TestExamplePictures.py FOLDER WORK [unittest options]

FOLDER is Examples/Python; needs a display.
"""
import contextlib
import io
import os
import runpy
import shutil
import sys
import unittest
from unittest import mock

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

FOLDER, WORK = "", ""


def run(name, *arguments):
    """What the example prints."""
    output = io.StringIO()
    path = os.path.join(FOLDER, name + ".py")
    with contextlib.redirect_stdout(output), mock.patch.object(sys, "argv", [path, *arguments]):
        runpy.run_path(path, run_name="__main__")
    return output.getvalue()


def numbers(text):
    """The numbers of a text, in order."""
    words = text.replace(",", " ").replace(":", " ").replace(";", " ").split()
    found = []
    for word in words:
        with contextlib.suppress(ValueError):
            found.append(float(word))
    return found


class TestExamplePictures(unittest.TestCase):
    def draw(self, name, *arguments, panels=2):
        """Runs an example; its picture must show something in each panel."""
        picture = os.path.join(WORK, name + ".png")
        text = run(name, "--picture", picture, "--scale", "0.25", *arguments)
        reader = vtkPNGReader()
        reader.SetFileName(picture)
        reader.Update()
        width, height, _ = reader.GetOutput().GetDimensions()
        pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
        pixels = pixels.reshape(height, width, -1)[..., :3].astype(int)
        for panel in numpy.array_split(pixels, panels, axis=1):
            # A background alone has few dark pixels, and those of its caption.
            self.assertGreater((panel.min(axis=2) < 150).mean(), 0.02, name)
        return text

    def test_points(self):
        few, some, many = numbers(self.draw("points", "--points", "200", panels=3))[1::2]
        self.assertTrue(few > some > many)
        self.assertLess(many, few / 8.0)

    def test_anisotropy(self):
        none, usual = numbers(self.draw("anisotropy", "--points", "600", panels=3))[1:4:2]
        self.assertLess(usual, 0.9 * none)

    def test_tolerance(self):
        rows = self.draw("tolerance", panels=3).splitlines()
        for row in rows:
            tolerance, _, largest, diagonal = numbers(row)
            self.assertLessEqual(largest, 1.001 * tolerance * diagonal)
        self.assertEqual(len(rows), 3)

    def test_density(self):
        text = self.draw("density", "--points", "600")
        self.assertGreater(float(text.split(" times")[0].split()[-1]), 5.0)

    def test_features(self):
        kept, cut = [numbers(row)[-1]
                     for row in self.draw("features", "--points", "900", panels=3).splitlines()]
        self.assertLess(kept, cut)

    def test_embedding(self):
        even, followed = numbers(self.draw("embedding", "--points", "1500", panels=3))
        self.assertLess(followed, 0.8 * even)

    def test_paper_figures(self):
        text = self.draw("paper_figures", "--points", "500", panels=3)
        mean = float(text.split(" +- ")[0].split()[-1])
        spread = float(text.split(" +- ")[1].split()[0])
        self.assertLess(spread, 0.2 * mean)

    def test_cad_normals(self):
        estimated, given = [float(row.split()[2])
                            for row in self.draw("cad_normals", "--points", "300", panels=3)
                            .splitlines()]
        self.assertLess(given, 0.2)
        self.assertGreater(estimated, 2.0)

    def test_decimation(self):
        rows = self.draw("decimation", "--points", "1000").splitlines()
        decimated, remeshed = [float(row.split("distance ")[1].split()[0]) for row in rows]
        self.assertLess(remeshed, decimated)

    def test_cells(self):
        self.assertRegex(self.draw("cells", "--points", "500"), r"^5\d\d cells in \d colours|^500 ")

    def test_convergence(self):
        with mock.patch.dict(sys.modules, {"matplotlib": None, "matplotlib.figure": None}):
            with self.assertRaisesRegex(SystemExit, "needs matplotlib"):
                run("convergence", "--points", "300", "--picture", os.path.join(WORK, "none.png"))
        try:
            import matplotlib  # noqa: F401
        except ImportError:
            print("no plot is drawn: python3-matplotlib is not installed")
            text = run("convergence", "--points", "500")
        else:
            text = self.draw("convergence", "--points", "500", panels=1)
        lloyd, newton = [numbers(row)[1] for row in text.splitlines()]
        self.assertLess(newton, lloyd)

    def test_adaptation(self):
        """The error of adapted meshes is a fraction of that of even ones, and falls like 1 / N."""
        arguments = ("adaptation", "--points", "1600")
        try:
            import matplotlib  # noqa: F401
        except ImportError:
            text = run(*arguments)
        else:
            text = self.draw(*arguments)
        front, wave = numpy.array([numbers(row.split("times")[1]) for row in text.splitlines()]
                                  ).reshape(2, 5, 2)
        self.assertLess(front[1:, 1].max(), 0.45)
        self.assertLess(front[-1, 1], 0.33)
        self.assertLess(wave[1:, 1].max() / wave[1:, 1].min(), 1.5)
        self.assertTrue((wave[1:, 1] < 0.8 * wave[1:, 0]).all())

    def test_metrics(self):
        text = self.draw("metrics", "--points", "600", panels=3)
        share, limit, mean, spread, unit = numbers(text.replace("%", " "))
        self.assertGreater(share, 99.0)
        self.assertLess(limit, 1.2)
        self.assertLess(spread, 0.12 * mean)
        self.assertLess(abs(mean / unit - 1.0), 0.1)

    def test_threads(self):
        self.assertIn("All meshes are the same", run("threads", "--points", "500"))

    def test_no_example_lacks(self):
        examples = {name[:-3] for name in os.listdir(FOLDER) if name.endswith(".py")}
        tested = {name[5:] for name in dir(self) if name.startswith("test_")}
        elsewhere = {"remesh", "flat_parts", "shapes", "panels"}  # in TestExamples, and modules
        self.assertEqual(examples - tested - elsewhere, set())


if __name__ == "__main__":
    FOLDER, WORK = os.path.abspath(sys.argv[1]), os.path.join(sys.argv[2], "ExamplePictures")
    shutil.rmtree(WORK, ignore_errors=True)
    os.makedirs(WORK)
    sys.path.insert(0, FOLDER)
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=2)
