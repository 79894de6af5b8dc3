#!/usr/bin/env bash
# Installs what is missing, builds the programs, and runs the main job: the flag of
# data/cases/table1/C2D.toml by local theory, by its modes and in a simulation, the verdicts of the
# paper's Table 1, and the curves and maps of its figures. Results go to results/.
# With PENNON_SETUP_ONLY=1 in the environment it stops after the build.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")"
source cmake/setup.sh

run_pennon() {
  say "$*"
  build/app/pennon "$@"
}

set_up_programs
[[ ${PENNON_SETUP_ONLY:-0} != 1 ]] || exit 0

run_pennon lsa data/cases/table1/C2D.toml
run_pennon modes data/cases/table1/C2D.toml
run_pennon lsa data/cases/verdicts_of_table1.toml
# The simulation goes on where an earlier run.sh was stopped.
checkpoint=results/C2D/dns/checkpoint.h5
if [[ -e $checkpoint && ! -e results/C2D/dns/summary.json ]]; then
  run_pennon dns data/cases/table1/C2D.toml --restart "$checkpoint"
else
  run_pennon dns data/cases/table1/C2D.toml
fi
run_pennon analyze results/C2D
shopt -s nullglob
for case_file in data/cases/figures/*.toml; do
  run_pennon lsa "$case_file"
done

say "done; the results and their pictures are in results/:"
find results -name '*.png' | sort
