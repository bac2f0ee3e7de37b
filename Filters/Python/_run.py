"""Sets a filter up from arguments and runs it."""
from __future__ import annotations

import threading
import time
from typing import Any, Dict, List, Mapping, Sequence, Tuple

import numpy

from . import _execution, _surfaces
from ._messages import Messages, logger
from ._progress import Progress, Reporter

# vtkSMPTools' settings are those of the process: runs of several threads take turns.
_turn = threading.RLock()

#: Arguments and the properties that they set as they are.
PROPERTIES = {
    "points": "NumberOfPoints",
    "tolerance": "DistanceTolerance",
    "tolerance_is_absolute": "DistanceToleranceIsAbsolute",
    "maximum_points": "MaximumNumberOfPoints",
    "features": "PreserveFeatures",
    "feature_angle": "FeatureAngle",
    "coarse_start": "CoarseStart",
    "seed": "Seed",
    "lloyd_iterations": "NumberOfLloydIterations",
    "newton_iterations": "NumberOfNewtonIterations",
    "history_length": "HistoryLength",
    "gradient_tolerance": "GradientTolerance",
    "energy_tolerance": "EnergyTolerance",
    "cells": "GenerateVoronoiCells",
    "edges": "GenerateEdges",
    "measure_distance": "MeasureDistance",
    "maximum_cell_embedding_dimension": "MaximumCellEmbeddingDimension",
    "anisotropy": "Anisotropy",
    "estimate_normals": "EstimateNormals",
    "normal_smoothing_passes": "NormalSmoothingPasses",
    "normal_smoothing_radius": "NormalSmoothingRadius",
    "merge_tolerance": "MergeTolerance",
    "metric_dimension": "MetricDimension",
    "limit_metric": "LimitMetric",
    "metric_growth": "MetricGrowth",
    "unit": "UnitEdges",
    "complexity": "MetricComplexity",
    "threads": "NumberOfThreads",
    "distribute_outputs": "DistributeOutputs",
    "samples": "NumberOfSamples",
    "bound_maximum_distance": "BoundMaximumDistance",
    "bins": "NumberOfBins",
    "minimum_size": "MinimumSize",
    "maximum_size": "MaximumSize",
    "maximum_ratio": "MaximumRatio",
    "chord_tolerance": "ChordTolerance",
    "distance_size": "DistanceSize",
    "distance_growth": "DistanceGrowth",
    "dimension": "Dimension",
    "refine": "Refine",
    "iterations": "NumberOfIterations",
    "time": "DiffusionTime",
}

#: Arguments that are words, their properties, and the values.
CHOICES: Dict[str, Tuple[str, Tuple[str, ...]]] = {
    "sampling": ("SamplingMethod", ("random", "stratified")),
    "vertex_placement": ("VertexPlacement", ("centroid", "surface_point", "quadric", "fit")),
    "embedding_mode": ("EmbeddingMode", ("position", "gauss_map")),
    "metric_order": ("MetricOrder", ("vtk", "rows", "sol")),
    "scaling": ("Scaling", ("none", "commute_time", "diffusion", "biharmonic")),
    "mass": ("MassMatrix", ("lumped", "consistent")),
    "border": ("BorderCondition", ("natural", "fixed")),
    "norm": ("ErrorNorm", ("l1", "l2", "l4", "maximum")),
    "backend": ("SMPBackend", ("automatic", "sequential", "stdthread", "tbb")),
}


def set_property(algorithm: Any, argument: str, value: Any) -> None:
    """Sets the property of an argument; what is out of its range is told by the filter."""
    if argument in CHOICES:
        name, words = CHOICES[argument]
        if value not in words:
            raise ValueError(f"{argument} must be one of {', '.join(words)}; not {value!r}.")
        value = words.index(value)
    elif argument == "maximum_extra_points":
        name = "MaximumNumberOfExtraPoints"
        value = {None: -2, float("inf"): -1}.get(value, value)
    else:
        name = PROPERTIES[argument]
    try:
        getattr(algorithm, "Set" + name)(value)
    except OverflowError:
        raise ValueError(f"{argument} is out of range: {value!r}.") from None
    except TypeError:
        whole = isinstance(getattr(algorithm, "Get" + name)(), int)
        kind = "a whole number" if whole else "a number"
        raise TypeError(f"{argument} must be {kind}, not {value!r}.") from None


def set_properties(algorithm: Any, arguments: Mapping[str, Any]) -> None:
    for argument, value in arguments.items():
        set_property(algorithm, argument, value)


class Input:
    """The surface of a run, with the arrays that are given as arguments."""

    def __init__(self, surface: Any) -> None:
        self.data, self.like = _surfaces.take(surface)

    def array(self, argument: str, value: Any, name: str, of_cells: bool = False) -> str:
        """The name of an array that is given by its name, or as numbers."""
        if isinstance(value, str):
            return value
        self.data = _surfaces.with_array(self.data, value, name, argument, of_cells)
        return name


def choose_arrays(algorithm: Any, surface: Input, arrays: Mapping[str, Any]) -> None:
    """The arrays of the filters on embedded surfaces."""
    normals = arrays.get("normals")
    if normals is not None:
        name = surface.array("normals", normals, "Given normals")
        algorithm.SetInputArrayToProcess(0, 0, 0, 0, name)
    embedding = arrays.get("embedding")
    if embedding is not None:
        algorithm.SetEmbeddingArray(surface.array("embedding", embedding, "Given embedding"))
    metric = arrays.get("metric")
    if metric is not None:
        algorithm.SetMetricArray(surface.array("metric", flat_tensors(metric), "Given metric"))
    for index, (array, scale) in enumerate(_pairs(arrays.get("coordinates"))):
        name = surface.array("coordinates", array, f"Given coordinates {index}")
        algorithm.AddCoordinateArray(name, scale)
    density = arrays.get("density")
    if density is not None:
        algorithm.SetDensityArray(surface.array("density", density, "Given density"))
    labels = arrays.get("feature_labels")
    if labels is not None:
        name = surface.array("feature_labels", labels, "Given labels", of_cells=True)
        algorithm.SetFeatureLabelArray(name)
    seams = arrays.get("seams", "automatic")
    if seams is None:
        algorithm.SetSeamArray("None")
    elif not (isinstance(seams, str) and seams == "automatic"):
        algorithm.SetSeamArray(surface.array("seams", seams, "Given seams"))


def flat_tensors(metric: Any) -> Any:
    """Tensors (n, 3, 3) as rows (n, 9)."""
    if isinstance(metric, str):
        return metric
    values = numpy.asarray(metric)
    return values.reshape(len(values), 9) if values.ndim == 3 and values[0].size == 9 else values


def _pairs(coordinates: Any) -> Sequence[Tuple[Any, float]]:
    if coordinates is None:
        return ()
    if isinstance(coordinates, Mapping):
        return list(coordinates.items())
    try:
        return [(array, float(scale)) for array, scale in coordinates]
    except (TypeError, ValueError):
        raise TypeError(
            "coordinates must be a dict {name: scale}, or pairs (name or array, scale)."
        ) from None


def update(algorithm: Any, progress: Progress, what: str) -> Tuple[List[str], float]:
    """
    Runs a filter; returns its warnings, which are also Python's, and the seconds. Raises its error,
    what `progress` raised, or what the handler of a signal raised.
    """
    start = time.perf_counter()
    reporter = Reporter(algorithm, progress)
    messages = Messages(algorithm, algorithm.GetExecutive())
    logger.info("%s: started", what)
    with _turn, messages, reporter:
        _execution.update(algorithm)
    if reporter.error is not None:
        raise reporter.error
    seconds = time.perf_counter() - start
    messages.tell()
    logger.info("%s: done in %.2f s", what, seconds)
    return messages.warnings, seconds


def outputs_of(algorithm: Any) -> List[Any]:
    return [
        algorithm.GetOutputDataObject(port) for port in range(algorithm.GetNumberOfOutputPorts())
    ]


def run_alone(
    algorithm: Any, taken: Input, progress: Progress, what: str
) -> Tuple[List[Any], Any, Dict[str, Any]]:
    """
    Runs a filter of one input on the surface, as `update` does; returns the outputs, what the
    surface was given as, and a report.
    """
    algorithm.SetInputDataObject(0, taken.data)
    warnings, seconds = update(algorithm, progress, what)
    return outputs_of(algorithm), taken.like, {"warnings": warnings, "seconds": {"total": seconds}}
