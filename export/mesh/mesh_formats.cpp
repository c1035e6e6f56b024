// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/mesh/mesh_formats.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "export/mesh/glb_file.h"
#include "export/mesh/obj_file.h"
#include "export/mesh/off_file.h"
#include "export/mesh/ply_file.h"
#include "export/mesh/stl_file.h"
#include "export/mesh/three_mf_file.h"

namespace latticast {
namespace {

std::string encode_three_mf_part(const MeshToWrite& part) {
  return encode_three_mf(
      std::array{NamedMesh{std::string(part.name), part.mesh, part.look.colour}});
}

std::string encode_glb_part(const MeshToWrite& part) {
  return encode_glb({{{std::string(part.name), part.mesh, part.look.colour}}});
}

using Objects = std::vector<MeshObject>;
using Path = std::filesystem::path;

template <TriangleMesh (*decode)(const Path& file, std::string_view bytes)>
Objects decode_one(const Path& file, std::string_view bytes) {
  Objects objects(1);
  objects.front().mesh = decode(file, bytes);
  return objects;
}

constexpr std::array formats = {
    MeshFileFormat{.format = MeshFormat::stl,
                   .encode = [](const MeshToWrite& part) { return encode_stl(part.mesh); },
                   .decode = decode_one<decode_stl>,
                   .keeps_vertex_numbers = false,
                   .keeps_infinite = true,
                   .keeps_part_name = false},
    MeshFileFormat{
        .format = MeshFormat::obj,
        .encode = [](const MeshToWrite& part) { return encode_obj(part.mesh, part.name); },
        .decode = decode_one<decode_obj>,
        .keeps_vertex_numbers = true,
        .keeps_infinite = true,
        .keeps_part_name = true},
    MeshFileFormat{.format = MeshFormat::three_mf,
                   .encode = encode_three_mf_part,
                   .decode = [](const Path& file,
                                std::string_view bytes) { return decode_three_mf(file, bytes); },
                   .keeps_vertex_numbers = true,
                   .keeps_infinite = false,
                   .keeps_part_name = true},
    MeshFileFormat{
        .format = MeshFormat::ply,
        .encode = [](const MeshToWrite& part) { return encode_ply(part.mesh, part.look); },
        .decode = decode_one<decode_ply>,
        .keeps_vertex_numbers = true,
        .keeps_infinite = true,
        .keeps_part_name = false},
    MeshFileFormat{
        .format = MeshFormat::glb,
        .encode = encode_glb_part,
        .decode = [](const Path& file, std::string_view bytes) { return decode_glb(file, bytes); },
        .keeps_vertex_numbers = true,
        .keeps_infinite = false,
        .keeps_part_name = true},
    MeshFileFormat{.format = MeshFormat::off,
                   .encode = [](const MeshToWrite& part) { return encode_off(part.mesh); },
                   .decode = decode_one<decode_off>,
                   .keeps_vertex_numbers = true,
                   .keeps_infinite = true,
                   .keeps_part_name = false},
    MeshFileFormat{
        .format = MeshFormat::stl_text,
        .encode = [](const MeshToWrite& part) { return encode_text_stl(part.mesh, part.name); },
        .decode = decode_one<decode_stl>,
        .keeps_vertex_numbers = false,
        .keeps_infinite = true,
        .keeps_part_name = true},
};
static_assert(formats.size() == mesh_format_names.size());

}  // namespace

const MeshFileFormat& mesh_file_format(MeshFormat format) {
  const auto* const row = std::find_if(formats.begin(), formats.end(),
                                       [&](const auto& known) { return known.format == format; });
  if (row == formats.end()) throw std::invalid_argument("no mesh format");
  return *row;
}

}  // namespace latticast
