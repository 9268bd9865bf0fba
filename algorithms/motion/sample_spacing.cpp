#include "algorithms/motion/sample_spacing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/core/median.h"
#include "algorithms/core/stamps.h"
#include "algorithms/motion/cubic_between.h"

namespace remount::motion {
namespace {

const Eigen::Vector3d kUnknownMiss = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());

double time_between_s(std::int64_t from_ns, std::int64_t to_ns) { return seconds(to_ns - from_ns); }

// The value at sample `k` by the cubic through those `step` and three times `step` away on either side, and how far it
// is from the sample.
Eigen::Vector3d miss_of_position(const std::vector<StampedPose>& samples, std::size_t k, std::size_t step) {
  if (k < 3 * step || k + 3 * step >= samples.size()) return kUnknownMiss;
  CubicNeighbours around;
  const std::size_t nodes[4] = {k - 3 * step, k - step, k + step, k + 3 * step};
  for (std::size_t i = 0; i < 4; ++i) {
    around.times_s[i] = time_between_s(samples[k].stamp_ns, samples[nodes[i]].stamp_ns);
    around.values[i] = samples[nodes[i]].pose.translation() - samples[k].pose.translation();
  }
  return cubic_between(around, 0.0);
}

// Likewise for turns since the sample before, as a turn of the body at the sample.
Eigen::Vector3d miss_of_attitude(const std::vector<StampedPose>& samples, std::size_t k, std::size_t step) {
  if (k < 3 * step || k + 3 * step >= samples.size()) return kUnknownMiss;
  CubicNeighbours around;
  const std::size_t nodes[4] = {k - 3 * step, k - step, k + step, k + 3 * step};
  const Eigen::Matrix3d from = samples[k - step].pose.linear();
  for (std::size_t i = 0; i < 4; ++i) {
    around.times_s[i] = time_between_s(samples[k].stamp_ns, samples[nodes[i]].stamp_ns);
    around.values[i] = so3_log(from.transpose() * samples[nodes[i]].pose.linear());
  }
  return so3_log(samples[k].pose.linear().transpose() * from * so3_exp(cubic_between(around, 0.0)));
}

template <class MissOf>
SampleSpacing spacing_of(const std::vector<StampedPose>& samples, MissOf&& miss_of) {
  std::vector<double> steps_s;
  for (std::size_t k = 1; k < samples.size(); ++k)
    steps_s.push_back(time_between_s(samples[k - 1].stamp_ns, samples[k].stamp_ns));
  if (steps_s.size() < 2) return {};
  if (median_of(std::move(steps_s)) < kSlowSamples_s) return {};
  std::vector<std::int64_t> stamps_ns;
  std::vector<Eigen::Vector3d> misses;
  double near2 = 0.0, far2 = 0.0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    stamps_ns.push_back(samples[k].stamp_ns);
    misses.push_back(miss_of(samples, k, 1));
    const Eigen::Vector3d far = miss_of(samples, k, 2);
    if (!far.allFinite()) continue;
    near2 += misses.back().squaredNorm();
    far2 += far.squaredNorm();
  }
  // A cubic misses 16 times less where samples are twice as close and the motion is smooth; where it is not, less than
  // that, but twice.
  const double proportion = near2 > 0.0 ? std::clamp(std::sqrt(far2 / near2), 2.0, 16.0) : 2.0;
  return {std::move(stamps_ns), std::move(misses), proportion};
}

}  // namespace

SampleSpacing::SampleSpacing(std::vector<std::int64_t> stamps_ns, std::vector<Eigen::Vector3d> misses,
                             double proportion)
    : stamps_ns_(std::move(stamps_ns)), proportion_(proportion) {
  Eigen::Matrix3d all = Eigen::Matrix3d::Zero();
  double known = 0.0;
  for (const Eigen::Vector3d& miss : misses)
    if (miss.allFinite()) all += miss * miss.transpose(), known += 1.0;
  if (known > 0.0) all /= known;
  // A stretch between two samples is as curved as at its ends; where these are not known, as all of the way.
  for (std::size_t k = 0; k + 1 < misses.size(); ++k) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    double count = 0.0;
    for (const std::size_t end : {k, k + 1})
      if (misses[end].allFinite()) sum += misses[end] * misses[end].transpose(), count += 1.0;
    squares_.push_back(count > 0.0 ? Eigen::Matrix3d(sum / count) : all);
  }
}

std::size_t SampleSpacing::knot_before(std::int64_t stamp_ns) const {
  const auto after = std::upper_bound(stamps_ns_.begin(), stamps_ns_.end(), stamp_ns);
  return after == stamps_ns_.begin() ? 0 : static_cast<std::size_t>(after - stamps_ns_.begin()) - 1;
}

Eigen::Matrix3d SampleSpacing::covariance(std::int64_t stamp_ns) const {
  const std::size_t k = knot_before(stamp_ns);
  if (k >= squares_.size() || stamp_ns < stamps_ns_[k]) return Eigen::Matrix3d::Zero();
  const double u = time_between_s(stamps_ns_[k], stamp_ns) / time_between_s(stamps_ns_[k], stamps_ns_[k + 1]);
  // The error of a cubic between two samples, as a share of that halfway.
  const double share = (1.0 + u) * u * (1.0 - u) * (2.0 - u) / 0.5625;
  return share * share / (proportion_ * proportion_) * squares_[k];
}

SampleSpacing spacing_of_attitudes(const std::vector<StampedPose>& world_from_body) {
  return spacing_of(world_from_body, miss_of_attitude);
}

SampleSpacing spacing_of_positions(const std::vector<StampedPose>& world_from_body) {
  return spacing_of(world_from_body, miss_of_position);
}

}  // namespace remount::motion
