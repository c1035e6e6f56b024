// SPDX-License-Identifier: GPL-3.0-or-later
// Publication of a set of files: all of them take their places in a folder, or none does. A journal
// tells a later run how to undo a publication that its process did not live to finish.
//
// A set is made in a folder of its own, inside the one it is meant for, so that taking a place is a
// rename. Beside the new files lie
//   new/NAME   each new file until it takes its place
//   old/NAME   the file that it replaces, until all have taken theirs
//   journal    the names; there from before the first rename until after the last
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace latticast {

/// Makes new/ and old/ in `set`. Throws FileError.
void prepare_set(const std::filesystem::path& set);

/// Where to write a file that will be called `name`.
std::filesystem::path place_in_set(const std::filesystem::path& set, const std::string& name);

/// Moves the files `names` of `set` into `folder` and replaces those of the same names. A file that
/// is replaced stays readable under its name until the new one is there, and the new one has its
/// permissions; a symbolic link is replaced itself, what it points to is not touched. All is forced
/// to the disk in an order that keeps the promise when power fails. Throws FileError after undoing
/// what was done: for a folder, a device or a write-protected file in the way nothing was.
void publish(const std::filesystem::path& set, const std::filesystem::path& folder,
             const std::vector<std::string>& names);

/// Undoes what a publication that was cut short did to `folder`; nothing where `set` has no journal
/// or all its files had taken their places. May itself be cut short, and called again. Throws
/// FileError.
void undo_publication(const std::filesystem::path& set, const std::filesystem::path& folder);

}  // namespace latticast
