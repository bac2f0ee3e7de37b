"""Write the example states beside this script: pvbatch make_states.py <plugin.so>

Each opens in ParaView once the plugin is loaded, and needs no data files.
"""
import os
import sys
from xml.etree import ElementTree

from paraview import simple

FOLDER = os.path.dirname(os.path.abspath(__file__))


def start():
    """An empty session with a smooth body: flat, bent one way, and bent both ways."""
    simple.ResetSession()
    body = simple.Superquadric(registrationName="Body", ThetaResolution=128, PhiResolution=128,
                               Scale=[0.7, 1.2, 0.7], PhiRoundness=0.3, Toroidal=0)
    remesher = simple.AnisotropicRemesher(registrationName="Remesher", Input=body,
                                          NumberOfPoints=1500, Anisotropy=0.06)
    return body, remesher


def render_view():
    view = simple.CreateView("RenderView")
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Single Color"
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    return view


def beside(*views):
    """A layout of views side by side."""
    layout = simple.CreateLayout(name="Example")
    layout.AssignView(0, views[0])
    if len(views) > 1:
        layout.AssignView(layout.SplitHorizontal(0, 0.5) + 1, views[1])
    layout.SetSize(1200, 600)


def look(view):
    simple.SetActiveView(view)
    view.CameraPosition = [1.3, 1.0, 2.4]
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    view.CameraViewUp = [0.0, 1.0, 0.0]
    simple.ResetCamera(view)
    view.CameraViewAngle = 25


def show_mesh(source, view, port=0):
    display = simple.Show(simple.OutputPort(source, port), view)
    display.Representation = "Surface With Edges"
    return display


def show_cells(remesher, view):
    cells = simple.Show(simple.OutputPort(remesher, 1), view)
    simple.ColorBy(cells, ("CELLS", "CellColor"))
    simple.Show(simple.OutputPort(remesher, 4), view)


def write(name, active):
    simple.SetActiveView(active)
    simple.RenderAllViews()
    file = os.path.join(FOLDER, name + ".pvsm")
    simple.SaveState(file)
    tree = ElementTree.parse(file)
    for property in tree.iter("Property"):
        for domain in property.findall("Domain"):  # Not read, and most of the file.
            property.remove(domain)
    tree.write(file)


def cells_state():
    _, remesher = start()
    left, right = render_view(), render_view()
    beside(left, right)
    show_mesh(remesher, left)
    show_cells(remesher, right)
    for view in (left, right):
        look(view)
    write("cells", left)


def convergence_state():
    _, remesher = start()
    left, chart = render_view(), simple.CreateView("XYChartView")
    beside(left, chart)
    show_mesh(remesher, left)
    look(left)
    simple.Show(simple.OutputPort(remesher, 3), chart)
    chart.LeftAxisTitle = "Energy"
    chart.BottomAxisTitle = "Iteration"
    write("convergence", left)


def comparison_state():
    body, remesher = start()
    left, right = render_view(), render_view()
    beside(left, right)
    comparison = simple.SurfaceMeshComparison(
        registrationName="Comparison", Input=simple.OutputPort(remesher, 0), Reference=body)
    for view, association, array in ((left, "POINTS", "Distance"), (right, "CELLS", "Quality")):
        display = show_mesh(comparison, view)
        simple.ColorBy(display, (association, array))
        display.SetScalarBarVisibility(view, True)
        bar = simple.GetScalarBar(simple.GetColorTransferFunction(array), view)
        bar.TitleColor = bar.LabelColor = [0.0, 0.0, 0.0]
        look(view)
    write("comparison", left)


simple.LoadPlugin(sys.argv[1], remote=False, ns=simple.__dict__)
cells_state()
convergence_state()
comparison_state()
