#!/usr/bin/env bash
# Installs what is missing, builds, and runs the tests. ./test.sh LABEL runs what has one label only:
# unit, verification, regression, or validation, which is left out otherwise because it takes long.
# ./test.sh bench builds the benchmarks in build/bench/, to be run by hand. ./test.sh lint checks style
# and seeks defects in the sources that changed since they last passed.
# ./test.sh sanitize runs the unit tests under the address and undefined-behaviour sanitizers, in
# build-sanitize/. ./test.sh kernels runs the tests once under each of several kernels of OpenBLAS
# that this processor can execute, about three minutes each: rounding differs between them, so a bound
# that fails elsewhere fails here. It is run before every release. With PENNON_SETUP_ONLY=1 in the
# environment test.sh stops after the build.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")"
source cmake/setup.sh

# Needs the compile commands of every source and the header of the commit, but nothing built.
lint() {
  install_packages run test lint
  cmake --preset lint
  cmake --build --preset lint --target pennon_commit
  [[ ${PENNON_SETUP_ONLY:-0} == 1 ]] || cmake -D BUILD_DIR=build-lint -P cmake/lint.cmake
}

# No part of the other tests, because all is built once more for it.
sanitize() {
  install_packages run test
  cmake --preset sanitize
  cmake --build --preset sanitize --target pennon pennon-global unit_tests
  [[ ${PENNON_SETUP_ONLY:-0} == 1 ]] ||
    ctest --preset sanitize --no-tests=error --parallel 2 --label-regex '^unit$'
}

run_tests() { ctest --preset release --no-tests=error --parallel 2 "$@"; }

# What /proc/cpuinfo lists of a processor that can execute the kernel.
instructions_of() {
  case $1 in
    Prescott) echo pni ;;
    Nehalem) echo sse4_2 ;;
    Haswell | Zen) echo avx2 fma ;;
    SkylakeX) echo avx512f avx512dq avx512bw avx512vl ;;
  esac
}

missing_instructions() {
  local instruction
  for instruction in $(instructions_of "$1"); do
    grep --quiet "^flags.* $instruction\\( \\|$\\)" /proc/cpuinfo || echo "$instruction"
  done
}

# Whether the BLAS that the tests are linked with takes this kernel when it is asked to.
blas_takes() {
  OPENBLAS_CORETYPE=$1 OPENBLAS_VERBOSE=2 build/tests/test_global_eigensolver --gtest_list_tests 2>&1 |
    grep --line-regexp "Core: $1" >/dev/null
}

run_under_kernels() {
  local kernel missing passed=() failed=()
  [[ $(uname --machine) == x86_64 ]] ||
    fail "the kernels that test.sh knows are those of x86-64, and this is $(uname --machine)"
  for kernel in Prescott Nehalem Haswell Zen SkylakeX; do
    missing=$(missing_instructions "$kernel" | xargs)
    if [[ -n $missing ]]; then
      say "$kernel is left out: this processor lacks $missing"
      continue
    fi
    blas_takes "$kernel" ||
      fail "BLAS does not take the kernel $kernel: it is not an OpenBLAS with several kernels"
    say "the tests under OpenBLAS's kernel $kernel"
    if OPENBLAS_CORETYPE=$kernel run_tests --label-exclude '^validation$'; then
      passed+=("$kernel")
    else
      failed+=("$kernel")
    fi
  done
  say "passed under: ${passed[*]:-none}"
  ((${#failed[@]} == 0)) || fail "failed under: ${failed[*]}"
}

(($# <= 1)) || fail "usage: ./test.sh [LABEL | bench | kernels | lint | sanitize]"
label=${1:-}
case $label in
  lint | sanitize)
    "$label"
    exit
    ;;
  "" | kernels | unit | verification | regression) set_up_tests ;;
  validation) set_up_tests VALIDATION ;;
  bench) set_up_tests BENCHMARKS ;;
  *) fail "no test has the label $label; there are: unit verification regression validation," \
    "and the commands bench kernels lint sanitize" ;;
esac
[[ ${PENNON_SETUP_ONLY:-0} != 1 ]] || exit 0

case $label in
  "")
    run_tests --label-exclude '^validation$'
    ;;
  bench) ls build/bench/bench_* ;;
  kernels) run_under_kernels ;;
  *) run_tests --label-regex "^$label\$" ;;
esac
