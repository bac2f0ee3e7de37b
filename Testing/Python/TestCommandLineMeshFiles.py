"""Tests of remesh_surface: .mesh, .meshb, and the metric in the .sol and .solb beside them.

    TestCommandLineMeshFiles.py --program build/bin/remesh_surface --work FOLDER [unittest options]

Binary files are written and read here by code of their own, as the format tells.
"""
import gzip
import json
import os
import pathlib
import re
import struct

import numpy

from CommandLineTesting import SMALL, content, main, read, sphere, write
from TestCommandLineFiles import CORNERS, SIDES, FilesTest
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

DIMENSION, VERTICES, EDGES, QUADRILATERALS, END, SOLUTIONS = 3, 4, 5, 7, 54, 62
TRIANGLES = 6
SOL_FROM_VTK = [0, 3, 1, 5, 4, 2]  # 11 12 22 13 23 33 of XX YY ZZ XY YZ XZ


class Binary:
    """A binary file that is made section by section."""

    def __init__(self, version=2, order="<"):
        self.version, self.order = version, order
        self.bytes = self.pack("ii", 1, version)
        self.places = []  # of what each section tells about the next one
        self.section(DIMENSION, self.pack("i", 3))

    def pack(self, form, *values):
        return struct.pack(self.order + form, *values)

    def whole(self, *values):
        return self.pack(("q" if self.version == 4 else "i") * len(values), *values)

    def real(self, *values):
        return self.pack(("f" if self.version == 1 else "d") * len(values), *values)

    def place(self, value):
        return self.pack("q" if self.version > 2 else "i", value)

    def section(self, code, data):
        self.bytes += self.pack("i", code)
        self.places.append(len(self.bytes))
        end = len(self.bytes) + len(self.place(0)) + len(data)
        self.bytes += self.place(end) + data
        return self

    def end(self):
        self.bytes += self.pack("i", END) + self.place(0)
        return self.bytes

    def box(self):
        self.section(VERTICES, self.whole(8) + b"".join(
            self.real(*corner) + self.whole(0) for corner in CORNERS))
        self.section(EDGES, self.whole(1, 1, 2, 7))
        return self.section(QUADRILATERALS, self.whole(6) + b"".join(
            self.whole(*(k + 1 for k in side), i) for i, side in enumerate(SIDES)))

    def solutions(self):
        """A tensor and a size for each corner of the box."""
        row = self.real(11, 12, 22, 13, 23, 33, 5)
        return self.section(SOLUTIONS, self.whole(8) + self.pack("iii", 2, 3, 1) + 8 * row)


def sections_of(data):
    """The data of the sections of a file of version 2, by their codes."""
    found = {}
    assert struct.unpack_from("<ii", data) == (1, 2)
    place = 8
    while place:
        code, after = struct.unpack_from("<ii", data, place)
        found[code] = data[place + 8:after or len(data)]
        place = after
    return found


def solution_text(data):
    """The types and the numbers, a row for each vertex, of a text with one solution."""
    words = data.split()
    assert words[:5] == [b"MeshVersionFormatted", b"2", b"Dimension", b"3", b"SolAtVertices"], words
    assert words[6] == b"1" and words[-1] == b"End", words[:9]
    return int(words[7]), numpy.array(words[8:-1], dtype=float).reshape(int(words[5]), -1)


class TestBinary(FilesTest):
    def test_versions(self):
        """All versions, in both orders of bytes, are the same surface as the text."""
        for version in (1, 2, 3, 4):
            for order in "<>":
                with self.subTest(version=version, order=order):
                    self.save("box.solb", Binary(version, order).solutions().end())
                    surface = self.read_box("box.meshb", Binary(version, order).box().end())
                    points = vtk_to_numpy(surface.GetPoints().GetData())
                    self.assertEqual(points.tolist(), [list(corner) for corner in CORNERS])
                    references = surface.GetCellData().GetArray("Reference")
                    self.assertEqual(sorted(vtk_to_numpy(references)), list(range(6)))
                    data = surface.GetPointData()
                    self.assertEqual(data.GetArray("Metric").GetTuple(3),
                                     (11.0, 22.0, 33.0, 12.0, 23.0, 13.0))
                    self.assertEqual(data.GetArray("Solution1").GetTuple(7), (5.0,))
        os.remove(self.input("box.solb"))
        self.save("box.sol", b"MeshVersionFormatted 2 Dimension 3 SolAtVertices 8 1 1\n"
                  + b"7\n" * 8 + b"End\n")
        surface = self.read_box("box.meshb", Binary().box().end())
        self.assertEqual(surface.GetPointData().GetArray("Metric").GetTuple(0), (7.0,))
        os.remove(self.input("box.sol"))

    def fail(self, pattern, data, name="wrong.meshb"):
        path = self.save(name, data)
        with self.subTest(pattern=pattern):
            self.fail_with(1, pattern, path.replace(".solb", ".meshb"), "out2.vtp")

    def test_truncated(self):
        data = Binary().box().end()
        for size in (*range(1, 40), *range(40, len(data), 11), len(data) - 1):
            self.fail("malformed .meshb file, it ends too early" if size >= 4 else
                      "its first four bytes are not the number 1", data[:size])

    def test_malformed(self):
        box = Binary().box
        file = box()
        data = file.end()

        def with_number(place, number):
            return data[:place] + struct.pack("<i", number) + data[place + 4:]

        vertices, edges = file.places[1] + 4, file.places[2] + 4
        self.fail("first four bytes are not the number 1", b"MeshVersionFormatted 2\n")
        self.fail("byte 4 has 5 for the version, 1 to 4", with_number(4, 5))
        self.fail("byte 16 has 4 for the dimension, 2 or 3", with_number(16, 4))
        self.fail("has -1 for the number of vertices", with_number(vertices, -1))
        self.fail("has 2147483647 for the number of vertices", with_number(vertices, 2 ** 31 - 1))
        self.fail("has more than fits before byte", with_number(vertices, 9))
        quadrilaterals = file.places[3] + 4
        self.fail("has 9 for a corner", with_number(quadrilaterals + 4, 9))
        self.fail("has 0 for a corner", with_number(quadrilaterals + 4, 0))
        for place in (-5, 8, edges - 8):  # the last is that of the section itself
            self.fail("for where the next section is", with_number(file.places[2], place))
        for place in (len(data) + 1, 2 ** 31 - 1):
            self.fail("it ends too early", with_number(file.places[2], place))
        nan = struct.pack("<d", float("nan"))
        self.fail("has -?nan for a coordinate", data[:vertices + 4] + nan + data[vertices + 12:])
        wide = Binary(4).section(VERTICES, struct.pack("<q", 2 ** 62)).end()
        self.fail("has 4611686018427387904 for the number of vertices", wide)
        far = Binary(3)
        far.bytes = far.bytes[:12] + struct.pack("<q", 2 ** 62) + far.bytes[20:]
        self.fail("it ends too early", far.box().end())

    def test_malformed_solutions(self):
        self.save("wrong.meshb", Binary().box().end())
        few = Binary().section(SOLUTIONS, struct.pack("<iii", 7, 1, 1) + 7 * struct.pack("<d", 1))
        self.fail("not that of the mesh", few.end(), "wrong.solb")
        for count, kind, pattern in ((0, 1, "the number of solutions"), (1, 4, "a type"),
                                     (1, 1, "has more than fits")):
            file = Binary().section(SOLUTIONS, struct.pack("<iii", 8, count, kind))
            self.fail(pattern, file.end(), "wrong.solb")
        self.fail("no solution at the vertices", Binary().end(), "wrong.solb")
        self.fail("malformed .solb file, it ends too early",
                  Binary().solutions().end()[:-40], "wrong.solb")
        os.remove(self.input("wrong.solb"))

    def test_written(self):
        """The same mesh as in the text, read back and through pipes, compressed or not."""
        self.succeed(self.input(), "a.meshb", *SMALL)
        self.succeed(self.input(), "a.mesh", *SMALL)
        words = content(self.path("a.mesh")).split()
        sections = sections_of(content(self.path("a.meshb")))
        self.assertEqual(set(sections), {DIMENSION, VERTICES, TRIANGLES, END})
        self.assertEqual(sections[VERTICES][:4], struct.pack("<i", 60))
        rows = list(struct.iter_unpack("<dddi", sections[VERTICES][4:]))
        self.assertEqual(rows, [tuple(map(float, words[k:k + 4])) for k in range(6, 246, 4)])
        self.assertEqual(sections[TRIANGLES][:4], struct.pack("<i", 116))
        rows = list(struct.iter_unpack("<iiii", sections[TRIANGLES][4:]))
        self.assertEqual(rows, [tuple(map(int, words[k:k + 4])) for k in range(248, 712, 4)])
        self.assertEqual(sorted(os.listdir(self.folder)), ["a.mesh", "a.meshb"])
        binary = content(self.path("a.meshb"))
        again = self.read_in("a.meshb", binary)
        self.assertEqual(again.GetNumberOfPolys(), 116)
        self.read_in("b.meshb.gz", gzip.compress(binary))
        first = content(self.path("out.vtp"))
        self.read_in("c.mesh", content(self.path("a.mesh")))
        self.assertEqual(content(self.path("out.vtp")), first)
        with open(self.input("a.meshb"), "rb") as file:
            self.run_program("-", "piped.vtp", *SMALL, "--quiet", stdin=file)
        self.assertEqual(content(self.path("piped.vtp")), first)


class TestMetricOfMesh(FilesTest):
    def input_with(self, name, values, array_name="M"):
        surface = sphere()
        array = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
        array.SetName(array_name)
        surface.GetPointData().AddArray(array)
        write(surface, self.input(name))
        return self.input(name)

    def tensors(self):
        """Of the sphere's points: 1 / h^2 times a constant tensor, in VTK's order."""
        points = vtk_to_numpy(sphere().GetPoints().GetData()).astype(float)
        scale = 4.0 + points[:, 0]
        return scale[:, None] * numpy.array([3.0, 2.0, 1.0, 0.5, 0.25, 0.125])

    def metric_of(self, name, values, *options):
        """What the .sol says, and the array of the mesh itself."""
        path = self.input_with(name + ".vtp", values)
        self.succeed(path, name + ".mesh", *SMALL, "--metric", "M", *options)
        self.succeed(path, name + ".vtp", *SMALL, "--metric", "M", *options)
        mesh = read(self.path(name + ".vtp"))
        self.assertEqual(content(self.path(name + ".mesh")).split()[5],
                         str(mesh.GetNumberOfPoints()).encode())
        kind, rows = solution_text(content(self.path(name + ".sol")))
        return kind, rows, vtk_to_numpy(mesh.GetPointData().GetArray("M"))

    def test_orders(self):
        """Each order of components comes out as 11 12 22 13 23 33, digit by digit."""
        tensors = self.tensors()
        for name, places, options in (
                ("vtk", [0, 1, 2, 3, 4, 5], ()),
                ("rows", [0, 3, 5, 1, 4, 2], ("--metric-order", "rows")),
                ("sol", SOL_FROM_VTK, ("--metric-order", "sol")),
                ("nine", [0, 3, 5, 3, 1, 4, 5, 4, 2], ())):
            with self.subTest(order=name):
                kind, rows, mine = self.metric_of(name, tensors[:, places], *options)
                self.assertEqual((kind, rows.shape), (3, (60, 6)))
                back = [places.index(k) for k in SOL_FROM_VTK]
                self.assertEqual(rows.tolist(), mine[:, back].tolist())
                # The tensor is one constant times a number at each point.
                self.assertLess(abs(rows / rows[:, :1] * 3 - [3, 0.5, 2, 0.125, 0.25, 1]).max(),
                                1e-12)

    def test_size(self):
        sizes = 0.2 + 0.05 * vtk_to_numpy(sphere().GetPoints().GetData())[:, 0].astype(float)
        kind, rows, mine = self.metric_of("size", sizes)
        self.assertEqual((kind, rows[:, 0].tolist()), (1, mine.tolist()))

    def test_plane(self):
        """A tensor of the plane has an inverse in space, too."""
        n = 9
        x, y = (values.ravel() for values in numpy.meshgrid(numpy.arange(n), numpy.arange(n)))
        square = "OFF\n%d %d 0\n" % (n * n, (n - 1) ** 2) + "".join(
            "%d %d 0\n" % place for place in zip(x, y)) + "".join(
                "4 %d %d %d %d\n" % (k, k + 1, k + n + 1, k + n)
                for k in range(n * n) if k % n < n - 1 and k < n * (n - 1))
        surface = self.read_in("square.off", square)
        surface.GetPointData().RemoveArray("Embedding")
        for order, row in (("vtk", (4.0, 9.0, 2.0)), ("rows", (4.0, 2.0, 9.0))):
            array = numpy_to_vtk(numpy.array([row] * surface.GetNumberOfPoints()), deep=True)
            array.SetName("M")
            surface.GetPointData().AddArray(array)
            write(surface, self.input("square.vtp"))
            self.succeed(self.input("square.vtp"), "square.mesh", "-n", "60", "--metric", "M",
                         "--metric-order", order)
            kind, rows = solution_text(content(self.path("square.sol")))
            self.assertEqual(kind, 3)
            self.assertLess(abs(rows - [4, 2, 9, 0, 0, 32 ** 0.5]).max(), 1e-12)

    def test_names_of_own_arrays(self):
        """A metric with the name of an array of the mesh itself can be used, but not be written."""
        outputs = pathlib.Path(__file__).parents[2] / "Documentation" / "Outputs.md"
        table = outputs.read_text("utf-8").split("## Port 0: Surface")[1].split("Field data")[0]
        names = re.findall(r"^\| `(\w+)` \|", table, re.MULTILINE)
        self.assertIn("CellArea", names)
        for name in names:
            with self.subTest(name=name):
                self.fail_with(2, "--metric %s: the mesh has an array of its own" % name,
                               self.input(), "own.meshb", *SMALL, "--metric", name)
        path = self.input_with("own.vtp", self.tensors(), "CellArea")
        self.succeed(path, "own.vtp", *SMALL, "--metric", "CellArea")
        mesh = read(self.path("own.vtp"))
        self.assertEqual(mesh.GetPointData().GetArray("CellArea").GetNumberOfComponents(), 1)

    def test_solution(self):
        """The metric for a solution; mesh and metric are an input again, text or binary."""
        self.succeed(self.input(), "a.mesh", *SMALL, "--solution", "Height")
        self.succeed(self.input(), "a.vtp", *SMALL, "--solution", "Height")
        metric = vtk_to_numpy(read(self.path("a.vtp")).GetPointData().GetArray("Metric"))
        kind, rows = solution_text(content(self.path("a.sol")))
        self.assertEqual((kind, rows.tolist()), (3, metric[:, SOL_FROM_VTK].tolist()))
        self.succeed(self.input(), "b.meshb.gz", *SMALL, "--solution", "Height")
        self.assertEqual(sorted(os.listdir(self.folder)),
                         ["a.mesh", "a.sol", "a.vtp", "b.meshb.gz", "b.solb"])
        binary = sections_of(content(self.path("b.solb")))[SOLUTIONS]
        self.assertEqual(binary[:12], struct.pack("<iii", 60, 1, 3))
        self.assertEqual([list(row) for row in struct.iter_unpack("<6d", binary[12:])],
                         rows.tolist())
        for name in ("a.mesh", "b.meshb.gz"):
            again = self.run_program(name, "again.vtp", *SMALL, "--metric", "Metric",
                                     "--embedded-surface", "x.vtp")
            self.assertEqual(again.returncode, 0, again.stderr)  # 60 points meet it not everywhere
            taken = read(self.path("x.vtp")).GetPointData().GetArray("Metric")
            self.assertEqual(vtk_to_numpy(taken)[:60].tolist(), metric.tolist())

    def test_outputs(self):
        """No metric, no .sol; one that is read is never overwritten, nor one named twice."""
        self.succeed(self.input(), "a.mesh", *SMALL)
        self.succeed(self.input(), "a.vtp", *SMALL, "--solution", "Height")
        self.assertEqual(sorted(os.listdir(self.folder)), ["a.mesh", "a.vtp"])
        self.save("box.meshb", Binary().box().end())
        box = self.save("box.sol", b"MeshVersionFormatted 2 Dimension 3 SolAtVertices 8 1 1\n"
                        + b"0.5\n" * 8 + b"End\n")
        self.fail_with(2, "box.sol' is an input, and would be overwritten",
                       self.input("box.meshb"), self.input("box.mesh"), *SMALL, "--metric", "Metric")
        self.fail_with(1, "it is a directory", self.input(), self.blocked(), *SMALL, "--solution",
                       "Height")
        os.remove(box)

    def test_left_solution(self):
        """A .sol of another mesh is kept, and told: it would be read with the new one."""
        old = b"MeshVersionFormatted 2 Dimension 3 SolAtVertices 8 1 1\n" + b"0.5\n" * 8 + b"End\n"
        left = self.path("a.sol")
        with open(left, "wb") as file:
            file.write(old)
        for name in ("a.mesh", "a.meshb"):  # either kind is read
            made = self.run_program(self.input(), name, *SMALL, "-r", "a.json")
            self.assertEqual(made.returncode, 0)
            self.assertRegex(made.stderr, "a.sol' was there before, and does not belong to '.*"
                             + name + "', but will be read with it. Remove or rename it")
            self.assertEqual(len(json.loads(content(self.path("a.json")))["warnings"]), 1)
            self.assertEqual(content(left), old)
        self.succeed(self.input(), "b.mesh", *SMALL)
        made = self.run_program(self.input(), "a.mesh", *SMALL, "--solution", "Height")
        self.assertNotIn("was there before", made.stderr)
        self.assertNotEqual(content(left), old)

    def blocked(self):
        """The name of a mesh whose .sol cannot be written."""
        os.mkdir(self.path("b.sol"))
        return "b.mesh"

    def test_folder(self):
        """Each mesh of several has its own."""
        os.mkdir(self.path("meshes"))
        other = self.input_with("other.vtp", self.tensors())
        self.assertEqual(self.run_program(self.input(), other, "meshes/", *SMALL, "--solution",
                                          "Height", "-f", "meshb").returncode, 0)
        self.assertEqual(sorted(os.listdir(self.path("meshes"))),
                         ["other.meshb", "other.solb", "sphere.meshb", "sphere.solb"])


if __name__ == "__main__":
    main()
