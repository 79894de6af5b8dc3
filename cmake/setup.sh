# Sourced by run.sh and test.sh in the project's folder. Nothing here needs a network where nothing is
# missing.

say() { printf '%s\n' "pennon: $*" >&2; }

fail() {
  say "$@"
  exit 1
}

# The packages of these sections of packages.txt.
listed_packages() {
  awk -v wanted=" $* " '
    { sub(/#.*/, "") }
    /^\[/ { gsub(/[][[:space:]]/, ""); is_wanted = index(wanted, " " $0 " "); next }
    is_wanted && NF { print $1 }' packages.txt
}

missing_packages() {
  local package
  for package in $(listed_packages "$@"); do
    [[ $(dpkg-query --show --showformat='${db:Status-Status} ' "$package" 2>/dev/null) == installed* ]] ||
      printf '%s\n' "$package"
  done
}

# Installs what is missing of the sections: install_packages run test.
install_packages() {
  command -v dpkg-query >/dev/null && command -v apt-get >/dev/null ||
    fail "this system has no apt-get. Install what corresponds to these packages of Debian 12:" \
      "$(listed_packages "$@" | xargs). Then: cmake --preset release && cmake --build --preset release"
  local missing as_root=()
  mapfile -t missing < <(missing_packages "$@")
  ((${#missing[@]})) || return 0
  if ((EUID != 0)); then
    command -v sudo >/dev/null ||
      fail "these packages are missing, and installing them takes root: ${missing[*]}"
    as_root=(sudo)
  fi
  say "installing ${missing[*]}"
  "${as_root[@]}" apt-get update
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install --yes --no-install-recommends "${missing[@]}"
}

# Builds the two programs and what installing them takes. A folder that was configured with the tests
# keeps them.
set_up_programs() {
  install_packages run
  say "configuring and building the programs in build/"
  local with_tests=OFF
  ! grep --quiet '^PENNON_TESTS:[A-Z]*=ON$' build/CMakeCache.txt 2>/dev/null || with_tests=ON
  cmake --preset release -D PENNON_TESTS=$with_tests
  cmake --build --preset release --target pennon pennon-global pennon_manual
}

# Builds the programs and the tests; with VALIDATION or BENCHMARKS those too.
set_up_tests() {
  install_packages run test ${1:+"${1,,}"}
  say "configuring and building in build/"
  cmake --preset release ${1:+-D "PENNON_$1=ON"}
  cmake --build --preset release
}
