// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/report_page.h"

#include <string>

#include <gtest/gtest.h>

namespace latticast {
namespace {

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
    ++found;
  return found;
}

std::string page_with(const std::string& text) {
  return report_page({text, "{\"name\":\"" + text + "\"}", "{\"note\":\"" + text + "\"}", "glTF"});
}

// The vectors of RFC 4648, section 10.
TEST(Base64, AgreesWithRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, TakesEveryByte) {
  EXPECT_EQ(base64({"\0\0\0", 3}), "AAAA");
  EXPECT_EQ(base64("\xff\xff\xff"), "////");
  EXPECT_EQ(base64("\xfb\xef\xbe"), "++++");
  EXPECT_EQ(base64({"\x80\0", 2}), "gAA=");
}

TEST(EscapedHtml, LeavesNoMarkup) {
  EXPECT_EQ(escaped_html("a<b>&\"'\xc3\xbc"), "a&lt;b&gt;&amp;&quot;&#39;\xc3\xbc");
}

TEST(EscapedJson, KeepsTheValueAndEndsNoElement) {
  EXPECT_EQ(escaped_json(R"({"a":"</script><!--&"})"),
            R"({"a":"\u003c/script\u003e\u003c!--\u0026"})");
  EXPECT_EQ(escaped_json("\xe2\x80\xa8 \xe2\x80\xa9 \xe2\x80\xa7"), "\\u2028 \\u2029 \xe2\x80\xa7");
  EXPECT_EQ(escaped_json("\xe2\x80"), "\xe2\x80");
}

TEST(ReportPage, TextsThatLookLikeMarkupAddNone) {
  const std::string plain = page_with("name");
  const std::string hostile = page_with("</script></title><script>x</script><!--");
  for (const char* markup : {"<script", "</script", "<!--", "<title", "</title"})
    EXPECT_EQ(count(plain, markup), count(hostile, markup)) << markup;
}

// A text that names a place of the template is data: it is not replaced in turn.
TEST(ReportPage, TextsThatLookLikePlacesStayText) {
  const std::string page = page_with("{{model}} {{style}}");
  EXPECT_EQ(count(page, "{{model}} {{style}}"), 3);
  EXPECT_EQ(count(page, base64("glTF")), 1);
}

TEST(ReportPage, EveryPlaceIsFilled) {
  const std::string page = page_with("name");
  EXPECT_EQ(count(page, "<title>name</title>"), 1);
  for (const char* place : {"{{title}}", "{{style}}", "{{report}}", "{{view}}", "{{model}}",
                            "{{script}}", "{{viewer}}"})
    EXPECT_EQ(count(page, place), 0) << place;
}

TEST(ReportPage, ScriptsEndNoElementOfTheirOwn) {
  const std::string page = page_with("name");
  EXPECT_EQ(count(page, "<script"), count(page, "</script"));
  EXPECT_EQ(count(page, "</script>"), 6);
}

// The licence of the view's library asks for its notice in every copy.
TEST(ReportPage, CarriesTheLicenceOfTheViewer) {
  if (!has_viewer()) GTEST_SKIP() << "built without the 3-D view";
  EXPECT_EQ(count(page_with("name"),
                  "The above copyright notice and this permission notice shall be included"),
            1);
}

TEST(ReportPage, WorksWithoutAnyPart) {
  EXPECT_EQ(count(report_page({}), "</html>"), 1);
}

}  // namespace
}  // namespace latticast
