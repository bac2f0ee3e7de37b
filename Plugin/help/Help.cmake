# Sets help_arguments for paraview_add_plugin(): the pages that the "?" button of ParaView's panel
# opens, written by make_help.py from the headers' comments and the properties' texts. ParaView
# compiles them into the plugin. ANISOTROPIC_REMESHING_PARAVIEW_HELP=OFF leaves them out.
set(help_arguments XML_DOCUMENTATION OFF)
if (NOT PARAVIEW_USE_QT OR NOT ANISOTROPIC_REMESHING_PARAVIEW_HELP)
  return ()
endif ()

# Qt 5's tools, by the names that ParaView looks for. (What Qt 6's need ParaView says itself.)
if (NOT DEFINED PARAVIEW_QT_MAJOR_VERSION OR PARAVIEW_QT_MAJOR_VERSION EQUAL 5)
  # An xmlpatterns on PATH may be a link that leads nowhere.
  find_program(qt_xmlpatterns_executable NAMES xmlpatterns-qt5 xmlpatterns
    PATHS /usr/lib/qt5/bin NO_DEFAULT_PATH)
  find_program(qt_xmlpatterns_executable NAMES xmlpatterns-qt5 xmlpatterns)
  mark_as_advanced(qt_xmlpatterns_executable)
  set(xmlpatterns_result 1)
  if (qt_xmlpatterns_executable)
    execute_process(COMMAND "${qt_xmlpatterns_executable}" -version
      RESULT_VARIABLE xmlpatterns_result OUTPUT_QUIET ERROR_QUIET)
  endif ()
  find_package(Qt5 QUIET COMPONENTS Help)
  set(missing_for_help)
  if (NOT Qt5Help_FOUND)
    list(APPEND missing_for_help "Qt5Help (Debian: qttools5-dev, qttools5-dev-tools)")
  endif ()
  if (NOT xmlpatterns_result EQUAL 0)
    list(APPEND missing_for_help "xmlpatterns (Debian: qtxmlpatterns5-dev-tools)")
  endif ()
  if (missing_for_help)
    list(JOIN missing_for_help " and " missing_for_help)
    message(FATAL_ERROR "The plugin's help pages need ${missing_for_help}. Install that, or build "
      "without help pages: -DANISOTROPIC_REMESHING_PARAVIEW_HELP=OFF")
  endif ()
endif ()

find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(help_pages_dir "${CMAKE_CURRENT_BINARY_DIR}/help")
set(help_filters
  AnisotropicRemesher RestrictedVoronoiDiagram GaussMapEmbedding SurfaceMeshComparison)
set(help_pages "${help_pages_dir}/index.html")
set(help_sections)
foreach (filter IN LISTS help_filters)
  list(APPEND help_pages "${help_pages_dir}/filters.${filter}.html")
  string(REGEX REPLACE "([a-z])([A-Z])" "\\1 \\2" title "${filter}")
  string(APPEND help_sections "<section title=\"${title}\" ref=\"filters.${filter}.html\"/>")
endforeach ()
set(help_xmls ${server_manager_xmls})
file(GLOB help_headers CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/../Filters/vtk*.h")

# ParaView makes pages of its own from the XML first. Those of the filters are replaced by these,
# those of the base proxies, which nobody asks for, removed.
set(paraview_pages_dir "${CMAKE_CURRENT_BINARY_DIR}/paraview_help")
add_custom_command(
  OUTPUT ${help_pages}
  COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_LIST_DIR}/make_help.py"
          --headers "${CMAKE_CURRENT_SOURCE_DIR}/../Filters"
          --xml ${help_xmls}
          --output "${help_pages_dir}"
          --prune "${paraview_pages_dir}"
  DEPENDS ${help_xmls} ${help_headers}
          AnisotropicRemeshing_doc "${paraview_pages_dir}/AnisotropicRemeshing_doc.xslt"
          "${CMAKE_CURRENT_LIST_DIR}/make_help.py"
          "${CMAKE_CURRENT_LIST_DIR}/header_comments.py"
          "${CMAKE_CURRENT_LIST_DIR}/proxies.py"
  COMMENT "Writing the plugin's help pages"
  VERBATIM)

set(help_arguments
  XML_DOCUMENTATION ON
  DOCUMENTATION_DIR "${help_pages_dir}"
  DOCUMENTATION_TOC
    "<toc><section title=\"Surface Remeshing\" ref=\"index.html\">${help_sections}</section></toc>"
  DOCUMENTATION_DEPENDENCIES ${help_pages})
