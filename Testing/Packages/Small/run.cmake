# Nothing is installed before all is built; what is installed is removed again, and nothing else.
set(build "${work}/build")
set(prefix "${work}/prefix")
file(REMOVE_RECURSE "${work}")

# run(<status> <command>...): the status is 0 or not; the output is in `output`.
function (run status)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if ((status EQUAL 0 AND NOT result EQUAL 0) OR (NOT status EQUAL 0 AND result EQUAL 0))
    string(REPLACE ";" " " command "${ARGN}")
    message(FATAL_ERROR "Status ${result}: ${command}\n${text}")
  endif ()
  set(output "${text}" PARENT_SCOPE)
endfunction ()

# expect_files(<file>...): what is in the prefix, sorted.
function (expect_files)
  file(GLOB_RECURSE files RELATIVE "${prefix}" "${prefix}/*")
  if (NOT "${files}" STREQUAL "${ARGN}")
    message(FATAL_ERROR "In the prefix: ${files}\nExpected: ${ARGN}")
  endif ()
endfunction ()

run(0 "${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}" -B "${build}"
  "-Drules=${CMAKE_CURRENT_LIST_DIR}/../../../CMake")

# --- Not built ------------------------------------------------------------------------------------
run(1 "${CMAKE_COMMAND}" --install "${build}" --prefix "${prefix}")
if (NOT output MATCHES "Nothing is installed.*cmake --build")
  message(FATAL_ERROR "No word of what to do:\n${output}")
endif ()
run(1 "${CMAKE_COMMAND}" --install "${build}" --prefix "${prefix}" --component tools)
expect_files()

# --- Installed twice, packed, removed -------------------------------------------------------------
file(TOUCH "${build}/library.so")
file(WRITE "${prefix}/include/AnisotropicRemeshing/foreign" "")
run(0 "${CMAKE_COMMAND}" --install "${build}" --prefix "${prefix}")
run(0 "${CMAKE_COMMAND}" --install "${build}" --prefix "${prefix}" --component tools)
set(python "lib/python3/dist-packages/small")
expect_files("bin/program" "include/AnisotropicRemeshing/CMakeLists.txt"
  "include/AnisotropicRemeshing/foreign" "${python}/module.py")
get_filename_component(folder "${CMAKE_COMMAND}" DIRECTORY)
run(0 "${CMAKE_COMMAND}" -E chdir "${build}" "${folder}/cpack")
file(WRITE "${prefix}/${python}/__pycache__/module.cpython-311.pyc" "")

run(0 "${CMAKE_COMMAND}" --build "${build}" --target uninstall)
expect_files("include/AnisotropicRemeshing/foreign")
if (EXISTS "${prefix}/${python}" OR NOT EXISTS "${prefix}/bin")
  message(FATAL_ERROR "Own folders go, bin stays")
endif ()
run(1 "${CMAKE_COMMAND}" --build "${build}" --target uninstall) # as there is nothing

# --- Below another root ---------------------------------------------------------------------------
set(prefix "${work}/root")
run(0 "${CMAKE_COMMAND}" -E env "DESTDIR=${prefix}" "${CMAKE_COMMAND}" --install "${build}"
  --prefix /usr)
expect_files("usr/bin/program" "usr/include/AnisotropicRemeshing/CMakeLists.txt"
  "usr/${python}/module.py")
run(0 "${CMAKE_COMMAND}" --build "${build}" --target uninstall)
expect_files()
