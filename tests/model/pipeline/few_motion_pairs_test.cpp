// A handful of motion pairs, whose noise their own few residuals have to tell.
#include "tests/support/noisy_motion_pairs.h"

namespace remount::pipeline {
namespace {

struct Tally {
  int solved = 0, known = 0, far = 0;
  double sum2 = 0.0, largest = 0.0;
};

enum class Linked { Apart, InARing, AllWithAll };

// Poses of an INS whose errors, 2 cm and 0.1 degrees, are in every pair of their keyframe; those of the LiDAR are
// small.
testing::NoisyMotionPairs linked_pairs(Linked linked, int keyframes, int seed, double louder) {
  const double noise_m = louder * 0.02, noise_rad = louder * degrees_to_radians(0.1);
  constexpr double kOfLidar = 0.05;
  std::mt19937_64 random(static_cast<std::uint64_t>(7919 * seed + keyframes));
  std::normal_distribution<double> normal;
  const auto noise = [&](double share) {
    Vector6d step;
    for (int i = 0; i < 6; ++i) step[i] = share * (i < 3 ? noise_m : noise_rad) * normal(random);
    return step;
  };
  testing::NoisyMotionPairs out;
  std::vector<RigidTransform> truth{RigidTransform::Identity()}, measured;
  for (int k = 1; k < keyframes; ++k)
    truth.push_back(truth.back() * testing::pair_motion(testing::PairMotion::Full, k, keyframes, random));
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
Tally tally_of(Linked linked, int count, int draws, int first_seed) {
  constexpr double kFar = 3.0;
  constexpr std::array kLouder{0.1, 1.0, 4.0};
  std::vector<calibration::CalibrationResult> results(static_cast<std::size_t>(draws));
  parallel_for(results.size(), 0, [&](std::size_t i) {
    const int seed = static_cast<int>(i) + first_seed;
    const double louder = kLouder[i / 3 % 3];
    testing::NoisyMotionPairs drive = linked == Linked::Apart
                                          ? testing::noisy_motion_pairs(testing::PairMotion::Full, count, seed, louder)
                                          : linked_pairs(linked, count, seed, louder);
    Progress progress;
    results[i] = solve_motion_pairs(drive.keyframes, drive.pairs, {}, {}, progress);
  });
  Tally tally;
  for (const calibration::CalibrationResult& result : results) {
    if (!calibration::is_usable(result)) continue;
    ++tally.solved;
    for (const double error : testing::normalised_errors(result, testing::NoisyMotionPairs{}.ins_from_lidar)) {
      if (!std::isfinite(error)) continue;
      ++tally.known;
      tally.far += std::abs(error) > kFar ? 1 : 0;
      tally.sum2 += error * error;
      tally.largest = std::max(tally.largest, std::abs(error));
    }
  }
  return tally;
}

TEST(motion_pairs_solution, a_handful_of_pairs_errs_by_more_than_three_sigma_in_less_than_one_case_in_a_hundred) {
  constexpr int kDraws = 300;
  for (const int count : {3, 4, 5, 6, 8}) {
    const Tally tally = tally_of(Linked::Apart, count, kDraws, 1);
    std::printf(
        "  %d pairs: %d of %d solved, %d parameters known, %d (%.2f %%) beyond 3 sigma, mean square %.2f, largest %.1f "
        "sigma\n",
        count, tally.solved, kDraws, tally.known, tally.far, 100.0 * tally.far / tally.known, tally.sum2 / tally.known,
        tally.largest);
    EXPECT_LT(tally.far, 0.01 * tally.known) << count << " pairs";
    EXPECT_GT(tally.sum2, 0.1 * tally.known) << count << " pairs: sigma is far too large";
    EXPECT_GT(tally.solved, kDraws / 2) << count << " pairs";
  }
}

TEST(motion_pairs_solution, pairs_that_share_keyframes_err_by_more_than_three_sigma_as_rarely) {
  constexpr int kDraws = 300, kFirstSeed = 5001;
  for (const Linked linked : {Linked::InARing, Linked::AllWithAll})
    for (const int keyframes : {4, 5, 6}) {
      const Tally tally = tally_of(linked, keyframes, kDraws, kFirstSeed);
      std::printf(
          "  %d keyframes %s: %d of %d solved, %d parameters known, %d (%.2f %%) beyond 3 sigma, mean square "
          "%.2f, largest %.1f sigma\n",
          keyframes, linked == Linked::InARing ? "in a ring" : "all with all", tally.solved, kDraws, tally.known,
          tally.far, 100.0 * tally.far / tally.known, tally.sum2 / tally.known, tally.largest);
      EXPECT_LT(tally.far, 0.01 * tally.known);
      EXPECT_GT(tally.solved, kDraws / 2);
    }
}

}  // namespace
}  // namespace remount::pipeline
