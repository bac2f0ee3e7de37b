"""Keeps the sharp edges of a part, or rounds them off.

    features.py [--points N] [--picture FILE.png]
"""
import anisotropic_remeshing as ar
import shapes


def main(options):
    surface = shapes.surface(*shapes.gear(steps=2))
    kept = ar.remesh(surface, options.points)
    cut = ar.remesh(surface, options.points, features=False)
    for name, result in (("kept", kept), ("not kept", cut)):
        print(f"features {name}: RMS distance {result.distance.rms:.2g}, "
              f"largest {result.distance.maximum:.2g}")
    if options.picture:
        import panels
        panels.draw(options, [
            panels.mesh(surface, f"from a CAD program: {surface.GetNumberOfPolys()} triangles"),
            panels.mesh(kept.mesh, f"features kept: off by {kept.distance.maximum:.1g} at most"),
            panels.mesh(cut.mesh, f"not kept: off by {cut.distance.maximum:.1g} at most")],
            view=(0.5, -1.0, 1.1))


if __name__ == "__main__":
    main(shapes.options(__doc__, 500))
