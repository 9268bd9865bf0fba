// X of one session against the pairs of another: agreement, a lidar that was moved in between, what nobody observes.
#include "model/pipeline/hold_out.h"

#include <gtest/gtest.h>

#include <random>

#include "algorithms/messages/render.h"
#include "model/results/result_file.h"
#include "tests/support/no_scans.h"

namespace remount::pipeline {
namespace {

constexpr int kKeyframes = 40, kPartners = 3;
constexpr double kStep_s = 0.4;
const SixParameters kHeldOutTruth{1.2, -0.3, 1.6, 0.03, -0.02, 0.015};
constexpr calibration::Parameter kHeldOutZ = calibration::Parameter::Z, kYaw = calibration::Parameter::Yaw;

struct HeldOutDrive {
  RigidTransform ins_from_lidar = rigid_from_six(kHeldOutTruth);
  bool flat = false;
  double noise = 1.0;  // of INS and registration, as a multiple of what the pairs declare
};

RigidTransform true_pose(const HeldOutDrive& drive, double time_s) {
  const double hills = drive.flat ? 0.0 : 1.0;
  return rigid_from_six({5.0 * time_s, 12.0 * std::sin(0.15 * time_s), hills * 0.3 * std::sin(0.4 * time_s),
                         0.9 * std::sin(0.15 * time_s), hills * 0.05 * std::sin(0.9 * time_s),
                         hills * 0.06 * std::sin(0.7 * time_s)});
}

RigidTransform disturbed(const RigidTransform& pose, double sigma_m, double sigma_rad, std::mt19937& random) {
  std::normal_distribution<double> noise;
  return pose * rigid_from_six({sigma_m * noise(random), sigma_m * noise(random), sigma_m * noise(random),
                                sigma_rad * noise(random), sigma_rad * noise(random), sigma_rad * noise(random)});
}

struct World {
  PipelineInput input;
  PipelineOutput output;
  std::mt19937 random{11};

  explicit World(const std::vector<HeldOutDrive>& drives) {
    input.nominal_ins_from_lidar = rigid_from_six({1.0, 0, 1.5, 0, 0, 0});
    output.nominal_known = output.initial_known = true;
    output.initial_ins_from_lidar = *input.nominal_ins_from_lidar;
    for (const HeldOutDrive& drive : drives) add(drive);
    Progress progress;
    solve_again(input, output, progress);
  }

  void add(const HeldOutDrive& drive) {
    auto session = std::make_shared<drive::Session>();
    const motion::SessionIndex number(input.sessions.size());
    const int first = static_cast<int>(output.keyframes.size());
    session->name = "drive" + std::to_string(number + 1);
    for (double time_s = 0.0; time_s < kStep_s * kKeyframes + 2.0; time_s += 0.02)
      session->world_from_ins.push_back(
          {static_cast<std::int64_t>(1e9 * time_s),
           disturbed(true_pose(drive, time_s), drive.noise * 0.005, drive.noise * 1e-4, random)});
    session->scans = std::make_shared<testing::NoScans>(kKeyframes, kStep_s);
    input.sessions.push_back(session);
    for (int k = 0; k < kKeyframes; ++k)
      output.keyframes.push_back(
          {number, index_at<motion::ScanIndex>(k), session->scans->stamp_ns(static_cast<std::size_t>(k)), 2.0 * k});
    for (int a = 0; a < kKeyframes; ++a)
      for (int b = a + 1; b <= std::min(a + kPartners, kKeyframes - 1); ++b) add_pair(drive, first, a, b);
  }

  void add_pair(const HeldOutDrive& drive, int first, int a, int b) {
    const auto pose = [&](int k) { return true_pose(drive, 1.0 + kStep_s * k); };
    const RigidTransform p = pose(b).inverse() * pose(a);
    motion::Pair pair;
    pair.keyframe_a = index_at<motion::KeyframeIndex>(first + a);
    pair.keyframe_b = index_at<motion::KeyframeIndex>(first + b);
    pair.gap_s = kStep_s * (b - a);
    pair.ins_b_from_ins_a = disturbed(p, drive.noise * 0.007, drive.noise * 1.4e-4, random);
    pair.lidar_b_from_lidar_a = disturbed(drive.ins_from_lidar.inverse() * p * drive.ins_from_lidar,
                                          drive.noise * 0.004, drive.noise * 2e-4, random);
    pair.registration.attempted = pair.registration.converged = true;
    pair.registration.information.diagonal() << Eigen::Vector3d::Constant(1.0 / (0.004 * 0.004)),
        Eigen::Vector3d::Constant(1.0 / (2e-4 * 2e-4));
    output.pairs.push_back(pair);
  }

  HoldOut check() const {
    Progress progress;
    return check_hold_out(input, output, progress);
  }
};

TEST(hold_out, sessions_without_errors_agree_exactly) {
  HeldOutDrive exact;
  exact.noise = 0.0;
  const World world({exact, exact});
  const HoldOut found = world.check();
  ASSERT_EQ(found.sessions.size(), 2U);
  ASSERT_EQ(found.scores.size(), 2U);
  ASSERT_EQ(found.differences.size(), 1U);
  for (const HeldOutScore& score : found.scores) {
    EXPECT_LT(score.residual.rotation_rad, 1e-6);
    EXPECT_LT(score.residual.translation_m, 1e-5);
  }
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(found.differences[0].difference[calibration::kParameters[i]], 0.0, 1e-5)
        << to_string(calibration::kParameters[i]);
  EXPECT_LT(calibration::largest_difference(found.differences[0])->sigmas, 0.1);
}

TEST(hold_out, noise_alone_makes_no_disagreement) {
  const World world({HeldOutDrive{}, HeldOutDrive{}});
  const HoldOut found = world.check();
  ASSERT_EQ(found.differences.size(), 1U);
  const auto largest = calibration::largest_difference(found.differences[0]);
  ASSERT_TRUE(largest);
  std::printf("two drives differ by %.2f sigma in %s; held out %.1f mm, own %.1f mm, common %.1f mm\n", largest->sigmas,
              to_string(largest->parameter).data(), 1e3 * found.scores[0].residual.translation_m,
              1e3 * found.sessions[1].own.translation_m, 1e3 * found.sessions[1].common.translation_m);
  EXPECT_LT(largest->sigmas, calibration::kDiffer_sigma);
  for (const HeldOutScore& score : found.scores) {
    const SessionAlone& scored = found.sessions[score.scored_on];
    EXPECT_LT(score.residual.translation_m, 1.5 * scored.own.translation_m);
    EXPECT_LE(scored.own.translation_m, 1.05 * scored.common.translation_m) << "nothing fits better than its own";
    EXPECT_GT(scored.pairs, 80);
  }
}

TEST(hold_out, a_lidar_that_was_turned_between_the_sessions_is_seen) {
  HeldOutDrive turned;
  turned.ins_from_lidar =
      rigid_from_six({kHeldOutTruth.x_m, kHeldOutTruth.y_m, kHeldOutTruth.z_m, kHeldOutTruth.yaw_rad + 0.01,
                      kHeldOutTruth.pitch_rad, kHeldOutTruth.roll_rad});
  const World world({HeldOutDrive{}, turned});
  const HoldOut found = world.check();
  ASSERT_EQ(found.differences.size(), 1U);
  const auto largest = calibration::largest_difference(found.differences[0]);
  ASSERT_TRUE(largest);
  EXPECT_EQ(largest->parameter, kYaw);
  EXPECT_GT(largest->sigmas, calibration::kDiffer_sigma);
  EXPECT_NEAR(found.differences[0].difference[kYaw], -0.01, 0.002);
  for (const HeldOutScore& score : found.scores)
    EXPECT_GT(score.residual.translation_m, 1.5 * found.sessions[score.scored_on].own.translation_m);
}

TEST(hold_out, nothing_is_claimed_of_what_a_flat_session_does_not_observe) {
  HeldOutDrive flat;
  flat.flat = true;
  const World world({HeldOutDrive{}, flat});
  const HoldOut found = world.check();
  ASSERT_EQ(found.sessions.size(), 2U);
  EXPECT_TRUE(found.sessions[0].result.known[kHeldOutZ].observed);
  EXPECT_FALSE(found.sessions[1].result.known[kHeldOutZ].observed);
  EXPECT_TRUE(std::isnan(found.differences[0].difference[kHeldOutZ]));
  EXPECT_TRUE(std::isnan(found.differences[0].sigma[kHeldOutZ]));
  EXPECT_TRUE(std::isfinite(found.differences[0].difference[kYaw]));
  // The hills are scored with their own height, not with the nominal one of the flat drive.
  const HeldOutScore& on_hills = found.scores[1];
  ASSERT_EQ(on_hills.solved_on, motion::SessionIndex{1});
  EXPECT_TRUE(on_hills.lent.contains(kHeldOutZ));
  EXPECT_LT(on_hills.residual.translation_m, 1.3 * found.sessions[0].own.translation_m);
}

TEST(hold_out, what_was_measured_by_hand_is_no_agreement) {
  HeldOutDrive flat;
  flat.flat = true;
  World world({flat, flat});
  world.input.settings.measured.z_m = kHeldOutTruth.z_m;
  world.input.settings.measured.z_sigma_m = 0.01;
  const HoldOut found = world.check();
  ASSERT_EQ(found.differences.size(), 1U);
  EXPECT_TRUE(std::isnan(found.differences[0].difference[kHeldOutZ]));
}

TEST(hold_out, a_session_without_pairs_has_no_numbers_and_says_why) {
  World world({HeldOutDrive{}, HeldOutDrive{}});
  for (motion::Pair& pair : world.output.pairs)
    if (pair.keyframe_a >= kKeyframes) {
      pair.state = motion::PairState::Rejected;
      pair.decided_by = motion::DecidedBy::User;
    }
  const HoldOut found = world.check();
  ASSERT_EQ(found.sessions.size(), 2U);
  EXPECT_FALSE(calibration::is_usable(found.sessions[1].result));
  EXPECT_FALSE(english(found.sessions[1].result.message).empty());
  EXPECT_EQ(found.sessions[1].pairs, 0);
  for (const HeldOutScore& score : found.scores) EXPECT_TRUE(std::isnan(score.residual.translation_m));
  EXPECT_FALSE(calibration::largest_difference(found.differences[0]));
}

TEST(hold_out, needs_two_sessions_and_can_be_cancelled) {
  EXPECT_TRUE(World(std::vector<HeldOutDrive>(1)).check().sessions.empty());
  const World world({HeldOutDrive{}, HeldOutDrive{}});
  std::stop_source stop;
  stop.request_stop();
  Progress progress(stop.get_token());
  EXPECT_TRUE(check_hold_out(world.input, world.output, progress).sessions.empty());
}

}  // namespace
}  // namespace remount::pipeline
