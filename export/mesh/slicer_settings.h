// SPDX-License-Identifier: GPL-3.0-or-later
// What slicers write into a 3MF beside its model: which of the meshes are printed, and which change
// how others are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "export/mesh/zip_archive.h"

namespace latticast {

/// A run of an object's triangles, both ends included.
struct SlicerVolume {
  std::size_t first = 0;
  std::size_t last = 0;
  bool printed = true;  ///< no modifier, negative volume, support blocker or support enforcer
};

struct SlicerSettings {
  /// By the object's number. PrusaSlicer and Slic3r put the volumes of an object into one mesh.
  std::map<std::uint32_t, std::vector<SlicerVolume>> volumes;
  /// Object and component that is not printed. Bambu Studio and Orca Slicer make each a component.
  std::set<std::pair<std::uint32_t, std::uint32_t>> unprinted_components;
};

/// The settings in a package; empty where no slicer left any. Throws FileError naming `file` for
/// settings that are no XML.
SlicerSettings read_slicer_settings(const std::filesystem::path& file, const ZipReader& package);

}  // namespace latticast
