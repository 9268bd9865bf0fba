#include "model/mounting_frames.h"

#include <gtest/gtest.h>

namespace remount {
namespace {

TEST(mounting_frames, a_nominal_starts_only_what_finds_the_sensor_in_its_frame) {
  const MountingFrames ins, vehicle{"vehicle", "lidar"}, machine{"machine", "lidar"}, typed{"vehicle", ""};
  for (const MethodChoice method : {MethodChoice::Pairwise, MethodChoice::Trajectory, MethodChoice::FusionOdometry}) {
    EXPECT_EQ(frame_problem(ins, method, {}), "");
    EXPECT_NE(frame_problem(vehicle, method, {}), "");
    EXPECT_NE(frame_problem(machine, method, {}), "");
    EXPECT_TRUE(starts_from_ins(method));
  }
  EXPECT_EQ(frame_problem(vehicle, MethodChoice::VehicleFrame, {}), "");
  EXPECT_EQ(frame_problem(typed, MethodChoice::VehicleFrame, {}), "");
  EXPECT_EQ(frame_problem(machine, MethodChoice::Slew, {}), "");
  EXPECT_NE(frame_problem(vehicle, MethodChoice::Slew, {}), "");
  const std::string problem = frame_problem(ins, MethodChoice::VehicleFrame, {});
  EXPECT_NE(problem.find("the INS frame"), std::string::npos) << problem;
  EXPECT_NE(problem.find("rear axle"), std::string::npos) << problem;
  EXPECT_FALSE(starts_from_ins(MethodChoice::VehicleFrame) || starts_from_ins(MethodChoice::Slew));
}

TEST(mounting_frames, the_place_of_an_antenna_is_none_of_a_lidar) {
  EXPECT_EQ(not_in_ins_frame({"ins", "lidar"}), "");
  for (const MountingFrames& frames : {MountingFrames{"vehicle", "antenna"}, MountingFrames{"antenna", "lidar"},
                                       MountingFrames{"machine", "lidar"}, MountingFrames{"vehicle", "lidar"}})
    EXPECT_NE(not_in_ins_frame(frames), "") << frames.reference;
  EXPECT_NE(frame_problem({"vehicle", "antenna"}, MethodChoice::VehicleFrame, {}), "");
}

}  // namespace
}  // namespace remount
