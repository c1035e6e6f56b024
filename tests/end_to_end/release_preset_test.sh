#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# release_preset_test.sh ROOT: builds the `release` preset, in which a room compiles as one source, and runs it: private
# names that clash within a room show nowhere else.
set -euo pipefail
root=$(cd "${1:?usage: release_preset_test.sh ROOT}" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

cd "$root"
# Only whether it compiles matters here, not how fast it runs.
cmake --preset release -B "$folder" -DCMAKE_CXX_FLAGS_RELEASE=-O0
cmake --build "$folder" --parallel 2
"$folder/app/latticast" predict examples/twisting/twisting.toml --pressure 0:60:20 --format csv
