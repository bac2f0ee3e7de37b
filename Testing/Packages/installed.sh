#!/bin/sh
# installed.sh DIR: installs the .deb files of DIR in a throw-away system (see ../chroot.sh), uses
# each without any setting of the environment, and purges them. Fails if one does not work, or if
# anything stays behind. Needs root; changes the system.
set -e
[ $# -eq 1 ] || { sed -n "2,4s/^# //p" "$0" >&2; exit 2; }
here=$(cd "$(dirname "$0")" && pwd)
packages=$(cd "$1" && pwd)
export DEBIAN_FRONTEND=noninteractive
unset PYTHONPATH LD_LIBRARY_PATH PV_PLUGIN_PATH CMAKE_PREFIX_PATH
vtk="libanisotropic-remeshing0 libanisotropic-remeshing-dev python3-anisotropic-remeshing
  anisotropic-remeshing-tools"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# What an installation may change for good: apt's and dpkg's records, logs and caches.
list_files()
{
  find / -xdev \( -path /proc -o -path /sys -o -path /dev -o -path /tmp -o -path /run \
    -o -path /var/lib/dpkg -o -path /var/lib/apt -o -path /var/cache -o -path /var/log \
    -o -path /root -o -path "$packages" \) -prune -o -print | LC_ALL=C sort
}

# add <name>...: installs our packages of these names, with what they depend on.
add()
{
  files=
  for name; do
    files="$files $(echo "$packages/${name}"_*.deb)"
  done
  # shellcheck disable=SC2086 # a list of words
  apt-get install -q -y --no-install-recommends $files >> log 2>&1 || { tail -n 50 log; exit 1; }
}

# purge <name>...: takes our packages away, but not what they depended on.
purge()
{
  apt-get purge -q -y "$@" >> log 2>&1 || { tail -n 50 log; exit 1; }
}

# check_clean <name>...: installs, calls `use`, purges; what is there is as before.
check_clean()
{
  add "$@"
  purge "$@"
  list_files > before
  add "$@"
  use
  purge "$@"
  list_files > after
  diff before after || { echo "installed.sh: these are left of $*" >&2; exit 1; }
}

use_vtk()
{
  cat > cube.obj <<'OBJ'
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
f 4 3 2 1
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
OBJ
  remesh_surface cube.obj cube.vtp --points 200
  test -s cube.vtp
  test -s /usr/share/man/man1/remesh_surface.1.gz
  python3 "$here/../Consumer/check_import.py" /usr/lib/python3/dist-packages
  rm -rf consumer
  cmake -G Ninja -S "$here/../Consumer" -B consumer > configured || { cat configured; exit 1; }
  cmake --build consumer
  consumer/consumer
}

use_paraview()
{
  pvbatch "$here/../InstalledPlugin/check_plugin.py" /usr/lib
}

apt-get update -q > log 2>&1
if ls "$packages"/anisotropic-remeshing-tools_*.deb > /dev/null 2>&1; then
  apt-get install -q -y --no-install-recommends cmake ninja-build g++ >> log 2>&1
  use() { use_vtk; }
  # shellcheck disable=SC2086 # a list of words
  check_clean $vtk
  # ParaView's Python cannot be installed beside VTK's.
  purge libvtk9-dev python3-vtk9
fi
if ls "$packages"/paraview-anisotropic-remeshing_*.deb > /dev/null 2>&1; then
  apt-get install -q -y --no-install-recommends python3-paraview >> log 2>&1 ||
    { tail -n 50 log; exit 1; }
  use() { use_paraview; }
  check_clean paraview-anisotropic-remeshing
fi
echo "installed.sh: the packages work, and leave nothing behind"
