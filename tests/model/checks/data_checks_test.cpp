#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "algorithms/messages/render.h"
#include "model/formats/files/printable_text.h"
#include "model/formats/session_readers.h"
#include "model/overview/session_report.h"
#include "model/report/drawing.h"
#include "model/report/report.h"
#include "tests/model/checks/check_fixture.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::checks {
namespace {

TEST(data_checks, every_code_stands_once_with_what_it_means_and_what_to_do) {
  std::set<std::string_view> codes;
  for (const DataCheck& check : data_checks())
    for (const FindingKind& kind : check.kinds) {
      EXPECT_TRUE(codes.insert(kind.code).second) << kind.code << " stands twice";
      EXPECT_TRUE(english(kind.meaning()).ends_with('.')) << kind.code;
      EXPECT_TRUE(english(kind.remedy()).ends_with('.')) << kind.code;
      EXPECT_EQ(finding_kind(kind.code), &kind) << kind.code << " is hidden by a pattern before it";
    }
  std::printf("%zu codes in %zu checks\n", codes.size(), data_checks().size());
}

TEST(data_checks, streams_of_any_name_have_the_code_of_their_trouble) {
  for (const char* code : {"ins-reversed-stamps", "wheels-duplicate-stamps", "scans-impossible-stamps", "bad-imu",
                           "ins-gaps", "cloud-left-handed", "host-clock", "angle-unit", "nominal-far", "map-less-sharp",
                           "clock-moved", "point-clock", "bag-damaged"})
    EXPECT_NE(finding_kind(code), nullptr) << code;
  EXPECT_EQ(finding_kind("deskew-on"), nullptr);
  EXPECT_EQ(finding_kind(""), nullptr);
}

TEST(data_checks, inspect_and_report_tell_code_meaning_and_remedy) {
  drive::Session session = good_drive();
  session.ins.erase(session.ins.begin() + 100, session.ins.begin() + 150);
  session.findings = data_findings(session, LookAt::StreamsAndScans, Progress());
  const FindingKind& kind = *finding_kind("ins-gaps");
  Progress progress;
  const std::string inspected = overview::describe(session, overview::report_session(session, progress));
  report::Report report;
  report.file.findings = session.findings;
  const std::string page = report::report_html(report);
  for (const std::string& part : {std::string("ins-gaps"), std::string("1 gap, the longest 1.020 s"),
                                  english(kind.meaning()), english(kind.remedy())}) {
    EXPECT_TRUE(formats::contains(inspected, part)) << part << "\n" << inspected;
    EXPECT_TRUE(formats::contains(page, part)) << part << "\n" << page;
  }
}

// Whatever code a reader, a check or a stage gives its finding: where it has a meaning, nobody is left without it.
TEST(data_checks, every_code_is_explained_in_inspect_and_report) {
  for (const DataCheck& check : data_checks())
    for (const FindingKind& kind : check.kinds) {
      std::string code(kind.code);
      if (const std::size_t star = code.find('*'); star != std::string::npos) code.replace(star, 1, "of-a-stream");
      drive::Session session = good_drive();
      session.findings = {
          {drive::Severity::Warning, code, std::string("a place"), Message::verbatim("Something was found there.")}};
      Progress progress;
      const std::string inspected = overview::describe(session, overview::report_session(session, progress));
      report::Report report;
      report.file.findings = session.findings;
      const std::string page = report::report_html(report);
      for (const std::string& part :
           {std::string("Something was found there."), english(kind.meaning()), english(kind.remedy())}) {
        EXPECT_TRUE(formats::contains(inspected, part)) << code << ": " << part << "\n" << inspected;
        EXPECT_TRUE(formats::contains(page, formats::escape_html(part))) << code << ": " << part;
      }
      EXPECT_TRUE(formats::contains(inspected, "warning [" + code + "] a place")) << inspected;
      EXPECT_TRUE(formats::contains(page, code)) << code;
    }
}

// A warning leaves nobody without what it means and what to do: found by reading the sources, for what a rare drive
// raises appears in no other test.
TEST(data_checks, every_warning_has_a_meaning_or_says_itself_what_to_do) {
  const std::set<std::string> say_themselves{
      "cancelled",       "clock-offset",    "height-unobserved",   "no-ins",
      "no-lidar",        "odometry-breaks", "odometry-guessed",    "odometry-mounting-unset",
      "odometry-unused", "one-stream",      "odometry-scans-only", "trajectory-not-covered"};
  const std::regex raised(
      R"re((?:Severity::(?:Warning|Problem)(?:\s*:\s*(?:drive::)?Severity::Note)?\s*,|problem\()\s*"([a-z-]+)")re");
  std::set<std::string> codes;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::filesystem::path(REMOUNT_SOURCE_DIR) / "model")) {
    if (entry.path().extension() != ".cpp") continue;
    std::stringstream source;
    source << std::ifstream(entry.path()).rdbuf();
    const std::string text = source.str();
    for (std::sregex_iterator match(text.begin(), text.end(), raised), end; match != end; ++match) {
      const std::string code = (*match)[1];
      codes.insert(code);
      EXPECT_TRUE(finding_kind(code) != nullptr || say_themselves.contains(code))
          << entry.path() << " warns of " << code << ", and no check says what it means";
    }
  }
  std::printf("%zu codes of warnings and problems\n", codes.size());
  EXPECT_GT(codes.size(), 85U);
  for (const std::string& code : say_themselves)
    EXPECT_EQ(finding_kind(code), nullptr) << code << " is explained: take it out of the list";
}

// A check that cries wolf is worse than none: recorded data that calibrate well have no problem.
TEST(data_checks, recorded_drives_raise_no_problem) {
  SKIP_WITHOUT(formats::shared_data());
  std::size_t opened = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(formats::shared_data())) {
    if (!entry.is_directory()) continue;
    Progress progress;
    const drive::Session session = [&]() -> drive::Session {
      try {
        return formats::open_session(entry.path(), progress);
      } catch (const Error&) {
        return {};
      }
    }();
    if (session.format.empty()) continue;
    ++opened;
    for (const drive::Finding& finding : session.findings) {
      std::printf("%s: %s [%s]\n", entry.path().filename().c_str(), english(finding.explanation).c_str(),
                  finding.code.c_str());
      EXPECT_NE(finding.severity, drive::Severity::Problem) << entry.path() << ": " << english(finding.explanation);
    }
  }
  EXPECT_GT(opened, 0U);
}

}  // namespace
}  // namespace remount::checks
