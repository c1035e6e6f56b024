#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# refresh_page.sh RESULTS PAGE: puts every RESULTS/NAME.md between the lines "<!-- begin NAME -->" and
# "<!-- end NAME -->" of a page. A place without its result keeps what it has and is named; a result
# without a place is named, too. Exit status 1 when anything was named.
set -euo pipefail
shopt -s inherit_errexit
results=${1:?usage: refresh_page.sh RESULTS PAGE}
page=${2:?usage: refresh_page.sh RESULTS PAGE}

complaints=0
complain() {
  printf 'refresh_page.sh: %s\n' "$*" >&2
  complaints=1
}

names=$(sed -n 's/^<!-- begin \([a-z0-9_]*\) -->$/\1/p' "$page")
for name in $names; do
  [[ -e $results/$name.md ]] || complain "$page has a place for $name, but there is no $results/$name.md"
  grep -q "^<!-- end $name -->\$" "$page" || complain "$page does not end $name" 
done
for file in "$results"/*.md; do
  name=$(basename "$file" .md)
  grep -qx "$name" <<<"$names" || complain "$file has no place on $page"
done

new=$(mktemp "$page.XXXXXX")
trap 'rm -f "$new"' EXIT
awk -v results="$results" '
  !inside { print }
  /^<!-- begin [a-z0-9_]+ -->$/ {
    file = results "/" $3 ".md"
    if ((getline line < file) < 0) next
    inside = $3
    do print line; while ((getline line < file) > 0)
    close(file)
  }
  inside && $0 == "<!-- end " inside " -->" { print; inside = "" }
' "$page" >"$new"
chmod --reference="$page" "$new"
mv "$new" "$page"
exit "$complaints"
