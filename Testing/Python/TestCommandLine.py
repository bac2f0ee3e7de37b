"""Tests of remesh_surface: options, help and manual page.

    TestCommandLine.py --program build/bin/remesh_surface --work FOLDER [unittest options]

Surfaces are made here, with VTK.
"""
import os
import re

from CommandLineTesting import SMALL, CommandLineTest, content, load, main, sphere, write

MAN_PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                        "..", "..", "Examples", "Cxx", "remesh_surface.1")


class TestUsage(CommandLineTest):
    def test_wrong_options(self):
        files = [self.input(), "out.vtp"]
        cases = [
            ("needs an input file and an output file", []),
            ("needs an input file and an output file", files[:1]),
            ("'third.vtp' is too much", files + ["third.vtp"]),
            ("'out.xyz' must end in .vtp, .*or .meshb", files[:1] + ["out.xyz"]),
            ("'c.ply' must end in .vtp or .vtk", files + ["--cells", "c.ply"]),
            ("unknown option '--foo' \\(see", files + ["--foo"]),
            ("unknown option '-x'", files + ["-x"]),
            ("unknown option '--point'; did you mean --points\\?", files + ["--point", "5"]),
            ("unknown option '--pionts'; did you mean --points\\?", files + ["--pionts=5"]),
            ("unknown option '--no-feature'; did you mean --no-features",
             files + ["--no-feature"]),
            ("unknown option '--anis'; did you mean --anisotropy", files + ["--anis", "0"]),
            ("at least 4 points, not 3", files + ["--points", "3"]),
            ("at least 4 points, not -5", files + ["-n", "-5"]),
            ("--points needs a value", files + ["--points"]),
            ("--points needs a value", files + ["--points", "--quiet"]),
            ("--quiet takes no value", files + ["--quiet=yes"]),
            ("--tolerance must be 0 or at least 1e-7", files + ["--tolerance", "1e-9"]),
            ("--cells needs a value that is not empty", files + ["--cells="]),
            ("all replace position and normal: choose one",
             files + ["--metric", "Six", "--solution", "Height"]),
            ("all replace position and normal: choose one",
             files + ["--eigenfunctions", "9", "--embedding-array", "Six"]),
            ("--eigenfunctions must be from 2 to 100000", files + ["--eigenfunctions", "1"]),
        ]
        for name in ("--points", "--lloyd", "--seed", "--threads", "--normal-smoothing"):
            for value in ("many", "1.5", "", " 7", "7x", "99999999999999999999"):
                cases.append((f"{name} (needs an integer|needs a value|must be from)",
                              files + [f"{name}={value}"]))
        for name in ("--anisotropy", "--merge-tolerance", "--tolerance"):
            for value in ("some", "", "nan", "inf", "-0.1", "1.5", "0.1x"):
                cases.append((f"{name} (needs a number|needs a value|must be from)", files + [f"{name}={value}"]))
        for name, value in (("--lloyd", "-1"), ("--lloyd", "100001"), ("--threads", "-1"),
                            ("--threads", "1025"), ("--normal-smoothing", "-2"),
                            ("--normal-smoothing", "10001"), ("--seed", "2147483648")):
            cases.append((f"{name} must be from", files + [name, value]))
        for name in ("--backend", "--dimension", "--error-norm", "--sampling", "--placement", "--format",
                     "--completion"):
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
        in_help = re.findall(r"^  (?:    |-(\w), )(--[a-z-]+)(?: (\S+))?", result.stdout,
                             re.MULTILINE)
        with open(MAN_PAGE, encoding="utf-8") as file:
            manual = file.read()
        in_manual = re.findall(
            r'^\.BI? "?(?:\\-(\w), )?(\\-\\-[a-z\\-]+)"?(?: " ([^"\n]+)")?$', manual, re.MULTILINE)
        in_manual = [(letter, name.replace("\\", ""), value) for letter, name, value in in_manual]
        self.assertGreater(len(in_help), 20)
        self.assertEqual(sorted(in_help), sorted(in_manual))
        self.assertLessEqual(max(map(len, result.stdout.splitlines())), 100)

    def test_defaults(self):
        # Help and man page tell those that the program has, each among what it says of its option.
        text = self.run_program("--help").stdout
        in_help = re.split(r"^  (?:    |-\w, )--", text, flags=re.MULTILINE)
        with open(MAN_PAGE, encoding="utf-8") as file:
            manual = file.read().replace("\\-", "-")
        in_manual = re.split(r'^\.BI? "?(?:-\w, )?--', manual, flags=re.MULTILINE)
        self.succeed(self.input(), "s.vtp", *SMALL)
        self.succeed(self.input(), "out.vtp", "--initial-sites", "s.vtp", "--report", "r.json")
        used = load(self.path("r.json"))["parameters"]
        for name in ("points", "tolerance", "max-points", "anisotropy", "feature-angle",
                     "max-extra-points", "lloyd", "newton", "energy-tolerance", "seed",
                     "sampling", "threads", "backend", "normal-smoothing", "merge-tolerance",
                     "placement", "error-norm", "min-size", "max-size", "eigenfunction-scaling",
                     "diffusion-time"):
            with self.subTest(name=name):
                value = used[name.replace("-", "_")]
                expected = f"{value:g}" if isinstance(value, float) else str(value)
                for text in (in_help, in_manual):
                    section, = (part for part in text if re.match(rf'{name}"?\s', part))
                    found = re.findall(r"Default\s+(-?[\d.]*\d(?:e-\d+)?)|(\w+)\s+\(default\)", section)
                    self.assertEqual(["".join(pair) for pair in found], [expected])

    def test_version(self):
        result = self.run_program("--version")
        self.assertEqual(result.returncode, 0)
        self.assertRegex(result.stdout, r"\Aremesh_surface \d+\.\d+\.\d+ \(VTK \d+\.\d+.*\)\n\Z")

    def test_two_ways_to_give_a_value(self):
        self.succeed(self.input(), "a.vtp", *SMALL, "--seed", "-3", "--backend", "STDThread")
        self.succeed("--points=60", "--lloyd=2", "--seed=-3", "--backend=stdthread", "--",
                     self.input(), "b.vtp")
        self.succeed("-n60", "-q", "-j1", self.input(), "c.vtp", "--lloyd", "9", "--lloyd", "2",
                     "--seed=-3")
        for name in ("b.vtp", "c.vtp"):
            self.assertEqual(content(self.path("a.vtp")), content(self.path(name)))


if __name__ == "__main__":
    main()
