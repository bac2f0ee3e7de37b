"""Tests of remesh_surface: files as people have them, and precision.

    TestCommandLineFiles.py --program build/bin/remesh_surface --work FOLDER [unittest options]

Surfaces are made here. How they were read is looked at in --embedded-surface, the input with its
arrays.
"""
import base64
import gzip
import json
import struct

import numpy

from CommandLineTesting import SMALL, CommandLineTest, content, load, main, read, sphere, write
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, VTK_TRIANGLE, vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

CORNERS = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
SIDES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
VERTICES = "".join("v %d %d %d\n" % corner for corner in CORNERS)


def face(side, form="%d"):
    return "f " + " ".join(form.replace("%d", str(i + 1)) for i in side) + "\n"


def utm_tile():
    """Points and triangles of a hilly square of 20 m, in the coordinates of a map."""
    n = 40
    x, y = numpy.meshgrid(numpy.linspace(0, 20, n + 1), numpy.linspace(0, 20, n + 1))
    height = 0.8 * (numpy.sin(x / 2) * numpy.cos(y / 3) + 0.12 * numpy.sin(2 * x + 3 * y))
    points = numpy.stack([4.5e5 + x, 5.4e6 + y, 300 + height], axis=-1).reshape(-1, 3).round(4)
    first = (numpy.arange(n) + (n + 1) * numpy.arange(n)[:, None]).ravel()
    triangles = numpy.concatenate([numpy.stack([first, first + 1, first + n + 2], axis=1),
                                   numpy.stack([first, first + n + 2, first + n + 1], axis=1)])
    return points, triangles


def obj_text(points, triangles):
    return "".join("v %.4f %.4f %.4f\n" % tuple(point) for point in points) + "".join(
        "f %d %d %d\n" % tuple(triangle + 1) for triangle in triangles)


def stl_text(points, triangles):
    return "solid tile\n" + "".join(
        "facet normal 0 0 0\nouter loop\n"
        + "".join("vertex %.4f %.4f %.4f\n" % tuple(points[i]) for i in triangle)
        + "endloop\nendfacet\n" for triangle in triangles) + "endsolid tile\n"


def ply_text(points, triangles):
    return ("ply\nformat ascii 1.0\nelement vertex %d\nproperty double x\nproperty double y\n"
            "property double z\nelement face %d\nproperty list uchar int vertex_indices\n"
            "end_header\n" % (len(points), len(triangles))
            + "".join("%.4f %.4f %.4f\n" % tuple(point) for point in points)
            + "".join("3 %d %d %d\n" % tuple(triangle) for triangle in triangles))


def area(surface):
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    ids = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    sides = points[ids[:, 1:]] - points[ids[:, :1]]
    return 0.5 * numpy.linalg.norm(numpy.cross(sides[:, 0], sides[:, 1]), axis=1).sum()


class FilesTest(CommandLineTest):
    def read_in(self, name, data, warning=""):
        """The surface as the program has read it, and the mesh, which has its area."""
        path = self.save(name, data if isinstance(data, bytes) else data.encode())
        result = self.run_program(path, "out.vtp", *SMALL, "--embedded-surface", "x.vtp")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stderr == "", warning == "", result.stderr)
        self.assertIn(warning, result.stderr)
        return read(self.path("x.vtp"))

    def read_box(self, name, data, warning=""):
        surface = self.read_in(name, data, warning)
        self.assertAlmostEqual(area(read(self.path("out.vtp"))), 6.0, delta=1e-9)
        return surface


class TestObj(FilesTest):
    def test_mixed_faces(self):
        attributes = "vt 0 0\nvt 1 0\nvn 0 0 1\n"
        forms = ["%d/1/1", "%d", "%d//1", "%d/2", "%d/1/", "%d/"]
        text = VERTICES + attributes + "".join(map(face, SIDES, forms))
        surface = self.read_box("mixed.obj", text, "texture coordinates of the file are not used: "
                                "12 of 24 corners")
        self.assertEqual(surface.GetNumberOfPoints(), 8)
        self.assertIsNone(surface.GetPointData().GetTCoords())

    def test_references_without_records(self):
        text = VERTICES + "".join(face(side, "%d/%d/1") for side in SIDES)
        self.read_box("none.obj", text)

    def test_as_people_write_them(self):
        bodies = {
            "negative": "".join("f " + " ".join(str(i - 8) for i in side) + "\n"
                                for side in SIDES),
            "continued": "".join(face(side).replace(" ", " \\\n ", 2) for side in SIDES),
            "comments": "# a comment \\\n" + "".join(
                face(side).replace("\n", " # side\n") for side in SIDES) + "#\n\n",
            "comment behind backslash": "".join(
                face(side).replace(" ", " \\ # goes on\n ", 1) for side in SIDES),
            "materials": "mtllib none.mtl\nusemtl\n" + "".join(map(face, SIDES)),
            "windows": "s off\n" + "".join(map(face, SIDES)).replace("\n", "\r\n"),
            "no end": "".join(map(face, SIDES)).rstrip("\n"),
        }
        for name, body in bodies.items():
            with self.subTest(name=name):
                self.read_box("people.obj", VERTICES + body)
        with self.subTest(name="faces first"):
            self.read_box("people.obj", "".join(map(face, SIDES)) + VERTICES)

    def test_groups(self):
        text = VERTICES + "o box\n"
        for i, side in enumerate(SIDES):
            text += f"g side {i // 2}\nusemtl {'red' if i < 5 else 'blue'}\n" + face(side)
        data = self.read_box("groups.obj", text).GetCellData()
        self.assertEqual(list(vtk_to_numpy(data.GetArray("GroupIds"))), [0, 0, 1, 1, 2, 2])
        self.assertEqual(list(vtk_to_numpy(data.GetArray("MaterialIds"))), [0, 0, 0, 0, 0, 1])
        self.assertIsNone(data.GetArray("ObjectIds"))  # there is one
        names = read(self.path("x.vtp")).GetFieldData().GetAbstractArray("GroupNames")
        self.assertEqual([names.GetValue(i) for i in range(3)], ["side 0", "side 1", "side 2"])
        self.succeed(self.input("groups.obj"), "l.vtp", *SMALL, "--labels", "GroupIds")

    def test_seams(self):
        # Around a seam, the points have two texture coordinates; each is kept with its corner.
        text = ("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0.25 0.5\n"
                "f 1/1 2/2 3/3\nf 1/4 3/3 4/2\n")
        surface = self.read_in("seam.obj", text, "interpolated across")
        self.assertEqual(surface.GetNumberOfPoints(), 5)
        self.assertEqual(surface.GetPoint(4), surface.GetPoint(0))
        textures = vtk_to_numpy(surface.GetPointData().GetTCoords())
        self.assertEqual(textures[[0, 4]].tolist(), [[0, 0], [0.25, 0.5]])

    def test_errors(self):
        for pattern, body in (
                ("line 9 refers to point 9, but there are 8", "f 1 2 9\n"),
                ("line 9 has a face that refers to point 0", "f 0 1 2\n"),
                ("line 9 has a face that refers to point -9", "f -9 1 2\n"),
                ("line 9 has a face with 'x'", "f 1 2 x\n"),
                ("line 9 has a face with '1.5'", "f 1 2 1.5\n"),
                ("line 9 has a face with fewer than three corners", "f 1 2\n"),
                ("line 10 is no statement", "f 1 2 3\n4 5\n"),
                ("line 9 has a free-form surface", "surf 0 1 0 1 1 2 3\n"),
                ("line 9 has no normal of three finite numbers", "vn 0 0\n"),
        ):
            with self.subTest(pattern=pattern):
                path = self.save("wrong.obj", (VERTICES + body).encode())
                self.fail_with(1, pattern, path, "out.vtp", *SMALL)


class TestPly(FilesTest):
    def test_precision(self):
        single = struct.unpack("f", struct.pack("f", 0.1))[0]
        for kind, expected in (("double", 0.1), ("float", single)):
            properties = "".join(f"property {kind} {axis}\n" for axis in "xyz")
            header = (f"element vertex 4\n{properties}element face 4\n"
                      "property list uchar int vertex_indices\nend_header\n")
            points = [(0.1, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
            faces = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
            text = "".join("%r %r %r\n" % point for point in points)
            text += "".join("3 %d %d %d\n" % face for face in faces)
            forms = {"ascii": text.encode()}
            for form, order in (("binary_big_endian", ">"), ("binary_little_endian", "<")):
                forms[form] = b"".join(struct.pack(f"{order}3{kind[0]}", *p) for p in points)
                forms[form] += b"".join(struct.pack(order + "B3i", 3, *f) for f in faces)
            for name, data in forms.items():
                with self.subTest(kind=kind, name=name):
                    surface = self.read_in("tetrahedron.ply",
                                           f"ply\nformat {name} 1.0\n{header}".encode() + data)
                    self.assertEqual(surface.GetPoint(0)[0], expected)
                    self.assertEqual(surface.GetPoints().GetData().GetDataTypeAsString(), kind)

    def test_strips(self):
        # Two strips of a box's sides, with a jump by triangles that have a point twice.
        strips = [[0, 1, 2, 3, 3, 6, 6, 7, 4, 5, -1, 0, 4, 1, 5],
                  [2, 3, 6, 7, -1, 0, 2, 4, 6, -1, 5, 7, 1, 3]]
        header = ("ply\nformat {} 1.0\nelement vertex 8\nproperty float x\nproperty float y\n"
                  "property float z\nelement tristrips 2\nproperty list int int vertex_indices\n"
                  "end_header\n")
        text = "".join("%d %d %d\n" % corner for corner in CORNERS)
        text += "".join(" ".join(map(str, [len(strip)] + strip)) + "\n" for strip in strips)
        binary = b"".join(struct.pack(">3f", *corner) for corner in CORNERS)
        binary += b"".join(struct.pack(f">{len(s) + 1}i", len(s), *s) for s in strips)
        for name, data in (("ascii", text.encode()), ("binary_big_endian", binary)):
            with self.subTest(name=name):
                surface = self.read_box("strips.ply", header.format(name).encode() + data)
                self.assertEqual(surface.GetNumberOfPolys(), 12)
        points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
        ids = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        corner = points[ids] - 0.5
        outward = numpy.linalg.det(corner)
        self.assertTrue((outward > 0).all() or (outward < 0).all(), outward)

    def test_arrays(self):
        properties = ["float x", "float y", "float z", "float nx", "float ny", "float nz",
                      "uchar red", "uchar green", "uchar blue", "double weight", "float s",
                      "float t"]
        text = "ply\nformat ascii 1.0\ncomment \xe9\nelement vertex 8\n"
        text += "".join(f"property {name}\n" for name in properties)
        text += ("element face 6\nproperty list uchar uint vertex_index\nproperty short part\n"
                 "element other 1\nproperty list uchar float numbers\nend_header\n")
        for i, corner in enumerate(CORNERS):
            text += "%d %d %d %g %g %g 7 8 9 %r 0.5 %d\n" % (
                *corner, *(numpy.array(corner) - 0.5), i / 7, i)
        text += "".join("4 %d %d %d %d %d\n" % (*side, i) for i, side in enumerate(SIDES))
        surface = self.read_in("arrays.ply", text.encode("latin-1") + b"2 1.5 2.5\n")
        data = surface.GetPointData()
        self.assertEqual(data.GetArray("RGB").GetTuple(3), (7, 8, 9))
        self.assertEqual(data.GetArray("weight").GetValue(3), 3 / 7)
        self.assertEqual(data.GetTCoords().GetTuple(3), (0.5, 3))
        self.assertEqual(data.GetArray("Normals").GetTuple(7), (0.5, 0.5, 0.5))
        self.assertEqual(list(vtk_to_numpy(surface.GetCellData().GetArray("part"))),
                         [0, 1, 2, 3, 4, 5])

    def test_textures_of_corners(self):
        text = ("ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
                "property double z\nproperty int tag\nelement face 2\n"
                "property list uchar int vertex_indices\nproperty list uchar float texcoord\n"
                "end_header\n0 0 0 5\n1 0 0 6\n1 1 0 7\n0 1 0 8\n"
                "3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 6 0.25 0.5 1 1 1 0\n")
        surface = self.read_in("seam.ply", text, "interpolated across")
        self.assertEqual(surface.GetNumberOfPoints(), 5)
        self.assertEqual(surface.GetPointData().GetTCoords().GetTuple(4), (0.25, 0.5))
        self.assertEqual(list(vtk_to_numpy(surface.GetPointData().GetArray("tag"))),
                         [5, 6, 7, 8, 5])
        path = self.save("wrong.ply", text.replace("3 0 2 3 6 0.25", "3 0 2 3 5").encode())
        self.fail_with(1, "do not fit the corners", path, "out2.vtp", *SMALL)


class TestOtherFormats(FilesTest):
    def test_off(self):
        points = "".join("%d %d %d\n" % corner for corner in CORNERS)
        faces = "".join("4 %d %d %d %d 200 10 10\n" % side for side in SIDES)
        for text in (f"OFF\n8 6 12\n{points}{faces}", f"OFF 8 6 0\n# comment\n\n{points}{faces}",
                     "COFF\n8 6 0\n" + points.replace("\n", " 0.5 0.5 0.5 1\n") + faces):
            self.assertEqual(self.read_box("box.off", text).GetNumberOfPoints(), 8)
        for pattern, text in (("ends too early", f"OFF\n8 7 0\n{points}{faces}"),
                              ("does not start with 'OFF'", f"4OFF\n8 6 0\n{points}{faces}"),
                              ("'8' for a corner", f"OFF\n8 1 0\n{points}3 0 1 8\n"),
                              ("fewer than three", f"OFF\n8 1 0\n{points}2 0 1\n"),
                              ("no three finite", f"OFF\n1 1 0\n0 nan 0\n3 0 0 0\n")):
            with self.subTest(pattern=pattern):
                self.fail_with(1, pattern, self.save("wrong.off", text.encode()), "out2.vtp")

    def test_off_is_written(self):
        self.succeed(self.input(), "a.off", *SMALL)
        self.succeed(self.input(), "a.obj", *SMALL)
        words = content(self.path("a.off")).split()
        self.assertEqual(words[:4], [b"OFF", b"60", b"116", b"0"])
        obj = [line.split()[1:] for line in content(self.path("a.obj")).splitlines()]
        self.assertEqual(words[4:4 + 180], sum(obj[:60], []))
        self.assertEqual(self.read_in("a.off", content(self.path("a.off"))).GetNumberOfPolys(), 116)

    MESH = ("MeshVersionFormatted 2\nDimension\n3\n# a comment\nVertices 8\n"
            + "".join("%d %d %d 0\n" % corner for corner in CORNERS)
            + "Edges 1\n1 2 7\nQuadrilaterals\n6\n"
            + "".join("%d %d %d %d %d\n" % (*(k + 1 for k in side), i)
                      for i, side in enumerate(SIDES))
            + "RequiredEdges 1\n1\nEnd\n")

    def test_mesh(self):
        """Sections in any order of lines, references, a .sol of the same name."""
        self.save("box.sol", ("MeshVersionFormatted 2 Dimension 3\nSolAtVertices 8 2 3 1\n"
                              + "11 12 22 13 23 33 5\n" * 8 + "End\n").encode())
        surface = self.read_box("box.mesh", self.MESH)
        self.assertEqual(surface.GetNumberOfPoints(), 8)
        references = surface.GetCellData().GetArray("Reference")
        self.assertEqual(sorted(vtk_to_numpy(references)), list(range(6)))
        self.assertEqual(surface.GetPointData().GetArray("Metric").GetTuple(3),
                         (11.0, 22.0, 33.0, 12.0, 23.0, 13.0))
        self.assertEqual(surface.GetPointData().GetArray("Solution1").GetTuple(7), (5.0,))
        for pattern, text in (("ends too early", self.MESH[:60]),
                              ("for its first word", "OFF\n" + self.MESH),
                              ("'9' for a corner", self.MESH.replace("\n6\n", "\n6\n9 ")),
                              ("for a coordinate", self.MESH.replace("8\n", "8\nnan ", 1))):
            with self.subTest(pattern=pattern):
                self.fail_with(1, pattern, self.save("wrong.mesh", text.encode()), "out2.vtp")
        self.save("few.sol", b"MeshVersionFormatted 2\nDimension 3\nSolAtVertices\n7\n1 1\n")
        self.fail_with(1, "not that of the mesh", self.save("few.mesh", self.MESH.encode()),
                       "out2.vtp")

    def test_mesh_is_written(self):
        self.succeed(self.input(), "a.mesh", *SMALL)
        self.succeed(self.input(), "b.obj", *SMALL)
        words = content(self.path("a.mesh")).split()
        self.assertEqual(words[:6], [b"MeshVersionFormatted", b"2", b"Dimension", b"3",
                                     b"Vertices", b"60"])
        obj = [line.split()[1:] for line in content(self.path("b.obj")).splitlines()]
        self.assertEqual(words[6:246], sum(([*point, b"0"] for point in obj[:60]), []))
        self.assertEqual(words[246:248], [b"Triangles", b"116"])
        self.assertEqual(words[248:-1], sum(([*triangle, b"0"] for triangle in obj[60:]), []))
        self.assertEqual(words[-1], b"End")
        again = self.read_in("a.mesh", content(self.path("a.mesh")))
        self.assertEqual(again.GetNumberOfPolys(), 116)

    def test_vtu(self):
        grid = vtkUnstructuredGrid()
        surface = sphere()
        grid.SetPoints(surface.GetPoints())
        grid.SetCells(VTK_TRIANGLE, surface.GetPolys())
        part = numpy_to_vtk(numpy.arange(surface.GetNumberOfPolys()), deep=True)
        part.SetName("Part")
        grid.GetCellData().AddArray(part)
        grid.GetPointData().ShallowCopy(surface.GetPointData())
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetInputData(grid)
        writer.SetDataModeToBinary()
        writer.SetFileName(self.input("sphere.vtu"))
        writer.Write()
        self.succeed(self.input("sphere.vtu"), "a.vtp", *SMALL)
        surface.GetCellData().AddArray(part)
        write(surface, self.input("part.vtp"))
        self.succeed(self.input("part.vtp"), "b.vtp", *SMALL)
        self.assertEqual(content(self.path("a.vtp")), content(self.path("b.vtp")))
        grid = vtkUnstructuredGrid()
        grid.SetPoints(surface.GetPoints())
        grid.Allocate(2)
        grid.InsertNextCell(VTK_TRIANGLE, 3, [0, 1, 2])
        grid.InsertNextCell(VTK_HEXAHEDRON, 8, list(range(8)))
        writer.SetInputData(grid)
        writer.Write()
        self.fail_with(1, "volume cells: extract their surface", self.input("sphere.vtu"), "c.vtp")

    def test_gltf(self):
        # A box whose node is moved and made twice as large.
        ids = sum(([a, b, c, a, c, d] for a, b, c, d in SIDES), [])
        data = struct.pack("<36H", *ids) + b"".join(struct.pack("<3f", *c) for c in CORNERS)
        document = {
            "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0, "translation": [5, 0, 0], "scale": [2, 2, 2]}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 1}, "indices": 0}]}],
            "accessors": [
                {"bufferView": 0, "componentType": 5123, "count": 36, "type": "SCALAR"},
                {"bufferView": 1, "componentType": 5126, "count": 8, "type": "VEC3",
                 "min": [0, 0, 0], "max": [1, 1, 1]}],
            "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 72},
                            {"buffer": 0, "byteOffset": 72, "byteLength": 96}],
            "buffers": [{"byteLength": len(data)}]}
        chunk = json.dumps(document).encode()
        chunk += b" " * (-len(chunk) % 4)
        glb = struct.pack("<4sII", b"glTF", 2, 28 + len(chunk) + len(data))
        glb += struct.pack("<I4s", len(chunk), b"JSON") + chunk
        glb += struct.pack("<I4s", len(data), b"BIN\0") + data
        document["buffers"][0]["uri"] = ("data:application/octet-stream;base64,"
                                         + base64.b64encode(data).decode())
        for name, content_of_file in (("box.glb", glb),
                                      ("box.gltf", json.dumps(document).encode())):
            with self.subTest(name=name):
                surface = self.read_in(name, content_of_file)
                self.assertEqual(surface.GetBounds(), (5, 7, 0, 2, 0, 2))
                self.assertAlmostEqual(area(read(self.path("out.vtp"))), 24, delta=1e-6)
        self.fail_with(1, "cannot read", self.save("half.glb", glb[:200]), "out2.vtp")
        self.fail_with(1, "cannot read", self.save("text.gltf", b"{}"), "out2.vtp")

    def test_gz(self):
        self.succeed(self.input(), "a.vtp", *SMALL)
        for extension in ("vtp", "vtk", "ply", "obj", "stl"):
            name = f"sphere.{extension}"
            path = self.save(name + ".gz", gzip.compress(content(self.input(name))))
            self.succeed(path, f"a.{extension}.gz", *SMALL, "--normals", "none")
            self.succeed(self.input(name), f"b.{extension}", *SMALL, "--normals", "none")
            self.assertEqual(gzip.decompress(content(self.path(f"a.{extension}.gz"))),
                             content(self.path(f"b.{extension}")))
        plain = content(self.input("sphere.ply"))
        parts = gzip.compress(plain[:500]) + gzip.compress(plain[500:]) + bytes(16)
        self.succeed(self.save("parts.ply.gz", parts), "c.ply", *SMALL, "--normals", "none")
        self.assertEqual(content(self.path("c.ply")), content(self.path("b.ply")))
        whole = gzip.compress(plain)
        for data in (whole[:-20], whole[:len(whole) // 2], whole[:40] + b"x" + whole[41:]):
            self.fail_with(1, "gzip archive is damaged|malformed",
                           self.save("damaged.ply.gz", data), "out2.vtp")


class TestPrecision(FilesTest):
    def test_map_coordinates(self):
        # In single precision, the tile's points of 0.5 m spacing would be on a grid of 0.5 m.
        points, triangles = utm_tile()
        outputs = []
        for name, text in (("ply", ply_text), ("obj", obj_text), ("stl", stl_text)):
            path = self.save("tile." + name, text(points, triangles).encode())
            self.succeed(path, "out.vtp", "-n", "500", "-a", "0.02", "-r", "r.json")
            output = load(self.path("r.json"))["output"]
            self.assertEqual(output["flipped_triangles"], 0)
            mesh = read(self.path("out.vtp"))
            outputs.append(vtk_to_numpy(mesh.GetPoints().GetData()))
        self.assertTrue((outputs[0] == outputs[1]).all())
        self.assertLess(abs(area(mesh) / 422 - 1), 0.02)
        self.succeed(self.input("tile.ply"), "out.ply", "-n", "500", "-a", "0.02")
        self.assertIn(b"property double x", content(self.path("out.ply")))
        result = self.run_program(self.input("tile.ply"), "out.stl", "-n", "500", "-a", "0.02")
        self.assertEqual(result.returncode, 0)
        self.assertRegex(result.stderr, r"single precision, in which \d+ triangles turn by more "
                         r"than 5 degrees: .vtp, .vtk, .ply, .obj and .off keep")

    def test_usual_coordinates(self):
        self.succeed(self.input(), "out.ply", *SMALL)
        self.assertIn(b"property float x", content(self.path("out.ply")))


if __name__ == "__main__":
    main()
