// SPDX-License-Identifier: GPL-3.0-or-later
// The model of a 3MF package, read but not yet placed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "export/mesh/mesh_limits.h"
#include "export/mesh/placement.h"
#include "export/mesh/slicer_settings.h"

namespace latticast {

/// An object where something uses it.
struct ThreeMfUse {
  std::uint32_t object = 0;
  Placement placement = in_place;
};

struct ThreeMfObject {
  std::string name;
  bool printed = true;               ///< neither a support nor a slicer's modifier
  bool has_geometry = false;         ///< a mesh or components, empty ones included
  std::vector<TriangleMesh> bodies;  ///< its mesh, in pieces where a slicer parted it
  std::vector<ThreeMfUse> components;
  // Of the object and all that it is made of, as printed.
  std::size_t depth = 1;
  std::size_t uses = 0;       ///< bodies
  std::size_t triangles = 0;  ///< of these
};

struct ThreeMfModel {
  Placement unit = in_place;  ///< to millimetres
  std::map<std::uint32_t, ThreeMfObject> objects;
  std::vector<ThreeMfUse> items;  ///< those that are printed
  std::size_t left_out = 0;       ///< items that are not
};

/// Takes the model's XML piece by piece.
class ThreeMfModelReader {
 public:
  ThreeMfModelReader(const std::filesystem::path& file, SlicerSettings settings,
                     const MeshLimits& limits);
  ~ThreeMfModelReader();
  ThreeMfModelReader(const ThreeMfModelReader&) = delete;
  ThreeMfModelReader& operator=(const ThreeMfModelReader&) = delete;

  /// Throws FileError naming the file and the line.
  void read(std::string_view piece);

  /// After the last piece.
  ThreeMfModel finish();

 private:
  class Events;

  std::unique_ptr<Events> events_;
};

}  // namespace latticast
