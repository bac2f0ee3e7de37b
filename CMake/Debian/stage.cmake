# Run by cpack on what it has installed for the packages, before it packs that. For .deb files:
# the copyright and the changelog of each package, compressed manual pages, the folder of Python
# packages that /usr has, no search paths in programs that use the library in its public folder, and
# the file that makes ParaView load the plugin.
if (NOT CPACK_GENERATOR STREQUAL "DEB")
  return ()
endif ()

# compress(<from> <to>): without name and time, so that the same text gives the same bytes.
function (compress from to)
  execute_process(COMMAND gzip -9nc "${from}" OUTPUT_FILE "${to}" RESULT_VARIABLE result)
  if (NOT result EQUAL 0)
    message(FATAL_ERROR "gzip failed on ${from}")
  endif ()
endfunction ()

# add_documentation(<root> <package>): what every package has in /usr/share/doc.
function (add_documentation root package)
  set(folder "${root}/share/doc/${package}")
  file(MAKE_DIRECTORY "${folder}")
  configure_file("${CPACK_RESOURCE_FILE_LICENSE}" "${folder}/copyright" COPYONLY)
  string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
  file(WRITE "${folder}/changelog"
    "${CPACK_PACKAGE_NAME} (${CPACK_PACKAGE_VERSION}) unstable; urgency=low\n\n"
    "  * Built from the project's sources.\n\n"
    " -- ${CPACK_DEBIAN_PACKAGE_MAINTAINER}  ${date}\n")
  compress("${folder}/changelog" "${folder}/changelog.gz")
  file(REMOVE "${folder}/changelog")
  file(CHMOD "${folder}/copyright" "${folder}/changelog.gz"
    PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
endfunction ()

# Packages of the VTK build alone: the library of the plugin is in a folder of ParaView.
function (use_public_folders root)
  file(GLOB pages "${root}/${CPACK_ANISOTROPIC_REMESHING_MANDIR}/*/*.[1-9]")
  foreach (page IN LISTS pages)
    compress("${page}" "${page}.gz")
    file(CHMOD "${page}.gz" PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
    file(REMOVE "${page}")
  endforeach ()

  # Debian's zsh looks for what packages bring elsewhere than below /usr/local.
  if (EXISTS "${root}/share/zsh/site-functions")
    file(RENAME "${root}/share/zsh/site-functions" "${root}/share/zsh/vendor-completions")
  endif ()

  # Below /usr, Python looks into the folder itself.
  file(GLOB path_files "${root}/lib/python3.*/dist-packages/anisotropic_remeshing.pth")
  foreach (path_file IN LISTS path_files)
    get_filename_component(folder "${path_file}" DIRECTORY)
    get_filename_component(folder "${folder}" DIRECTORY)
    file(REMOVE_RECURSE "${folder}")
  endforeach ()
  set(python "${root}/${CPACK_ANISOTROPIC_REMESHING_PYTHON_DIR}")
  set(usr_python "${root}/lib/python3/dist-packages")
  if (EXISTS "${python}" AND NOT python STREQUAL usr_python)
    get_filename_component(usr_folder "${usr_python}" DIRECTORY)
    file(MAKE_DIRECTORY "${usr_folder}")
    file(RENAME "${python}" "${usr_python}")
    get_filename_component(folder "${python}" DIRECTORY)
    file(REMOVE "${folder}")
  endif ()

  file(GLOB_RECURSE binaries "${root}/bin/*" "${root}/lib/*.so" "${root}/lib/*.so.*")
  foreach (binary IN LISTS binaries)
    if (NOT IS_SYMLINK "${binary}")
      file(RPATH_REMOVE FILE "${binary}") # as an install script of CMake does
    endif ()
  endforeach ()
endfunction ()

file(GLOB stages LIST_DIRECTORIES TRUE "${CPACK_TEMPORARY_DIRECTORY}/*")
foreach (stage IN LISTS stages)
  get_filename_component(component "${stage}" NAME)
  string(TOUPPER "${component}" component)
  set(package "${CPACK_DEBIAN_${component}_PACKAGE_NAME}")
  if (NOT package)
    continue ()
  endif ()
  set(root "${stage}/usr")
  add_documentation("${root}" "${package}")
  if (CPACK_ANISOTROPIC_REMESHING_PARAVIEW_CONF)
    file(WRITE "${root}/${CPACK_ANISOTROPIC_REMESHING_PARAVIEW_CONF}"
      "${CPACK_ANISOTROPIC_REMESHING_PLUGINS_FILE}\n")
  else ()
    use_public_folders("${root}")
  endif ()
endforeach ()
