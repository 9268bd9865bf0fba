#include "model/ins_findings.h"

#include <gtest/gtest.h>

#include <cmath>

namespace remount {
namespace {

/// Ten seconds at 50 Hz, northwards at 5 m/s, turning by `turn_deg` and tilting by `tilt_deg` on the way.
Session drive(double turn_deg, double tilt_deg) {
  Session session;
  session.name = "drive";
  for (int i = 0; i < 500; ++i) {
    InsSample sample;
    const double share = i / 499.0;
    sample.stamp_ns = std::int64_t{1'600'000'000'000'000'000} + i * std::int64_t{20'000'000};
    sample.latitude_rad = 0.85 + 0.1 * i / 6.37e6;
    sample.longitude_rad = 0.15;
    sample.enu_from_ins = Eigen::Quaterniond(rotation_from_yaw_pitch_roll(
        {degrees_to_radians(turn_deg) * share, degrees_to_radians(tilt_deg) * std::sin(6.0 * share), 0.0}));
    sample.quality = InsQuality::Good;
    session.ins.push_back(sample);
  }
  for (int i = 0; i < 90; ++i)
    session.odometry_from_lidar.push_back({session.ins[static_cast<std::size_t>(5 * i + 2)].stamp_ns, {}});
  return session;
}

bool has(const std::vector<Finding>& findings, const std::string& code) {
  for (const Finding& finding : findings)
    if (finding.code == code) return true;
  return false;
}

TEST(ins_findings, nothing_is_wrong_with_a_good_drive) { EXPECT_TRUE(ins_findings(drive(90, 3)).empty()); }

TEST(ins_findings, too_little_motion_is_named) {
  EXPECT_TRUE(has(ins_findings(drive(2, 0)), "little-turning"));
  EXPECT_FALSE(has(ins_findings(drive(90, 0)), "little-turning"));
  EXPECT_TRUE(has(ins_findings(drive(90, 0.1)), "flat-driving"));
}

TEST(ins_findings, gaps_frozen_solutions_jumps_and_status) {
  Session gap = drive(90, 3);
  gap.ins.erase(gap.ins.begin() + 100, gap.ins.begin() + 150);
  EXPECT_TRUE(has(ins_findings(gap), "ins-gaps"));
  Session frozen = drive(90, 3);
  for (std::size_t i = 200; i < 300; ++i) {
    const std::int64_t stamp_ns = frozen.ins[i].stamp_ns;
    frozen.ins[i] = frozen.ins[200];
    frozen.ins[i].stamp_ns = stamp_ns;
  }
  EXPECT_TRUE(has(ins_findings(frozen), "ins-frozen"));
  Session jump = drive(90, 3);
  for (std::size_t i = 250; i < 500; ++i) jump.ins[i].latitude_rad += 1e-4;
  EXPECT_TRUE(has(ins_findings(jump), "ins-jump"));
  Session status = drive(90, 3);
  status.ins[7].quality = InsQuality::Invalid;
  EXPECT_TRUE(has(ins_findings(status), "ins-status"));
  EXPECT_TRUE(ins_findings(Session{}).empty());
}

}  // namespace
}  // namespace remount
