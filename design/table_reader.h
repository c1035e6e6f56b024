// SPDX-License-Identifier: GPL-3.0-or-later
// Reading a tree of TOML values so that each rule of the grammar takes one line and no problem
// stops the reading: whatever is wrong is noted, and reading goes on with what is left.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "design/issue.h"
#include "design/limits.h"
#include "design/toml_text.h"
#include "design/word.h"

namespace latticast {

/// The problems found so far, each with its place in the file.
class Problems {
 public:
  void add(int column, Issue issue) { entries_.push_back({column, std::move(issue)}); }

  /// By line and column; problems of one place stay in the order in which they were found.
  std::vector<Issue> in_file_order() const;

 private:
  struct Entry {
    int column;
    Issue issue;
  };
  std::vector<Entry> entries_;
};

class TableReader;

/// A value together with its key path, or the absence of one. Reading an absent field gives the
/// fallback and says nothing; reading a present one that breaks its rule notes the problem and
/// gives what "refused" means for that type: NaN for a number, so that a comparison made with it
/// later is false and stays silent.
///
/// Fields are views: the TOML tree and the Problems must outlive them.
class Field {
 public:
  Field(const TomlValue* value, std::string path, Problems& problems)
      : value_(value), path_(std::move(path)), problems_(&problems) {}

  bool present() const { return value_ != nullptr; }
  bool is_number() const;
  bool is_text() const;
  bool is_list() const;
  bool is_table() const;

  /// NaN when absent or refused.
  double number(const Range& range) const;
  double number_or(double fallback, const Range& range) const;
  /// Empty when absent or refused.
  std::optional<double> optional_number(const Range& range) const;
  std::optional<int> whole(int low, int high) const;
  std::optional<std::string> text() const;
  /// `fallback` also when refused.
  bool flag_or(bool fallback) const;

  /// The meaning of the one of `words` that is written; `fallback` when absent or refused.
  template <class Meaning, std::size_t n>
  Meaning word_or(Meaning fallback, const Word<Meaning> (&words)[n]) const {
    return word_or(fallback, std::span<const Word<Meaning>>(words));
  }
  template <class Meaning>
  Meaning word_or(Meaning fallback, std::span<const Word<Meaning>> words) const {
    std::vector<std::string> names;
    for (const Word<Meaning>& word : words) names.emplace_back(word.name);
    const std::optional<std::size_t> chosen = index_of_word(names);
    return chosen ? words[*chosen].meaning : fallback;
  }

  /// The entries of a list that holds from `low` to `high` of them; none when absent or refused.
  /// `hint` says how such a list is written.
  std::vector<Field> items(std::size_t low, std::size_t high, std::string_view hint) const;
  /// A list of numbers; entries that are refused are NaN, so that the size is what was written.
  std::vector<double> numbers(std::size_t low, std::size_t high, const Range& range) const;

  /// The field as a table; an absent one when it is something else. `hint` says how it is written.
  TableReader as_table(std::string_view hint) const;

  /// Notes that this field breaks a rule. Nothing when the field is absent.
  void refuse(std::string rule, std::string hint) const;

 private:
  friend class TableReader;
  std::optional<std::size_t> index_of_word(const std::vector<std::string>& names) const;

  const TomlValue* value_;
  std::string path_;
  Problems* problems_;
};

/// A table being read. Every key that is asked for counts as known; when all have been asked for,
/// refuse_unknown_keys() notes the others. An absent table has only absent fields, silently.
class TableReader {
 public:
  explicit TableReader(Field table) : table_(std::move(table)) {}

  bool present() const { return table_.present(); }
  const Field& table() const { return table_; }

  /// A key that may be left out.
  Field may(std::string_view key);
  /// A key that must be there; `example` is how a user would write it.
  Field need(std::string_view key, std::string_view example);
  void refuse_unknown_keys() const;
  /// Every key with its field, sorted by key: for tables whose keys are names of the user's own.
  std::vector<std::pair<std::string, Field>> entries() const;

 private:
  const TomlValue::Table& members() const;
  std::string path_of(std::string_view key) const;
  Field member_field(const TomlMember& member) const;

  Field table_;
  std::vector<std::string> known_;
};

/// The outermost table of a file.
TableReader root_table(const TomlValue& root, Problems& problems);

}  // namespace latticast
