"""Variational anisotropic surface remeshing with VTK.

    from anisotropic_remeshing import vtkAnisotropicRemesher
"""
from .vtkFiltersAnisotropicRemeshing import (
    vtkAnisotropicRemesher,
    vtkEmbeddedSurfaceAlgorithm,
    vtkGaussMapEmbedding,
    vtkRestrictedVoronoiAlgorithm,
    vtkRestrictedVoronoiDiagram,
    vtkSurfaceMeshComparison,
    vtkWholeSurfaceAlgorithm,
)

__all__ = [
    "vtkAnisotropicRemesher",
    "vtkEmbeddedSurfaceAlgorithm",
    "vtkGaussMapEmbedding",
    "vtkRestrictedVoronoiAlgorithm",
    "vtkRestrictedVoronoiDiagram",
    "vtkSurfaceMeshComparison",
    "vtkWholeSurfaceAlgorithm",
]
