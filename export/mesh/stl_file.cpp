// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/mesh/stl_file.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "design/file_error.h"
#include "export/mesh/line_reader.h"
#include "export/mesh/little_endian.h"

namespace latticast {
namespace {

constexpr std::size_t header_size = 80;
constexpr std::size_t preamble_size = header_size + 4;
constexpr std::size_t facet_size = 50;
// Anything but "solid", by which readers know text STL.
constexpr std::string_view stl_header = "binary STL, unit mm";

using Vector = std::array<float, 3>;

char* put_vector(char* out, const Vector& vector) {
  for (const float x : vector) {
    out = put_float32(out, x);
  }
  return out;
}

Vector rounded(const Point& p) {
  return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
}

/// Of the rounded corners, so that the file agrees with itself.
Vector unit_normal(const Vector& a, const Vector& b, const Vector& c) {
  const Point u{double{b[0]} - a[0], double{b[1]} - a[1], double{b[2]} - a[2]};
  const Point v{double{c[0]} - a[0], double{c[1]} - a[1], double{c[2]} - a[2]};
  const Point n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  if (!(length > 0) || !std::isfinite(length)) {
    return {0, 0, 0};
  }
  return rounded({n[0] / length, n[1] / length, n[2] / length});
}

std::size_t facet_count(std::string_view bytes) {
  return get_little_endian(bytes.data() + header_size, 4);
}

bool has_binary_length(std::string_view bytes) {
  return bytes.size() >= preamble_size &&
         bytes.size() == preamble_size + facet_size * facet_count(bytes);
}

class TextStlReader {
 public:
  TextStlReader(const std::filesystem::path& file, std::string_view text)
      : file_(file), lines_(text) {}

  TriangleMesh read() {
    while (lines_.next_line()) {
      read_statement(lines_.next_word());
    }
    if (in_solid_) {
      fail("the last solid does not end");
    }
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw FileError(file_, "line " + std::to_string(lines_.line_number()) + ": " + reason);
  }

  void require(bool in_place) const {
    if (!in_place) {
      fail("is out of place");
    }
  }

  void read_statement(std::string_view keyword) {
    if (keyword == "solid") {
      require(!in_solid_);
      in_solid_ = true;
    } else if (keyword == "facet") {
      require(in_solid_ && !in_facet_);
      in_facet_ = true;
    } else if (keyword == "vertex") {
      require(in_facet_);
      read_vertex();
    } else if (keyword == "endfacet") {
      require(in_facet_);
      end_facet();
    } else if (keyword == "endsolid") {
      require(in_solid_ && !in_facet_);
      in_solid_ = false;
    } else if (keyword == "outer" || keyword == "endloop") {
      require(in_facet_);
    } else if (!keyword.empty()) {
      fail("\"" + std::string(keyword) + "\" is no statement of text STL");
    }
  }

  void read_vertex() {
    Point vertex;
    for (double& coordinate : vertex) {
      const std::optional<float> number = float32_of(lines_.next_word());
      if (!number) {
        fail("a vertex needs three numbers");
      }
      coordinate = *number;
    }
    mesh_.vertices.push_back(vertex);
  }

  void end_facet() {
    const auto first = static_cast<std::uint32_t>(3 * mesh_.triangles.size());
    if (mesh_.vertices.size() != first + std::size_t{3}) {
      fail("a facet needs three vertices");
    }
    mesh_.triangles.push_back({first, first + 1, first + 2});
    in_facet_ = false;
  }

  const std::filesystem::path& file_;
  LineReader lines_;
  TriangleMesh mesh_;
  bool in_solid_ = false;
  bool in_facet_ = false;
};

bool is_text(std::string_view bytes) {
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  return start != std::string_view::npos && bytes.substr(start).starts_with("solid") &&
         !has_binary_length(bytes);
}

TriangleMesh decode_binary(const std::filesystem::path& file, std::string_view bytes) {
  if (bytes.size() < preamble_size) {
    throw FileError(file, "too short for an STL file");
  }
  const std::size_t facets = facet_count(bytes);
  if (!has_binary_length(bytes)) {
    throw FileError(file, "says that it holds " + std::to_string(facets) +
                              " triangles, which takes " +
                              std::to_string(preamble_size + facet_size * facets) +
                              " bytes, but has " + std::to_string(bytes.size()));
  }
  TriangleMesh mesh;
  mesh.vertices.resize(3 * facets);
  mesh.triangles.resize(facets);
  for (std::size_t i = 0; i < facets; ++i) {
    const char* in = bytes.data() + preamble_size + facet_size * i + sizeof(Vector);
    for (std::size_t corner = 3 * i; corner < 3 * i + 3; ++corner) {
      mesh.triangles[i][corner - 3 * i] = static_cast<std::uint32_t>(corner);
      for (double& coordinate : mesh.vertices[corner]) {
        coordinate = get_float32(in);
        in += sizeof(float);
      }
    }
  }
  return mesh;
}

}  // namespace

std::string encode_stl(const TriangleMesh& mesh) {
  std::string bytes(preamble_size + facet_size * mesh.triangles.size(), '\0');
  stl_header.copy(bytes.data(), stl_header.size());
  char* out = put_little_endian(bytes.data() + header_size, mesh.triangles.size(), 4);
  for (const Triangle& triangle : mesh.triangles) {
    const Vector a = rounded(mesh.vertices[triangle[0]]);
    const Vector b = rounded(mesh.vertices[triangle[1]]);
    const Vector c = rounded(mesh.vertices[triangle[2]]);
    out = put_vector(out, unit_normal(a, b, c));
    out = put_vector(out, a);
    out = put_vector(out, b);
    out = put_vector(out, c);
    out += 2;  // the attribute count, zero
  }
  return bytes;
}

TriangleMesh decode_stl(const std::filesystem::path& file, std::string_view bytes) {
  return is_text(bytes) ? TextStlReader(file, bytes).read() : decode_binary(file, bytes);
}

}  // namespace latticast
