# Debian packages; CMake/make-packages.sh builds them. With the prefix /usr alone:
#   VTK build       libanisotropic-remeshing0, libanisotropic-remeshing-dev,
#                   python3-anisotropic-remeshing, anisotropic-remeshing-tools
#   ParaView build  paraview-anisotropic-remeshing
option(ANISOTROPIC_REMESHING_DEBIAN_PACKAGES
  "Install for Debian packages: copyright files, a compressed man page, ParaView's configuration" OFF)
if (NOT ANISOTROPIC_REMESHING_DEBIAN_PACKAGES)
  return ()
endif ()
if (NOT CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  message(FATAL_ERROR "ANISOTROPIC_REMESHING_DEBIAN_PACKAGES needs CMAKE_INSTALL_PREFIX=/usr")
endif ()

set(package_folder "${CMAKE_BINARY_DIR}/Packages")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME "anisotropic-remeshing")
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGING_INSTALL_PREFIX "/usr")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
# As Debian's own tools have it; else an address that is an example.
set(CPACK_DEBIAN_PACKAGE_MAINTAINER
  "The AnisotropicRemeshing authors <anisotropic-remeshing@example.org>")
if (DEFINED ENV{DEBFULLNAME} AND DEFINED ENV{DEBEMAIL})
  set(CPACK_DEBIAN_PACKAGE_MAINTAINER "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
endif ()
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

# add_documentation(<component> <package>): what each package has in /usr/share/doc.
function (add_documentation component package)
  install(FILES "${PROJECT_SOURCE_DIR}/LICENSE"
    DESTINATION "share/doc/${package}" RENAME copyright COMPONENT "${component}")
  install(FILES "${package_folder}/changelog.gz"
    DESTINATION "share/doc/${package}" COMPONENT "${component}")
endfunction ()

# compress(<from> <to>): without name and time, so that the same text gives the same bytes.
function (compress from to)
  execute_process(COMMAND gzip -9nc "${from}" OUTPUT_FILE "${to}" RESULT_VARIABLE result)
  if (NOT result EQUAL 0)
    message(FATAL_ERROR "gzip failed on ${from}")
  endif ()
endfunction ()

string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE "${package_folder}/changelog"
  "anisotropic-remeshing (${PROJECT_VERSION}) unstable; urgency=low\n\n"
  "  * Built from the project's sources.\n\n"
  " -- ${CPACK_DEBIAN_PACKAGE_MAINTAINER}  ${date}\n")
compress("${package_folder}/changelog" "${package_folder}/changelog.gz")

set(summary "anisotropic surface remeshing by Voronoi tessellation")
string(JOIN "\n" story
  "Remeshes a surface with a given number of points, adapted to its"
  "curvature: triangles become long along flat directions and small where"
  "the surface bends.")

if (ANISOTROPIC_REMESHING_BUILD_PARAVIEW_PLUGIN)
  # ParaView loads the plugins of the files that paraview.conf beside its programs names.
  file(WRITE "${package_folder}/paraview.conf"
    "../${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/anisotropic-remeshing.plugins.xml\n")
  install(FILES "${package_folder}/paraview.conf"
    DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT plugin)
  set(CPACK_COMPONENTS_ALL runtime paraview_plugins plugin)
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
  add_documentation(plugin paraview-anisotropic-remeshing)

  string(REGEX MATCH "^([0-9]+)\\.([0-9]+)" series "${ParaView_VERSION}")
  math(EXPR next "${CMAKE_MATCH_2} + 1")
  set(CPACK_DEBIAN_PACKAGE_NAME paraview-anisotropic-remeshing)
  set(CPACK_DEBIAN_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "paraview (>= ${series}), paraview (<< ${CMAKE_MATCH_1}.${next}~)")
  set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${summary} (ParaView plugin)")
  set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
    "${story}\nThe plugin for ParaView ${series}, which loads it when it starts.")
  # Beside the plugin.
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_BINARY_DIR}/${library_destination}")
else ()
  compress("${PROJECT_SOURCE_DIR}/Examples/Cxx/remesh_surface.1"
    "${package_folder}/remesh_surface.1.gz")
  install(FILES "${package_folder}/remesh_surface.1.gz"
    DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT tools)
  add_documentation(runtime libanisotropic-remeshing0)
  add_documentation(development libanisotropic-remeshing-dev)
  add_documentation(python python3-anisotropic-remeshing)
  add_documentation(tools anisotropic-remeshing-tools)

  set(CPACK_COMPONENTS_ALL runtime development python tools)
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_BINARY_DIR}/${library_destination}")
  set(library "libanisotropic-remeshing0 (= ${PROJECT_VERSION})")

  set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME libanisotropic-remeshing0)
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
  set(CPACK_DEBIAN_RUNTIME_DESCRIPTION "${summary} (library)\n${story}\nThe library for VTK.")
  file(WRITE "${package_folder}/shlibs"
    "libvtkFiltersAnisotropicRemeshing 0 libanisotropic-remeshing0 (>= ${PROJECT_VERSION})\n")
  file(WRITE "${package_folder}/triggers" "activate-noawait ldconfig\n")
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA
    "${package_folder}/shlibs;${package_folder}/triggers")

  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libanisotropic-remeshing-dev)
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${library}, libvtk9-dev")
  set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
    "${summary} (development)\n${story}\nHeaders and the CMake package.")

  math(EXPR next "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-anisotropic-remeshing)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(interpreter "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next}~)")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "${library}, ${interpreter}, python3-numpy, python3-vtk9")
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION "${summary} (Python 3)\n${story}\nThe package for Python.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    "${PROJECT_SOURCE_DIR}/CMake/Debian/postinst;${PROJECT_SOURCE_DIR}/CMake/Debian/prerm")

  set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME anisotropic-remeshing-tools)
  set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS "${library}")
  set(CPACK_DEBIAN_TOOLS_DESCRIPTION
    "${summary} (command line)\n${story}\nThe program remesh_surface and its manual page.")
endif ()
include(CPack)
