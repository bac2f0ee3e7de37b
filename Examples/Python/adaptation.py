"""Adapts meshes to a solution, round by round, and plots the error against the number of points.

    adaptation.py [--points N] [--rounds R] [--picture FILE.png]

1. Solve on the mesh: here a function is evaluated, a front on a square or a wave on a sphere.
2. Compute the metric in which a mesh of N points has the least error of interpolation.
3. Refine the mesh, so that its triangles can follow the metric, and remesh it. The remesher carries
   the solution over, for a solver to go on from.

Where the metric is the best, the error falls like 1 / N, however sharp the front. The plot needs
matplotlib (Debian: python3-matplotlib); the numbers do not.
"""
import sys
import warnings

import numpy
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter

import anisotropic_remeshing as ar
import shapes


def front(points):
    return numpy.tanh(40.0 * (numpy.hypot(points[:, 0], points[:, 1]) - 0.3))


def wave(points):
    return numpy.sin(8.0 * points[:, 2] + 4.0 * points[:, 0] * points[:, 1])


def square():
    points, triangles = shapes.sheet(24)
    return 0.5 * (points + [1.0, 1.0, 0.0]), triangles


def on_sphere(points):
    return points / numpy.linalg.norm(points, axis=1)[:, None]


def on_square(points):
    return points


def error(points, triangles, function, project, steps=6):
    """Root of the integral of the squared error of linear interpolation."""
    corners, values = points[triangles], function(points)[triangles]
    areas = 0.5 * numpy.linalg.norm(numpy.cross(corners[:, 1] - corners[:, 0],
                                                corners[:, 2] - corners[:, 0]), axis=1)
    places = [(i + third, j + third) for third in (1 / 3, 2 / 3) for i in range(steps)
              for j in range(steps - i - (third > 0.5))]
    squares = 0.0
    for x, y in numpy.array(places) / steps:
        weights = numpy.array([1.0 - x - y, x, y])
        exact = function(project(numpy.einsum("k,tkc->tc", weights, corners)))
        squares = squares + (exact - values @ weights) ** 2
    return numpy.sqrt((areas * squares).sum() / len(places))


def refined(surface, project):
    """Four triangles for each, on the surface, with the arrays."""
    divided = vtkLinearSubdivisionFilter()
    divided.SetInputData(surface)
    divided.Update()
    finer = ar.embed(divided.GetOutput(), anisotropy=0.0)
    finer.points[:] = project(finer.points)
    return finer.surface


def adapt(start, function, project, number, rounds):
    """The errors of a mesh of equal triangles, and after each round."""
    run = {"cells": False, "edges": False, "measure_distance": False}
    mesh = ar.remesh(start, number, anisotropy=0.0, **run)
    errors = []
    for _ in range(rounds):
        errors.append(error(mesh.points, mesh.triangles, function, project))
        solved = shapes.surface(mesh.points, mesh.triangles, U=function(mesh.points))
        metric = ar.metric_from_solution(solved, "U", number)
        mesh = ar.remesh(refined(metric.surface, project), number, metric="Metric", **run)
        mesh.points[:] = project(mesh.points)
    return errors + [error(mesh.points, mesh.triangles, function, project)]


def main(options):
    cases = (("front on a square", square(), front, on_square),
             ("wave on a sphere", shapes.sphere(24), wave, on_sphere))
    numbers = [options.points // 2 ** k for k in (4, 3, 2, 1, 0)]
    curves = {}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of a first mesh that is too coarse for its metric
        for name, start, function, project in cases:
            found = [adapt(start, function, project, n, int(options.rounds)) for n in numbers]
            for number, errors in zip(numbers, found):
                print(f"{name}, {number} points: error times points {number * errors[0]:.3g} at "
                      f"first, {number * errors[-1]:.3g} adapted", flush=True)
            curves[name] = numpy.array(found)
    if options.picture:
        plot(options.picture, numbers, curves)


def plot(picture, numbers, curves):
    try:
        from matplotlib.figure import Figure
    except ImportError:
        sys.exit("adaptation.py: the plot needs matplotlib (Debian: python3-matplotlib).")
    figure = Figure(figsize=(8.0, 3.6), layout="constrained")
    for k, (name, errors) in enumerate(curves.items()):
        axes = figure.add_subplot(1, len(curves), k + 1)
        axes.loglog(numbers, errors[:, 0], marker="o", color="tab:blue", label="equal triangles")
        axes.loglog(numbers, errors[:, -1], marker="o", color="tab:orange", label="adapted")
        axes.loglog(numbers, errors[-1, -1] * numbers[-1] / numpy.array(numbers, float), ":",
                    color="gray", label="1 / N")
        axes.set_title(name)
        axes.set_xlabel("points")
        axes.set_ylabel("L2 error")
        axes.grid(True, which="both", alpha=0.3)
        axes.legend()
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    main(shapes.options(__doc__, 4000, rounds=5))
