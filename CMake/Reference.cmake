# The target `reference`: reference pages of the headers and documents, where Doxygen is installed.
# Tree-Doxygen makes the same pages, and fails on a warning.
find_program(ANISOTROPIC_REMESHING_DOXYGEN doxygen)
mark_as_advanced(ANISOTROPIC_REMESHING_DOXYGEN)
find_package(Python3 COMPONENTS Interpreter QUIET)
if (NOT ANISOTROPIC_REMESHING_DOXYGEN OR NOT Python3_Interpreter_FOUND)
  return ()
endif ()
set(reference_folder "${CMAKE_BINARY_DIR}/reference")
set(reference_doxyfile "${CMAKE_BINARY_DIR}/Doxyfile")
configure_file("${CMAKE_CURRENT_LIST_DIR}/../Documentation/Doxyfile.in" "${reference_doxyfile}"
  @ONLY)
add_custom_target(reference
  COMMAND "${ANISOTROPIC_REMESHING_DOXYGEN}" "${reference_doxyfile}"
  COMMENT "Reference pages: ${reference_folder}/html/index.html"
  VERBATIM)
