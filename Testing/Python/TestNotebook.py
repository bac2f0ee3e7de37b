#!/usr/bin/env python3
"""In a notebook a result shows a picture of its triangles."""
import base64
import os
import re
import sys
import tempfile
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

from TestPackage import html_of_result


class TestNotebook(unittest.TestCase):
    def test_picture(self):
        text = html_of_result(os.environ)
        image = base64.b64decode(re.search("src='data:image/png;base64,([^']+)'", text)[1])
        with tempfile.NamedTemporaryFile(suffix=".png") as file:
            file.write(image)
            file.flush()
            reader = vtkPNGReader()
            reader.SetFileName(file.name)
            reader.Update()
        width, height, _ = reader.GetOutput().GetDimensions()
        pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
        inked = (pixels[:, :3].min(axis=1) < 250).reshape(height, width)
        self.assertTrue(0.2 < inked.mean() < 0.8, inked.mean())
        border = numpy.concatenate((inked[0], inked[-1], inked[:, 0], inked[:, -1]))
        self.assertFalse(border.any(), "the sphere is cut off")


if __name__ == "__main__":
    if not os.environ.get("DISPLAY"):
        print("Skipped: there is no display.")
        sys.exit(125)
    unittest.main(verbosity=2)
