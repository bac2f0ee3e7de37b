"""Tests of what remesh_surface cannot do: one sentence for each, and no file left.

    TestCommandLineErrors.py --program build/bin/remesh_surface --work FOLDER [unittest options]

Surfaces are made here, with VTK.
"""
import os
import resource
import signal
import struct
import subprocess
import time
import unittest

from CommandLineTesting import FORMATS, SMALL, CommandLineTest, content, main, read, sphere, write
from vtkmodules.vtkCommonDataModel import vtkPolyData


class TestCannot(CommandLineTest):
    def test_inputs(self):
        surface = content(self.input("sphere.ply"))
        cases = [
            ("No such file", self.input("missing.ply")),
            ("is a directory", self.inputs),
            ("is empty", self.save("empty.ply", b"")),
            ("must end in .vtp, .vtk, .ply, .stl, .obj, .off, .mesh, .meshb, .vtu, .glb or .gltf",
             self.save("sphere.xyz", surface)),
            ("has no polygons", self.save("points.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\n")),
        ]
        write(vtkPolyData(), self.input("nothing.vtp"))
        cases.append(("No Points|has no polygons", self.input("nothing.vtp")))
        for pattern, path in cases:
            with self.subTest(path=path):
                self.fail_with(1, pattern, path, "out.vtp", *SMALL)

    def test_outputs(self):
        os.mkdir(self.path("folder.vtp"))
        os.mkfifo(self.path("pipe.vtp"))
        self.fail_with(1, "there is no directory 'none'", self.input(), "none/out.vtp", *SMALL)
        self.fail_with(1, "it is a directory", self.input(), "folder.vtp", *SMALL)
        self.fail_with(1, "not an ordinary file", self.input(), "pipe.vtp", *SMALL)
        for option in ("--cells", "--sites", "--edges", "--embedded-surface"):
            self.fail_with(1, "there is no directory", self.input(), "out.vtp", option, "no/f.vtp")
        for option in ("--convergence", "--report"):
            self.fail_with(1, "there is no directory", self.input(), "out.vtp", option, "no/f")

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_read_only_folder(self):
        os.mkdir(self.path("locked"), 0o555)
        self.fail_with(1, "Permission denied", self.input(), "locked/out.vtp", *SMALL)

    def test_arrays(self):
        files = [self.input(), "out.vtp"]
        self.fail_with(1, "no point array 'Foo'", *files, "--normals", "Foo")
        self.fail_with(1, "no point array 'Foo'", *files, "--embedding-array", "Foo")
        self.fail_with(1, "no point array 'Foo'", *files, "--coordinates", "Foo=2")
        self.fail_with(1, "6 components, normals have 3", *files, "--normals", "Six")
        self.fail_with(1, "no point array 'Foo'", *files, "--solution", "Height", "--solution", "Foo")
        self.fail_with(1, "cannot remesh .*", *files, "--embedding-array", "Height")
        self.fail_with(1, "eigenfunctions beside constants", *files, "--eigenfunctions", "9999")

    def test_initial_sites(self):
        files = [self.input(), "out.vtp"]
        self.fail_with(1, "No such file", *files, "--initial-sites", "missing.vtp")
        few = self.save("few.obj", b"v 0 0 0\nv 1 0 0\nf 1 2 1\n")
        self.fail_with(1, "cannot remesh .*4", *files, "--initial-sites", few)

    def test_not_finite(self):
        for value in (b"nan", b"inf", b"x", b""):
            wrong = self.save("wrong.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 %s\nf 1 2 3\n" % value)
            self.fail_with(1, "line 3", wrong, "out.vtp")
        for value in (float("nan"), float("inf")):
            surface = sphere()
            surface.GetPoints().SetPoint(7, 0.0, value, 0.0)
            for extension, pattern in (("ply", "cannot remesh .*Point 7 is not finite"),
                                       ("stl", r"line \d+ has no three finite coordinates")):
                wrong = self.input("wrong." + extension)
                write(surface, wrong)
                self.fail_with(1, pattern, wrong, "out.vtp", *SMALL)

    def test_stl(self):
        def triangle(z):
            return (f"facet normal 0 0 1\nouter loop\nvertex 0 0 {z}\nvertex 1 0 {z}\n"
                    f"vertex 0 1 {z}\nendloop\nendfacet\n")
        text = "solid x\n" + triangle(0) + "endsolid x\n"
        record = struct.pack("<12fH", 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0)

        def binary(start, announced, records):
            return start.ljust(80) + struct.pack("<I", announced) + records * record
        good = [text, text.upper(), "\n \t" + text, "solid " + 200 * "x" + text[7:],
                "solid x\n" + triangle(0) + triangle(1) + "endsolid x\n",
                binary(b"solid facet", 1, 1), binary(b"other", 2, 2)]
        for data in good:
            with self.subTest(data=data[:20], size=len(data)):
                path = self.save("good.stl", data if isinstance(data, bytes) else data.encode())
                self.succeed(path, "out.vtp", "--points", "20", "--quiet")
        wrong = [
            ("no polygons", b"solid x\nendsolid x\n"),
            ("no polygons", b" SOLID\nENDSOLID\n"),
            ("no polygons", binary(b"solid", 0, 0)),
            ("of 2 triangles", binary(b"other", 2, 1)),
            ("of 1 triangles", binary(b"solid facet", 1, 2)),
            ("line 4", text.replace("vertex 0 0 0", "vertex 0 0 z").encode()),
            ("line 7 has 'endfacet' instead of 'endloop'", text.replace("endloop\n", "").encode()),
            ("ends before its last solid", text.replace("endsolid x\n", "").encode()),
        ]
        for pattern, data in wrong:
            with self.subTest(pattern=pattern, data=data[:20]):
                self.fail_with(1, pattern, self.save("wrong.stl", data), "out.vtp", *SMALL)

    def test_empty_result_says_why(self):
        flat = self.save("flat.obj", b"v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")
        self.fail_with(1, "the result is empty: None of .* has an area", flat, "out.vtp", *SMALL)

    def test_truncated(self):
        for extension in FORMATS:
            data = content(self.input("sphere." + extension))
            for size in (len(data) // 2, 30, 3):
                with self.subTest(extension=extension, size=size):
                    path = self.save("truncated." + extension, data[:size])
                    self.fail_with(1, "truncated", path, "out.vtp", *SMALL)

    def test_not_a_surface(self):
        for extension in FORMATS:
            for data in (bytes((37 * i * i + 11 * i) % 256 for i in range(2000)),
                         b"this is\nno surface\n" * 20, b"\0" * 500):
                with self.subTest(extension=extension, data=data[:10]):
                    path = self.save("garbage." + extension, data)
                    self.fail_with(1, "garbage", path, "out.vtp", *SMALL)

    def test_malformed_ply(self):
        def ascii_ply(vertices, faces, counts="3 1", extra=""):
            vertex, face = counts.split()
            return (f"ply\nformat ascii 1.0\nelement vertex {vertex}\nproperty float x\n"
                    f"property float y\nproperty float z\n{extra}element face {face}\n"
                    f"property list uchar int vertex_indices\nend_header\n{vertices}{faces}"
                    ).encode()
        corners = "0 0 0\n1 0 0\n0 1 0\n"
        cases = [
            ("refers to point 3", ascii_ply(corners, "3 0 1 3\n")),
            ("refers to point -1", ascii_ply(corners, "3 0 1 -1\n")),
            ("too few numbers", ascii_ply(corners, "3 0 1\n")),
            ("too few numbers", ascii_ply("0 0 0\n1 0\n0 1 0\n", "3 0 1 2\n")),
            ("ends in its body", ascii_ply(corners, "", "3 2")),
            ("no valid count", ascii_ply(corners, "3 0 1 2\n", "-3 1")),
            ("no valid count", ascii_ply(corners, "3 0 1 2\n", "3 99999999999")),
            ("too long or too short", ascii_ply(corners, "-1\n")),
            ("unknown type", ascii_ply(corners, "3 0 1 2\n", extra="property quad w\n")),
            ("fewer than three corners", ascii_ply(corners, "2 0 1\n")),
            ("line 3 of its body has 'x'", ascii_ply("0 0 0\n1 0 0\n0 1 x\n", "3 0 1 2\n")),
            ("no format", b"ply\nelement vertex 0\nend_header\n"),
        ]
        for pattern, data in cases:
            with self.subTest(pattern=pattern):
                path = self.save("malformed.ply", data)
                self.fail_with(1, pattern, path, "out.vtp", *SMALL)

    def test_point_ids_out_of_range(self):
        for name, data in (
                ("far.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 900000000\n"),
                ("far.vtk", b"# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\n"
                            b"POINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 7\n")):
            with self.subTest(name=name):
                self.fail_with(1, "cannot read", self.save(name, data), "out.vtp", *SMALL)

    def test_full_disk(self):
        def limit():
            # As a full disk: writing beyond this size fails.
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000))
        for extension in FORMATS + ("PLY",):
            # VTK's own writer does not tell why.
            reason = "" if extension == "vtk" else "File too large"
            with self.subTest(extension=extension):
                self.fail_with(1, "cannot write.*" + reason, self.input(), "out." + extension,
                               "--report", "r.json", *SMALL, preexec_fn=limit)

    def test_failure_keeps_older_files(self):
        with open(self.path("out.vtp"), "w", encoding="utf-8") as file:
            file.write("older")
        self.fail_with(1, "no polygons", self.save("points.obj", b"v 0 0 0\n"), "out.vtp")
        self.assertEqual(content(self.path("out.vtp")), b"older")

    def test_failure_while_renaming_keeps_older_files(self):
        # A folder takes the place of an output during the run: when all is written, and the first
        # file has its name.
        older = {"out.vtp": b"older", "s.vtp": b"older sites"}
        for name, data in older.items():
            with open(self.path(name), "wb") as file:
                file.write(data)
        os.mkfifo(self.path("in.vtp"))
        with subprocess.Popen(
                [self.program, "in.vtp", "out.vtp", *SMALL, "--sites", "s.vtp", "--cells", "c.vtp",
                 "--edges", "e.vtp", "--report", "r.json"], cwd=self.folder,
                stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8") as process:
            with open(self.path("in.vtp"), "wb") as pipe:  # opened when the program reads
                os.mkdir(self.path("e.vtp"))
                pipe.write(content(self.input()))
            output, error = process.communicate(timeout=60)
        self.assertEqual((process.returncode, output), (1, ""))
        self.assertRegex(error, r"\Aremesh_surface: cannot write 'e.vtp': [^\n]+\n\Z")
        self.assertEqual(sorted(os.listdir(self.folder)), ["e.vtp", "in.vtp", "out.vtp", "s.vtp"])
        for name, data in older.items():
            self.assertEqual(content(self.path(name)), data)

    def test_older_files_are_replaced(self):
        for name in ("out.vtp", "r.json"):
            with open(self.path(name), "wb") as file:
                file.write(b"older")
        self.succeed(self.input(), "out.vtp", *SMALL, "--report", "r.json")
        self.assertEqual(sorted(os.listdir(self.folder)), ["out.vtp", "r.json"])
        self.assertEqual(read(self.path("out.vtp")).GetNumberOfPoints(), 60)

    def test_interruption(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with subprocess.Popen(
                    [self.program, self.input(), "out.vtp", "--points", "2000", "--lloyd", "100000",
                     "--cells", "cells.vtp"], cwd=self.folder, stdout=subprocess.PIPE,
                    stderr=subprocess.PIPE, encoding="utf-8") as process:
                time.sleep(1.5)
                self.assertIsNone(process.poll())
                process.send_signal(number)
                output, error = process.communicate(timeout=60)
            self.assertEqual((process.returncode, output, error),
                             (-number, "", "remesh_surface: interrupted\n"))
            self.assertEqual(os.listdir(self.folder), [])


if __name__ == "__main__":
    main()
