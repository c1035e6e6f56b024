// SPDX-License-Identifier: GPL-3.0-or-later
// 3MF: a zip archive with one XML model, for printers and slicers.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "export/colour.h"
#include "export/mesh/mesh_limits.h"
#include "geometry/mesh/mesh_object.h"

namespace latticast {

struct NamedMesh {
  std::string name;
  TriangleMesh mesh;
  Colour colour = usual_colour;
};

/// The parts as a 3MF package (core specification) in millimetres: an object with the part's name
/// and display colour, and one build item, for each. Coordinates have the fewest digits that
/// identify the float32. Vertices and triangles keep their numbers; a triangle whose corners are
/// not three vertices is written all the same, although 3MF allows none and readers drop it. The
/// bytes depend on the parts and the program's version alone: no dates.
///
/// Throws std::invalid_argument for no parts, a mesh without triangles or with an index past its
/// vertices, a coordinate that is not finite at float32 (3MF has none), and a name that is not
/// UTF-8 or has control characters.
std::string encode_three_mf(std::span<const NamedMesh> parts);

/// Writes encode_three_mf(parts); the file appears whole or not at all. Throws as that does, and
/// FileError.
void write_three_mf(const std::filesystem::path& file, std::span<const NamedMesh> parts);

/// The meshes of all build items of a 3MF package in mm (the model's unit is applied), in their
/// order, each object of a component by itself, with its name or that of what it is part of;
/// objects in other models of the package included (production extension). What is not printed is
/// left out: items marked so, supports, and the modifiers, negative volumes, support blockers and
/// support enforcers of PrusaSlicer, Slic3r, Bambu Studio, Orca Slicer and Cura; a mesh of several
/// volumes becomes an object for each. A coordinate is the float32 nearest to its text where
/// nothing is moved or scaled; otherwise the product is rounded to float32 once. A transform that
/// mirrors keeps the surface facing outward. Vertices and triangles are neither joined nor dropped.
/// Colours, slices and beams are passed over.
///
/// Memory grows with the unpacked models and, within `limits`, with what they place. Throws
/// FileError naming `file`, and the model's line where there is one, for an archive or XML that is
/// damaged, a number that is none, a triangle that names a missing vertex, an object that is not
/// defined before it is used, a required extension that may change the geometry, an object whose
/// mesh only stands for its slices, and what goes beyond `limits`.
std::vector<MeshObject> decode_three_mf(const std::filesystem::path& file, std::string_view bytes,
                                        const MeshLimits& limits = {});

}  // namespace latticast
