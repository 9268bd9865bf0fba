// A decision in the window waits for solve_again: it must be quick, and say what the decision changed.
#include <gtest/gtest.h>

#include <chrono>
#include <random>

#include "model/pipeline.h"

namespace remount {
namespace {

constexpr int kMostKeyframes = 170, kPartners = 3;
constexpr double kStep_s = 0.4;
const SixParameters kTruth{1.2, -0.3, 1.6, 0.03, -0.02, 0.015};

RigidTransform true_pose(double time_s) {
  return rigid_from_six({5.0 * time_s, 12.0 * std::sin(0.15 * time_s), 0.3 * std::sin(0.4 * time_s),
                         0.9 * std::sin(0.15 * time_s), 0.05 * std::sin(0.9 * time_s), 0.06 * std::sin(0.7 * time_s)});
}

RigidTransform disturbed(const RigidTransform& pose, double sigma_m, double sigma_rad, std::mt19937& random) {
  std::normal_distribution<double> noise;
  return pose * rigid_from_six({sigma_m * noise(random), sigma_m * noise(random), sigma_m * noise(random),
                                sigma_rad * noise(random), sigma_rad * noise(random), sigma_rad * noise(random)});
}

class NoScans : public ScanSource {
 public:
  std::size_t size() const override { return kMostKeyframes; }
  std::int64_t stamp_ns(std::size_t scan) const override {
    return 1'000'000'000 + static_cast<std::int64_t>(1e9 * kStep_s * static_cast<double>(scan));
  }
  std::string name(std::size_t scan) const override { return std::to_string(scan); }
  PointCloud load(std::size_t) const override {
    ADD_FAILURE() << "no scan is read";
    return {};
  }
};

PipelineInput drive() {
  auto session = std::make_shared<Session>();
  session->name = "drive";
  std::mt19937 random(3);
  const double end_s = kStep_s * kMostKeyframes + 2.0;
  for (double time_s = 0.0; time_s < end_s; time_s += 0.02)
    session->world_from_ins.push_back(
        {static_cast<std::int64_t>(1e9 * time_s), disturbed(true_pose(time_s), 0.005, 1e-4, random)});
  session->scans = std::make_shared<NoScans>();
  PipelineInput input;
  input.sessions = {session};
  input.nominal_ins_from_lidar = rigid_from_six({1.0, 0, 1.5, 0, 0, 0});
  return input;
}

PipelineOutput registered(const PipelineInput& input, int keyframes) {
  std::mt19937 random(4);
  PipelineOutput output;
  output.nominal_known = output.initial_known = true;
  output.initial_ins_from_lidar = *input.nominal_ins_from_lidar;
  const RigidTransform x = rigid_from_six(kTruth);
  const auto time_s = [&](int k) {
    return 1e-9 * static_cast<double>(output.keyframes[static_cast<std::size_t>(k)].stamp_ns);
  };
  for (int k = 0; k < keyframes; ++k)
    output.keyframes.push_back({0, k, input.sessions[0]->scans->stamp_ns(static_cast<std::size_t>(k)), 2.0 * k});
  for (int a = 0; a < keyframes; ++a)
    for (int b = a + 1; b <= std::min(a + kPartners, keyframes - 1); ++b) {
      Pair pair;
      pair.keyframe_a = a;
      pair.keyframe_b = b;
      pair.gap_s = time_s(b) - time_s(a);
      const RigidTransform p = true_pose(time_s(b)).inverse() * true_pose(time_s(a));
      pair.ins_b_from_ins_a = disturbed(p, 0.007, 1.4e-4, random);
      pair.lidar_b_from_lidar_a = disturbed(x.inverse() * p * x, 0.004, 2e-4, random);
      if (a % 20 == 7) pair.lidar_b_from_lidar_a.translation().x() += 0.8;  // an alignment that went wrong
      pair.registration.attempted = pair.registration.converged = true;
      pair.registration.information.diagonal() << Eigen::Vector3d::Constant(1.0 / (0.004 * 0.004)),
          Eigen::Vector3d::Constant(1.0 / (2e-4 * 2e-4));
      output.pairs.push_back(pair);
    }
  return output;
}

template <class Solve>
double taken_ms(const Solve& solve) {
  const auto start = std::chrono::steady_clock::now();
  solve();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void reject(PipelineOutput& output, int first, int count) {
  for (int i = first; i < first + count; ++i) {
    Pair& pair = output.pairs.at(static_cast<std::size_t>(i));
    pair.state = PairState::Rejected;
    pair.decided_by = DecidedBy::User;
  }
}

TEST(solve_again, is_answered_at_once_nearly_as_it_is_in_the_end) {
  const PipelineInput input = drive();
  PipelineOutput output = registered(input, 50);
  Progress progress;
  const double whole_ms = taken_ms([&] { solve_again(input, output, progress); });
  ASSERT_EQ(output.result.status, Status::Ok) << output.result.message;
  EXPECT_LT((output.result.ins_from_lidar.translation() - rigid_from_six(kTruth).translation()).norm(), 0.06);
  const RigidTransform before = output.result.ins_from_lidar;
  reject(output, 30, 25);
  const double at_once_ms = taken_ms([&] { EXPECT_TRUE(solve_at_once(input, output, progress)); });
  const RigidTransform quick = output.result.ins_from_lidar;
  const int accepted = output.result.pairs_accepted;
  solve_again(input, output, progress);
  const double moved = difference(before, output.result.ins_from_lidar).norm();
  const double missed = difference(quick, output.result.ins_from_lidar).norm();
  std::printf("%zu pairs: whole solution %.0f ms, first answer %.0f ms, which is %.3g off of %.3g that X moved\n",
              output.pairs.size(), whole_ms, at_once_ms, missed, moved);
  EXPECT_GT(moved, 0.0) << "good pairs less change something";
  EXPECT_LT(missed, 0.3 * moved);
  EXPECT_NEAR(accepted, output.result.pairs_accepted, 3) << "those on the edge may be judged otherwise";
}

TEST(solve_again, a_decision_about_five_hundred_pairs_is_answered_at_once) {
  const PipelineInput input = drive();
  PipelineOutput output = registered(input, kMostKeyframes);
  output.result.status = Status::Ok;
  output.result.observed.fill(true);
  output.result.ins_from_lidar = rigid_from_six(kTruth);
  output.result.noise.ins_position_drift = 0.01;  // as solutions of logs have them: twice the unknowns
  output.result.noise.ins_attitude_drift = 1e-4;
  for (std::size_t i = 0; i < output.pairs.size(); ++i) {
    Pair& pair = output.pairs[i];
    const bool wrong = (pair.keyframe_a % 20) == 7;
    pair.state = wrong ? PairState::Rejected : PairState::Accepted;
    pair.decided_by = DecidedBy::Program;
    pair.weight = wrong ? 0.0 : 1.0;
  }
  Progress progress;
  ASSERT_TRUE(solve_at_once(input, output, progress));
  const RigidTransform before = output.result.ins_from_lidar;
  std::vector<double> ms;
  for (int decision = 0; decision < 5; ++decision) {
    reject(output, 100 * decision, 1);
    ms.push_back(taken_ms([&] { EXPECT_TRUE(solve_at_once(input, output, progress)); }));
  }
  std::sort(ms.begin(), ms.end());
  std::printf("%zu pairs of %d keyframes: a decision is answered after %.0f ms (median), %.0f ms (longest)\n",
              output.pairs.size(), kMostKeyframes, ms[2], ms.back());
  EXPECT_GT(difference(before, output.result.ins_from_lidar).norm(), 0.0);
  // Wanted: 100. The bound is for machines that are busy or check memory.
  EXPECT_LT(ms[2], 1500.0);
}

TEST(solve_again, nothing_is_answered_at_once_without_a_result_or_pairs) {
  const PipelineInput input = drive();
  PipelineOutput output = registered(input, 20);
  Progress progress;
  EXPECT_FALSE(solve_at_once(input, output, progress)) << "nothing was solved yet";
  output.result.status = Status::Ok;
  output.result.observed.fill(true);
  EXPECT_FALSE(solve_at_once(input, output, progress)) << "no pair takes part";
}

}  // namespace
}  // namespace remount
