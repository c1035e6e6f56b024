#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# report_page_test.sh NODE MODULES PAGE_FROM_PARTS KIND: makes the page of a made-up report and checks it in Chromium.
# MODULES is the folder of npm's packages. Exit status 77 says that a program is missing.
set -euo pipefail
node=$1 modules=$2 page_from_parts=$3 kind=$4
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")

# shellcheck source=tests/end_to_end/report_page/needs.sh
. "$here/needs.sh"

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$node" "$here/sample.mjs" "$folder" "--$kind"
"$page_from_parts" "Sample" "$folder" "$folder/report.html"
LATTICAST_NODE_MODULES=$modules "$node" "$here/report_page_test.mjs" "$folder/report.html"
