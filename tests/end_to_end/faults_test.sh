#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Full disks, failing renames, lost output and killed builds, fifty of each: no folder is left with files of two builds,
# nothing stays behind, and the exit status tells. faults_test.sh PROGRAM SOURCE_TREE SHIM
set -uo pipefail
program=$1
source_tree=$2
shim=$3
# Where syncing costs nothing, if there is such a place.
place=/dev/shm
[[ -w $place ]] || place=${TMPDIR:-/tmp}
work=$(mktemp -d -p "$place")
trap 'rm -rf "$work"' EXIT
# shellcheck source=tests/end_to_end/expect.sh
. "$source_tree/tests/end_to_end/expect.sh"
cd "$work" || exit 1
export ASAN_OPTIONS=verify_asan_link_order=0:detect_leaks=0

sed 's/^formats = .*/formats = ["stl", "obj", "3mf", "ply", "glb", "off"]/; /^preview/d' \
  "$source_tree/examples/twisting/twisting.toml" >new.toml
sed 's/inner_radius = 12$/inner_radius = 12.5/' new.toml >old.toml
sed 's/^\[make\]/[make]\npreview = { pressures = [500] }/' new.toml >burst.toml
parts=(--only liner,flat-pattern)

expect 0 "$program" --quiet build new.toml -o new "${parts[@]}"
expect 0 "$program" --quiet build old.toml -o old "${parts[@]}"
rm old/*.off # so that the new set has a file that the old one has not
echo mine >old/mine
cp old/mine new/mine
holds test "$(find new -type f | wc -l)" -eq 9

# same FOLDER OTHER: the same files, hidden ones too, with the same bytes.
same() { diff -rq "$1" "$2" >"$work/differences"; }
# whole FOLDER: the old set or the new one, and nothing else.
whole() { same "$1" old || same "$1" new; }

# faulty KIND CALLS AT COMMAND...
faulty() {
  local kind=$1 calls=$2 at=$3
  shift 3
  env FAULT_KIND="$kind" FAULT_CALLS="$calls" FAULT_AT="$at" LD_PRELOAD="$shim" "$@"
}

# Errors: the old set stays, or the build is done where the failing call was not needed.
faults() {
  local kind=$1 calls=$2 count=$3 status failed=0 i
  for ((i = 0; i < count; ++i)); do
    rm -rf built && cp -r old built
    faulty "$kind" "$calls" "$i" "$program" --quiet build new.toml -o built "${parts[@]}" >"$work/out" 2>"$work/err"
    status=$?
    out=$(<"$work/out") err=$(<"$work/err") last="fault $kind $calls $i"
    case $status in
      0) holds same built new ;;
      4) failed=$((failed + 1)); holds same built old ;;
      *) wrong "status $status" ;;
    esac
  done
  echo "$kind $calls: $failed of $count runs failed"
  [[ $failed -ge ${4:-1} ]] || wrong "too few faults: $failed"
}
faults once r 50 8
faults once rlsmu 50 20
faults full w 50 9
faults full lwm 50 9

# Where renaming fails for good, undoing does too; the next build puts the older files back, whatever it comes to.
stuck=0
for ((i = 9; i < 20; ++i)); do
  rm -rf built && cp -r old built
  faulty full r "$i" "$program" --quiet build new.toml -o built "${parts[@]}" >"$work/out" 2>"$work/err"
  status=$? out=$(<"$work/out") err=$(<"$work/err") last="stuck $i"
  if [[ $status -eq 4 ]]; then
    stuck=$((stuck + 1))
    expect 3 "$program" --quiet build burst.toml -o built --only preview
    holds same built old
  fi
done
[[ $stuck -ge 5 ]] || wrong "too few: $stuck"

# Killed: whatever the next build comes to, the folder holds one set, and nothing is left over.
killed=0
for ((i = 0; i < 60; ++i)); do
  rm -rf built && cp -r old built
  # The shell's own line about the killed process is not wanted.
  { faulty kill rlsmuw "$i" "$program" --quiet build new.toml -o built "${parts[@]}" >"$work/out" 2>"$work/err"; } 2>/dev/null
  status=$?
  last="kill $i"
  [[ $status -eq 137 ]] && killed=$((killed + 1))
  [[ $status -eq 137 || $status -eq 0 ]] || wrong "status $status"
  "$program" --quiet build burst.toml -o built --only preview >"$work/out" 2>"$work/err"
  [[ $? -eq 3 ]] || wrong "the build after it ended with another status than 3"
  holds whole built
  expect 0 "$program" --quiet build new.toml -o built "${parts[@]}"
  holds same built new
done
echo "killed: $killed of 60"
[[ $killed -ge 50 ]] || wrong "too few kills: $killed"

# Lost output, however it is lost and whatever was said: 4. What was asked for is made all the same.
lost=0
lost() {
  local status=$? said=$1
  lost=$((lost + 1))
  last="lost output: $said"
  [[ $status -eq 4 ]] || wrong "status $status instead of 4"
}
commands=("predict new.toml" "predict new.toml --format csv" "predict new.toml --format json" "predict new.toml --shape tip"
  "check new.toml" "check new.toml --format json" "audit new/twisting-36-liner.stl" "materials" "materials ecoflex-00-50"
  "--version" "--help" "predict --help" "build new.toml --dry-run" "build new.toml -o lost --only liner")
for command in "${commands[@]}"; do
  # shellcheck disable=SC2086
  {
    "$program" $command >/dev/full 2>"$work/err"; lost "$command >/dev/full"
    "$program" $command >&- 2>"$work/err"; lost "$command >&-"
    { sleep 0.05; "$program" $command 2>"$work/err"; echo $? >"$work/status"; } | :
    (exit "$(<"$work/status")"); lost "$command | :"
  }
done
for command in "predict missing.toml" "build new.toml -o lost --only liner" "audit missing.stl" "nonsense" "predict"; do
  # shellcheck disable=SC2086
  {
    "$program" $command 2>/dev/full >"$work/out"; lost "$command 2>/dev/full"
    "$program" $command 2>&- >"$work/out"; lost "$command 2>&-"
  }
done
# What nobody wrote to is not lost; what cannot be read is told.
"$program" -q predict new.toml --pressure 10 -o answer.csv >&- 2>&-
[[ $? -eq 0 ]] || wrong "a closed output that is not written to is no loss"
expect 4 bash -c '"$1" predict - <&-' _ "$program"
err_says "standard input"
holds test "$(ls -A lost)" = "$(cd new && ls twisting-36-liner.*)"
holds cmp lost/twisting-36-liner.stl new/twisting-36-liner.stl
echo "lost output: $lost"
[[ $lost -ge 50 ]] || wrong "too few: $lost"

finish
