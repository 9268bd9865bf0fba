#include "model/formats/files/printable_text.h"

#include <gtest/gtest.h>

#include "model/overview/session_report.h"
#include "model/report/drawing.h"

namespace remount::formats {
namespace {

TEST(printable_text, of_any_script_stays_as_it_is) {
  for (const char* text : {"", "drive 1", "测试 行驶", "Überfahrt №7", "\xF0\x9F\x9A\x97", "a\tb\nc", "1 < 2 & \"x\""})
    EXPECT_EQ(printable(text), text);
}

TEST(printable_text, that_steers_is_shown) {
  EXPECT_EQ(printable("\x1b[2J\x1b]0;title\x07"), "\\x1b[2J\\x1b]0;title\\x07");
  EXPECT_EQ(printable("a\rb\x7f\b"), "a\\x0db\\x7f\\x08");
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m"),
            "\\u009b31m")
      << "the other control sequence introducer";
  EXPECT_EQ(printable("a\xe2\x80\xae"
                      "b\xe2\x81\xa6"),
            "a\\u202eb\\u2066")
      << "turns the direction";
  EXPECT_EQ(printable("\xff\xfe\x80 \xc0\xaf \xed\xa0\x80"), "\\xff\\xfe\\x80 \\xc0\\xaf \\xed\\xa0\\x80")
      << "no UTF-8";
  EXPECT_EQ(printable("cut \xe6\xb5"), "cut \\xe6\\xb5");
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\x00b");
}

TEST(printable_text, of_a_name_is_one_line) {
  EXPECT_EQ(printable("a\nremount-cli: all is well", LineBreaks::Escaped), "a\\x0aremount-cli: all is well");
  EXPECT_EQ(printable("a\nb"), "a\nb");
}

TEST(printable_text, is_what_pages_and_reports_have) {
  EXPECT_EQ(escape_html("<b>\x1b[31m"), "&lt;b&gt;\\x1b[31m");
  drive::Session session;
  session.path = "drive\n\x1b[2J";
  session.topics.push_back({"/points\nall is well", "t\x1b", 3, 0.0, {}, {}});
  session.findings.push_back(
      {drive::Severity::Warning, "bad-scan", std::string("a\nb"), Message::verbatim("it holds \x1b")});
  Progress progress;
  const std::string text = overview::describe(session, overview::report_session(session, progress));
  EXPECT_NE(text.find("drive\\x0a\\x1b[2J\n"), std::string::npos) << text;
  EXPECT_NE(text.find("/points\\x0aall is well"), std::string::npos) << text;
  EXPECT_NE(text.find("a\\x0ab: "), std::string::npos) << text;
}

}  // namespace
}  // namespace remount::formats
