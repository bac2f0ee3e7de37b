"""The functions of the package: what a Python user calls."""
from __future__ import annotations

from typing import Any, Dict, Optional, Union

from . import _surfaces
from ._progress import Progress
from ._results import Compared, Diagram, Embedded, Remeshed, facts_of, row_of, snake_case
from ._run import Input, choose_arrays, outputs_of, run_alone, set_properties, update
from .vtkFiltersAnisotropicRemeshing import (
    vtkAnisotropicRemesher,
    vtkGaussMapEmbedding,
    vtkRestrictedVoronoiDiagram,
    vtkSurfaceMeshComparison,
)

_FIELD_FACTS = [
    "TopologyPreserved",
    "EulerCharacteristic",
    "RMSDistance",
    "MaximumDistance",
    "NumberOfExtraPoints",
    "NumberOfFlippedTriangles",
    "NumberOfStrayTriangles",
    "NumberOfSelfIntersections",
    "NumberOfNonManifoldEdges",
    "NormalSmoothingRadius",
    "MetricUnit",
    "MetricLimit",
    "MetricShare",
    "Seed",
]
_RUN_FACTS = [
    "TopologyReport",
    "Dimension",
    "Energy",
    "NumberOfIterations",
    "NumberOfEvaluations",
    "NumberOfInputComponents",
    "NumberOfDroppedTriangles",
    "NumberOfMergedPoints",
    "UsedBackend",
    "NumberOfUsedThreads",
]
_PHASES = ["intake", "sampling", "lloyd", "newton", "repair", "placement", "distance", "diagram"]


def _report(algorithm: Any, field: Any, ran: Any) -> Dict[str, Any]:
    """All facts that a diagram filter tells of its run."""
    warnings, seconds = ran
    report = facts_of(field, _FIELD_FACTS)
    for name in _RUN_FACTS:
        report[snake_case(name)] = getattr(algorithm, "Get" + name)()
    report["warnings"] = warnings
    report["seconds"] = {phase: algorithm.GetPhaseSeconds(phase) for phase in _PHASES}
    report["seconds"]["total"] = seconds
    return report


def remesh(
    surface: Any,
    points: int = 10000,
    *,
    anisotropy: float = 0.04,
    tolerance: Optional[float] = None,
    features: bool = True,
    # what the run is asked for
    tolerance_is_absolute: bool = False,
    maximum_points: int = 1000000,
    feature_angle: float = 35.0,
    feature_labels: Any = None,
    seams: Any = "automatic",
    maximum_extra_points: Union[None, int, float] = None,
    vertex_placement: str = "fit",
    unit: bool = False,
    complexity: float = 0.0,
    # how the surface is embedded
    density: Any = None,
    normals: Any = None,
    estimate_normals: bool = False,
    normal_smoothing_passes: int = -1,
    normal_smoothing_radius: float = -1.0,
    coordinates: Any = None,
    embedding: Any = None,
    embedding_mode: str = "gauss_map",
    metric: Any = None,
    metric_order: str = "vtk",
    metric_dimension: int = 6,
    limit_metric: bool = True,
    metric_growth: float = 5.0,
    merge_tolerance: float = 0.0,
    # how it runs
    initial_sites: Any = None,
    seed: int = 0,
    sampling: str = "stratified",
    coarse_start: bool = True,
    lloyd_iterations: int = 5,
    newton_iterations: int = 30,
    history_length: int = 7,
    gradient_tolerance: float = 0.0,
    energy_tolerance: float = 5e-6,
    threads: int = 0,
    backend: str = "automatic",
    # what comes out
    cells: bool = True,
    edges: bool = True,
    measure_distance: bool = True,
    maximum_cell_embedding_dimension: int = 16,
    distribute_outputs: bool = False,
    progress: Progress = None,
) -> Remeshed:
    """
    Makes new triangles for a surface: long along flat directions, small where it bends.

        remesh("scan.ply", 5000)                   # as many points
        remesh(mesh, tolerance=1e-3)               # as many as a distance needs
        remesh((points, triangles), 2000, anisotropy=0.0)  # triangles of equal size

    Parameters
    ----------
    surface : vtkPolyData or other VTK data, PyVista mesh, (points, triangles), trimesh, meshio, path
        Points (n, 3) in any unit; triangles (m, 3), or faces (m, k), or a list of lists. A path is
        of a .ply, .stl, .obj, .vtp, .vtu, .vtm or .vtk file. It is not changed; VTK's arrays are
        not copied.
    points : int, from 4
        Points of the new mesh, default 10000.
    anisotropy : float, 0 to 1
        How much the normals count: the length of a unit normal as a fraction of the bounding box's
        diagonal, default 0.04; 0.02 to 0.1 is usual, 0 gives triangles of equal size.
    tolerance : float or None
        How far mesh and surface may be from each other, as a fraction of the diagonal (1e-4 to
        1e-2 is usual), or in the unit of the points with `tolerance_is_absolute`. Then `points`
        does not count: as many are taken as that needs, at most `maximum_points` (default a
        million). Takes about ten times as long.
    features : bool
        Whether creases, corners and borders stay, default True.
    feature_angle : float, 0 to 180 degrees
        Edges that are sharper are creases, default 35.
    feature_labels : str or (m,) numbers, optional
        A label for each cell, or the cell array's name: between labels are features, too.
    seams : str, (n, k) numbers or None, optional
        A point array that jumps where points coincide: along its jumps are edges, with a point for
        each side. Default: the active texture coordinates; None: no such edges.
    maximum_extra_points : int, None or math.inf
        By how many points the mesh may exceed `points` where its topology needs them. None
        (default): one percent; 0 forbids.
    vertex_placement : "fit", "quadric", "surface_point" or "centroid"
        Where the points are put: default, where all triangles together are closest to the surface.
    density : str or (n,) numbers above 0, optional
        Where it is large, points are dense: spacing goes with density ** -0.25.
    normals : str or (n, 3) unit vectors, optional
        Normals of the surface, as from a CAD program. Default: the surface's active ones, else they
        are estimated (with `estimate_normals` in any case) and smoothed.
    normal_smoothing_passes, normal_smoothing_radius : int from 0; float from 0, unit of the points
        How far estimated normals are smoothed; below 0 (default) it is chosen.
    coordinates : {name: scale} or [(name or (n,) or (n, k) numbers, scale)], optional
        Data that the triangles follow, too: appended to the embedding, scaled (length per unit).
    embedding : str or (n, d) numbers, d from 2, optional
        Replaces the embedding: each point's place in R^d.
    metric : str, (n, 3, 3) or (n, 9), (n, 6), (n, 3) or (n,) numbers, optional
        A symmetric tensor M for each point, or a size: edges e get lengths sqrt(e' M e), all times
        one number. Replaces the embedding. (n, 3) is for a surface in a plane of equal z.
    metric_order, metric_dimension : "vtk", "rows" or "sol"; int, 3 to 16
        What (n, 6) are: XX YY ZZ XY YZ XZ, or XX XY XZ YY YZ ZZ, or XX XY YY XZ YZ ZZ. The
        dimension that the metric is embedded in, default 6.
    limit_metric, metric_growth : bool; float, 1.01 to 1000
        Whether a metric is limited to what straight edges can follow (default), and then by what
        factor sizes may differ between the ends of an edge, default 5.
    unit, complexity : bool; float from 0
        Whether the metric decides the number of points, so that edges have the mean length 1 in it;
        the area that it is scaled to before, in squares of units, default 0: as it is.
    embedding_mode : "gauss_map" or "position"
        "position" is as `anisotropy` 0.
    merge_tolerance : float, 0 to 0.1
        Points closer than this fraction of the diagonal become one, default 0: equal ones.
    initial_sites : (k, 3) numbers, VTK points, a path or a result with sites, optional
        Where the sites start; their number replaces `points`. Then features are not kept.
    seed, sampling, coarse_start : int; "stratified" or "random"; bool
        The first sites. Same input, arguments and seed give the same mesh.
    lloyd_iterations, newton_iterations : int, 0 to 100000
        Steps of the optimiser, default 5 and 30.
    history_length : int, 1 to 100
        How many steps the quasi-Newton method remembers, default 7.
    gradient_tolerance, energy_tolerance : float, 0 to 1
        It ends where the gradient is this fraction of the first one (default 0: never), or where a
        step lowers the energy by at most this fraction (default 5e-6; 0: by nothing).
    threads, backend : int, 0 to 1024; "automatic", "sequential", "stdthread" or "tbb"
        0: all. The mesh does not depend on it.
    cells, edges, measure_distance : bool
        Whether the result has `cells`, `edges`, `distance`. Off saves time and memory.
    maximum_cell_embedding_dimension : int, 0 to 100000
        Up to which dimension the cells carry `Embedding`, default 16.
    distribute_outputs : bool
        With MPI: whether the outputs are spread over the processes.
    progress : bool or callable, optional
        True shows a bar (tqdm) or a line; a callable gets (fraction, phase) and stops the run by
        returning False or raising.

    Returns
    -------
    Remeshed
        `mesh` is of the kind that was put in; `points` and `triangles` are numpy views.

    Raises
    ------
    RemeshingError
        A ValueError: the surface cannot be used (no polygons, NaN), or an argument is out of its
        range.
    ValueError, TypeError
        An argument has a wrong shape or type.
    FileNotFoundError, MemoryError
    RemeshingStopped, KeyboardInterrupt
        `progress` or Ctrl-C ended the run; within 0.3 s as a rule.

    Warns
    -----
    RemeshingWarning
        The result is not all that was asked for, as more points than `points`.

    Notes
    -----
    Time goes with triangles + points: 10 000 points of a scan take a few seconds. Several threads'
    calls take turns; other Python threads work on meanwhile, but not with ParaView's VTK.

    Source: B. Levy, N. Bonneel: Variational Anisotropic Surface Meshing with Voronoi Parallel
    Linear Enumeration. 21st International Meshing Roundtable, 2012.
    """
    arguments = dict(locals())
    taken = Input(arguments.pop("surface"))
    remesher = vtkAnisotropicRemesher()
    arrays = ("normals", "embedding", "metric", "coordinates", "density", "feature_labels", "seams")
    choose_arrays(remesher, taken, {name: arguments.pop(name) for name in arrays})
    for name in ("progress", "initial_sites"):
        del arguments[name]
    if tolerance is None:
        del arguments["tolerance"]
    elif not tolerance > 0:
        raise ValueError(f"tolerance must be above 0, or None; not {tolerance}.")
    set_properties(remesher, arguments)
    remesher.SetInputDataObject(0, taken.data)
    if initial_sites is not None:
        remesher.SetInitialSitesData(_surfaces.take_points(initial_sites, "initial_sites"))
    ran = update(remesher, progress, "remesh")
    outputs = outputs_of(remesher)
    return Remeshed(outputs, taken.like, _report(remesher, outputs[0].GetFieldData(), ran))


def voronoi(
    surface: Any,
    sites: Any,
    *,
    anisotropy: float = 0.04,
    vertex_placement: str = "fit",
    density: Any = None,
    normals: Any = None,
    estimate_normals: bool = False,
    normal_smoothing_passes: int = -1,
    normal_smoothing_radius: float = -1.0,
    coordinates: Any = None,
    embedding: Any = None,
    embedding_mode: str = "gauss_map",
    metric: Any = None,
    metric_order: str = "vtk",
    metric_dimension: int = 6,
    limit_metric: bool = True,
    metric_growth: float = 5.0,
    merge_tolerance: float = 0.0,
    threads: int = 0,
    backend: str = "automatic",
    cells: bool = True,
    edges: bool = True,
    measure_distance: bool = True,
    maximum_cell_embedding_dimension: int = 16,
    distribute_outputs: bool = False,
    progress: Progress = None,
) -> Diagram:
    """
    Cuts a surface into the Voronoi cells of given sites, and joins the sites to triangles.

    Parameters
    ----------
    surface
        As for `remesh`.
    sites : (k, 3) numbers, VTK or PyVista points, a path, or a result with sites; k from 1
        They stay where they are: each is the place of the surface closest to it. Points with an
        array `Embedding` of d components are at that place in R^d.
    density
        As for `remesh`; changes sums only.

    The other arguments, and what is raised and warned: as for `remesh`. With `anisotropy` 0, cells
    are those of distances in space alone.

    Returns
    -------
    Diagram
        Its `cells` have the cell array `SiteId`, the site's index; they cover the surface.

    Notes
    -----
    Takes a fraction of a second for 10 000 sites, most of it for `measure_distance`.
    Source: as for `remesh`, section 4.
    """
    arguments = dict(locals())
    taken = Input(arguments.pop("surface"))
    diagram = vtkRestrictedVoronoiDiagram()
    arrays = ("normals", "embedding", "metric", "coordinates", "density")
    choose_arrays(diagram, taken, {name: arguments.pop(name) for name in arrays})
    for name in ("progress", "sites"):
        del arguments[name]
    set_properties(diagram, arguments)
    diagram.SetInputDataObject(0, taken.data)
    diagram.SetSitesData(_surfaces.take_points(sites, "sites"))
    ran = update(diagram, progress, "voronoi")
    outputs = outputs_of(diagram)
    return Diagram(outputs, taken.like, _report(diagram, outputs[0].GetFieldData(), ran))


def compare(
    mesh: Any,
    surface: Any = None,
    *,
    samples: int = 200000,
    bound_maximum_distance: bool = True,
    bins: int = 30,
    threads: int = 0,
    backend: str = "automatic",
    distribute_outputs: bool = False,
    progress: Progress = None,
) -> Compared:
    """
    Tells how good a mesh is: its triangles, its faults, and how far it is from a surface.

        compare(remesh(surface, 5000), surface).distance.rms

    Parameters
    ----------
    mesh
        What `remesh` takes for a surface, or a result of it.
    surface
        The same, optional: the surface that the mesh stands for.
    samples : int, 1 to 1000000000
        About how many places of each are measured at, default 200000.
    bound_maximum_distance : bool
        Whether `maximum_distance_bound` is sought, which the largest distance cannot pass; default
        True. Off saves half the time.
    bins : int, 1 to 10000
        Rows of the histograms, default 30.
    threads, backend, distribute_outputs, progress
        As for `remesh`.

    Returns
    -------
    Compared
        `distance`, `summary` (all numbers by name), `mesh` and `surface` with arrays that tell
        where, `histograms`.

    Raises and warns as `remesh` does.

    Notes
    -----
    About a second for 100 000 triangles. Distances are integrals over the surfaces, both ways, in
    the unit of the points; those with `relative_` are fractions of the surface's diagonal.
    """
    comparison = vtkSurfaceMeshComparison()
    taken = Input(mesh)
    set_properties(
        comparison,
        {
            "samples": samples,
            "bound_maximum_distance": bound_maximum_distance,
            "bins": bins,
            "threads": threads,
            "backend": backend,
            "distribute_outputs": distribute_outputs,
        },
    )
    comparison.SetInputDataObject(0, taken.data)
    if surface is not None:
        comparison.SetReferenceData(_surfaces.take(surface).data)
    update(comparison, progress, "compare")
    outputs = outputs_of(comparison)
    return Compared(outputs, taken.like, row_of(outputs[2]))


def embed(
    surface: Any,
    points: int = 10000,
    *,
    anisotropy: float = 0.04,
    normals: Any = None,
    estimate_normals: bool = False,
    normal_smoothing_passes: int = -1,
    normal_smoothing_radius: float = -1.0,
    coordinates: Any = None,
    embedding: Any = None,
    embedding_mode: str = "gauss_map",
    metric: Any = None,
    metric_order: str = "vtk",
    metric_dimension: int = 6,
    limit_metric: bool = True,
    metric_growth: float = 5.0,
    merge_tolerance: float = 0.0,
    threads: int = 0,
    backend: str = "automatic",
    distribute_outputs: bool = False,
    progress: Progress = None,
) -> Embedded:
    """
    Tells where `remesh` sees a surface's points: in R^d, position and scaled normal as a rule.

        space = embed(mesh).embedding.copy()    # (n, 6)
        space[:, 2] *= 0.5                       # half as many points across
        remesh(mesh, 5000, embedding=space)

    Parameters
    ----------
    surface
        As for `remesh`.
    points : int, from 1
        Points of the mesh that it is for, default 10000: estimated normals are smoothed for those.

    The other arguments, and what is raised and warned: as for `remesh`.

    Returns
    -------
    Embedded
        `embedding` (n, d), and `surface` with it as the point array `Embedding`.

    Notes
    -----
    Takes a fraction of a second for 100 000 triangles. Source: as for `remesh`, section 3.2.
    """
    arguments = dict(locals())
    taken = Input(arguments.pop("surface"))
    mapped = vtkGaussMapEmbedding()
    arrays = ("normals", "embedding", "metric", "coordinates")
    choose_arrays(mapped, taken, {name: arguments.pop(name) for name in arrays})
    del arguments["progress"]
    set_properties(mapped, arguments)
    return Embedded(*run_alone(mapped, taken, progress, "embed"))
