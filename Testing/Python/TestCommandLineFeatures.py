"""Tests of remesh_surface: what it keeps of creases, borders, labels and topology.

    TestCommandLineFeatures.py --program build/bin/remesh_surface --work FOLDER [unittest options]

The surfaces are made of flat parts, so that lengths and areas are known.
"""
import json
import os

import numpy

from CommandLineTesting import CommandLineTest, main, read, write
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_POLYGON, vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource

CLOSE = 1e-9


def surface_of(points, polygons):
    surface = vtkPolyData()
    surface.SetPoints(vtkPoints())
    surface.GetPoints().SetDataTypeToDouble()
    for point in points:
        surface.GetPoints().InsertNextPoint(point)
    surface.SetPolys(vtkCellArray())
    for polygon in polygons:
        surface.InsertNextCell(VTK_POLYGON, len(polygon), polygon)
    return surface


def grid(columns, rows, place, closed=False):
    """Squares, placed at the points place(i, j); closed: as a ring in both directions."""
    wide, high = (columns, rows) if closed else (columns + 1, rows + 1)
    return surface_of([place(i, j) for j in range(high) for i in range(wide)],
                      [[(i + a) % wide + (j + b) % high * wide
                        for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
                       for j in range(rows) for i in range(columns)])


def cube():
    source = vtkCubeSource()  # of side 1, around the origin
    source.Update()
    surface = vtkPolyData()
    surface.CopyStructure(source.GetOutput())  # without its normals
    return surface


def roof(degrees):
    """Two rectangles of size 1 x 2 that meet along x = 0, bent there by an angle."""
    angle = numpy.radians(degrees)
    ends = [(-1.0, 0.0), (0.0, 0.0), (numpy.cos(angle), -numpy.sin(angle))]
    return grid(2, 1, lambda i, j: (ends[i][0], 2.0 * j, ends[i][1]))


def plate():
    """The rectangle of size 2 x 1 around the origin; Part is 7 for x > 0.25, else -1."""
    surface = grid(8, 4, lambda i, j: (i / 4 - 1, j / 4 - 0.5, 0.0))
    part = numpy_to_vtk(numpy.tile([-1] * 5 + [7] * 3, 4), deep=True)
    part.SetName("Part")
    surface.GetCellData().AddArray(part)
    return surface


def torus():
    def place(i, j):
        around, across = 2 * numpy.pi * i / 36, 2 * numpy.pi * j / 18
        radius = 1 + 0.4 * numpy.cos(across)
        return radius * numpy.cos(around), radius * numpy.sin(around), 0.4 * numpy.sin(across)
    return grid(36, 18, place, closed=True)


def triangles_of(mesh):
    """The coordinates of each triangle's corners: triangle, corner, axis."""
    ids = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return vtk_to_numpy(mesh.GetPoints().GetData())[ids]


def edges_of(mesh):
    """The ids of each edge's two ends, once for each edge."""
    ids = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    edges = numpy.concatenate([ids[:, [0, 1]], ids[:, [1, 2]], ids[:, [2, 0]]])
    return numpy.unique(numpy.sort(edges, axis=1), axis=0)


def length_where(mesh, is_inside):
    """Length of the mesh's edges whose ends and middle all are where `is_inside` holds."""
    ends = vtk_to_numpy(mesh.GetPoints().GetData())[edges_of(mesh)]
    chosen = is_inside(ends[:, 0]) & is_inside(ends[:, 1]) & is_inside(ends.mean(axis=1))
    return numpy.linalg.norm(ends[chosen, 1] - ends[chosen, 0], axis=1).sum()


def area_of(mesh):
    corners = triangles_of(mesh)
    sides = corners[:, 1:] - corners[:, :1]
    return 0.5 * numpy.linalg.norm(numpy.cross(sides[:, 0], sides[:, 1]), axis=1).sum()


def number_across(mesh, x):
    """How many triangles have corners on both sides of the plane at x."""
    offset = triangles_of(mesh)[:, :, 0] - x
    return ((offset.min(axis=1) < -CLOSE) & (offset.max(axis=1) > CLOSE)).sum()


class TestFeatures(CommandLineTest):
    def remesh(self, surface, *options):
        """The mesh of a surface, and the report."""
        write(surface, self.path("surface.vtp"))
        self.succeed("surface.vtp", "out.vtp", "--report", "r.json", *options)
        with open(self.path("r.json"), encoding="utf-8") as file:
            return read(self.path("out.vtp")), json.load(file)

    def test_no_features(self):
        def on_crease(points):
            return (abs(abs(points) - 0.5) < CLOSE).sum(axis=1) >= 2
        kept, report = self.remesh(cube(), "--points", "200")
        self.assertIs(report["parameters"]["features"], True)
        self.assertAlmostEqual(length_where(kept, on_crease), 12.0, delta=CLOSE)
        self.assertAlmostEqual(area_of(kept), 6.0, delta=CLOSE)
        cut, report = self.remesh(cube(), "--points", "200", "--no-features")
        self.assertIs(report["parameters"]["features"], False)
        self.assertLess(length_where(cut, on_crease), 1.0)
        self.assertLess(area_of(cut), 5.999)

    def test_no_features_at_borders(self):
        kept, _ = self.remesh(plate(), "--points", "100")
        self.assertAlmostEqual(area_of(kept), 2.0, delta=CLOSE)
        shrunk, _ = self.remesh(plate(), "--points", "100", "--no-features")
        self.assertLess(area_of(shrunk), 1.9)

    def test_feature_angle(self):
        def on_ridge(points):
            return abs(points[:, 0]) < CLOSE
        for degrees, options, kept in ((45, [], True), (45, ["--feature-angle", "44"], True),
                                       (45, ["--feature-angle", "46"], False),
                                       (45, ["--feature-angle", "60"], False), (30, [], False),
                                       (30, ["--feature-angle", "29"], True)):
            with self.subTest(degrees=degrees, options=options):
                mesh, report = self.remesh(roof(degrees), "--points", "150",
                                           "--placement", "centroid", *options)
                expected = float(options[1]) if options else 35
                self.assertEqual(report["parameters"]["feature_angle"], expected)
                self.assertEqual(number_across(mesh, 0) == 0, kept)
                self.assertEqual(abs(length_where(mesh, on_ridge) - 2.0) < CLOSE, kept)

    def test_labels(self):
        def on_border(points):
            return abs(points[:, 0] - 0.25) < CLOSE
        for options, kept in ((["--labels", "Part"], True), ([], False),
                              (["--labels", "Part", "--no-features"], False)):
            with self.subTest(options=options):
                mesh, report = self.remesh(plate(), "--points", "150", *options)
                self.assertEqual(report["parameters"]["labels"], "Part" if options else "")
                self.assertEqual(number_across(mesh, 0.25) == 0, kept)
                self.assertEqual(abs(length_where(mesh, on_border) - 1.0) < CLOSE, kept)
        os.remove(self.path("out.vtp"))
        self.fail_with(1, "no cell array 'Foo'", "surface.vtp", "out.vtp", "--labels", "Foo")


class TestExtraPoints(CommandLineTest):
    def test_max_extra_points(self):
        # No torus has fewer than 7 points; four of them are asked for.
        write(torus(), self.path("torus.vtp"))
        for most, enough in (("0", False), ("1", False), ("200", True), ("-1", True),
                             ("-2", False)):
            with self.subTest(most=most):
                result = self.run_program("torus.vtp", "out.vtp", "--points", "4", "--report",
                                          "r.json", "--max-extra-points", most)
                self.assertEqual((result.returncode, result.stderr == ""), (0, enough))
                with open(self.path("r.json"), encoding="utf-8") as file:
                    report = json.load(file)
                self.assertEqual(report["parameters"]["max_extra_points"], int(most))
                mesh = read(self.path("out.vtp"))
                points = mesh.GetNumberOfPoints()
                extra = mesh.GetFieldData().GetArray("NumberOfExtraPoints").GetTuple1(0)
                self.assertEqual((report["output"]["points"], report["output"]["extra_points"],
                                  extra), (points, points - 4, points - 4))
                self.assertEqual(report["topology"]["preserved"], int(enough))
                self.assertEqual(report["topology"]["report"] == "", enough)
                if enough:
                    self.assertGreaterEqual(points, 7)
                    self.assertLess(points, 100)
                    self.assertEqual(points - len(edges_of(mesh)) + mesh.GetNumberOfPolys(), 0)
                else:  # one percent of 4 is none
                    self.assertTrue(4 <= points <= 4 + max(int(most), 0), points)


if __name__ == "__main__":
    main()
