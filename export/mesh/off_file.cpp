// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/mesh/off_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
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

class OffReader {
 public:
  OffReader(const std::filesystem::path& file, std::string_view text) : file_(file), lines_(text) {}

  TriangleMesh read() {
    read_word_and_counts();
    for (std::uint64_t i = 0; i < vertices_; ++i) {
      read_vertex();
    }
    for (std::uint64_t i = 0; i < faces_; ++i) {
      read_face();
    }
    if (next_line()) {
      fail("is left over");
    }
    mesh_.triangles = std::move(face_list_).triangles(mesh_.vertices);
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw FileError(file_, "line " + std::to_string(lines_.line_number()) + ": " + reason);
  }

  /// Goes to the next line that holds a word, which becomes the pending one; false at the end.
  bool next_line() {
    while (lines_.next_line()) {
      pending_ = lines_.next_word();
      if (!pending_.empty() && !pending_.starts_with('#')) {
        return true;
      }
    }
    return false;
  }

  void need_line(const char* what) {
    if (!next_line()) {
      throw FileError(file_, std::string("ends where a ") + what + " should follow");
    }
  }

  /// Of the line, empty at its end or where a comment begins.
  std::string_view next_word() {
    const std::string_view word = std::exchange(pending_, {});
    const std::string_view next = word.empty() ? lines_.next_word() : word;
    return next.starts_with('#') ? std::string_view() : next;
  }

  std::uint64_t whole_number(const char* what) {
    const std::string_view word = next_word();
    std::uint64_t number = 0;
    const char* const end = word.data() + word.size();
    const auto parsed = std::from_chars(word.data(), end, number);
    if (word.empty() || parsed.ec != std::errc() || parsed.ptr != end) {
      fail(in_quotes(word) + " is not " + what);
    }
    return number;
  }

  // Some programs write the counts behind the word.
  void read_word_and_counts() {
    need_line("count");
    if (pending_ == "OFF" || pending_ == "COFF") {
      pending_ = lines_.next_word();
      if (pending_.empty() || pending_.starts_with('#')) {
        need_line("count");
      }
    }
    vertices_ = whole_number("OFF, nor a count of vertices");
    faces_ = whole_number("a count of faces");
    if (const std::string_view edges = next_word(); !edges.empty()) {
      pending_ = edges;
      whole_number("a count of edges");
    }
  }

  void read_vertex() {
    need_line("vertex");
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

  std::uint32_t corner() {
    const std::uint64_t index = whole_number("a vertex number");
    if (index >= mesh_.vertices.size()) {
      fail("there is no vertex " + std::to_string(index));
    }
    return static_cast<std::uint32_t>(index);
  }

  void read_face() {
    need_line("face");
    const std::uint64_t corners = whole_number("a count of corners");
    if (corners < 3) {
      fail("a face needs three vertices");
    }
    corners_.clear();
    for (std::uint64_t i = 0; i < corners; ++i) {
      corners_.push_back(corner());
    }
    face_list_.add(corners_);
  }

  const std::filesystem::path& file_;
  LineReader lines_;
  std::string_view pending_;  // a word of the line that was looked at before its turn
  std::uint64_t vertices_ = 0;
  std::uint64_t faces_ = 0;
  TriangleMesh mesh_;
  FaceList face_list_;
  std::vector<std::uint32_t> corners_;  ///< of the face that is read
};

}  // namespace

std::string encode_off(const TriangleMesh& mesh) {
  constexpr int digits = 9;
  std::string text = "OFF\n";
  text.reserve(32 * mesh.vertices.size() + 24 * mesh.triangles.size());
  append_number(text, mesh.vertices.size());
  text += ' ';
  append_number(text, mesh.triangles.size());
  text += " 0\n";
  for (const Point& vertex : mesh.vertices) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      append_number(text, static_cast<float>(vertex[axis]), std::chars_format::general, digits);
      text += axis < 2 ? ' ' : '\n';
    }
  }
  for (const Triangle& triangle : mesh.triangles) {
    text += '3';
    for (const std::uint32_t corner : triangle) {
      text += ' ';
      append_number(text, corner);
    }
    text += '\n';
  }
  return text;
}

TriangleMesh decode_off(const std::filesystem::path& file, std::string_view text) {
  return OffReader(file, without_byte_order_mark(file, text)).read();
}

}  // namespace latticast
