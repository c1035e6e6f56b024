#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# predict_preset_test.sh ROOT: builds the `predict` preset with the packages of the geometry part
# hidden from CMake, then shows from the record of the compiler and from the program itself that
# neither a header nor a library of theirs was used, and that the program predicts.
set -euo pipefail
root=$(cd "${1:?usage: predict_preset_test.sh ROOT}" && pwd)
design=$root/examples/twisting/twisting.toml
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

fail() {
  echo "FAILED: $1"
  exit 1
}

# refuse WHAT PATTERN TEXT: fails when TEXT has a line with PATTERN.
refuse() {
  local found
  if found=$(grep -E "$2" <<<"$3"); then
    fail "$1: $found"
  fi
}

hidden=()
for package in CGAL GMP GMPXX MPFR PNG EXPAT Boost TBB; do
  hidden+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON")
done

cd "$root"
# Only what it links matters here, not how fast it runs.
cmake --preset predict -B "$folder" -DCMAKE_CXX_FLAGS_RELEASE=-O0 "${hidden[@]}"
cmake --build "$folder" --parallel 2
program=$folder/app/latticast
[[ -x $program ]] || fail "no program at app/latticast"

headers=$(cmake --build "$folder" -- -t deps)
grep -qE '/kinsol/kinsol\.h$' <<<"$headers" || fail "the record of headers is not what it should be"
refuse "a header of the geometry part was read" \
  '/(CGAL|boost)/|/(gmp|gmpxx|mpfr|png|pngconf|expat|zip|tiny_gltf)\.h$' "$headers"

libraries=$(readelf -d "$program")
grep -qE 'NEEDED.*libsundials_kinsol' <<<"$libraries" || fail "the program does not link KINSOL"
loaded=$(ldd "$program")
refuse "the program needs a library of the geometry part" \
  'lib(gmp|gmpxx|mpfr|png|png16|expat|zip|CGAL|boost[a-z_]*)[.-]' "$libraries"$'\n'"$loaded"

table=$("$program" predict "$design" --pressure 0:60:20 --format csv)
echo "$table"
[[ $(grep -c . <<<"$table") -eq 5 ]] || fail "expected a heading and four pressures"
