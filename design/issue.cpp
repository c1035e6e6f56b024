// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/issue.h"

namespace latticast {

std::string describe(const Issue& issue, std::string_view file) {
  std::string text(file);
  if (issue.line > 0) text += ':' + std::to_string(issue.line);
  if (issue.line == Issue::set_by_path) text += " as set";
  text += ": ";
  if (!issue.key.empty()) {
    text += issue.key;
    if (!issue.value.empty()) text += " = " + issue.value;
    text += ": ";
  }
  text += issue.rule;
  if (!issue.hint.empty()) {
    text += ". " + issue.hint;
    char& first = text[text.size() - issue.hint.size()];
    if (first >= 'a' && first <= 'z') first = static_cast<char>(first - 'a' + 'A');
  }
  return text;
}

}  // namespace latticast
