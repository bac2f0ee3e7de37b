"""Tests of the table of verdicts: what is worse than what, and a tiny run.

    TestVerdicts.py --program build/bin/remesh_surface --work FOLDER [unittest options]
"""
import contextlib
import io
import os
import sys
from unittest import mock

from CommandLineTesting import CommandLineTest, content, main

BENCHMARKS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Benchmarks")
sys.path.insert(0, BENCHMARKS)
import verdict_surfaces  # noqa: E402 pylint: disable=wrong-import-position
import verdicts  # noqa: E402 pylint: disable=wrong-import-position

RIGHT = {"surface": "cone", "n": "500", "s": "0.04", "outcome": "done", "off": "0",
         "topology": "proven", "faults": "0", "inverted": "0", "strays": "0", "crossings": "0",
         "rms": "0.01", "largest": "0.1", "bytes": "0123456789ab", "seconds": "1.5",
         "warnings": "-"}
WORSE = {"outcome": "error", "off": "-3", "topology": "lost", "faults": "2", "inverted": "1",
         "strays": "4", "crossings": "1", "rms": "0.0103", "largest": "0.2"}


class TestVerdicts(CommandLineTest):
    """The script, called as a module."""
    def table(self, name, *rows, build="build"):
        path = self.path(name)
        verdicts.save(path, build, {verdicts.key_of(row): row for row in rows})
        return path

    def call(self, *words):
        """Exit status, what is printed, and what is said on standard error."""
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            status = verdicts.main([str(word) for word in words])
        return status, out.getvalue(), err.getvalue()

    def test_order(self):
        names = list(WORSE)
        self.assertEqual(list(verdicts.RECORD), names)
        for place, name in enumerate(names):
            first = {**RIGHT, name: WORSE[name]}
            later = {**RIGHT, **{other: WORSE[other] for other in names[place + 1:]}}
            with self.subTest(name=name):
                self.assertEqual(verdicts.compare_rows(RIGHT, first), (1, name))
                self.assertEqual(verdicts.compare_rows(later, first), (1, name))
                self.assertEqual(verdicts.compare_rows(first, later), (-1, name))
                self.assertEqual(verdicts.compare_rows(first, first), (0, None))

    def test_entries(self):
        def compare(**entries):
            """From the first of two values to the second."""
            pair = [{**RIGHT, **{name: texts[k] for name, texts in entries.items()}}
                    for k in (0, 1)]
            return verdicts.compare_rows(*pair)[0]
        self.assertEqual(compare(off=("3", "-3")), 0)
        self.assertEqual(compare(off=("-3", "4")), 1)
        self.assertEqual(compare(rms=("0.0101", "0.0103")), 0)  # within two percent
        self.assertEqual(compare(rms=("0.0103", "0.0101"), largest=("0.1", "0.103")), 1)
        self.assertEqual(compare(rms=("0", "1e-5")), 1)
        self.assertEqual(compare(crossings=("-", "5")), 0)  # not reported before
        self.assertEqual(compare(outcome=("timeout", "error")), -1)
        self.assertEqual(compare(topology=("none", "lost")), 1)
        self.assertEqual(compare(bytes=("01", "02"), warnings=("-", "The mesh")), 0)

    def test_compare(self):
        others = [{**RIGHT, "surface": name} for name in ("a", "b", "c")]
        before = self.table("before.txt", *others, RIGHT)
        after = self.table("after.txt", {**others[0], "rms": "0.02"},
                           {**others[1], "inverted": "2", "bytes": "ba9876543210"},
                           {**others[2], "rms": "0.005", "warnings": "The mesh is"})
        status, out, _ = self.call("compare", before, after)
        self.assertEqual(status, 1)
        self.assertIn("1 better, 0 same, 2 worse; 1 with other bytes, 1 with other warnings", out)
        self.assertIn("ratios: 1.0000", out)
        self.assertIn("WORSE: a 500 0.04: rms 0.01 -> 0.02", out)
        self.assertIn("better: c 500 0.04: rms 0.01 -> 0.005", out)
        self.assertIn("not compared: 1 rows that are in " + before, out)
        self.assertEqual(out.count("\n+ "), 2)
        self.assertEqual(self.call("compare", before, before)[0], 0)

    def test_unusable(self):
        table = self.table("table.txt", RIGHT)
        other = self.table("other.txt", {**RIGHT, "n": "501"})
        self.assertEqual(self.call("compare", table, other)[0], 2)
        self.assertEqual(self.call("compare", table, self.path("none.txt"))[0], 2)
        text = content(table).decode()
        for wrong in ("", "no table\n", text.replace("off", "of"), text.replace("proven", "x"),
                      text.replace("      rms    largest", "  largest        rms")):
            with open(other, "w", encoding="utf-8") as file:
                file.write(wrong)
            self.assertEqual(self.call("compare", table, other)[0], 2, wrong)

    def test_verdict(self):
        sentence = ("The cells are not proven to have the surface's topology: 3 cells are no "
                    "disks, 1 pair of cells meets not in one segment. The mesh has, against the "
                    "surface: 2 handles more, Euler characteristic 3 for 2.")
        report = {"output": {"extra_points": -4, "flipped_triangles": 5, "stray_triangles": 6,
                             "rms_distance": 0.0123456, "maximum_distance": 1e-9},
                  "topology": {"preserved": 0, "report": sentence},
                  "warnings": ["5 triangles face the surface the wrong way.", sentence]}
        self.assertEqual(verdicts.verdict_of(report, 1.0), {
            "outcome": "done", "off": "-4", "topology": "lost", "faults": "6", "inverted": "5",
            "strays": "6", "crossings": "-", "rms": "0.0123", "largest": "0",
            "warnings": "N triangles face the surface; The cells are not proven"})
        report["topology"]["report"] = "The surface is no manifold, at 6 edges, 2 points."
        verdict = verdicts.verdict_of(report, 1.0)
        self.assertEqual((verdict["topology"], verdict["faults"]), ("none", "0"))

    def test_run(self):
        def command(table):
            return ("run", self.program, table, "--only", "bico*", "--points", 60,
                    "--anisotropy", "0", "0.1")

        def interrupted(*words):
            if os.path.exists(table):  # which the first row makes
                raise KeyboardInterrupt
            return one_case(*words)

        table, again, one_case = self.path("table.txt"), self.path("again.txt"), verdicts.run_case
        with mock.patch("verdicts.run_case", side_effect=interrupted):
            status, _, err = self.call(*command(table))
        self.assertEqual(status, 1)
        self.assertIn("interrupted: 1 rows", err)
        partial = content(table)
        for name in (table, again):
            self.assertEqual(self.call(*command(name)),
                             (0, f"{name}: 2 rows, 0 of them not right\n", ""))
        self.assertEqual(content(table).splitlines()[:3], partial.splitlines())
        self.assertEqual(content(table), content(again))
        with mock.patch("verdicts.run_case", side_effect=AssertionError):
            self.assertEqual(self.call(*command(table))[0], 0)  # nothing is run twice
        self.table("other.txt", *verdicts.load(table)[1].values())
        status, _, err = self.call(*command(self.path("other.txt")))
        self.assertEqual(status, 2)
        self.assertIn("of another build", err)

    def test_data(self):
        folder = self.path("data")
        os.mkdir(folder)
        for name, data in (("bad.ply", b"ply\n"), ("notes.txt", b""),
                           ("good one.ply", content(self.input("sphere.ply")))):
            with open(os.path.join(folder, name), "wb") as file:
                file.write(data)
        table = self.path("table.txt")
        status, out, _ = self.call("run", self.program, table, "--data", folder, "--no-generated",
                                   "--points", 60, "--anisotropy", 0)
        self.assertEqual((status, out), (0, f"{table}: 2 rows, 1 of them not right\n"))
        _, rows = verdicts.load(table)
        self.assertEqual([(key[0], row["outcome"]) for key, row in rows.items()],
                         [("bad.ply", "error"), ("good_one.ply", "done")])
        self.assertIn("bad.ply 60 0: error (cannot read", self.call("wrong", table)[1])
        self.assertEqual(self.call("run", self.program, self.path("x"), "--only", "none")[0], 2)
        self.assertEqual(self.call("run", self.path("none"), self.path("x"))[0], 2)

    def test_pinned(self):
        _, rows = verdicts.load(os.path.join(BENCHMARKS, "verdicts.txt"))
        wanted = {(name, int(n), float(s)) for name in verdict_surfaces.SURFACES
                  for n in verdicts.POINTS for s in verdicts.ANISOTROPY}
        self.assertEqual(set(rows), wanted)


if __name__ == "__main__":
    main()
