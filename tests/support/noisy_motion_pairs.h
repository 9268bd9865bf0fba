// Motion pairs as somebody else's programs compute them: each with noise of its own, of drives that turn in different
// ways; and what the solutions of many draws of that noise must obey.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "algorithms/core/parallel.h"
#include "algorithms/messages/render.h"
#include "model/pipeline/pipeline.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/chi_square.h"

namespace remount::testing {

enum class PairMotion { YawOnly, NearlyPlanar, StraightWithTwoTurns, Full };
inline constexpr std::array kPairMotions{PairMotion::YawOnly, PairMotion::NearlyPlanar,
                                         PairMotion::StraightWithTwoTurns, PairMotion::Full};
inline const char* name_of(PairMotion motion) {
  constexpr std::array kNames{"yaw only", "nearly planar", "straight with two turns", "full"};
  return kNames.at(static_cast<std::size_t>(motion));
}

struct NoisyMotionPairs {
  RigidTransform ins_from_lidar = rigid_from_six({1.2, -0.3, 1.6, 0.4, 0.03, -0.02});
  std::vector<motion::Keyframe> keyframes;  ///< two of its own for each pair
  std::vector<motion::Pair> pairs;
};

/// Turns and ways of one pair of a drive of `count` pairs.
inline RigidTransform pair_motion(PairMotion motion, int pair, int count, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::normal_distribution<double> normal;
  constexpr double kSharp_rad = 0.7, kTurn_rad = 0.3, kTilt_rad = 0.15, kRipple_rad = 0.005, kWay_m = 5.0;
  double yaw_rad = kSharp_rad * unit(random), pitch_rad = 0.0, roll_rad = 0.0;
  if (motion == PairMotion::StraightWithTwoTurns) {
    const int turn = std::max(2, count / 20), from_first = pair - count / 4, from_second = pair - 2 * count / 3;
    const bool first = from_first >= 0 && from_first < turn, second = from_second >= 0 && from_second < turn;
    yaw_rad = first ? kTurn_rad : second ? -kTurn_rad : 0.0;
  } else if (motion == PairMotion::NearlyPlanar) {
    pitch_rad = kRipple_rad * normal(random);
    roll_rad = kRipple_rad * normal(random);
  } else if (motion == PairMotion::Full) {
    pitch_rad = kTilt_rad * unit(random);
    roll_rad = kTilt_rad * unit(random);
  }
  const double way_m = kWay_m * (1.0 + 0.4 * unit(random));
  // The chord of the arc that turns by the yaw.
  return make_rigid(rotation_from_yaw_pitch_roll({yaw_rad, pitch_rad, roll_rad}),
                    {way_m * std::cos(0.5 * yaw_rad), way_m * std::sin(0.5 * yaw_rad), way_m * pitch_rad});
}

/// 2 cm and 0.1 degrees of noise for each pair, by turns (the seed says) in P, in Q, and shared between the two.
/// @param louder both, as a multiple
inline NoisyMotionPairs noisy_motion_pairs(PairMotion motion, int count, int seed, double louder = 1.0) {
  const double noise_m = louder * 0.02, noise_rad = louder * degrees_to_radians(0.1);
  const double in_p2 = seed % 3 == 0 ? 1.0 : seed % 3 == 1 ? 0.0 : 0.5;
  std::mt19937_64 random(static_cast<std::uint64_t>(1000 * seed + static_cast<int>(motion)));
  std::normal_distribution<double> normal;
  const auto noise = [&](double share2) {
    Vector6d step;
    for (int i = 0; i < 6; ++i) step[i] = std::sqrt(share2) * (i < 3 ? noise_m : noise_rad) * normal(random);
    return step;
  };
  NoisyMotionPairs out;
  for (int i = 0; i < count; ++i) {
    const RigidTransform p = pair_motion(motion, i, count, random);
    const RigidTransform q = out.ins_from_lidar.inverse() * p * out.ins_from_lidar;
    motion::Pair pair;
    pair.keyframe_a = index_at<motion::KeyframeIndex>(2 * i + 1);
    pair.keyframe_b = index_at<motion::KeyframeIndex>(2 * i);
    pair.ins_b_from_ins_a = perturb(p, noise(in_p2));
    pair.lidar_b_from_lidar_a = perturb(q, noise(1.0 - in_p2));
    out.pairs.push_back(pair);
    for (const int scan : {2 * i, 2 * i + 1})
      out.keyframes.push_back({motion::SessionIndex{0}, index_at<motion::ScanIndex>(scan), scan, 0.0});
  }
  return out;
}

/// Every draw is solved, names what it does not observe, and errs as its sigmas say.
inline void expect_solved_whatever_the_noise(PairMotion motion, int count, int seeds) {
  std::vector<calibration::CalibrationResult> results(static_cast<std::size_t>(seeds));
  RigidTransform truth;
  parallel_for(results.size(), 0, [&](std::size_t i) {
    NoisyMotionPairs drive = noisy_motion_pairs(motion, count, static_cast<int>(i) + 1);
    if (i == 0) truth = drive.ins_from_lidar;
    Progress progress;
    results[i] = pipeline::solve_motion_pairs(drive.keyframes, drive.pairs, {}, {}, progress);
  });
  std::array<double, 6> sum{}, largest{};
  std::array<int, 6> observed{};
  for (std::size_t i = 0; i < results.size(); ++i) {
    const calibration::CalibrationResult& result = results[i];
    EXPECT_TRUE(calibration::is_usable(result)) << name_of(motion) << ", " << count << " pairs, seed " << i + 1 << ": "
                                                << to_string(result.status) << ", " << english(result.message);
    const std::array<double, 6> errors = normalised_errors(result, truth);
    for (std::size_t k = 0; k < 6; ++k) {
      if (!result.known[calibration::kParameters[k]].observed) {
        EXPECT_NE(english(result.message).find(to_string(calibration::kParameters[k])), std::string::npos)
            << to_string(calibration::kParameters[k]) << " is not named: " << english(result.message);
        continue;
      }
      sum[k] += errors[k] * errors[k];
      largest[k] = std::max(largest[k], std::abs(errors[k]));
      ++observed[k];
    }
  }
  for (std::size_t k = 0; k < 6; ++k) {
    const double lower = chi_square_quantile(observed[k], -kOnePercentOutside),
                 upper = chi_square_quantile(observed[k], kOnePercentOutside);
    std::printf(
        "  %-24s %4d pairs, %-5s: observed %3d of %d, chi-square %6.1f (%5.1f to %5.1f), largest %.2f sigma%s\n",
        name_of(motion), count, to_string(calibration::kParameters[k]).data(), observed[k], seeds, sum[k], lower, upper,
        largest[k], sum[k] < lower || sum[k] > upper ? "  <--" : "");
    EXPECT_GE(sum[k], lower) << to_string(calibration::kParameters[k]) << ": sigma is too large";
    EXPECT_LE(sum[k], upper) << to_string(calibration::kParameters[k]) << ": sigma is too small";
  }
}

}  // namespace remount::testing
