// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/mesh/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>
#include <utility>

#include "design/file_error.h"
#include "export/mesh/line_reader.h"

namespace latticast {
namespace {

struct TypeName {
  std::string_view old_name;
  std::string_view name;
  std::size_t size;
};

/// In the order of PlyType.
constexpr std::array<TypeName, 8> types{{{"char", "int8", 1},
                                         {"uchar", "uint8", 1},
                                         {"short", "int16", 2},
                                         {"ushort", "uint16", 2},
                                         {"int", "int32", 4},
                                         {"uint", "uint32", 4},
                                         {"float", "float32", 4},
                                         {"double", "float64", 8}}};

std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view blanks = " \t";
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;
       at = line.find_first_not_of(blanks)) {
    line.remove_prefix(at);
    const std::string_view word = line.substr(0, line.find_first_of(blanks));
    words.push_back(word);
    line.remove_prefix(word.size());
  }
  return words;
}

bool has_name(const auto& list, std::string_view name) {
  return std::any_of(list.begin(), list.end(), [&](const auto& item) { return item.name == name; });
}

class HeaderReader {
 public:
  HeaderReader(const std::filesystem::path& file, std::string_view bytes)
      : file_(file),
        bytes_(bytes),
        line_end_(bytes.starts_with("ply\r") && !bytes.starts_with("ply\r\n") ? '\r' : '\n') {}

  PlyHeader read() {
    if (next_line() != "ply") {
      throw FileError(file_, "does not begin with a PLY header");
    }
    while (true) {
      const std::vector<std::string_view> words = words_of(next_line());
      if (words.empty()) {
        fail("is empty");
      }
      if (words[0] == "end_header") {
        break;
      }
      read_statement(words);
    }
    if (!has_format_) {
      fail("the format is missing before it");
    }
    check_counts();
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw FileError(file_, "line " + std::to_string(line_number_) + ": " + reason);
  }

  std::string_view next_line() {
    const std::size_t end = bytes_.find(line_end_, header_.size);
    if (end == std::string_view::npos) {
      throw FileError(file_, "has a PLY header without an end");
    }
    std::string_view line = bytes_.substr(header_.size, end - header_.size);
    header_.size = end + 1;
    ++line_number_;
    if (line.ends_with('\r')) {
      line.remove_suffix(1);
    }
    return line;
  }

  void read_statement(const std::vector<std::string_view>& words) {
    if (words[0] == "format") {
      read_format(words);
    } else if (words[0] == "element") {
      read_element(words);
    } else if (words[0] == "property") {
      read_property(words);
    } else if (words[0] != "comment" && words[0] != "obj_info") {
      fail(in_quotes(words[0]) + " is no statement of a PLY header");
    }
  }

  void read_format(const std::vector<std::string_view>& words) {
    constexpr std::array<std::string_view, 3> names{"ascii", "binary_little_endian",
                                                    "binary_big_endian"};
    const auto* const found =
        words.size() == 3 ? std::find(names.begin(), names.end(), words[1]) : names.end();
    if (has_format_ || found == names.end() || words[2] != "1.0") {
      fail("is no format of PLY 1.0, or a second one");
    }
    header_.encoding = static_cast<PlyEncoding>(found - names.begin());
    has_format_ = true;
  }

  void read_element(const std::vector<std::string_view>& words) {
    PlyElement element;
    if (words.size() != 3) {
      fail("an element needs a name and a count");
    }
    const char* const end = words[2].data() + words[2].size();
    const auto parsed = std::from_chars(words[2].data(), end, element.count);
    if (parsed.ec != std::errc() || parsed.ptr != end) {
      fail(in_quotes(words[2]) + " is no count");
    }
    element.name = words[1];
    if (has_name(header_.elements, element.name)) {
      fail("a second element \"" + element.name + "\"");
    }
    header_.elements.push_back(std::move(element));
  }

  PlyType type_of(std::string_view word) const {
    const auto* const found = std::find_if(types.begin(), types.end(), [&](const TypeName& type) {
      return type.old_name == word || type.name == word;
    });
    if (found == types.end()) {
      fail(in_quotes(word) + " is no type");
    }
    return static_cast<PlyType>(found - types.begin());
  }

  void read_property(const std::vector<std::string_view>& words) {
    if (header_.elements.empty()) {
      fail("a property before the first element");
    }
    const bool is_list = words.size() > 1 && words[1] == "list";
    if (words.size() != (is_list ? 5 : 3)) {
      fail("a property needs a type and a name");
    }
    PlyProperty property{std::string(words.back()), type_of(words[words.size() - 2]), {}};
    if (is_list) {
      property.list_length = type_of(words[2]);
      if (!is_integer(*property.list_length)) {
        fail("the length of a list must be an integer");
      }
    }
    std::vector<PlyProperty>& properties = header_.elements.back().properties;
    if (has_name(properties, property.name)) {
      fail("a second property \"" + property.name + "\"");
    }
    properties.push_back(std::move(property));
  }

  // Each instance takes a byte at least, unless it has no properties and nothing is read.
  void check_counts() const {
    for (const PlyElement& element : header_.elements) {
      if (element.count > bytes_.size() - header_.size && !element.properties.empty()) {
        throw FileError(file_, "says that it holds more \"" + element.name +
                                   "\" elements than it has bytes for them");
      }
    }
  }

  const std::filesystem::path& file_;
  std::string_view bytes_;
  char line_end_;
  PlyHeader header_;
  std::size_t line_number_ = 0;
  bool has_format_ = false;
};

}  // namespace

std::size_t size_in_bytes(PlyType type) {
  return types.at(static_cast<std::size_t>(type)).size;
}

bool is_integer(PlyType type) {
  return type != PlyType::float32 && type != PlyType::float64;
}

PlyHeader read_ply_header(const std::filesystem::path& file, std::string_view bytes) {
  return HeaderReader(file, bytes).read();
}

}  // namespace latticast
