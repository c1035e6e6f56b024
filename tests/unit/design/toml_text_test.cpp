// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/toml_text.h"

#include <gtest/gtest.h>

#include "design/limits.h"

namespace latticast {
namespace {

std::string repeated(std::string_view text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

void expect_too_deep(const std::string& text, int line) {
  const TomlText parsed = parse_toml(text);
  ASSERT_EQ(parsed.issues.size(), 1U) << text.substr(0, 80);
  EXPECT_NE(parsed.issues[0].rule.find("32 deep"), std::string::npos) << parsed.issues[0].rule;
  EXPECT_EQ(parsed.issues[0].line, line);
}

TEST(ParseToml, KeepsPlaces) {
  const TomlText parsed = parse_toml("b = 1\n\n  a = [2,\n 3.5]\n[t]\nd = 2020-01-02\n");
  ASSERT_TRUE(parsed.issues.empty());
  EXPECT_EQ(parsed.root.line, 0);
  const auto& members = std::get<TomlValue::Table>(parsed.root.content);
  ASSERT_EQ(members.size(), 3U);
  EXPECT_EQ(members[0].key, "a");
  EXPECT_EQ(members[0].key_line, 3);
  EXPECT_EQ(members[0].key_column, 3);
  const auto& list = std::get<TomlValue::List>(members[0].value.content);
  EXPECT_EQ(list[1].line, 4);
  EXPECT_EQ(list[1].column, 2);
  EXPECT_EQ(members[2].value.line, 5);
  EXPECT_EQ(written(members[2].value), "{...}");
  const auto& date = std::get<TomlValue::Table>(members[2].value.content)[0];
  EXPECT_EQ(written(date.value), "2020-01-02");
}

TEST(ParseToml, RefusesDepthBeforeItCanHarm) {
  expect_too_deep("x = 1\na = " + repeated("[", 1900000), 2);
  expect_too_deep("a = " + repeated("{a=", 1000000), 1);
  expect_too_deep("\n\na" + repeated(".a", 1900000) + " = 1", 3);
  expect_too_deep("[a" + repeated(".a", 1900000) + "]", 1);
  expect_too_deep("a" + repeated(".\"=#.\"", 500000) + " = 1", 1);
  expect_too_deep("a" + repeated(".'\\'", 500000) + " = 1", 1);
  expect_too_deep("s = \"\"\"\n\\\"\"\" # \" \n\"\"\"\na" + repeated(".a", 100000) + " = 1", 4);
}

TEST(ParseToml, DotsAndBracketsInTextAndCommentsAreNotDepth) {
  const std::string dots = repeated(".", 500) + repeated("[", 500);
  const std::string text = "# " + dots + "\na = \"" + dots + "\" # \"" + dots + "\nb = '" + dots +
                           "'\nc = \"\"\"" + dots + "\n\"" + dots + "\"\"\"\nd = \"\\\"" + dots +
                           "\"\n";
  const TomlText parsed = parse_toml(text);
  ASSERT_TRUE(parsed.issues.empty()) << parsed.issues[0].rule;
  EXPECT_EQ(std::get<TomlValue::Table>(parsed.root.content).size(), 4U);
}

TEST(ParseToml, DeepButAllowed) {
  const int deep = limits::nesting;
  EXPECT_TRUE(parse_toml("a" + repeated(".a", deep) + " = 1").issues.empty());
  EXPECT_TRUE(parse_toml("a = " + repeated("[", deep) + repeated("]", deep)).issues.empty());
}

TEST(ParseToml, SizeLimit) {
  const std::string line = "#" + std::string(limits::file_bytes - 1, 'x');
  EXPECT_TRUE(parse_toml(line).issues.empty());
  EXPECT_EQ(parse_toml(line + "x").issues.size(), 1U);
}

TEST(ParseToml, EveryByteAlone) {
  for (int byte = 0; byte < 256; ++byte) {
    const TomlText parsed = parse_toml(std::string(1, static_cast<char>(byte)));
    const bool harmless = byte == ' ' || byte == '\t' || byte == '\n' || byte == '#';
    EXPECT_EQ(parsed.issues.empty(), harmless) << byte;
  }
}

TEST(Written, ShowsOneShortCleanLine) {
  TomlValue value;
  value.content = std::string("a\n\x1b[31m\"\\");
  EXPECT_EQ(written(value), R"("a\u000a\u001b[31m\"\\")");
  value.content = std::string(1000, 'x');
  EXPECT_EQ(written(value), '"' + std::string(60, 'x') + "...\"");
  value.content = 0.1;
  EXPECT_EQ(written(value), "0.1");
  value.content = TomlValue::List(100, value);
  EXPECT_EQ(written(value), "[0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, ...]");
}

TEST(Written, NeverCutsACharacterInHalf) {
  for (int before = 55; before < 65; ++before) {
    TomlValue value;
    value.content =
        std::string(before, 'x') + "\xE2\x82\xAC\xE2\x82\xAC\xE2\x82\xAC";  // euro signs
    const std::string shown = written(value);
    // What is shown is text again.
    EXPECT_TRUE(parse_toml("a = " + shown).issues.empty()) << shown;
  }
}

TEST(WrittenKey, QuotesWhatIsNotBare) {
  EXPECT_EQ(written_key("inner_radius"), "inner_radius");
  EXPECT_EQ(written_key("3mf-x"), "3mf-x");
  EXPECT_EQ(written_key(""), "\"\"");
  EXPECT_EQ(written_key("a b"), "\"a b\"");
  EXPECT_EQ(written_key("a\"\n"), R"("a\"\u000a")");
}

}  // namespace
}  // namespace latticast
