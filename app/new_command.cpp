// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/new_command.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string_view>

#include <fmt/core.h>

#include "design/file_error.h"
#include "design/nearest_name.h"

namespace latticast {
namespace {

// What sets one kind apart; the tube around it is the same.
struct Kind {
  std::string_view name;
  std::string_view meaning;
  std::string_view families;
  std::string_view model;
  int most_kpa = 60;
};

constexpr std::array<Kind, 4> kinds{{
    {.name = "twisting",
     .meaning = "A tube that turns about its axis as it lengthens: tilted strips wind around it",
     .families = R"(    [[segment.lattice.grid]]
    angle = 36                                        # of the strips to the rings; 90: along the tube
    count = 8                                         # strips around the tube
    width = 2
)",
     .model = "joint = \"clear-span\"                                  # strips are clamped at the "
              "rings"},
    {.name = "bending",
     .meaning = "A tube that bends: one side's columns are broad and stretch less than the other's",
     .families = R"(    [[segment.lattice.grid]]
    angle = 90                                        # columns along the tube
    count = 16
    width = { from = 2, to = 3, profile = "halves" }  # half of them 2 mm, half 3 mm
    horseshoe = { radius = 2.65625, arc = 180 }       # 16 arcs on 85 mm: columns that can stretch
)",
     .model = "columns = \"distributed\"                               # each is counted where "
              "it stands"},
    {.name = "elongation",
     .meaning = "A tube that only lengthens: equal horseshoe columns straighten out",
     .families = R"(    [[segment.lattice.grid]]
    angle = 90                                        # columns along the tube
    count = 16
    width = 2
    horseshoe = { radius = 2.65625, arc = 180 }       # 16 arcs on 85 mm: columns that can stretch
)",
     .model = "columns = \"distributed\"                               # each is counted where "
              "it stands"},
    {.name = "superimposed",
     .meaning = "A tube that lengthens, turns and bends at once: its centre line becomes a helix",
     .families = R"(    [[segment.lattice.grid]]
    angle = 60                                        # tilted: the tube turns
    count = 8
    width = { from = 2, to = 4, profile = "cosine" }  # uneven: the tube bends
    horseshoe = { radius = 3.067, arc = 180 }         # stretchable: it lengthens; 16 arcs on 85 mm / sin 60
)",
     .model = "columns = \"distributed\"                               # each is counted where "
              "it stands",
     .most_kpa = 40},
}};

constexpr std::string_view text = R"(# {meaning}.
# Lengths are mm, pressures kPa, angles degrees; docs/design-file.md has every key.
# What it will do: latticast predict {name}.toml    What may go wrong: latticast check {name}.toml
# Its files:       latticast build {name}.toml -o {name}
name = "{name}"                                       # begins every file's name

[[segment]]                                           # further segments make a chain
length = 85

  [segment.liner]                                     # the airtight tube
  inner_radius = 12
  thickness = 4
  material = "ecoflex-00-50"                          # latticast materials lists them

  [segment.lattice]                                   # what guides it
  thickness = 2
  material = "hei-cast-8400"

    [segment.lattice.rings]                           # they keep the tube slim
    count = 8
    width = 2

{families}
[load]
pressure = {{ from = 0, to = {most}, step = 5 }}

[model]
{model}

[make]                                                # what latticast build makes
lattice = true
liner = true
preview = {{ pressures = [0, {half}] }}                 # the inflated shape
report = true                                         # a page with everything at a glance
# lattice_mold = {{ pieces = "auto", wall = 5 }}        # molds to cast the lattice and the liner
# liner_mold = {{ wall = 5 }}

[export]
formats = ["stl"]                                     # also obj, 3mf, ply, glb
tolerance = 0.02                                      # how far facets may leave the true surface

[printer]
process = "fdm"                                       # or sla
)";

const Kind& kind_named(const std::string& name) {
  for (const Kind& kind : kinds) {
    if (kind.name == name) return kind;
  }
  throw std::invalid_argument(
      fmt::format("no kind '{}': {}", name, name_hint(name, new_kinds(), "kinds")));
}

}  // namespace

std::vector<std::string> new_kinds() {
  std::vector<std::string> names;
  names.reserve(std::size(kinds));
  for (const Kind& kind : kinds) names.emplace_back(kind.name);
  return names;
}

std::string new_design(const std::string& name) {
  const Kind& kind = kind_named(name);
  return fmt::format(text, fmt::arg("meaning", kind.meaning), fmt::arg("name", kind.name),
                     fmt::arg("families", kind.families), fmt::arg("model", kind.model),
                     fmt::arg("most", kind.most_kpa), fmt::arg("half", kind.most_kpa / 2));
}

ExitStatus run_new(const std::string& kind, const std::filesystem::path& file,
                   const Console& console) {
  const std::string design = new_design(kind);
  if (file == "-") {
    console.data(design);
    return ExitStatus::done;
  }
  const std::filesystem::path path = file.empty() ? std::filesystem::path(kind + ".toml") : file;
  // Exclusive: a file that appears meanwhile is not overwritten either.
  std::FILE* stream = std::fopen(path.c_str(), "wx");
  if (stream == nullptr) {
    throw FileError(path, errno == EEXIST ? "exists already; give another name after the kind"
                                          : std::strerror(errno));
  }
  const bool written = std::fwrite(design.data(), 1, design.size(), stream) == design.size();
  if (std::fclose(stream) != 0 || !written) {
    const FileError fault(path, std::strerror(errno));
    std::remove(path.c_str());  // no half of a design
    throw fault;
  }
  console.note(fmt::format("wrote {0}; next: latticast predict {0}", path.string()));
  return ExitStatus::done;
}

}  // namespace latticast
