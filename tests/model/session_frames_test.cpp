#include "model/session_frames.h"

#include <gtest/gtest.h>

namespace remount {
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

}  // namespace
}  // namespace remount
