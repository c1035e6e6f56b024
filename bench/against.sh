#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# against.sh COMMIT [--only WORD...]: whole commands of build/release beside those of another commit: instructions, CPU
# seconds, written bytes. The other commit is built once, by its own CMake, in build/against/COMMIT. Designs are that
# commit's examples, so that both programs can read them. JOBS: how many compilers at once.
set -euo pipefail
shopt -s inherit_errexit
export LC_ALL=C

commit=$(git rev-parse --verify --quiet "${1:?usage: against.sh COMMIT [--only WORD...]}^{commit}") ||
  { echo "against.sh: no commit '$1' in this repository" >&2; exit 2; }
words=("${@:2}")
[[ ${#words[@]} -eq 0 || (${words[0]} == --only && ${#words[@]} -gt 1) ]] ||
  { echo "usage: against.sh COMMIT [--only WORD...]" >&2; exit 2; }
words=("${words[@]:1}")

against=$PWD/build/against
other_tree=$against/${commit:0:12}
programs=("$other_tree/build/release/app/latticast" "$PWD/build/release/app/latticast")
run=$against/run
clock=$run/still_clock.so

build_other() {
  [[ ! -x ${programs[0]} ]] || return 0
  echo "== Building ${commit:0:12} in $other_tree, once" >&2
  mkdir -p "$other_tree"
  git archive "$commit" | tar -x -C "$other_tree"
  (cd "$other_tree" && cmake --preset release && cmake --build --preset release --parallel "${JOBS:-1}") >&2
}

# Both programs run in folders whose paths are equally long, because lengths of paths and of the environment move the
# stack and change how many instructions it takes to handle them.
prepare_run() {
  rm -rf "$run"
  mkdir -p "$run/0" "$run/1" "$run/designs"
  local side design
  for side in 0 1; do cp "${programs[side]}" "$run/$side/latticast"; done
  for design in "$other_tree"/examples/*/*.toml; do cp "$design" "$run/designs/"; done
  cat >"$run/designs/lattice_80x20.toml" <<'DESIGN'
name = "lattice"
[[segment]]
length = 850
  [segment.liner]
  inner_radius = 12
  thickness = 4
  material = "ecoflex-00-50"
  [segment.lattice]
  thickness = 2
  material = "hei-cast-8400"
    [segment.lattice.rings]
    count = 80
    width = 2
    [[segment.lattice.grid]]
    angle = 36
    count = 20
    width = 2
[make]
lattice = true
[export]
formats = ["stl"]
tolerance = 0.01
DESIGN
  "${CXX:-c++}" -std=c++20 -O1 -shared -fPIC -o "$clock" bench/still_clock.cpp
}

# One line per command: its name, then its arguments.
commands() {
  echo "version --version"
  local verb design name
  for verb in predict check build; do
    for design in "$run"/designs/*.toml; do
      name=$(basename "$design" .toml)
      [[ $name != lattice_80x20 || $verb == build ]] || continue
      echo "$verb-$name $verb ../designs/$name.toml$([[ $verb != build ]] || echo ' -o out')"
    done
  done
}

chosen_commands() {
  local line word
  commands | while read -r line; do
    [[ ${#words[@]} -gt 0 ]] || echo "$line"
    for word in "${words[@]}"; do [[ ${line%% *} != *"$word"* ]] || { echo "$line" && break; }; done
  done
}

# The processor of each side: with one processor the program starts one thread, whose order repeats.
processor_of() {
  local allowed
  allowed=$(taskset -pc $$ | sed 's/.*: //')
  [[ $1 == 0 ]] && echo "${allowed%%[-,]*}" || echo "${allowed##*[-,]}"
}

# Instructions of one side, the loader's included. Cachegrind without its cache counts what callgrind counts in half the time.
count_instructions() {
  local side=$1
  shift
  cd "$run/$side"
  rm -rf out
  env -i LD_PRELOAD="$clock" taskset -c "$(processor_of "$side")" valgrind --tool=cachegrind --cache-sim=no \
    --cachegrind-out-file=/dev/null --log-file="$run/$side/log" ./latticast "$@" >stdout 2>stderr || true
  sed -n 's/.*I *refs: *//p' log | tr -d , >instructions
}

# Everything that a command writes, durations being 0.
write_bytes() {
  local side=$1
  shift
  cd "$run/$side"
  rm -rf out bytes
  mkdir bytes
  local status=0
  env -i LD_PRELOAD="$clock" taskset -c "$(processor_of "$side")" ./latticast "$@" >bytes/stdout 2>bytes/stderr || status=$?
  echo "$status" >bytes/status
  [[ ! -d out ]] || mv out bytes/
}

cpu_seconds() {
  local side=$1 TIMEFORMAT='%U %S'
  shift
  cd "$run/$side"
  rm -rf out
  { time env -i taskset -c "$(processor_of 0)" ./latticast "$@" >stdout 2>stderr || true; } 2>&1 |
    awk '{ printf "%.3f\n", $1 + $2 }'
}

# The least of five turns, taken alternately.
least_cpu_seconds() {
  local turn side
  for turn in 1 2 3 4 5; do
    for side in 0 1; do (cpu_seconds "$side" "$@") >>"$run/$side/seconds"; done
  done
  for side in 0 1; do sort -n "$run/$side/seconds" | head -n 1 && rm "$run/$side/seconds"; done
}

compare() {
  local name=$1 side
  shift
  for side in 0 1; do (count_instructions "$side" "$@") & done
  wait
  for side in 0 1; do (write_bytes "$side" "$@"); done
  local seconds differing
  seconds=$(least_cpu_seconds "$@" | tr '\n' ' ')
  differing=$(diff -rq "$run/0/bytes" "$run/1/bytes" | sed -E "s|^Files $run/0/bytes/(.*) and .*|\1|; s|^Only in $run/(.)/bytes|only in \1|" |
    tr '\n' ' ') || true
  # shellcheck disable=SC2086  # two numbers
  printf '%s %s %s %s %s\n' "$name" "$(cat "$run/0/instructions")" "$(cat "$run/1/instructions")" $seconds |
    awk -v differing="${differing:-same}" '{
      printf "%-26s %15.0f %15.0f %7.4f %8.3f %8.3f %6.2f  %s\n", $1, $2, $3, $3 / $2, $4, $5,
             ($4 > 0 ? $5 / $4 : 1), differing }'
}

# Milliseconds of the solver for the 13 pressures of the twisting example: what this machine is worth just now.
yardstick() {
  cd "$run/$1"
  local turn
  for turn in 1 2 3 4 5; do
    # Programs from before --times write them always.
    { ./latticast predict ../designs/twisting.toml --format csv --times ||
      ./latticast predict ../designs/twisting.toml --format csv; } 2>/dev/null |
      awk -F, 'NR > 1 && NR <= 14 { sum += $15 } END { printf "%.3f\n", sum / 1000 }'
  done | sort -n | head -n 1
}

build_other
prepare_run
printf '%-26s %15s %15s %7s %8s %8s %6s  %s\n' command "${commit:0:12}" "this tree" ratio "CPU s" "this" ratio bytes
chosen_commands | while read -r name arguments; do
  # shellcheck disable=SC2086  # a list of words
  compare "$name" $arguments </dev/null
done
printf '13 pressures of the twisting example: %s ms, this tree %s ms\n' "$(yardstick 0)" "$(yardstick 1)"
