"""The surfaces of the table of verdicts, from formulas, one for each kind that meshing can fail on;
and what the table needs of a mesh's file.

Coordinates have seven decimals, so that the last bits of a machine's sines make no other surface.
"""
import hashlib
import os
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
for folder in ("Python", "Gallery"):
    sys.path.insert(0, os.path.join(ROOT, "Examples", folder))
import make_surfaces  # noqa: E402 pylint: disable=wrong-import-position
import shapes  # noqa: E402 pylint: disable=wrong-import-position

PI = numpy.pi


def grid_of(rows, columns):
    """Angles of the points of a closed lattice of rows x columns, row by row."""
    u, v = numpy.meshgrid(2.0 * PI * numpy.arange(rows) / rows,
                          2.0 * PI * numpy.arange(columns) / columns, indexing="ij")
    return u.ravel(), v.ravel()


def torus_points(u, v, tube):
    """Around a ring of radius 1; the tube's radius for each point."""
    ring = 1.0 + tube * numpy.cos(v)
    return numpy.stack([ring * numpy.cos(u), ring * numpy.sin(u), tube * numpy.sin(v)], axis=1)


def bumpy_tube(u, v):
    """Waves around both circles, of 3 to 19 periods."""
    return 0.4 * (1.0 + 0.12 * numpy.sin(3.0 * u + 2.0 * v) +
                  0.05 * numpy.sin(7.0 * u - 5.0 * v + 1.0) +
                  0.02 * numpy.sin(19.0 * u + 11.0 * v + 2.0))


def joined(parts):
    """One surface of several (points, faces)."""
    points, faces, first = [], [], 0
    for some, their in parts:
        points.append(some)
        faces.append(numpy.asarray(their) + first)
        first += len(some)
    return numpy.concatenate(points), numpy.concatenate(faces)


def ellipsoid():
    """Smooth, of three lengths."""
    points, faces = shapes.sphere(60)
    return points * [1.0, 0.6, 0.3], faces


def implicit(name, spacing):
    """A surface of the gallery, coarser and with estimated normals."""
    function, bounds, _, _ = make_surfaces.SURFACES[name]
    data = make_surfaces.make_surface(function, bounds, spacing)
    points = vtk_to_numpy(data.GetPoints().GetData())
    return points, vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def plate():
    """A thin plate with a round rim; its flat sides are two triangles each."""
    return shapes.rounded_box((1.0, 0.7, 0.02), 0.02)[:2]


def leaf():
    """Closed, thin and wavy; its rim is sharp in places."""
    points, faces = shapes.sphere(60)
    x, y, z = points.T
    y = 0.6 * y
    wavy = 0.02 * z + 0.15 * numpy.sin(6.0 * x) * numpy.cos(5.0 * y)
    return numpy.stack([x, y, wavy], axis=1), faces


def shell():
    """Two bumpy toruses inside each other, a hundredth of the tube apart."""
    u, v = grid_of(80, 40)
    faces = shapes.lattice(80, 40, True, True)
    tube = bumpy_tube(u, v)
    return joined([(torus_points(u, v, tube), faces),
                   (torus_points(u, v, 0.99 * tube), faces[:, ::-1])])


def bicone():
    """Two long fans of coarse triangles, back to back."""
    around = numpy.arange(72)
    angle = 2.0 * PI * around / 72
    rim = numpy.stack([numpy.cos(angle), numpy.sin(angle), 0.0 * angle], axis=1)
    beside = (around + 1) % 72
    upper = numpy.stack([around, beside, numpy.full(72, 72)], axis=1)
    lower = numpy.stack([beside, around, numpy.full(72, 73)], axis=1)
    return (numpy.concatenate([rim, [[0.0, 0.0, 10.0], [0.0, 0.0, -10.0]]]),
            numpy.concatenate([upper, lower]))


def star():
    """A super-toroid: sharp edges, each cut off, whose creases take any number of points."""
    u, v = grid_of(120, 90)

    def power(x, exponent):
        x = x.round(12)
        return numpy.sign(x) * numpy.abs(x) ** exponent

    tube = 1.0 + 0.5 * power(numpy.cos(v), 2.5)
    points = numpy.stack([tube * power(numpy.cos(u), 0.3), tube * power(numpy.sin(u), 0.3),
                          0.5 * power(numpy.sin(v), 2.5)], axis=1)
    return points, shapes.lattice(120, 90, True, True)


def holes():
    """A wavy sheet with five jagged holes."""
    points, faces = shapes.sheet(80)
    centers = points[faces].mean(axis=1)
    kept = numpy.ones(len(faces), bool)
    for x, y in ((0.0, 0.0), (0.55, 0.5), (-0.55, 0.5), (0.5, -0.6), (-0.6, -0.45)):
        kept &= numpy.hypot(centers[:, 0] - x, centers[:, 1] - y) > 0.17
    points[:, 2] = 0.15 * numpy.sin(3.0 * PI * points[:, 0])
    return points, faces[kept]


def book():
    """Three bent sheets that share an edge: no manifold."""
    sheets = []
    for k in range(3):
        points, faces = shapes.sheet(30)
        radius, height = 0.5 * (points[:, 0] + 1.0), points[:, 1]
        angle = 2.0 * PI * k / 3.0 + 0.7 * radius
        sheets.append((numpy.stack([radius * numpy.cos(angle), radius * numpy.sin(angle), height],
                                   axis=1), faces))
    return joined(sheets)


def crumbs():
    """225 components of many sizes: more than 500 points can mesh."""
    points, faces = shapes.sphere(6)
    return joined([((0.03 + 0.0008 * (k % 100)) * points + [0.25 * (k % 15), 0.25 * (k // 15), 0.0],
                    faces) for k in range(225)])


def needles():
    """Forty small bicones: coarse fans, and a dozen points for each."""
    points, faces = bicone()
    angle = 2.0 * PI * numpy.arange(40) / 40
    return joined([(points * [0.05, 0.05, 0.01 * (1 + k % 3)] +
                    [numpy.cos(angle[k]), numpy.sin(angle[k]), 0.0], faces) for k in range(40)])


def roll():
    """A sheet rolled up: three turns, closer than few points are."""
    points, faces = shapes.sheet(60)
    turn = 3.0 * PI * (points[:, 0] + 1.0)
    radius = 0.3 + 0.005 * turn
    return numpy.stack([radius * numpy.cos(turn), radius * numpy.sin(turn), points[:, 1]],
                       axis=1), faces


def cog():
    """A gear of ninety teeth, whose creases take all of few points."""
    return shapes.gear(90, 1)


def mobius():
    """A strip that is joined to itself after half a turn: nothing tells its front."""
    points, faces = shapes.sheet(120)
    turn, across = PI * (points[:, 0] + 1.0), 0.3 * points[:, 1]
    ring = 1.0 + across * numpy.cos(0.5 * turn)
    return numpy.stack([ring * numpy.cos(turn), ring * numpy.sin(turn),
                        across * numpy.sin(0.5 * turn)], axis=1), faces


def scan():
    """A bumpy torus with noise of a seventh of its edges."""
    u, v = grid_of(120, 60)
    noise = numpy.sin(12.9898 * numpy.arange(len(u))) * 43758.5453
    noise -= numpy.floor(noise)
    return (torus_points(u, v, bumpy_tube(u, v) + 0.012 * (noise - 0.5)),
            shapes.lattice(120, 60, True, True))


def spikes():
    """A sphere with many thin thorns, that take more than few points."""
    points, faces = shapes.sphere(60)
    x, y, z = points.T
    waves = numpy.sin(4.0 * numpy.arctan2(y, x)) * numpy.sin(4.0 * numpy.arccos(z))
    return points * (1.0 + 1.5 * waves[:, None] ** 12), faces


def ribbon():
    """A knot pressed flat, so that it nearly touches itself."""
    points, faces = shapes.knot(840, 24)
    return points * [1.0, 1.0, 0.3], faces


def voxels():
    """The faces between full and empty voxels, which meet at edges and points: no manifold."""
    x, y, z = numpy.indices((6, 6, 6))
    full = numpy.pad((7 * x + 5 * y + 3 * z + x * y + 2 * y * z) % 4 < 2, 1)
    sides, corners = numpy.eye(3), []
    for axis, front in ((axis, front) for axis in range(3) for front in (0, 1)):
        u, v = sides[(axis + 1) % 3], sides[(axis + 2) % 3]
        beyond = numpy.roll(full, -1 if front else 1, axis)
        first = numpy.argwhere(full & ~beyond) + front * sides[axis]
        around = [first, first + u, first + u + v, first + v]
        corners.append(numpy.stack(around if front else around[::-1], axis=1))
    points = numpy.concatenate(corners).reshape(-1, 3)
    return points, numpy.arange(len(points)).reshape(-1, 4)


# What makes points, faces and, where they are given, normals.
SURFACES = {
    "bicone": bicone,
    "book": book,
    "box": shapes.rounded_box,
    "cog": cog,
    "crumbs": crumbs,
    "ellipsoid": ellipsoid,
    "gear": shapes.gear,
    "holes": holes,
    "knot": lambda: shapes.knot(210, 30),
    "leaf": leaf,
    "mobius": mobius,
    "needles": needles,
    "octopus": lambda: implicit("octopus", 0.05),
    "part": lambda: implicit("part", 0.045),
    "plate": plate,
    "ribbon": ribbon,
    "roll": roll,
    "scan": scan,
    "shell": shell,
    "spikes": spikes,
    "star": star,
    "voxels": voxels,
}


def write(name, path):
    """Makes the surface of this name: a .vtp file."""
    points, faces, *normals = SURFACES[name]()
    data = shapes.surface(numpy.round(points, 7) + 0.0, faces,  # no -0
                          *(numpy.round(array, 7) + 0.0 for array in normals))
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(data)
    writer.SetFileName(path)
    writer.SetDataModeToBinary()
    if not writer.Write() or writer.GetErrorCode() != 0:
        raise OSError(f"cannot write {path}")


def measure(path):
    """A .vtp file's first 48 bits of the SHA-256 of points and triangles, and its diagonal."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    mesh = reader.GetOutput()
    if mesh.GetNumberOfPolys() == 0:
        return "empty", 0.0
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype("<f8")
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).astype("<i8")
    return hashlib.sha256(points.tobytes() + triangles.tobytes()).hexdigest()[:12], mesh.GetLength()
