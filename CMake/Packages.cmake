# Packages, by `cpack` in the build folder, or the target `package`:
#   .tar.gz   all that is installed; works from any folder, with the VTK or ParaView it was built with
#   .deb      where dpkg-dev and file are installed, whatever CMAKE_INSTALL_PREFIX is:
#     VTK build       libanisotropic-remeshing0, libanisotropic-remeshing-dev,
#                     python3-anisotropic-remeshing, anisotropic-remeshing-tools
#     ParaView build  paraview-anisotropic-remeshing (without a Python package: that is for VTK's)
# What is Debian's alone is done on the way, by Debian/stage.cmake. See also make-packages.sh.
set(CPACK_PACKAGE_NAME "anisotropic-remeshing")
set(CPACK_PACKAGE_VENDOR "The AnisotropicRemeshing authors")
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

# --- .tar.gz --------------------------------------------------------------------------------------
set(CPACK_GENERATOR TGZ)
set(system "${CMAKE_SYSTEM_NAME}")
if (EXISTS "/etc/os-release")
  foreach (key IN ITEMS ID VERSION_CODENAME)
    file(STRINGS "/etc/os-release" line REGEX "^${key}=")
    string(REGEX REPLACE "^${key}=\"?([^\"]*)\"?$" "\\1" ${key} "${line}")
  endforeach ()
  set(system "${ID}-${VERSION_CODENAME}")
endif ()
set(built_for "vtk${VTK_VERSION}")
if (ANISOTROPIC_REMESHING_BUILD_PARAVIEW_PLUGIN)
  set(built_for "paraview${ParaView_VERSION}")
endif ()
set(CPACK_PACKAGE_FILE_NAME
  "${CPACK_PACKAGE_NAME}-${PROJECT_VERSION}-${built_for}-${system}-${CMAKE_SYSTEM_PROCESSOR}")

# --- .deb -----------------------------------------------------------------------------------------
find_program(ANISOTROPIC_REMESHING_SHLIBDEPS dpkg-shlibdeps)
find_program(ANISOTROPIC_REMESHING_FILE file)
mark_as_advanced(ANISOTROPIC_REMESHING_SHLIBDEPS ANISOTROPIC_REMESHING_FILE)
if (ANISOTROPIC_REMESHING_SHLIBDEPS AND ANISOTROPIC_REMESHING_FILE)
  list(APPEND CPACK_GENERATOR DEB)
else ()
  message(STATUS "cpack makes .tar.gz alone: .deb files take dpkg-dev and file")
endif ()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
# As Debian's own tools have it; else an address that is an example.
set(CPACK_DEBIAN_PACKAGE_MAINTAINER
  "${CPACK_PACKAGE_VENDOR} <anisotropic-remeshing@example.org>")
if (DEFINED ENV{DEBFULLNAME} AND DEFINED ENV{DEBEMAIL})
  set(CPACK_DEBIAN_PACKAGE_MAINTAINER "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
endif ()
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_BINARY_DIR}/${library_destination}")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_CURRENT_LIST_DIR}/Debian/stage.cmake")
set(CPACK_ANISOTROPIC_REMESHING_MANDIR "${CMAKE_INSTALL_MANDIR}")

# No CPACK_PACKAGE_DESCRIPTION_SUMMARY: that would come before each package's own.
set(summary "anisotropic surface remeshing by Voronoi tessellation")
string(JOIN "\n" story
  "Remeshes a surface with a given number of points, adapted to its"
  "curvature: triangles become long along flat directions and small where"
  "the surface bends.")

# debian_package(<component> <name> <section> <summary's end> <last sentence>)
function (debian_package component name section kind sentence)
  string(TOUPPER "${component}" upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME "${name}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION "${section}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${summary} (${kind})\n${story}\n${sentence}" PARENT_SCOPE)
endfunction ()

if (ANISOTROPIC_REMESHING_BUILD_PARAVIEW_PLUGIN)
  string(REGEX MATCH "^([0-9]+)\\.([0-9]+)" series "${ParaView_VERSION}")
  math(EXPR next "${CMAKE_MATCH_2} + 1")
  set(CPACK_COMPONENTS_ALL runtime paraview_plugins)
  set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
  set(CPACK_COMPONENT_RUNTIME_GROUP plugin)
  set(CPACK_COMPONENT_PARAVIEW_PLUGINS_GROUP plugin)
  debian_package(plugin paraview-anisotropic-remeshing science "ParaView plugin"
    "The plugin for ParaView ${series}, which loads it when it starts.")
  set(CPACK_DEBIAN_PLUGIN_PACKAGE_DEPENDS
    "paraview (>= ${series}), paraview (<< ${CMAKE_MATCH_1}.${next}~)")
  # ParaView loads the plugins of the files that paraview.conf beside its programs names.
  set(CPACK_ANISOTROPIC_REMESHING_PARAVIEW_CONF "${CMAKE_INSTALL_BINDIR}/paraview.conf")
  set(CPACK_ANISOTROPIC_REMESHING_PLUGINS_FILE
    "../${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/anisotropic-remeshing.plugins.xml")
else ()
  set(CPACK_COMPONENTS_ALL runtime development python tools)
  set(CPACK_COMPONENTS_GROUPING IGNORE)
  set(library "libanisotropic-remeshing0 (= ${PROJECT_VERSION})")

  debian_package(runtime libanisotropic-remeshing0 libs "library" "The library for VTK.")
  set(control "${CMAKE_BINARY_DIR}/Packages")
  file(WRITE "${control}/shlibs"
    "libvtkFiltersAnisotropicRemeshing 0 libanisotropic-remeshing0 (>= ${PROJECT_VERSION})\n")
  file(WRITE "${control}/triggers" "activate-noawait ldconfig\n")
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA "${control}/shlibs;${control}/triggers")

  debian_package(development libanisotropic-remeshing-dev libdevel "development"
    "Headers and the CMake package.")
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${library}, libvtk9-dev")

  math(EXPR next "${Python3_VERSION_MINOR} + 1")
  debian_package(python python3-anisotropic-remeshing python "Python 3" "The package for Python.")
  set(interpreter "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next}~)")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "${library}, ${interpreter}, python3-numpy, python3-vtk9")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    "${CMAKE_CURRENT_LIST_DIR}/Debian/postinst;${CMAKE_CURRENT_LIST_DIR}/Debian/prerm")
  set(CPACK_ANISOTROPIC_REMESHING_PYTHON_DIR "${python_destination}")

  debian_package(tools anisotropic-remeshing-tools science "command line"
    "The program remesh_surface and its manual page.")
  set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS "${library}")
endif ()
set(package_generators "${CPACK_GENERATOR}") # CPack leaves those of sources behind
include(CPack)
