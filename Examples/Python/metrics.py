"""Metrics in pictures: ellipses, the mesh that they ask for, and where it comes from.

    metrics.py [--points N] [--picture FILE.png]

Upper row: a metric as ellipses, each as large as a unit of length is there in all directions; the
mesh that it asks for, with the ellipses of its own points; a solution, and the mesh on which it is
interpolated best. Lower row: the surface where lengths are those of the metric, in three of the six
dimensions, with the mesh on it; the same for forty eigenfunctions of a surface, and its mesh.
"""
import numpy

import anisotropic_remeshing as ar
import shapes


def tensors(points):
    """Three times as long along a direction that turns with x, and finer to the right."""
    angle = 1.5 * points[:, 0]
    size = 0.5 - 0.25 * points[:, 0]
    rotation = numpy.stack([numpy.stack([numpy.cos(angle), numpy.sin(angle)], axis=1),
                            numpy.stack([-numpy.sin(angle), numpy.cos(angle)], axis=1)], axis=2)
    squares = numpy.stack([(3.0 / size) ** 2, (1.0 / size) ** 2], axis=1)
    metric = numpy.zeros((len(points), 3, 3))
    metric[:, :2, :2] = numpy.einsum("nik,nk,njk->nij", rotation, squares, rotation)
    metric[:, 2, 2] = 1.0
    return metric


def ellipses(points, metric, radius, sides=24):
    """The curves e' M e = radius^2 around points of the plane, as polygons."""
    values, vectors = numpy.linalg.eigh(metric[:, :2, :2])
    angle = 2.0 * numpy.pi * numpy.arange(sides) / sides
    circle = numpy.stack([numpy.cos(angle), numpy.sin(angle)], axis=1)
    rings = numpy.einsum("nik,nk,sk->nsi", vectors, radius / numpy.sqrt(values), circle)
    places = numpy.zeros((len(points), sides, 3))
    places[..., :2] = points[:, None, :2] + rings
    places[..., 2] = 0.002
    faces = numpy.arange(len(points) * sides).reshape(len(points), sides)
    return shapes.surface(places.reshape(-1, 3), faces)


def star():
    """A sphere with three arms."""
    points, triangles = shapes.sphere(60)
    arms = numpy.cos(3.0 * numpy.arctan2(points[:, 1], points[:, 0]))
    ring = numpy.hypot(points[:, 0], points[:, 1])
    return points * (1.0 + 0.8 * arms * ring ** 3)[:, None] * [1.0, 1.0, 0.7], triangles


def front(points):
    return numpy.tanh(12.0 * (points[:, 1] - 0.4 * numpy.sin(3.0 * points[:, 0])))


def main(options):
    flat, triangles = shapes.sheet(80)
    surface = shapes.surface(flat, triangles, Metric=tensors(flat).reshape(-1, 9),
                             Solution=front(flat))
    run = {"cells": False, "measure_distance": False}
    made = ar.metric_embedding(surface, "Metric", options.points)
    asked = ar.remesh(surface, options.points, metric="Metric", **run)
    few = options.points // 3
    solution = ar.metric_from_solution(surface, "Solution", few)
    adapted = ar.remesh(solution.surface, few, metric="Metric", **run)
    organic = shapes.surface(*star())
    spectrum = ar.spectral_embedding(organic, 40, scaling="biharmonic")
    even = ar.remesh(organic, options.points, embedding=spectrum.embedding, **run)
    print(f"the metric is met on {100 * made.share:.1f} % of the square, and sizes were made "
          f"smaller by at most {made.limit:.2f}")
    sides = lengths(asked, tensors)
    print(f"its edges are {sides.mean():.3f} +- {sides.std():.3f} long, a unit being "
          f"{asked.mesh.GetFieldData().GetArray('MetricUnit').GetValue(0):.3f}")
    if options.picture:
        draw(options, surface, made, asked, adapted, spectrum, even)


def lengths(result, metric):
    """Of the edges, in the metric at their middles."""
    sides = numpy.concatenate([result.triangles[:, [k, (k + 1) % 3]] for k in range(3)])
    ends = result.points[sides]
    edge = ends[:, 1] - ends[:, 0]
    return numpy.sqrt(numpy.einsum("ni,nij,nj->n", edge, metric(ends.mean(axis=1)), edge))


def with_glyphs(panel, points, radius, color):
    """A panel with ellipses on it."""
    import render

    caption, data, actors = panel
    glyphs = ellipses(points, tensors(points), radius)
    face = render.face_actor(glyphs, False)
    face.GetProperty().SetColor(*color)
    return caption, data, actors + [face, render.line_actor(render.mesh_lines(glyphs), 1.0)]


def placed(places, triangles):
    """A surface at the three of its coordinates in R^d that spread most."""
    centered = places - places.mean(axis=0)
    axes = numpy.linalg.svd(centered, full_matrices=False)[2]
    return shapes.surface(centered @ axes[:3].T, triangles)


def draw(options, surface, made, asked, adapted, spectrum, even):
    import panels

    grid = numpy.linspace(-0.84, 0.84, 7)
    centers = numpy.stack([c.ravel() for c in numpy.meshgrid(grid, grid)] + [numpy.zeros(49)], axis=1)
    inner = asked.points[numpy.abs(asked.points[:, :2]).max(axis=1) < 0.93]
    unit = asked.mesh.GetFieldData().GetArray("MetricUnit").GetValue(0)
    plain = shapes.surface(*shapes.sheet(8))
    height = numpy.zeros(plain.GetNumberOfPoints())
    space = asked.mesh.GetPointData().GetArray("Embedding")
    places = numpy.array([space.GetTuple(k) for k in range(space.GetNumberOfTuples())])
    spectral = even.mesh.GetPointData().GetArray("Embedding")
    kernel = numpy.array([spectral.GetTuple(k) for k in range(spectral.GetNumberOfTuples())])
    panels.draw(options, [
        with_glyphs(panels.shade(plain, height, "a metric: ellipses of equal length", low=-1.0,
                                 high=1.0), centers, 0.22, (0.77, 0.28, 0.2)),
        with_glyphs(panels.mesh(asked.mesh, "the mesh it asks for"), inner[::9], 0.5 * unit,
                    (0.77, 0.28, 0.2)),
        panels.shade(adapted.mesh, front(adapted.points), "a solution and its mesh", lines=True),
        panels.mesh(placed(places, asked.triangles), "where lengths are the metric's"),
        panels.mesh(placed(kernel, even.triangles), "by eigenfunctions: even there"),
        panels.mesh(even.mesh, "and in space")],
        view=3 * [(0.0, -0.001, 1.0)] + [(0.3, -0.8, 1.0), (0.3, -0.8, 1.0), (0.2, -0.4, 1.0)],
        up=(0, 0.3, 1), columns=3, size=(330, 300))


if __name__ == "__main__":
    main(shapes.options(__doc__, 1500))
