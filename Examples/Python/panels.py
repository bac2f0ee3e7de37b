"""Draws surfaces side by side, each with a caption: the pictures of the examples.

Needs a display, as `xvfb-run -a` gives one.
"""
import os
import struct
import sys
import zlib

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkImagingColor import vtkImageQuantizeRGBToIndex
from vtkmodules.vtkImagingCore import vtkImageResize
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkTextActor, vtkWindowToImageFilter
import vtkmodules.vtkRenderingFreeType  # noqa: F401 (text needs it)

import shapes

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Gallery"))
import render  # noqa: E402

COLD, MIDDLE, WARM = (46, 96, 160), (242, 238, 224), (196, 72, 52)
COLORS = 64  # of a picture: enough for smooth shading


def polydata(data):
    return shapes.surface(*data) if isinstance(data, tuple) else data


def painted(data, colors, of_cells):
    """A copy with these colours (n, 3), 0 to 255, of points or cells."""
    copy = vtkPolyData()
    copy.ShallowCopy(data)
    array = numpy_to_vtk(numpy.ascontiguousarray(colors, dtype=numpy.uint8), deep=True)
    array.SetName("Color")
    attributes = copy.GetCellData() if of_cells else copy.GetPointData()
    (copy.GetPointData() if of_cells else copy.GetCellData()).SetActiveScalars(None)
    attributes.SetScalars(array)
    return copy


def width_of(data):
    """Thinner lines where there are more of them."""
    return min(1.3, max(0.5, 55.0 / numpy.sqrt(data.GetNumberOfPoints())))


def mesh(data, caption):
    """A mesh with its edges."""
    data = polydata(data)
    return caption, data, [render.face_actor(data, False),
                           render.line_actor(render.mesh_lines(data), width_of(data))]


def shade(data, values, caption, lines=False, low=None, high=None):
    """A surface coloured by a value at each point."""
    data = polydata(data)
    values = numpy.asarray(values, float)
    low = values.min() if low is None else low
    high = values.max() if high is None else high
    share = numpy.clip((values - low) / ((high - low) or 1.0), 0.0, 1.0)
    colors = numpy.stack([numpy.interp(share, (0.0, 0.5, 1.0), rgb)
                          for rgb in zip(COLD, MIDDLE, WARM)], axis=1)
    actors = [render.face_actor(painted(data, colors, False), True)]
    if lines:
        actors.append(render.line_actor(render.mesh_lines(data), width_of(data)))
    return caption, data, actors


def smooth(data, caption):
    """A mesh that is lit by its array Normals, as in a game or a viewer."""
    data = polydata(data)
    actor = render.face_actor(data, False)
    looks = actor.GetProperty()
    looks.SetInterpolationToPhong()
    looks.SetSpecular(0.6)
    looks.SetSpecularPower(40.0)
    looks.SetColor(0.55, 0.68, 0.82)
    return caption, data, [actor]


def cells(result, caption):
    """The Voronoi cells of a result, by their array CellColor, and their borders."""
    data = result.cells
    number = vtk_to_numpy(data.GetCellData().GetArray("CellColor"))
    palette = numpy.array([[int(color[k:k + 2], 16) for k in (0, 2, 4)]
                           for color in render.PALETTE])
    colored = painted(data, palette[number % len(palette)], True)
    borders = render.line_actor(render.cell_borders(result.edges), width_of(result.mesh))
    return caption, data, [render.face_actor(colored, True), borders]


def photograph(panel, extent, view, up, zoom, size):
    """A panel's picture, as (height, width, 3) numbers."""
    caption, _, actors = panel
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(*(render.OVERSAMPLING * pixels for pixels in size))
    renderer = render.make_renderer(actors, extent.GetLength())
    window.AddRenderer(renderer)
    renderer.SetPass(None)  # flat colours: files are a third as large
    render.fit_camera(renderer, extent, view, up, 0.9 * zoom)
    renderer.GetActiveCamera().SetWindowCenter(0.0, -0.07)  # the caption is below
    text = vtkTextActor()
    text.SetInput(caption)
    text.SetPosition(render.OVERSAMPLING * size[0] / 2, render.OVERSAMPLING * 9)
    looks = text.GetTextProperty()
    looks.SetFontSize(render.OVERSAMPLING * 15)
    looks.SetJustificationToCentered()
    looks.SetColor(0.1, 0.1, 0.12)
    renderer.AddActor2D(text)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    small = vtkImageResize()
    small.SetInputConnection(image.GetOutputPort())
    small.SetOutputDimensions(*size, 1)
    small.Update()
    pixels = vtk_to_numpy(small.GetOutput().GetPointData().GetScalars())
    return pixels.reshape(size[1], size[0], 3)[::-1]


def write_png(path, pixels):
    """A PNG file with a palette of COLORS: a third as large as one with all colours."""
    height, width = pixels.shape[:2]
    image = image_of(pixels)
    quantize = vtkImageQuantizeRGBToIndex()
    quantize.SetInputData(image)
    quantize.SetNumberOfColors(COLORS)
    quantize.Update()
    index = vtk_to_numpy(quantize.GetOutput().GetPointData().GetScalars()).astype(numpy.uint8)
    table = vtk_to_numpy(quantize.GetLookupTable().GetTable())[:, :3].astype(numpy.uint8)
    lines = numpy.zeros((height, width + 1), numpy.uint8)  # each row begins with its filter, none
    lines[:, 1:] = index.reshape(height, width)

    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data)))

    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" +
                   chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 3, 0, 0, 0)) +
                   chunk(b"PLTE", table.tobytes()) +
                   chunk(b"IDAT", zlib.compress(lines.tobytes(), 9)) + chunk(b"IEND", b""))


def image_of(pixels):
    image = vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    image.GetPointData().SetScalars(
        numpy_to_vtk(numpy.ascontiguousarray(pixels).reshape(-1, 3), deep=True))
    return image


def draw(options, panels, view, up=(0, 0, 1), zoom=1.0, columns=None, size=(400, 370)):
    """Writes a PNG file of the panels, row by row; view: from surface to eye, for all or each."""
    columns = columns or len(panels)
    size = [int(options.scale * pixels) for pixels in size]
    views = view if isinstance(view, list) else [view] * len(panels)
    pictures = [photograph(panel, panel[1], direction, up, zoom, size)
                for panel, direction in zip(panels, views)]
    rows = [numpy.concatenate(pictures[k:k + columns], axis=1)
            for k in range(0, len(pictures), columns)]
    write_png(options.picture, numpy.concatenate(rows, axis=0))
