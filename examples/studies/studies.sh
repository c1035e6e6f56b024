#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The paper's parameter studies as CSV files and plots: studies.sh [FOLDER]
#   bending.csv      angle and stretch over pressure and width ratio, by both column models
#   twisting.csv     twist and stretch over pressure and strip angle
#   two-families.csv twist and stretch at 40 kPa over the second family's angle, the first at 30 degrees
# The program is $LATTICAST, or the release build, or the one on the path. Plots need gnuplot.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
folder=${1:-.}
program=${LATTICAST:-$here/../../build/release/app/latticast}
[[ -x $program ]] || program=$(command -v latticast) || {
  echo "studies.sh: build the program (./dev build), or say where it is: LATTICAST=..." >&2
  exit 2
}
mkdir -p "$folder"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# design LINER_MATERIAL RINGS_AND_GRIDS MODEL: the paper's tube with that lattice.
design() {
  cat <<EOF
name = "study"
[[segment]]
length = 85
liner = { inner_radius = 12, thickness = 4, material = "$1" }
[segment.lattice]
thickness = 2
material = "hei-cast-8400"
$2
[model]
$3
EOF
}

# rows PRESSURES COLUMNS PREFIX: the design on standard input, predicted; chosen columns after a prefix.
# A pressure beyond the limit point has no row (status 3), which a study takes as it is.
rows() {
  cat >"$work/study.toml"
  local status=0
  "$program" --quiet predict "$work/study.toml" --pressure "$1" --format csv >"$work/rows.csv" 2>"$work/errors" ||
    status=$?
  [[ $status -eq 0 || $status -eq 3 ]] || {
    cat "$work/errors" >&2
    exit "$status"
  }
  tail -n +2 "$work/rows.csv" | cut -d, -f"$2" | sed "s/^/$3,/"
}

bending() {
  echo "model,width_2_mm,pressure_kPa,stretch,bend_deg"
  local width columns
  for width in 2 2.25 2.5 2.75 3 3.5 4 4.5 5 6 7 8 9 10; do
    columns="angle = 90, count = 16, width = { from = 2, to = $width, profile = \"halves\" }"
    # Radius and arc of the rods are fitted to the paper's plots; those of the distributed columns are not.
    design ecoflex-00-50-linear \
      "grid = [ { $columns, horseshoe = { radius = 3.5, arc = 170 } } ]" 'columns = "rods"' |
      rows 0:300:4 2,3,6 "rods,$width"
    ((${width%.*} < 6)) || continue # wider columns have no place on the tube
    design ecoflex-00-50 "rings = { count = 8, width = 2 }
grid = [ { $columns, horseshoe = { radius = 2.65625, arc = 180 } } ]" 'columns = "distributed"' |
      rows 0:100:4 2,3,6 "distributed,$width"
  done
}

twisting() {
  echo "joint,angle_deg,pressure_kPa,stretch,twist_per_length_rad_per_mm"
  local joint angle
  for joint in paper clear-span; do
    for ((angle = 20; angle <= 70; angle += 2)); do
      design ecoflex-00-50 "rings = { count = 8, width = 2 }
grid = [ { angle = $angle, count = 8, width = 2 } ]" "joint = \"$joint\"" |
        rows 0:60:5 2,3,5 "$joint,$angle"
    done
  done
}

two_families() {
  echo "second_angle_deg,pressure_kPa,stretch,twist_per_length_rad_per_mm"
  local angle
  for ((angle = 20; angle <= 160; angle += 2)); do
    # At 30 degrees the second family would lie on the first.
    [[ $angle -ne 30 ]] || continue
    design ecoflex-00-50 "rings = { count = 8, width = 2 }
grid = [ { angle = 30, count = 8, width = 2 }, { angle = $angle, count = 8, width = 2 } ]" '' |
      rows 40 2,3,5 "$angle"
  done
}

bending >"$folder/bending.csv"
twisting >"$folder/twisting.csv"
two_families >"$folder/two-families.csv"
if command -v gnuplot >/dev/null; then
  gnuplot -e "folder = '$folder'" "$here/plots.gp"
else
  echo "studies.sh: no gnuplot, so no plots: install gnuplot-nox" >&2
fi
ls "$folder"/*.csv "$folder"/*.png 2>/dev/null || true
