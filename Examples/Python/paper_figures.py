"""The idea of the paper in six pictures, as in its figures 4 and 5.

    paper_figures.py [--points N] [--picture FILE.png]

A square with a metric: distances are longer across a hill's slope than along it. Seen as a surface
in space (lower row), the same distances are the usual ones. So an even mesh of the hill is, from
above (upper row), the mesh that the metric asks for.
"""
import numpy

import anisotropic_remeshing as ar
import shapes


def hill(points):
    """Heights of a ring-shaped wall."""
    radius = numpy.hypot(points[:, 0], points[:, 1])
    return 0.55 / (1.0 + numpy.exp((radius - 0.55) / 0.045))


def lift(points):
    return numpy.column_stack([points[:, :2], hill(points)])


def rings(flat, centers):
    """How far each point is, on the hill, from the nearest of some centers."""
    away = lift(flat)[:, None] - lift(centers)[None]
    return numpy.linalg.norm(away, axis=2).min(axis=1)


def main(options):
    flat, triangles = shapes.sheet(160)
    raised = lift(flat)
    surface = shapes.surface(flat, triangles)
    result = ar.remesh(surface, options.points, embedding=raised)
    mesh = lift(result.points)[result.triangles]
    sides = numpy.linalg.norm(mesh - numpy.roll(mesh, 1, axis=1), axis=2)
    print(f"{len(result.points)} points; on the hill the sides of triangles are "
          f"{sides.mean():.3g} +- {sides.std():.2g} long")
    if options.picture:
        draw(options, result)


def draw(options, result):
    import panels
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

    def raise_up(data):
        copy = data.NewInstance()
        copy.DeepCopy(data)
        places = vtk_to_numpy(copy.GetPoints().GetData())
        copy.GetPoints().SetData(numpy_to_vtk(lift(places), deep=True))
        return copy

    class Raised:
        cells, edges, mesh = (raise_up(data) for data in (result.cells, result.edges, result.mesh))

    grid = numpy.linspace(-0.84, 0.84, 7)
    centers = numpy.stack([c.ravel() for c in numpy.meshgrid(grid, grid)], axis=1)
    fine = shapes.surface(*shapes.sheet(400))
    away = rings(vtk_to_numpy(fine.GetPoints().GetData()), centers)
    disks = numpy.where(away < 0.1, numpy.where(away < 0.025, 1.0, 0.1), 0.5)
    panels.draw(options, [
        panels.shade(fine, disks, "equally far from a dot"),
        panels.cells(result, "Voronoi cells"), panels.mesh(result.mesh, "mesh"),
        panels.shade(raise_up(fine), disks, "the same, on the hill"),
        panels.cells(Raised, "even cells"), panels.mesh(Raised.mesh, "even triangles")],
        view=3 * [(0.0, -0.001, 1.0)] + 3 * [(0.4, -1.0, 0.9)], up=(0, 0.3, 1), columns=3,
        size=(330, 300))


if __name__ == "__main__":
    main(shapes.options(__doc__, 1500))
