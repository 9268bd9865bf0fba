// The example of a check of recorded data in CONTRIBUTING.md, as it is compiled.
#include "model/checks/data_check.h"

#include <gtest/gtest.h>

#include "algorithms/core/stamps.h"
#include "messages/examples.h"
#include "messages/places.h"

namespace remount::checks {
namespace {

void look_for_standing(const CheckedSession& checked, std::vector<drive::Finding>& findings, const Progress&) {
  constexpr double kStands_mps = 0.05, kMostOfIt = 0.5;
  double stands_s = 0.0, whole_s = 0.0;
  for (std::size_t i = 1; i < checked.poses.size(); ++i) {
    const double step_s = seconds(checked.poses[i].stamp_ns - checked.poses[i - 1].stamp_ns);
    const double way_m = (checked.poses[i].pose.translation() - checked.poses[i - 1].pose.translation()).norm();
    whole_s += step_s;
    if (way_m < kStands_mps * step_s) stands_s += step_s;
  }
  if (stands_s > kMostOfIt * whole_s)
    findings.push_back({drive::Severity::Warning, "drive-stands", say::place_ins(),
                        say::drive_stands(Duration{stands_s}, Duration{whole_s})});
}

DataCheck standing_check() {
  return {.kinds = {{"drive-stands", say::drive_stands_meaning, say::drive_stands_remedy}}, .look = look_for_standing};
}

drive::Session session_at(double mps) {
  drive::Session session;
  for (int i = 0; i < 100; ++i)
    session.world_from_ins.push_back(
        {i * 100'000'000LL, make_rigid(Eigen::Matrix3d::Identity(), {0.1 * mps * i, 0.0, 0.0})});
  return session;
}

TEST(example_of_a_check, finds_a_vehicle_that_stands_and_no_other) {
  for (const double mps : {0.0, 3.0}) {
    const drive::Session session = session_at(mps);
    std::vector<drive::Finding> findings;
    standing_check().look({session, conventions::MetricPoses(session)}, findings, Progress());
    EXPECT_EQ(findings.size(), mps > 0.0 ? 0U : 1U) << mps;
  }
}

}  // namespace
}  // namespace remount::checks
