#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# structure_test.sh ROOT: the check itself on small trees with one violation each, then the real tree.
set -euo pipefail
root=$(cd "${1:?usage: structure_test.sh ROOT}" && pwd)
check=$root/tests/end_to_end/structure_check.sh
work_folder=$(mktemp -d)
tree=$work_folder/tree
good_tree=$work_folder/good
trap 'rm -rf "$work_folder"' EXIT
failures=0

# put FILE LINE...: a file of the small tree.
put() {
  [[ $1 != */* || -d $tree/${1%/*} ]] || mkdir -p "$tree/${1%/*}"
  printf '%s\n' "${@:2}" >"$tree/$1"
}

# Kept apart from what follows them, so that this file names no such folder itself.
home=/home
work=/work
licence='// SPDX-License-Identifier: GPL-3.0-or-later'

# Laid once, then copied: the processes of a put are what takes the time.
lay_good_tree() {
  rm -rf "$tree"
  if [[ -d $good_tree ]]; then
    cp -r "$good_tree" "$tree"
    return
  fi
  mkdir "$tree"
  put dev '#!/usr/bin/env bash' '# SPDX-License-Identifier: GPL-3.0-or-later' "rm -rf out$work/old"
  put design/design.h "$licence" '#include <vector>'
  put design/private_reader.h "$licence" "struct Section;" '#include <toml++/toml.h>'
  put design/reader.cpp "$licence" '#include "design/private_reader.h"' '#include "design/design.h"'
  put geometry/mesh/triangle_mesh.h "$licence"
  put geometry/solid/audit.h "$licence" '#include "geometry/mesh/triangle_mesh.h"'
  put geometry/solid/audit.cpp "$licence" '#include <CGAL/box_intersection_d.h>' '#include "design/design.h"'
  put model/section/section.h "$licence" '#include "design/design.h"' 'struct Section {' '};'
  put app/build.cpp "$licence" '#include <CLI/CLI.hpp>' '#include "geometry/solid/audit.h"' '#include "model/section/section.h"'
  put tests/unit/audit_test.cpp "$licence" '#include <gtest/gtest.h>' '#include "design/private_reader.h"'
  put examples/one.toml '# A design' "name = \"https://example.org$work/one\""
  put docs/references.md '# References' '- **[Gent 1996]** A. N. Gent.'
  put docs/model.md '# The model' '## Energy of a section, per mm' 'As in [Gent 1996].'
  put model/section/energy.cpp "$licence" '// [Gent 1996] (3), docs/model.md#energy-of-a-section-per-mm.'
  put build/generated.cpp '#include "../x.h"'
  cp -r "$tree" "$good_tree"
}

# refused NAME EXPECTED: the small tree has exactly one violation, reported as EXPECTED (a pattern).
refused() {
  local report status=0
  report=$(bash "$check" "$tree") || status=$?
  if [[ $status -ne 1 || $(grep -c . <<<"$report") -ne 1 ]] || ! grep -qE "$2" <<<"$report"; then
    echo "FAILED: $1: exit status $status, report: $report"
    failures=$((failures + 1))
  fi
}

# violation FILE LINE EXPECTED: adds LINE to FILE of a good tree.
violation() {
  lay_good_tree
  [[ -e $tree/$1 ]] || put "$1" "$licence"
  printf '%s\n' "$2" >>"$tree/$1"
  refused "$2 in $1" "$3"
}

lay_good_tree
bash "$check" "$tree" || {
  echo "FAILED: a good tree is refused"
  failures=$((failures + 1))
}

violation design/design.h '#include "model/section/section.h"' '^design/design.h:3: design must not include model'
violation design/design.h '#include "geometry/mesh/triangle_mesh.h"' 'design must not include geometry/mesh'
violation geometry/mesh/triangle_mesh.h '  #  include "design/design.h"' 'geometry/mesh must not include design'
violation geometry/pattern/rings.cpp '#include "geometry/solid/audit.h"' 'pattern must not include geometry/solid'
violation geometry/solid/audit.cpp '#include "model/section/section.h"' 'geometry/solid must not include model'
violation model/section/section.h '#include "geometry/solid/audit.h"' 'model/section must not include geometry/solid'
violation export/files.cpp '#include "model/section/section.h"' 'export must not include model'
violation export/files.cpp '#include "geometry/solid/audit.h"' 'export must not include geometry/solid'
violation molds/parting.cpp '#include "model/section/section.h"' 'molds must not include model'
violation model/section/section.h '#include "app/build.h"' 'model/section must not include app'
violation model/section/section.h '#include "../design/design.h"' 'not relative to the root'
violation model/section/section.h '#include "design.h"' 'not relative to the root'
violation attic/old.cpp '#include "design/design.h"' 'attic has no place'
violation model/section/section.cpp '#include <toml++/toml.h>' '<toml\+\+/toml.h> is not for model'
violation model/section/section.cpp '#include <CGAL/number_utils.h>' 'is not for model'
violation geometry/pattern/rings.cpp '#include <boost/config.hpp>' 'is not for geometry/pattern'
violation geometry/solid/audit.cpp '#include <kinsol/kinsol.h>' 'is not for geometry/solid'
violation app/build.cpp '#include <assimp/scene.h>' 'is not for app'
violation app/build.cpp '#include <png.h>' 'is not for app'
violation design/reader.cpp '#include <nlohmann/json.hpp>' 'is not for design'
violation model/section/section.cpp '#include <unheard/of.h>' 'belongs to no folder'
violation app/build.cpp '#include "design/private_reader.h"' 'carries <toml\+\+/toml.h> out of its folder'
violation design/design.h 'class Section {};' '^design/design.h:3: the type Section is defined in model/section/section.h already|^model/section/section.h:3: the type Section is defined in design/design.h already'
violation docs/page.md "Look in $home/someone/latticast" '^docs/page.md:2: names a folder'
violation model/section/section.cpp '// [Gent 1997] (3)' 'section.cpp:2: \[Gent 1997\] is cited, and nowhere'
violation model/section/section.cpp '// see docs/attic.md' 'docs/attic.md is cited'
violation model/section/section.cpp '// docs/model.md#energies.' 'docs/model.md#energies is cited'
violation app/build.cpp "// see $work/notes.txt" '^app/build.cpp:5: names a folder'

lay_good_tree
put design/wrapper.h "$licence" '#include "design/private_reader.h"'
put model/section/section.h "$licence" '#include "design/wrapper.h"'
refused 'a third-party header two steps away' '^model/section/section.h:2: .*carries'

for file in design/plain.h molds/plain.cpp model/CMakeLists.txt cmake/plain.cmake design/plain.toml dev tests/plain.sh; do
  lay_good_tree
  put "$file" 'no licence'
  refused "no licence in $file" "^$file:1: the SPDX licence line is missing"
done

lay_good_tree
: >"$tree/design/empty.h"
refused 'an empty source' '^design/empty.h:1: the SPDX licence line is missing'

bash "$check" "$root" || failures=$((failures + 1))
[[ $failures -eq 0 ]] || exit 1
