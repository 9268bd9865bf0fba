#include "algorithms/calibration/mounting.h"

#include <gtest/gtest.h>

#include <string>

#include "algorithms/core/error.h"

namespace remount::calibration {
namespace {

const RigidTransform kFar = rigid_from_six({1.0, -0.5, 2.0, 0.3, -0.1, 0.2});

template <class Mix>
std::string refusal_of(Mix&& mix) {
  try {
    mix();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::Contract);
    return error.what();
  }
  return {};
}

TEST(mounting, every_frame_comes_back_from_its_name) {
  for (const BodyFrame frame : kFrames) EXPECT_EQ(frame_from_string(to_string(frame)), frame) << to_string(frame);
  for (const char* none : {"", "INS", "world", "lidar "}) EXPECT_FALSE(frame_from_string(none)) << none;
}

TEST(mounting, is_given_in_the_frames_that_it_has) {
  const Mounting mounting{BodyFrame::Vehicle, BodyFrame::Antenna, kFar};
  EXPECT_EQ(mounting.between(BodyFrame::Vehicle, BodyFrame::Antenna).matrix(), kFar.matrix());
  EXPECT_EQ((Mounting{BodyFrame::Ins, BodyFrame::Lidar, kFar}).ins_from_lidar().matrix(), kFar.matrix());
}

TEST(mounting, is_refused_in_other_frames_with_the_reason) {
  const Mounting mounting{BodyFrame::Vehicle, BodyFrame::Antenna, kFar};
  const std::string refusal = refusal_of([&] { return mounting.ins_from_lidar(); });
  for (const char* said : {"the antenna in the vehicle's frame", "the LiDAR in the INS frame"})
    EXPECT_NE(refusal.find(said), std::string::npos) << refusal;
  for (const BodyFrame reference : kFrames)
    for (const BodyFrame sensor : kFrames)
      EXPECT_EQ(refusal_of([&] { return mounting.between(reference, sensor); }).empty(),
                reference == mounting.reference && sensor == mounting.sensor)
          << to_string(reference) << " from " << to_string(sensor);
}

TEST(mounting, products_cancel_or_are_refused) {
  const Mounting vehicle_from_ins{BodyFrame::Vehicle, BodyFrame::Ins, kFar},
      ins_from_lidar{BodyFrame::Ins, BodyFrame::Lidar, kFar};
  const Mounting vehicle_from_lidar = vehicle_from_ins * ins_from_lidar;
  EXPECT_LT(difference(vehicle_from_lidar.between(BodyFrame::Vehicle, BodyFrame::Lidar), kFar * kFar).norm(), 1e-12);
  EXPECT_NE(refusal_of([&] { return ins_from_lidar * vehicle_from_ins; }), "");
  const Mounting back = vehicle_from_lidar.inverse() * vehicle_from_ins * ins_from_lidar;
  EXPECT_LT(difference(back.between(BodyFrame::Lidar, BodyFrame::Lidar), RigidTransform::Identity()).norm(), 1e-12);
}

TEST(mounting, differences_are_of_the_same_frames) {
  const Mounting of_ins{BodyFrame::Ins, BodyFrame::Lidar, kFar}, of_vehicle{BodyFrame::Vehicle, BodyFrame::Lidar, kFar};
  EXPECT_TRUE(mounting_difference(of_ins, of_ins).isZero(1e-12));
  EXPECT_NE(refusal_of([&] { return mounting_difference(of_ins, of_vehicle); }), "");
}

}  // namespace
}  // namespace remount::calibration
