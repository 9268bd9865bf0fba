// A drive whose pairs are aligned: what a solution from pairs starts from.
#pragma once

#include <random>

#include "model/pipeline/pipeline.h"
#include "tests/support/no_scans.h"

namespace remount::testing {

inline constexpr int kMostKeyframes = 170, kPartners = 3;
inline constexpr double kStep_s = 0.4;
inline const SixParameters kTruth{1.2, -0.3, 1.6, 0.03, -0.02, 0.015};

inline RigidTransform true_pose(double time_s) {
  return rigid_from_six({5.0 * time_s, 12.0 * std::sin(0.15 * time_s), 0.3 * std::sin(0.4 * time_s),
                         0.9 * std::sin(0.15 * time_s), 0.05 * std::sin(0.9 * time_s), 0.06 * std::sin(0.7 * time_s)});
}

inline RigidTransform disturbed(const RigidTransform& pose, double sigma_m, double sigma_rad, std::mt19937& random) {
  std::normal_distribution<double> noise;
  return pose * rigid_from_six({sigma_m * noise(random), sigma_m * noise(random), sigma_m * noise(random),
                                sigma_rad * noise(random), sigma_rad * noise(random), sigma_rad * noise(random)});
}

inline pipeline::PipelineInput drive() {
  auto session = std::make_shared<drive::Session>();
  session->name = "drive";
  std::mt19937 random(3);
  const double end_s = kStep_s * kMostKeyframes + 2.0;
  for (double time_s = 0.0; time_s < end_s; time_s += 0.02)
    session->world_from_ins.push_back(
        {static_cast<std::int64_t>(1e9 * time_s), disturbed(true_pose(time_s), 0.005, 1e-4, random)});
  session->scans = std::make_shared<NoScans>(kMostKeyframes, kStep_s);
  pipeline::PipelineInput input;
  input.sessions = {session};
  input.nominal_ins_from_lidar = rigid_from_six({1.0, 0, 1.5, 0, 0, 0});
  return input;
}

/// Its pairs, aligned; some wrongly, and nothing decided yet.
inline pipeline::PipelineOutput registered(const pipeline::PipelineInput& input, int keyframes) {
  std::mt19937 random(4);
  pipeline::PipelineOutput output;
  output.nominal_known = output.initial_known = true;
  output.initial_ins_from_lidar = *input.nominal_ins_from_lidar;
  const RigidTransform x = rigid_from_six(kTruth);
  const auto time_s = [&](int k) {
    return 1e-9 * static_cast<double>(output.keyframes[static_cast<std::size_t>(k)].stamp_ns);
  };
  for (int k = 0; k < keyframes; ++k)
    output.keyframes.push_back({motion::SessionIndex{0}, index_at<motion::ScanIndex>(k),
                                input.sessions[0]->scans->stamp_ns(static_cast<std::size_t>(k)), 2.0 * k});
  for (int a = 0; a < keyframes; ++a)
    for (int b = a + 1; b <= std::min(a + kPartners, keyframes - 1); ++b) {
      motion::Pair pair;
      pair.keyframe_a = index_at<motion::KeyframeIndex>(a);
      pair.keyframe_b = index_at<motion::KeyframeIndex>(b);
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

inline void reject(pipeline::PipelineOutput& output, int first, int count) {
  for (int i = first; i < first + count; ++i) {
    motion::Pair& pair = output.pairs.at(static_cast<std::size_t>(i));
    pair.state = motion::PairState::Rejected;
    pair.decided_by = motion::DecidedBy::User;
  }
}

}  // namespace remount::testing
