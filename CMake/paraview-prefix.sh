#!/bin/sh
# paraview-prefix.sh DIR: lays out in DIR the installed ParaView plus the files of Debian's
# python3-paraview, which find_package(ParaView) asks for but which cannot be installed beside
# VTK's own python3-vtk9. Then:
#   cmake -DCMAKE_PREFIX_PATH=DIR -DANISOTROPIC_REMESHING_BUILD_PARAVIEW_PLUGIN=ON ...
#   PYTHONPATH=DIR/lib/python3/dist-packages DIR/bin/pvpython script.py
# Needs the packages paraview and paraview-dev, and the network for apt-get download. Does nothing
# if DIR already holds the installed version.
set -e
[ $# -eq 1 ] || { sed -n "2,4s/^# //p" "$0" >&2; exit 2; }
arch=$(dpkg-architecture -qDEB_HOST_MULTIARCH 2>/dev/null || gcc -print-multiarch)
version=$(dpkg-query -W -f='${Version}' paraview-dev)
mkdir -p "$1"
dest=$(cd "$1" && pwd)
[ "$(cat "$dest/version" 2>/dev/null)" != "$version" ] || exit 0

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
(cd "$work" && apt-get download -q "python3-paraview=$version" && dpkg -x python3-paraview_*.deb tree)
rm -rf "${dest:?}/lib" "${dest:?}/bin" "${dest:?}/include"
mkdir -p "$dest/lib/$arch/cmake" "$dest/include" "$dest/bin"
cp -a "$work/tree/usr/lib/." "$dest/lib/"
cp -a "$work/tree/usr/bin/." "$dest/bin/"
# A copy, not a link: the package finds its prefix from the real path of these.
cp -a "/usr/lib/$arch/cmake/paraview-"* "$dest/lib/$arch/cmake/"
dpkg -L paraview paraview-dev |
  sed -n "s,^/usr/\(lib/$arch/[^/]*\|bin/[^/]*\|include/[^/]*\)\$,\1,p" |
  while read -r path; do
    [ -e "$dest/$path" ] || ln -s "/usr/$path" "$dest/$path"
  done
# From trixie on, the modules carry an ABI tag that the CMake package lacks.
find "$dest/lib/python3" -name '*.cpython-*.so' | while read -r path; do
  ln -sf "$(basename "$path")" "${path%%.cpython*}.so"
done
echo "$version" > "$dest/version"
