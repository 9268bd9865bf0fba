#include "model/pipeline/chosen_pairs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>

#include "algorithms/messages/render.h"
#include "model/results/deciding_notes.h"
#include "model/simulator/simulator.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/kept_scans.h"

namespace remount::pipeline {
namespace {

simulator::SimulatedDrive minute_and_more(int seed) {
  simulator::SimulationOptions options;
  options.duration_s = 70.0;
  options.beams = 16;
  options.azimuth_steps = 150;
  options.seed = seed;
  return testing::simulate_drive(options);
}

PipelineInput input_of(const simulator::SimulatedDrive& drive, motion::PairChoice choice) {
  PipelineInput input;
  input.sessions.push_back(std::make_shared<drive::Session>(drive.session));
  input.settings.pairing.choice = choice;
  input.settings.run.map_check = false;
  input.settings.solve.joint_clouds = false;
  return input;
}

TEST(chosen_pairs, of_a_long_drive_are_a_part_and_give_nearly_the_sigma_of_all) {
  const simulator::SimulatedDrive drive = minute_and_more(31);
  PipelineInput input = input_of(drive, motion::PairChoice::Auto);
  std::vector<std::string> told;
  input.tell_so_far = [&](const Message& x) { told.push_back(english(x)); };
  Progress progress;
  const PipelineOutput chosen = run_pipeline(input, progress),
                       all = run_pipeline(input_of(drive, motion::PairChoice::All), progress);
  ASSERT_EQ(chosen.result.status, calibration::Status::Ok) << english(chosen.result.message);
  std::printf("  %zu of %zu pairs\n", chosen.pairs.size(), all.pairs.size());
  EXPECT_LT(chosen.pairs.size(), 3 * all.pairs.size() / 4);
  for (const calibration::Parameter parameter : calibration::kParameters) {
    const double ratio = *chosen.result.estimate(parameter).sigma / *all.result.estimate(parameter).sigma;
    std::printf("  %s: sigma %.3f times that of all\n", std::string(to_string(parameter)).c_str(), ratio);
    EXPECT_LE(ratio, 1.15) << to_string(parameter);
  }
  for (const double error : testing::normalised_errors(chosen.result, drive.ins_from_lidar))
    EXPECT_LE(std::abs(error), 3.5) << "sigma";
  const auto note = [](const PipelineOutput& output) {
    return std::ranges::find_if(output.findings,
                                [](const drive::Finding& finding) { return finding.code == results::kPairsChosen; });
  };
  ASSERT_NE(note(chosen), chosen.findings.end());
  EXPECT_NE(english(note(chosen)->explanation)
                .find(std::to_string(chosen.pairs.size()) + " of " + std::to_string(all.pairs.size())),
            std::string::npos)
      << english(note(chosen)->explanation);
  EXPECT_EQ(note(all), all.findings.end());
  ASSERT_FALSE(told.empty()) << "what is known before the end";
  EXPECT_NE(told.front().find("± "), std::string::npos) << told.front();
}

TEST(told_by_trend, goes_on_as_the_last_two_solutions_did) {
  // Half of the variance averages out, half does not.
  const auto solved_by = [](std::size_t pairs) {
    return SolvedByPairs{pairs, Vector6d::Constant(1e-6 + 1e-3 / static_cast<double>(pairs))};
  };
  const SolvedByPairs before = solved_by(500), now = solved_by(1000);
  EXPECT_NEAR(told_by_trend(before, now, 1000, 1000).wider, 1.0, 1e-12);
  EXPECT_NEAR(told_by_trend(before, now, 1000, 10000).wider, std::sqrt(2e-6 / 1.1e-6), 1e-9);
  EXPECT_NEAR(told_by_trend(before, now, 2000, 10000).wider, std::sqrt(1.5e-6 / 1.1e-6), 1e-9);
  SolvedByPairs of_one = now;
  of_one.variances.tail<5>().setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(told_by_trend(before, of_one, 1000, 10000).parameter, calibration::Parameter::X);
  EXPECT_EQ(told_by_trend(now, now, 1000, 10000).wider, 1.0) << "a sigma that does not fall is not waited for";
}

TEST(chosen_pairs, hold_those_that_the_user_decided_and_are_the_same_each_time) {
  const simulator::SimulatedDrive drive = minute_and_more(32);
  PipelineInput input = input_of(drive, motion::PairChoice::Auto);
  Progress progress;
  const PipelineOutput before = run_pipeline(input, progress);
  const PipelineInput with_all = input_of(drive, motion::PairChoice::All);
  const PipelineOutput all = run_pipeline(with_all, progress);
  const auto stamps_of = [](const PipelineOutput& output) {
    std::vector<std::pair<std::int64_t, std::int64_t>> stamps;
    for (const motion::Pair& pair : output.pairs)
      stamps.emplace_back(output.keyframes[pair.keyframe_a].stamp_ns, output.keyframes[pair.keyframe_b].stamp_ns);
    return stamps;
  };
  const auto taken = stamps_of(before);
  for (const auto& [a_ns, b_ns] : stamps_of(all))
    if (input.verdicts.size() < 3 && std::ranges::find(taken, std::pair{a_ns, b_ns}) == taken.end())
      input.verdicts.push_back(
          {motion::SessionIndex{0}, a_ns, b_ns, motion::PairState::Rejected, Message::verbatim("looked at")});
  ASSERT_EQ(input.verdicts.size(), 3U);
  input.threads = 1;
  const PipelineOutput after = run_pipeline(input, progress);
  for (const PairVerdict& verdict : input.verdicts) {
    const auto stamps = stamps_of(after);
    const auto place = std::ranges::find(stamps, std::pair{verdict.stamp_a_ns, verdict.stamp_b_ns});
    ASSERT_NE(place, stamps.end());
    const motion::Pair& pair = after.pairs[static_cast<std::size_t>(place - stamps.begin())];
    EXPECT_EQ(pair.state, motion::PairState::Rejected);
    EXPECT_EQ(pair.decided_by, motion::DecidedBy::User);
  }
  input.verdicts.clear();
  const PipelineOutput again = run_pipeline(input, progress);
  EXPECT_EQ(stamps_of(again), taken) << "on one thread as on all";
  EXPECT_TRUE(again.result.mounting.ins_from_lidar().matrix() == before.result.mounting.ins_from_lidar().matrix());
}

}  // namespace
}  // namespace remount::pipeline
