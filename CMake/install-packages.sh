#!/bin/sh
# install-packages.sh [vtk] [paraview]: installs the Debian packages that the VTK build, the
# ParaView build or (default) both need. Needs root or sudo, and the network, only if one is
# missing. python3-paraview is not among them: see paraview-prefix.sh.
# Knows Debian 12 (bookworm), 13 (trixie), 14 (forky) and sid, and Ubuntu from 24.04 (noble) on.
set -e
common="cmake ninja-build g++ libeigen3-dev libnanoflann-dev libtbb-dev libcli11-dev
  nlohmann-json3-dev python3 python3-numpy xvfb xauth dpkg-dev file doxygen"
vtk="libvtk9-dev python3-vtk9 python3-mypy"
paraview="paraview paraview-dev python3-mpi4py mpi-default-dev libdouble-conversion-dev
  libx11-dev libfreetype-dev libtiff-dev liblz4-dev libgl-dev libglew-dev openbox"

# The Qt of ParaView's window: 5 until ParaView 5.11, then 6.
release=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
case $release in
  bookworm | noble) qt=5 ;;
  trixie | forky | sid | plucky | questing | resolute) qt=6 ;;
  *) qt=6; echo "install-packages.sh: not tried on $release; taking what Debian 13 has" >&2 ;;
esac
case $qt in
  5) paraview="$paraview qtbase5-dev qhelpgenerator-qt5 libqt5svg5" ;;
  6) paraview="$paraview qt6-base-dev qt6-documentation-tools qt6-svg-plugins" ;;
esac
# ParaView 6 is built with the system's VTK, and its headers include those of VTK for Qt.
case $release in
  forky | sid | resolute) paraview="$paraview libvtk9-qt-dev" ;;
esac

wanted=$common
[ $# -gt 0 ] || set -- vtk paraview
for build; do
  case $build in
    vtk) wanted="$wanted $vtk" ;;
    paraview) wanted="$wanted $paraview" ;;
    *) sed -n "2,5s/^# //p" "$0" >&2; exit 2 ;;
  esac
done

missing=
for package in $wanted; do
  case $(dpkg-query -W -f='${Status}' "$package" 2>/dev/null) in
    *" installed") ;;
    *) missing="$missing $package" ;;
  esac
done
[ -n "$missing" ] || exit 0

if ! command -v apt-get >/dev/null; then
  echo "install-packages.sh: this is not Debian (no apt-get). Please install:$missing" >&2
  exit 1
elif [ "$(id -u)" -eq 0 ]; then
  sudo=
elif command -v sudo >/dev/null; then
  sudo=sudo
else
  echo "install-packages.sh: neither root nor sudo. Please have installed:$missing" >&2
  exit 1
fi
$sudo apt-get update -q
# shellcheck disable=SC2086 # a list of words
$sudo env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $missing
