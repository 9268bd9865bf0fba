// A handful of motion pairs, whose noise their own few residuals have to tell.
#include "tests/support/noisy_motion_pairs.h"

namespace remount {
namespace {

struct Tally {
  int solved = 0, known = 0, far = 0;
  double sum2 = 0.0, largest = 0.0;
};

// A third of the draws has a tenth of the usual noise, a third has it, and a third four times as much.
Tally tally_of(int count, int draws) {
  constexpr double kFar = 3.0;
  constexpr std::array kLouder{0.1, 1.0, 4.0};
  std::vector<CalibrationResult> results(static_cast<std::size_t>(draws));
  parallel_for(results.size(), 0, [&](std::size_t i) {
    NoisyMotionPairs drive = noisy_motion_pairs(PairMotion::Full, count, static_cast<int>(i) + 1, kLouder[i / 3 % 3]);
    Progress progress;
    results[i] = solve_motion_pairs(drive.keyframes, drive.pairs, {}, {}, progress);
  });
  Tally tally;
  for (const CalibrationResult& result : results) {
    if (!is_usable(result)) continue;
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

TEST(motion_pairs_solution, a_handful_of_pairs_errs_by_more_than_three_sigma_in_less_than_one_case_in_a_hundred) {
  constexpr int kDraws = 300;
  for (const int count : {3, 4, 5, 6, 8}) {
    const Tally tally = tally_of(count, kDraws);
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

}  // namespace
}  // namespace remount
