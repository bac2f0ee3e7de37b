#!/usr/bin/env python3
"""pip install of the repository into a new environment.

    TestPip.py SOURCE [unittest options]

It builds the library again: with ccache in a minute, without too slowly for a test.
"""
import importlib.util
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = "."
PROGRAM = """
import importlib.metadata, sys
import anisotropic_remeshing as ar
from vtkmodules.vtkFiltersSources import vtkSphereSource
assert ar.__file__.startswith(sys.prefix), ar.__file__
print(ar.__version__, importlib.metadata.version("anisotropic-remeshing"),
      len(ar.remesh(vtkSphereSource(), 100).points),
      [point.value for point in importlib.metadata.entry_points(group="pyvista.accessors")])
"""


class TestPip(unittest.TestCase):
    def test_install(self):
        with tempfile.TemporaryDirectory() as folder:
            source = os.path.join(folder, "source")
            shutil.copytree(SOURCE, source, ignore=shutil.ignore_patterns("build*", ".git"))
            home = os.path.join(folder, "venv")
            subprocess.run([sys.executable, "-m", "venv", "--without-pip", "--system-site-packages",
                            home], check=True)
            python = os.path.join(home, "bin", "python3")
            # No build of the test's own is found.
            environment = dict(os.environ, CMAKE_CXX_COMPILER_LAUNCHER="ccache")
            subprocess.run([python, "-m", "pip", "install", "--no-build-isolation", "--no-index",
                            "--no-deps", source], check=True, env=environment)
            environment.pop("PYTHONPATH", None)
            out = subprocess.run([python, "-c", PROGRAM], check=True, env=environment,
                                 capture_output=True, text=True, cwd=folder)
        with open(os.path.join(SOURCE, "CMakeLists.txt"), encoding="utf-8") as file:
            version = re.search(r"project\(AnisotropicRemeshing VERSION ([0-9.]+)", file.read())[1]
        self.assertEqual(out.stdout, f"{version} {version} 100 "
                                     "['anisotropic_remeshing.pyvista_accessor']\n")


if __name__ == "__main__":
    SOURCE = sys.argv.pop(1)
    missing = [name for name in ("pip", "scikit_build_core") if not importlib.util.find_spec(name)]
    missing += [] if shutil.which("ccache") else ["ccache"]
    if missing:
        print("Skipped: not installed:", ", ".join(missing))
        sys.exit(125)
    unittest.main(verbosity=2)
