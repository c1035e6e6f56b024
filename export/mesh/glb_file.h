// SPDX-License-Identifier: GPL-3.0-or-later
// GLB, glTF 2.0 in one binary file: a scene of bodies with states, for viewers. Its own units are
// metres with y upward.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "export/colour.h"
#include "export/mesh/mesh_limits.h"
#include "geometry/mesh/mesh_object.h"

namespace latticast {

/// Another place in mm for every vertex of a body.
struct MorphTarget {
  std::string name;
  std::vector<Point> positions;
};

struct SceneBody {
  std::string name;
  TriangleMesh mesh;                      ///< in mm, at rest
  Colour colour = usual_colour;           ///< of a dull surface, seen from outside only
  std::vector<MorphTarget> targets = {};  ///< further states, in the order of an animation
};

struct Scene {
  std::vector<SceneBody> bodies;
  bool animated = false;  ///< writes an animation "inflate"; every body has as many targets
};

/// The scene as GLB. A root node "actuator" turns mm, z upward, into metres, y upward; below it
/// stands a node for each body, with the body's name, one mesh and one material. Coordinates are
/// the float32 values nearest to those in mm. Vertices and triangles keep their numbers. Normals
/// are not written: readers then shade the facets flat, so that creases show.
///
/// A target is stored as its difference from the rounded rest position, rounded to float32; the
/// names are the mesh's extras.targetNames, and all weights are 0 by default. Targets that leave
/// every body as it is, to 1e-7 of its size, are not stored: they are the rest state. The animation
/// begins and ends with that, shows each target in turn, a second apart, and goes back through
/// them; all bodies have its keyframes at the same times. Between two the weights are linear, from
/// 0 to 1.
///
/// The bytes depend on the scene and the program's version alone. Throws std::invalid_argument for
/// a scene without bodies, a mesh without triangles or with an index past its vertices, a target
/// with another number of positions than its mesh, a coordinate that is not finite at float32
/// (glTF has none), a name that is not UTF-8, and for 4 GiB or more.
std::string encode_glb(const Scene& scene);

/// Writes encode_glb(scene); the file appears whole or not at all. Throws as that does, and
/// FileError.
void write_glb(const std::filesystem::path& file, const Scene& scene);

/// The meshes of GLB in mm, z upward, placed as the nodes of its scene say: positions are
/// multiplied in double and rounded to float32 once, and what write_glb wrote comes back bit for
/// bit. Each use of a mesh is an object (each primitive
/// of it, where all of them are closed) with the node's name, or the mesh's, in the order of the
/// nodes; one that mirrors keeps its surface facing outward. Instances (EXT_mesh_gpu_instancing)
/// are placed, invisible nodes (KHR_node_visibility) left out. Morph targets, skins, materials,
/// points and lines are passed over.
///
/// Throws FileError naming `file` for what is no GLB, is cut short or contradicts itself, for data
/// that is not read (outside the file, compressed, sparse, triangle strips and fans), for other
/// extensions that change the geometry or are required, by name, and for what goes beyond `limits`.
std::vector<MeshObject> decode_glb(const std::filesystem::path& file, std::string_view bytes,
                                   const MeshLimits& limits = {});

}  // namespace latticast
