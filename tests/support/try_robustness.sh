#!/usr/bin/env bash
# Tries to make pennon fail: interrupts, restarts with other cases, folders of others, odd values, a
# world that does not work. Prints a table of what was tried and answered well, by class, and fails
# where anything was not.
#
# usage: tests/support/try_robustness.sh PENNON [FOREIGN_FILES]
#   PENNON         the program
#   FOREIGN_FILES  test_foreign_files or test_foreign_files_validation: the files of others too
#
# Answered well: the exit code is the one that the README gives for this, nothing ends by a signal,
# nothing takes longer than a minute, what is refused is refused in words that name the thing, and
# what is interrupted goes on to the same bits.
set -uo pipefail

pennon=$(readlink -f "$1")
foreign_files=${2:+$(readlink -f "$2")}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

class="" classes=()
declare -A tried well
begin() { class=$1 && classes+=("$class") && tried[$class]=0 && well[$class]=0; }
# count "WHAT" HOLDS...: HOLDS is a command.
count() {
  local what=$1
  shift
  tried[$class]=$((tried[$class] + 1))
  if "$@"; then well[$class]=$((well[$class] + 1)); else echo "not well: $class: $what" >&2; fi
}

# answers CODE WORDS COMMAND...: the exit code, and the words in what it says.
answers() {
  local code=$1 words=$2 status
  shift 2
  timeout --kill-after=5 60 "$@" >out 2>&1 </dev/null
  status=$?
  if ((status != code)); then
    echo "exit code $status in place of $code" >&2
    head -5 out >&2
    return 1
  fi
  grep -q 'terminate called\|what():\|basic_string\|std::' out && return 1
  [[ -z $words ]] || grep -qF -- "$words" out
}

cat >flag.toml <<'END'
[flag]
mu = 0.1
K_B = 1e-3
gravity = [0.0, 9.0, 0.0]
[dns]
dt = 2e-3
t_end = 12.0
[dns.flag]
n_y = 24
[dns.initial]
A = [0.2]
[dns.output]
checkpoint_interval = 0.2
END
cat >coupled.toml <<'END'
[flag]
mu = 0.125
K_B = 1e-4
damping = 0.02
[flow]
Re = 200.0
[dns]
n_rho = 16
n_theta = 32
wall_spacing = 0.06
dt = 0.01
t_end = 2.0
[dns.initial]
A = [0.05]
[dns.probes]
y = [2.0]
z = [0.25]
END
sed 's/^mu/gamma = 2.0\nmu/; s/^dt = 0.01/dt = 0.01\nn_x = 4/; s/t_end = 2.0/t_end = 0.6/' coupled.toml >span.toml

# A run that a signal meets once (timeout without --foreground sends it twice) after so many seconds,
# and that goes on afterwards.
interrupted() {
  local case=$1 signal=$2 after=$3 ranks=$4 run=()
  ((ranks == 1)) || run=(mpiexec --oversubscribe -n "$ranks")
  local results=$case.$signal.$ranks restart=() status
  rm -rf "$results"
  { timeout --foreground --kill-after=30 --signal="$signal" "$after" \
    "${run[@]}" "$pennon" dns "$case.toml" --quiet --output "$results" >out 2>&1 </dev/null; } 2>/dev/null
  status=$?
  # 124: the signal was sent, and the run ended by itself; 137: it was killed.
  ((status == 0 || status == 124 || status == 137)) || return 1
  ((ranks == 1)) || sleep 4 # the ranks of a killed mpiexec end a moment later
  [[ ! -f $results/summary.json ]] || return 0 # it was done before
  # A program that has only begun to load says nothing and leaves nothing; one that has not begun to
  # step has nothing to go on from.
  if [[ $signal != KILL && -d $results ]]; then
    grep -q 'stopped by' out || return 1
    [[ ! -f $results/checkpoint.h5 ]] || grep -q 'go on with --restart' out || return 1
  fi
  [[ -f $results/checkpoint.h5 ]] && restart=(--restart "$results/checkpoint.h5")
  timeout 120 "${run[@]}" "$pennon" dns "$case.toml" --quiet --force --output "$results" \
    "${restart[@]}" >out 2>&1 </dev/null || return 1
  # Every step has a row, with all digits.
  cmp -s "$case.whole.$ranks/history.csv" "$results/history.csv"
}

begin "interrupts"
for case in flag coupled span; do
  answers 0 "" "$pennon" dns "$case.toml" --quiet --output "$case.whole.1" || exit 1
  for signal in TERM INT USR1 USR2 HUP KILL; do
    for after in 0.3 0.5 0.8; do
      count "$case $signal after $after s" interrupted "$case" "$signal" "$after" 1
    done
  done
done
answers 0 "" mpiexec --oversubscribe -n 2 "$pennon" dns span.toml --quiet --output span.whole.2 || exit 1
for after in 0.8 1.2; do
  count "two ranks, KILL after $after s" interrupted span KILL "$after" 2
done

begin "restarts with another case"
answers 0 "" "$pennon" dns coupled.toml --quiet --output start --set dns.t_end=0.2 || exit 1
answers 0 "" "$pennon" dns flag.toml --quiet --output start_flag --set dns.t_end=0.2 || exit 1
restart=("$pennon" dns coupled.toml --quiet --output again --restart start/checkpoint.h5
  --set dns.t_end=0.3)
while read -r key value; do
  count "$key" answers 2 "$key" "${restart[@]}" --set "$key=$value"
done <<'END'
flag.mu 0.2
flag.K_B 2e-4
flag.K_S 400
flag.nu_s 0.2
flag.damping 0.03
flag.leading_edge clamped
flow.Re 300
dns.R 6
dns.wall_spacing 0.05
dns.wake_clustering 0.2
dns.n_rho 18
dns.n_theta 34
dns.initial.A [0.06]
dns.fluid.convection central
END
for change in flag.mu=0.2 flow.Re=300 flag.damping=0.03; do
  count "$change, meant" answers 0 "" "${restart[@]}" --force --change --set "$change"
done
count "the end is reached" answers 2 "t_end" "${restart[@]}" --force --set dns.t_end=0.1
count "an empty name" answers 2 "--restart" "$pennon" dns coupled.toml --output again --restart ""
count "a missing file" answers 2 "nowhere.h5" "$pennon" dns coupled.toml --output again --restart nowhere.h5
count "a checkpoint of a flag" answers 2 "" "$pennon" dns coupled.toml --output again --force \
  --restart start_flag/checkpoint.h5
count "another time step" answers 0 "" "${restart[@]}" --force --set dns.dt=0.005

begin "folders"
answers 0 "" "$pennon" lsa coupled.toml --quiet --output theory || exit 1
count "the same case again" answers 0 "" "$pennon" lsa coupled.toml --quiet --output theory
count "another case" answers 2 "flag.mu" "$pennon" lsa coupled.toml --set flag.mu=0.2 --output theory
count "another command" answers 2 "" "$pennon" dns coupled.toml --output theory
count "another case, meant" answers 0 "" "$pennon" lsa coupled.toml --set flag.mu=0.2 --output theory --force
mkdir other && echo "a letter" >other/letter.txt && echo "t,x" >other/history.csv
count "files of someone else" answers 2 "history.csv" "$pennon" dns coupled.toml --output other
rm other/history.csv
beside_a_letter() {
  answers 0 "" "$pennon" lsa coupled.toml --output other && [[ $(<other/letter.txt) == "a letter" ]]
}
count "other files beside the results" beside_a_letter
count "a file in its place" answers 1 "flag.toml" "$pennon" lsa coupled.toml --output flag.toml
two_at_once() {
  "$pennon" dns coupled.toml --quiet --output both --set dns.t_end=20 >/dev/null 2>&1 &
  local first=$! answered
  sleep 0.7
  answers 2 "$first" "$pennon" dns coupled.toml --quiet --output both --set dns.t_end=20
  answered=$?
  kill -9 "$first"
  wait "$first" 2>/dev/null
  # A lock whose process is gone does not bind.
  ((answered == 0)) && answers 0 "" "$pennon" dns coupled.toml --quiet --output both --force
}
count "two runs at once" two_at_once
mkfifo pipe.toml
count "a pipe as a case" answers 2 "pipe.toml" "$pennon" lsa pipe.toml
mkdir with_pipe && mkfifo with_pipe/case.resolved.toml
count "a pipe among results" answers 2 "" "$pennon" lsa coupled.toml --output with_pipe

begin "values"
while read -r command key value; do
  count "$key = $value" answers 2 "${key##*.}" "$pennon" "$command" coupled.toml --output values --force \
    --set "$key=$value" --check
done <<'END'
lsa flag.mu 0
lsa flag.mu -1
lsa flag.mu nan
lsa flag.mu inf
lsa flag.mu 1e400
lsa flag.mu "light"
lsa flag.mu [1,2]
lsa flag.nu_s 0.6
lsa flag.K_B -1e-4
lsa flag.gamma 0
lsa flow.Re 0
lsa flow.Re -10
lsa flow.Ree 10
lsa flg.mu 1
lsa lsa.k_y nan
lsa lsa.added_mass "wue"
lsa lsa.k_y 9223372036854775808
dns dns.n_rho 5
dns dns.n_rho 60.5
dns dns.n_rho 1000000000
dns dns.n_theta 31
dns dns.n_theta 0
dns dns.dt 0
dns dns.dt -0.1
dns dns.R 0.1
dns dns.wall_spacing 0
dns dns.wall_spacing 1e-5
dns dns.t_end -1
dns dns.initial.A [99,99]
dns dns.output.history_interval -1
dns dns.output.fields_interval 1
dns dns.probes.y [2.0,3.0]
dns dns.probes.y [99.0]
modes modes.normal.m 0
modes modes.normal.family "bessels"
modes modes.global.target [1]
modes modes.global.n_theta 31
END

begin "the world outside"
count "standard output full" answers 1 "" bash -c "exec '$pennon' lsa coupled.toml --output full >/dev/full"
count "standard output closed" answers 1 "" bash -c "exec '$pennon' lsa coupled.toml --output full --force >&-"
count "both outputs closed" answers 1 "" bash -c "exec '$pennon' lsa coupled.toml --output full --force >&- 2>&-"
nobody_reads() {
  bash -c "'$pennon' lsa coupled.toml --output piped 2>err | true; exit \${PIPESTATUS[0]}"
  [[ $? == 1 && -f piped/summary.json ]] && grep -q "standard output" err
}
count "a pipe that nobody reads" nobody_reads
mkdir bin && ln -s "$(command -v env)" bin/env
count "no ssh" answers 0 "" env PATH="$folder/bin" "$pennon" dns span.toml --quiet --set dns.t_end=0.02 --output no_ssh
count "no gnuplot" answers 0 "" env PATH="$folder/bin" "$pennon" modes coupled.toml --output no_gnuplot
printf '#!/bin/sh\nexit 1\n' >bin/gnuplot && chmod +x bin/gnuplot
count "a gnuplot that fails" answers 0 "" env PATH="$folder/bin:/usr/bin:/bin" "$pennon" modes coupled.toml --output bad_gnuplot
count "GNUTERM" answers 0 "" env GNUTERM=nonsense "$pennon" modes coupled.toml --output gnuterm
count "threads without end" answers 0 "" env OMP_NUM_THREADS=100000 "$pennon" lsa coupled.toml --output threads
cp coupled.toml ...toml
count "a name of dots" answers 2 "the name of a case" "$pennon" lsa ...toml --output dots
cp coupled.toml $'escape\e[31m.toml'
escapes_are_shown() {
  answers 0 "" "$pennon" lsa $'escape\e[31m.toml' --output escape && ! grep -q $'\e\[31m' out
}
count "escapes in a name" escapes_are_shown
count "two ranks where one works" answers 2 "" mpiexec --oversubscribe -n 2 "$pennon" lsa coupled.toml --output ranks

# The foreign files count themselves: "KIND: 12 refused, 3 taken".
if [[ -n $foreign_files ]]; then
  begin "files of others"
  "$foreign_files" --gtest_brief=1 >foreign 2>&1
  status=$?
  number=$(sed -n 's/^.*: \([0-9]*\) refused, \([0-9]*\) taken$/\1 \2/p' foreign | awk '{n += $1 + $2} END {print n + 0}')
  tried[$class]=$number
  ((status == 0)) && well[$class]=$number || tail -20 foreign >&2
fi

printf '| class | tried | answered well |\n|---|---|---|\n'
all_well=0
for class in "${classes[@]}"; do
  printf '| %s | %d | %d |\n' "$class" "${tried[$class]}" "${well[$class]}"
  ((tried[$class] > 0 && tried[$class] == well[$class])) || all_well=1
done
exit $all_well
