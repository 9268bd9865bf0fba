// A handful of motion pairs, whose noise their own few residuals have to tell.
#pragma once

#include "tests/support/noisy_motion_pairs.h"

namespace remount::testing {

struct Tally {
  int solved = 0, known = 0, far = 0;
  double sum2 = 0.0, largest = 0.0;
};

enum class Linked { Apart, InARing, AllWithAll };

// Poses of an INS whose errors, 2 cm and 0.1 degrees, are in every pair of their keyframe; those of the LiDAR are
// small.
inline NoisyMotionPairs linked_pairs(Linked linked, int keyframes, int seed, double louder) {
  const double noise_m = louder * 0.02, noise_rad = louder * degrees_to_radians(0.1);
  constexpr double kOfLidar = 0.05;
  std::mt19937_64 random(static_cast<std::uint64_t>(7919 * seed + keyframes));
  std::normal_distribution<double> normal;
  const auto noise = [&](double share) {
    Vector6d step;
    for (int i = 0; i < 6; ++i) step[i] = share * (i < 3 ? noise_m : noise_rad) * normal(random);
    return step;
  };
  NoisyMotionPairs out;
  std::vector<RigidTransform> truth{RigidTransform::Identity()}, measured;
  for (int k = 1; k < keyframes; ++k)
    truth.push_back(truth.back() * pair_motion(PairMotion::Full, k, keyframes, random));
  for (int k = 0; k < keyframes; ++k) {
    measured.push_back(perturb(truth[static_cast<std::size_t>(k)], noise(1.0)));
    out.keyframes.push_back({motion::SessionIndex{0}, index_at<motion::ScanIndex>(k), k, 0.0});
  }
  for (int b = 1; b < keyframes; ++b)
    for (int a = 0; a < b; ++a) {
      const bool in_ring = a + 1 == b || (a == 0 && b + 1 == keyframes);
      if (linked == Linked::InARing && !in_ring) continue;
      const auto from = static_cast<std::size_t>(a), to = static_cast<std::size_t>(b);
      motion::Pair pair;
      pair.keyframe_a = index_at<motion::KeyframeIndex>(a);
      pair.keyframe_b = index_at<motion::KeyframeIndex>(b);
      pair.ins_b_from_ins_a = measured[to].inverse() * measured[from];
      pair.lidar_b_from_lidar_a = perturb(
          out.ins_from_lidar.inverse() * truth[to].inverse() * truth[from] * out.ins_from_lidar, noise(kOfLidar));
      out.pairs.push_back(pair);
    }
  return out;
}

// A third of the draws has a tenth of the usual noise, a third has it, and a third four times as much.
/// @param count of pairs, or of keyframes where they are linked
inline Tally tally_of(Linked linked, int count, int draws, int first_seed) {
  constexpr double kFar = 3.0;
  constexpr std::array kLouder{0.1, 1.0, 4.0};
  std::vector<calibration::CalibrationResult> results(static_cast<std::size_t>(draws));
  parallel_for(results.size(), 0, [&](std::size_t i) {
    const int seed = static_cast<int>(i) + first_seed;
    const double louder = kLouder[i / 3 % 3];
    NoisyMotionPairs drive = linked == Linked::Apart ? noisy_motion_pairs(PairMotion::Full, count, seed, louder)
                                                     : linked_pairs(linked, count, seed, louder);
    Progress progress;
    results[i] = pipeline::solve_motion_pairs(drive.keyframes, drive.pairs, {}, {}, progress);
  });
  Tally tally;
  for (const calibration::CalibrationResult& result : results) {
    if (!calibration::is_usable(result)) continue;
    ++tally.solved;
    for (const double error : normalised_errors(result, NoisyMotionPairs{}.ins_from_lidar)) {
      if (!std::isfinite(error)) continue;
      ++tally.known;
      tally.far += std::abs(error) > kFar ? 1 : 0;
      tally.sum2 += error * error;
      tally.largest = std::max(tally.largest, std::abs(error));
    }
  }
  return tally;
}

/// A handful of pairs errs by more than three sigma in less than one case in a hundred.
inline void expect_honest_handful(int draws) {
  for (const int count : {3, 4, 5, 6, 8}) {
    const Tally tally = tally_of(Linked::Apart, count, draws, 1);
    std::printf(
        "  %d pairs: %d of %d solved, %d parameters known, %d (%.2f %%) beyond 3 sigma, mean square %.2f, largest %.1f "
        "sigma\n",
        count, tally.solved, draws, tally.known, tally.far, 100.0 * tally.far / tally.known, tally.sum2 / tally.known,
        tally.largest);
    EXPECT_LT(tally.far, 0.01 * tally.known) << count << " pairs";
    EXPECT_GT(tally.sum2, 0.1 * tally.known) << count << " pairs: sigma is far too large";
    EXPECT_GT(tally.solved, draws / 2) << count << " pairs";
  }
}

/// Pairs that share keyframes do so as rarely.
inline void expect_honest_links(int draws) {
  constexpr int kFirstSeed = 5001;
  for (const Linked linked : {Linked::InARing, Linked::AllWithAll})
    for (const int keyframes : {4, 5, 6}) {
      const Tally tally = tally_of(linked, keyframes, draws, kFirstSeed);
      std::printf(
          "  %d keyframes %s: %d of %d solved, %d parameters known, %d (%.2f %%) beyond 3 sigma, mean square "
          "%.2f, largest %.1f sigma\n",
          keyframes, linked == Linked::InARing ? "in a ring" : "all with all", tally.solved, draws, tally.known,
          tally.far, 100.0 * tally.far / tally.known, tally.sum2 / tally.known, tally.largest);
      EXPECT_LT(tally.far, 0.01 * tally.known);
      EXPECT_GT(tally.solved, draws / 2);
    }
}

}  // namespace remount::testing
