#!/bin/sh
# demo.sh [MESH [POINTS [ANISOTROPY]]]: installs what is needed, builds, remeshes and draws.
#   MESH        .vtp, .vtk, .ply, .stl or .obj; default: an octopus made by make_surfaces.py
#   POINTS      points of the new mesh; default 3000
#   ANISOTROPY  0 (none) to 1, usual are 0.02 to 0.1; default 0.08
# Leaves Surface.vtp, VoronoiCells.vtp, Sites.vtp, Edges.vtp, report.json and Picture.png in
# build/demo/. Installing packages needs root or sudo, and only if one is missing.
set -e
case ${1:-} in
  -h | --help) sed -n '2,7s/^# //p' "$0"; exit 0 ;;
  "") mesh= ;;
  /*) mesh=$1 ;;
  *) mesh=$(pwd)/$1 ;;
esac
points=${2:-3000}
anisotropy=${3:-0.08}
if [ -n "$mesh" ] && [ ! -f "$mesh" ]; then
  echo "demo.sh: there is no file '$mesh'" >&2
  exit 1
fi

cd "$(dirname "$0")/../.."
CMake/install-packages.sh vtk
cmake --preset release
cmake --build build --target remesh_surface --parallel "$(nproc)"

out=build/demo
mkdir -p "$out"
if [ -z "$mesh" ]; then
  mesh=$out/octopus.vtp
  [ -f "$mesh" ] || /usr/bin/python3 Examples/Gallery/make_surfaces.py "$out"
  set -- --view 2,-3,3.3 --up 0,0,1
else
  set --
fi

build/bin/remesh_surface "$mesh" "$out/Surface.vtp" \
  --points "$points" --anisotropy "$anisotropy" \
  --cells "$out/VoronoiCells.vtp" --sites "$out/Sites.vtp" --edges "$out/Edges.vtp" \
  --report "$out/report.json"
xvfb-run -a /usr/bin/python3 Examples/Gallery/render.py \
  --surface "$out/Surface.vtp" --cells "$out/VoronoiCells.vtp" --edges "$out/Edges.vtp" \
  --output "$out/Picture.png" "$@"
echo "$(pwd)/$out:"
ls "$out"
