#!/bin/sh
# demo.sh [MESH [POINTS [ANISOTROPY]]]: installs what is needed, builds, remeshes and draws.
#   MESH        a file that remesh_surface reads; default: an octopus that make_surfaces.py makes
#   POINTS      points of the new mesh, at least 4; default 3000
#   ANISOTROPY  0 (none) to 1, usual are 0.02 to 0.1; default 0.08
# Leaves Surface.vtp, VoronoiCells.vtp, Sites.vtp, Edges.vtp, report.json and Picture.png in a new
# folder of build/demo, as octopus-3000-0.08. Installing packages needs root or sudo, and only if
# one is missing.
set -e

fail()
{
  echo "demo.sh: $1" >&2
  exit 2
}

# is_number TEXT LEAST MOST
is_number()
{
  printf '%s\n' "$1" | grep -Eq '^([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?$' &&
    awk -v x="$1" -v least="$2" -v most="$3" 'BEGIN { exit !(x + 0 >= least && x + 0 <= most) }'
}

case ${1:-} in
  -h | --help) sed -n '2,8s/^# //p' "$0"; exit 0 ;;
  "") mesh= ;;
  -*) fail "there is no option '$1'; --help tells what there is" ;;
  /*) mesh=$1 ;;
  *) mesh=$(pwd)/$1 ;;
esac
points=${2:-3000}
anisotropy=${3:-0.08}
[ $# -le 3 ] || fail "three arguments at most: MESH POINTS ANISOTROPY"
[ -z "$mesh" ] || { [ -f "$mesh" ] && [ -r "$mesh" ]; } || fail "the file '$mesh' cannot be read"
case $points in *[!0-9]*) fail "POINTS is a whole number, not '$points'" ;; esac
is_number "$points" 4 1e9 || fail "POINTS is at least 4, not '$points'"
is_number "$anisotropy" 0 1 || fail "ANISOTROPY is 0 to 1, not '$anisotropy'"

cd "$(dirname "$0")/../.."
CMake/install-packages.sh vtk
cmake --preset release -DBUILD_TESTING=OFF
cmake --build build --parallel "$(nproc)"

mkdir -p build/demo
name=$(basename "${mesh:-octopus}")
name=${name%.*}-$points-$anisotropy
out=build/demo/$name
number=2
until mkdir "$out" 2>/dev/null; do # earlier results stay
  [ -d "$out" ] || fail "the folder '$out' cannot be made"
  out=build/demo/$name-$number
  number=$((number + 1))
done
if [ -z "$mesh" ]; then
  mesh=build/demo/octopus.vtp
  [ -f "$mesh" ] || /usr/bin/python3 Examples/Gallery/make_surfaces.py build/demo octopus
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
