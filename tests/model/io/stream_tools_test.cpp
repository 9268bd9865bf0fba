#include "model/io/stream_tools.h"

#include <gtest/gtest.h>

#include "algorithms/geometry/rotation.h"
#include "tests/model/io/temporary_folder.h"

namespace remount {
namespace {

std::vector<InsSample> drive_at(double longitude_deg, int count = 20) {
  std::vector<InsSample> ins(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    ins[static_cast<std::size_t>(i)].stamp_ns = 1'600'000'000'000'000'000 + i * 10'000'000LL;
    ins[static_cast<std::size_t>(i)].latitude_rad = degrees_to_radians(48.0 + 1e-6 * i);
    ins[static_cast<std::size_t>(i)].longitude_rad = wrap_angle_rad(degrees_to_radians(longitude_deg + 1e-4 * i));
  }
  return ins;
}

TEST(stream_tools, samples_far_from_the_drive_are_left_out_and_counted) {
  std::vector<Finding> findings;
  for (const double longitude_deg : {9.0, 179.9995}) {
    findings.clear();
    std::vector<InsSample> ins = drive_at(longitude_deg);
    keep_near(ins, "ins.csv", findings);
    EXPECT_EQ(ins.size(), 20U) << "also across the date line";
    EXPECT_TRUE(findings.empty());
    ins[0].longitude_rad = degrees_to_radians(250.857);
    ins[7].latitude_rad = 0.0;
    keep_near(ins, "ins.csv", findings);
    EXPECT_EQ(ins.size(), 18U);
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_EQ(findings[0].code, "ins-far-away");
    EXPECT_TRUE(contains(findings[0].explanation, "2 samples")) << findings[0].explanation;
  }
}

TEST(stream_tools, stamps_that_are_no_time_are_left_out_before_they_are_compared) {
  std::vector<Finding> findings;
  std::vector<InsSample> ins = drive_at(9.0);
  ins[3].stamp_ns = std::numeric_limits<std::int64_t>::max();
  ins[4].stamp_ns = std::numeric_limits<std::int64_t>::min();
  keep_ascending(ins, "ins", "ins.csv", findings);
  EXPECT_EQ(ins.size(), 18U);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].code, "ins-impossible-stamps");
  for (InsSample& sample : ins) sample.stamp_ns = std::numeric_limits<std::int64_t>::max();
  EXPECT_ERROR(keep_ascending(ins, "ins", "ins.csv", findings), "ins.csv: no entry has a possible time");
}

TEST(stream_tools, a_last_line_that_was_cut_is_left_out_and_said) {
  const std::string head = "time_ns,x_m,z_m\n", rows = "1000,2.51,250.7\n1001,2.52,250.7\n1002,2.5,250.7\n";
  const auto kept = [&](const std::string& text, std::size_t findings_expected) {
    std::vector<Finding> findings;
    const std::string left(without_cut_line(text, "ins.csv", findings));
    EXPECT_EQ(findings.size(), findings_expected) << text;
    for (const Finding& finding : findings) EXPECT_EQ(finding.code + " " + finding.where, "log-cut ins.csv:6");
    return left;
  };
  for (const std::string whole : {"1003,2.53,250.7\n", "1003,2.53,250.7", "1003,2.53,250.7\r\n", ""})
    EXPECT_EQ(kept(head + rows + whole, 0), head + rows + whole);
  for (const std::string cut : {"1003,2.53,2", "1003,2.5", "1", "1003,2.53,250"})
    EXPECT_EQ(kept(head + rows + "1002,2.53,250.9\n" + cut, 1), head + rows + "1002,2.53,250.9\n");
  EXPECT_EQ(kept("1000,2.51,250.7\n1", 0), "1000,2.51,250.7\n1") << "one line does not show how long lines are";
  EXPECT_EQ(kept("no line end", 0), "no line end");
}

TEST(stream_tools, one_bad_item_is_spoken_of_in_the_singular) {
  std::vector<Finding> findings;
  BadItems bad;
  bad.add(std::string("a.bin: is missing"));
  bad.report(findings, "missing-scans", "data", "scans");
  EXPECT_EQ(findings.back().explanation, "1 scan cannot be used and is left out. First: a.bin: is missing");
  bad.add(std::string("b.bin: is missing"));
  bad.report(findings, "missing-scans", "data", "scans");
  EXPECT_EQ(findings.back().explanation, "2 scans cannot be used and are left out. First: a.bin: is missing");
}

}  // namespace
}  // namespace remount
