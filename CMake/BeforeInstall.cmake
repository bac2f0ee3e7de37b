# Before anything is installed: is all of it built? Include this before any install() rule.
# A build of one target, or one that was configured anew for another prefix, lacks files. Installing
# would break off half way and leave what came before.
set(installed_files)
foreach (target IN ITEMS
    FiltersAnisotropicRemeshing vtkFiltersAnisotropicRemeshingPython
    AnisotropicRemeshingPythonExecution remesh_surface AnisotropicRemeshing)
  string(APPEND installed_files " \"$<$<TARGET_EXISTS:${target}>:$<TARGET_FILE:${target}>>\"")
endforeach ()
install(CODE "
  foreach (file IN ITEMS ${installed_files})
    if (file AND NOT EXISTS \"\${file}\")
      message(FATAL_ERROR \"Nothing is installed, as \${file} is not built yet. \"
        \"Build all first: cmake --build ${CMAKE_BINARY_DIR}\")
    endif ()
  endforeach ()" ALL_COMPONENTS)
