#include "algorithms/calibration/trajectory/trajectory_chain.h"

#include <gtest/gtest.h>

#include "algorithms/calibration/linear_solutions.h"

namespace remount::calibration {
namespace {

TEST(trajectory_chain, solves_what_a_dense_solver_does) {
  constexpr int kPoses = 5, kSize = 6 * kPoses + kBorderSize;
  std::srand(5);  // Eigen's Random
  TrajectoryChain chain(kPoses);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(kSize, kSize);
  Eigen::VectorXd dense_side = Eigen::VectorXd::Zero(kSize);
  ChainVector side(kPoses);
  std::vector<TrajectoryTerm> terms;
  for (std::size_t i = 0; i < kPoses; ++i)
    for (const TermKind kind : {TermKind::InsPosition, TermKind::InsAttitude, TermKind::StepTranslation,
                                TermKind::StepRotation, TermKind::Antenna}) {
      TrajectoryTerm term;
      term.kind = kind;
      term.epoch = i;
      if (term.is_step() && i == 0) continue;
      term.by_pose.setRandom();
      term.by_border.setRandom();
      if (term.is_step()) term.by_before.setRandom();
      const Eigen::Vector3d v = Eigen::Vector3d::Random();
      chain.add(term, 2.0);
      TrajectoryChain::add_transposed(term, v, side);
      Eigen::MatrixXd row = Eigen::MatrixXd::Zero(3, kSize);
      row.middleCols<6>(6 * static_cast<int>(i)) = term.by_pose;
      if (term.is_step()) row.middleCols<6>(6 * static_cast<int>(i) - 6) = term.by_before;
      row.rightCols<kBorderSize>() = term.by_border;
      dense += 2.0 * row.transpose() * row;
      dense_side += row.transpose() * v;
    }
  for (int i = 0; i < kPoses; ++i) {  // what the chain adds so that open attitudes can be solved
    dense.diagonal().segment<3>(6 * i).array() += 1e-8 / kPoses;
    dense.diagonal().segment<3>(6 * i + 3).array() += 1e-2 / kPoses;
  }
  ASSERT_TRUE(chain.factor());
  chain.reduce(side);
  const BorderVector border = symmetric_solution(Eigen::MatrixXd(chain.reduced()), side.border);
  const auto sensitivity = chain.sensitivity();
  chain.substitute(border, side);
  const Eigen::VectorXd expected = symmetric_solution(dense, dense_side);
  EXPECT_LT((border - expected.tail<kBorderSize>()).norm(), 1e-8 * expected.norm());
  for (int i = 0; i < kPoses; ++i)
    EXPECT_LT((side.poses[static_cast<std::size_t>(i)] - expected.segment<6>(6 * i)).norm(), 1e-8 * expected.norm());
  const Eigen::MatrixXd poses = dense.topLeftCorner(6 * kPoses, 6 * kPoses),
                        follow = -symmetric_solution(poses, dense.topRightCorner(6 * kPoses, kBorderSize));
  for (int i = 0; i < kPoses; ++i)
    EXPECT_LT((sensitivity[static_cast<std::size_t>(i)] - follow.middleRows<6>(6 * i)).norm(), 1e-8 * follow.norm());
}

TEST(trajectory_chain, what_is_not_finite_is_refused) {
  TrajectoryChain chain(2);
  TrajectoryTerm term;
  term.by_pose.setConstant(std::numeric_limits<double>::quiet_NaN());
  chain.add(term, 1.0);
  EXPECT_FALSE(chain.factor());
}

}  // namespace
}  // namespace remount::calibration
