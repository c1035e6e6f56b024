#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The command line as a user types it, right and wrong: command_line_test.sh PROGRAM SOURCE_TREE
set -uo pipefail
program=$1
source_tree=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# shellcheck source=tests/end_to_end/expect.sh
. "$source_tree/tests/end_to_end/expect.sh"
design=$source_tree/examples/twisting/twisting.toml
cd "$work" || exit 1

# Every [make] of the example appears, passes its audit, and is the same the second time.
expect 0 "$program" build "$design" -o first
says "twisting-36-lattice.stl: closed, 1 piece, genus 57"
says "twisting-36-liner.stl: closed, 1 piece, genus 1"
says "twisting-36-flat.svg, twisting-36-flat.dxf: flat pattern, 106.814 mm around (R = 17 mm), 85 mm along, 1 piece, 44 holes"
holds test ! -e first/.latticast-*
expect 0 "$program" build "$design" -o second
expect 0 diff -r first second
expect 0 "$program" audit first/*.stl first/*.obj
holds test "$(grep -c '^pass' "$work/out")" -eq 16
holds test "$(find first -type f | wc -l)" -eq 22

# One family more; a bare tube; two segments with their own files.
expect 0 "$program" build "$source_tree/examples/twisting/two_families.toml" -o families
says "two-families-lattice.stl: closed, 1 piece"
sed '/segment.lattice\]/,/^\[load\]/{/^\[load\]/!d}; s/^lattice = true/lattice = false/; /^flat_pattern/d' "$design" >bare.toml
expect 0 "$program" build bare.toml -o bare --only liner
expect 0 "$program" predict bare.toml --pressure 10
{ sed -n '1,/^\[load\]/p' "$design" | sed '$d'
  sed -n '/^\[\[segment\]\]/,/^\[load\]/p' "$design" | sed '$d'
  echo '[load]'; echo '[[load.case]]'; echo 'pressure = [10, 20]'
  echo '[make]'; echo 'lattice = true'; echo 'flat_pattern = true'; echo 'preview = { pressures = [10] }'; } >chain.toml
expect 0 "$program" build chain.toml -o chain
says "twisting-36-segment-2-lattice.stl: closed, 1 piece, genus 57"
holds test -s chain/twisting-36-segment-1-flat.svg
holds test -s chain/twisting-36-segment-2-flat.dxf
expect 0 "$program" predict chain.toml --format csv
holds test "$(tail -n +2 "$work/out" | cut -d, -f1,2 | tr '\n' ' ')" = "1,10 2,20 "

# The plan: each stage once, with its reason; nothing is made.
expect 0 "$program" build "$design" --dry-run -o planned
says "run   lattice        [make] names lattice"
says "skip  horseshoe-law  no strand is a horseshoe"
says "skip  bending        every section is symmetric about its axis"
says "run   flat-pattern   [make] names flat_pattern"
says "skip  lattice-mold   [make] does not name lattice_mold"
says "run   report         [make] names report"
says "skip  liner-mold     [make] does not name liner_mold"
holds test ! -e planned
says "mesh  twisting-36-preview-lattice: 3 x about 61000 triangles"
says "MB of memory"
expect 0 "$program" build "$design" --dry-run --set make.preview.pressures=[5000]
says "size not known: preview at 5000 kPa"
# What is too large is refused at once, with a tolerance that fits.
expect 2 "$program" build "$design" -o planned --set export.tolerance=0.00001
err_says "twisting-36-preview-lattice would have about"
err_says "million triangles, and a mesh may have 20 million"
fitting=$(grep -o '[0-9.]* mm fits' <<<"$err" | cut -d' ' -f1)
expect 0 "$program" build "$design" --dry-run --set "export.tolerance=$fitting"
expect 2 "$program" build "$source_tree/examples/molds/bending_molds.toml" --force -o planned --set export.tolerance=0.00001
err_says "bending-lattice-mold would have about"
holds test ! -e planned
expect 0 "$program" build "$design" --dry-run --only lattice
says "skip  prediction     nothing that is made needs a deformed shape"
says "skip  liner          left out by --only"
expect 0 "$program" build "$design" --only lattice -o narrow
holds test "$(ls narrow | tr '\n' ' ')" = "twisting-36-lattice.obj twisting-36-lattice.stl "
expect 0 "$program" build "$design" --only flat-pattern -o flat
holds test "$(ls flat | tr '\n' ' ')" = "twisting-36-flat.dxf twisting-36-flat.svg "
# A chain whose second segment is a bare tube has one drawing, and says why.
{ sed -n '1,/^\[load\]/p' "$design" | sed '$d'
  sed -n '/^\[\[segment\]\]/,/^  \[segment.lattice\]/p' "$design" | sed '$d'
  echo '[make]'; echo 'flat_pattern = true'; } >half.toml
expect 0 "$program" build half.toml -o half
says "twisting-36-segment-2-flat: no flat pattern, the segment has no lattice"
holds test "$(ls half | tr '\n' ' ')" = "twisting-36-segment-1-flat.dxf twisting-36-segment-1-flat.svg "
expect 2 "$program" build "$design" --only molds -o narrow
err_says "[make] does not ask for it"
expect 2 "$program" build "$design" --only wheel -o narrow
err_says "no such part"

# Prediction: the contract's columns; held coordinates; a limit point is named and gives status 3.
expect 0 "$program" predict "$design" --format csv
holds test "$(head -1 "$work/out")" = "segment,pressure_kPa,stretch,twist_deg,twist_per_length_rad_per_mm,bend_deg,bend_direction_deg,inner_radius_mm,outer_radius_mm,torque_Nmm,moment_Nmm,stable,residual,error_estimate,time_us"
holds test "$(wc -l <"$work/out")" -eq 14
holds awk -F, 'NR > 1 && !($12 == 1 && $13 < 1e-10 && $14 < 1e-9) { exit 1 }' "$work/out"
expect 0 "$program" predict "$design" --format csv --hold twist --pressure 60
holds awk -F, 'NR == 2 && !($4 == 0 && $10 > 800) { exit 1 }' "$work/out"
expect 0 "$program" predict "$design" --format csv --hold stretch --pressure 20
holds awk -F, 'NR == 2 && !($3 == 1 && $16 != 0) { exit 1 }' "$work/out"
expect 0 "$program" predict "$design" --hold bend --pressure 20
expect 2 "$program" predict "$design" --hold tip --pressure 20
err_says "bend in one plane"
expect 2 "$program" predict "$design" --hold tip,twist --pressure 20
err_says "one after the other"
expect 2 "$program" predict "$design" --hold twist --shape tip
err_says "leave --hold out"
expect 0 "$program" predict chain.toml --shape tip
says "pressure_2_kPa"
err_says "1 of 1 cases have an equilibrium; the tip is 0 to 0 mm off"
expect 0 "$program" predict chain.toml --shape centre-line --format json
says '"rest_mm": 170'
expect 3 "$program" predict chain.toml --shape tip --pressure 10,500 --format csv
holds test "$(wc -l <"$work/out")" -eq 2
err_says "1 of 2 cases"
expect 3 "$program" predict "$design" --pressure 0:200:50
err_says "limit point (ballooning) at 104."
says "no equilibrium"
expect 0 "$program" predict "$design" --format json --pressure 5,10
says '"schema_version": 1'
holds test "$(grep -c time_us "$work/out")" -eq 0
expect 0 "$program" predict "$design" --format json --pressure 5 --times
says '"time_us"'
expect 0 "$program" predict "$design" --format csv --pressure 5 --times
holds awk -F, 'NR == 2 && !($15 > 0) { exit 1 }' "$work/out"
# Every answer as its schema says, those of pressures without equilibrium too.
"$program" -q predict "$design" --pressure 0:200:50 -o response.json 2>/dev/null
"$program" -q predict chain.toml --shape tip --pressure 10,500 -o tip.json 2>/dev/null
"$program" -q predict chain.toml --shape centre-line --pressure 10 -o line.json
"$program" -q predict "$source_tree/examples/bending/bending.toml" --hold tip --pressure 10,500 -o force.json 2>/dev/null
"$program" -q predict "$design" --kinds --pressure 10,500 -o kinds.json 2>/dev/null
holds test "$(grep -c '"reason": "' response.json tip.json force.json kinds.json | tr '\n' ' ')" = \
  "response.json:7 tip.json:1 force.json:1 kinds.json:1 "
python3 "$source_tree/tests/end_to_end/validate_json.py" "$source_tree/docs/prediction.schema.json" \
  response.json tip.json line.json force.json kinds.json >"$work/out" 2>"$work/err"
status=$?
out=$(<"$work/out") err=$(<"$work/err") last=validate_json.py
if [[ $status -eq 77 || $status -eq 127 ]]; then
  skip "the JSON Schema, without python3-jsonschema"
else
  holds test "$status" -eq 0
fi
expect 2 "$program" predict "$design" --pressure 0:60
err_says "FROM:TO:STEP"
expect 2 "$program" predict "$design" --pressure 0:60:-5
expect 2 "$program" predict "$design" --pressure 0:60:1e-9
expect 2 "$program" predict "$design" --pressure nan
expect 2 "$program" predict "$design" --format xml

# Wrong designs: every problem at once, nothing written; what this version lacks is said plainly.
sed 's/angle = 36/angle = 200/; s/thickness = 2/thickness = -2/; s/inner_radius = 12/inner_radius = nan/; s/^length/lenght/; s/hei-cast-8400/hei-cast-84000/' "$design" >bad.toml
expect 2 "$program" build bad.toml -o bad
for fragment in lenght nan thickness angle hei-cast-84000 "problems in bad.toml"; do err_says "$fragment"; done
holds test ! -e bad
sed 's/    angle = 36/    angle = 36\n    horseshoe = { radius = 2.5 }/' "$design" >horseshoe.toml
expect 2 "$program" build horseshoe.toml -o bad
err_says "the lattice cannot be drawn"
err_says "segment[0].lattice.grid[0]"
err_says "radius"
holds test ! -e bad
sed 's/pressures = \[10\]/pressures = [10, [5, 10], 10]/' chain.toml >apart.toml
expect 0 "$program" build apart.toml -o apart --only preview
says "twisting-36-segment-2-preview-5_10kPa-liner.stl: closed, 1 piece"
holds test "$(find apart -name '*-preview-10kPa-*.stl' | wc -l)" -eq 4
sed 's/pressures = \[0, 20, 40\]/pressures = [500]/' "$design" >burst.toml
expect 3 "$program" build burst.toml -o bad --only preview
err_says "500 kPa"
holds test ! -e bad
# What cannot be made takes nothing else with it.
expect 3 "$program" build burst.toml -o rest
err_says "500 kPa"
err_says "all other files are in rest"
says "twisting-36-lattice.stl: closed, 1 piece, genus 57"
holds test -s rest/twisting-36-lattice.stl
holds test -z "$(find rest -name '*preview*')"

# A failed build leaves an old file as it was; an unwritable folder is a file error.
mkdir kept && echo old >kept/twisting-36-lattice.stl
expect 3 "$program" build burst.toml -o kept --only preview
holds test "$(cat kept/twisting-36-lattice.stl)" = old
holds test "$(ls -A kept)" = twisting-36-lattice.stl
touch file
expect 4 "$program" build "$design" -o file
mkdir -p way/twisting-36-lattice.obj
expect 4 "$program" build "$design" -o way
holds test "$(ls -A way)" = twisting-36-lattice.obj

# Files that are no meshes, and meshes that are no solids.
expect 4 "$program" audit missing.stl first/twisting-36-liner.stl
says "pass first/twisting-36-liner.stl"
expect 4 "$program" audit "$design"
printf 'solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid s\n' >open.stl
expect 1 "$program" audit open.stl
says "open edge: 3"

# What is no design and no mesh that is read is told so, without a word about TOML's grammar.
printf '\0\1\2' >shape.step
expect 2 "$program" check shape.step
err_says "shape.step: STEP files are not read: meshes end in .stl, .obj"
cp shape.step shape.unknown
expect 2 "$program" check shape.unknown
err_says "shape.unknown: is no design, which is TOML, and no mesh that is read"
holds test "${err/valid TOML/}" = "$err"
expect 2 "$program" predict open.stl
err_says "open.stl: is a mesh"

# Numbers are written as people write them, and a mesh in metres is suspected.
for v in "0 0 0" "0.02 0 0" "0 0.02 0" "0 0 0.02"; do echo "v $v"; done >metres.obj
printf 'f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n' >>metres.obj
expect 0 "$program" audit metres.obj
says "0.00000133333 mm3"
says "note: all of it measures 0.02 x 0.02 x 0.02 mm: if its numbers are metres"
expect 0 "$program" check metres.obj
says "warning mesh-too-small"

# Materials and the command line itself.
expect 0 "$program" materials
says "ecoflex-00-50-tensile"
expect 0 "$program" materials ecoflex-00-50
says "0.022"
expect 2 "$program" materials ecoflex-00-5
err_says "did you mean ecoflex-00-50"
printf '[house-rubber]\nlaw = "yeoh"\nc1 = 0.02\nc2 = 0.001\nc3 = 0\nsource = "own tensile test"\n' >own.toml
expect 0 "$program" --materials own.toml materials house-rubber
says "yeoh"
printf '[mooney-rubber]\nlaw = "mooney"\nc10 = 0.03\nc01 = 0.01\nsource = "own test"\n' >own.toml
printf '[ogden-rubber]\nlaw = "ogden"\nmu = [0.06, -0.02]\nalpha = [2, -2]\nsource = "own test"\n' >>own.toml
expect 0 "$program" --materials own.toml materials
says "mooney, c10 = 0.03, c01 = 0.01 MPa"
says "ogden, mu = [0.06, -0.02] MPa, alpha = [2, -2]"
# The same rubber by either law.
sed 's/"ecoflex-00-50"/"mooney-rubber"/' "$design" >mooney.toml
sed 's/"ecoflex-00-50"/"ogden-rubber"/' "$design" >ogden.toml
expect 0 "$program" --materials own.toml predict mooney.toml --pressure 20
of_mooney=$(sed 's/mooney-rubber//' <<<"$out" | cut -c1-45)
expect 0 "$program" --materials own.toml predict ogden.toml --pressure 20
holds test "$of_mooney" = "$(sed 's/ogden-rubber//' <<<"$out" | cut -c1-45)"
says "stretch"
expect 2 "$program" bild
err_says "did you mean build"
expect 2 "$program"
err_says "latticast predict twisting.toml"
expect 2 "$program" build
err_says "design is required"
expect 2 "$program" predict "$design" --presure 3
err_says "no option '--presure': did you mean --pressure?"
expect 2 "$program" predict "$design" twice.toml
err_says "'twice.toml' is one word too many"
for option in --pressure -o --set --materials --shape --format; do
  expect 2 "$program" predict "$design" $option ""
  err_says "$option"
done
expect 0 "$program" help
says "predict"
for command in build predict check audit materials new; do
  expect 0 "$program" help $command
  says "Example"
  says "latticast $command "
  first=$out
  expect 0 "$program" $command --help
  holds test "$out" = "$first"
done
expect 0 "$program" help help
expect 2 "$program" --verison
err_says "did you mean --version?"
expect 2 "$program" help bild
err_says "did you mean build"
expect 0 "$program" -V
says "latticast "

# A design from standard input, an answer into a file.
"$program" -q predict - --pressure 10 <"$design" >piped.txt
expect 0 "$program" -q predict "$design" --pressure 10
holds test "$out" = "$(<piped.txt)"
expect 0 "$program" predict "$design" --pressure 10 -o answer.csv
holds test -z "$out"
holds test "$(head -c 8 answer.csv)" = "segment,"
expect 4 "$program" predict "$design" --pressure 10 -o missing/answer.csv
"$program" -q check - <"$design" >"$work/out" && out=$(<"$work/out")
says "0 errors"

# Values in place of the design's, by name too; what a path does not find is told.
sed 's/^length = 85/length = 85\nname = "tip"/' "$design" >named.toml
expect 0 "$program" predict named.toml --set segment.tip.length=90 --set segment[0].liner.thickness=3 --pressure 10
says "segment 1 (tip): 90 mm"
expect 0 "$program" build named.toml --set segment.tip.length=60 -o set --only liner
expect 0 "$program" check named.toml --set segment.tip.length=60
expect 2 "$program" predict named.toml --set segment.tpi.length=90 --set segment.0.lenght=90 --pressure 10
err_says "named.toml as set: segment.tpi.length=90: segment is a list, and none of its entries is named tpi. Did you mean tip?"
err_says "named.toml as set: segment[0].lenght = 90: is not a known key. Did you mean length?"
expect 2 "$program" check first/twisting-36-liner.stl --set segment.0.length=90
err_says "there is none among the files"

# Names that would move a terminal are shown, not obeyed.
expect 4 "$program" audit $'a\e[2Jb\u202Ec.stl'
err_says 'a\u001b[2Jb\u202ec.stl'
expect 4 "$program" build missing.toml
expect 0 "$program" --help
says "predict"
expect 0 "$program" --version
expect 0 "$program" --quiet build "$design" -o quiet --only lattice
holds test -z "$err"

# A new design of each kind is ready for every command, and nothing is overwritten.
for kind in twisting bending elongation superimposed; do
  expect 0 "$program" new "$kind"
  err_says "wrote $kind.toml"
  expect 0 "$program" predict "$kind.toml" --pressure 10
  expect 0 "$program" build "$kind.toml" -o "new-$kind" --only lattice,liner
  says "$kind-lattice.stl: closed, 1 piece"
done
cp bending.toml kept.toml
expect 4 "$program" new twisting bending.toml
err_says "bending.toml: exists already"
holds cmp bending.toml kept.toml
expect 0 "$program" new twisting mine.toml
holds cmp mine.toml twisting.toml
expect 0 "$program" new twisting -
holds test "$out" = "$(<twisting.toml)"
expect 2 "$program" new twistin
err_says "did you mean twisting?"
expect 2 "$program" new

finish
