#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# design_page_test.sh NODE MODULES PROGRAM DESIGN [SCREENSHOTS]: builds the report of a design and checks its page in
# Chromium, pictures of it going to the folder SCREENSHOTS. Exit status 77 says that a program is missing.
set -euo pipefail
node=$1 modules=$2 program=$3 design=$4 pictures=${5:-}
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
# shellcheck source=tests/end_to_end/report_page/needs.sh
. "$here/needs.sh"

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$program" --quiet build "$design" -o "$folder" >"$folder/files.txt"
page=$(find "$folder" -name '*-report.html')
LATTICAST_NODE_MODULES=$modules "$node" "$here/report_page_test.mjs" "$page" ${pictures:+--screenshots "$pictures"}
