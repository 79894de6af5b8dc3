#!/usr/bin/env bash
# Installs what is missing, builds, and runs the tests. ./test.sh LABEL runs what has one label only:
# unit, verification, regression, or validation, which is left out otherwise because it takes long.
# ./test.sh lint checks style and seeks defects in the sources that changed since they last passed.
# ./test.sh sanitize runs the unit tests under the address and undefined-behaviour sanitizers, in
# build-sanitize/. With PENNON_SETUP_ONLY=1 in the environment it stops after the build.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")"
source cmake/setup.sh

# Needs the compile commands of every source and the header of the commit, but nothing built.
lint() {
  install_packages run test lint
  configure_tests
  cmake --build --preset release --target pennon_commit
  [[ ${PENNON_SETUP_ONLY:-0} == 1 ]] || cmake -D BUILD_DIR=build -P cmake/lint.cmake
}

# No part of the other tests, because all is built once more for it.
sanitize() {
  install_packages run test
  configure_tests sanitize
  cmake --build --preset sanitize --target pennon pennon-global unit_tests
  [[ ${PENNON_SETUP_ONLY:-0} == 1 ]] ||
    ctest --preset sanitize --no-tests=error --parallel 2 --label-regex '^unit$'
}

run_tests() { ctest --preset release --no-tests=error --parallel 2 "$@"; }

known_labels() { ctest --test-dir build --print-labels | sed -n 's/^  *\([a-z]*\)$/\1/p'; }

(($# <= 1)) || fail "usage: ./test.sh [LABEL | lint | sanitize]"
label=${1:-}
case $label in
  lint | sanitize)
    "$label"
    exit
    ;;
esac
set_up
[[ ${PENNON_SETUP_ONLY:-0} != 1 ]] || exit 0

case $label in
  "")
    run_tests --label-exclude '^validation$'
    ;;
  *)
    known_labels | grep --quiet --line-regexp --fixed-strings -- "$label" ||
      fail "no test has the label $label; there are: lint sanitize $(known_labels | xargs)"
    run_tests --label-regex "^$label\$"
    ;;
esac
