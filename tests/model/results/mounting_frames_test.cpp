#include "model/results/mounting_frames.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "messages/drives.h"

namespace remount::results {

using calibration::BodyFrame;

namespace {

TEST(mounting_frames, a_nominal_starts_only_what_finds_the_sensor_in_its_frame) {
  const calibration::MountingFrames ins, vehicle{BodyFrame::Vehicle, BodyFrame::Lidar},
      machine{BodyFrame::Machine, BodyFrame::Lidar}, typed{BodyFrame::Vehicle, std::nullopt};
  for (const char* id : {"pairwise", "trajectory", "fusion-odometry"}) {
    const method_registry::CalibrationMethod& method = method_registry::calibration_method(id);
    EXPECT_TRUE(frame_problem(ins, method, {}).empty());
    EXPECT_FALSE(frame_problem(vehicle, method, {}).empty());
    EXPECT_FALSE(frame_problem(machine, method, {}).empty());
    EXPECT_TRUE(starts_from_ins(method));
  }
  EXPECT_TRUE(frame_problem(vehicle, method_registry::calibration_method("vehicle-frame"), {}).empty());
  EXPECT_TRUE(frame_problem(typed, method_registry::calibration_method("vehicle-frame"), {}).empty());
  EXPECT_TRUE(frame_problem(machine, method_registry::calibration_method("slew"), {}).empty());
  EXPECT_FALSE(frame_problem(vehicle, method_registry::calibration_method("slew"), {}).empty());
  const std::string problem = english(frame_problem(ins, method_registry::calibration_method("vehicle-frame"), {}));
  EXPECT_NE(problem.find("the INS frame"), std::string::npos) << problem;
  EXPECT_NE(problem.find("rear axle"), std::string::npos) << problem;
  EXPECT_FALSE(starts_from_ins(method_registry::calibration_method("vehicle-frame")) ||
               starts_from_ins(method_registry::calibration_method("slew")));
}

TEST(mounting_frames, the_place_of_an_antenna_is_none_of_a_lidar) {
  EXPECT_TRUE(not_in_ins_frame({BodyFrame::Ins, BodyFrame::Lidar}).empty());
  for (const calibration::MountingFrames& frames : {calibration::MountingFrames{BodyFrame::Vehicle, BodyFrame::Antenna},
                                                    calibration::MountingFrames{BodyFrame::Antenna, BodyFrame::Lidar},
                                                    calibration::MountingFrames{BodyFrame::Machine, BodyFrame::Lidar},
                                                    calibration::MountingFrames{BodyFrame::Vehicle, BodyFrame::Lidar}})
    EXPECT_FALSE(not_in_ins_frame(frames).empty()) << to_string(frames.reference);
  EXPECT_FALSE(
      frame_problem({BodyFrame::Vehicle, BodyFrame::Antenna}, method_registry::calibration_method("vehicle-frame"), {})
          .empty());
}

TEST(mounting_frames, a_declaration_that_is_not_used_is_called_what_it_is) {
  const Message unused = unused_declaration(method_registry::calibration_method("vehicle-frame"), {});
  EXPECT_EQ(unused, say::nominal_of_session_unused(
                        calibration::in_words(calibration::MountingFrames()), "vehicle-frame",
                        calibration::in_words(calibration::MountingFrames{BodyFrame::Vehicle, BodyFrame::Lidar})))
      << english(unused);
  EXPECT_NE(english(unused).find(english(calibration::in_words(calibration::MountingFrames()))), std::string::npos)
      << english(unused);
}

}  // namespace
}  // namespace remount::results
