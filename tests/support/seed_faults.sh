#!/usr/bin/env bash
# Puts the faults of seeded_faults.txt into the code one at a time, builds the test programs that
# should see each, runs them, and says how many were seen. Works on a copy of what is committed, in
# build-faults/, which it makes or goes on with. First all of these programs must pass without a fault.
#
# usage: tests/support/seed_faults.sh [FIRST [LAST]]     the numbers of the faults, from 1
#
# Fails where fewer than 19 in 20 are seen.
set -euo pipefail
set -f # the filters of tests are no names of files

checkout=$(git -C "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" rev-parse --show-toplevel)
folder=$checkout/build-faults
source=$folder/source
build=$folder/build

trimmed() { sed 's/^[[:space:]]*//; s/[[:space:]]*$//' <<<"$1"; }

# Replaces the text, which must stand in the file once.
put_in() {
  FROM=$2 TO=$3 perl -0pi -e '
    $count = s/\Q$ENV{FROM}\E/$ENV{TO}/g;
    END { exit($count == 1 ? 0 : 9) }' "$1"
}

# Whether a program, as the list names it, passes. A fault that does not compile is none.
passes() {
  local program filter
  program=${1%%:*}
  filter=${1#"$program"}
  ninja -C "$build" "$program" >"$folder/log" 2>&1 || {
    echo "$program does not compile, see $folder/log" >&2
    exit 2
  }
  timeout 900 "$build/tests/$program" --gtest_brief=1 ${filter:+"--gtest_filter=${filter#:}"} >>"$folder/log" 2>&1
}

# The chosen lines of the list.
faults() {
  grep -v -e '^#' -e '^[[:space:]]*$' "$checkout/tests/support/seeded_faults.txt" |
    awk -v first="${1:-1}" -v last="${2:-${1:-1000}}" 'NR >= first && NR <= last { print NR "|" $0 }'
}

mkdir -p "$folder"
[[ -d $source ]] || git clone --quiet --shared "$checkout" "$source"
git -C "$source" fetch --quiet "$checkout" HEAD
git -C "$source" checkout --quiet --force --detach FETCH_HEAD
cmake -S "$source" -B "$build" -G Ninja -D CMAKE_BUILD_TYPE=Release -D PENNON_TESTS=ON \
  -D CMAKE_UNITY_BUILD=ON >"$folder/log"

for program in $(faults "$@" | cut -d'|' -f5 | tr -s ' ' '\n' | sort -u); do
  passes "$program" || {
    echo "$program fails without any fault, see $folder/log" >&2
    exit 2
  }
done

seen=0 tried=0
while IFS='|' read -r number where from to programs; do
  where=$(trimmed "$where") from=$(trimmed "$from") to=$(trimmed "$to")
  put_in "$source/$where" "$from" "$to" || {
    echo "$number $where: the text is not there exactly once: $from" >&2
    exit 2
  }
  tried=$((tried + 1))
  by=""
  for program in $programs; do
    passes "$program" || { by=$program && break; }
  done
  git -C "$source" checkout --quiet --force -- "$where"
  if [[ -n $by ]]; then
    seen=$((seen + 1))
    echo "$number seen by ${by%%:*}: $where: $to"
  else
    echo "$number NOT SEEN: $where: $to"
  fi
done < <(faults "$@")
echo "$seen of $tried faults were seen"
((20 * seen >= 19 * tried))
