#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What other people's programs make of our files: outside_programs_test.sh PROGRAM SOURCE_TREE
# Needs admesh, prusa-slicer, ezdxf and rsvg-convert.
set -uo pipefail
program=$1
source_tree=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# shellcheck source=tests/end_to_end/expect.sh
. "$source_tree/tests/end_to_end/expect.sh"
cd "$work" || exit 1
for needed in admesh prusa-slicer ezdxf rsvg-convert; do
  command -v "$needed" >/dev/null && continue
  echo "skipped: there is no $needed"
  exit 77
done

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
  first_size=
  for mesh in "$example"/*; do
    expect 0 prusa-slicer --export-gcode --support-material -o "$work/sliced.gcode" "$mesh"
    holds test -s "$work/sliced.gcode"
    holds test -z "$(grep -iE 'repair|error|warn|manifold|open edge' "$work/out" "$work/err")"
    expect 0 prusa-slicer --info "$mesh"
    says "manifold = yes"
    says "number_of_parts =  1"
    # Every format gives the same size in mm; the actuator is 85 mm long.
    says "size_z = 85.000000"
    size=$(grep '^size_' <<<"$out")
    holds test "$size" = "${first_size:=$size}"
  done
done

# Flat patterns: a DXF reader finds nothing to mend and reads millimetres; an SVG renderer makes a
# picture of the size that is written in it, 25.4 dots an inch being one a millimetre.
expect 0 "$program" build "$source_tree/examples/twisting/twisting.toml" -o flat --only flat-pattern
sed 's/^lattice = true/flat_pattern = true/; /^preview/d; /^liner/d' \
  "$source_tree/examples/bending/bending.toml" >bending.toml
expect 0 "$program" build bending.toml -o flat
for drawing in flat/*.dxf; do
  expect 0 ezdxf audit "$drawing"
  says "No errors found"
  holds test -z "$(grep -iE 'fixed|unrecoverable' "$work/out" "$work/err")"
  holds /usr/bin/python3 - "$drawing" <<'END'
import sys
import ezdxf
drawing = ezdxf.readfile(sys.argv[1])
outlines = drawing.modelspace().query("LWPOLYLINE")
assert drawing.units == 4, drawing.units
assert all(outline.closed for outline in outlines)
assert {outline.dxf.layer for outline in outlines} == {"LATTICE", "SHEET"}
sheet = [o for o in outlines if o.dxf.layer == "SHEET"][0].get_points("xy")
size = [sheet[2][axis] - sheet[0][axis] for axis in (0, 1)]
assert abs(size[0] - 106.81415022205297) < 1e-9 and abs(size[1] - 85) < 1e-9, sheet
points = [point for outline in outlines for point in outline.get_points("xy")]
for mark in drawing.modelspace().query("LINE TEXT"):
    points += [mark.dxf.start, mark.dxf.end] if mark.dxftype() == "LINE" else [mark.dxf.insert]
assert min(min(point[0], point[1]) for point in points) >= 0
END
done
for drawing in flat/*.svg; do
  expect 0 rsvg-convert --dpi-x 25.4 --dpi-y 25.4 -o picture.png "$drawing"
  holds /usr/bin/python3 - "$drawing" picture.png <<'END'
import re, struct, sys
text = open(sys.argv[1], encoding="utf-8").read()
width, height = (float(x) for x in re.search(r'width="([\d.]+)mm" height="([\d.]+)mm"', text).groups())
pixels = struct.unpack(">II", open(sys.argv[2], "rb").read()[16:24])
assert abs(pixels[0] - width) <= 1 and abs(pixels[1] - height) <= 1, (pixels, width, height)
END
done

finish
