#include "algorithms/calibration/joint/shared_block.h"

#include <gtest/gtest.h>

#include <random>

namespace remount::calibration {
namespace {

// Narrow and wide blocks, and as many terms as fill the stack, one less and one more.
TEST(shared_block, is_the_sum_of_all_terms_and_what_was_there) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  const auto draw = [&] { return normal(random); };
  for (const Eigen::Index columns : {7, 60})
    for (const int terms : {0, 1, 31, 32, 33, 100}) {
      const Eigen::MatrixXd root = Eigen::MatrixXd::NullaryExpr(columns, columns, draw);
      Eigen::MatrixXd sum = root * root.transpose(), expected = sum;
      SharedBlock block(sum);
      for (int term = 0; term < terms; ++term) {
        const Eigen::MatrixXd weight = Eigen::MatrixXd::NullaryExpr(6, 6, draw);
        const SharedBlock::Jacobian jacobian = SharedBlock::Jacobian::NullaryExpr(6, columns, draw);
        const SharedBlock::Jacobian weighted = weight * weight.transpose() * jacobian;
        block.add(jacobian, weighted);
        expected += jacobian.transpose() * weighted;
      }
      block.finish();
      EXPECT_LT((sum - expected).cwiseAbs().maxCoeff(), 1e-11 * expected.cwiseAbs().maxCoeff())
          << columns << " columns, " << terms << " terms";
    }
}

}  // namespace
}  // namespace remount::calibration
