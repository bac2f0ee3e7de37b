"""What the tests of remesh_surface share: surfaces in all formats, and running the program."""
import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkOBJWriter, vtkSTLReader, vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataReader, vtkPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYReader, vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

FORMATS = ("vtp", "vtk", "ply", "stl", "obj")
WRITERS = dict(zip(FORMATS, (vtkXMLPolyDataWriter, vtkPolyDataWriter, vtkPLYWriter, vtkSTLWriter,
                             vtkOBJWriter)))
READERS = dict(zip(FORMATS, (vtkXMLPolyDataReader, vtkPolyDataReader, vtkPLYReader, vtkSTLReader,
                             vtkOBJReader)))
SMALL = ["--points", "60", "--lloyd", "2"]
LAST_LINE = (r"\A\S.*: (\d+) points, (\d+) triangles, topology (preserved|not proven)"
             r"(, RMS distance \S+ of the diagonal)?, \d+\.\d s\n\Z")


def sphere():
    """An ellipsoid with the arrays Normals (active; those of the sphere), Six and Height."""
    source = vtkSphereSource()
    source.SetThetaResolution(24)
    source.SetPhiResolution(20)
    source.Update()
    surface = vtkPolyData()
    surface.DeepCopy(source.GetOutput())
    points = vtk_to_numpy(surface.GetPoints().GetData())
    normals = vtk_to_numpy(surface.GetPointData().GetNormals()).astype(float)
    points[:, 0] *= 2.0
    six = numpy.hstack([points.astype(float), 0.25 * normals])
    for name, values in (("Six", six), ("Height", points[:, 2].copy())):
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        surface.GetPointData().AddArray(array)
    return surface


def write(surface, path):
    writer = WRITERS[path.rsplit(".", 1)[1]]()
    writer.SetInputData(surface)
    writer.SetFileName(path)
    if isinstance(writer, vtkXMLPolyDataWriter):
        writer.SetDataModeToBinary()  # ParaView 5.11 fails on appended data with newer libexpat
    writer.Write()


def read(path):
    reader = READERS[path.rsplit(".", 1)[1].lower()]()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def load(path):
    """A report."""
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def content(path):
    with open(path, "rb") as file:
        return file.read()


class CommandLineTest(unittest.TestCase):
    """Each test runs in an empty folder of its own; the inputs are in another."""
    program = None
    work = None

    @classmethod
    def setUpClass(cls):
        cls.inputs = tempfile.mkdtemp(dir=cls.work, prefix="inputs-")
        surface = sphere()
        for extension in FORMATS:
            write(surface, os.path.join(cls.inputs, "sphere." + extension))

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.inputs)

    def setUp(self):
        self.folder = tempfile.mkdtemp(dir=self.work, prefix="run-")
        self.addCleanup(shutil.rmtree, self.folder)

    def input(self, name="sphere.vtp"):
        return os.path.join(self.inputs, name)

    def save(self, name, data):
        """A file of the inputs' folder with the given bytes; its path."""
        path = self.input(name)
        with open(path, "wb") as file:
            file.write(data)
        return path

    def run_program(self, *arguments, **keywords):
        return subprocess.run([self.program, *arguments], cwd=self.folder, capture_output=True,
                              encoding="utf-8", errors="replace", timeout=300, check=False,
                              **keywords)

    def succeed(self, *arguments, **keywords):
        """The run says nothing but its last line, which is returned."""
        result = self.run_program(*arguments, **keywords)
        self.assertEqual((result.returncode, result.stderr), (0, ""), arguments)
        if {"--quiet", "-q"} & set(arguments):
            self.assertEqual(result.stdout, "")
        else:
            self.assertRegex(result.stdout, LAST_LINE)
        return result.stdout

    def fail_with(self, status, pattern, *arguments, **keywords):
        """The run has this exit status, one sentence that matches, and leaves no new file."""
        before = sorted(os.listdir(self.folder))
        result = self.run_program(*arguments, **keywords)
        self.assertEqual(result.returncode, status, (arguments, result.stderr))
        self.assertEqual(result.stdout, "")
        self.assertRegex(result.stderr, r"\Aremesh_surface: [^\n]+\n\Z")
        self.assertRegex(result.stderr, pattern)
        self.assertEqual(sorted(os.listdir(self.folder)), before, arguments)

    def path(self, name):
        return os.path.join(self.folder, name)


def main():
    """Runs the tests of the calling script: --program FILE --work FOLDER [unittest options]."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    parser.add_argument("--work", required=True)
    known, rest = parser.parse_known_args()
    CommandLineTest.program = os.path.abspath(known.program)
    CommandLineTest.work = os.path.abspath(known.work)
    os.makedirs(CommandLineTest.work, exist_ok=True)
    unittest.main(argv=sys.argv[:1] + rest, verbosity=2)
