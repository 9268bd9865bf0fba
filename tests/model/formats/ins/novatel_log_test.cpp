// NovAtel's ASCII logs as terminals and loggers write them, and what is taken of several.
#include "model/formats/ins/novatel_log.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>

#include "algorithms/messages/render.h"
#include "model/drive/attitude_convention.h"
#include "tests/model/formats/ins/novatel_records.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/sanitized.h"

namespace remount::formats {
namespace {

using namespace novatel;

class novatel_log : public ::testing::Test {
 protected:
  std::vector<motion::InsSample> read(const std::string& text) {
    findings_.clear();
    const auto path = folder_.write("a.log", text);
    EXPECT_EQ(recognise_novatel(path), NovatelFormat::Log);
    return read_novatel(path, NovatelFormat::Log, findings_).ins;
  }
  TemporaryFolder folder_;
  std::vector<drive::Finding> findings_;
};

TEST_F(novatel_log, lines_are_found_behind_prompts_and_times) {
  for (const std::string& before :
       {std::string("[COM1]"), std::string("[USB1]"), std::string("<OK\r\n[COM1]"), std::string("12:34:56.789 > "),
        std::string("2023-01-01 12:00:00.123 "), std::string("#SOMETHINGA,COM1,0;cut [COM1]")}) {
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

TEST_F(novatel_log, inspva_says_what_inspvax_says_but_for_its_errors) {
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

TEST_F(novatel_log, the_faster_of_the_two_serves_with_the_errors_of_the_other) {
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

TEST_F(novatel_log, with_other_ends_of_lines_is_one_line_and_costs_no_more) {
  constexpr std::size_t kLogs = testing::kSanitized ? 2'000 : 20'000;  // what it costs is for the release tests
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
  while (cut.size() < 75 * kLogs) cut += cut;
  std::size_t after_marks = 0;
  const double marks_s = seconds_of([&] { after_marks = read(inspvaxa(2183, 100.0, 90.0) + cut).size(); });
  EXPECT_EQ(after_marks, 1U);
  const auto none = folder_.write("none", cut);
  const double none_s = seconds_of([&] { EXPECT_FALSE(recognise_novatel(none)); });
  std::printf("%.1f MB in one line: %.3f s; of marks alone %.3f s, not recognised in %.3f s\n",
              1e-6 * static_cast<double>(text.size()), taken_s, marks_s, none_s);
  // Looked through again from every mark, they would take minutes; a busy machine takes seconds.
  constexpr double kLongest_s = 10.0;
  EXPECT_LT(taken_s, kLongest_s * testing::kSanitizerSlowdown);
  EXPECT_LT(marks_s, kLongest_s * testing::kSanitizerSlowdown);
  EXPECT_LT(none_s, kLongest_s * testing::kSanitizerSlowdown);
}

TEST_F(novatel_log, a_text_that_mentions_a_log_is_none) {
  EXPECT_FALSE(recognise_novatel(folder_.write("README", "Lines begin with #INSPVAXA, and end with a checksum.\n")));
}

TEST_F(novatel_log, a_status_from_the_table_of_positions_is_read_as_it_was_meant) {
  std::string text;
  for (int i = 0; i < 10; ++i) text += inspvaxa(2183, 100.0 + 0.1 * i, 90.0, "SINGULARITY");
  for (const motion::InsSample& sample : read(text)) EXPECT_EQ(sample.quality, motion::InsQuality::Good);
  ASSERT_EQ(findings_.size(), 1U);
  EXPECT_EQ(findings_[0].code, "ins-status-misnamed");
  EXPECT_TRUE(contains(english(findings_[0].explanation), "10 statuses of the INS"))
      << english(findings_[0].explanation);
  EXPECT_TRUE(contains(english(findings_[0].explanation), "novatel_gps_driver")) << english(findings_[0].explanation);
  EXPECT_EQ(novatel_quality("NO_CONVERGENCE"), motion::InsQuality::Degraded) << "INS_HIGH_VARIANCE";
  EXPECT_EQ(novatel_quality("INSUFFICIENT_OBS"), motion::InsQuality::Invalid) << "INS_ALIGNING";
  EXPECT_EQ(novatel_quality("INS_ALIGNING"), motion::InsQuality::Invalid);
}

// The examples of the OEM7 Commands and Logs Reference Manual.
TEST_F(novatel_log, the_manuals_examples_have_right_checksums) {
  const std::string text =
      "%INSPVASA,2209,490712.000;2209,490712.000000000,51.15043713712,-114.03067872932,1080.3580,0.0014,-0.0007,0.0015,"
      "-0.293782412,0.302470613,157.989827209,INS_SOLUTION_GOOD*a87ab88b\r\n"
      "#IMURATEPVAA,USB1,0,62.5,FINESTEERING,2209,489768.026,02000020,81ba,16809;2209,489768.026275000,51.15043706787,"
      "-114.03067862997,1080.3569,-0.0021,0.0003,-0.0009,-0.314843800,0.320501757,158.167631576,INS_SOLUTION_GOOD"
      "*d377f22f\r\n"
      "#INSSTDEVA,USB1,0,66.0,FINESTEERING,2209,491004.000,02000020,2396,16809;0.1813,0.1813,0.1806,0.0018,0.0018,"
      "0.0017,0.0292,0.0291,0.0577,13000045,0,0,7fd1bf,0*b490ddee\r\n"
      "%RAWIMUSXA,2209,491674.014;04,41,2209,491674.013699,ea59fe00,329308016,-2706935,4508389,196192,417138,-1000837"
      "*038422a7\r\n"
      "#BESTGNSSPOSA,USB1,0,65.0,FINESTEERING,2209,487877.000,02000020,c292,16809;SOL_COMPUTED,PPP,51.15043712234,"
      "-114.03067870773,1097.3556,-17.0001,WGS84,0.0176,0.0123,0.0317,\"TSTR\",17.000,0.000,42,38,38,37,00,00,3f,37"
      "*5fea7d4b\r\n";
  NovatelScanner scanner(text);
  std::string names;
  for (NovatelFrame frame; scanner.next(frame);) {
    EXPECT_TRUE(frame.problem.empty()) << frame.name;
    names += std::string(frame.name) + " ";
  }
  EXPECT_EQ(names, "INSPVAS IMURATEPVA INSSTDEV RAWIMUSX BESTGNSSPOS ");
}

TEST_F(novatel_log, insstdev_gives_its_errors_to_samples_of_two_seconds_about_it) {
  for (const char* name : {"INSSTDEVA", "INSSTDEVSA"}) {
    std::string text;
    for (int i = 0; i < 100; ++i) text += inspva("INSPVASA", 100.0 + 0.1 * i, 90.0);
    const std::vector<motion::InsSample> ins = read(text + insstdev(name, 102.0));
    ASSERT_EQ(ins.size(), 100U) << name;
    for (std::size_t i = 0; i < ins.size(); ++i)
      EXPECT_EQ(std::isnan(ins[i].sigma.position_enu_m.x()), i > 40) << name << ": " << i;
    EXPECT_EQ(ins[0].sigma.position_enu_m, Eigen::Vector3d(0.9, 0.8, 1.2)) << "east, north, up";
    const Eigen::Vector3d attitude_deg = ins[0].sigma.attitude_rad * 180.0 / kPi;
    EXPECT_LT((attitude_deg - Eigen::Vector3d(0.6, 0.5, 0.7)).norm(), 1e-12) << "pitch about x, roll about y";
    EXPECT_EQ(testing::said_of(findings_, "ins-log-chosen"),
              "The INS is taken from INSPVAS (100 samples). Its errors are those of " +
                  std::string(name == std::string("INSSTDEVA") ? "INSSTDEV" : "INSSTDEVS") +
                  ", the nearest in time and not more than 2 s away. 59 samples have none.");
  }
}

TEST_F(novatel_log, of_several_solutions_the_one_with_most_samples_is_taken) {
  std::string text;
  for (int i = 0; i < 40; ++i) {
    text += inspva("INSPVASA", 100.0 + 0.1 * i, 90.0);
    if (i % 2 == 0) text += inspvaxa(kWeek, 100.0 + 0.1 * i, 90.0);
    if (i % 4 == 0) text += inspva("INSPVAA", 100.0 + 0.1 * i, 90.0) + bestpos("BESTPOSA", 100.0 + 0.1 * i);
  }
  EXPECT_EQ(read(text).size(), 40U);
  EXPECT_EQ(testing::said_of(findings_, "ins-log-chosen"),
            "The INS is taken from INSPVAS (40 samples). Its errors are those of INSPVAX, the nearest in time and not "
            "more than 2 s away. Not used: BESTPOS (10), INSPVA (10).");
  EXPECT_EQ(findings_.size(), 1U);
}

TEST_F(novatel_log, of_inspva_alone_no_errors_are_declared) {
  std::string text;
  for (int i = 0; i < 10; ++i) text += inspva("INSPVAA", 100.0 + 0.1 * i, 90.0);
  EXPECT_TRUE(read(text).front().sigma.attitude_rad.array().isNaN().all());
  EXPECT_TRUE(contains(testing::said_of(findings_, "ins-log-chosen"), "none are declared"));
}

TEST_F(novatel_log, positions_of_a_receiver_stand_in_where_there_is_no_ins) {
  std::string text;
  for (int i = 0; i < 10; ++i)
    text +=
        bestpos("BESTPOSA", 100.0 + i, i < 3 ? "INSUFFICIENT_OBS" : "SOL_COMPUTED") + bestpos("BESTPOSA_1", 100.0 + i);
  const auto path = folder_.write("a.log", text);
  ASSERT_EQ(recognise_novatel(path), NovatelFormat::Log);
  const NovatelLog log = read_novatel(path, NovatelFormat::Log, findings_);
  EXPECT_TRUE(log.ins.empty());
  ASSERT_EQ(log.fixes.size(), 7U);
  EXPECT_NEAR(log.fixes[0].height_m, 1063.6093 - 16.9, 1e-9) << "above the ellipsoid";
  EXPECT_LT((log.fixes[0].covariance_enu_m2.diagonal() - Eigen::Vector3d(0.81, 0.64, 1.44)).norm(), 1e-12);
  EXPECT_TRUE(contains(testing::said_of(findings_, "no-fix"), "3 logs were written without a position"));
  EXPECT_EQ(testing::said_of(findings_, "ins-log-chosen"),
            "The log has no solution of an INS: its positions are the 7 fixes of BESTPOS. Not used: BESTPOS_1 (10).")
      << "the second antenna is elsewhere";
  EXPECT_EQ(read_novatel_fixes(path, findings_).size(), 7U);
}

TEST_F(novatel_log, fixes_that_are_asked_for_are_those_of_the_receiver_alone) {
  std::string text;
  for (int i = 0; i < 10; ++i) text += inspva("INSPVAA", 100.0 + 0.1 * i, 90.0);
  EXPECT_THROW(read_novatel_fixes(folder_.write("ins.log", text), findings_), Error) << "no position of the receiver";
  for (int i = 0; i < 6; ++i) text += bestpos("BESTPOSA", 100.0 + 0.2 * i);
  for (int i = 0; i < 3; ++i) text += bestpos("BESTGNSSPOSA", 100.0 + 0.4 * i);
  const auto path = folder_.write("both.log", text);
  EXPECT_EQ(read_novatel_fixes(path, findings_).size(), 3U) << "BESTPOS may be the INS itself";
  EXPECT_EQ(testing::said_of(findings_, "ins-log-chosen"),
            "Of this log the positions are taken, the 3 fixes of BESTGNSSPOS. Not used: INSPVA (10), BESTPOS (6).");
}

TEST_F(novatel_log, what_was_written_before_the_ins_had_a_solution_is_counted) {
  std::string text;
  for (int i = 0; i < 5; ++i)
    text += with_crc('#', ascii_header("INSPVAA", 90.0 + i) + std::to_string(kWeek) +
                              ",90.000000000,-90.00000000000,0.00000000000,-6356752.3142,0,0,0,0,0,0,INS_ALIGNING");
  for (int i = 0; i < 10; ++i) text += inspva("INSPVAA", 100.0 + 0.1 * i, 90.0);
  EXPECT_EQ(read(text).size(), 10U);
  EXPECT_TRUE(
      contains(testing::said_of(findings_, "ins-log-chosen"), "5 logs of it were written while the INS had no"));
  EXPECT_EQ(testing::said_of(findings_, "bad-ins"), "");
}

}  // namespace
}  // namespace remount::formats
