#include "model/rig/swept_time.h"

#include <gtest/gtest.h>

#include "model/pipeline/scan_times.h"
#include "model/simulator/simulator.h"

namespace remount::rig {
namespace {

motion::Sweep averaged_of(const drive::Session& session, int frames) {
  const std::vector<std::shared_ptr<const drive::Session>> sessions{std::make_shared<const drive::Session>(session)};
  pipeline::PipelineOutput output;
  output.session_swept = pipeline::swept_times(sessions, settings::DeskewMode::Auto);
  output.session_frames = {frames};
  return averaged_times(pipeline::DriveMotion(sessions, output.session_swept), output).front();
}

drive::Session short_drive(bool distorted, double ins_noise_m = 0.0) {
  simulator::SimulationOptions options;
  options.duration_s = 1.5;
  options.azimuth_steps = 120;
  options.motion_distortion = distorted;
  options.ins_position_noise_m = ins_noise_m;
  options.ins_attitude_noise_deg = 0.0;
  return simulator::simulate_drive(options).session;
}

TEST(swept_time, is_that_of_a_turn_and_of_all_scans_of_a_keyframe) {
  const drive::Session session = short_drive(true);
  const motion::Sweep one = averaged_of(session, 1), three = averaged_of(session, 3);
  EXPECT_NEAR(one.length_s(), 0.1, 0.005) << one.from_s << " to " << one.until_s;
  EXPECT_NEAR(three.from_s, one.from_s - 0.1, 1e-6);
  EXPECT_NEAR(three.until_s, one.until_s + 0.1, 1e-6);
}

TEST(swept_time, is_none_where_points_are_of_one_moment) {
  const motion::Sweep at_once = averaged_of(short_drive(false), 1);
  EXPECT_EQ(at_once.from_s, 0.0);
  EXPECT_EQ(at_once.until_s, 0.0);
}

TEST(swept_time, is_no_shorter_than_noise_is_averaged) {
  const motion::Sweep averaged = averaged_of(short_drive(false, 0.005), 1);
  EXPECT_NEAR(averaged.from_s, -0.05, 1e-9);
  EXPECT_NEAR(averaged.until_s, 0.05, 1e-9);
}

}  // namespace
}  // namespace remount::rig
