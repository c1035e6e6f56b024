// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/mesh/obj_file.h"

#include <charconv>
#include <cstdint>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "design/file_error.h"
#include "export/mesh/line_reader.h"
#include "export/mesh/text_writer.h"
#include "geometry/polygon/face_list.h"

namespace latticast {
namespace {

class ObjReader {
 public:
  ObjReader(const std::filesystem::path& file, std::string_view text) : file_(file), lines_(text) {}

  TriangleMesh read() {
    while (lines_.next_line()) {
      const std::string_view keyword = lines_.next_word();
      if (keyword == "v") {
        read_vertex();
      }
      if (keyword == "f") {
        read_face();
      }
    }
    mesh_.triangles = std::move(faces_).triangles(mesh_.vertices);
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw FileError(file_, "line " + std::to_string(lines_.line_number()) + ": " + reason);
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

  /// "7", "7/1", "7//3" or "7/1/3", where -1 means the latest vertex.
  std::uint32_t vertex_index(std::string_view word) const {
    std::int64_t number = 0;
    const char* const end = word.data() + word.size();
    const auto parsed = std::from_chars(word.data(), end, number);
    if (parsed.ec != std::errc() || (parsed.ptr != end && *parsed.ptr != '/')) {
      fail(in_quotes(word) + " is not a vertex number");
    }
    const auto count = static_cast<std::int64_t>(mesh_.vertices.size());
    const std::int64_t index = number < 0 ? count + number : number - 1;
    if (index < 0 || index >= count) {
      fail("there is no vertex " + std::to_string(number) + " before it");
    }
    return static_cast<std::uint32_t>(index);
  }

  void read_face() {
    corners_.clear();
    for (std::string_view word = lines_.next_word(); !word.empty(); word = lines_.next_word()) {
      if (word.starts_with('#')) {
        break;
      }
      corners_.push_back(vertex_index(word));
    }
    if (corners_.size() < 3) {
      fail("a face needs three vertices");
    }
    faces_.add(corners_);
  }

  const std::filesystem::path& file_;
  LineReader lines_;
  TriangleMesh mesh_;
  FaceList faces_;
  std::vector<std::uint32_t> corners_;  ///< of the face that is read
};

}  // namespace

std::string encode_obj(const TriangleMesh& mesh, std::string_view name) {
  std::string text = "# unit mm\no " + one_word(name) + "\n";
  text.reserve(32 * mesh.vertices.size() + 24 * mesh.triangles.size());
  for (const Point& vertex : mesh.vertices) {
    text += 'v';
    for (const double coordinate : vertex) {
      text += ' ';
      append_number(text, static_cast<float>(coordinate), std::chars_format::fixed);
    }
    text += '\n';
  }
  for (const Triangle& triangle : mesh.triangles) {
    text += 'f';
    for (const std::uint32_t corner : triangle) {
      text += ' ';
      append_number(text, std::uint64_t{corner} + 1);
    }
    text += '\n';
  }
  return text;
}

TriangleMesh decode_obj(const std::filesystem::path& file, std::string_view text) {
  return ObjReader(file, without_byte_order_mark(file, text)).read();
}

}  // namespace latticast
