"""Functions that compute arrays for `remesh`: metrics, their embeddings, and eigenfunctions."""
from __future__ import annotations

from typing import Any, List

from ._progress import Progress
from ._results import Metric, MetricEmbedded, Spectrum
from ._run import Input, flat_tensors, run_alone, set_properties
from .vtkFiltersAnisotropicRemeshing import (
    vtkMetricEmbedding,
    vtkSolutionMetric,
    vtkSpectralEmbedding,
)


def _list(arrays: Any) -> List[Any]:
    """Arrays that are given one by one, or as a list."""
    if arrays is None:
        return []
    return list(arrays) if isinstance(arrays, (list, tuple)) else [arrays]


def metric_from_solution(
    surface: Any,
    arrays: Any = None,
    points: int = 10000,
    *,
    norm: str = "l2",
    hessians: Any = None,
    metrics: Any = None,
    metric_order: str = "vtk",
    minimum_size: float = 0.0,
    maximum_size: float = 0.0,
    maximum_ratio: float = 1000.0,
    chord_tolerance: float = 0.0,
    distance: Any = None,
    distance_size: float = 0.0,
    distance_growth: float = 0.2,
    threads: int = 0,
    backend: str = "automatic",
    distribute_outputs: bool = False,
    progress: Progress = None,
) -> Metric:
    """
    Computes the metric in which `remesh` makes the mesh with the least interpolation error.

        metric = metric_from_solution(surface, "Temperature", 5000).metric   # (n, 6)
        remesh(surface, 5000, metric=metric)

    Parameters
    ----------
    surface
        As for `remesh`.
    arrays : str, (n,) or (n, k) numbers, or a list of these
        Point arrays whose interpolation error is to be small; each counts as much, whatever its
        unit. Where nothing else is given either, the surface's active point scalars.
    points : int, from 1
        Points that the whole metric asks for, default 10000.
    norm : "l1", "l2", "l4" or "maximum"
        Of the error, default "l2". The lower, the more points go to weak bends.
    hessians : str, (n, 3, 3), (n, 9), (n, 6) or (n, 3) numbers, or a list of these
        Second derivatives of further functions, where they are known.
    metrics : the same, or (n,) sizes
        Metrics to intersect with, as they are: the shorter edges count, in each direction.
    metric_order : "vtk", "rows" or "sol"
        What 6 components of `hessians` and `metrics` are, as for `remesh`.
    minimum_size, maximum_size : float, from 0
        Limits of the edges' length, in the unit of the points; 0, default: none, and the diagonal of
        the bounding box.
    maximum_ratio : float, 1 to 1000000
        Of the lengths along and across a triangle, default 1000.
    chord_tolerance : float, from 0
        How far the middle of an edge may be from the surface's curve; 0, default: any.
    distance : str or (n,) numbers
        Edges get at most the length `distance_size + distance_growth * abs(distance)`.
    distance_size, distance_growth : float, from 0
        `distance_size` is above 0 where there is a distance; `distance_growth` is 0.2 by default.
    threads, backend, distribute_outputs, progress
        As for `remesh`.

    Returns
    -------
    Metric
        `metric` (n, 6), `surface` with it as the point array `Metric`, and `wanted_points`.

    Raises and warns as `remesh` does.

    Notes
    -----
    About a second for 100 000 points. Source: A. Loseille, F. Alauzet: Continuous mesh framework
    part I, SIAM Journal on Numerical Analysis 49, 2011.
    """
    taken = Input(surface)
    made = vtkSolutionMetric()
    for k, array in enumerate(_list(arrays)):
        made.AddSolutionArray(taken.array("arrays", array, f"Given solution {k}"))
    for k, array in enumerate(_list(hessians)):
        name = taken.array("hessians", flat_tensors(array), f"Given Hessian {k}")
        made.AddHessianArray(name)
    for k, array in enumerate(_list(metrics)):
        made.AddMetricArray(taken.array("metrics", flat_tensors(array), f"Given metric {k}"))
    if distance is not None:
        made.SetDistanceArray(taken.array("distance", distance, "Given distance"))
    set_properties(
        made,
        {
            "points": points,
            "norm": norm,
            "metric_order": metric_order,
            "minimum_size": minimum_size,
            "maximum_size": maximum_size,
            "maximum_ratio": maximum_ratio,
            "chord_tolerance": chord_tolerance,
            "distance_size": distance_size,
            "distance_growth": distance_growth,
            "threads": threads,
            "backend": backend,
            "distribute_outputs": distribute_outputs,
        },
    )
    return Metric(*run_alone(made, taken, progress, "metric_from_solution"))


def metric_embedding(
    surface: Any,
    metric: Any,
    points: int = 10000,
    *,
    metric_order: str = "vtk",
    unit: bool = False,
    complexity: float = 0.0,
    dimension: int = 6,
    refine: bool = True,
    limit_metric: bool = True,
    metric_growth: float = 5.0,
    iterations: int = 200,
    energy_tolerance: float = 0.15,
    threads: int = 0,
    backend: str = "automatic",
    distribute_outputs: bool = False,
    progress: Progress = None,
) -> MetricEmbedded:
    """
    Finds places in R^d whose distances along the surface are those of a metric.

        made = metric_embedding(surface, "Metric", 5000)
        remesh(made.surface, 5000, embedding=made.embedding)

    `remesh(surface, 5000, metric="Metric")` does that in one step.

    Parameters
    ----------
    surface
        As for `remesh`.
    metric : str, (n, 3, 3), (n, 9), (n, 6) or (n, 3) tensors, or (n,) sizes
        As for `remesh`: an edge e is to have the length sqrt(e' M e).
    points : int, from 1
        Points of the mesh that it is for, default 10000.
    metric_order : "vtk", "rows" or "sol"
        What 6 components are, as for `remesh`.
    unit : bool
        Whether it is for a mesh with edges of the length 1 in the metric, instead; default False.
    complexity : float, from 0
        Then the area that the metric is scaled to, as for `remesh`.
    dimension : int, 3 to 16
        Of the space, default 6.
    refine : bool
        Whether triangles that are too large for the metric are split; default True.
    limit_metric, metric_growth
        As for `remesh`.
    iterations : int, from 0
        Steps at most, default 200.
    energy_tolerance : float, 0 to 1
        Steps end where ten of them gain less than this share of the energy, default 0.15.
    threads, backend, distribute_outputs, progress
        As for `remesh`.

    Returns
    -------
    MetricEmbedded
        `surface` in triangles with the arrays, `embedding` (n, d), `metric` (n, 6) as it was
        limited, and `stretch` (m, 2), which is 1 where the metric is met; n and m are points and
        triangles of `surface`, whose first points are those that were put in.

    Raises and warns as `remesh` does.

    Notes
    -----
    Some 6 s of one processor for 100 000 points that become 205 000. Source: O. Sorkine, M. Alexa:
    As-rigid-as-possible surface modeling, Symposium on Geometry Processing, 2007.
    """
    arguments = dict(locals())
    taken = Input(arguments.pop("surface"))
    embedded = vtkMetricEmbedding()
    del arguments["progress"]
    embedded.SetMetricArray(
        taken.array("metric", flat_tensors(arguments.pop("metric")), "Given metric")
    )
    set_properties(embedded, arguments)
    return MetricEmbedded(*run_alone(embedded, taken, progress, "metric_embedding"))


def spectral_embedding(
    surface: Any,
    dimension: int = 6,
    *,
    scaling: str = "commute_time",
    time: float = 0.0,
    mass: str = "lumped",
    border: str = "natural",
    threads: int = 0,
    backend: str = "automatic",
    distribute_outputs: bool = False,
    progress: Progress = None,
) -> Spectrum:
    """
    Computes the first eigenfunctions of the surface's Laplacian, as places in R^d.

        space = spectral_embedding(surface, 50).embedding    # (n, 50)
        remesh(surface, 5000, embedding=space)

    Parameters
    ----------
    surface
        As for `remesh`.
    dimension : int, 2 to 100000
        Number of eigenfunctions, without constants, default 6; fewer than the points.
    scaling : "commute_time", "diffusion", "biharmonic" or "none"
        What the function of an eigenvalue is multiplied by: its root's inverse (default),
        `exp(-time * value)`, its inverse, or 1.
    time : float, from 0
        Of diffusion, in squares of the points' unit, default 0.
    mass : "lumped" or "consistent"
        The mass matrix, default "lumped".
    border : "natural" or "fixed"
        At borders functions have no slope across (default), or are 0.
    threads, backend, distribute_outputs, progress
        As for `remesh`.

    Returns
    -------
    Spectrum
        `embedding` (n, d), `eigenvalues` (d,), and `surface` with the point array `Embedding`.

    Raises and warns as `remesh` does.

    Notes
    -----
    Seconds for 6 functions of 100 000 triangles. Source: B. Vallet, B. Levy: Spectral geometry
    processing with manifold harmonics, Computer Graphics Forum 27, 2008.
    """
    arguments = dict(locals())
    taken = Input(arguments.pop("surface"))
    embedded = vtkSpectralEmbedding()
    del arguments["progress"]
    set_properties(embedded, arguments)
    return Spectrum(*run_alone(embedded, taken, progress, "spectral_embedding"))
