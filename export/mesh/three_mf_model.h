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
#include <utility>
#include <vector>

#include "export/mesh/mesh_limits.h"
#include "export/mesh/placement.h"
#include "export/mesh/slicer_settings.h"

namespace latticast {

/// The model part of the package that holds an object, and the object's number in it.
using ThreeMfKey = std::pair<std::string, std::uint32_t>;

/// An object where something uses it.
struct ThreeMfUse {
  ThreeMfKey object;
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

/// All model parts of a package together.
struct ThreeMfModel {
  Placement unit = in_place;  ///< to millimetres, of the part that was read last
  std::map<ThreeMfKey, ThreeMfObject> objects;
  std::size_t components = 0;
  std::vector<ThreeMfUse> items;  ///< those of the part that was read last that are printed
  std::size_t left_out = 0;       ///< and how many are not
};

/// Takes the XML of a model part piece by piece, and adds to `model`. The root part comes last:
/// only its items count, and it may use the objects of the parts before it (production extension).
class ThreeMfModelReader {
 public:
  /// All must outlive it. `part` is the name of the part.
  ThreeMfModelReader(const std::filesystem::path& file, std::string_view part,
                     const SlicerSettings& settings, const MeshLimits& limits, ThreeMfModel& model);
  ~ThreeMfModelReader();
  ThreeMfModelReader(const ThreeMfModelReader&) = delete;
  ThreeMfModelReader& operator=(const ThreeMfModelReader&) = delete;

  /// Throws FileError naming the file and the line.
  void read(std::string_view piece);

  /// After the last piece.
  void finish();

 private:
  class Events;

  std::unique_ptr<Events> events_;
};

}  // namespace latticast
