"""Chooses threads and the back-end of vtkSMPTools; the mesh is the same with any.

    threads.py [--points N]

A filter of this library can have its own choice (`threads`, `backend`), or takes VTK's. VTK's own
is chosen for all filters by vtkSMPTools, or by the environment, as VTK_SMP_BACKEND_IN_USE=STDThread
and VTK_SMP_MAX_THREADS=4.
"""
import time

from vtkmodules.vtkCommonCore import vtkSMPTools

import anisotropic_remeshing as ar
import shapes


def main(options):
    surface = shapes.surface(*shapes.knot())
    print(f"VTK's back-end: {vtkSMPTools.GetBackend()}, "
          f"{vtkSMPTools.GetEstimatedNumberOfThreads()} threads")
    bytes_of_first = None
    for backend, threads in (("sequential", 1), ("stdthread", 2), ("stdthread", 0)):
        start = time.perf_counter()
        result = ar.remesh(surface, options.points, backend=backend, threads=threads)
        used = result.report
        print(f"{used['used_backend']}, {used['number_of_used_threads']} threads: "
              f"{time.perf_counter() - start:.2f} s")
        bytes_of_first = bytes_of_first or result.points.tobytes()
        assert result.points.tobytes() == bytes_of_first
    print("All meshes are the same, to the last bit.")


if __name__ == "__main__":
    main(shapes.options(__doc__, 2000))
