#include "model/drive/session_frames.h"

#include <gtest/gtest.h>

#include "algorithms/geodesy/local_level.h"
#include "model/conventions/metric_poses.h"

namespace remount::drive {
namespace {

std::shared_ptr<const Session> with_axes(std::optional<InsAxes> axes) {
  Session session;
  session.ins_axes = axes;
  return std::make_shared<const Session>(session);
}

TEST(session_frames, axes_are_common_where_all_sessions_declare_the_same) {
  const auto left = with_axes(InsAxes::ForwardLeftUp), right = with_axes(InsAxes::RightForwardUp),
             unknown = with_axes({});
  EXPECT_EQ(common_axes({left, left}), InsAxes::ForwardLeftUp);
  EXPECT_EQ(common_axes({right}), InsAxes::RightForwardUp);
  EXPECT_FALSE(common_axes({left, right}));
  EXPECT_FALSE(common_axes({left, unknown}));
  EXPECT_FALSE(common_axes({}));
}

TEST(session_frames, what_is_ahead_lies_on_x_and_what_is_right_on_negative_y) {
  const RigidTransform turned = forward_left_up_from(InsAxes::RightForwardUp);
  EXPECT_EQ(turned * Eigen::Vector3d(0, 2, 0), Eigen::Vector3d(2, 0, 0));
  EXPECT_EQ(turned * Eigen::Vector3d(1, 0, 3), Eigen::Vector3d(0, -1, 3));
  for (const std::optional<InsAxes> same : {std::optional(InsAxes::ForwardLeftUp), std::optional<InsAxes>()})
    EXPECT_EQ(forward_left_up_from(same).matrix(), RigidTransform::Identity().matrix());
}

// A hundred kilometres apart north and level differ by a degree; a drive of that length is one rigid thing all the
// same.
TEST(session_frames, metric_poses_have_the_axes_of_the_first_sample_everywhere) {
  const double latitude_rad = degrees_to_radians(48.78), longitude_rad = degrees_to_radians(9.18);
  const geodesy::LocalLevel level(latitude_rad, longitude_rad, 250.0);
  Session session;
  for (int i = 0; i < 3; ++i) {
    motion::InsSample sample;
    sample.stamp_ns = i * 1'000'000'000LL;
    sample.latitude_rad = latitude_rad;
    sample.longitude_rad = longitude_rad + degrees_to_radians(0.6 * i);
    sample.height_m = 250.0;
    sample.enu_from_ins = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ());
    session.ins.push_back(sample);
  }
  const std::vector<motion::StampedPose> poses = metric_poses(session);
  ASSERT_EQ(poses.size(), 3u);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const double turned_rad = degrees_to_radians(0.6 * static_cast<double>(i)) * std::sin(latitude_rad);
    EXPECT_NEAR(yaw_pitch_roll_from_rotation(poses[i].pose.linear()).yaw_rad, 0.3 + turned_rad, 2e-4) << i;
    EXPECT_LT(difference(poses[i].pose, level.enu_from_ins(session.ins[i])).norm(), 1e-9) << i;
  }
  EXPECT_NEAR(poses[2].pose.translation().x(), 88100.0, 200.0);
  // The same one by one.
  const conventions::MetricPoses one_by_one(session);
  ASSERT_EQ(one_by_one.size(), poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(one_by_one[i].stamp_ns, poses[i].stamp_ns);
    EXPECT_LT(difference(one_by_one[i].pose, poses[i].pose).norm(), 1e-9) << i;
  }
}

}  // namespace
}  // namespace remount::drive
