# Writes what ParaView's window holds to a file: TestWindow.py has the window's own Python shell
# run this, with `name`, `folder` and `digests` given. Nothing is changed or executed by it.
import hashlib
import json
import os
import subprocess
import traceback

from paraview import servermanager, simple
from paraview.vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader


def digest(source, port):
    """The points and the cells of an output, as a short text."""
    data = servermanager.Fetch(servermanager.OutputPort(source, port))
    text = hashlib.sha256(vtk_to_numpy(data.GetPoints().GetData()).tobytes())
    for cells in (data.GetVerts(), data.GetLines(), data.GetPolys()):
        if cells.GetNumberOfCells():
            text.update(vtk_to_numpy(cells.GetConnectivityArray()).tobytes())
    return text.hexdigest()


def arrays_of(information):
    """Components of the point arrays, by name."""
    arrays = information.GetPointDataInformation()
    listed = [arrays.GetArrayInformation(k) for k in range(arrays.GetNumberOfArrays())]
    return {array.GetName(): array.GetNumberOfComponents() for array in listed}


def source_state(source, with_digest):
    """Numbers of points and cells by port, and the properties that the test sets."""
    ports = range(source.SMProxy.GetNumberOfOutputPorts())
    information = [source.GetDataInformation(port).DataInformation for port in ports]
    state = {"points": [item.GetNumberOfPoints() for item in information],
             "cells": [item.GetNumberOfCells() for item in information],
             "type": source.GetXMLName(), "arrays": arrays_of(information[0])}
    for property in ("NumberOfPoints", "Anisotropy", "NumberOfSamples"):
        if source.GetProperty(property) is not None:
            state[property] = value_of(source, property)
    for property in ("Input", "Reference", "Sites"):
        if source.GetProperty(property) is not None:
            state[property] = input_of(source, property)
    if with_digest:
        state["digest"] = digest(source, 0)
    return state


def representation_state(representation):
    return {"source": names.get(representation.Input.SMProxy.GetGlobalID()),
            "port": representation.Input.Port,
            "how": str(getattr(representation, "Representation", "")),
            "type": representation.GetXMLName()}


def picture_state(view):
    """How much of the picture the surface takes, and how much of that are dark lines."""
    file = os.path.join(folder, name + ".png")
    simple.SaveScreenshot(file, view, ImageResolution=[500, 400])
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)
    pixels = pixels[60:, :, :3].astype(int)  # without the axes in the lower corner
    surface = abs(pixels - pixels[-1, 0]).max(axis=2) > 20
    lines = surface & (pixels[:, :, :2].max(axis=2) < 60)
    return {"surface": float(surface.mean()), "lines": float(lines.sum() / max(1, surface.sum()))}


def value_of(source, property):
    value = source.GetPropertyValue(property)
    return value if isinstance(value, (int, float, str)) else list(value)


def input_of(source, property):
    value = source.GetPropertyValue(property)
    return names.get(value.SMProxy.GetGlobalID()) if value else None


def window_state():
    state = {"sources": {}, "views": {}}
    for key, source in simple.GetSources().items():
        state["sources"][key[0]] = source_state(source, key[0] in digests)
    for key, view in servermanager.ProxyManager().GetProxiesInGroup("views").items():
        state["views"][key[0]] = {
            "type": view.GetXMLName(),
            "visible": [representation_state(item) for item in view.Representations
                        if getattr(item, "Visibility", 0) and hasattr(item, "Input")]}
    active = simple.GetActiveView()
    state["active_view"] = active.GetXMLName() if active else None
    state["time"] = simple.GetAnimationScene().AnimationTime
    if active and active.GetXMLName() == "RenderView":
        state["picture"] = picture_state(active)
    return state


def keep_window_picture():
    """The whole window, to look at, where that is wanted and ImageMagick is there."""
    pictures = os.environ.get("TEST_WINDOW_PICTURES")
    if pictures:
        subprocess.run(["import", "-window", "root", os.path.join(pictures, name + ".png")])


names = {source.SMProxy.GetGlobalID(): key[0] for key, source in simple.GetSources().items()}
keep_window_picture()
try:
    text = json.dumps(window_state(), indent=1)
except Exception:
    text = json.dumps({"error": traceback.format_exc()})
with open(os.path.join(folder, name + ".json"), "w") as file:
    file.write(text)
