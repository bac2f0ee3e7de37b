#!/bin/sh
# make_pictures.sh [NAME ...]: draws the gallery's pictures anew, with the examples of those names
# (default: all that draw one). Needs the package in build/, or installed, and xvfb.
cd "$(dirname "$0")/../.." || exit 1
PYTHONPATH=$(pwd)/build/lib/python3/dist-packages${PYTHONPATH:+:$PYTHONPATH}
export PYTHONPATH
[ $# -gt 0 ] || set -- points anisotropy tolerance density features decimation cells embedding \
  paper_figures cad_normals convergence adaptation metrics
for name; do
  echo "$name:"
  xvfb-run -a -s "-screen 0 1280x1024x24" /usr/bin/python3 "Examples/Python/$name.py" \
    --picture "Examples/Gallery/$name.png" || exit 1
done
