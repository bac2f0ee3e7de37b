"""Uses the exact normals of a CAD part, whose rounds come as few flat strips.

    cad_normals.py [--points N] [--picture FILE.png]

Estimated normals see flat strips, the CAD program knows that they are round. Its normals steer the
triangles, and the mesh gets them, too, for shading. The strips meet at 45 degrees here, but none of
these edges is a crease: a larger feature angle says so.
"""
import numpy

import anisotropic_remeshing as ar
import shapes

HALF, RADIUS = (1.0, 0.7, 0.25), 0.2


def true_normals(points):
    """Of the rounded box: away from the box that is smaller by the radius."""
    inner = numpy.array(HALF) - RADIUS
    away = points - numpy.clip(points, -inner, inner)
    return away / numpy.linalg.norm(away, axis=1)[:, None]


def error_of(result):
    """Mean angle between the mesh's normals and the true ones, in degrees."""
    cosines = (result.point_data["Normals"] * true_normals(result.points)).sum(axis=1)
    return numpy.degrees(numpy.arccos(cosines.clip(-1.0, 1.0))).mean()


def main(options):
    points, faces, normals = shapes.rounded_box(HALF, RADIUS, steps=2)
    estimated = ar.remesh((points, faces), options.points, feature_angle=60.0)
    exact = ar.remesh((points, faces), options.points, feature_angle=60.0, normals=normals)
    captions = []
    for name, result in (("estimated", estimated), ("given", exact)):
        captions.append(f"normals {name}: {error_of(result):.1f} degrees off")
    print("\n".join(captions))
    if options.picture:
        import panels
        lit = [shapes.surface(*result.mesh, result.point_data["Normals"])
               for result in (estimated, exact)]
        panels.draw(options, [
            panels.mesh((points, faces), f"from a CAD program: {len(faces)} triangles"),
            *(panels.smooth(mesh, caption) for mesh, caption in zip(lit, captions))],
            view=(0.6, -1.0, 0.8), size=(420, 320))


if __name__ == "__main__":
    main(shapes.options(__doc__, 800))
