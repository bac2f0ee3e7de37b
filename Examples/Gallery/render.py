#!/usr/bin/python3
"""Draws a remeshed surface: on the left its triangles, on the right the Voronoi cells.

    xvfb-run -a /usr/bin/python3 render.py --surface Surface.vtp --cells VoronoiCells.vtp
        --edges Edges.vtp --output picture.png [--view X,Y,Z] [--up X,Y,Z] [--zoom Z]
        [--size WIDTHxHEIGHT]

The cells are coloured by `SiteId`, neighbouring ones differently; their borders are the lines of
`EdgeType` 0. --view is the direction from the surface to the eye, --up another one that points
up in the picture.
"""
import argparse
import math
import sys

import numpy as np
import vtkmodules.vtkInteractionStyle  # noqa: F401 (render windows need it)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkImageAppend, vtkThreshold
from vtkmodules.vtkImagingCore import vtkImageResize
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkDataSetMapper, vtkLightKit, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
    vtkWindowToImageFilter)
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass, vtkSSAOPass

try:
    from vtkmodules.vtkFiltersCore import vtkExtractEdges
except ImportError:  # VTK 9.1
    from vtkmodules.vtkFiltersExtraction import vtkExtractEdges

OVERSAMPLING = 2  # pixels drawn for each pixel of the picture, along each side
BACKGROUND = (0.985, 0.985, 0.98), (0.86, 0.89, 0.92)  # below, above
FACE_COLOR = (0.93, 0.90, 0.84)
LINE_COLOR = (0.16, 0.19, 0.24)
PALETTE = ("7fb2d9", "f4b98a", "93cfa6", "e99a9a", "bfa8e0", "f3dc8c", "84cccf", "d8b894",
           "b3cd7d", "e3a6cb", "a9b8c9", "f2d3c2")


def read(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    if reader.GetOutput().GetNumberOfCells() == 0:
        sys.exit(f"render.py: '{path}' has no cells, or cannot be read")
    return reader.GetOutput()


def site_colors(cells, edges):
    """For each site a row of PALETTE that none of its neighbours has, as far as there is one."""
    count = int(cells.GetCellData().GetArray("SiteId").GetRange()[1]) + 1
    neighbors = [set() for _ in range(count)]
    for one, other in vtk_to_numpy(edges.GetCellData().GetArray("SiteId")):
        if one >= 0 and other >= 0:
            neighbors[one].add(other)
            neighbors[other].add(one)
    colors = np.full(count, -1)
    for site in range(count):
        taken = {colors[other] for other in neighbors[site]}
        start = (site * 7919 + site // 3) % len(PALETTE)
        order = [(start + k) % len(PALETTE) for k in range(len(PALETTE))]
        colors[site] = next((color for color in order if color not in taken), start)
    return colors


def color_cells(cells, edges):
    site = vtk_to_numpy(cells.GetCellData().GetArray("SiteId"))
    rgb = np.array([[int(color[k:k + 2], 16) for k in (0, 2, 4)] for color in PALETTE], np.uint8)
    array = numpy_to_vtk(rgb[site_colors(cells, edges)[site]], deep=True)
    array.SetName("Color")
    cells.GetCellData().SetScalars(array)


def face_actor(surface, colored):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(surface)
    mapper.SetScalarVisibility(colored)
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(1.0, 1.0)
    actor = vtkActor()
    actor.SetMapper(mapper)
    looks = actor.GetProperty()
    looks.SetInterpolationToFlat()
    looks.SetColor(*FACE_COLOR)
    looks.SetAmbient(0.15)
    looks.SetDiffuse(0.9)
    looks.SetSpecular(0.06)
    looks.SetSpecularPower(15.0)
    return actor


def line_actor(algorithm, width):
    mapper = vtkDataSetMapper()
    mapper.SetInputConnection(algorithm.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    looks = actor.GetProperty()
    looks.LightingOff()
    looks.SetColor(*LINE_COLOR)
    looks.SetLineWidth(width * OVERSAMPLING)
    return actor


def mesh_lines(surface):
    edges = vtkExtractEdges()
    edges.SetInputData(surface)
    return edges


def cell_borders(edges):
    borders = vtkThreshold()
    borders.SetInputData(edges)
    borders.SetInputArrayToProcess(0, 0, 0, 1, "EdgeType")
    borders.SetLowerThreshold(-0.5)
    borders.SetUpperThreshold(0.5)
    borders.SetThresholdFunction(vtkThreshold.THRESHOLD_BETWEEN)
    return borders


def make_renderer(actors, diagonal):
    renderer = vtkRenderer()
    renderer.GradientBackgroundOn()
    renderer.SetBackground(*BACKGROUND[0])
    renderer.SetBackground2(*BACKGROUND[1])
    for actor in actors:
        renderer.AddActor(actor)
    renderer.RemoveAllLights()
    renderer.AutomaticLightCreationOff()
    kit = vtkLightKit()
    kit.SetKeyLightIntensity(0.92)
    kit.SetKeyLightWarmth(0.56)
    kit.SetKeyToFillRatio(2.0)
    kit.SetKeyToHeadRatio(4.0)
    kit.AddLightsToRenderer(renderer)
    # Darker where light hardly gets to: it shows the shape where the lines do not.
    shading = vtkSSAOPass()
    shading.SetRadius(0.06 * diagonal)
    shading.SetBias(0.0008 * diagonal)
    shading.SetKernelSize(48)
    shading.BlurOn()
    shading.SetDelegatePass(vtkRenderStepsPass())
    renderer.SetPass(shading)
    return renderer


def fit_camera(renderer, surface, view, up, zoom):
    """Parallel projection, the surface as large as the picture allows."""
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    view = np.array(view) / np.linalg.norm(view)
    right = np.cross(up, view)
    right /= np.linalg.norm(right)
    above = np.cross(view, right)
    x, y, z = points @ right, points @ above, points @ view
    center = ((x.min() + x.max()) * right + (y.min() + y.max()) * above +
              (z.min() + z.max()) * view) / 2.0
    width, height = renderer.GetRenderWindow().GetSize()
    aspect = width / height
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(*center)
    camera.SetPosition(*(center + 2.0 * np.linalg.norm(np.ptp(points, axis=0)) * view))
    camera.SetViewUp(*above)
    camera.SetParallelScale(1.06 / zoom * max(np.ptp(y), np.ptp(x) / aspect) / 2.0)
    renderer.ResetCameraClippingRange()


def render(actors, surface, options):
    """One half of the picture. (Of two renderers in a window, only one gets its shading.)"""
    width, height = options.size[0] // 2, options.size[1]
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(OVERSAMPLING * width, OVERSAMPLING * height)
    renderer = make_renderer(actors, surface.GetLength())
    window.AddRenderer(renderer)
    fit_camera(renderer, surface, options.view, options.up, options.zoom)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    small = vtkImageResize()
    small.SetInputConnection(image.GetOutputPort())
    small.SetOutputDimensions(width, height, 1)
    small.Update()
    return small.GetOutput()


def draw(options):
    surface, cells, edges = (read(path) for path in
                             (options.surface, options.cells, options.edges))
    color_cells(cells, edges)
    # Thinner lines where there are more of them.
    width = min(1.6, max(0.55, 90.0 / math.sqrt(surface.GetNumberOfPoints())))
    sides = [
        [face_actor(surface, False), line_actor(mesh_lines(surface), width)],
        [face_actor(cells, True), line_actor(cell_borders(edges), width)],
    ]
    picture = vtkImageAppend()
    for actors in sides:
        picture.AddInputData(render(actors, surface, options))
    writer = vtkPNGWriter()
    writer.SetInputConnection(picture.GetOutputPort())
    writer.SetCompressionLevel(9)
    writer.SetFileName(options.output)
    writer.Write()
    if writer.GetErrorCode() != 0:
        sys.exit(f"render.py: cannot write '{options.output}'")


def vector(text):
    numbers = tuple(float(word) for word in text.split(","))
    if len(numbers) != 3 or not any(numbers):
        raise argparse.ArgumentTypeError("three numbers, X,Y,Z")
    return numbers


def dimensions(text):
    width, height = (int(word) for word in text.split("x"))
    return width, height


def main():
    parser = argparse.ArgumentParser(description="Draws a remeshed surface.")
    parser.add_argument("--surface", required=True)
    parser.add_argument("--cells", required=True)
    parser.add_argument("--edges", required=True)
    parser.add_argument("--output", required=True)
    parser.add_argument("--view", type=vector, default=(0.5, 0.35, 1.0))
    parser.add_argument("--up", type=vector, default=(0.0, 1.0, 0.0))
    parser.add_argument("--zoom", type=float, default=1.0)
    parser.add_argument("--size", type=dimensions, default=(2400, 1200))
    options = parser.parse_args()
    lengths = np.linalg.norm(options.view) * np.linalg.norm(options.up)
    if not np.linalg.norm(np.cross(options.up, options.view)) > 1e-6 * lengths:
        parser.error("--view and --up must be directions, and not the same or opposite ones: "
                     "choose another --up")
    draw(options)


if __name__ == "__main__":
    main()
