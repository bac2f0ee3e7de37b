"""What a result shows of itself in a notebook."""
from __future__ import annotations

import base64
import html
import os
import subprocess
import sys
import tempfile
from typing import Any, Dict, Optional, Tuple

from vtkmodules.vtkCommonDataModel import vtkPolyData

_MOST_TRIANGLES = 2000000
_SECONDS = 30

# In a process of its own: where there is no display, VTK ends the program.
_SCRIPT = """
import sys
import vtkmodules.vtkRenderingOpenGL2
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter)
reader = vtkXMLPolyDataReader()
reader.SetFileName(sys.argv[1])
mapper = vtkPolyDataMapper()
mapper.SetInputConnection(reader.GetOutputPort())
mapper.ScalarVisibilityOff()
actor = vtkActor()
actor.SetMapper(mapper)
actor.GetProperty().SetColor(0.85, 0.87, 0.9)
actor.GetProperty().SetEdgeColor(0.2, 0.25, 0.35)
actor.GetProperty().EdgeVisibilityOn()
renderer = vtkRenderer()
renderer.SetBackground(1, 1, 1)
renderer.AddActor(actor)
window = vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetMultiSamples(8)
window.SetSize(480, 360)
window.AddRenderer(renderer)
renderer.ResetCamera()
renderer.GetActiveCamera().Azimuth(30)
renderer.GetActiveCamera().Elevation(20)
renderer.GetActiveCamera().OrthogonalizeViewUp()
renderer.ResetCamera()
renderer.GetActiveCamera().Zoom(1.15)
renderer.ResetCameraClippingRange()
window.Render()
grab = vtkWindowToImageFilter()
grab.SetInput(window)
grab.ReadFrontBufferOff()
writer = vtkPNGWriter()
writer.SetFileName(sys.argv[2])
writer.SetInputConnection(grab.GetOutputPort())
writer.Write()
"""


def _render(mesh: Any) -> Tuple[Optional[bytes], str]:
    """(PNG, ""), or (None, why there is none)."""
    if not isinstance(mesh, vtkPolyData) or mesh.GetNumberOfPolys() == 0:
        return None, "there are no triangles to show"
    if mesh.GetNumberOfPolys() > _MOST_TRIANGLES:
        return None, f"more than {_MOST_TRIANGLES} triangles"
    from . import _surfaces

    shape = vtkPolyData()
    shape.CopyStructure(mesh)
    with tempfile.TemporaryDirectory() as folder:
        source, target = os.path.join(folder, "mesh.vtp"), os.path.join(folder, "mesh.png")
        _surfaces.write(shape, source)
        environment = dict(os.environ, PYTHONPATH=os.pathsep.join(filter(None, sys.path)))
        try:
            subprocess.run([sys.executable or "python3", "-c", _SCRIPT, source, target],
                           env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL, timeout=_SECONDS, check=False)
        except (OSError, subprocess.TimeoutExpired):
            return None, "rendering failed"
        try:
            with open(target, "rb") as file:
                return file.read(), ""
        except FileNotFoundError:
            return None, "VTK cannot render here (is there a display?)"


def html_of(title: str, mesh: Any, facts: Dict[str, str]) -> str:
    """A picture of the mesh, where VTK can render, beside a table of facts."""
    image, reason = _render(mesh)
    rows = "".join(
        f"<tr><th style='text-align:left'>{html.escape(name)}</th>"
        f"<td style='text-align:left'>{html.escape(value)}</td></tr>"
        for name, value in facts.items()
    )
    table = f"<table><caption><b>{html.escape(title)}</b></caption>{rows}</table>"
    if image is None:
        return f"<div>{table}<p><i>No picture: {html.escape(reason)}.</i></p></div>"
    data = base64.b64encode(image).decode("ascii")
    return (
        "<div style='display:flex;align-items:center;gap:1em'>"
        f"<img alt='{html.escape(title)}' width='480' src='data:image/png;base64,{data}'/>"
        f"{table}</div>"
    )
