# Installs the build tree into a fresh prefix; configures, builds and runs the consumer against it;
# imports the installed Python package. See CMakeLists.txt for the variables.
set(prefix "${work}/prefix")
set(consumer "${work}/build")
file(REMOVE_RECURSE "${prefix}" "${consumer}")

function (run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result)
  if (NOT result EQUAL 0)
    string(REPLACE ";" " " command "${ARGV}")
    message(FATAL_ERROR "Failed (${result}): ${command}")
  endif ()
endfunction ()

run("${CMAKE_COMMAND}" --install "${build}" --prefix "${prefix}")

set(options "-DVTK_DIR=${vtk_dir}")
if (python)
  list(APPEND options "-DPython3_EXECUTABLE=${python}")
endif ()
run("${CMAKE_COMMAND}" -G "${generator}" -S "${CMAKE_CURRENT_LIST_DIR}" -B "${consumer}"
  "-DCMAKE_PREFIX_PATH=${prefix}" ${options})
run("${CMAKE_COMMAND}" --build "${consumer}")
run("${consumer}/consumer")

if (python)
  run("${CMAKE_COMMAND}" -E env "PYTHONPATH=${prefix}/${python_destination}"
    "${python}" "${CMAKE_CURRENT_LIST_DIR}/check_import.py" "${prefix}")
  # As Debian's Python looks below /usr/local.
  if (EXISTS "/etc/debian_version" AND python STREQUAL "/usr/bin/python3")
    file(GLOB site "${prefix}/lib/python3.*/dist-packages")
    run("${CMAKE_COMMAND}" -E env --unset=PYTHONPATH "${python}" -c
      "import site; site.addsitedir('${site}'); import anisotropic_remeshing as package; assert package.__file__.startswith('${prefix}')")
  endif ()
endif ()
