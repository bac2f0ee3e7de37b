"""Opens each of the example states, and checks what is seen and how much came out.

TestExampleStates.py <plugin.so> <folder for pictures> <folder of the states>
"""
import os
import sys

from paraview import servermanager, simple

REMESHED = 1500
# By state, for each view what is visible in it: the source, its port, and what colours it.
EXPECTED = {
    "cells": [[("Remesher", 0, "")], [("Remesher", 1, "CellColor"), ("Remesher", 4, "EdgeType")]],
    "convergence": [[("Remesher", 0, "")], [("Remesher", 3, None)]],
    "comparison": [[("Comparison", 0, "Distance")], [("Comparison", 0, "Quality")]],
}


def visible(view, names):
    shown = []
    for item in view.Representations:
        if getattr(item, "Visibility", 0) and hasattr(item, "Input"):
            array = item.ColorArrayName[1] if hasattr(item, "ColorArrayName") else None
            shown.append((names[item.Input.SMProxy.GetGlobalID()], item.Input.Port, array or
                          ("" if array is not None else None)))
    return sorted(shown)


def check_state(name, file, picture):
    simple.ResetSession()
    simple.LoadState(file)
    views = simple.GetViews()
    names = {source.SMProxy.GetGlobalID(): key[0] for key, source in simple.GetSources().items()}
    simple.RenderAllViews()
    seen = sorted(visible(view, names) for view in views)
    assert seen == sorted(EXPECTED[name]), (name, seen)
    body, remesher = simple.FindSource("Body"), simple.FindSource("Remesher")
    surface = servermanager.Fetch(simple.OutputPort(remesher, 0))
    assert surface.GetNumberOfPoints() == REMESHED, surface.GetNumberOfPoints()
    # A closed surface without handles.
    assert surface.GetNumberOfCells() == 2 * REMESHED - 4, surface.GetNumberOfCells()
    assert body.GetDataInformation().GetNumberOfPoints() > REMESHED
    simple.SaveScreenshot(picture, simple.GetLayout(views[0]), ImageResolution=[1200, 600])


def main(plugin, pictures, states):
    simple.LoadPlugin(plugin, remote=False, ns=globals())
    found = sorted(file[:-5] for file in os.listdir(states) if file.endswith(".pvsm"))
    assert found == sorted(EXPECTED), found
    for name in found:
        check_state(name, os.path.join(states, name + ".pvsm"),
                    os.path.join(pictures, "ExampleState-%s.png" % name))


main(*sys.argv[1:])
