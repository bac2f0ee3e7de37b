"""Tests of remesh_surface: options, errors, formats, report, determinism.

    TestCommandLine.py --program build/bin/remesh_surface --work FOLDER [unittest options]

Every failure must give one sentence and leave no file. Surfaces are made here, with VTK.
"""
import argparse
import json
import os
import pty
import re
import resource
import shutil
import signal
import struct
import subprocess
import sys
import time
import unittest

from CommandLineTesting import FORMATS, SMALL, CommandLineTest, content, read, sphere, write
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

MAN_PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                        "..", "..", "Examples", "Cxx", "remesh_surface.1")


class TestUsage(CommandLineTest):
    def test_wrong_options(self):
        files = [self.input(), "out.vtp"]
        cases = [
            ("needs an input file and an output file", []),
            ("needs an input file and an output file", files[:1]),
            ("too much", files + ["third"]),
            ("unknown option '--foo'", files + ["--foo"]),
            ("unknown option '-q'", files + ["-q"]),
            ("unknown option '--point'", files + ["--point", "5"]),
            ("--points needs a value", files + ["--points"]),
            ("--points needs a value", files + ["--points", "--quiet"]),
            ("--quiet takes no value", files + ["--quiet=yes"]),
            ("--cells needs a value that is not empty", files + ["--cells="]),
        ]
        for name in ("--points", "--lloyd", "--seed", "--threads", "--normal-smoothing"):
            for value in ("many", "1.5", "", " 7", "7x", "99999999999999999999"):
                cases.append((f"{name} (needs an integer|must be from)",
                              files + [f"{name}={value}"]))
        for name in ("--anisotropy", "--merge-tolerance"):
            for value in ("some", "", "nan", "inf", "-0.1", "1.5", "0.1x"):
                cases.append((f"{name} (needs a number|must be from)", files + [f"{name}={value}"]))
        for name, value in (("--lloyd", "-1"), ("--lloyd", "100001"), ("--threads", "-1"),
                            ("--threads", "1025"), ("--normal-smoothing", "-2"),
                            ("--normal-smoothing", "10001"), ("--seed", "2147483648")):
            cases.append((f"{name} must be from", files + [name, value]))
        for name in ("--backend", "--dimension", "--sampling"):
            cases.append((f"{name} must be one of", files + [name, "other"]))
        for value in ("Height", "=2", "Height=", "Height=x", "Height=inf"):
            cases.append(("--coordinates needs", files + ["--coordinates", value]))
        for pattern, arguments in cases:
            with self.subTest(arguments=arguments):
                self.fail_with(2, pattern, *arguments)

    def test_two_outputs_of_one_name(self):
        os.symlink(".", self.path("here"))
        self.fail_with(2, "two outputs", self.input(), "out.vtp", "--cells", "here/out.vtp")

    def test_inputs_are_kept(self):
        before = content(self.input())
        os.symlink(self.input(), self.path("link.vtp"))
        self.fail_with(2, "is an input", self.input(), "link.vtp")
        self.fail_with(2, "is an input", self.input(), "out.vtp", "--report", self.input())
        write(sphere(), self.path("sites.vtp"))
        self.fail_with(2, "is an input", self.input(), "out.vtp", "--initial-sites", "sites.vtp",
                       "--sites", "sites.vtp")
        self.assertEqual(content(self.input()), before)

    def test_help_and_manual_page(self):
        result = self.run_program("--help")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(self.run_program("-h").stdout, result.stdout)
        in_help = re.findall(r"^  (--[a-z-]+)(?: (\S+))?", result.stdout, re.MULTILINE)
        with open(MAN_PAGE, encoding="utf-8") as file:
            manual = file.read()
        in_manual = re.findall(r'^\.BI? (\\-\\-[a-z\\-]+)(?: "? ?([^"\n]+)"?)?$', manual,
                               re.MULTILINE)
        in_manual = [(name.replace("\\", ""), value) for name, value in in_manual]
        self.assertGreater(len(in_help), 20)
        self.assertEqual(sorted(in_help), sorted(in_manual))
        self.assertLessEqual(max(map(len, result.stdout.splitlines())), 100)
        # Defaults are the same, too.
        for name in ("points", "lloyd", "anisotropy", "normal\\-smoothing"):
            plain = name.replace("\\", "")
            default = re.search(rf"--{plain} .*?Default\s+(-?[\d.]*\d)", result.stdout, re.DOTALL)
            section = re.search(rf"^\.BI \\-\\-{re.escape(name)} .*?Default (\\?-?[\d.]*\d)",
                                manual, re.DOTALL | re.MULTILINE)
            self.assertEqual(default[1], section[1].replace("\\", ""), name)

    def test_version(self):
        result = self.run_program("--version")
        self.assertEqual(result.returncode, 0)
        self.assertRegex(result.stdout, r"\Aremesh_surface \d+\.\d+\.\d+ \(VTK \d+\.\d+.*\)\n\Z")

    def test_two_ways_to_give_a_value(self):
        self.succeed(self.input(), "a.vtp", *SMALL, "--seed", "-3", "--backend", "STDThread")
        self.succeed("--points=60", "--lloyd=2", "--seed=-3", "--backend=stdthread", "--",
                     self.input(), "b.vtp")
        self.assertEqual(content(self.path("a.vtp")), content(self.path("b.vtp")))


class TestCannot(CommandLineTest):
    def test_inputs(self):
        surface = content(self.input("sphere.ply"))
        cases = [
            ("No such file", self.input("missing.ply")),
            ("is a directory", self.inputs),
            ("is empty", self.save("empty.ply", b"")),
            ("must end in .vtp, .vtk, .ply, .stl or .obj", self.save("sphere.xyz", surface)),
            ("has no polygons", self.save("points.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\n")),
        ]
        write(vtkPolyData(), self.input("nothing.vtp"))
        cases.append(("No Points|has no polygons", self.input("nothing.vtp")))
        for pattern, path in cases:
            with self.subTest(path=path):
                self.fail_with(1, pattern, path, "out.vtp", *SMALL)

    def test_points(self):
        for count in ("3", "0", "-5"):
            self.fail_with(1, "at least 4 points", self.input(), "out.vtp", "--points", count)

    def test_outputs(self):
        os.mkdir(self.path("folder.vtp"))
        os.mkfifo(self.path("pipe.vtp"))
        self.fail_with(1, "must end in", self.input(), "out.xyz", *SMALL)
        self.fail_with(1, "must end in .vtp or .vtk", self.input(), "out.vtp", "--cells", "c.ply")
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
        self.fail_with(1, "cannot remesh .*", *files, "--embedding-array", "Height")

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
            for extension, point in (("ply", "7"), ("stl", r"\d+")):
                wrong = self.input("wrong." + extension)
                write(surface, wrong)
                self.fail_with(1, f"cannot remesh .*Point {point} is not finite", wrong, "out.vtp",
                               *SMALL)

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
            ("vertex has a list", ascii_ply(corners, "3 0 1 2\n",
                                            extra="property list int int w\n")),
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
            with self.subTest(extension=extension):
                self.fail_with(1, "cannot write", self.input(), "out." + extension,
                               "--report", "r.json", *SMALL, preexec_fn=limit)

    def test_failure_keeps_older_files(self):
        with open(self.path("out.vtp"), "w", encoding="utf-8") as file:
            file.write("older")
        self.fail_with(1, "no polygons", self.save("points.obj", b"v 0 0 0\n"), "out.vtp")
        self.assertEqual(content(self.path("out.vtp")), b"older")

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
                             (1, "", "remesh_surface: interrupted\n"))
            self.assertEqual(os.listdir(self.folder), [])


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

    def test_ply_precision(self):
        single = struct.unpack("f", struct.pack("f", 0.1))[0]
        for kind, expected in (("double", 0.1), ("float", single)):
            properties = "".join(f"property {kind} {axis}\n" for axis in "xyz")
            header = (f"element vertex 4\n{properties}element face 4\n"
                      "property list uchar int vertex_indices\nend_header\n")
            points = [(0.1, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
            faces = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
            text = "".join("%r %r %r\n" % point for point in points)
            text += "".join("3 %d %d %d\n" % face for face in faces)
            binary = b"".join(struct.pack(f">3{kind[0]}", *point) for point in points)
            binary += b"".join(struct.pack(">B3i", 3, *face) for face in faces)
            for name, data in (("ascii", text.encode()), ("binary_big_endian", binary)):
                with self.subTest(kind=kind, name=name):
                    path = self.save("tetrahedron.ply",
                                     f"ply\nformat {name} 1.0\n{header}".encode() + data)
                    self.succeed(path, "out.vtp", *SMALL, "--embedded-surface", "x.vtp")
                    self.assertEqual(read(self.path("x.vtp")).GetPoint(0)[0], expected)

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
        self.assertEqual(lines[0], "Iteration,Energy,GradientNorm,StepLength,Time")
        with open(self.path("r.json"), encoding="utf-8") as file:
            report = json.load(file)
        self.assertEqual(len(lines), report["iterations"] + 2)
        self.assertEqual(float(lines[-1].split(",")[1]), report["energy"])

    def test_report(self):
        name = 'odd "name" \\ \u00e9\n.vtp'
        shutil.copy(self.input(), self.path(name))
        self.succeed(name, "out.vtp", *SMALL, "--report", "r.json", "--anisotropy", "0.1",
                     "--coordinates", "Height=0.5", "--coordinates", "Six=2", "--threads", "1")
        with open(self.path("r.json"), encoding="utf-8") as file:
            report = json.load(file)
        self.assertLessEqual(
            {"input", "parameters", "output", "iterations", "evaluations", "energy", "seconds",
             "processor_seconds", "peak_megabytes", "threads", "backend", "warnings"},
            set(report))
        surface = sphere()
        self.assertEqual(report["input"], {
            "file": name, "points": surface.GetNumberOfPoints(),
            "cells": surface.GetNumberOfCells(), "components": 1, "dropped": 0})
        self.assertEqual(report["output"], {"points": 60, "triangles": 116, "extra_points": 0})
        self.assertEqual(report["parameters"]["anisotropy"], 0.1)
        self.assertEqual(report["parameters"]["coordinates"],
                         [{"name": "Height", "scale": 0.5}, {"name": "Six", "scale": 2}])
        seconds = report["seconds"]
        self.assertLessEqual({"read", "intake", "sampling", "lloyd", "newton", "repair", "diagram",
                              "write", "total"}, set(seconds))
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

    def test_embedding_array(self):
        self.succeed(self.input(), "out.vtp", *SMALL, "--embedding-array", "Six",
                     "--embedded-surface", "x.vtp")
        data = read(self.path("x.vtp")).GetPointData()
        self.assertTrue((vtk_to_numpy(data.GetArray("Embedding")) ==
                         vtk_to_numpy(data.GetArray("Six"))).all())

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

    def test_replaces_and_follows_links(self):
        os.mkdir(self.path("there"))
        with open(self.path("there/out.vtp"), "w", encoding="utf-8") as file:
            file.write("older")
        os.symlink("there/out.vtp", self.path("link.vtp"))
        self.succeed(self.input(), "link.vtp", *SMALL)
        self.assertTrue(os.path.islink(self.path("link.vtp")))
        self.assertEqual(read(self.path("there/out.vtp")).GetNumberOfPoints(), 60)
        self.assertEqual(os.listdir(self.path("there")), ["out.vtp"])

    def test_progress_bar(self):
        def on_terminal(*options):
            try:
                ours, theirs = pty.openpty()
            except OSError as error:
                self.skipTest(str(error))
            result = subprocess.run([self.program, self.input(), "out.vtp", "--points", "2000",
                                     "--lloyd", "60", *options], cwd=self.folder, stderr=theirs,
                                    stdout=theirs, timeout=300, check=False)
            os.write(theirs, b"END")
            text = b""
            while not text.endswith(b"END"):
                text += os.read(ours, 65536)
            os.close(ours)
            os.close(theirs)
            self.assertEqual(result.returncode, 0)
            return text[:-3].decode()
        self.assertRegex(on_terminal(), r"\A(\r\[#*\.*\] +\d+ % [^\r\n]*\x1b\[K)+\r\x1b\[K\Z")
        self.assertEqual(on_terminal("--quiet"), "")


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    parser.add_argument("--work", required=True)
    known, rest = parser.parse_known_args()
    CommandLineTest.program = os.path.abspath(known.program)
    CommandLineTest.work = os.path.abspath(known.work)
    os.makedirs(CommandLineTest.work, exist_ok=True)
    unittest.main(argv=sys.argv[:1] + rest, verbosity=2)
