# The target `uninstall`, by a record of what was installed. Include this after all install() rules.
# CMake's own install_manifest.txt will not do: cpack writes the same file, with paths of packages.
set(installed_record "${CMAKE_BINARY_DIR}/installed.txt")
install(CODE "
  if (NOT \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}\" MATCHES \"/_CPack_Packages/\")
    set(files)
    foreach (file IN LISTS CMAKE_INSTALL_MANIFEST_FILES)
      string(APPEND files \"\$ENV{DESTDIR}\${file}\\n\")
    endforeach ()
    file(APPEND \"${installed_record}\" \"\${files}\")
  endif ()" ALL_COMPONENTS)

add_custom_target(uninstall
  COMMAND "${CMAKE_COMMAND}" "-Drecord=${installed_record}"
    -P "${CMAKE_CURRENT_LIST_DIR}/RemoveInstalled.cmake"
  COMMENT "Removing what was installed"
  VERBATIM)
