"""Tests of how shells complete remesh_surface's command line.

    TestCommandLineCompletion.py --program build/bin/remesh_surface --work FOLDER [unittest options]

Those of zsh and fish take these shells.
"""
import os
import pty
import re
import select
import shutil
import signal
import subprocess
import unittest

from CommandLineTesting import CommandLineTest, main


class TestCompletion(CommandLineTest):
    def setUp(self):
        super().setUp()
        text = self.run_program("--help").stdout
        self.options = re.findall(r"^  (?:    |-(\w), )--([a-z-]+)(?: (\S+))?", text, re.MULTILINE)

    def script(self, shell):
        result = self.run_program("--completion", shell)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        with open(self.path(shell), "w", encoding="utf-8") as file:
            file.write(result.stdout)
        return result.stdout

    def type_in(self, command, setup, lines):
        """
        The arguments that a shell on a terminal gives the program for each line; a tab in a line
        completes. The program is a function of the shell, that prints them.
        """
        leader, terminal = pty.fork()
        if leader == 0:
            os.chdir(self.folder)
            os.execvpe(command[0], command, {**os.environ, "TERM": "dumb", "PS1": "$ "})

        def read_until(word):
            text = b""
            while word not in text:
                self.assertTrue(select.select([terminal], [], [], 20)[0], text)
                text += os.read(terminal, 65536)
            return text.decode()

        try:
            setup += "; remesh_surface() { printf '<%s>' \"$@\"; echo '<'END'>'; }"
            os.write(terminal, f"{setup}; echo 'READ'Y\n".encode())
            read_until(b"READY")
            found = []
            for line in lines:
                os.write(terminal, f"remesh_surface {line}\n".encode())
                found.append(re.findall(r"<([^<>]*)>", read_until(b"<END>"))[:-1])
            return found
        finally:
            os.kill(leader, signal.SIGKILL)
            os.waitpid(leader, 0)
            os.close(terminal)

    # What is typed, with tabs, and what the program gets.
    TYPED = {"sc\t": ["scan.ply"],
             "my\t": ["my scan.vtp"],
             "scan.ply --cel\tsc\t": ["scan.ply", "--cells", "scan.ply"],
             "-c sc\t": ["-c", "scan.ply"],
             "--placement c\t": ["--placement", "centroid"],
             "--backend=tb\t": ["--backend=tbb"],
             "--points sc\t": ["--points", "sc"]}

    def check_typing(self, command, setup):
        for name in ("scan.ply", "my scan.vtp"):
            with open(self.path(name), "wb"):
                pass
        found = self.type_in(command, setup, self.TYPED)
        # zsh ends an option that takes a value with "=".
        self.assertEqual([" ".join(words).replace("--cells=", "--cells ") for words in found],
                         [" ".join(words) for words in self.TYPED.values()])

    def complete(self, *words):
        """What bash would offer for the last word; nothing stands for files."""
        line = " ".join(f"'{word}'" for word in ("remesh_surface",) + words)
        result = subprocess.run(
            ["bash", "-c", f"compopt() {{ :; }}; source ./bash; COMP_WORDS=({line}); "
             f"COMP_CWORD={len(words)}; _remesh_surface; printf '%s\\n' \"${{COMPREPLY[@]}}\""],
            cwd=self.folder, capture_output=True, encoding="utf-8", check=True)
        self.assertEqual(result.stderr, "")
        return sorted(result.stdout.split())

    def test_bash(self):
        self.script("bash")
        expected = [f"--{name}" for _, name, _ in self.options]
        expected += [f"-{letter}" for letter, _, _ in self.options if letter]
        self.assertEqual(self.complete("x.ply", "-"), sorted(expected))
        self.assertEqual(self.complete("--po"), ["--points"])
        backends = ["automatic", "sequential", "stdthread", "tbb"]
        self.assertEqual(self.complete("--backend", ""), backends)
        self.assertEqual(self.complete("--backend", "="), backends)
        self.assertEqual(self.complete("--backend", "=", "t"), ["tbb"])
        self.check_typing(["bash", "--norc", "-i"], "source ./bash")

    def test_zsh(self):
        text = self.script("zsh")
        self.assertTrue(text.startswith("#compdef remesh_surface\n"))
        found = set(re.findall(r"^  '(?:\([^)]*\)|\*)(--?[a-z-]+|-[a-zA-Z])[+=]?\[", text,
                               re.MULTILINE))
        expected = {f"--{name}" for _, name, _ in self.options}
        expected |= {f"-{letter}" for letter, _, _ in self.options if letter}
        self.assertEqual(found, expected)
        # Single quotes pair up in every shell.
        subprocess.run([shutil.which("zsh") or "bash", "-n", "./zsh"], cwd=self.folder, check=True)

    @unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
    def test_typing_in_zsh(self):
        self.script("zsh")
        os.rename(self.path("zsh"), self.path("_remesh_surface"))
        self.check_typing(["zsh", "-f", "-i"], "fpath=($PWD $fpath); autoload -Uz compinit; "
                                               "compinit -u -D")

    def test_fish(self):
        found = re.findall(r"^complete -c remesh_surface -l ([a-z-]+)(?: -s (\w))?( -[rx])?",
                           self.script("fish"), re.MULTILINE)
        self.assertEqual([(letter, name, value != "") for name, letter, value in found],
                         [(letter, name, value != "") for letter, name, value in self.options])

    @unittest.skipUnless(shutil.which("fish"), "fish is not installed")
    def test_offers_of_fish(self):
        self.script("fish")
        with open(self.path("scan.ply"), "wb"):
            pass
        for line, expected in (("sc", ["scan.ply"]), ("--cells sc", ["scan.ply"]),
                               ("--poi", ["--points"]), ("--points sc", []),
                               ("--placement c", ["centroid"]), ("--backend=t", ["--backend=tbb"])):
            result = subprocess.run(
                ["fish", "--no-config", "-c",
                 f"source ./fish; complete -C 'remesh_surface {line}'"],
                cwd=self.folder, capture_output=True, encoding="utf-8", check=True)
            offered = [text.split("\t")[0] for text in result.stdout.splitlines()]
            self.assertEqual(offered, expected, line)


if __name__ == "__main__":
    main()
