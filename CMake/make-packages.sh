#!/bin/sh
# make-packages.sh [vtk] [paraview]: builds Debian packages into build-packages/; default both.
#   vtk       libanisotropic-remeshing0, libanisotropic-remeshing-dev,
#             python3-anisotropic-remeshing, anisotropic-remeshing-tools
#   paraview  paraview-anisotropic-remeshing, the plugin for the installed ParaView
# Installs what building needs (see install-packages.sh). Then, as root:
#   apt install ./build-packages/*.deb
# The ParaView build has no Python package: that one is for VTK's own Python.
set -e
cd "$(dirname "$0")/.."
[ $# -gt 0 ] || set -- vtk paraview
for build; do
  case $build in
    vtk | paraview) ;;
    *) sed -n "2,8s/^# //p" "CMake/make-packages.sh" >&2; exit 2 ;;
  esac
done
CMake/install-packages.sh "$@"
umask 022

for build; do
  folder=build-packages-$build
  mkdir -p "$folder" build-packages
  options=
  if [ "$build" = paraview ]; then
    CMake/paraview-prefix.sh "$folder/prefix"
    options="-DCMAKE_PREFIX_PATH=$(pwd)/$folder/prefix -DANISOTROPIC_REMESHING_WRAP_PYTHON=OFF
      -DANISOTROPIC_REMESHING_BUILD_PARAVIEW_PLUGIN=ON -DANISOTROPIC_REMESHING_BUILD_EXAMPLES=OFF"
  fi
  # shellcheck disable=SC2086 # a list of words
  cmake -G Ninja -S . -B "$folder" -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr \
    -DBUILD_TESTING=OFF -DCMAKE_SKIP_INSTALL_RPATH="$([ "$build" = vtk ] && echo ON || echo OFF)" \
    -DANISOTROPIC_REMESHING_DEBIAN_PACKAGES=ON $options
  cmake --build "$folder" --parallel "$(nproc)"
  rm -f "$folder"/*.deb
  (cd "$folder" && cpack)
  mv "$folder"/*.deb build-packages/
done
ls -1 build-packages/*.deb
