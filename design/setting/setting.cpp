// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/setting/setting.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/core.h>

#include "design/nearest_name.h"
#include "design/setting/path_step.h"
#include "design/text/printable.h"

namespace latticast {
namespace {

// Why a setting has no place; its Issue is made by who knows the whole of it.
struct Refusal {
  std::string rule;
  std::string hint;
};

bool is_word(std::string_view text) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return !text.empty() && is_letter(text[0]) && std::all_of(text.begin(), text.end(), [&](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '_';
  });
}

void mark_as_set(TomlValue& value) {
  value.line = Issue::set_by_path;
  value.column = 0;
  if (auto* list = std::get_if<TomlValue::List>(&value.content)) {
    for (TomlValue& item : *list) mark_as_set(item);
  } else if (auto* table = std::get_if<TomlValue::Table>(&value.content)) {
    for (TomlMember& member : *table) {
      member.key_line = Issue::set_by_path;
      member.key_column = 0;
      mark_as_set(member.value);
    }
  }
}

/// The value as TOML has it, or a word as text; empty where it is neither.
std::optional<TomlValue> parse_value(std::string_view text) {
  TomlText parsed = parse_toml(fmt::format("v = {}", text));
  auto* members = std::get_if<TomlValue::Table>(&parsed.root.content);
  std::optional<TomlValue> value;
  if (parsed.issues.empty() && members != nullptr && members->size() == 1) {
    value = std::move(members->front().value);
  } else if (is_word(text)) {
    value.emplace().content = std::string(text);
  }
  if (value) mark_as_set(*value);
  return value;
}

const std::string* name_of(const TomlValue& entry) {
  const auto* table = std::get_if<TomlValue::Table>(&entry.content);
  if (table == nullptr) return nullptr;
  const auto found = std::find_if(table->begin(), table->end(),
                                  [](const TomlMember& member) { return member.key == "name"; });
  return found == table->end() ? nullptr : std::get_if<std::string>(&found->value.content);
}

std::vector<std::string> names_in(const TomlValue::List& list) {
  std::vector<std::string> names;
  for (const TomlValue& entry : list) {
    if (const std::string* name = name_of(entry)) names.push_back(*name);
  }
  return names;
}

/// A path on its way through a design. Every member names the step that it takes next.
class PathWalk {
 public:
  PathWalk(const std::vector<PathStep>& steps, TomlValue& root) : steps_(steps), at_(&root) {}

  /// Where the value goes; nothing, with the reason in refusal(), where the path leads nowhere.
  TomlValue* place() {
    for (taken_ = 0; taken_ < steps_.size(); ++taken_) {
      if (auto* list = std::get_if<TomlValue::List>(&at_->content)) {
        at_ = entry_of(*list);
      } else if (auto* table = std::get_if<TomlValue::Table>(&at_->content)) {
        at_ = member_of(*table);
      } else {
        refuse(fmt::format("{} is {} here, and nothing is inside it", here(), written(*at_)),
               "set it as a whole");
        at_ = nullptr;
      }
      if (at_ == nullptr) return nullptr;
    }
    return at_;
  }

  const Refusal& refusal() const { return refusal_; }

 private:
  const PathStep& step() const { return steps_[taken_]; }
  std::string here() const { return path_text(steps_, taken_); }
  void refuse(std::string rule, std::string hint) { refusal_ = {std::move(rule), std::move(hint)}; }

  TomlValue* entry_of(TomlValue::List& list) {
    if (const auto number = step().number()) {
      if (*number < list.size()) return &list[*number];
      refuse(fmt::format("{} has {} entr{}, and no number {}", here(), list.size(),
                         list.size() == 1 ? "y" : "ies", *number),
             list.empty() ? "add one to the design" : "entries are counted from 0");
      return nullptr;
    }
    for (TomlValue& entry : list) {
      const std::string* name = name_of(entry);
      if (name != nullptr && *name == step().key) return &entry;
    }
    refuse_entry_name(list);
    return nullptr;
  }

  void refuse_entry_name(const TomlValue::List& list) {
    const std::vector<std::string> names = names_in(list);
    const std::string rule = fmt::format("{} is a list, and none of its entries is named {}",
                                         here(), written_key(step().key));
    const std::string by_number =
        fmt::format("name an entry by its number, counted from 0: {}.0.{}", here(),
                    path_text({steps_.begin() + static_cast<std::ptrdiff_t>(taken_), steps_.end()},
                              steps_.size()));
    refuse(rule, names.empty() ? by_number : name_hint(step().key, names, "names"));
  }

  TomlValue* member_of(TomlValue::Table& table) {
    const auto place = std::lower_bound(
        table.begin(), table.end(), step().key,
        [](const TomlMember& member, const std::string& key) { return member.key < key; });
    if (place != table.end() && place->key == step().key) return &place->value;
    const auto rest = steps_.begin() + static_cast<std::ptrdiff_t>(taken_) + 1;
    if (std::any_of(rest, steps_.end(), [](const PathStep& s) { return s.number().has_value(); })) {
      refuse_missing(table);
      return nullptr;
    }
    TomlMember added{step().key, Issue::set_by_path, 0, {}};
    added.value.content = TomlValue::Table();
    mark_as_set(added.value);
    return &table.insert(place, std::move(added))->value;
  }

  // An entry of a list that is not there.
  void refuse_missing(const TomlValue::Table& table) {
    std::vector<std::string> keys;
    for (const TomlMember& member : table) keys.push_back(member.key);
    refuse(fmt::format("the design has no {}", path_text(steps_, taken_ + 1)),
           name_hint(step().key, keys, "keys"));
  }

  const std::vector<PathStep>& steps_;
  TomlValue* at_;
  std::size_t taken_ = 0;
  Refusal refusal_;
};

std::optional<Refusal> put_in_place(std::string_view setting, TomlValue& root) {
  const SplitSetting split = split_setting(setting);
  if (!split.value) return Refusal{"is no setting", "write PATH=VALUE, as in segment.0.length=90"};
  const ParsedPath path = parse_path(split.path);
  if (!path.problem.empty()) return Refusal{"is no path: " + path.problem, "see segment.0.length"};
  std::optional<TomlValue> value = parse_value(*split.value);
  if (!value) {
    return Refusal{"has a value that is neither one of TOML nor a word",
                   R"(write a number, true, "text", [1, 2] or { from = 2, to = 3 })"};
  }
  PathWalk walk(path.steps, root);
  TomlValue* place = walk.place();
  if (place == nullptr) return walk.refusal();
  *place = std::move(*value);
  return std::nullopt;
}

}  // namespace

std::vector<Issue> apply_settings(std::span<const std::string> settings, TomlValue& root) {
  std::vector<Issue> issues;
  for (const std::string& setting : settings) {
    if (std::optional<Refusal> refusal = put_in_place(setting, root)) {
      issues.push_back({Issue::set_by_path, printable(setting), "", std::move(refusal->rule),
                        std::move(refusal->hint)});
    }
  }
  return issues;
}

ReadResult read_design_with(std::string_view toml_text, std::span<const std::string> settings,
                            const MaterialLibrary& materials) {
  TomlText text = parse_toml(toml_text);
  if (!text.issues.empty()) return {{}, std::move(text.issues)};
  std::vector<Issue> issues = apply_settings(settings, text.root);
  ReadResult result = read_design(text, materials);
  std::move(result.issues.begin(), result.issues.end(), std::back_inserter(issues));
  result.issues = std::move(issues);
  return result;
}

}  // namespace latticast
