# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by the tests of the page: ends with status 77 where node, npm's packages or chromium are missing.

skip() {
  echo "skipped: $*"
  exit 77
}

[[ -x $node ]] || skip "there is no node"
export CHROMIUM=${CHROMIUM:-$(command -v chromium || true)}
[[ -x $CHROMIUM ]] || skip "there is no chromium"
[[ -d $modules/playwright-core ]] || skip "npm's packages are not there: $modules"
