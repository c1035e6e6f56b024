// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/table_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include <fmt/core.h>

#include "design/joined.h"
#include "design/nearest_name.h"
#include "design/text/written_number.h"

namespace latticast {
namespace {

constexpr double refused_number = std::numeric_limits<double>::quiet_NaN();

std::optional<double> as_number(const TomlValue& value) {
  if (const auto* x = std::get_if<double>(&value.content)) return *x;
  if (const auto* i = std::get_if<std::int64_t>(&value.content)) return static_cast<double>(*i);
  return std::nullopt;
}

std::string unit_of(const Range& range) {
  return *range.unit == '\0' ? "" : fmt::format(" {}", range.unit);
}

std::string rule_of(const Range& range) {
  const std::string unit = unit_of(range);
  const std::string low = written(range.low);
  const std::string high = written(range.high);
  switch (range.ends) {
    case RangeEnds::both:
      break;
    case RangeEnds::low:
      return fmt::format("must be a number from {0} to {1}{2}, {1} not included", low, high, unit);
    case RangeEnds::neither:
      return fmt::format("must be a number between {} and {}{}, neither included", low, high, unit);
  }
  return fmt::format("must be a number from {} to {}{}", low, high, unit);
}

std::string in_its_unit(const Range& range) {
  return *range.unit == '\0' ? "" : fmt::format(", in {}", range.unit);
}

}  // namespace

std::vector<Issue> Problems::in_file_order() const {
  std::vector<Entry> sorted = entries_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.issue.line, a.column) < std::tie(b.issue.line, b.column);
  });
  std::vector<Issue> issues;
  issues.reserve(sorted.size());
  for (Entry& entry : sorted) issues.push_back(std::move(entry.issue));
  return issues;
}

bool Field::is_number() const {
  return present() && as_number(*value_).has_value();
}

bool Field::is_text() const {
  return present() && std::holds_alternative<std::string>(value_->content);
}

bool Field::is_list() const {
  return present() && std::holds_alternative<TomlValue::List>(value_->content);
}

bool Field::is_table() const {
  return present() && std::holds_alternative<TomlValue::Table>(value_->content);
}

double Field::number(const Range& range) const {
  if (!present()) return refused_number;
  const std::optional<double> x = as_number(*value_);
  if (x && range.contains(*x)) return *x;
  refuse(rule_of(range), "write a plain number" + in_its_unit(range));
  return refused_number;
}

double Field::number_or(double fallback, const Range& range) const {
  return present() ? number(range) : fallback;
}

std::optional<double> Field::optional_number(const Range& range) const {
  const double x = number(range);
  return std::isnan(x) ? std::nullopt : std::optional(x);
}

std::optional<int> Field::whole(int low, int high) const {
  if (!present()) return std::nullopt;
  const auto* i = std::get_if<std::int64_t>(&value_->content);
  if (i && *i >= low && *i <= high) return static_cast<int>(*i);
  refuse(fmt::format("must be a whole number from {} to {}", low, high),
         "write it without point or quotes");
  return std::nullopt;
}

std::optional<std::string> Field::text() const {
  if (!present()) return std::nullopt;
  if (is_text()) return std::get<std::string>(value_->content);
  refuse("must be text", "write it in quotes");
  return std::nullopt;
}

bool Field::flag_or(bool fallback) const {
  if (!present()) return fallback;
  if (const bool* flag = std::get_if<bool>(&value_->content)) return *flag;
  refuse("must be true or false", "write true or false, without quotes");
  return fallback;
}

std::optional<std::size_t> Field::index_of_word(const std::vector<std::string>& names) const {
  if (!present()) return std::nullopt;
  const auto* typed = std::get_if<std::string>(&value_->content);
  const auto found = typed ? std::find(names.begin(), names.end(), *typed) : names.end();
  if (found != names.end()) return found - names.begin();
  const std::string rule = fmt::format("must be \"{}\"", joined(names, "\" or \""));
  refuse(rule, typed ? name_hint(*typed, names, "words") : "write one of these words in quotes");
  return std::nullopt;
}

std::vector<Field> Field::items(std::size_t low, std::size_t high, std::string_view hint) const {
  if (!present()) return {};
  const auto* list = std::get_if<TomlValue::List>(&value_->content);
  if (!list || list->size() < low || list->size() > high) {
    const std::string size = low == high ? fmt::format("{}", low)  //
                                         : fmt::format("{} to {}", low, high);
    const std::string held = list ? fmt::format("; this one holds {}", list->size()) : "";
    refuse(fmt::format("must be a list of {} entries{}", size, held), std::string(hint));
    return {};
  }
  std::vector<Field> fields;
  fields.reserve(list->size());
  for (std::size_t i = 0; i < list->size(); ++i) {
    fields.emplace_back(&(*list)[i], fmt::format("{}[{}]", path_, i), *problems_);
  }
  return fields;
}

std::vector<double> Field::numbers(std::size_t low, std::size_t high, const Range& range) const {
  const std::string hint = "write plain numbers in square brackets" + in_its_unit(range);
  std::vector<double> values;
  for (const Field& item : items(low, high, hint)) values.push_back(item.number(range));
  return values;
}

TableReader Field::as_table(std::string_view hint) const {
  if (present() && !is_table()) {
    refuse("must be a table", std::string(hint));
    return TableReader(Field(nullptr, path_, *problems_));
  }
  return TableReader(*this);
}

void Field::refuse(std::string rule, std::string hint) const {
  if (!present()) return;
  const bool has_value = !path_.empty();
  problems_->add(value_->column, {value_->line, path_, has_value ? written(*value_) : "",
                                  std::move(rule), std::move(hint)});
}

Field TableReader::member_field(const TomlMember& member) const {
  return Field(&member.value, path_of(member.key), *table_.problems_);
}

std::string TableReader::path_of(std::string_view key) const {
  const std::string last = written_key(key);
  return table_.path_.empty() ? last : fmt::format("{}.{}", table_.path_, last);
}

Field TableReader::may(std::string_view key) {
  known_.emplace_back(key);
  const TomlValue::Table& members = this->members();
  const auto found = std::lower_bound(
      members.begin(), members.end(), key,
      [](const TomlMember& member, std::string_view name) { return member.key < name; });
  if (found != members.end() && found->key == key) return member_field(*found);
  return Field(nullptr, path_of(key), *table_.problems_);
}

Field TableReader::need(std::string_view key, std::string_view example) {
  Field field = may(key);
  if (present() && !field.present()) {
    const TomlValue& table = *table_.value_;
    table_.problems_->add(table.column, {table.line, field.path_, "", "must be given",
                                         fmt::format("add, for example, {}", example)});
  }
  return field;
}

void TableReader::refuse_unknown_keys() const {
  for (const TomlMember& member : members()) {
    if (std::find(known_.begin(), known_.end(), member.key) != known_.end()) continue;
    table_.problems_->add(member.key_column,
                          {member.key_line, path_of(member.key), written(member.value),
                           "is not a known key", name_hint(member.key, known_, "keys")});
  }
}

std::vector<std::pair<std::string, Field>> TableReader::entries() const {
  std::vector<std::pair<std::string, Field>> fields;
  for (const TomlMember& member : members()) fields.emplace_back(member.key, member_field(member));
  return fields;
}

const TomlValue::Table& TableReader::members() const {
  static const TomlValue::Table none;
  return table_.is_table() ? std::get<TomlValue::Table>(table_.value_->content) : none;
}

TableReader root_table(const TomlValue& root, Problems& problems) {
  return TableReader(Field(&root, "", problems));
}

}  // namespace latticast
