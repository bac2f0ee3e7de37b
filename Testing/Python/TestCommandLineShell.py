"""Tests of remesh_surface at home in a shell: several files, pipes, terminals.

    TestCommandLineShell.py --program build/bin/remesh_surface --work FOLDER [unittest options]
"""
import json
import os
import pty
import re
import select
import shutil
import signal
import subprocess
import time

from CommandLineTesting import (LAST_LINE, SMALL, CommandLineTest, content, load, main, read,
                                sphere, write)


class TestSeveralFiles(CommandLineTest):
    def setUp(self):
        super().setUp()
        for name in ("a.ply", "b.vtp"):
            shutil.copy(self.input("sphere." + name[-3:]), self.path(name))

    def test_folder(self):
        os.mkdir(self.path("meshes"))
        result = self.run_program("a.ply", "b.vtp", "meshes", *SMALL)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        lines = result.stdout.splitlines(True)
        self.assertEqual([line.split(":")[0] for line in lines], ["meshes/a.ply", "meshes/b.vtp"])
        for line in lines:
            self.assertRegex(line, LAST_LINE)
        self.succeed("a.ply", "meshes/", *SMALL, "-f", "OBJ", "--report", "{stem}-{points}.json")
        self.assertEqual(sorted(os.listdir(self.path("meshes"))), ["a.obj", "a.ply", "b.vtp"])
        self.assertEqual(load(self.path("a-60.json"))["input"]["file"], "a.ply")
        self.fail_with(1, "there is no directory 'none'", "a.ply", "none/", *SMALL)
        os.mkdir(self.path("folder.vtp"))
        self.succeed("a.ply", "folder.vtp/", *SMALL)

    def test_pattern(self):
        result = self.run_program("a.ply", "b.vtp", "-o", "{stem}-{points}-{anisotropy}.obj.gz",
                                  "-a", "0.05", "--sites", "s-{stem}.vtp", *SMALL)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(sorted(os.listdir(self.folder)),
                         ["a-60-0.05.obj.gz", "a.ply", "b-60-0.05.obj.gz", "b.vtp", "s-a.vtp",
                          "s-b.vtp"])

    def test_wrong_usage(self):
        for pattern, arguments in (
                ("braces around something else", ["a.ply", "-o", "{name}.vtp"]),
                ("braces around something else", ["a.ply", "-o", "{stem.vtp"]),
                ("must end in", ["a.ply", "-o", "{stem}.xyz"]),
                ("written to 'c.vtp': put {stem}", ["a.ply", "b.vtp", "-o", "c.vtp"]),
                ("written to 'r.json'", ["a.ply", "b.vtp", "-o", "{stem}2.vtp", "-r", "r.json"]),
                ("is too much, or no folder", ["a.ply", "b.vtp", "c.vtp"]),
                ("is an input", ["a.ply", "b.vtp", "./", *SMALL]),
                ("read only once", ["-", "-", "-o", "{stem}.vtp", "--initial-sites", "-"])):
            with self.subTest(arguments=arguments):
                before = sorted(os.listdir(self.folder))
                result = self.run_program(*arguments)
                self.assertEqual(result.returncode, 2)
                self.assertRegex(result.stderr, pattern)
                self.assertEqual(sorted(os.listdir(self.folder)), before)

    def test_one_fails(self):
        result = self.run_program("missing.ply", "b.vtp", "-o", "{stem}2.vtp", *SMALL)
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, r"\Aremesh_surface: cannot read 'missing.ply': [^\n]+\n\Z")
        self.assertRegex(result.stdout, LAST_LINE)
        self.assertTrue(os.path.exists(self.path("b2.vtp")))

    def test_json_lines(self):
        result = self.run_program("a.ply", "b.vtp", "-o", "{stem}2.vtp", "--json", *SMALL)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        files = [json.loads(line)["input"]["file"] for line in result.stdout.splitlines()]
        self.assertEqual(files, ["a.ply", "b.vtp"])


class TestStreams(CommandLineTest):
    def pipe(self, data, *arguments):
        result = subprocess.run([self.program, *arguments], cwd=self.folder, input=data,
                                capture_output=True, timeout=300, check=False)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        return result.stdout

    def test_standard_input_and_output(self):
        for extension in ("ply", "vtp", "vtk", "stl", "obj"):
            with self.subTest(extension=extension):
                path = self.input("sphere." + extension)
                self.succeed(path, "out." + extension, *SMALL)
                expected = content(self.path("out." + extension))
                os.remove(self.path("out." + extension))
                self.assertEqual(self.pipe(content(path), "-", "-", *SMALL), expected)
                self.assertEqual(os.listdir(self.folder), [])
        text = self.pipe(content(self.input("sphere.ply")), "-", "-", "-f", "off", *SMALL)
        self.assertTrue(text.startswith(b"OFF\n60 116 0\n"))
        self.assertRegex(self.pipe(content(self.input()), "-", "out.vtp", *SMALL).decode(),
                         LAST_LINE)

    def test_wrong_input(self):
        for data, pattern in ((b"", "cannot read '-': it is empty"),
                              (b"what is this", "none of the formats"),
                              (content(self.input("sphere.ply"))[:-9], "cannot read '-': mal")):
            result = subprocess.run([self.program, "-", "-"], input=data, capture_output=True,
                                    timeout=60, check=False)
            self.assertEqual((result.returncode, result.stdout), (1, b""))
            self.assertRegex(result.stderr.decode(), pattern)

    def test_json(self):
        result = self.run_program(self.input(), "out.vtp", "--json", "-r", "r.json", *SMALL)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        printed = json.loads(result.stdout)
        written = load(self.path("r.json"))
        self.assertEqual(list(printed), list(written))
        self.assertEqual(printed["output"], written["output"])
        self.fail_with(2, "two outputs", self.input(), "-", "--json")

    def test_nobody_reads(self):
        ours, theirs = os.pipe()
        os.close(ours)
        with open(self.path("s.vtp"), "wb") as file:
            file.write(b"older")
        result = subprocess.run([self.program, self.input(), "-", "--sites", "s.vtp", *SMALL],
                                cwd=self.folder, stdout=theirs, stderr=subprocess.PIPE,
                                timeout=60, check=False)
        os.close(theirs)
        self.assertEqual(result.returncode, 1)
        self.assertIn(b"cannot write to standard output: Broken pipe", result.stderr)
        self.assertEqual(content(self.path("s.vtp")), b"older")

    def test_last_line(self):
        report = ["--report", "r.json"]
        line = self.succeed(self.input(), "out.vtp", *SMALL, *report)
        found = re.match(LAST_LINE, line)
        output = load(self.path("r.json"))["output"]
        self.assertEqual(found.groups()[:3], ("60", "116", "preserved"))
        relative = output["rms_distance"] / sphere().GetLength()
        self.assertIn(f"RMS distance {relative:.1e} of the diagonal", line)
        line = self.succeed(self.input(), "out.vtp", *SMALL, "--no-distance")
        self.assertNotIn("RMS", line)

    def test_links(self):
        os.mkdir(self.path("there"))
        for name, older in (("there/out.vtp", True), ("there/new.vtp", False)):
            if older:
                with open(self.path(name), "w", encoding="utf-8") as file:
                    file.write("older")
            os.symlink(name, self.path("link.vtp"))
            os.symlink("link.vtp", self.path("link2.vtp"))
            self.succeed(self.input(), "link2.vtp", *SMALL)
            self.assertTrue(os.path.islink(self.path("link.vtp")))
            self.assertTrue(os.path.islink(self.path("link2.vtp")))
            self.assertEqual(read(self.path(name)).GetNumberOfPoints(), 60)
            os.remove(self.path("link.vtp"))
            os.remove(self.path("link2.vtp"))
        self.assertEqual(sorted(os.listdir(self.path("there"))), ["new.vtp", "out.vtp"])


class TestCompare(CommandLineTest):
    def test_table(self):
        result = self.run_program(self.input(), "out.vtp", "-n", "100", "--compare", self.input(),
                                  "-r", "r.json")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        lines = result.stdout.splitlines()
        self.assertRegex(lines[-1] + "\n", LAST_LINE)
        rows = {line[:30].strip(): line[30:].split() for line in lines[:-1] if line.strip()}
        self.assertEqual(rows["points"], ["100", str(sphere().GetNumberOfPoints())])
        self.assertEqual(rows["triangles"], ["196", str(sphere().GetNumberOfPolys())])
        self.assertEqual(rows["Euler characteristic"], ["2", "2"])
        report = load(self.path("r.json"))
        self.assertEqual(rows["RMS distance"][0], f"{report['comparison']['RMSDistance']:.4g}")
        self.assertAlmostEqual(report["comparison"]["RMSDistance"],
                               report["output"]["rms_distance"],
                               delta=0.1 * report["output"]["rms_distance"])
        again = self.run_program("out.vtp", "-c", self.input())
        self.assertEqual(again.stdout.splitlines(), lines[:-1])
        self.assertEqual(sorted(os.listdir(self.folder)), ["out.vtp", "r.json"])

    def test_json(self):
        result = self.run_program(self.input("sphere.ply"), "-c", self.input(), "--json")
        comparison = json.loads(result.stdout)["comparison"]
        self.assertEqual(comparison["NumberOfTriangles"], sphere().GetNumberOfPolys())
        self.assertLess(comparison["MaximumDistance"], 1e-6)

    def test_wrong(self):
        self.fail_with(1, "No such file", self.input(), "out.vtp", "-c", "missing.vtp")
        self.fail_with(2, "nothing to write", self.input(), "-c", self.input(), "-r", "r.json")
        self.fail_with(2, "is an input", self.input(), "ref.vtp", "-c", "ref.vtp",
                       **self.reference())

    def reference(self):
        write(sphere(), self.path("ref.vtp"))
        return {}


def lead_session(command, folder, environment, done):
    """Runs the command on the terminal, which would lose its last words if its leader ended."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    status = subprocess.run(
        command, cwd=folder, env={**os.environ, "TERM": "xterm", **environment}, check=False,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL)).returncode
    os.write(done, str(status).encode())
    time.sleep(60)
    os._exit(0)


def on_terminal(command, folder, send=None, environment=None):
    """Exit status and output of a command on a terminal of its own; `send` is typed at 'READY'."""
    status, done = os.pipe()
    leader, terminal = pty.fork()
    if leader == 0:
        lead_session(command, folder, environment or {}, done)
    text = b""
    ready = [terminal]
    while terminal in ready:  # all that there is when the command has ended
        ready = select.select([terminal, status], [], [], 60)[0]
        if terminal in ready:
            text += os.read(terminal, 65536)
        if send and b"READY" in text and b"%" in text:
            os.write(terminal, send)
            send = None
    code = int(os.read(status, 20)) if ready else None
    os.kill(leader, signal.SIGKILL)
    os.waitpid(leader, 0)
    for file in (status, done, terminal):
        os.close(file)
    return code, text.decode()


class TestTerminal(CommandLineTest):
    LONG = ["--points", "2000", "--lloyd", "60"]

    def test_progress_bar(self):
        status, text = on_terminal([self.program, self.input(), "out.vtp", *self.LONG], self.folder)
        self.assertEqual(status, 0)
        bar, line = re.fullmatch(r"((?:\r\[#*\.*\] +\d+ % [^\r\n]*\x1b\[K)+\r\x1b\[K)(.*)\r\n",
                                 text, re.DOTALL).groups()
        self.assertGreater(bar.count("%"), 1)
        self.assertRegex(line.replace("\x1b[1m", "").replace("\x1b[0m", "") + "\n", LAST_LINE)
        status, text = on_terminal([self.program, self.input(), "out.vtp", "-q", *self.LONG],
                                   self.folder)
        self.assertEqual((status, text), (0, ""))

    def test_colors(self):
        command = [self.program, "missing.ply", "out.vtp"]
        for environment, colored in (({}, True), ({"NO_COLOR": "1"}, False),
                                     ({"NO_COLOR": ""}, True), ({"TERM": "dumb"}, False)):
            status, text = on_terminal(command, self.folder, environment=environment)
            self.assertEqual(status, 1)
            self.assertEqual("\x1b[" in text, colored, (environment, text))
        self.assertEqual(self.run_program(*command[1:]).stderr.count("\x1b"), 0)

    def test_interrupt_ends_a_loop(self):
        loop = (f"echo READY; for i in 1 2 3; do '{self.program}' '{self.input()}' out$i.vtp "
                "--points 2000 --lloyd 100000; done; echo 'AFTER'")
        started = time.monotonic()
        status, text = on_terminal(["bash", "-c", loop], self.folder, send=b"\x03")
        self.assertLess(time.monotonic() - started, 30)
        self.assertEqual(status, -signal.SIGINT, text)
        self.assertEqual(text.count("interrupted"), 1)
        self.assertNotIn("AFTER", text)
        self.assertEqual(os.listdir(self.folder), [])

    def test_interrupt_ends_several_inputs(self):
        shutil.copy(self.input(), self.path("b.vtp"))
        with subprocess.Popen([self.program, self.input(), "b.vtp", "-o", "{stem}2.vtp",
                               "--points", "2000", "--lloyd", "100000"], cwd=self.folder,
                              stderr=subprocess.PIPE) as process:
            time.sleep(1)
            process.send_signal(signal.SIGINT)
            _, error = process.communicate(timeout=60)
        self.assertEqual((process.returncode, error),
                         (-signal.SIGINT, b"remesh_surface: interrupted\n"))
        self.assertEqual(os.listdir(self.folder), ["b.vtp"])


if __name__ == "__main__":
    main()
