"""Results of the package's functions."""
from __future__ import annotations

from typing import Any, Dict, List, NamedTuple, Optional

import numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

from . import _surfaces
from ._surfaces import Taken


class Distance(NamedTuple):
    """How far a mesh and a surface are from each other, both ways, in the unit of the points."""

    #: root of the mean of both mean squares
    rms: float
    #: the largest found; with a tolerance, or from `compare`, see there for a bound
    maximum: float


def _number(value: Any) -> Any:
    """A Python number (or list of them) from an array's values."""
    if isinstance(value, list):
        return value[0] if len(value) == 1 else value
    return value.item() if value.size == 1 else value.tolist()


def snake_case(name: str) -> str:
    """NumberOfPoints, RMSDistance -> number_of_points, rms_distance."""
    spelled = ""
    for k, letter in enumerate(name):
        starts = letter.isupper() and k > 0
        after_small = starts and name[k - 1].islower()
        before_small = starts and name[k - 1].isupper() and name[k + 1 : k + 2].islower()
        spelled += ("_" if after_small or before_small else "") + letter.lower()
    return spelled


class _Result:
    """Data of one kind of input, and facts."""

    def __init__(self, outputs: List[Any], like: str, report: Dict[str, Any]) -> None:
        self._outputs = outputs
        self._like = like
        self._given: Dict[int, Any] = {}
        #: Facts about the run: a dict with names like `topology_preserved`.
        self.report = report

    def _give(self, port: int, role: str) -> Any:
        if port not in self._given:
            self._given[port] = _surfaces.give(self._outputs[port], self._like, role)
        return self._given[port]

    def _taken(self) -> Taken:
        return Taken(self._outputs[0], self._like)

    def _plain(self) -> Any:
        data = self._outputs[0]
        if not isinstance(data, vtkPolyData):
            raise TypeError(f"The result is a {data.GetClassName()}: take its blocks' arrays.")
        return data

    @property
    def points(self) -> numpy.ndarray[Any, Any]:
        """(n, 3) numpy view of the points, space of the surface. No copy; changes are seen."""
        return _surfaces.points_of(self._plain())

    @property
    def triangles(self) -> numpy.ndarray[Any, Any]:
        """(m, 3) numpy view of the triangles: indices of points, 64 or 32 bits. No copy."""
        return _surfaces.triangles_of(self._plain())

    @property
    def point_data(self) -> Dict[str, Any]:
        """Numpy views of the point arrays by name: (n,) or (n, k). Strings are lists."""
        return _surfaces.arrays_of(self._plain().GetPointData())

    @property
    def cell_data(self) -> Dict[str, Any]:
        """Numpy views of the arrays of triangles by name: (m,) or (m, k). Strings are lists."""
        return _surfaces.arrays_of(self._plain().GetCellData())

    def save(self, path: Any) -> None:
        """
        Writes the mesh: .vtp (with all arrays), .vtk, .ply, .stl or .obj. Raises OSError where
        that fails, ValueError for another ending.
        """
        _surfaces.write(self._outputs[0], path)

    def _facts(self) -> Dict[str, str]:
        raise NotImplementedError

    def _repr_html_(self) -> str:
        from ._pictures import html_of

        return html_of(type(self).__name__, self._outputs[0], self._facts())

    def __repr__(self) -> str:
        facts = ", ".join(f"{name} {value}" for name, value in self._facts().items())
        return f"<{type(self).__name__}: {facts}>"

    def _size(self) -> Dict[str, str]:
        data = self._outputs[0]
        if not isinstance(data, vtkPolyData):
            return {"blocks": str(data.GetNumberOfBlocks())} if hasattr(
                data, "GetNumberOfBlocks"
            ) else {"type": data.GetClassName()}
        return {
            "points": f"{data.GetNumberOfPoints()}",
            "triangles": f"{data.GetNumberOfPolys()}",
        }


class Diagram(_Result):
    """
    A restricted Voronoi diagram and its dual, the mesh; from `voronoi`.

    `mesh`, `cells`, `sites`, `edges` and `convergence` are of the kind that was put in:

    - VTK data, or a path: vtkPolyData, vtkTable (of composite data: the same structure)
    - PyVista: PyVista's PolyData and Table
    - arrays, trimesh, meshio: numpy arrays as told below; `mesh` a Trimesh or meshio.Mesh
    """

    @property
    def mesh(self) -> Any:
        """The triangles; of arrays, (points (n, 3), triangles (m, 3))."""
        return self._give(0, "mesh")

    @property
    def cells(self) -> Any:
        """
        The Voronoi cells, as convex polygons, one for each triangle of the surface and site; of
        arrays, (points (p, 3), list of arrays of indices).
        """
        return self._give(1, "cells")

    @property
    def sites(self) -> Any:
        """The sites, in the middle of their cells; of arrays, points (k, 3)."""
        return self._give(2, "sites")

    @property
    def convergence(self) -> Any:
        """
        Iteration, Energy, GradientNorm, StepLength, Seconds for each step; of arrays, a dict of
        arrays (steps,).
        """
        return self._give(3, "table")

    @property
    def edges(self) -> Any:
        """
        Edges of the cells, features and borders, as lines; of arrays, (points (p, 3), lines (l,
        2)).
        """
        return self._give(4, "edges")

    @property
    def topology_preserved(self) -> bool:
        """Whether the mesh is proven to have the topology of the surface."""
        return bool(self.report.get("topology_preserved", False))

    @property
    def distance(self) -> Optional[Distance]:
        """
        How far mesh and surface are from each other, in the unit of the points; None where that was
        not measured. With a tolerance `maximum` is a bound that no point passes.
        """
        if "rms_distance" not in self.report:
            return None
        return Distance(self.report["rms_distance"], self.report["maximum_distance"])

    def _sites(self) -> Any:
        return self._outputs[2]

    def _facts(self) -> Dict[str, str]:
        facts = self._size()
        facts["topology"] = "preserved" if self.topology_preserved else "not proven"
        if self.distance:
            facts["RMS distance"] = f"{self.distance.rms:.3g}"
            facts["largest"] = f"{self.distance.maximum:.3g}"
        return facts


class Remeshed(Diagram):
    """
    A new mesh of a surface, from `remesh`, with the Voronoi diagram that it is the dual of.

    See `Diagram` for `mesh`, `cells`, `sites`, `edges` and `convergence`; `points` and `triangles`
    are numpy views of the mesh in any case. In a notebook it shows itself.
    """


class Compared(_Result):
    """How good a mesh is, alone and against a surface; from `compare`."""

    @property
    def mesh(self) -> Any:
        """
        The mesh with arrays that tell where it is good: of triangles `Quality`, `MinimumAngle`
        (degrees), with a surface `NormalDeviation`, and of points `Distance`, `SignedDistance`.
        """
        return self._give(0, "mesh")

    @property
    def surface(self) -> Any:
        """The surface with its points' `Distance` to the mesh; None without a surface."""
        if "rms_distance" not in self.report:
            return None
        return self._give(1, "cells")

    @property
    def summary(self) -> Dict[str, Any]:
        """The numbers by name: `rms_distance`, `minimum_quality`, `number_of_components` ..."""
        return self.report

    @property
    def histograms(self) -> Any:
        """Histograms of quality, angles and deviation; of arrays, a dict of arrays (bins,)."""
        return self._give(3, "table")

    @property
    def distance(self) -> Optional[Distance]:
        """How far mesh and surface are from each other; None without a surface."""
        if "rms_distance" not in self.report:
            return None
        return Distance(self.report["rms_distance"], self.report["maximum_distance"])

    def _facts(self) -> Dict[str, str]:
        facts = self._size()
        if self.distance:
            facts["RMS distance"] = f"{self.distance.rms:.3g}"
            facts["largest"] = f"{self.distance.maximum:.3g}"
        for name in ("mean_quality", "least_minimum_angle", "number_of_components"):
            facts[name.replace("_", " ")] = f"{self.report[name]:.4g}"
        return facts


class Embedded(_Result):
    """A surface with its embedding, from `embed`."""

    @property
    def surface(self) -> Any:
        """The surface as it was put in, with the point array `Embedding`."""
        return self._give(0, "cells")

    @property
    def embedding(self) -> numpy.ndarray[Any, Any]:
        """(n, d) numpy view, a row for each point of the surface: where it is in R^d."""
        return _surfaces.view_of(self._plain().GetPointData().GetArray("Embedding"))

    def _facts(self) -> Dict[str, str]:
        return {
            "points": str(self._plain().GetNumberOfPoints()),
            "dimension": str(self.embedding.shape[1]),
        }


class Spectrum(Embedded):
    """A surface with eigenfunctions of its Laplacian, from `spectral_embedding`."""

    @property
    def eigenvalues(self) -> numpy.ndarray[Any, Any]:
        """(d,) numpy view, ascending, in 1 / the square of the points' unit."""
        return _surfaces.view_of(self._plain().GetFieldData().GetArray("Eigenvalues"))


class MetricEmbedded(Embedded):
    """A surface with an embedding of a metric, from `metric_embedding`."""

    @property
    def surface(self) -> Any:
        """
        The surface in triangles, with the arrays `Embedding`, `LimitedMetric`, `LeastStretch` and
        `LargestStretch`. Its first points are those that were put in.
        """
        return self._give(0, "mesh")

    @property
    def metric(self) -> numpy.ndarray[Any, Any]:
        """(n, 6) numpy view, a tensor XX YY ZZ XY YZ XZ for each point: what was embedded."""
        return _surfaces.view_of(self._plain().GetPointData().GetArray("LimitedMetric"))

    @property
    def stretch(self) -> numpy.ndarray[Any, Any]:
        """
        (m, 2) numbers, for each triangle the lengths in R^d over those in the metric, where that is
        least and where it is largest.
        """
        data = self._plain().GetCellData()
        names = ("LeastStretch", "LargestStretch")
        return numpy.stack([_surfaces.view_of(data.GetArray(name)) for name in names], axis=1)

    @property
    def unit(self) -> float:
        """The length in the metric of the edges that it is for."""
        return self._fact("MetricUnit")

    @property
    def wanted_points(self) -> int:
        """How many points a mesh with such edges has."""
        return round(self._fact("MetricPoints"))

    @property
    def limit(self) -> float:
        """The largest factor by which a size of the metric was made smaller, from 1."""
        return self._fact("MetricLimit")

    @property
    def share(self) -> float:
        """The share of the area, in the metric, where that is met within a factor of sqrt 2."""
        return self._fact("MetricShare")

    def _fact(self, name: str) -> float:
        return float(self._plain().GetFieldData().GetArray(name).GetValue(0))

    def _facts(self) -> Dict[str, str]:
        return {**super()._facts(), "met on": f"{self.share:.1%}"}


class Metric(_Result):
    """A surface with a metric, from `metric_from_solution`."""

    @property
    def surface(self) -> Any:
        """The surface as it was put in, with the point array `Metric`."""
        return self._give(0, "cells")

    @property
    def metric(self) -> numpy.ndarray[Any, Any]:
        """(n, 6) numpy view, a tensor XX YY ZZ XY YZ XZ for each point of the surface."""
        return _surfaces.view_of(self._plain().GetPointData().GetArray("Metric"))

    @property
    def wanted_points(self) -> int:
        """How many points a mesh has whose edges have the length 1 in the metric."""
        return int(round(self._plain().GetFieldData().GetArray("MetricPoints").GetValue(0)))

    def _facts(self) -> Dict[str, str]:
        return {"points": str(self._plain().GetNumberOfPoints()), "asks for": str(self.wanted_points)}


def facts_of(field: Any, names: List[str]) -> Dict[str, Any]:
    """Those single values of field data that are there, in snake case."""
    facts: Dict[str, Any] = {}
    for name in names:
        array = field.GetAbstractArray(name)
        if array is not None and array.GetNumberOfValues() == 1:
            value = array.GetValue(0)
            facts[snake_case(name)] = bool(value) if name == "TopologyPreserved" else value
    return facts


def row_of(table: Any) -> Dict[str, Any]:
    """The first row of a table, in snake case."""
    columns = _surfaces.arrays_of(table.GetRowData())
    return {
        snake_case(name): _number(numpy.asarray(column)[:1])
        for name, column in columns.items()
        if len(column)
    }
