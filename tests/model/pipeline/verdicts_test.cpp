#include "model/pipeline/verdicts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/messages/render.h"
#include "model/simulator/simulator.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/kept_scans.h"
#include "tests/support/registered_drive.h"

namespace remount::pipeline {
namespace {

PairVerdict verdict_on(const PipelineOutput& output, std::size_t index, motion::PairState state,
                       const std::string& reason) {
  const motion::Pair& pair = output.pairs.at(index);
  const auto keyframe = [&](motion::KeyframeIndex k) { return output.keyframes.at(k); };
  return {keyframe(pair.keyframe_a).session, keyframe(pair.keyframe_a).stamp_ns, keyframe(pair.keyframe_b).stamp_ns,
          state, Message::verbatim(reason)};
}

TEST(verdicts, find_their_pairs_by_the_stamps) {
  PipelineOutput output = testing::registered(testing::drive(), 6);
  const PairVerdict lorry = verdict_on(output, 2, motion::PairState::Rejected, "a lorry");
  PairVerdict of_another = lorry;
  of_another.session = motion::SessionIndex{1};
  EXPECT_EQ(apply_verdicts({lorry, of_another}, output), 1);
  for (std::size_t i = 0; i < output.pairs.size(); ++i) {
    const motion::Pair& pair = output.pairs[i];
    EXPECT_EQ(pair.decided_by, i == 2 ? motion::DecidedBy::User : motion::DecidedBy::Nobody) << i;
    EXPECT_EQ(pair.state, i == 2 ? motion::PairState::Rejected : motion::PairState::Proposed) << i;
    EXPECT_EQ(english(pair.reason), i == 2 ? "a lorry" : "") << i;
  }
}

TEST(verdicts, never_accept_what_cannot_be_used) {
  PipelineOutput output = testing::registered(testing::drive(), 6);
  output.pairs[1].registration.failure = Message::verbatim("overlap 0.10 is below 0.30");
  output.pairs[1].state = motion::PairState::Rejected;
  EXPECT_EQ(apply_verdicts({verdict_on(output, 1, motion::PairState::Accepted, "looks fine")}, output), 0);
  EXPECT_EQ(output.pairs[1].state, motion::PairState::Rejected);
}

TEST(verdicts, are_withdrawn_to_what_the_program_can_say) {
  PipelineOutput output = testing::registered(testing::drive(), 6);
  output.pairs[1].registration.failure = Message::verbatim("overlap 0.10 is below 0.30");
  apply_verdicts({verdict_on(output, 0, motion::PairState::Rejected, "a"),
                  verdict_on(output, 1, motion::PairState::Rejected, "b")},
                 output);
  withdraw_verdicts(output);
  EXPECT_EQ(output.pairs[0].state, motion::PairState::Proposed);
  EXPECT_EQ(output.pairs[0].decided_by, motion::DecidedBy::Nobody);
  EXPECT_EQ(english(output.pairs[0].reason), "");
  EXPECT_EQ(output.pairs[1].state, motion::PairState::Rejected);
  EXPECT_EQ(output.pairs[1].decided_by, motion::DecidedBy::Program);
  EXPECT_EQ(english(output.pairs[1].reason), "overlap 0.10 is below 0.30");
}

// A whole calibration obeys them before it solves: its last step, the joint alignment, is of the pairs that are left.
TEST(verdicts, are_obeyed_by_a_whole_calibration_with_its_last_step) {
  simulator::SimulationOptions options;
  options.beams = 16;
  options.azimuth_steps = 450;
  options.duration_s = 10.0;
  const simulator::SimulatedDrive drive = testing::simulate_drive(options);
  PipelineInput input;
  input.sessions.push_back(std::make_shared<drive::Session>(drive.session));
  input.nominal_ins_from_lidar = rigid_from_six({0.9, 0.1, 0.9, 0.02, 0.02, -0.02});  // a second pass is needed
  Progress progress;
  const PipelineOutput without = run_pipeline(input, progress);
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < without.pairs.size() && chosen.size() < 5; i += 3)
    if (without.pairs[i].state == motion::PairState::Accepted) chosen.push_back(i);
  ASSERT_EQ(chosen.size(), 5U);
  for (const std::size_t i : chosen)
    input.verdicts.push_back(verdict_on(without, i, motion::PairState::Rejected, "a lorry"));
  const PipelineOutput with = run_pipeline(input, progress);
  for (std::size_t i = 0; i < with.pairs.size(); ++i) {
    const bool is_chosen = std::find(chosen.begin(), chosen.end(), i) != chosen.end();
    EXPECT_EQ(with.pairs[i].decided_by == motion::DecidedBy::User, is_chosen) << i;
    EXPECT_TRUE(!is_chosen || with.pairs[i].state == motion::PairState::Rejected) << i;
  }
  EXPECT_EQ(with.result.pairs_accepted,
            std::count_if(with.pairs.begin(), with.pairs.end(),
                          [](const motion::Pair& pair) { return pair.state == motion::PairState::Accepted; }));
  const auto& candidates = with.result.candidates;
  EXPECT_TRUE(std::any_of(candidates.begin(), candidates.end(), [](const calibration::Candidate& candidate) {
    return candidate.source == calibration::MountingSource::JointClouds;
  })) << "the last step was left out";
  EXPECT_NE(
      difference(without.result.mounting.reference_from_sensor, with.result.mounting.reference_from_sensor).norm(),
      0.0);
  testing::expect_within_sigma(with.result, drive.ins_from_lidar, 4.0);
}

}  // namespace
}  // namespace remount::pipeline
