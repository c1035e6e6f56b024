#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# latticast check on designs and on mesh files: check_test.sh PROGRAM SOURCE_TREE
set -uo pipefail
program=$1
source_tree=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# shellcheck source=tests/end_to_end/expect.sh
. "$source_tree/tests/end_to_end/expect.sh"
cd "$work" || exit 1
fixtures=$source_tree/tests/checks

# Designs: an error is status 1, less is 0.
expect 1 "$program" check "$fixtures/gap-too-small/rejected.toml"
says "error gap-too-small"
says "segment 1, grid 1 strand 8, theta 337.5 degrees"
says "remedy: count = 7"
says "1 error, 0 warnings"
expect 0 "$program" check "$fixtures/gap-too-small/accepted.toml"
says "0 errors"
expect 0 "$program" check "$fixtures/demolding-strain/rejected.toml" --format json
says '"code": "demolding-strain"'
says '"severity": "warning"'
says '"remedy": "lattice_mold.pieces = 5"'
says '"pressure_kPa": null'
expect 2 "$program" check "$fixtures/gap-too-small/rejected.toml" "$fixtures/overhang/rejected.toml"
err_says "one design at a time"
printf 'name = 7\n' >broken.toml
expect 2 "$program" check broken.toml
err_says "broken.toml:1"
expect 4 "$program" check absent.toml

# A build is checked first, as far as its parts need it, and refused on an error.
expect 1 "$program" build "$fixtures/gap-too-small/rejected.toml" -o refused
err_says "error: gap-too-small: segment 1, grid 1 strand 8"
err_says "remedy: count = 7"
err_says "--force"
holds test ! -e refused
expect 0 "$program" build "$fixtures/gap-too-small/rejected.toml" -o forced --force
err_says "in spite of the errors"
holds test -e forced
expect 0 "$program" build "$fixtures/gap-too-small/accepted.toml" -o made

# What is built passes, beside its design too.
expect 0 "$program" build "$source_tree/examples/twisting/twisting.toml" -o built --only lattice,liner
expect 0 "$program" check built/*.stl built/*.obj
says "0 errors, 0 warnings, 0 notes"
expect 0 "$program" check built/*.stl "$source_tree/examples/twisting/twisting.toml"
says "overhang"

# A torn file, among others; one that cannot be read does not keep the rest from being checked.
expect 1 "$program" check built/*.stl "$fixtures/mesh-open-edge/rejected.obj"
says "error mesh-open-edge"
says "rejected.obj"
cp "$fixtures/mesh-open-edge/rejected.obj" TORN.OBJ
expect 1 "$program" check TORN.OBJ --format json
says '"design": null'
says '"value": 3.0'
cp TORN.OBJ $'\xff.obj'
expect 1 "$program" check $'\xff.obj' --format json
expect 4 "$program" check absent.stl TORN.OBJ
says "mesh-open-edge"
err_says "absent.stl"
finish
