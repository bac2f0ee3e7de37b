#!/bin/sh
# run.sh [release] [paraview] [asan]: installs what is needed, builds and tests; default all three.
#   release   Debian's VTK, -Wall -Wextra -Werror        -> build/
#   paraview  Debian's ParaView, with the plugin,        -> build-paraview/
#             but for the core's tests and fuzzers
#   asan      Address- and UndefinedBehaviorSanitizer    -> build-asan/
# The last line sums up: N passed, N failed, N skipped. A build that fails counts as one failure.
cd "$(dirname "$0")/.." || exit 1
root=$(pwd)
jobs=$(nproc)
passed=0 failed=0 skipped=0
[ $# -gt 0 ] || set -- release paraview asan

packages=vtk
case " $* " in *" paraview "*) packages="vtk paraview" ;; esac
# shellcheck disable=SC2086 # a list of words
CMake/install-packages.sh $packages || { echo "0 passed, 1 failed, 0 skipped"; exit 1; }

# Sanitizers: VTK, the drivers and TBB keep memory until exit.
export LSAN_OPTIONS="suppressions=$root/Testing/lsan.supp:print_suppressions=0"
export UBSAN_OPTIONS=print_stacktrace=1

# build_and_test PRESET DIR: one configuration; adds to the counts.
build_and_test()
{
  echo "=== $1"
  if ! cmake --preset "$1" -DANISOTROPIC_REMESHING_WARNINGS_AS_ERRORS=ON ||
    ! cmake --build "$2" --parallel "$jobs"; then
    echo "=== $1: the build failed"
    failed=$((failed + 1))
    return
  fi
  report=$root/$2/ctest.xml
  rm -f "$report"
  # Without -noreset, a client that comes as the last one leaves finds no server.
  xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" \
    ctest --test-dir "$2" --output-on-failure --parallel "$jobs" --output-junit "$report"
  status=$?
  # <testsuite ... tests="T" failures="F" disabled="D" skipped="S" ...>
  counts=$(/usr/bin/python3 - "$report" <<'PY'
import sys, xml.etree.ElementTree
suite = xml.etree.ElementTree.parse(sys.argv[1]).getroot()
failed = int(suite.get("failures"))
skipped = int(suite.get("skipped")) + int(suite.get("disabled"))
print(int(suite.get("tests")) - failed - skipped, failed, skipped)
PY
  ) || counts="0 1 0"
  # shellcheck disable=SC2086 # three words
  set -- $counts
  passed=$((passed + $1)) failed=$((failed + $2)) skipped=$((skipped + $3))
  # Anything else that ctest finds wrong, as a missing executable.
  [ "$status" -eq 0 ] || [ "$2" -gt 0 ] || failed=$((failed + 1))
}

for build; do
  case $build in
    release) build_and_test release build ;;
    asan) build_and_test asan build-asan ;;
    paraview)
      if CMake/paraview-prefix.sh build-paraview/prefix; then
        build_and_test paraview build-paraview
      else
        echo "=== paraview: the prefix could not be made"
        failed=$((failed + 1))
      fi
      ;;
    *) echo "run.sh: no build named $build" >&2; failed=$((failed + 1)) ;;
  esac
done

echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ]
