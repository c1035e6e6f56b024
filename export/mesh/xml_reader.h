// SPDX-License-Identifier: GPL-3.0-or-later
// XML reader (expat): a document as a sequence of elements that begin and end.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace latticast {

/// The attributes of one element, by name; in a namespace it is "NAMESPACE|NAME".
class XmlAttributes {
 public:
  /// `pairs` are names and values in turn, and a null.
  explicit XmlAttributes(const char** pairs) : pairs_(pairs) {}

  std::optional<std::string_view> find(std::string_view name) const;

 private:
  const char** pairs_;
};

/// Reads a document piece by piece. Names are "NAMESPACE|NAME", or "NAME" in none; a document type,
/// and with it every entity of its own, is refused. Time grows with the bytes, however long a
/// single attribute is.
class XmlReader {
 public:
  struct Events {
    std::function<void(std::string_view name, const XmlAttributes&)> start;
    std::function<void(std::string_view name)> end;
    std::function<void(std::string_view text)> text = {};  ///< between elements, in pieces
    /// What a prefix stands for, before the element that says so.
    std::function<void(std::string_view prefix, std::string_view name_space)> prefix = {};
  };

  XmlReader(std::filesystem::path file, Events events);
  ~XmlReader();
  XmlReader(const XmlReader&) = delete;
  XmlReader& operator=(const XmlReader&) = delete;

  /// Throws FileError naming the file and the line for what is not well-formed, and what the events
  /// throw; nothing may be read afterwards.
  void read(std::string_view piece);

  /// After the last piece. Throws FileError when the document is not complete.
  void finish();

  /// From 1.
  std::size_t line_number() const;

 private:
  struct Parser;

  std::unique_ptr<Parser> parser_;
};

}  // namespace latticast
