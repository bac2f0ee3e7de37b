"""Remeshes a surface in ParaView, draws triangles and Voronoi cells, and saves a picture.

    xvfb-run -a pvpython remesh.py PLUGIN PICTURE.png [SURFACE]

PLUGIN is AnisotropicRemeshing.so of the ParaView build; without SURFACE, a superquadric is taken.
"""
import sys

from paraview import simple


def show(data, view, representation, color=(0.93, 0.90, 0.84)):
    display = simple.Show(data, view)
    display.SetRepresentationType(representation)
    display.AmbientColor = display.DiffuseColor = color
    display.EdgeColor = (0.2, 0.2, 0.25)
    display.Interpolation = "Flat"
    display.ColorArrayName = ("POINTS", "")
    return display


def make_view(layout, number):
    view = simple.CreateRenderView()
    simple.AssignViewToLayout(view, layout, number)
    view.UseColorPaletteForBackground = 0
    view.Background = (1.0, 1.0, 1.0)
    view.OrientationAxesVisibility = 0
    return view


def main(plugin, picture, path=None):
    simple.LoadPlugin(plugin, remote=False, ns=vars(simple))
    if path:
        surface = simple.OpenDataFile(path)
    else:
        surface = simple.Superquadric(ThetaResolution=120, PhiResolution=120, Toroidal=0,
                                      ThetaRoundness=0.3, PhiRoundness=0.5, Scale=(1, 1, 2))

    remesher = simple.AnisotropicRemesher(Input=surface)
    remesher.NumberOfPoints = 2000
    remesher.Anisotropy = 0.08
    remesher.UpdatePipeline()

    layout = simple.CreateLayout("Remeshing")
    layout.SplitHorizontal(0, 0.5)
    left, right = make_view(layout, 1), make_view(layout, 2)
    show(simple.OutputPort(remesher, "Surface"), left, "Surface With Edges")
    cells = show(simple.OutputPort(remesher, "VoronoiCells"), right, "Surface")
    simple.ColorBy(cells, ("CELLS", "CellArea"))
    show(simple.OutputPort(remesher, "Edges"), right, "Surface", (0.1, 0.1, 0.15)).LineWidth = 1.5

    for view in (left, right):
        simple.ResetCamera(view)
        camera = view.GetActiveCamera()
        camera.Azimuth(30)
        camera.Elevation(25)
        camera.Zoom(1.05)
    layout.SetSize(1600, 800)
    simple.SaveScreenshot(picture, layout)


if __name__ == "__main__":
    if not 3 <= len(sys.argv) <= 4:
        sys.exit(__doc__.split("\n\n")[1].strip())
    main(*sys.argv[1:])
