# Lays out the superproject with the repository linked into it; configures, builds (a static
# library) and runs it. See CMakeLists.txt for the variables.
set(source "${work}/source")
set(build "${work}/build")
file(REMOVE_RECURSE "${source}" "${build}")
file(COPY "${CMAKE_CURRENT_LIST_DIR}/CMakeLists.txt" "${CMAKE_CURRENT_LIST_DIR}/../Consumer/main.cxx"
  DESTINATION "${source}")
file(CREATE_LINK "${repository}" "${source}/AnisotropicRemeshing" SYMBOLIC)

function (run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result)
  if (NOT result EQUAL 0)
    string(REPLACE ";" " " command "${ARGV}")
    message(FATAL_ERROR "Failed (${result}): ${command}")
  endif ()
endfunction ()

# Not optimised, and a room at a time: whether it can be built and linked is in question.
run("${CMAKE_COMMAND}" -G "${generator}" -S "${source}" -B "${build}"
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O0 -DBUILD_SHARED_LIBS=OFF
  -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0
  "-DVTK_DIR=${vtk_dir}")
run("${CMAKE_COMMAND}" --build "${build}")
run("${build}/consumer")
