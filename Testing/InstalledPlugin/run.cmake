# Installs the build tree into a fresh prefix, checks what is in it, and runs the plugin from there
# with PV_PLUGIN_PATH alone. See CMakeLists.txt for the variables.
set(prefix "${work}/prefix")
file(REMOVE_RECURSE "${prefix}")

function (run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result)
  if (NOT result EQUAL 0)
    string(REPLACE ";" " " command "${ARGV}")
    message(FATAL_ERROR "Failed (${result}): ${command}")
  endif ()
endfunction ()

run("${CMAKE_COMMAND}" --install "${build}" --prefix "${prefix}")

# The library for VTK goes to the same prefix, so that nothing may lie outside ParaView's folders.
get_filename_component(folder "${plugins}" DIRECTORY)
file(GLOB_RECURSE files RELATIVE "${prefix}" "${prefix}/*")
foreach (file IN LISTS files)
  string(FIND "${file}" "${folder}/" at)
  if (NOT at EQUAL 0)
    message(FATAL_ERROR "${file} is not in ${folder}")
  endif ()
endforeach ()

# The interpreter's ParaView is where the system has it, or in the prefix beside this build tree.
set(variables --unset=LD_LIBRARY_PATH "PV_PLUGIN_PATH=${prefix}/${plugins}")
run("${CMAKE_COMMAND}" -E env ${variables} "PYTHONPATH=${paraview_python}"
  "${pvbatch}" "${CMAKE_CURRENT_LIST_DIR}/check_plugin.py" "${prefix}")
run("${CMAKE_COMMAND}" -E env ${variables} "PYTHONPATH=${paraview_python}"
  "${pvpython}" "${CMAKE_CURRENT_LIST_DIR}/check_plugin.py" "${prefix}")
if (python)
  run("${CMAKE_COMMAND}" -E env --unset=LD_LIBRARY_PATH
    "PYTHONPATH=${prefix}/${python}:${paraview_python}"
    "${pvpython}" "${CMAKE_CURRENT_LIST_DIR}/../Consumer/check_import.py" "${prefix}")
endif ()
