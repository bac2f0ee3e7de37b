#!/bin/sh
# make-packages.sh [vtk] [paraview]: builds packages into build-packages/; default both.
#   vtk       libanisotropic-remeshing0, libanisotropic-remeshing-dev,
#             python3-anisotropic-remeshing, anisotropic-remeshing-tools
#   paraview  paraview-anisotropic-remeshing, the plugin for the installed ParaView
# and a .tar.gz of each build. Installs what building needs (see install-packages.sh). Then, as root:
#   apt install ./build-packages/*.deb
# In a build folder of your own, `cpack` makes the same packages.
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
  # With /usr, libraries go to the folder of the machine's kind, as Debian's own.
  # shellcheck disable=SC2086 # a list of words
  cmake -G Ninja -S . -B "$folder" -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr \
    -DBUILD_TESTING=OFF $options
  cmake --build "$folder" --parallel "$(nproc)"
  rm -f "$folder"/*.deb "$folder"/*.tar.gz
  (cd "$folder" && cpack)
  mv "$folder"/*.deb "$folder"/*.tar.gz build-packages/
done
ls -1 build-packages/*
