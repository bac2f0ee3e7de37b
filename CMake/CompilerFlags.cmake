# Flags for this project's own sources (generated wrappings are left alone).

# Exact predicates and equal bytes on every machine need each product and sum rounded on its own.
set(anisotropic_remeshing_flags "$<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-ffp-contract=off>")

set(anisotropic_remeshing_warnings)
if (ANISOTROPIC_REMESHING_WARNINGS_AS_ERRORS)
  set(anisotropic_remeshing_warnings -Wall -Wextra -Werror)
endif ()

# Headers of other libraries that nearly every source needs, for target_precompile_headers(): without
# them, building takes half as long again. Sources include what they use all the same, so that
# CMAKE_DISABLE_PRECOMPILE_HEADERS (as for ccache) builds, too.
set(anisotropic_remeshing_headers
  <Eigen/Geometry> <algorithm> <cmath> <functional> <iostream> <limits> <map> <memory> <sstream>
  <string> <utility> <vector>)
set(anisotropic_remeshing_vtk_headers
  <vtkDoubleArray.h> <vtkPointData.h> <vtkPolyData.h> <vtkPolyDataAlgorithm.h>)
