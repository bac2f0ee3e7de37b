# Lets Debian's Python find the package below /usr/local without PYTHONPATH. There it looks into
# lib/python3.X/dist-packages alone, not into lib/python3/dist-packages, as it does below /usr: a
# .pth file in the former names the latter. Below other prefixes, the file does nothing.
set(python_site "lib/python${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}/dist-packages")
if (SKBUILD OR NOT EXISTS "/etc/debian_version" OR NOT Python3_EXECUTABLE STREQUAL "/usr/bin/python3"
    OR python_destination STREQUAL python_site)
  return ()
endif ()
file(RELATIVE_PATH from_site "/${python_site}" "/${python_destination}")
file(WRITE "${CMAKE_BINARY_DIR}/anisotropic_remeshing.pth" "${from_site}\n")
install(FILES "${CMAKE_BINARY_DIR}/anisotropic_remeshing.pth"
  DESTINATION "${python_site}" COMPONENT python)
