// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/mesh/stl_file.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "design/file_error.h"
#include "export/mesh/line_reader.h"
#include "export/mesh/little_endian.h"
#include "export/mesh/text_writer.h"

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

bool is_comment(std::string_view word) {
  return word.starts_with('#') || word.starts_with(';') || word.starts_with("//");
}

/// Words in their order, whatever the lines: some programs write all on one.
class TextStlReader {
 public:
  TextStlReader(const std::filesystem::path& file, std::string_view text)
      : file_(file), lines_(text, LineJoining::none) {}

  TriangleMesh read() {
    for (std::string_view word = next_word(); !word.empty(); word = next_word()) {
      read_statement(word);
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

  /// Empty at the end of the text.
  std::string_view next_word() {
    while (true) {
      const std::string_view word = lines_.next_word();
      if (!word.empty() && !is_comment(word)) {
        return word;
      }
      if (!lines_.next_line()) {
        return {};
      }
    }
  }

  void read_statement(std::string_view word) {
    if (is_word(word, "solid")) {
      require(!in_solid_);
      in_solid_ = true;
      pass_over_name();
    } else if (is_word(word, "facet")) {
      require(in_solid_ && !in_facet_);
      in_facet_ = true;
      pass_over_normal();
    } else if (is_word(word, "vertex")) {
      require(in_facet_);
      read_vertex();
    } else if (is_word(word, "outer") || is_word(word, "loop")) {
      require(in_facet_);
    } else if (is_word(word, "end")) {
      read_end(next_word());
    } else if (is_word(word.substr(0, 3), "end")) {
      read_end(word.substr(3));
    } else {
      fail(in_quotes(word) + " is no statement of text STL");
    }
  }

  void read_end(std::string_view what) {
    if (is_word(what, "loop")) {
      require(in_facet_);
    } else if (is_word(what, "facet")) {
      require(in_facet_);
      end_facet();
    } else if (is_word(what, "solid")) {
      require(in_solid_ && !in_facet_);
      in_solid_ = false;
      pass_over_name();
    } else {
      fail(in_quotes("end" + std::string(what)) + " is no statement of text STL");
    }
  }

  /// Goes to the end of the line, which the name of a solid takes; where the line goes on with
  /// facets, to the statement that they begin with.
  void pass_over_name() {
    LineReader ahead = lines_;
    LineReader statement = lines_;
    while (true) {
      const LineReader here = ahead;
      const std::string_view word = ahead.next_word();
      if (word.empty()) {
        lines_ = ahead;
        return;
      }
      const bool begins = is_word(word, in_solid_ ? "facet" : "solid");
      const bool ends = is_word(word, "endsolid");
      if (begins || ends) {
        statement = here;
      }
      if ((is_word(word, "facet") && is_normal(ahead)) || (ends && in_solid_)) {
        lines_ = statement;
        return;
      }
    }
  }

  static bool is_normal(LineReader after_facet) {
    return is_word(after_facet.next_word(), "normal") &&
           float32_of(after_facet.next_word()).has_value();
  }

  // Its numbers may be none at all: it is not used.
  void pass_over_normal() {
    LineReader before = lines_;
    for (int words = 0; words <= 4; ++words) {
      const std::string_view word = next_word();
      if (word.empty() || is_word(word, "outer") || is_word(word, "vertex") ||
          is_word(word.substr(0, 3), "end")) {
        lines_ = before;
        return;
      }
      before = lines_;
    }
    fail("a facet's normal has three numbers");
  }

  void read_vertex() {
    Point vertex;
    for (double& coordinate : vertex) {
      const std::optional<float> number = float32_of(next_word());
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

/// Whether the first word, after comments, is "solid".
bool begins_with_solid(std::string_view text) {
  LineReader lines(text, LineJoining::none);
  while (lines.next_line()) {
    const std::string_view word = lines.next_word();
    if (!word.empty() && !is_comment(word)) {
      return is_word(word.substr(0, 5), "solid");
    }
  }
  return false;
}

/// No text has a zero byte, and hardly a binary file none where it begins.
bool looks_binary(std::string_view bytes) {
  return bytes.substr(0, 512).find('\0') != std::string_view::npos;
}

TriangleMesh decode_binary(const std::filesystem::path& file, std::string_view bytes) {
  if (!has_binary_length(bytes) && !looks_binary(bytes)) {
    throw FileError(file,
                    "is neither text STL, which begins with \"solid\", nor binary STL, which is as "
                    "long as its count of triangles says");
  }
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

void append_vector(std::string& text, std::string_view word, const Vector& vector) {
  text += word;
  for (const float x : vector) {
    text += ' ';
    append_number(text, x);
  }
  text += '\n';
}

}  // namespace

std::string encode_text_stl(const TriangleMesh& mesh, std::string_view name) {
  std::string text = "solid " + one_word(name) + '\n';
  text.reserve(256 * mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) {
    const std::array corners{rounded(mesh.vertices[triangle[0]]),
                             rounded(mesh.vertices[triangle[1]]),
                             rounded(mesh.vertices[triangle[2]])};
    append_vector(text, "facet normal", unit_normal(corners[0], corners[1], corners[2]));
    text += "outer loop\n";
    for (const Vector& corner : corners) {
      append_vector(text, "vertex", corner);
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid " + one_word(name) + '\n';
}

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
  if (has_binary_length(bytes)) {
    return decode_binary(file, bytes);
  }
  const std::string_view text = without_byte_order_mark(file, bytes);
  return !looks_binary(bytes) && begins_with_solid(text) ? TextStlReader(file, text).read()
                                                         : decode_binary(file, bytes);
}

}  // namespace latticast
