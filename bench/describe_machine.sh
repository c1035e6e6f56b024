#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# describe_machine.sh BUILD: one sentence on what the figures were measured with, for the page.
set -euo pipefail
build=${1:?usage: describe_machine.sh BUILD}
cpu=$(sed -n 's/^model name[[:space:]]*: //p' /proc/cpuinfo | head -n 1)
compiler=$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$build/CMakeCache.txt")
commit=$(git log -1 --format='%h of %cd' --date=short 2>/dev/null || echo "unknown")
changed=$(git status --porcelain -- ':!docs' 2>/dev/null | head -n 1)
printf 'Measured on %s cores (%s), %s, with the code of commit %s%s.\n' "$(nproc)" "${cpu:-unknown processor}" \
  "$("$compiler" --version | head -n 1)" "$commit" "${changed:+ and changes not yet committed}"
