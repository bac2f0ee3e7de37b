#!/usr/bin/python3
"""Makes two surfaces to try the remesher on: an octopus and a machined part.

    make_surfaces.py FOLDER [octopus] [part]

writes octopus.vtp (smooth, closed, genus 0, about 40 000 triangles) and part.vtp (plate with boss,
bore and fillets; closed, genus 1, about 30 000 triangles), or one of them, with exact unit normals
in the point array `Normals`; and the same as octopus.ply and part.ply without these.

1. A shape is the zero set of a function f that is close to a distance: unions and intersections of
   simple solids with rounded transitions (so that the surface has a tangent plane everywhere).
2. f is sampled on a grid, and the zero set extracted (flying edges: closed and manifold).
3. Vertices are moved along the surface towards the mean of their neighbours, which makes the
   triangles even, and back to f = 0 by Newton's method.
4. Closedness and genus are checked.
"""
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import (
    numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy)
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkFlyingEdges3D
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter


# --- solids: functions of points (n x 3), negative inside -----------------------------------------

def round_cone_chain(points, centers, radii):
    """Distance to the union of cones between successive spheres."""
    distance = np.full(len(points), np.inf)
    for a, b, ra, rb in zip(centers[:-1], centers[1:], radii[:-1], radii[1:]):
        axis = b - a
        t = np.clip((points - a) @ axis / (axis @ axis), 0.0, 1.0)
        gap = np.linalg.norm(points - a - t[:, None] * axis, axis=1) - ra - t * (rb - ra)
        distance = np.minimum(distance, gap)
    return distance


def smooth_union(a, b, width):
    """Minimum of a and b, blended where they differ by less than `width` (cubic)."""
    blend = np.maximum(width - np.abs(a - b), 0.0) / width
    return np.minimum(a, b) - blend ** 3 * width / 6.0


def fillet_union(a, b, radius):
    """Union; where the solids meet at right angles, a circular fillet."""
    corner = np.hypot(np.maximum(radius - a, 0.0), np.maximum(radius - b, 0.0))
    return np.maximum(radius, np.minimum(a, b)) - corner


def fillet_intersection(a, b, radius):
    """Intersection; where the solids meet at right angles, a circular round."""
    return -fillet_union(-a, -b, radius)


def rounded_box(points, half_size, radius):
    """Box around the origin; all edges have the given radius."""
    q = np.abs(points) - (np.asarray(half_size) - radius)
    outside = np.linalg.norm(np.maximum(q, 0.0), axis=1)
    return outside + np.minimum(q.max(axis=1), 0.0) - radius


def octopus(points):
    """A head and eight curled arms."""
    head = points - np.array([0.0, 0.0, 0.62])
    head = (np.linalg.norm(head / np.array([0.46, 0.42, 0.6]), axis=1) - 1.0) * 0.44
    body = np.linalg.norm(points / np.array([0.5, 0.5, 0.3]), axis=1) * 0.34 - 0.34
    solid = smooth_union(head, body, 0.3)
    t = np.linspace(0.0, 1.0, 40)
    for arm in range(8):
        raised = arm % 2 == 0
        reach = 0.25 + 1.2 * t ** 0.9
        turn = np.pi * (arm + 0.5) / 4.0 + (0.75 if raised else 0.95) * t ** 2
        lift = -0.1 - 0.12 * np.sin(np.pi * t) + (0.62 if raised else 0.1) * t ** 2.5
        centers = np.stack([reach * np.cos(turn), reach * np.sin(turn), lift], axis=1)
        radii = 0.17 * (1.0 - t) ** 0.8 + 0.05
        # Far from an arm it does not matter how far.
        near = np.all((points > centers.min(axis=0) - 0.5) & (points < centers.max(axis=0) + 0.5),
                      axis=1)
        arm_distance = round_cone_chain(points[near], centers, radii)
        solid[near] = smooth_union(solid[near], arm_distance, 0.16)
    return solid


def part(points):
    """A plate with a boss, a bore through both, and rounds and fillets everywhere."""
    x, y, z = points.T
    plate = rounded_box(points, (1.0, 0.65, 0.2), 0.08)
    boss = fillet_intersection(np.hypot(x, y) - 0.42, z - 0.75, 0.07)
    boss = np.maximum(boss, -z)
    solid = fillet_union(plate, boss, 0.15)
    return fillet_intersection(solid, 0.24 - np.hypot(x, y), 0.05)


# --- from a function to a mesh --------------------------------------------------------------------

def gradient(function, points, step=1e-5):
    """Central differences (n x 3)."""
    return np.stack([
        (function(points + step * e) - function(points - step * e)) / (2.0 * step)
        for e in np.eye(3)], axis=1)


def project(function, points, steps):
    """Newton's method along the gradient: the nearby points with f = 0."""
    for _ in range(steps):
        slope = gradient(function, points)
        value = function(points) / np.maximum((slope ** 2).sum(axis=1), 1e-12)
        points = points - value[:, None] * slope
    return points


def extract(function, bounds, spacing):
    """Points (n x 3) and triangles (m x 3) of the zero set."""
    low, high = np.array(bounds, dtype=float).reshape(3, 2).T
    size = np.ceil((high - low) / spacing).astype(int) + 1
    z, y, x = np.meshgrid(*(low[k] + spacing * np.arange(size[k]) for k in (2, 1, 0)),
                          indexing="ij")
    samples = function(np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1))
    image = vtkImageData()
    image.SetDimensions(*(int(n) for n in size))
    image.SetOrigin(*low)
    image.SetSpacing(spacing, spacing, spacing)
    image.GetPointData().SetScalars(numpy_to_vtk(samples, deep=True))
    contour = vtkFlyingEdges3D()
    contour.SetInputData(image)
    contour.SetValue(0, 0.0)
    contour.ComputeNormalsOff()
    contour.Update()
    surface = contour.GetOutput()
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return points, triangles.astype(np.int64)


def relax(function, points, triangles, rounds):
    """Evens the triangles out; the points stay on the zero set."""
    heads = triangles[:, [1, 2, 0]].ravel()
    tails = triangles.ravel()
    degree = np.bincount(tails, minlength=len(points))[:, None]
    for _ in range(rounds):
        total = np.stack([np.bincount(tails, points[heads, k], len(points)) for k in range(3)],
                         axis=1)
        points = project(function, points + 0.6 * (total / degree - points), 1)
    return project(function, points, 4)


def make_surface(function, bounds, spacing):
    points, triangles = extract(function, bounds, spacing)
    points = relax(function, points, triangles, 12)
    normals = gradient(function, points)
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    a, b, c = (points[triangles[:, k]] for k in range(3))
    facing = np.einsum("ij,ij->i", np.cross(b - a, c - a), normals[triangles].sum(axis=1))
    if facing.sum() < 0.0:
        triangles = triangles[:, ::-1].copy()

    surface = vtkPolyData()
    surface.SetPoints(vtkPoints())
    surface.GetPoints().SetData(numpy_to_vtk(points, deep=True))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(triangles.ravel(), deep=True))
    surface.SetPolys(cells)
    array = numpy_to_vtk(normals, deep=True)
    array.SetName("Normals")
    surface.GetPointData().SetNormals(array)
    return surface


def check(surface, euler_characteristic):
    edges = vtkFeatureEdges()
    edges.SetInputData(surface)
    edges.FeatureEdgesOff()
    edges.Update()
    triangles = surface.GetNumberOfPolys()
    euler = surface.GetNumberOfPoints() - triangles // 2
    if edges.GetOutput().GetNumberOfCells() > 0 or euler != euler_characteristic:
        sys.exit(f"make_surfaces.py: not closed, or Euler characteristic {euler}")


def write(surface, folder, name):
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(surface)
    writer.SetFileName(os.path.join(folder, name + ".vtp"))
    writer.SetDataModeToBinary()
    good = writer.Write() and writer.GetErrorCode() == 0
    bare = vtkPolyData()
    bare.CopyStructure(surface)
    plywriter = vtkPLYWriter()
    plywriter.SetInputData(bare)
    plywriter.SetFileName(os.path.join(folder, name + ".ply"))
    if not (good and plywriter.Write()):
        sys.exit(f"make_surfaces.py: cannot write to '{folder}'")


SURFACES = {  # function, bounds, spacing, Euler characteristic
    "octopus": (octopus, (-1.6, 1.6, -1.6, 1.6, -0.5, 1.3), 0.0315, 2),
    "part": (part, (-1.1, 1.1, -0.75, 0.75, -0.3, 0.85), 0.027, 0),
}


def main(folder, names):
    os.makedirs(folder, exist_ok=True)
    for name in names or SURFACES:
        function, bounds, spacing, euler_characteristic = SURFACES[name]
        surface = make_surface(function, bounds, spacing)
        check(surface, euler_characteristic)
        write(surface, folder, name)
        print(f"{name}: {surface.GetNumberOfPoints()} points, "
              f"{surface.GetNumberOfPolys()} triangles")


if __name__ == "__main__":
    if len(sys.argv) < 2 or not set(sys.argv[2:]) <= set(SURFACES):
        sys.exit(__doc__.split("\n\n")[1].strip())
    main(sys.argv[1], sys.argv[2:])
