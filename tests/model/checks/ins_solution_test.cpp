#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "model/checks/builtin.h"
#include "tests/model/checks/check_fixture.h"

namespace remount::checks {
namespace {

TEST(ins_solution_check, nothing_is_wrong_with_a_good_drive) {
  EXPECT_TRUE(data_findings(good_drive(), LookAt::StreamsAndScans, Progress()).empty())
      << english(data_findings(good_drive(), LookAt::Streams, Progress())[0].explanation);
  EXPECT_TRUE(data_findings(drive::Session{}, LookAt::StreamsAndScans, Progress()).empty());
}

TEST(ins_solution_check, gaps_frozen_solutions_and_status) {
  drive::Session gap = good_drive();
  gap.ins.erase(gap.ins.begin() + 100, gap.ins.begin() + 150);
  EXPECT_EQ(testing::said_of(found_by(ins_solution_check(), gap), "ins-gaps"),
            "1 gap, the longest 1.020 s; nothing is interpolated across them.");
  drive::Session frozen = good_drive();
  for (std::size_t i = 200; i < 300; ++i) {
    const std::int64_t stamp_ns = frozen.ins[i].stamp_ns;
    frozen.ins[i] = frozen.ins[200];
    frozen.ins[i].stamp_ns = stamp_ns;
  }
  EXPECT_TRUE(testing::has_code(found_by(ins_solution_check(), frozen), "ins-frozen"));
  drive::Session status = good_drive();
  status.ins[7].quality = motion::InsQuality::Invalid;
  for (std::size_t i = 100; i < 151; ++i) status.ins[i].quality = motion::InsQuality::Degraded;
  const std::vector<drive::Finding> findings = found_by(ins_solution_check(), status);
  EXPECT_EQ(
      testing::said_of(findings, "ins-status"),
      "51 of 500 samples are degraded and 1 invalid by the INS's own status, in 2 stretches, the longest of 1.0 s.");
  EXPECT_EQ(findings.at(0).severity, drive::Severity::Warning);
}

TEST(drive_variety_check, too_little_motion_is_named) {
  EXPECT_TRUE(testing::has_code(found_by(drive_variety_check(), good_drive(2, 0)), "little-turning"));
  EXPECT_FALSE(testing::has_code(found_by(drive_variety_check(), good_drive(90, 0)), "little-turning"));
  EXPECT_TRUE(testing::has_code(found_by(drive_variety_check(), good_drive(90, 0.1)), "flat-driving"));
}

}  // namespace
}  // namespace remount::checks
