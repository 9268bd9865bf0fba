#include "model/rig/swept_time.h"

#include <gtest/gtest.h>

#include "model/simulator/simulator.h"

namespace remount::rig {
namespace {

motion::Sweep sweep_of(const drive::Session& session, int frames, bool uses_sweep) {
  pipeline::PipelineInput input;
  input.sessions = {std::make_shared<const drive::Session>(session)};
  pipeline::PipelineOutput output;
  output.session_frames = {frames};
  output.session_uses_sweep = {uses_sweep};
  return swept_times(input, output).front();
}

drive::Session short_drive(bool distorted) {
  simulator::SimulationOptions options;
  options.duration_s = 1.0;
  options.azimuth_steps = 120;
  options.motion_distortion = distorted;
  return simulator::simulate_drive(options).session;
}

TEST(swept_time, is_that_of_a_turn_and_of_all_scans_of_a_keyframe) {
  const drive::Session session = short_drive(true);
  const motion::Sweep one = sweep_of(session, 1, true), three = sweep_of(session, 3, true);
  EXPECT_NEAR(one.until_s - one.from_s, 0.1, 0.005) << one.from_s << " to " << one.until_s;
  EXPECT_NEAR(three.from_s, one.from_s - 0.1, 1e-6);
  EXPECT_NEAR(three.until_s, one.until_s + 0.1, 1e-6);
}

TEST(swept_time, is_none_where_points_are_of_one_moment) {
  const motion::Sweep at_once = sweep_of(short_drive(false), 1, false);
  EXPECT_EQ(at_once.from_s, 0.0);
  EXPECT_EQ(at_once.until_s, 0.0);
}

}  // namespace
}  // namespace remount::rig
