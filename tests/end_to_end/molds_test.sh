#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Molds from the command line, and what other people's programs make of them:
# molds_test.sh PROGRAM SOURCE_TREE. Needs admesh and prusa-slicer.
set -uo pipefail
program=$1
source_tree=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# shellcheck source=tests/end_to_end/expect.sh
. "$source_tree/tests/end_to_end/expect.sh"
examples=$source_tree/examples
cd "$work" || exit 1

# Superimposed columns as well, with a flanged liner.
sed 's/^lattice = true/lattice_mold = {}/; s/^liner = true/liner_mold = { ends = "flanged" }/; /^preview/d; s/formats = .*/formats = ["stl"]/' \
  "$examples/superimposed/superimposed.toml" >superimposed_molds.toml

for design in "$examples/molds/twisting_molds.toml" "$examples/molds/bending_molds.toml" superimposed_molds.toml; do
  expect 0 "$program" build "$design" -o molds
  says "lattice-mold-core.stl: closed, 1 piece, genus 0"
  says "liner-mold-cap.stl: closed, 1 piece, genus 3"
  says "liner-mold-plug-inlet.stl: closed, 1 piece, genus 1"
  holds test -z "$(grep -v -e ': closed, 1 piece, genus' -e 'the mold taken apart' -e ': print ' \
    -e 'report.html: ' -e 'report.json: ' -e 'response.csv: ' <<<"$out")"
done
holds test "$(find molds -name '*-lattice-mold-shell-*.stl' | wc -l)" -ge 15
holds test "$(find molds -name '*.md' | wc -l)" -eq 6
holds test "$(find molds -name '*.png' | wc -l)" -eq 6
holds grep -q "through the lowest bore" molds/twisting-lattice-mold.md
holds grep -q "hei-cast-8400: the cavity holds 7.2 ml" molds/twisting-lattice-mold.md
holds grep -q "ecoflex-00-50: the cavity holds 29.9 ml" molds/twisting-liner-mold.md

for mesh in molds/*.stl; do
  expect 0 admesh "$mesh"
  holds awk '/Total disconnected facets/ && ($5 != 0 || $6 != 0) { exit 1 }' "$work/out"
  says "Number of parts       :     1"
done
# One of each kind is sliced: shells of all three, a core, plates with openings, a plug.
for mesh in molds/*-lattice-mold-shell-1.stl molds/twisting-lattice-mold-{core,base}.stl \
  molds/twisting-liner-mold-{shell-1,cap,plug-inlet}.stl; do
  expect 0 prusa-slicer --export-gcode -o "$work/sliced.gcode" "$mesh"
  holds test -s "$work/sliced.gcode"
  holds test -z "$(grep -iE 'repair|error|manifold|open edge' "$work/out" "$work/err")"
  expect 0 prusa-slicer --info "$mesh"
  says "manifold = yes"
done

# Parts of it, and the same bytes the second time.
twisting=$examples/molds/twisting_molds.toml
expect 0 "$program" build "$twisting" --only lattice-mold -o narrow
holds test -z "$(find narrow -name '*liner*')"
expect 0 "$program" build "$twisting" --only molds -o again
expect 0 diff -r <(cd molds && ls twisting-*) <(cd again && ls)
for file in again/*; do holds cmp -s "$file" "molds/${file#again/}"; done

# Around a printed pattern: every piece sound, and the page says what stands where.
sed 's/^lattice_mold.*/lattice_mold = { method = "replica" }/; /^liner_mold/d' "$twisting" >replica.toml
expect 0 "$program" build replica.toml -o replica
says "twisting-lattice-mold-pattern.stl: closed, 1 piece, genus 0"
says "twisting-lattice-mold-cap.stl: closed, 1 piece, genus 3"
holds grep -q "Set the pattern into the socket" replica/twisting-lattice-mold.md
holds grep -q "The lattice takes 7.2 ml of hei-cast-8400" replica/twisting-lattice-mold.md
expect 0 prusa-slicer --export-gcode --support-material -o "$work/sliced.gcode" replica/twisting-lattice-mold-pattern.stl
holds test -z "$(grep -iE 'repair|error|manifold|open edge' "$work/out" "$work/err")"

# Bad wishes, each with its own message; nothing is written.
bad_mold() { # MOLD MESSAGE
  sed "/^liner_mold/d; s/^lattice_mold.*/$1/" "$twisting" >bad.toml
  expect 2 "$program" build bad.toml -o bad
  err_says "$2"
  holds test ! -e bad
}
bad_mold 'lattice_mold = { pieces = 1 }' "must be a whole number from 2 to 100"
bad_mold 'lattice_mold = { wall = 0 }' "must be a number from 0.001"
bad_mold 'lattice_mold = { wall = 0.2 }' "the printer's clearance, 0.3 mm, must be less than the mold's wall"
bad_mold 'lattice_mold = { wall = 1.5 }' "grooves for strands 2 mm deep need more wall behind them"
bad_mold 'liner_mold = { ends = "flanged", keyed = true }' "would hang between the flanges"
sed 's/process = "fdm"/process = "fdm"\nbed = [50, 50, 50]/' "$twisting" >bed.toml
expect 1 "$program" build bed.toml -o bad
err_says "error: exceeds-bed: segment 1, lattice-mold core: is 32 x 32 x 104.7 mm"
expect 2 "$program" build bed.toml -o bad --force
err_says "the mold does not fit the printer"
err_says "core is 32 x 32.01 x 104.7 mm"
holds test ! -e bad

# Pieces of one shape are one file; the pages to cast by and the report count them.
cat >twins.toml <<'END'
name = "twins"
[[segment]]
length = 40
liner = { inner_radius = 12, thickness = 4, material = "ecoflex-00-50" }
[[segment]]
length = 40
liner = { inner_radius = 12, thickness = 4, material = "ecoflex-00-50" }
[[segment]]
length = 60
liner = { inner_radius = 12, thickness = 4, material = "ecoflex-00-50" }
[make]
liner_mold = {}
report = true
[load]
pressure = 1
[export]
formats = ["stl"]
END
expect 0 "$program" build twins.toml -o twins --force
says "twins-segment-1-liner-mold-core: print 2 ×"
says "twins-segment-1-liner-mold-plug: print 3 ×"
holds test -z "$(md5sum twins/*.stl | cut -d ' ' -f 1 | sort | uniq -d)"
holds test ! -e twins/twins-segment-2-liner-mold-core.stl
holds test -s twins/twins-segment-3-liner-mold-core.stl
holds grep -q 'twins-segment-1-liner-mold-plug`: print 3 ×, as twins-segment-1-liner-mold-plug, twins-segment-2' twins/twins-segment-3-liner-mold.md
holds grep -q '"prints": 3' twins/twins-report.json
holds test "$(grep -o 'img alt="twins-segment-[123]-liner-mold, taken apart" src="data:image/png;base64,iVBOR' twins/twins-report.html | wc -l)" -eq 3

finish
