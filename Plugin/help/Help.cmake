# Adds to the plugin's sources and interfaces the pages that the "?" button of ParaView's panel
# opens. make_help.py writes them from the headers' comments and the properties' texts.
# ANISOTROPIC_REMESHING_PARAVIEW_HELP=OFF leaves them out. Servers need none.
if (NOT ANISOTROPIC_REMESHING_PLUGIN_WIDGETS OR NOT ANISOTROPIC_REMESHING_PARAVIEW_HELP)
  return ()
endif ()

# One on PATH may be a link that leads nowhere.
string(REGEX REPLACE "[^0-9]" "" qt_version "${qt}")
find_program(ANISOTROPIC_REMESHING_QHELPGENERATOR qhelpgenerator
  PATHS "/usr/lib/qt${qt_version}/bin" "/usr/lib/qt${qt_version}/libexec"
        "${${qt}_DIR}/../../../bin" "${${qt}_DIR}/../../../libexec"
  NO_DEFAULT_PATH)
find_program(ANISOTROPIC_REMESHING_QHELPGENERATOR qhelpgenerator)
mark_as_advanced(ANISOTROPIC_REMESHING_QHELPGENERATOR)
set(result 1)
if (ANISOTROPIC_REMESHING_QHELPGENERATOR)
  execute_process(COMMAND "${ANISOTROPIC_REMESHING_QHELPGENERATOR}" -v
    RESULT_VARIABLE result OUTPUT_QUIET ERROR_QUIET)
endif ()
if (NOT result EQUAL 0)
  message(FATAL_ERROR "The plugin's help pages need qhelpgenerator (Debian: qhelpgenerator-qt5, "
    "from 13 on qt6-documentation-tools). Install that, or build without help pages: "
    "-DANISOTROPIC_REMESHING_PARAVIEW_HELP=OFF")
endif ()

find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(help_dir "${CMAKE_CURRENT_BINARY_DIR}/help")
set(help_scripts header_comments.py make_help.py proxies.py)
list(TRANSFORM help_scripts PREPEND "${CMAKE_CURRENT_LIST_DIR}/")
set(help_xmls)
foreach (xml IN LISTS server_manager_xmls)
  get_filename_component(xml "${xml}" ABSOLUTE)
  list(APPEND help_xmls "${xml}")
endforeach ()
file(GLOB help_headers CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/../Filters/vtk*.h")
add_custom_command(
  OUTPUT "${help_dir}/AnisotropicRemeshing.qch"
  COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_LIST_DIR}/make_help.py"
          --headers "${CMAKE_CURRENT_SOURCE_DIR}/../Filters"
          --xml ${help_xmls}
          --output "${help_dir}"
  COMMAND "${ANISOTROPIC_REMESHING_QHELPGENERATOR}" "${help_dir}/AnisotropicRemeshing.qhp"
          -s -o "${help_dir}/AnisotropicRemeshing.qch"
  DEPENDS ${help_scripts} ${help_xmls} ${help_headers}
  COMMENT "Writing the plugin's help pages"
  VERBATIM)

configure_file("${CMAKE_CURRENT_LIST_DIR}/help.qrc" "${help_dir}/help.qrc" COPYONLY)
add_custom_command(
  OUTPUT "${help_dir}/qrc_help.cpp"
  COMMAND ${qt}::rcc --name remeshing_help --output "${help_dir}/qrc_help.cpp"
          "${help_dir}/help.qrc"
  DEPENDS "${help_dir}/help.qrc" "${help_dir}/AnisotropicRemeshing.qch"
  VERBATIM)
set_source_files_properties("${help_dir}/qrc_help.cpp" PROPERTIES SKIP_AUTOGEN ON)

paraview_plugin_add_auto_start(CLASS_NAME pqRemeshingHelp
  INTERFACES interface SOURCES generated)
list(APPEND interfaces ${interface})
list(APPEND sources
  ${generated} pqRemeshingHelp.cxx pqRemeshingHelp.h "${help_dir}/qrc_help.cpp")
