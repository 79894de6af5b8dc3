# Sourced by run.sh and test.sh in the project's folder: set_up installs what packages.txt lists and is
# missing, configures and builds. Needs no network where nothing is missing.

say() { printf '%s\n' "pennon: $*" >&2; }

fail() {
  say "$@"
  exit 1
}

listed_packages() { sed -e 's/#.*//' -e '/^[[:space:]]*$/d' packages.txt; }

missing_packages() {
  local package
  for package in $(listed_packages); do
    [[ $(dpkg-query --show --showformat='${db:Status-Status} ' "$package" 2>/dev/null) == installed* ]] ||
      printf '%s\n' "$package"
  done
}

install_packages() {
  command -v dpkg-query >/dev/null && command -v apt-get >/dev/null ||
    fail "this system has no apt-get. Install what corresponds to these packages of Debian 12:" \
      "$(listed_packages | xargs). Then: cmake --preset release && cmake --build --preset release"
  local missing as_root=()
  mapfile -t missing < <(missing_packages)
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

set_up() {
  install_packages
  say "configuring and building in build/"
  cmake --preset release
  cmake --build --preset release
}
