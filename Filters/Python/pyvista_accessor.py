"""`mesh.anisotropic.remesh(5000)` on PyVista's meshes, from PyVista 0.48 on.

PyVista imports this module by its entry point (group `pyvista.accessors`) the first time that
`anisotropic` is asked for; nothing else of the package does.
"""
from __future__ import annotations

from typing import Any

import pyvista

from . import Compared, Diagram, Embedded, Remeshed, compare, embed, remesh, voronoi


@pyvista.register_dataset_accessor("anisotropic", pyvista.DataSet)
class AnisotropicAccessor:
    """The functions of anisotropic_remeshing with a mesh as the surface; same arguments."""

    def __init__(self, mesh: Any) -> None:
        self._mesh = mesh

    def remesh(self, points: int = 10000, **arguments: Any) -> Remeshed:
        """`anisotropic_remeshing.remesh(mesh, points, ...)`; its `mesh` is a PolyData."""
        return remesh(self._mesh, points, **arguments)

    def voronoi(self, sites: Any, **arguments: Any) -> Diagram:
        """`anisotropic_remeshing.voronoi(mesh, sites, ...)`."""
        return voronoi(self._mesh, sites, **arguments)

    def compare(self, surface: Any = None, **arguments: Any) -> Compared:
        """`anisotropic_remeshing.compare(mesh, surface, ...)`."""
        return compare(self._mesh, surface, **arguments)

    def embed(self, points: int = 10000, **arguments: Any) -> Embedded:
        """`anisotropic_remeshing.embed(mesh, points, ...)`."""
        return embed(self._mesh, points, **arguments)
