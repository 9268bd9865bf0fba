#include "algorithms/calibration/pairwise/pair_judgement.h"

#include <gtest/gtest.h>

#include "algorithms/calibration/joint/pair_equation.h"
#include "algorithms/calibration/pairwise/uncertainty.h"
#include "algorithms/messages/render.h"
#include "tests/algorithms/support/simulated_drive.h"

namespace remount::calibration {
namespace {

TEST(pair_judgement, distances_marginalise_the_ins_errors_also_where_a_registration_leaves_something_open) {
  testing::DriveOptions options;
  options.noise.ins_position_drift = 0.02;
  const testing::SimulatedDrive drive = testing::simulate(options, 3);
  std::vector<motion::Pair> pairs = testing::pairs_of(drive);
  pairs.resize(20);
  std::vector<motion::PairIndex> all;
  for (motion::PairIndex i; i < pairs.size(); ++i) {
    all.push_back(i);
    pairs[i].gap_s = 0.1 * static_cast<double>(i);
    if (i % 2 == 0) continue;
    // A corridor: nothing along its length.
    pairs[i].registration.information.row(0).setZero();
    pairs[i].registration.information.col(0).setZero();
  }
  const RigidTransform x = perturb(testing::mounting(), Vector6d::Constant(0.01));
  const std::vector<double> found = distances2(noisy_pairs(pairs, all, options.noise), x);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const PairEquation equation = linearise_pair(pairs[i].ins_b_from_ins_a, pairs[i].lidar_b_from_lidar_a, x);
    const double expected =
        equation.residual.dot(residual_information(pairs[i], equation, options.noise) * equation.residual);
    EXPECT_GT(expected, 1.0);
    EXPECT_NEAR(found[i], expected, 1e-6 * expected) << "pair " << i;
  }
}

TEST(pair_judgement, of_what_scans_leave_open_a_registration_may_be_off_by_a_tenth_of_the_way_and_no_more) {
  const testing::DriveOptions options;
  const testing::SimulatedDrive drive = testing::simulate(options, 3);
  const auto judged = [&](double baseline_m, double slid_m, double turned_rad, bool open) {
    std::vector<motion::Pair> pairs = testing::pairs_of(drive);
    pairs.resize(20);
    std::vector<motion::PairIndex> all;
    for (motion::PairIndex i; i < pairs.size(); ++i) all.push_back(i);
    motion::Pair& pair = pairs[7];
    pair.baseline_m = baseline_m;
    pair.registration.information.setZero();
    if (open) pair.registration.undetermined = Message::verbatim("x, yaw (axes of the lidar)");
    pair.lidar_b_from_lidar_a.translation().x() += slid_m;
    pair.lidar_b_from_lidar_a.rotate(so3_exp({0.0, 0.0, turned_rad}));
    judge_pairs(pairs, all, drive.ins_from_lidar, options.noise, 4.0);
    return pair.state;
  };
  EXPECT_EQ(judged(5.0, 0.8, 0.0, true), motion::PairState::Accepted);
  EXPECT_EQ(judged(5.0, 1.4, 0.0, true), motion::PairState::Rejected);
  EXPECT_EQ(judged(30.0, 2.5, 0.0, true), motion::PairState::Accepted) << "a nominal may be off by degrees";
  EXPECT_EQ(judged(30.0, 3.5, 0.0, true), motion::PairState::Rejected);
  EXPECT_EQ(judged(5.0, 0.0, 0.1, true), motion::PairState::Accepted);
  EXPECT_EQ(judged(5.0, 0.0, 0.3, true), motion::PairState::Rejected);
  EXPECT_EQ(judged(5.0, 1.4, 0.0, false), motion::PairState::Accepted) << "what is known of it decides alone";
}

TEST(pair_judgement, a_failed_registration_that_is_proposed_again_keeps_its_reason) {
  std::vector<motion::Pair> pairs(3);
  for (motion::Pair& pair : pairs) pair.state = motion::PairState::Proposed;
  pairs[0].registration.attempted = true;
  pairs[0].registration.failure = Message::verbatim("too little overlap");
  pairs[1].registration.attempted = true;
  pairs[1].registration.information = Matrix6d::Identity();
  refuse_unusable(pairs);
  EXPECT_EQ(pairs[0].state, motion::PairState::Rejected);
  EXPECT_EQ(english(pairs[0].reason), "too little overlap");
  EXPECT_EQ(pairs[1].state, motion::PairState::Proposed) << "the solution judges it";
  EXPECT_EQ(pairs[2].state, motion::PairState::Proposed) << "it is not registered yet";
}

}  // namespace
}  // namespace remount::calibration
