"""Anisotropic surface remeshing: new triangles for a surface, adapted to its curvature.

    import anisotropic_remeshing as ar

    result = ar.remesh("scan.ply", 5000)  # or a vtkPolyData, PyVista mesh, (points, triangles)
    result.points, result.triangles       # numpy arrays, without copies
    result.save("mesh.vtp")

Functions: `remesh`, `compare` (how good a mesh is), `voronoi` (cells of given sites), `embed` (the
space that the remesher measures in), `metric_from_solution` (the metric for a solution),
`metric_embedding` (the space of a metric), `spectral_embedding` (eigenfunctions). They give back results like `Remeshed`; what is wrong raises,
what is doubtful is a Python warning, and Ctrl-C stops a run.

The VTK filters underneath are here, too, as `vtkAnisotropicRemesher`, for VTK pipelines.

Messages go to the logger `anisotropic_remeshing`.
"""
import threading as _threading

# Their classes are arguments or results of the filters.
import vtkmodules.vtkCommonDataModel  # noqa: F401
import vtkmodules.vtkCommonExecutionModel  # noqa: F401

from . import _execution as _execution
from ._fields import metric_embedding, metric_from_solution, spectral_embedding
from ._functions import compare, embed, remesh, voronoi
from ._messages import RemeshingError, RemeshingStopped, RemeshingWarning
from ._results import (
    Compared,
    Diagram,
    Distance,
    Embedded,
    Metric,
    MetricEmbedded,
    Remeshed,
    Spectrum,
)
from ._version import __version__
from .vtkFiltersAnisotropicRemeshing import (
    vtkAnisotropicRemesher,
    vtkEmbeddedSurfaceAlgorithm,
    vtkGaussMapEmbedding,
    vtkMetricEmbedding,
    vtkRestrictedVoronoiAlgorithm,
    vtkRestrictedVoronoiDiagram,
    vtkSolutionMetric,
    vtkSpectralEmbedding,
    vtkSurfaceFieldAlgorithm,
    vtkSurfaceMeshComparison,
    vtkWholeSurfaceAlgorithm,
)

_execution.watch(_threading.main_thread().ident or 0)

# Where they are to be found, as tracebacks and help() tell it.
for _public in (Compared, Diagram, Distance, Embedded, Metric, MetricEmbedded, Remeshed,
                RemeshingError, RemeshingStopped, RemeshingWarning, Spectrum, compare, embed,
                metric_embedding, metric_from_solution, remesh, spectral_embedding, voronoi):
    _public.__module__ = __name__

__all__ = [
    "Compared",
    "Diagram",
    "Distance",
    "Embedded",
    "Metric",
    "MetricEmbedded",
    "Remeshed",
    "RemeshingError",
    "RemeshingStopped",
    "RemeshingWarning",
    "Spectrum",
    "__version__",
    "compare",
    "embed",
    "metric_embedding",
    "metric_from_solution",
    "remesh",
    "spectral_embedding",
    "voronoi",
    "vtkAnisotropicRemesher",
    "vtkEmbeddedSurfaceAlgorithm",
    "vtkGaussMapEmbedding",
    "vtkMetricEmbedding",
    "vtkRestrictedVoronoiAlgorithm",
    "vtkRestrictedVoronoiDiagram",
    "vtkSolutionMetric",
    "vtkSpectralEmbedding",
    "vtkSurfaceFieldAlgorithm",
    "vtkSurfaceMeshComparison",
    "vtkWholeSurfaceAlgorithm",
]
