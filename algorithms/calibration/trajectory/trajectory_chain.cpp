#include "algorithms/calibration/trajectory/trajectory_chain.h"

namespace remount::calibration {

TrajectoryChain::TrajectoryChain(std::size_t poses)
    : diagonal_(poses, Matrix6d::Zero()), to_next_(poses, Matrix6d::Zero()), to_border_(poses, Link::Zero()) {
  // Positions alone leave the attitude of a short track open: ten radians are no knowledge, but make the equations
  // definite.
  constexpr double kOpen_rad = 10.0, kOpen_m = 1e4;
  for (Matrix6d& block : diagonal_) {
    block.diagonal().head<3>().setConstant(1.0 / (kOpen_m * kOpen_m) / static_cast<double>(poses));
    block.diagonal().tail<3>().setConstant(1.0 / (kOpen_rad * kOpen_rad) / static_cast<double>(poses));
  }
}

void TrajectoryChain::add(const TrajectoryTerm& term, double weight) {
  const std::size_t i = term.epoch;
  const Eigen::Matrix<double, 6, 3> pose = weight * term.by_pose.transpose();
  diagonal_[i].noalias() += pose * term.by_pose;
  to_border_[i].noalias() += pose * term.by_border;
  border_.noalias() += weight * term.by_border.transpose() * term.by_border;
  if (!term.is_step()) return;
  const Eigen::Matrix<double, 6, 3> before = weight * term.by_before.transpose();
  diagonal_[i - 1].noalias() += before * term.by_before;
  to_next_[i - 1].noalias() += before * term.by_pose;
  to_border_[i - 1].noalias() += before * term.by_border;
}

void TrajectoryChain::add_transposed(const TrajectoryTerm& term, const Eigen::Vector3d& v, ChainVector& to) {
  to.poses[term.epoch].noalias() += term.by_pose.transpose() * v;
  if (term.is_step()) to.poses[term.epoch - 1].noalias() += term.by_before.transpose() * v;
  to.border.noalias() += term.by_border.transpose() * v;
}

Eigen::Vector3d TrajectoryChain::apply(const TrajectoryTerm& term, const ChainVector& step) {
  Eigen::Vector3d out = term.by_pose * step.poses[term.epoch] + term.by_border * step.border;
  if (term.is_step()) out += term.by_before * step.poses[term.epoch - 1];
  return out;
}

bool TrajectoryChain::factor() {
  factors_.clear();
  factors_.reserve(diagonal_.size());
  for (std::size_t i = 0; i < diagonal_.size(); ++i) {
    factors_.emplace_back(diagonal_[i]);
    if (factors_[i].info() != Eigen::Success || !diagonal_[i].allFinite()) return false;
    const Link solved = factors_[i].solve(to_border_[i]);
    border_.noalias() -= to_border_[i].transpose() * solved;
    if (i + 1 == diagonal_.size()) break;
    const Matrix6d gain = factors_[i].solve(to_next_[i]).transpose();
    diagonal_[i + 1].noalias() -= gain * to_next_[i];
    diagonal_[i + 1] = (0.5 * (diagonal_[i + 1] + diagonal_[i + 1].transpose())).eval();
    to_border_[i + 1].noalias() -= gain * to_border_[i];
  }
  border_ = (0.5 * (border_ + border_.transpose())).eval();
  return border_.allFinite();
}

void TrajectoryChain::reduce(ChainVector& side) const {
  for (std::size_t i = 0; i < factors_.size(); ++i) {
    const Vector6d solved = factors_[i].solve(side.poses[i]);
    side.border.noalias() -= to_border_[i].transpose() * solved;
    if (i + 1 < factors_.size()) side.poses[i + 1].noalias() -= to_next_[i].transpose() * solved;
  }
}

void TrajectoryChain::substitute(const BorderVector& border_step, ChainVector& side) const {
  side.border = border_step;
  for (std::size_t i = factors_.size(); i-- > 0;) {
    Vector6d rest = side.poses[i] - to_border_[i] * border_step;
    if (i + 1 < factors_.size()) rest -= to_next_[i] * side.poses[i + 1];
    side.poses[i] = factors_[i].solve(rest);
  }
}

std::vector<Eigen::Matrix<double, 6, kBorderSize>> TrajectoryChain::sensitivity() const {
  std::vector<Link> out(factors_.size());
  for (std::size_t i = factors_.size(); i-- > 0;) {
    Link rest = -to_border_[i];
    if (i + 1 < factors_.size()) rest -= to_next_[i] * out[i + 1];
    out[i] = factors_[i].solve(rest);
  }
  return out;
}

}  // namespace remount::calibration
