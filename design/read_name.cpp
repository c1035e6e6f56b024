// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/read_name.h"

#include <algorithm>

#include <fmt/core.h>

#include "design/text/printable.h"

namespace latticast {
namespace {

char capital(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

// Windows gives these to devices, whatever follows the first point.
bool is_reserved(std::string_view name) {
  std::string start(name.substr(0, name.find('.')));
  std::transform(start.begin(), start.end(), start.begin(), capital);
  for (const std::string_view device : {"CON", "PRN", "AUX", "NUL"}) {
    if (start == device) return true;
  }
  const bool numbered = start.size() == 4 && start[3] >= '1' && start[3] <= '9';
  return numbered && (start.starts_with("COM") || start.starts_with("LPT"));
}

std::string broken_rule(std::string_view name) {
  if (name.empty() || name.size() > limits::name_bytes) {
    return fmt::format("must have from 1 to {} bytes", limits::name_bytes);
  }
  if (name.find_first_of("/\\") != std::string::npos) {
    return "must not hold a path separator, / or \\";
  }
  switch (first_unprintable(name)) {
    case Unprintable::control:
      return "must not hold control characters";
    case Unprintable::hidden:
      return "must not hold characters that turn the direction of writing or cannot be seen";
    case Unprintable::none:
      break;
  }
  if (name.find_first_of("<>:\"|?*") != std::string::npos) {
    return "must not hold < > : \" | ? or *, which many disks and memory cards refuse";
  }
  if (name[0] == '.' || name[0] == '-') return "must not start with a point or a minus";
  if (name.front() == ' ' || name.back() == ' ') return "must not start or end with a space";
  if (is_reserved(name)) return "must not be a name that Windows keeps for a device";
  return {};
}

bool is_word(std::string_view name) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto may_follow = [&](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return !name.empty() && name.size() <= limits::name_bytes && is_letter(name[0]) &&
         std::all_of(name.begin(), name.end(), may_follow);
}

}  // namespace

std::string read_design_name(const Field& field) {
  std::string name = field.text().value_or("");
  if (!field.is_text()) return name;
  if (std::string rule = broken_rule(name); !rule.empty()) {
    field.refuse(std::move(rule),
                 R"(the name begins the files' names; write one as in "twisting-36")");
  }
  return name;
}

std::string read_entry_name(const Field& field, std::vector<std::string>& others) {
  std::string name = field.text().value_or("");
  if (!field.is_text()) return name;
  if (!is_word(name)) {
    field.refuse("must be a letter, then letters, digits, _ and -", R"(write one as in "tip")");
  } else if (std::find(others.begin(), others.end(), name) != others.end()) {
    field.refuse("must not be the name of two", "give each a name of its own");
  }
  others.push_back(name);
  return name;
}

}  // namespace latticast
