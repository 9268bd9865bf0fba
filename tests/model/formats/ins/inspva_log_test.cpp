// NovAtel's ASCII logs as terminals and loggers write them, and INSPVA among them.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>

#include "algorithms/messages/render.h"
#include "model/drive/attitude_convention.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/sanitized.h"

namespace remount::formats {
namespace {

std::string with_crc(char begin, const std::string& body) {
  char crc[16];
  std::snprintf(crc, sizeof crc, "*%08x\r\n", novatel_crc32(body));
  return begin + body + crc;
}

/// @param name "INSPVAA" or "INSPVASA", which has a short header
std::string inspva(const std::string& name, double seconds, double azimuth_deg) {
  char body[400];
  std::snprintf(body, sizeof body,
                "2183,%.9f,51.11637873403,-114.03825114994,1046.7093,0.1,0.2,0.3,1.5,-2.5,%.6f,INS_SOLUTION_GOOD",
                seconds, azimuth_deg);
  char header[120];
  std::snprintf(header, sizeof header,
                name == "INSPVASA" ? "%s,2183,%.3f;" : "%s,COM1,0,73.5,FINESTEERING,2183,%.3f,00000040,4e77,43562;",
                name.c_str(), seconds);
  return with_crc(name == "INSPVASA" ? '%' : '#', std::string(header) + body);
}

class inspva_log : public ::testing::Test {
 protected:
  std::vector<motion::InsSample> read(const std::string& text) {
    findings_.clear();
    const auto path = folder_.write("a.log", text);
    EXPECT_EQ(recognise_inspvax(path), InspvaxFormat::AsciiLog);
    return read_inspvax(path, InspvaxFormat::AsciiLog, findings_).ins;
  }
  TemporaryFolder folder_;
  std::vector<drive::Finding> findings_;
};

TEST_F(inspva_log, lines_are_found_behind_prompts_and_times) {
  for (const std::string& before :
       {std::string("[COM1]"), std::string("[USB1]"), std::string("<OK\r\n[COM1]"), std::string("12:34:56.789 > "),
        std::string("2023-01-01 12:00:00.123 "), std::string("#BESTPOSA,COM1,0;cut [COM1]")}) {
    std::string text;
    for (int i = 0; i < 10; ++i) text += before + inspvaxa(2183, 100.0 + 0.1 * i, 90.0 + i);
    EXPECT_EQ(read(text).size(), 10U) << before;
    EXPECT_TRUE(findings_.empty()) << before << english(findings_.front().explanation);
  }
  // The terminal lost the end of a line: two logs stand in one.
  std::string text;
  for (int i = 0; i < 10; ++i) {
    std::string line = inspvaxa(2183, 100.0 + 0.1 * i, 90.0);
    text += i % 2 == 0 ? line.substr(0, line.size() - 2) : line;
  }
  EXPECT_EQ(read(text).size(), 10U);
  const std::string half = inspvaxa(2183, 101.0, 90.0).substr(0, 60);
  EXPECT_EQ(read(text + half + inspvaxa(2183, 102.0, 90.0)).size(), 11U);
  ASSERT_EQ(findings_.size(), 1U) << "what was cut is counted";
  EXPECT_EQ(findings_[0].code, "bad-ins");
}

TEST_F(inspva_log, inspva_says_what_inspvax_says_but_for_its_errors) {
  const motion::InsSample with_errors = read(inspvaxa(2183, 100.5, 87.25)).front();
  for (const char* name : {"INSPVAA", "INSPVASA"}) {
    const std::vector<motion::InsSample> ins = read("<OK\r\n[COM1]" + inspva(name, 100.5, 87.25));
    ASSERT_EQ(ins.size(), 1U) << name;
    EXPECT_EQ(ins[0].stamp_ns, with_errors.stamp_ns) << name;
    EXPECT_NEAR(ins[0].height_m, with_errors.height_m, 1e-9) << "above the ellipsoid in both";
    EXPECT_LT(ins[0].enu_from_ins.angularDistance(with_errors.enu_from_ins), 1e-12);
    EXPECT_EQ(ins[0].quality, motion::InsQuality::Good);
    EXPECT_TRUE(std::isnan(ins[0].sigma.position_enu_m.x()));
  }
}

TEST_F(inspva_log, the_faster_of_the_two_serves_with_the_errors_of_the_other) {
  std::string text;
  for (int i = 0; i < 100; ++i) {
    text += inspva("INSPVAA", 100.0 + 0.02 * i, 90.0);
    if (i % 50 == 0) text += inspvaxa(2183, 100.0 + 0.02 * i, 90.0);
  }
  const std::vector<motion::InsSample> ins = read(text);
  ASSERT_EQ(ins.size(), 100U);
  for (const motion::InsSample& sample : ins) EXPECT_EQ(sample.sigma.position_enu_m, Eigen::Vector3d(0.9, 0.8, 1.2));
  std::string alike;
  for (int i = 0; i < 100; ++i)
    alike += inspva("INSPVAA", 100.0 + 0.02 * i, 90.0) + inspvaxa(2183, 100.0 + 0.02 * i, 90.0);
  EXPECT_EQ(read(alike).front().sigma.position_enu_m, Eigen::Vector3d(0.9, 0.8, 1.2));
}

double seconds_of(const std::function<void()>& what) {
  const auto start = std::chrono::steady_clock::now();
  what();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST_F(inspva_log, with_other_ends_of_lines_is_one_line_and_costs_no_more) {
  constexpr std::size_t kLogs = 20'000;
  std::string text, cut;
  for (std::size_t i = 0; i < kLogs; ++i) {
    std::string line = inspvaxa(2183, 100.0 + 0.01 * static_cast<double>(i), 90.0);
    line.pop_back();  // "\n" of "\r\n"
    text += line;
    cut += "#INSPVAXA,#%INSPVASA,##";
  }
  std::vector<motion::InsSample> ins;
  const double taken_s = seconds_of([&] { ins = read(text); });
  EXPECT_EQ(ins.size(), kLogs);
  // Marks without a log behind them, in one line as well: recognised by the last.
  while (cut.size() < 1'500'000) cut += cut;
  std::size_t after_marks = 0;
  const double marks_s = seconds_of([&] { after_marks = read(inspvaxa(2183, 100.0, 90.0) + cut).size(); });
  EXPECT_EQ(after_marks, 1U);
  const auto none = folder_.write("none", cut);
  const double none_s = seconds_of([&] { EXPECT_FALSE(recognise_inspvax(none)); });
  std::printf("%.1f MB in one line: %.3f s; of marks alone %.3f s, not recognised in %.3f s\n",
              1e-6 * static_cast<double>(text.size()), taken_s, marks_s, none_s);
  // Looked through again from every mark, they would take minutes; a busy machine takes seconds.
  constexpr double kLongest_s = 10.0;
  EXPECT_LT(taken_s, kLongest_s * testing::kSanitizerSlowdown);
  EXPECT_LT(marks_s, kLongest_s * testing::kSanitizerSlowdown);
  EXPECT_LT(none_s, kLongest_s * testing::kSanitizerSlowdown);
}

TEST_F(inspva_log, a_text_that_mentions_a_log_is_none) {
  EXPECT_FALSE(recognise_inspvax(folder_.write("README", "Lines begin with #INSPVAXA, and end with a checksum.\n")));
}

TEST_F(inspva_log, a_status_from_the_table_of_positions_is_read_as_it_was_meant) {
  std::string text;
  for (int i = 0; i < 10; ++i) text += inspvaxa(2183, 100.0 + 0.1 * i, 90.0, "SINGULARITY");
  for (const motion::InsSample& sample : read(text)) EXPECT_EQ(sample.quality, motion::InsQuality::Good);
  ASSERT_EQ(findings_.size(), 1U);
  EXPECT_EQ(findings_[0].code, "ins-status-misnamed");
  EXPECT_TRUE(contains(english(findings_[0].explanation), "10 statuses of the INS"))
      << english(findings_[0].explanation);
  EXPECT_TRUE(contains(english(findings_[0].explanation), "novatel_gps_driver")) << english(findings_[0].explanation);
  EXPECT_EQ(inspvax_quality("NO_CONVERGENCE"), motion::InsQuality::Degraded) << "INS_HIGH_VARIANCE";
  EXPECT_EQ(inspvax_quality("INSUFFICIENT_OBS"), motion::InsQuality::Invalid) << "INS_ALIGNING";
  EXPECT_EQ(inspvax_quality("INS_ALIGNING"), motion::InsQuality::Invalid);
}

}  // namespace
}  // namespace remount::formats
