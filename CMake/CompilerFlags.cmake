# Flags for this project's own sources (generated wrappings are left alone).

# Exact predicates and equal bytes on every machine need each product and sum rounded on its own.
set(anisotropic_remeshing_flags "$<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-ffp-contract=off>")

set(anisotropic_remeshing_warnings)
if (ANISOTROPIC_REMESHING_WARNINGS_AS_ERRORS)
  set(anisotropic_remeshing_warnings -Wall -Wextra -Werror)
endif ()
