#include "model/pipeline/chosen_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <limits>
#include <mutex>
#include <set>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "messages/stages.h"
#include "model/results/deciding_notes.h"
#include "model/simulator/simulator.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/draws.h"
#include "tests/support/forwarded_scans.h"
#include "tests/support/kept_scans.h"

namespace remount::pipeline {
namespace {

simulator::SimulatedDrive long_enough(double duration_s, int seed) {
  simulator::SimulationOptions options;
  options.duration_s = duration_s;
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
  const simulator::SimulatedDrive drive = long_enough(70.0, 31);
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

/// While `rots`, what is read rots away, and stays so.
class RottenScans final : public testing::ForwardedScans {
 public:
  using ForwardedScans::ForwardedScans;
  cloud::PointCloud load(std::size_t scan) const override {
    const std::scoped_lock lock(mutex_);
    if (rots) rotten_.insert(scan);
    if (rotten_.contains(scan)) throw Error(ErrorCode::Format, name(scan), Message::verbatim("is no point cloud"));
    return ForwardedScans::load(scan);
  }
  std::size_t rotten() const { return rotten_.size(); }

  std::atomic<bool> rots = false;

 private:
  mutable std::mutex mutex_;
  mutable std::set<std::size_t> rotten_;
};

TEST(chosen_pairs, whose_scans_cannot_be_read_are_followed_by_others) {
  const simulator::SimulatedDrive drive = long_enough(32.0, 33);
  PipelineInput input = input_of(drive, motion::PairChoice::Auto);
  const auto scans = std::make_shared<RottenScans>(drive.session.scans);
  auto session = std::make_shared<drive::Session>(drive.session);
  session->scans = scans;
  input.sessions = {session};
  input.nominal_ins_from_lidar = drive.ins_from_lidar;
  bool registered = false;
  Progress progress({}, [&](const ProgressUpdate& update) {
    registered = registered || update.stage == say::stage_registering_pairs;
    scans->rots = update.stage == say::stage_finding_objects && !registered;
  });
  const PipelineOutput output = run_pipeline(input, progress);
  const auto named = static_cast<std::size_t>(std::ranges::count_if(
      output.findings, [](const drive::Finding& finding) { return finding.code == "scan-unreadable"; }));
  std::printf("  %zu scans rotted away, %zu named; %d of %zu pairs accepted\n", scans->rotten(), named,
              output.result.pairs_accepted, output.pairs.size());
  EXPECT_GE(scans->rotten(), 50U) << "all that the first pairs are of";
  EXPECT_EQ(named, scans->rotten());
  EXPECT_EQ(output.result.status, calibration::Status::Ok) << english(output.result.message);
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
  ONLY_IN_LONG_TESTS();
  const simulator::SimulatedDrive drive = long_enough(32.0, 32);
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
