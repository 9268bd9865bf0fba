#include "algorithms/calibration/joint/shared_block.h"

namespace remount::calibration {
namespace {

constexpr Eigen::Index kWide = 24, kStackedRows = 192;

}  // namespace

SharedBlock::SharedBlock(Eigen::MatrixXd& sum) : sum_(sum) {
  if (sum.rows() < kWide) return;
  plain_.resize(kStackedRows, sum.rows());
  weighted_.resize(kStackedRows, sum.rows());
}

void SharedBlock::add(const Jacobian& jacobian, const Jacobian& weighted) {
  if (plain_.size() == 0) {
    sum_ += jacobian.transpose().lazyProduct(weighted);
    return;
  }
  plain_.middleRows<6>(rows_) = jacobian;
  weighted_.middleRows<6>(rows_) = weighted;
  rows_ += 6;
  if (rows_ == kStackedRows) add_rows();
}

void SharedBlock::finish() {
  if (plain_.size() == 0) return;
  add_rows();
  sum_.triangularView<Eigen::StrictlyUpper>() = sum_.transpose();
}

void SharedBlock::add_rows() {
  if (rows_ > 0) sum_.triangularView<Eigen::Lower>() += plain_.topRows(rows_).transpose() * weighted_.topRows(rows_);
  rows_ = 0;
}

}  // namespace remount::calibration
