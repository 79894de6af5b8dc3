#!/usr/bin/env bash
# Proves that packages.txt names all that pennon needs, section by section: makes a bare Debian 12 in a
# temporary folder, clones this checkout (what is committed) into it, and runs there
#
#   PENNON_SETUP_ONLY=1 ./run.sh              with the network
#   PENNON_SETUP_ONLY=1 ./run.sh              again at once, without any network
#   PENNON_SETUP_ONLY=1 ./test.sh             with the network
#   ./test.sh [LABEL]                         without any network
#
# usage: tests/support/prove_bare_system.sh [LABEL]
#
# Says how long each took. With the label lint it installs and runs the lint check instead of the tests.
# Takes root, debootstrap, 4 GB in /var/tmp (or TMPDIR), and the time of a full build. The mirror and
# the settings of apt are those of the system it runs on.
set -euo pipefail

checkout=$(git -C "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" rev-parse --show-toplevel)
suite=bookworm

((EUID == 0)) || { echo "this takes root" >&2; exit 1; }
for program in debootstrap ip; do
  command -v "$program" >/dev/null || { echo "install $program first" >&2; exit 1; }
done

# In a mount namespace of its own, so that no mount outlives it however it ends.
if [[ ${IN_NAMESPACE:-} != 1 ]]; then
  IN_NAMESPACE=1 exec unshare --mount --propagation private "$0" "$@"
fi

tree=$(mktemp -d "${TMPDIR:-/var/tmp}/pennon-bare-XXXXXX")
remove_tree() {
  umount --recursive "$tree/proc" "$tree/sys" "$tree/dev" 2>/dev/null || true
  rm -rf --one-file-system "$tree"
}
trap remove_tree EXIT

mirror=$(apt-get indextargets --format '$(REPO_URI)' "Codename: $suite" 'Created-By: Packages' | head -n 1)
proxy=$(apt-config dump --format '%v%n' Acquire::http::Proxy)
[[ -z $proxy ]] || export http_proxy=$proxy

debootstrap --variant=minbase "$suite" "$tree" "$mirror"
apt-config dump | grep -E '^Acquire::(http|https|Check|Retries)' >"$tree/etc/apt/apt.conf.d/host" || true
cp /etc/resolv.conf /etc/hosts "$tree/etc/"
mount -t proc proc "$tree/proc"
mount --rbind /sys "$tree/sys"
mount --rbind /dev "$tree/dev"
git clone --quiet --no-hardlinks "$checkout" "$tree/pennon"

# Runs a command in the tree with nothing of this system's environment but what is given first.
inside() { env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 "$@"; }

# The loopback device is there on any machine, and MPI needs it.
without_network() {
  inside unshare --net sh -c 'ip link set lo up && exec chroot "$@"' sh "$tree" "$@"
}

with_network() { inside PENNON_SETUP_ONLY=1 chroot "$tree" "$@"; }

step() {
  echo "== $1"
  local start=$SECONDS
  shift
  "$@"
  echo "== took $((SECONDS - start)) s"
}

setup_of_tests=(/pennon/test.sh)
[[ ${1:-} != lint ]] || setup_of_tests+=(lint)

step "the programs, with the network" with_network /pennon/run.sh
step "once more, without a network" \
  without_network env PENNON_SETUP_ONLY=1 /pennon/run.sh
step "what the tests need, with the network" with_network "${setup_of_tests[@]}"
step "the tests, without a network" without_network /pennon/test.sh "$@"
