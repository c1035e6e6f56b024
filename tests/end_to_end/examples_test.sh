#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Every example is built and does what its README says: examples_test.sh PROGRAM SOURCE_TREE
set -uo pipefail
program=$1
source_tree=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# shellcheck source=tests/end_to_end/expect.sh
. "$source_tree/tests/end_to_end/expect.sh"
examples=$source_tree/examples
cd "$work" || exit 1

# row EXPRESSION: some row of the last command's CSV makes the awk expression true.
row() { awk -F, "NR > 1 && ($1) { found = 1 } END { exit !found }" "$work/out"; }
every_row() { awk -F, "NR > 1 && !($1) { bad = 1 } END { exit bad || NR < 2 }" "$work/out"; }

# All of them are delivered: each mesh read back, closed, in one piece.
for design in "$examples"/*/*.toml; do
  [[ $design != */molds/* ]] || continue # molds_test.sh
  expect 0 "$program" build "$design" -o built
  holds grep -q ': closed, 1 piece, genus' <<<"$out"
  holds test -z "$(grep -v -e ': closed, 1 piece, genus' -e 'side by side' -e ': flat pattern, ' \
    -e 'report.html: ' -e 'report.json: ' -e 'response.csv: ' <<<"$out")"
done
holds test "$(find built -name '*-lattice.stl' | grep -vc preview)" -eq 12
holds test "$(find built -name '*-preview.png' | wc -l)" -eq 10

# What the README prints is a design, and so it is with its second grid in place of the first.
readme=$source_tree/README.md
awk '/^name = "my-twister"/ { on = 1 } /^```/ { if (on) exit } on' "$readme" >my-twister.toml
awk '/^\[\[segment.lattice.grid\]\]/ { on = 1 } /^```/ { if (on) exit } on' "$readme" >grid.toml
holds test -s grid.toml
sed -e '/^grid = /{r grid.toml' -e 'd}' my-twister.toml >tilted.toml
expect 0 "$program" predict my-twister.toml --hold twist --pressure 60
says "855.466"
expect 0 "$program" build my-twister.toml -o readme
expect 0 "$program" build tilted.toml -o readme
holds test "$(grep -c 'closed, 1 piece' <<<"$out")" -ge 5

# Elongation: longer, neither twisted nor bent.
expect 0 "$program" predict "$examples/elongation/elongation.toml" --format csv
every_row '$4 == 0 && $6 == 0 && $12 == 1'
row '$2 == 30 && $3 > 1.13 && $3 < 1.15'

# Bending: toward the thicker half, more with 3.5 mm than with 3 mm; a stop at the tip is pressed harder.
expect 0 "$program" predict "$examples/bending/bending.toml" --format csv
holds row '$2 == 40 && $6 > 18.5 && $6 < 18.7 && $7 == 258.75'
expect 0 "$program" predict "$examples/bending/bending_2_3_5.toml" --format csv
holds row '$2 == 40 && $6 > 23'
expect 0 "$program" predict "$examples/bending/bending.toml" --hold tip --pressure 20,40 --format csv
weaker=$(awk -F, '$2 == 40 { print $3 }' "$work/out")
expect 0 "$program" predict "$examples/bending/bending_2_3_5.toml" --hold tip --pressure 20,40 --format csv
holds row "\$2 == 40 && \$3 > 1.2 * $weaker"
expect 0 "$program" predict "$examples/bending/bending.toml" --hold bend --pressure 20 --format csv
holds row '$6 == 0 && $11 > 50'

# Superimposed: all three at once, and the centre line leaves every plane through the base's axis.
expect 0 "$program" predict "$examples/superimposed/superimposed.toml" --format csv
holds row '$2 == 40 && $3 > 1.25 && $4 < -50 && $6 > 20'
expect 0 "$program" predict "$examples/superimposed/superimposed.toml" --shape centre-line --format csv
holds row '$1 == 9 && $3 == 85 && $4 < -17 && $5 < -13'

# Climbing robot: one gait cycle; alike pressures keep the end faces parallel and move the foot aside.
expect 0 "$program" predict "$examples/climbing_robot/climbing_robot.toml" --shape tip --format csv
holds test "$(head -1 "$work/out")" = "case,pressure_1_kPa,pressure_2_kPa,x_mm,y_mm,z_mm,axis_x,axis_y,axis_z,mark_x,mark_y,mark_z,tilt_deg,twist_deg,length_mm,stable"
holds test "$(wc -l <"$work/out")" -eq 11
holds every_row '$2 != $3 || ($13 < 1e-6 && $13 >= 0)'
holds row '$1 == 5 && $2 == 32 && sqrt($4 * $4 + $5 * $5) > 39'
holds row '$2 == 25 && $3 == 32 && $13 > 4'

# Manipulator: the whole grid; the turn is that of the twisting segment alone.
expect 0 "$program" predict "$examples/manipulator/manipulator.toml" --shape tip --format csv
holds test "$(wc -l <"$work/out")" -eq 144
err_says "143 of 143 cases"
holds row '$2 == 60 && $3 == 30 && $14 < -170'
holds row '$2 == 0 && $3 == 0 && $6 == 200'

# The parameter studies: known values, and pictures of them.
expect 0 env LATTICAST="$program" "$examples/studies/studies.sh" studies
for study in bending twisting two-families; do holds test -s "studies/$study.png"; done
cp studies/bending.csv out
holds row '$1 == "rods" && $2 == 4 && $3 == 20 && $5 > 14.11 && $5 < 14.15'
holds row '$1 == "rods" && $2 == 4 && $3 == 100 && $5 > 42.85 && $5 < 42.89'
holds row '$1 == "rods" && $2 == 10 && $3 == 60 && $5 > 41.64 && $5 < 41.68'
holds every_row '$2 != 2 || $5 < 1e-9'
cp studies/twisting.csv out
# At 40 kPa the twist per deformed length is largest near 37 degrees.
holds test "$(awk -F, '$1 == "paper" && $3 == 40 { t = -$5; if (t > best) { best = t; angle = $2 } } END { print angle }' out)" -eq 36
cp studies/two-families.csv out
holds row '$1 == 150 && $4 < 1e-12 && $4 > -1e-12'
expect 2 env LATTICAST=/nonexistent PATH=/usr/bin:/bin "$examples/studies/studies.sh" studies

finish
