#!/usr/bin/env python3
"""mypy knows the package's types, those of the wrapped classes among them."""
import importlib.util
import os
import re
import subprocess
import sys
import tempfile
import unittest

import anisotropic_remeshing as ar

PROGRAM = """import anisotropic_remeshing as ar
result = ar.remesh("x.ply", 5000, tolerance=1e-3, progress=lambda fraction, phase: fraction < 1)
proven: bool = result.topology_preserved
count: int = ar.vtkAnisotropicRemesher().GetNumberOfPoints()
ar.remesh("x.ply", seed="3")
ar.vtkAnisotropicRemesher().SetNumberOfPoints("3")
wrong: str = result.topology_preserved
"""


def mypy(folder, *arguments):
    environment = dict(os.environ, MYPYPATH="")
    out = subprocess.run([sys.executable, "-m", "mypy", "--no-incremental", *arguments], cwd=folder,
                         capture_output=True, text=True, check=False, timeout=240, env=environment)
    return out.stdout + out.stderr


class TestTypes(unittest.TestCase):
    def test_use(self):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "use.py"), "w", encoding="utf-8") as file:
                file.write(PROGRAM)
            text = mypy(folder, "use.py")
        self.assertEqual(re.findall(r"^use.py:(\d+): error", text, re.MULTILINE), ["5", "6", "7"],
                         text)

    def test_package(self):
        folder = os.path.dirname(os.path.dirname(ar.__file__))
        text = mypy(folder, "--strict", "--ignore-missing-imports", "--allow-subclassing-any",
                    "-p", "anisotropic_remeshing")
        self.assertIn("Success", text)


if __name__ == "__main__":
    if importlib.util.find_spec("mypy") is None:
        print("Skipped: mypy is not installed.")
        sys.exit(125)
    unittest.main(verbosity=2)
