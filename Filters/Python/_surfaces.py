"""Surfaces in and out: VTK, PyVista, numpy, trimesh, meshio, files."""
from __future__ import annotations

import contextlib
import importlib
import os
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Tuple

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkDataObject,
    vtkDataSet,
    vtkPolyData,
    vtkTable,
)
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkAlgorithmOutput

from ._messages import Messages, RemeshingError


class Taken(NamedTuple):
    """A surface as VTK data, and how results are given back."""

    data: Any
    like: str  # "vtk", "pyvista", "numpy", "trimesh" or "meshio"


# --- In -------------------------------------------------------------------------------------------
def take(surface: Any, name: str = "surface") -> Taken:
    """The surface as VTK data; numpy arrays are copied, VTK's are not."""
    taken = _take_data(surface) or _take_arrays(surface, name)
    data = taken.data
    if hasattr(data, "GetNumberOfPoints") and data.GetNumberOfPoints() == 0:
        raise RemeshingError(f"{name} is empty: it has no points.")
    return taken


def _take_data(surface: Any) -> Optional[Taken]:
    """What is, or comes as, VTK data."""
    if isinstance(surface, vtkDataObject):
        return Taken(surface, "pyvista" if _is_of(surface, "pyvista") else "vtk")
    if isinstance(surface, vtkAlgorithm):
        return Taken(_output_of(surface, 0), "vtk")
    if isinstance(surface, vtkAlgorithmOutput):
        return Taken(_output_of(surface.GetProducer(), surface.GetIndex()), "vtk")
    if isinstance(surface, (str, os.PathLike)):
        return Taken(read(surface), "vtk")
    return surface._taken() if hasattr(surface, "_taken") else None  # a result of this package


def _output_of(algorithm: Any, port: int) -> Any:
    with Messages(algorithm, algorithm.GetExecutive()) as messages:
        algorithm.Update(port)
    messages.tell()
    return algorithm.GetOutputDataObject(port)


def _take_arrays(surface: Any, name: str) -> Taken:
    if isinstance(surface, (tuple, list)) and len(surface) == 2:
        return Taken(make_surface(surface[0], surface[1], name), "numpy")
    points = getattr(surface, "vertices", getattr(surface, "points", None))
    faces = getattr(surface, "faces", None)
    if faces is None and hasattr(surface, "cells"):
        faces = _faces_of_blocks(surface.cells)
    if points is None or faces is None:
        raise TypeError(
            f"{name} must be VTK data, a PyVista mesh, (points, triangles), an object with points "
            f"and faces, or the path of a file; not {type(surface).__name__}."
        )
    like = next((kind for kind in ("trimesh", "meshio") if _is_of(surface, kind)), "numpy")
    return Taken(make_surface(points, faces, name), like)


def _is_of(value: Any, package: str) -> bool:
    return any(base.__module__.partition(".")[0] == package for base in type(value).__mro__)


def _faces_of_blocks(blocks: Any) -> Any:
    """meshio's cells: those that are polygons, as one list."""
    sizes = {"triangle": 3, "quad": 4, "polygon": 0}
    faces: List[Any] = []
    for block in blocks:
        if str(block.type).rstrip("0123456789") in sizes:
            faces.append(numpy.asarray(block.data))
    if len(faces) == 1:
        return faces[0]
    return [face for part in faces for face in part] if faces else None


def make_points(points: Any, name: str) -> Any:
    """vtkPoints from (n, 3) numbers: float32 stays, all else becomes float64."""
    array = numpy.asarray(points)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name}: points must have the shape (n, 3), not {array.shape}.")
    if array.dtype not in (numpy.float32, numpy.float64):
        array = array.astype(float)
    made = vtkPoints()
    made.SetData(numpy_to_vtk(numpy.ascontiguousarray(array), deep=True))
    return made


def make_surface(points: Any, faces: Any, name: str = "surface") -> Any:
    """
    vtkPolyData from points (n, 3) and faces: (m, 3) or (m, k) indices, a list of lists of indices,
    or one row of numbers in which each face's follow their count, as in PyVista.
    """
    surface = vtkPolyData()
    surface.SetPoints(make_points(points, name))
    offsets, corners = _rows(faces, name)
    if corners.size and not 0 <= corners.min() <= corners.max() < surface.GetNumberOfPoints():
        raise ValueError(
            f"{name}: triangles name points {corners.min()} to {corners.max()}, but there are "
            f"{surface.GetNumberOfPoints()} points (0 to {surface.GetNumberOfPoints() - 1})."
        )
    cells = vtkCellArray()
    cells.SetData(
        numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(corners, deep=True)
    )
    surface.SetPolys(cells)
    return surface


def _rows(faces: Any, name: str) -> Tuple[Any, Any]:
    """(offsets, corners) of faces, as VTK has them."""
    try:
        array = numpy.asarray(faces)
        if array.dtype == object:
            raise ValueError
    except ValueError:  # faces of several sizes
        lists = [numpy.asarray(face, dtype=numpy.int64).ravel() for face in faces]
        sizes = numpy.array([len(face) for face in lists], dtype=numpy.int64)
        corners = numpy.concatenate(lists) if lists else numpy.empty(0, numpy.int64)
        return numpy.append(0, numpy.cumsum(sizes)), corners
    if array.size == 0:
        return numpy.zeros(1, numpy.int64), numpy.empty(0, numpy.int64)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name}: triangles must be integers, not {array.dtype}.")
    array = numpy.ascontiguousarray(array, dtype=numpy.int64)
    if array.ndim == 1:
        return _counted_rows(array, name)
    if array.ndim != 2 or array.shape[1] < 3:
        raise ValueError(f"{name}: triangles must have the shape (m, 3), not {array.shape}.")
    return numpy.arange(0, array.size + 1, array.shape[1], dtype=numpy.int64), array.ravel()


def _counted_rows(array: Any, name: str) -> Tuple[Any, Any]:
    starts = []
    at = 0
    while at < array.size:
        starts.append(at)
        at += max(int(array[at]), 0) + 1
    if at != array.size:
        raise ValueError(f"{name}: faces in one row must be counts, each with as many indices.")
    kept = numpy.ones(array.size, dtype=bool)
    kept[starts] = False
    return numpy.append(0, numpy.cumsum(array[starts])), array[kept]


def take_points(points: Any, name: str) -> Any:
    """Points as VTK data: VTK, PyVista, (k, 3) numbers, a path, or a result with sites."""
    if isinstance(points, vtkDataObject):
        return points
    if isinstance(points, (str, os.PathLike)):
        return read(points)
    if hasattr(points, "_sites"):
        return points._sites()
    made = vtkPolyData()
    made.SetPoints(make_points(points, name))
    return made


def with_array(data: Any, values: Any, name: str, argument: str, of_cells: bool = False) -> Any:
    """
    A shallow copy of the data with an array more: `values` has a row for each point (or cell).
    """
    if not isinstance(data, vtkDataSet):
        raise TypeError(f"{argument}: give the array's name; {data.GetClassName()} has blocks.")
    count = data.GetNumberOfCells() if of_cells else data.GetNumberOfPoints()
    array = numpy.asarray(values)
    if array.ndim not in (1, 2) or len(array) != count:
        raise ValueError(
            f"{argument} must have a row for each of the {count} "
            f"{'cells' if of_cells else 'points'}, not the shape {array.shape}."
        )
    if array.dtype == bool:
        array = array.astype(numpy.uint8)
    if array.dtype.kind not in "iuf":
        raise TypeError(f"{argument} must be numbers, not {array.dtype}.")
    copy = data.NewInstance() if type(data).__module__.startswith("vtk") else vtkPolyData()
    copy.ShallowCopy(data)
    added = numpy_to_vtk(numpy.ascontiguousarray(array), deep=True)
    added.SetName(name)
    (copy.GetCellData() if of_cells else copy.GetPointData()).AddArray(added)
    return copy


# --- Files ----------------------------------------------------------------------------------------
# Of each ending: the VTK module, its reader and its writer.
_FORMATS: Dict[str, Tuple[str, str, Optional[str]]] = {
    ".ply": ("vtkIOPLY", "vtkPLYReader", "vtkPLYWriter"),
    ".stl": ("vtkIOGeometry", "vtkSTLReader", "vtkSTLWriter"),
    ".obj": ("vtkIOGeometry", "vtkOBJReader", "vtkOBJWriter"),
    ".vtp": ("vtkIOXML", "vtkXMLPolyDataReader", "vtkXMLPolyDataWriter"),
    ".vtu": ("vtkIOXML", "vtkXMLUnstructuredGridReader", None),
    ".vtm": ("vtkIOXML", "vtkXMLMultiBlockDataReader", "vtkXMLMultiBlockDataWriter"),
    ".vtk": ("vtkIOLegacy", "vtkPolyDataReader", "vtkPolyDataWriter"),
}


def _make(path: str, what: int, verb: str) -> Any:
    """A reader (1) or writer (2) for files of the kind that a name tells."""
    names = _FORMATS.get(os.path.splitext(path)[1].lower())
    if names is None or names[what] is None:
        endings = [ending for ending, found in _FORMATS.items() if found[what]]
        raise ValueError(
            f"'{path}' cannot be {verb}: its name must end in "
            f"{', '.join(endings[:-1])} or {endings[-1]}."
        )
    module = importlib.import_module("vtkmodules." + names[0])
    return getattr(module, str(names[what]))()


def read(path: Any) -> Any:
    """The surface in a file: PLY, STL, OBJ, VTP, VTU, VTM or legacy VTK."""
    path = os.fspath(path)
    with open(path, "rb"):  # FileNotFoundError and its like, before VTK is asked
        pass
    reader = _make(path, 1, "read")
    reader.SetFileName(path)
    with Messages(reader, reader.GetExecutive()) as messages:
        reader.Update()
    data = reader.GetOutputDataObject(0)
    if messages.errors or messages.failed:
        why = "".join(messages.errors[:1]) or f"it is no {os.path.splitext(path)[1][1:]} file."
        raise RemeshingError(f"'{path}' cannot be read: {why}")
    if isinstance(data, vtkDataSet) and data.GetNumberOfCells() == 0:
        raise RemeshingError(f"'{path}' holds no surface.")
    return data


def write(data: Any, path: Any) -> None:
    """
    Writes a mesh to a file of the kind that its name tells; VTP holds all arrays. The file is there
    once it is whole.
    """
    path = os.fspath(path)
    writer = _make(path, 2, "written")
    draft = f"{path}.{os.getpid()}{os.path.splitext(path)[1].lower()}"
    writer.SetFileName(draft)
    for option in ("SetDataModeToBinary", "SetFileTypeToBinary"):
        if hasattr(writer, option):
            getattr(writer, option)()
    writer.SetInputDataObject(data)
    try:
        try:
            with open(draft, "wb"):  # PermissionError and its like, before VTK is asked
                pass
        except OSError as error:  # of the file that was asked for
            raise type(error)(error.errno, error.strerror, path) from None
        with Messages(writer, writer.GetExecutive()) as messages:
            done = writer.Write()
        if not done or messages.errors or writer.GetErrorCode():
            why = "".join(messages.errors[:1]) or "is the disk full?"
            raise OSError(f"'{path}' cannot be written: {why}")
        os.replace(draft, path)
    finally:
        with contextlib.suppress(FileNotFoundError):
            os.remove(draft)


# --- Out ------------------------------------------------------------------------------------------
def view_of(array: Any) -> numpy.ndarray[Any, Any]:
    """A view of a VTK array, which it keeps alive."""
    view: numpy.ndarray[Any, Any] = vtk_to_numpy(array)
    return view


def points_of(data: Any) -> numpy.ndarray[Any, Any]:
    """(n, 3) view of a data set's points."""
    points = data.GetPoints()
    return view_of(points.GetData()) if points else numpy.empty((0, 3))


def corners_of(cells: Any) -> numpy.ndarray[Any, Any]:
    """A view of the indices of points of a vtkCellArray's cells, one after the other."""
    return view_of(cells.GetConnectivityArray())


def triangles_of(data: Any) -> numpy.ndarray[Any, Any]:
    """(m, 3) view of the triangles of a mesh of triangles alone."""
    return corners_of(data.GetPolys()).reshape(-1, 3)


def arrays_of(attributes: Any) -> Dict[str, Any]:
    """Views of the named arrays of points, cells, rows or a field; strings as lists."""
    found: Dict[str, Any] = {}
    for index in range(attributes.GetNumberOfArrays()):
        array = attributes.GetAbstractArray(index)
        if array.IsNumeric():
            found[array.GetName()] = view_of(array)
        else:
            found[array.GetName()] = [
                array.GetValue(k) for k in range(array.GetNumberOfValues())
            ]
    return found


def _numpy_mesh(mesh: Any) -> Any:
    return points_of(mesh), triangles_of(mesh)


def _numpy_polygons(data: Any) -> Any:
    offsets = view_of(data.GetPolys().GetOffsetsArray())
    return points_of(data), numpy.split(corners_of(data.GetPolys()), offsets[1:-1])


def _numpy_lines(data: Any) -> Any:
    return points_of(data), corners_of(data.GetLines()).reshape(-1, 2)


def _numpy_table(table: Any) -> Any:
    return arrays_of(table.GetRowData())


_NUMPY: Dict[str, Callable[[Any], Any]] = {
    "mesh": _numpy_mesh,
    "cells": _numpy_polygons,
    "sites": points_of,
    "edges": _numpy_lines,
    "table": _numpy_table,
}


def give(data: Any, like: str, role: str) -> Any:
    """Data as the surface was put in; `role` is mesh, cells, sites, edges or table."""
    if like == "vtk" or (like != "pyvista" and not isinstance(data, (vtkPolyData, vtkTable))):
        return data
    if like == "pyvista":
        import pyvista

        return pyvista.wrap(data)
    if role == "mesh" and like == "trimesh":
        import trimesh

        points, triangles = _numpy_mesh(data)
        return trimesh.Trimesh(vertices=points, faces=triangles, process=False)
    if role == "mesh" and like == "meshio":
        import meshio

        points, triangles = _numpy_mesh(data)
        return meshio.Mesh(
            points,
            [("triangle", triangles)],
            point_data=arrays_of(data.GetPointData()),
            cell_data={name: [v] for name, v in arrays_of(data.GetCellData()).items()},
        )
    return _NUMPY[role](data)
