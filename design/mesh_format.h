// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh file formats by name: the words of `[export] formats` and the suffixes of files. What a
// format holds and who reads and writes it stands in export/mesh/mesh_formats.h.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace latticast {

enum class MeshFormat { stl, obj, three_mf, ply, glb, off, stl_text };

struct MeshFormatName {
  MeshFormat format;
  std::string_view name;
  std::string_view suffix;
};

/// One for each format, in the order in which messages name them.
inline constexpr std::array mesh_format_names = {
    MeshFormatName{MeshFormat::stl, "stl", ".stl"},
    MeshFormatName{MeshFormat::obj, "obj", ".obj"},
    MeshFormatName{MeshFormat::three_mf, "3mf", ".3mf"},
    MeshFormatName{MeshFormat::ply, "ply", ".ply"},
    MeshFormatName{MeshFormat::glb, "glb", ".glb"},
    MeshFormatName{MeshFormat::off, "off", ".off"},
    MeshFormatName{MeshFormat::stl_text, "stl-text", "-text.stl"},
};

/// What a format's files end in, as in ".stl", or "-text.stl" where another has that suffix.
std::string_view extension(MeshFormat format);

/// The format that a file's suffix names, in upper or lower case; nothing where it names none. STL
/// is told apart from text STL by its bytes alone.
std::optional<MeshFormat> mesh_format_of(const std::filesystem::path& file);

/// All suffixes for a message: ".stl, .obj or .ply".
std::string mesh_suffixes();

/// What other programs call files with this suffix, as in "STEP", where they hold shapes or
/// pictures that nothing here reads; empty for any other.
std::string_view foreign_format_of(const std::filesystem::path& file);

}  // namespace latticast
