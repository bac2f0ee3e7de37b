"""Runs the code of all documents, and looks whether the guide names all that the code has.

    TestSnippets.py --source FOLDER --build FOLDER --work FOLDER [--no-cxx] [--cmake FILE]
                    [unittest options]

1. Fenced blocks of python, sh, console, cpp and cmake are run, those under one heading together and
   in order, in a folder of their own with small input files (see make_inputs). Blocks of C++ are
   built with the block of CMake under the same heading, against an installation of the build.
2. A block that a test cannot run has a line `<!-- not run: REASON -->` above it; such blocks are
   listed. Blocks of text, json and the like are no code. A block without a language is a mistake.
3. A shell block that names cmake builds a program against that installation.
4. Every message of the filters is in Documentation/Messages.md; every array of their outputs is in
   Documentation/Outputs.md, and every array named there exists.
"""
import argparse
import os
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataWriter, vtkXMLPolyDataReader, vtkXMLPolyDataWriter)
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource

import anisotropic_remeshing as ar

CODE = ("python", "sh", "console", "cpp", "cmake")
NO_CODE = ("text", "json", "csv")
SECONDS = 120  # for the blocks of one heading, on a busy machine
OPTIONS = None  # of the command line


# --- Blocks ---------------------------------------------------------------------------------------
class Block:
    def __init__(self, place, language, reason):
        self.place, self.language, self.reason = place, language, reason
        self.lines = []

    @property
    def text(self):
        return "\n".join(self.lines) + "\n"


def sections_of(path):
    """{heading: its fenced blocks}."""
    sections, heading, block, reason = {}, "", None, None
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        fence = re.match(r"(\s*)```(\w*)", line)
        mark = re.match(r"\s*<!-- not run: (.+?) -->", line)
        if block is not None:
            if fence:
                block = None
            else:
                block.lines.append(line[indent:])
        elif fence:
            indent = len(fence.group(1))
            block = Block(f"{path.name}:{number}", fence.group(2), reason)
            sections.setdefault(heading, []).append(block)
            reason = None
        elif mark:
            reason = mark.group(1)
        elif re.match(r"#+ ", line):
            heading = line.lstrip("# ")
    return sections


# --- Input files ----------------------------------------------------------------------------------
def write(writer, data, name):
    writer.SetFileName(name)
    writer.SetInputData(data)
    writer.Write()


def make_inputs(folder):
    """The files that the snippets read: small surfaces of the kinds that their names tell."""
    sys.path.insert(0, str(OPTIONS.source / "Examples" / "Python"))
    import shapes

    os.makedirs(folder)
    scan = shapes.surface(*shapes.knot(120, 24))
    write(vtkPLYWriter(), scan, f"{folder}/scan.ply")
    write(vtkXMLPolyDataWriter(), scan, f"{folder}/scan.vtp")
    write(vtkPLYWriter(), scan, f"{folder}/other.ply")
    part = shapes.surface(*shapes.rounded_box())
    write(vtkXMLPolyDataWriter(), part, f"{folder}/part.vtp")
    write(vtkSTLWriter(), shapes.surface(*shapes.gear(6, 2)), f"{folder}/part.stl")

    points, triangles = shapes.sphere(24)
    labelled = shapes.surface(points, triangles, Density=1.0 + 10.0 * (points[:, 0] > 0.0),
                              Temperature=numpy.tanh(5.0 * points[:, 2]))
    material = (points[triangles].mean(axis=1)[:, 2] > 0.0).astype(numpy.int32)
    array = numpy_to_vtk(material, deep=True)
    array.SetName("Material")
    labelled.GetCellData().AddArray(array)
    write(vtkXMLPolyDataWriter(), labelled, f"{folder}/labels.vtp")

    # Texture coordinates that jump from 1 to 0, where a tube closes.
    u, v = numpy.meshgrid(*2 * [numpy.linspace(0.0, 1.0, 33)], indexing="ij")
    angle = 2 * numpy.pi * (u.ravel() % 1.0)
    tube = shapes.surface(numpy.stack([numpy.cos(angle), numpy.sin(angle), v.ravel()], axis=1),
                          shapes.lattice(33, 33))
    texture = numpy_to_vtk(numpy.stack([u.ravel(), v.ravel()], axis=1), deep=True)
    texture.SetName("UV")
    tube.GetPointData().SetTCoords(texture)
    write(vtkXMLPolyDataWriter(), tube, f"{folder}/textured.vtp")

    # A metric: ten times as long along y as along x.
    points, triangles = shapes.sphere(24)
    metric = shapes.surface(points, triangles, Metric=numpy.tile(
        [100.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0], (len(points), 1)))
    write(vtkXMLPolyDataWriter(), metric, f"{folder}/metric.vtp")

    # A tile of a periodic surface: a wave that goes on at all sides.
    x, y = numpy.meshgrid(*2 * [numpy.linspace(0.0, 1.0, 25)], indexing="ij")
    z = 0.1 * numpy.sin(2 * numpy.pi * x) * numpy.sin(2 * numpy.pi * y)
    tile = shapes.surface(numpy.stack([x.ravel(), y.ravel(), z.ravel()], axis=1),
                          shapes.lattice(25, 25))
    write(vtkXMLPolyDataWriter(), tile, f"{folder}/tile.vtp")

    image = vtkRTAnalyticSource()
    image.Update()
    write(vtkXMLImageDataWriter(), image.GetOutput(), f"{folder}/image.vti")


# --- Running --------------------------------------------------------------------------------------
class TestSnippets(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = OPTIONS.work / "Snippets"
        shutil.rmtree(cls.folder, ignore_errors=True)
        make_inputs(cls.folder / "inputs")
        # The first of their names on PATH: this interpreter, and the programs of this build.
        os.makedirs(cls.folder / "bin")
        os.symlink(sys.executable, cls.folder / "bin" / "python3")
        cls.environment = dict(
            os.environ, PATH=os.pathsep.join([str(cls.folder / "bin"), str(OPTIONS.build / "bin"),
                                              os.environ["PATH"]]),
            CMAKE_PREFIX_PATH=str(cls.folder / "prefix"))
        cls.sources = [OPTIONS.source / "README.md", OPTIONS.source / "CONTRIBUTING.md",
                       *sorted((OPTIONS.source / "Documentation").glob("*.md"))]

    def scratch(self, path, number):
        """A new folder with the inputs, and the tree's names that README's commands use."""
        folder = self.folder / f"{path.stem}-{number}"
        shutil.copytree(self.folder / "inputs", folder)
        for name in ("Examples", "CMake", "Testing"):
            os.symlink(OPTIONS.source / name, folder / name)
        os.makedirs(folder / "build")
        for name in ("bin", "lib"):
            os.symlink(OPTIONS.build / name, folder / "build" / name)
        return folder

    def run_in(self, folder, command, what):
        result = subprocess.run(command, cwd=folder, env=self.environment, encoding="utf-8",
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False,
                                stdin=subprocess.DEVNULL, timeout=SECONDS)
        self.assertEqual(result.returncode, 0, f"{what} fails:\n{result.stdout[-3000:]}")

    def run_shell(self, folder, block):
        lines = block.lines
        if block.language == "console":  # commands follow a prompt, the rest is what they print
            lines = [line[2:] for line in lines if line.startswith("$ ")]
        self.run_in(folder, ["sh", "-e", "-c", "\n".join(lines)], block.place)

    def install(self):
        """The build, once, where the snippets' CMake looks."""
        if not (self.folder / "prefix").exists():
            self.run_in(self.folder, [OPTIONS.cmake, "--install", str(OPTIONS.build), "--prefix",
                                      str(self.folder / "prefix")], "the installation")

    def run_cxx(self, folder, blocks):
        """Writes the project of the blocks; builds and runs it, unless shell blocks do."""
        build = next(block for block in blocks if block.language == "cmake")
        program = next(block for block in blocks if block.language == "cpp")
        names = re.search(r"add_executable\((\w+)\s+([\w.]+)", build.text)
        (folder / names.group(2)).write_text(program.text, encoding="utf-8")
        (folder / "CMakeLists.txt").write_text(build.text, encoding="utf-8")
        if any("cmake" in block.text for block in blocks if block.language == "sh"):
            return
        configure = [OPTIONS.cmake, "-S", ".", "-B", "cxx", "-DCMAKE_BUILD_TYPE=Release"]
        self.run_in(folder, configure, build.place)
        self.run_in(folder, [OPTIONS.cmake, "--build", "cxx"], program.place)
        self.run_in(folder, [f"./cxx/{names.group(1)}", "scan.ply", "out.vtp"], program.place)

    def run_section(self, path, number, blocks):
        folder = self.scratch(path, number)
        script = [block for block in blocks if block.language == "python"]
        project = [block for block in blocks if block.language in ("cpp", "cmake")]
        if script:
            (folder / "snippet.py").write_text("".join(b.text for b in script), encoding="utf-8")
            self.run_in(folder, [sys.executable, "snippet.py"], script[0].place)
        builds = [b for b in blocks if b in project or b.language == "sh" and "cmake" in b.text]
        if builds and OPTIONS.no_cxx:
            print(f"not run: {builds[0].place}: programs of this build need its sanitizers")
            blocks = [block for block in blocks if block not in builds]
        elif builds:
            self.install()
            if project:
                self.assertEqual({b.language for b in project}, {"cpp", "cmake"}, project[0].place)
                self.run_cxx(folder, blocks)
        for block in blocks:
            if block.language in ("sh", "console"):
                self.run_shell(folder, block)

    def test_blocks(self):
        ran = 0
        for path in self.sources:
            for number, (heading, blocks) in enumerate(sections_of(path).items()):
                good = []
                for block in blocks:
                    self.assertIn(block.language, CODE + NO_CODE, f"{block.place}: which language?")
                    if block.language in CODE and block.reason:
                        print(f"not run: {block.place} ({block.language}): {block.reason}")
                    elif block.language in CODE:
                        good.append(block)
                if good:
                    ran += len(good)
                    with self.subTest(file=path.name, heading=heading):
                        self.run_section(path, number, good)
        print(f"{ran} blocks of code ran")
        self.assertGreater(ran, 10)

    def test_fences(self):
        """Code stands between fences, so that it is run; in lists, text may be indented."""
        for path in self.sources:
            in_list = fenced = blank = False
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                fenced ^= line.lstrip().startswith("```")
                if line and not line.startswith(" "):
                    in_list = bool(re.match(r"[-*] |\d+\. ", line))
                code = not fenced and not in_list and blank and line.startswith("    ")
                self.assertFalse(code, f"{path.name}:{number}: fence this code with its language")
                blank = not line.strip()

    def test_links(self):
        """Files and headings that the documents refer to exist."""
        for path in self.sources:
            text = re.sub(r"```.*?```", "", path.read_text(encoding="utf-8"), flags=re.DOTALL)
            for target in re.findall(r"\]\(([^)\s]+)\)", text):
                name, _, anchor = target.partition("#")
                if "://" in name or name.startswith("mailto:"):
                    continue
                file = (path.parent / name) if name else path
                self.assertTrue(file.exists(), f"{path.name}: there is no {target}")
                if anchor:
                    headings = re.findall(r"^#+ (.+)$", file.read_text(encoding="utf-8"), re.M)
                    anchors = [re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")
                               for heading in headings]
                    self.assertIn(anchor, anchors, f"{path.name}: {target}")


# --- What the guide must name ---------------------------------------------------------------------
STATEMENTS = (
    r"warnings\.(?:push|emplace)_back\((.*?)\);", r"vtkWarning(?:WithObject)?Macro\((.*?)\);",
    r"\bwarning\s*<<(.*?);", r"\bwarning\s*=(.*?);", r"vtkError(?:WithObject)?Macro\((.*?)\);",
    r"Status::(?:invalid|empty)\((.*?)\);", r"StatusCode::OutOfMemory,(.*?)[;}]",
    r"\bmessage\s*<<(.*?);", r"\btext\s*<<(.*?);", r"status\.message\s*=(.*?);")
# Whose every string is a part of a message.
WHOLE_FILES = ("Adaptors/Distribution.h", "Adaptors/CarriedArrays.cxx", "Adaptors/LeafSurface.cxx",
               "Core/Delaunay/TopologyResult.cxx")


def plain(text):
    """Words alone, so that line ends and quotes do not matter."""
    return " ".join(re.sub(r"[`\"*\\]", " ", text).split())


def fragments(source):
    """The parts of messages that stand in the code, of three words or more."""
    text = re.sub(r"//[^\n]*|/\*.*?\*/", "", source.read_text(encoding="utf-8"), flags=re.DOTALL)
    statements = ([text] if str(source).endswith(WHOLE_FILES) else
                  [part for pattern in STATEMENTS for part in re.findall(pattern, text, re.DOTALL)])
    for statement in statements:
        joined = re.sub(r'"\s*\n\s*"', "", statement)  # literals that follow each other are one
        for literal in re.findall(r'"((?:[^"\\\n]|\\.)*)"', joined):
            if len(re.findall(r"[A-Za-z]{2,}", literal)) >= 3:
                yield plain(literal)


class TestGuide(unittest.TestCase):
    def test_messages(self):
        """Every warning and error of the filters is explained."""
        guide = plain((OPTIONS.source / "Documentation" / "Messages.md").read_text("utf-8"))
        filters = OPTIONS.source / "Filters"
        missing, found = [], 0
        for source in sorted(filters.rglob("*")):
            if source.suffix in (".cxx", ".h"):
                for words in fragments(source):
                    found += 1
                    if words not in guide:
                        missing.append(f"{source.relative_to(filters)}: {words}")
        self.assertEqual(missing, [], "\n".join(["Messages.md lacks", *missing]))
        self.assertGreater(found, 60)

    @staticmethod
    def names_of(data, field=True):
        """Names of all arrays of an output, of its points, cells, rows and field data."""
        kinds = ["GetRowData"] if hasattr(data, "GetRowData") else ["GetPointData", "GetCellData"]
        names = set()
        for kind in kinds + ["GetFieldData"] * field:
            attributes = getattr(data, kind)()
            names |= {attributes.GetAbstractArray(k).GetName()
                      for k in range(attributes.GetNumberOfArrays())}
        return names

    def test_arrays(self):
        """Every array of a port is described, and every one that is described comes out."""
        folder = OPTIONS.work / "Arrays"
        shutil.rmtree(folder, ignore_errors=True)
        make_inputs(folder)
        surface = vtkXMLPolyDataReader()
        surface.SetFileName(str(folder / "labels.vtp"))
        surface.Update()
        surface = surface.GetOutput()
        plain_run = ar.remesh(surface, 200)
        runs = [plain_run, ar.remesh(surface, 200, density="Density", feature_labels="Material"),
                ar.voronoi(surface, plain_run.points)]
        metric = ar.metric_from_solution(surface, "Temperature", 200)
        adapted = metric._outputs[0]
        runs.append(ar.remesh(adapted, 200, metric="Metric"))
        compared = ar.compare(plain_run, surface)
        text = (OPTIONS.source / "Documentation" / "Outputs.md").read_text("utf-8")
        parts = {title: body for title, body in re.findall(r"^## (.+?)$(.+?)(?=^## |\Z)", text,
                                                           re.MULTILINE | re.DOTALL)}
        own = {f"Port {port}": [run._outputs[port] for run in runs] for port in range(5)}
        own["The comparison"] = compared._outputs
        own["The embedding of a metric"] = ar.metric_embedding(adapted, "Metric", 200)._outputs
        own["Eigenfunctions"] = ar.spectral_embedding(surface)._outputs
        own["The metric of a solution"] = metric._outputs
        carried = dict.fromkeys(own, self.names_of(surface))
        carried.update(dict.fromkeys((name for name in own if name.startswith("Port")),
                                     self.names_of(adapted)))
        carried["The embedding of a metric"] = self.names_of(adapted) - {"MetricPoints"}
        carried["The comparison"] = self.names_of(plain_run.mesh, field=False)
        for title, outputs in own.items():
            body = next(parts[name] for name in parts if name.startswith(title))
            rows = re.findall(r"^\| (`.*?) \|", body, re.MULTILINE)
            described = {name for row in rows for name in re.findall(r"`(\w+)`", row)}
            described |= set(re.findall(r"^Points have `(\w+)`", body, re.MULTILINE))
            ours = title != "The comparison"  # whose field data is that of its inputs
            names = set().union(*(self.names_of(output, ours) for output in outputs))
            names -= carried[title]
            self.assertEqual(sorted(names - described), [], f"{title}: arrays lack in Outputs.md")
            self.assertEqual(sorted(described - names), [], f"{title}: there are no such arrays")


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    for option in ("--source", "--build", "--work"):
        parser.add_argument(option, type=lambda name: Path(name).resolve(), required=True)
    parser.add_argument("--no-cxx", action="store_true")
    parser.add_argument("--cmake", default="cmake")
    OPTIONS, rest = parser.parse_known_args()
    unittest.main(argv=sys.argv[:1] + rest, verbosity=2)
