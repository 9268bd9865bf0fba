// LiDARs whose scans take time, and overlap.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "tests/algorithms/calibration/rig/rig_drives.h"
#include "tests/support/draws.h"

namespace remount::calibration {
namespace {

int drawn_drives() { return testing::some_of_many(40, 20); }

/// Drives whose INS errs by white noise alone, and the same solved as if every scan was measured at once.
struct SweptTally {
  Tally single, relative, taken_for_independent;
  double wider = 0.0;  ///< z, than if taken for independent

  static SweptTally of(const std::vector<double>& sweeps_s, const std::vector<double>& phases_s, bool any_cross) {
    SweptTally tally;
    const int kDrives = drawn_drives();
    for (int seed = 101; seed <= 100 + kDrives; ++seed) {
      testing::RigOptions options = small_rig();
      options.drive.noise.ins_position_drift = options.drive.noise.ins_attitude_drift = 0.0;
      options.drive.attitude_bias_sigma_rad = 0.0;
      options.drive.noise.ins_position_sigma_m *= 4.0;
      options.drive.noise.ins_attitude_sigma_rad *= 4.0;
      options.any_cross = any_cross;
      options.sweeps_s = sweeps_s;
      options.phases_s = phases_s;
      testing::SimulatedRig rig = testing::simulate_rig(options, seed);
      std::vector<CrossPair> cross_pairs = rig.cross_pairs;
      const RigSolution solution = solve_rig(rig.lidars, rig.cross_pairs, {});
      for (RigLidar& lidar : rig.lidars) lidar.sweeps.clear(), lidar.at_once_s = 0.0;
      const RigSolution at_once = solve_rig(rig.lidars, cross_pairs, {});
      EXPECT_TRUE(solution.solved && at_once.solved) << seed;
      tally.add(options, solution, at_once);
    }
    tally.wider /= tally.single.count;
    std::cout << "taken for independent: "
              << (tally.taken_for_independent.sum / tally.taken_for_independent.count).transpose() << "; z is "
              << tally.wider << " times as wide\n";
    return tally;
  }
  void add(const testing::RigOptions& options, const RigSolution& solution, const RigSolution& at_once) {
    for (std::size_t l = 0; l < 3; ++l) {
      const Eigen::Index at = signed_of(6 * l);
      const Vector6d variance = solution.covariance.diagonal().segment<6>(at),
                     independent = at_once.covariance.diagonal().segment<6>(at);
      single.add(difference(options.ins_from_lidars[l], solution.ins_from_lidars[l]), variance);
      taken_for_independent.add(difference(options.ins_from_lidars[l], at_once.ins_from_lidars[l]), independent);
      wider += std::sqrt(variance[2] / independent[2]);
    }
    for (const RelativeMounting& two : solution.relatives)
      relative.add(
          difference(relative_mounting(options.ins_from_lidars[two.lidar_a], options.ins_from_lidars[two.lidar_b]),
                     two.lidar_a_from_lidar_b),
          two.covariance.diagonal());
  }
};

// Scans that take time to be measured have the mean of the INS's errors over that, and LiDARs whose scans overlap have
// part of it in common: together they tell less of what they share than as many that look at other times.
TEST(rig_sweeps, sweeps_that_overlap_have_errors_of_the_ins_in_common) {
  const SweptTally tally = SweptTally::of({0.4, 0.4, 0.4}, {0.0, 0.04, 0.08}, true);
  tally.single.expect_within_one_percent("mountings", drawn_drives());
  tally.relative.expect_within_one_percent("relative mountings", drawn_drives());
  const int count = tally.taken_for_independent.count;
  EXPECT_GT((tally.taken_for_independent.sum / count).maxCoeff(),
            testing::chi_square_quantile(count, testing::kOnePercentOutside) / count);
  EXPECT_GT(tally.wider, 1.1);
}

// Two are triggered together and have all of it in common, the third looks later and for longer.
TEST(rig_sweeps, sweeps_of_several_lengths_and_at_once_do_so_too) {
  ONLY_IN_LONG_TESTS();
  const SweptTally tally = SweptTally::of({0.3, 0.3, 0.45}, {0.0, 0.0, 0.2}, true);
  tally.single.expect_within_one_percent("mountings", drawn_drives());
  tally.relative.expect_within_one_percent("relative mountings", drawn_drives());
}

// Each is calibrated by its own scans, which do not overlap: it is as certain as if the others were not there. What
// they have in common cancels between them, what each one's registrations may do beyond that does not.
TEST(rig_sweeps, sweeps_that_overlap_widen_no_lidar_without_pairs_across) {
  ONLY_IN_LONG_TESTS();
  const SweptTally tally = SweptTally::of({0.4, 0.4, 0.4}, {0.0, 0.04, 0.08}, false);
  EXPECT_NEAR(tally.wider, 1.0, 1e-3);
  tally.single.expect_within_one_percent("mountings", drawn_drives());
  const Vector6d relative = tally.relative.sum / tally.relative.count;
  EXPECT_LT(relative.maxCoeff(),
            testing::chi_square_quantile(drawn_drives(), testing::kOnePercentOutside) / drawn_drives())
      << relative.transpose();
}

}  // namespace
}  // namespace remount::calibration
