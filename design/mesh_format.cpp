// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/mesh_format.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace latticast {

namespace {

struct ForeignFormat {
  std::string_view suffix;
  std::string_view name;
};

constexpr std::array foreign_formats = {
    ForeignFormat{".3dm", "Rhino"},       ForeignFormat{".3ds", "3D Studio"},
    ForeignFormat{".amf", "AMF"},         ForeignFormat{".blend", "Blender"},
    ForeignFormat{".brep", "BREP"},       ForeignFormat{".ctm", "OpenCTM"},
    ForeignFormat{".dae", "COLLADA"},     ForeignFormat{".dwg", "DWG"},
    ForeignFormat{".dxf", "DXF"},         ForeignFormat{".f3d", "Fusion"},
    ForeignFormat{".fbx", "FBX"},         ForeignFormat{".fcstd", "FreeCAD"},
    ForeignFormat{".gcode", "G-code"},    ForeignFormat{".gltf", "glTF in several files"},
    ForeignFormat{".iges", "IGES"},       ForeignFormat{".igs", "IGES"},
    ForeignFormat{".inp", "Abaqus"},      ForeignFormat{".ipt", "Inventor"},
    ForeignFormat{".jt", "JT"},           ForeignFormat{".msh", "Gmsh"},
    ForeignFormat{".nas", "Nastran"},     ForeignFormat{".pcd", "PCD"},
    ForeignFormat{".png", "PNG"},         ForeignFormat{".sat", "ACIS"},
    ForeignFormat{".scad", "OpenSCAD"},   ForeignFormat{".sldprt", "SolidWorks"},
    ForeignFormat{".step", "STEP"},       ForeignFormat{".stp", "STEP"},
    ForeignFormat{".svg", "SVG"},         ForeignFormat{".unv", "UNV"},
    ForeignFormat{".usd", "USD"},         ForeignFormat{".usda", "USD"},
    ForeignFormat{".usdc", "USD"},        ForeignFormat{".usdz", "USD"},
    ForeignFormat{".vrml", "VRML"},       ForeignFormat{".vtk", "VTK"},
    ForeignFormat{".vtp", "VTK"},         ForeignFormat{".vtu", "VTK"},
    ForeignFormat{".wrl", "VRML"},        ForeignFormat{".x", "DirectX"},
    ForeignFormat{".x3d", "X3D"},         ForeignFormat{".x_t", "Parasolid"},
    ForeignFormat{".xyz", "point cloud"}, ForeignFormat{".zip", "zip"},
};

std::string small_suffix(const std::filesystem::path& file) {
  std::string suffix = file.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return suffix;
}

}  // namespace

std::string_view extension(MeshFormat format) {
  for (const MeshFormatName& known : mesh_format_names) {
    if (known.format == format) return known.suffix;
  }
  throw std::invalid_argument("no mesh format");
}

std::optional<MeshFormat> mesh_format_of(const std::filesystem::path& file) {
  const std::string suffix = small_suffix(file);
  for (const MeshFormatName& known : mesh_format_names) {
    if (known.suffix == suffix) return known.format;
  }
  return std::nullopt;
}

std::string mesh_suffixes() {
  std::vector<std::string_view> suffixes;
  for (const MeshFormatName& known : mesh_format_names) {
    if (known.suffix.starts_with('.')) suffixes.push_back(known.suffix);
  }
  std::string text;
  for (std::size_t i = 0; i < suffixes.size(); ++i) {
    if (i > 0) text += i + 1 == suffixes.size() ? " or " : ", ";
    text += suffixes[i];
  }
  return text;
}

std::string_view foreign_format_of(const std::filesystem::path& file) {
  const std::string suffix = small_suffix(file);
  for (const ForeignFormat& known : foreign_formats) {
    if (known.suffix == suffix) return known.name;
  }
  return {};
}

}  // namespace latticast
