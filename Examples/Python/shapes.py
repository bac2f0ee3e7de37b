"""Surfaces for the examples, from formulas: points (n, 3) and faces, as numpy arrays."""
import argparse

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData


def surface(points, faces, normals=None, **arrays):
    """vtkPolyData with those points, faces (m, k), point normals and point arrays."""
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(numpy.array(points, float, order="C"), deep=True))
    cells = vtkCellArray()
    faces = numpy.asarray(faces)
    cells.SetData(faces.shape[1], numpy_to_vtkIdTypeArray(faces.astype(numpy.int64).ravel(), True))
    data.SetPolys(cells)
    if normals is not None:
        arrays["Normals"] = normals
    for name, values in arrays.items():
        array = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    if normals is not None:
        data.GetPointData().SetActiveNormals("Normals")
    return data


def lattice(rows, columns, closed_rows=False, closed_columns=False):
    """Triangles of a grid of rows x columns points, stored row by row; closed: joined to a ring."""
    i, j = numpy.meshgrid(numpy.arange(rows - (not closed_rows)),
                          numpy.arange(columns - (not closed_columns)), indexing="ij")
    i, j = i.ravel(), j.ravel()
    down, right = (i + 1) % rows, (j + 1) % columns
    a, b, c, d = i * columns + j, down * columns + j, down * columns + right, i * columns + right
    return numpy.concatenate([numpy.stack([a, b, c], axis=1), numpy.stack([a, c, d], axis=1)])


def sheet(resolution=100):
    """The square from -1 to 1, flat."""
    x, y = numpy.meshgrid(*2 * [numpy.linspace(-1.0, 1.0, resolution + 1)], indexing="ij")
    points = numpy.stack([x.ravel(), y.ravel(), numpy.zeros(x.size)], axis=1)
    return points, lattice(resolution + 1, resolution + 1)


def sphere(resolution=100):
    """The unit sphere; its poles are rows of points that are equal."""
    latitude, longitude = numpy.meshgrid(numpy.linspace(-0.5, 0.5, resolution + 1) * numpy.pi,
                                         numpy.arange(2 * resolution) * numpy.pi / resolution,
                                         indexing="ij")
    latitude[0], latitude[-1] = -numpy.pi / 2, numpy.pi / 2
    ring = numpy.cos(latitude)
    ring[[0, -1]] = 0.0
    points = numpy.stack([ring * numpy.cos(longitude), ring * numpy.sin(longitude),
                          numpy.sin(latitude)], axis=2).reshape(-1, 3)
    return points, lattice(resolution + 1, 2 * resolution, closed_columns=True)[:, ::-1]


def knot(along=420, around=60):
    """A flat band, closed to a trefoil knot: it bends a lot across, and little along."""
    t = numpy.linspace(0.0, 2.0 * numpy.pi, along, endpoint=False)

    def spine(t):
        radius = 2.0 + numpy.cos(3.0 * t)
        return numpy.stack([radius * numpy.cos(2.0 * t), radius * numpy.sin(2.0 * t),
                            1.1 * numpy.sin(3.0 * t)], axis=1)

    tangent = spine(t + 1e-5) - spine(t - 1e-5)
    tangent /= numpy.linalg.norm(tangent, axis=1)[:, None]
    out = numpy.stack([numpy.cos(3 * t) * numpy.cos(2 * t), numpy.cos(3 * t) * numpy.sin(2 * t),
                       numpy.sin(3 * t)], axis=1)
    out -= (out * tangent).sum(axis=1)[:, None] * tangent
    out /= numpy.linalg.norm(out, axis=1)[:, None]
    side = numpy.cross(tangent, out)
    u = numpy.linspace(0.0, 2.0 * numpy.pi, around, endpoint=False)
    points = (spine(t)[:, None] + 0.2 * numpy.cos(u)[None, :, None] * out[:, None] +
              0.55 * numpy.sin(u)[None, :, None] * side[:, None])
    return points.reshape(-1, 3), lattice(along, around, True, True)


def gear(teeth=14, steps=5):
    """A gear with hub and bore, as CAD programs write one: long thin triangles, sharp edges."""
    shape = [0.82, 0.82, 1.0, 1.0]  # root, root, tip, tip of a tooth
    places = numpy.arange(teeth * 4) / 4.0
    corners = numpy.interp(numpy.linspace(0.0, 4.0 * teeth, 4 * teeth * steps, endpoint=False),
                           numpy.arange(4 * teeth + 1), numpy.append(places, teeth))
    radii = numpy.interp(corners, numpy.append(places, teeth), shape * teeth + shape[:1])
    angles = 2.0 * numpy.pi * corners / teeth
    rings = [(radii, -0.16), (radii, 0.16), (0.45, 0.16), (0.4, 0.42), (0.22, 0.42), (0.22, -0.16)]
    points = [numpy.stack([radius * numpy.cos(angles), radius * numpy.sin(angles),
                           numpy.full(len(angles), height)], axis=1) for radius, height in rings]
    return numpy.concatenate(points), lattice(len(rings), len(angles), True, True)[:, ::-1]


def rounded_box(half=(1.0, 0.7, 0.25), radius=0.2, steps=3):
    """
    Points, faces and exact normals of a box with rounds of so many steps in a quarter, as a CAD
    program writes it: flat faces are two triangles.
    """
    quarter = numpy.linspace(0.0, 90.0, steps + 1)
    longitude = numpy.concatenate([quarter + 90.0 * q for q in range(4)])
    signs = numpy.repeat([[1, 1], [-1, 1], [-1, -1], [1, -1]], steps + 1, axis=0)
    latitude = numpy.concatenate([quarter - 90.0, quarter])
    upper = numpy.repeat([-1, 1], steps + 1)
    a, b = (numpy.radians(angle) for angle in numpy.meshgrid(latitude, longitude, indexing="ij"))
    normals = numpy.stack([numpy.cos(a) * numpy.cos(b), numpy.cos(a) * numpy.sin(b),
                           numpy.sin(a)], axis=2).round(15)
    corner = numpy.empty_like(normals)
    corner[..., :2], corner[..., 2] = signs[None], upper[:, None]
    points = corner * (numpy.array(half) - radius) + radius * normals
    rows, columns = a.shape
    faces = lattice(rows, columns, closed_columns=True)[:, ::-1]
    pole = numpy.arange(4) * (steps + 1)
    top = (rows - 1) * columns + pole
    caps = [pole[[0, 2, 1]], pole[[0, 3, 2]], top[[0, 1, 2]], top[[0, 2, 3]]]
    return points.reshape(-1, 3), numpy.concatenate([faces, caps]), normals.reshape(-1, 3)


def options(document, points, **others):
    """What an example is asked for: --points, --picture, and others with their defaults."""
    parser = argparse.ArgumentParser(description=document.split("\n\n")[0])
    parser.add_argument("--points", type=int, default=points, help=f"of a mesh, default {points}")
    parser.add_argument("--picture", help="a PNG file to draw (needs a display)")
    parser.add_argument("--scale", type=float, default=1.0, help="of the picture, default 1")
    for name, value in others.items():
        parser.add_argument(f"--{name}", default=value)
    return parser.parse_args()
