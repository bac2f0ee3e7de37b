# The Python package around the wrapped module: in the build tree as it is installed.
set(python_package "${python_destination}/anisotropic_remeshing")
set(python_build "${CMAKE_BINARY_DIR}/${python_package}")

# add_python_file(<file> [<name>]): into the build tree and the installation.
function (add_python_file file)
  configure_file("${file}" "${python_build}" COPYONLY)
  install(FILES "${file}" DESTINATION "${python_package}" COMPONENT python)
endfunction ()

foreach (name IN ITEMS __init__.py _execution.pyi _functions.py _messages.py _pictures.py _progress.py _results.py
    _run.py _surfaces.py py.typed pyvista_accessor.py)
  add_python_file("${PROJECT_SOURCE_DIR}/Filters/Python/${name}")
endforeach ()
set(python_generated "${CMAKE_BINARY_DIR}/PythonPackage")
configure_file(Filters/Python/_version.py.in "${python_generated}/_version.py" @ONLY)
add_python_file("${python_generated}/_version.py")

include(CMake/CompilerFlags.cmake)

# What other packages find this one by, as PyVista its accessor; pip writes its own.
if (NOT SKBUILD)
  set(python_information "anisotropic_remeshing-${PROJECT_VERSION}.dist-info")
  foreach (name IN ITEMS METADATA entry_points.txt)
    configure_file("Filters/Python/${name}.in" "${python_generated}/${name}" @ONLY)
    configure_file("${python_generated}/${name}"
      "${CMAKE_BINARY_DIR}/${python_destination}/${python_information}/${name}" COPYONLY)
    install(FILES "${python_generated}/${name}"
      DESTINATION "${python_destination}/${python_information}" COMPONENT python)
  endforeach ()
endif ()

# What lets signals through while a filter works.
add_library(AnisotropicRemeshingPythonExecution MODULE Filters/Python/_execution.cxx)
target_compile_features(AnisotropicRemeshingPythonExecution PRIVATE cxx_std_17)
target_compile_options(AnisotropicRemeshingPythonExecution
  PRIVATE ${anisotropic_remeshing_warnings})
target_link_libraries(AnisotropicRemeshingPythonExecution
  PRIVATE
    AnisotropicRemeshing::FiltersAnisotropicRemeshing
    VTK::CommonCore
    VTK::CommonExecutionModel
    VTK::Python
    VTK::WrappingPythonCore)
file(RELATIVE_PATH to_library "/${python_package}" "/${library_destination}")
set_target_properties(AnisotropicRemeshingPythonExecution PROPERTIES
  OUTPUT_NAME _execution
  PREFIX ""
  SUFFIX ".so"
  CXX_VISIBILITY_PRESET hidden
  LIBRARY_OUTPUT_DIRECTORY "${python_build}"
  INSTALL_RPATH "$ORIGIN/${to_library}")
install(TARGETS AnisotropicRemeshingPythonExecution
  LIBRARY DESTINATION "${python_package}" COMPONENT python)

# The wrapped classes' types, as VTK's wrappers tell them.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(python_environment)
if (NOT VTK_PREFIX_PATH STREQUAL "/usr") # there Python looks by itself
  set(python_environment "PYTHONPATH=${VTK_PREFIX_PATH}/${VTK_PYTHONPATH}")
endif ()
set(python_stubs "${python_build}/vtkFiltersAnisotropicRemeshing.pyi")
add_custom_command(
  OUTPUT  "${python_stubs}"
  COMMAND "${CMAKE_COMMAND}" -E env ${python_environment}
          "${Python3_EXECUTABLE}" "${PROJECT_SOURCE_DIR}/Filters/Python/make_stubs.py"
          "${CMAKE_BINARY_DIR}/${python_destination}" anisotropic_remeshing
          vtkFiltersAnisotropicRemeshing "${python_stubs}"
  DEPENDS vtkFiltersAnisotropicRemeshingPython
          "${PROJECT_SOURCE_DIR}/Filters/Python/make_stubs.py"
  COMMENT "Writing the types of the wrapped classes"
  VERBATIM)
add_custom_target(AnisotropicRemeshingPythonStubs ALL DEPENDS "${python_stubs}")
install(FILES "${python_stubs}" DESTINATION "${python_package}" COMPONENT python)
