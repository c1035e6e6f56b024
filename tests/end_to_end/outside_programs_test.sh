#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What other people's programs make of our files: outside_programs_test.sh PROGRAM SOURCE_TREE
# Needs admesh and prusa-slicer.
set -uo pipefail
program=$1
source_tree=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# shellcheck source=tests/end_to_end/expect.sh
. "$source_tree/tests/end_to_end/expect.sh"
cd "$work" || exit 1

# What prusa-slicer says of a mesh's size, line by line.
size_of() {
  prusa-slicer --info "$1" 2>"$work/err" | grep -E '^size_[xyz] = '
}

for example in twisting two_families; do
  sed 's/"stl", "obj"/"stl", "obj", "3mf"/' "$source_tree/examples/twisting/$example.toml" >"$example.toml"
  expect 0 "$program" build "$example.toml" -o "$example" --only lattice
  holds test "$(find "$example" -type f | wc -l)" -eq 3
  for mesh in "$example"/*.stl; do
    expect 0 admesh "$mesh"
    # "Total disconnected facets : 0 0", one part, and no fix of any kind.
    holds awk '/Total disconnected facets/ && ($5 != 0 || $6 != 0) { exit 1 }' "$work/out"
    holds awk -F: '/(Edges fixed|Facets removed|Facets added|Facets reversed|Backwards edges|Normals fixed)/ && $2 + 0 != 0 { exit 1 }' "$work/out"
    says "Number of parts       :     1"
  done
  for mesh in "$example"/*; do
    expect 0 prusa-slicer --export-gcode --support-material -o "$work/sliced.gcode" "$mesh"
    holds test -s "$work/sliced.gcode"
    holds test -z "$(grep -iE 'repair|error|warn|manifold|open edge' "$work/out" "$work/err")"
    expect 0 prusa-slicer --info "$mesh"
    says "manifold = yes"
    says "number_of_parts =  1"
    # Every format gives the same size in mm; the actuator is 85 mm long.
    says "size_z = 85.000000"
    holds test "$(size_of "$mesh")" = "$(size_of "$(echo "$example"/*.stl)")"
  done
done

finish
