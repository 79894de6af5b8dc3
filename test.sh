#!/usr/bin/env bash
# Installs what is missing, builds, and runs the lint check and then the tests. ./test.sh LABEL runs
# what has one label only: lint, unit, verification, regression, or validation, which is left out
# otherwise because it takes long. With PENNON_SETUP_ONLY=1 in the environment it stops after the
# build.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")"
source cmake/setup.sh

lint() { cmake -D BUILD_DIR=build -P cmake/lint.cmake; }

run_tests() { ctest --preset release --no-tests=error --parallel 2 "$@"; }

known_labels() { ctest --test-dir build --print-labels | sed -n 's/^  *\([a-z]*\)$/\1/p'; }

(($# <= 1)) || fail "usage: ./test.sh [LABEL]"
set_up
[[ ${PENNON_SETUP_ONLY:-0} != 1 ]] || exit 0

label=${1:-}
case $label in
  "")
    lint
    run_tests --label-exclude '^validation$'
    ;;
  lint) lint ;;
  *)
    known_labels | grep --quiet --line-regexp --fixed-strings -- "$label" ||
      fail "no test has the label $label; there are: lint $(known_labels | xargs)"
    run_tests --label-regex "^$label\$"
    ;;
esac
