#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The report that a build makes, how it shows its progress, and how it stops: build_test.sh PROGRAM SOURCE_TREE
set -uo pipefail
program=$1
source_tree=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# shellcheck source=tests/end_to_end/expect.sh
. "$source_tree/tests/end_to_end/expect.sh"
cd "$work" || exit 1
twisting=$source_tree/examples/twisting/twisting.toml
sed '/^report = /d; s/^preview = .*/&\nreport = true/' "$twisting" >design.toml

# The report: page, numbers, curve; the same bytes in the next run, but for times when they are asked for.
expect 0 "$program" build design.toml -o made --only report
says "twisting-36-report.html"
holds test "$(ls made)" = $'twisting-36-report.html\ntwisting-36-report.json\ntwisting-36-response.csv'
expect 0 "$program" build design.toml -o again --only report
holds cmp made/twisting-36-report.json again/twisting-36-report.json
holds cmp made/twisting-36-response.csv again/twisting-36-response.csv
holds cmp made/twisting-36-report.html again/twisting-36-report.html
holds grep -q '"schema_version": 1' made/twisting-36-report.json
holds grep -q '"stage": "liner-mold"' made/twisting-36-report.json
holds test "$(grep -c '"seconds"' made/twisting-36-report.json)" -eq 0
expect 0 "$program" build design.toml -o timed --only report --times
holds grep -q '"seconds"' timed/twisting-36-report.json
holds test "$(head -1 made/twisting-36-response.csv | tr ',' '\n' | grep -c .)" -eq 13
holds test "$(wc -l <made/twisting-36-response.csv)" -ge 34

# Its pieces are those of the same build, with grams; molds tell what is poured.
expect 0 "$program" build design.toml -o all
holds grep -q '"genus": 57' all/twisting-36-report.json
holds grep -q '"mass_g": [0-9]' all/twisting-36-report.json
sed '/^\[make\]/a report = true' "$source_tree/examples/molds/twisting_molds.toml" >molds.toml
expect 0 "$program" build molds.toml -o molds --only report,liner-mold
holds grep -q '"kind": "pour"' molds/*-report.json

# Without a load there is nothing to predict, and a report all the same.
sed '/^\[load\]/,/^pressure/d' design.toml >idle.toml
expect 0 "$program" build idle.toml -o idle --only report
holds grep -q '"prediction": null' idle/twisting-36-report.json
holds test ! -e idle/twisting-36-response.csv

# Every format; a preview in colours, and as an animation; the parts together.
sed 's/^formats = .*/formats = ["stl", "obj", "3mf", "ply", "glb"]/; s/pressures = \[0, 20, 40\]/pressures = [0, 40]/' design.toml >formats.toml
expect 0 "$program" build formats.toml -o formats --only lattice,liner,preview
for ending in stl obj 3mf ply glb; do
  says "twisting-36-lattice.$ending: closed, 1 piece, genus 57, 7174.51 mm3, 11870 triangles"
  says "twisting-36-preview-40kPa-liner.$ending: closed, 1 piece, genus 1"
done
says "twisting-36-preview.glb"
says "twisting-36-preview-lattice: colours in PLY from strain"
holds grep -aq '"inflate"' formats/twisting-36-preview.glb
holds grep -aq 'property uchar red' formats/twisting-36-preview-40kPa-lattice.ply
holds test "$(head -c 400 formats/twisting-36-lattice.ply | grep -ac 'uchar red')" -eq 0
says "twisting-36.3mf: 2 parts"
expect 0 "$program" audit formats/*-lattice.* formats/*-liner.*
# Together they pass as they do one by one, although the lattice stands on the liner.
expect 0 "$program" audit formats/twisting-36.3mf formats/twisting-36-preview.glb
says "pass formats/twisting-36.3mf: 2 objects, closed, 2 pieces, genus 58"
says "pass formats/twisting-36-preview.glb: 2 objects"
holds test "${out/overlap/}" = "$out"

# Progress is drawn on a terminal: it never falls, and ends at 100.
if script -qec true /dev/null </dev/null >/dev/null 2>&1; then
  script -qec "$program build design.toml -o drawn" drawn.txt </dev/null >/dev/null
  percents=$(grep -aoE '\[ *[0-9]+ %\]' drawn.txt | tr -dc '0-9\n')
  holds test "$(wc -l <<<"$percents")" -ge 40
  holds test "$percents" = "$(sort -n <<<"$percents")"
  holds test "$(head -1 <<<"$percents")" -eq 0
  holds test "$(tail -1 <<<"$percents")" -eq 100
  holds test "$(grep -cx 99 <<<"$percents")" -le 1
  holds grep -aqE '\[ *[0-9]+ %\] twisting-36-preview.png' drawn.txt
else
  skip "progress on a terminal: no pseudo-terminal can be opened"
fi
expect 0 "$program" build design.toml -o undrawn --only lattice
holds test "$(grep -c '%\]' <<<"$err")" -eq 0

# Ctrl-C after the first part: what is there stays, nothing else appears, and it says what was ready.
mkdir stopped && echo old >stopped/twisting-36-lattice.stl
"$program" build design.toml -o stopped 2>stopped.err >/dev/null &
pid=$!
while kill -0 $pid 2>/dev/null && ! grep -q '^twisting-36-lattice: ' stopped.err; do sleep 0.01; done
kill -INT $pid
status=0
wait $pid || status=$?
last="build, interrupted" out="" err=$(<stopped.err)
holds test "$status" -eq 130
err_says "files were ready"
holds test "$(ls -A stopped)" = twisting-36-lattice.stl
holds test "$(<stopped/twisting-36-lattice.stl)" = old
finish
