#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# structure_check.sh ROOT: the rules of the tree that no compiler checks. Prints each violation as
# "FILE:LINE: what is wrong" and exits 1 when there is one.
#
#   - A folder, and a room within it, includes only what lies below it (table `below`).
#   - A third-party header is included only in the folder that owns the library (table `owners`), and
#     no file of another folder reaches it through that folder's headers.
#   - A citation resolves: `[Author Year]` is a key of docs/references.md, `docs/page.md` a page, and the part
#     behind its # a heading of it.
#   - No two headers define a type of one name.
#   - Every source starts with its licence.
#   - No file names a folder of somebody's machine.
set -euo pipefail
shopt -s inherit_errexit
export LC_ALL=C
cd "${1:?usage: structure_check.sh ROOT}"

# A room, then everything that it may include besides itself; a folder's name stands for all of its
# rooms. app, bench and tests may include all.
below='
numerics
design/text
design/material          design/text
design                   design/material design/text
design/setting           design
files                    design
geometry/mesh
geometry/polygon         geometry/mesh
geometry/pattern         numerics design geometry/mesh
geometry/solid           numerics design geometry/mesh geometry/pattern
model/numerics
model/law                design model/numerics
model/horseshoe          design model/numerics model/law
model/sinusoid           design model/numerics model/law
model/strand             design geometry/pattern model/law model/horseshoe model/sinusoid
model/section            design geometry/pattern model/numerics model/law model/strand
model/cell               design geometry/mesh geometry/pattern geometry/solid model/numerics model/section
model/equilibrium        numerics design model/numerics model/law model/strand model/section
model/effective_rods     numerics design model/numerics model/law model/strand model/equilibrium
model/shape              design geometry model/numerics model/law model/strand model/section model/equilibrium
model                    numerics design geometry/mesh geometry/pattern model
molds                    design geometry
export                   design files geometry/mesh
export/mesh              design files geometry/mesh geometry/polygon export/.
export/picture           design files geometry/mesh export/.
export/flat              design files export/.
prepared                 design geometry model molds
checks                   numerics design geometry model molds prepared
report                   design geometry model molds export prepared checks
app                      *
bench                    *
tests                    *
'

# A header as it is included, as a regular expression, then the folders that may include it.
# bench and tests may include any.
owners='
^toml\+\+/           design
^fmt/                design geometry/mesh geometry/pattern geometry/solid model molds export checks report app
^Eigen/              geometry/mesh geometry/pattern geometry/solid model
^(CGAL|boost)/       geometry/polygon geometry/solid molds
^polyclipping/       geometry/solid
^(gmp|gmpxx|mpfr)\.h geometry/solid molds
^(sundials|kinsol|cvodes|nvector|sunmatrix|sunlinsol|sunnonlinsol)/ model
^assimp/             tests
^(cholmod|dlfcn)\.h   model
^png\.h              export
^(tiny_gltf|zip|expat)\.h export
^CLI/                app
^nlohmann/           export report app
^(unistd|fcntl|stdlib)\.h files app
^sys/                files app
'

files() {
  find . \( -path ./.git -o -path ./build -o -path ./out -o -path ./.cache \) -prune -o \
    -type f -print | sed 's|^\./||' | sort
}

include_violations() {
  { grep -E '\.(h|cpp)$' || true; } |
    { xargs -d '\n' -r grep -HnE '^[[:space:]]*#[[:space:]]*include' || true; } |
    awk -v below="$below" -v owners="$owners" '
    # The target that a file belongs to, and the room within it: the deepest one in the table.
    function folder_of(path, parts) {
      split(path, parts, "/")
      return parts[1] == "geometry" ? parts[1] "/" parts[2] : parts[1]
    }
    function room_of(path, parts, depth, room, deepest, i) {
      depth = split(path, parts, "/")
      for (i = 1; i < depth; ++i) {
        room = room (i > 1 ? "/" : "") parts[i]
        if (room in allowed) deepest = room
      }
      return deepest == "" ? folder_of(path) : deepest
    }
    # "export/." is the folder alone, without its rooms.
    function may_reach(from, to, words, i, n) {
      if (from == to) return 1
      n = split(allowed[from], words, " ")
      for (i = 1; i <= n; ++i)
        if (words[i] == "*" || words[i] == to || words[i] == to "/." || index(to, words[i] "/") == 1)
          return 1
      return 0
    }
    BEGIN {
      n = split(below, lines, "\n")
      for (i = 1; i <= n; ++i) {
        m = split(lines[i], words, " ")
        if (m == 0) continue
        allowed[words[1]] = " "
        for (j = 2; j <= m; ++j) allowed[words[1]] = allowed[words[1]] words[j] " "
      }
      n = split(owners, lines, "\n")
      for (i = 1; i <= n; ++i) {
        m = split(lines[i], words, " ")
        if (m == 0) continue
        header[++rules] = words[1]
        for (j = 2; j <= m; ++j) owner[rules] = owner[rules] " " words[j] " "
      }
    }
    {
      split($0, place, ":")
      file = place[1]
      at = file ":" place[2] ": "
      from = folder_of(file)
      room = room_of(file)
      if (!(room in allowed)) {
        print at "the folder " room " has no place in the order of folders"
        next
      }
      if (match($0, /"[^"]*"/)) {
        target = substr($0, RSTART + 1, RLENGTH - 2)
        to = room_of(target)
        if (target !~ "/" || target ~ /(^|\/)\.\.?\//)
          print at "\"" target "\" is not relative to the root of the tree"
        else if (!may_reach(room, to))
          print at room " must not include " to " (\"" target "\")"
        ++count
        includer[count] = file; included[count] = target; where[count] = at
      } else if (match($0, /<[^>]*>/)) {
        target = substr($0, RSTART + 1, RLENGTH - 2)
        if (target !~ /[.\/]/) next  # the standard library
        known = permitted = from == "tests" || from == "bench"
        for (i = 1; i <= rules; ++i) {
          if (target !~ header[i]) continue
          known = 1
          if (index(owner[i], " " from " ")) permitted = 1
        }
        if (!known)
          print at "<" target "> belongs to no folder"
        else if (!permitted)
          print at "<" target "> is not for " from
        if (file ~ /\.h$/ && !(file in exposes)) exposes[file] = "<" target ">"
      }
    }
    END {
      do {
        grown = 0
        for (i = 1; i <= count; ++i)
          if (includer[i] ~ /\.h$/ && included[i] in exposes && !(includer[i] in exposes) &&
              folder_of(includer[i]) == folder_of(included[i])) {
            exposes[includer[i]] = exposes[included[i]]
            grown = 1
          }
      } while (grown)
      for (i = 1; i <= count; ++i) {
        from = folder_of(includer[i])
        if (from == "tests" || from == "bench" || from == folder_of(included[i])) continue
        if (included[i] in exposes)
          print where[i] "\"" included[i] "\" carries " exposes[included[i]] " out of its folder"
      }
    }'
}

# Designs that users copy (examples) and test data carry no licence line of their own.
licence_violations() {
  { grep -E '(\.(h|cpp|in|cmake|sh|py|toml)|(^|/)CMakeLists\.txt|^dev|^\.ci/run)$' || true; } |
    { grep -vE '^(examples|tests/golden|tests/checks)/' || true; } |
    xargs -d '\n' -r awk '
      BEGIN { for (i = 1; i < ARGC; ++i) missing[ARGV[i]] = 1 }
      FNR == 1 { script = /^#!/ }
      FNR == 1 + script && /^(\/\/|#) SPDX-License-Identifier: GPL-3\.0-or-later$/ { delete missing[FILENAME] }
      FNR > 1 { nextfile }
      END {
        for (i = 1; i < ARGC; ++i)
          if (ARGV[i] in missing) print ARGV[i] ":1: the SPDX licence line is missing"
      }'
}

machine_path_violations() {
  xargs -d '\n' -r grep -InE '(^|[^[:alnum:]_.~-])/(home|root|Users|work)/' |
    sed -E 's/^([^:]*:[0-9]+:).*/\1 names a folder of one machine/' || true
}

# All headers share one namespace: two types of one name would share their constructors, too, and the
# linker keeps only one of each.
repeated_type_violations() {
  { grep -E '^(numerics|design|files|geometry|model|molds|export|prepared|checks|report|app|bench)/.*\.h$' || true; } |
    { xargs -d '\n' -r grep -HnE '^(struct|class|enum class|union) +[A-Za-z0-9_]+( |:|[{]|$)' || true; } |
    awk -F: '
      {
        name = $3
        sub(/^(enum class|[a-z]+) +/, "", name)
        sub(/[^A-Za-z0-9_].*/, "", name)
        if (name in first && first[name] != $1)
          print $1 ":" $2 ": the type " name " is defined in " first[name] " already"
        else
          first[name] = $1
      }'
}

# A heading's anchor, as GitHub makes it: small letters, without punctuation, hyphens for spaces.
citation_violations() {
  { grep -E '\.(h|cpp|md|sh|py|js|mjs|gp|cmake)$|^dev$' || true; } |
    { grep -vE '^tests/end_to_end/structure_(check|test)\.sh$' || true; } |
    { xargs -d '\n' -r grep -HnE '\[Wang\]|\[[A-Z][A-Za-z-]+ [12][0-9]{3}[a-z]?\]|docs/[A-Za-z0-9_/-]+\.md|MODEL\.md|^#+ ' || true; } |
    awk '
    function slug(text) {
      text = tolower(text)
      gsub(/[^a-z0-9 \200-\377_-]/, "", text)
      gsub(/ /, "-", text)
      return text
    }
    {
      split($0, place, ":")
      file = place[1]
      line = substr($0, length(place[1] place[2]) + 3)
      if (file ~ /^docs\/.*\.md$/) {
        page[file] = 1
        if (match(line, /^#+ /)) heading[file "#" slug(substr(line, RLENGTH + 1))] = 1
        if (file == "docs/references.md" && match(line, /^- \*\*\[[^]]*\]/))
          key[substr(line, RSTART + 4, RLENGTH - 4)] = 1
      }
      while (match(line, /\[Wang\]|\[[A-Z][A-Za-z-]+ [12][0-9][0-9][0-9][a-z]?\]|docs\/[A-Za-z0-9_\/-]+\.md(#[^][ )`"*,;]*[a-z0-9])?|MODEL\.md/)) {
        cited[++count] = substr(line, RSTART, RLENGTH)
        where[count] = file ":" place[2] ": "
        line = substr(line, RSTART + RLENGTH)
      }
    }
    END {
      for (i = 1; i <= count; ++i) {
        target = cited[i]
        known = target ~ /^\[/ ? target in key : target ~ /#/ ? target in heading : target in page
        if (!known) print where[i] target " is cited, and nowhere to be found"
      }
    }'
}

# A new folder or library is added to the tables above.
violations=$(
  files | include_violations
  files | repeated_type_violations
  files | citation_violations
  files | licence_violations
  files | machine_path_violations
)
[[ -z $violations ]] || {
  printf '%s\n' "$violations"
  exit 1
}
