// SPDX-License-Identifier: GPL-3.0-or-later
// Settings: values that take the place of those in a design's text, by one grammar of paths for all
// who ask (--set, sweeps, other programs).
//
//     setting = path "=" value
//     path    = step { "." step }
//     step    = key                     of a table; quoted as in TOML where it must be
//             | number                  of a list's entry, counted from 0
//             | name                    of a list's entry that has a key `name`
//     value   = a value as in TOML, or a word, which is text: 90, [1, 2], { from = 2, to = 3 }, sla
//
// "list[2]", as messages write it, is the same as "list.2". Examples:
//     segment.tip.length=90
//     segment.0.lattice.grid.1.angle=30
//     model.kind=bonded
//     load.pressure={from=0, to=60, step=5}
//
// A path must lead to entries that are there; a key that is not there, and the tables on the way to
// it, are added, because most keys may be left out. What is read is the design with the values in
// their places: all its rules hold, and a key that no design has is refused as in a file.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "design/issue.h"
#include "design/read_design.h"
#include "design/toml_text.h"

namespace latticast {

/// Puts the values into the tree, the later of two settings for one path last. Their line is
/// Issue::set_by_path. Returns one issue for every setting that could not be put in its place, and
/// leaves it out. Never throws on bad input.
std::vector<Issue> apply_settings(std::span<const std::string> settings, TomlValue& root);

/// Reads a design as read_design() does, with settings in the places of its values. Problems of the
/// settings come first.
ReadResult read_design_with(std::string_view toml_text, std::span<const std::string> settings,
                            const MaterialLibrary& materials);

}  // namespace latticast
