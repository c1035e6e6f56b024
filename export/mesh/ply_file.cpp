// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/mesh/ply_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "design/file_error.h"
#include "export/mesh/line_reader.h"
#include "export/mesh/little_endian.h"
#include "export/mesh/ply_header.h"
#include "geometry/polygon/face_list.h"

namespace latticast {
namespace {

std::string ply_header(const TriangleMesh& mesh, const MeshLook& look) {
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment unit mm\nelement vertex " +
                     std::to_string(mesh.vertices.size()) +
                     "\nproperty float x\nproperty float y\nproperty float z\n";
  if (!look.vertex_colours.empty()) {
    text += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  }
  if (!look.vertex_qualities.empty()) {
    text += "property float quality\n";
  }
  return text + "element face " + std::to_string(mesh.triangles.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

char* put_colour(char* out, const Colour& colour) {
  for (const double x : {colour.red, colour.green, colour.blue}) {
    const double level = x > 0 ? std::min(x, 1.0) : 0;
    *out++ = static_cast<char>(std::lround(255 * level));
  }
  return out;
}

/// A value that is not there or not of its type.
struct BadValue {
  std::string reason;
};

/// Words of text, whatever the lines.
class TextValues {
 public:
  explicit TextValues(std::string_view text) : rest_(text) { skip_blanks(); }

  bool at_end() const { return rest_.empty(); }

  float number(PlyType) {
    const std::string_view word = next_word();
    const std::optional<float> value = float32_of(word);
    if (!value) {
      throw BadValue{in_quotes(word) + " is no number"};
    }
    return *value;
  }

  std::int64_t integer(PlyType) {
    const std::string_view word = next_word();
    std::int64_t value = 0;
    const auto parsed = std::from_chars(word.data(), word.data() + word.size(), value);
    if (parsed.ec != std::errc() || parsed.ptr != word.data() + word.size()) {
      throw BadValue{in_quotes(word) + " is no integer"};
    }
    return value;
  }

 private:
  static constexpr std::string_view blanks = " \t\r\n";

  void skip_blanks() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
  }

  std::string_view next_word() {
    const std::string_view word = rest_.substr(0, rest_.find_first_of(blanks));
    if (word.empty()) {
      throw BadValue{"the file ends in it"};
    }
    rest_.remove_prefix(word.size());
    skip_blanks();
    return word;
  }

  std::string_view rest_;
};

class BinaryValues {
 public:
  BinaryValues(std::string_view bytes, PlyEncoding encoding)
      : rest_(bytes), reversed_(encoding == PlyEncoding::big_endian) {}

  bool at_end() const { return rest_.empty(); }

  float number(PlyType type) {
    if (is_integer(type)) {
      return static_cast<float>(integer(type));
    }
    const std::uint64_t bits = next_bits(size_in_bytes(type));
    return type == PlyType::float32 ? std::bit_cast<float>(static_cast<std::uint32_t>(bits))
                                    : static_cast<float>(std::bit_cast<double>(bits));
  }

  std::int64_t integer(PlyType type) {
    const std::uint64_t bits = next_bits(size_in_bytes(type));
    switch (type) {
      case PlyType::int8:
        return static_cast<std::int8_t>(bits);
      case PlyType::int16:
        return static_cast<std::int16_t>(bits);
      case PlyType::int32:
        return static_cast<std::int32_t>(bits);
      default:
        return static_cast<std::int64_t>(bits);
    }
  }

 private:
  std::uint64_t next_bits(std::size_t size) {
    if (rest_.size() < size) {
      throw BadValue{"the file ends in it"};
    }
    std::array<char, 8> value{};
    std::copy_n(rest_.begin(), size, value.begin());
    if (reversed_) {
      std::reverse(value.begin(), value.begin() + size);
    }
    rest_.remove_prefix(size);
    return get_little_endian(value.data(), size);
  }

  std::string_view rest_;
  bool reversed_;
};

/// What becomes of a property: a coordinate (0, 1, 2), the corners of a face or of strips, or
/// nothing.
constexpr int use_as_corners = 3;
constexpr int use_as_strips = 4;
constexpr int passed_over = -1;

int use_of(const PlyElement& element, const PlyProperty& property) {
  constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
  const auto* const axis = std::find(axes.begin(), axes.end(), property.name);
  if (element.name == "vertex" && axis != axes.end() && !property.list_length) {
    return static_cast<int>(axis - axes.begin());
  }
  const bool names_corners = property.name == "vertex_indices" || property.name == "vertex_index";
  if (element.name == "face" && names_corners && property.list_length &&
      is_integer(property.type)) {
    return use_as_corners;
  }
  if (element.name == "tristrips" && names_corners && property.list_length &&
      is_integer(property.type)) {
    return use_as_strips;
  }
  return passed_over;
}

template <typename Values>
class BodyReader {
 public:
  BodyReader(const std::filesystem::path& file, const PlyHeader& header, Values values)
      : file_(file), header_(header), values_(values) {}

  TriangleMesh read() {
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") {
        vertex_count_ = element.count;
      }
    }
    for (const PlyElement& element : header_.elements) {
      read_element(element);
    }
    if (!values_.at_end()) {
      throw FileError(file_, "goes on after the last element that its header names");
    }
    mesh_.triangles = std::move(faces_).triangles(mesh_.vertices);
    return std::move(mesh_);
  }

 private:
  void read_element(const PlyElement& element) {
    std::vector<int> uses;
    for (const PlyProperty& property : element.properties) {
      uses.push_back(use_of(element, property));
    }
    if (element.name == "vertex" && std::count(uses.begin(), uses.end(), passed_over) + 3 !=
                                        static_cast<std::ptrdiff_t>(uses.size())) {
      throw FileError(file_, "has vertices without numbers x, y and z");
    }
    if (uses.empty()) {
      return;
    }
    for (std::size_t i = 0; i < element.count; ++i) {
      try {
        read_instance(element, uses);
      } catch (const BadValue& bad) {
        throw FileError(file_, element.name + " " + std::to_string(i) + ": " + bad.reason);
      }
    }
  }

  void read_instance(const PlyElement& element, const std::vector<int>& uses) {
    Point point{};
    for (std::size_t i = 0; i < uses.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (uses[i] == use_as_corners) {
        read_face(property);
      } else if (uses[i] == use_as_strips) {
        read_strips(property);
      } else if (uses[i] != passed_over) {
        point[uses[i]] = values_.number(property.type);
      } else {
        pass_over(property);
      }
    }
    if (element.name == "vertex") {
      mesh_.vertices.push_back(point);
    }
  }

  std::int64_t length_of_list(const PlyProperty& property) {
    const std::int64_t length = values_.integer(*property.list_length);
    if (length < 0) {
      throw BadValue{"a list of " + std::to_string(length) + " values"};
    }
    return length;
  }

  void pass_over(const PlyProperty& property) {
    const std::int64_t count = property.list_length ? length_of_list(property) : 1;
    for (std::int64_t i = 0; i < count; ++i) {
      values_.number(property.type);
    }
  }

  void read_face(const PlyProperty& property) {
    const std::int64_t count = length_of_list(property);
    if (count < 3) {
      throw BadValue{"a face needs three vertices"};
    }
    corners_.clear();
    for (std::int64_t i = 0; i < count; ++i) {
      corners_.push_back(vertex(values_.integer(property.type)));
    }
    faces_.add(corners_);
  }

  std::uint32_t vertex(std::int64_t number) const {
    if (number < 0 || static_cast<std::uint64_t>(number) >= vertex_count_) {
      throw BadValue{"there is no vertex " + std::to_string(number)};
    }
    return static_cast<std::uint32_t>(number);
  }

  void read_strips(const PlyProperty& property) {
    const std::int64_t count = length_of_list(property);
    Triangle last{};
    std::int64_t length = 0;  // of the strip so far
    for (std::int64_t i = 0; i < count; ++i) {
      const std::int64_t number = values_.integer(property.type);
      if (number == -1 || (property.type == PlyType::uint32 && number == 0xFFFFFFFF)) {
        length = 0;
        continue;
      }
      last = {last[1], last[2], vertex(number)};
      if (++length < 3) {
        continue;
      }
      const Triangle facing = length % 2 == 1 ? last : Triangle{last[1], last[0], last[2]};
      if (facing[0] != facing[1] && facing[1] != facing[2] && facing[2] != facing[0]) {
        faces_.add(facing);
      }
    }
  }

  const std::filesystem::path& file_;
  const PlyHeader& header_;
  Values values_;
  std::size_t vertex_count_ = 0;
  TriangleMesh mesh_;
  FaceList faces_;
  std::vector<std::uint32_t> corners_;  ///< of the face that is read
};

}  // namespace

std::string encode_ply(const TriangleMesh& mesh, const MeshLook& look) {
  const std::string header = ply_header(mesh, look);
  const std::size_t vertex_size =
      12U + (look.vertex_colours.empty() ? 0U : 3U) + (look.vertex_qualities.empty() ? 0U : 4U);
  constexpr std::size_t face_size = 13;
  std::string bytes = header;
  bytes.resize(header.size() + vertex_size * mesh.vertices.size() +
               face_size * mesh.triangles.size());
  char* out = bytes.data() + header.size();
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    for (const double x : mesh.vertices[i]) {
      out = put_float32(out, static_cast<float>(x));
    }
    if (!look.vertex_colours.empty()) {
      out = put_colour(out, look.vertex_colours[i]);
    }
    if (!look.vertex_qualities.empty()) {
      out = put_float32(out, static_cast<float>(look.vertex_qualities[i]));
    }
  }
  for (const Triangle& triangle : mesh.triangles) {
    *out++ = 3;
    for (const std::uint32_t corner : triangle) {
      out = put_little_endian(out, corner, 4);
    }
  }
  return bytes;
}

TriangleMesh decode_ply(const std::filesystem::path& file, std::string_view whole) {
  const std::string_view bytes = without_byte_order_mark(file, whole);
  const PlyHeader header = read_ply_header(file, bytes);
  const std::string_view body = bytes.substr(header.size);
  if (header.encoding == PlyEncoding::text) {
    return BodyReader(file, header, TextValues(body)).read();
  }
  return BodyReader(file, header, BinaryValues(body, header.encoding)).read();
}

}  // namespace latticast
