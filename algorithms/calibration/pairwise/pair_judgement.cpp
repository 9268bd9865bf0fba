#include "algorithms/calibration/pairwise/pair_judgement.h"

#include <algorithm>
#include <cmath>

#include "algorithms/calibration/joint/pair_equation.h"
#include "algorithms/calibration/linear_solutions.h"
#include "algorithms/motion/screw.h"
#include "messages/pairs.h"

namespace remount::calibration {

using motion::Pair;

namespace {

Message outlier_reason(const Pair& pair, double score) {
  return (pair.screw.passed ? say::pair_contradicts_ins : say::pair_contradicts_ins_screw)(
      {pair.residual_translation_m}, {pair.residual_rotation_rad}, score);
}

// Also a good pair may leave something open; nothing is taken from it there.
Message open_directions(const Pair& pair) {
  return pair.registration.undetermined.empty() ? Message() : say::pair_leaves_open(pair.registration.undetermined);
}

// Whether scans that leave directions open were aligned at a place where they never were: along an open direction a
// registration stays about where it starts, and one that lies metres off began wrongly or slid. What its surfaces seem
// to determine then are not the same surfaces.
bool slid_away(const Pair& pair) {
  constexpr double kFar_m = 1.0, kFarShare = 0.1, kFar_rad = degrees_to_radians(10.0);
  return !pair.registration.undetermined.empty() &&
         (pair.residual_translation_m > std::max(kFar_m, kFarShare * pair.baseline_m) ||
          pair.residual_rotation_rad > kFar_rad);
}

Message slid_reason(const Pair& pair) {
  return say::pair_slid({pair.residual_translation_m}, {pair.residual_rotation_rad}, pair.registration.undetermined);
}

void set_residual(const RigidTransform& ins_from_lidar, Pair& pair) {
  const Vector6d residual = motion_residual(pair.ins_b_from_ins_a, pair.lidar_b_from_lidar_a, ins_from_lidar);
  pair.residual_translation_m = residual.head<3>().norm();
  pair.residual_rotation_rad = residual.tail<3>().norm();
}

double tilt_of(const PairTilts& tilts_rad, motion::PairIndex pair) {
  return pair < tilts_rad.size() ? tilts_rad[pair] : 0.0;
}

}  // namespace

double sigma_equivalent(double distance2) { return std::sqrt(2.0 * distance2) - std::sqrt(11.0); }

double residual_scale2(std::vector<double> d2) {
  // More than half of the pairs may be wrong: the scale follows the better third. docs/maths/pairwise.md (P8)
  constexpr double kShare = 0.35, kShareChi2 = 4.197;  // that quantile of six degrees of freedom
  if (d2.empty()) return 1.0;
  const auto place = d2.begin() + static_cast<std::ptrdiff_t>(kShare * static_cast<double>(d2.size()));
  std::nth_element(d2.begin(), place, d2.end());
  return std::max(1.0, *place / kShareChi2);
}

std::vector<motion::PairIndex> usable_pairs(const std::vector<Pair>& pairs) {
  std::vector<motion::PairIndex> usable;
  for (motion::PairIndex i; i < pairs.size(); ++i) {
    const Pair& pair = pairs[i];
    if (pair.state == motion::PairState::Rejected && pair.decided_by == motion::DecidedBy::User) continue;
    if (!motion::unusable_reason(pair).empty()) continue;
    usable.push_back(i);
  }
  return usable;
}

void refuse_unusable(std::vector<Pair>& pairs) {
  for (Pair& pair : pairs) {
    // One whose registration failed is proposed again when more pairs are taken, and nobody judges it then.
    const bool failed = pair.state == motion::PairState::Proposed && pair.registration.attempted;
    if (pair.state != motion::PairState::Accepted && !failed) continue;
    const Message reason = motion::unusable_reason(pair);
    if (reason.empty()) continue;
    pair.state = motion::PairState::Rejected;
    pair.decided_by = motion::DecidedBy::Program;
    pair.reason = reason;
    pair.weight = 0.0;
  }
}

std::vector<search::MotionPair> accepted_motions(const std::vector<Pair>& pairs) {
  std::vector<search::MotionPair> accepted;
  for (const Pair& pair : pairs)
    if (pair.state == motion::PairState::Accepted)
      accepted.push_back({pair.ins_b_from_ins_a, pair.lidar_b_from_lidar_a, 1.0});
  return accepted;
}

std::vector<NoisyPair> noisy_pairs(const std::vector<Pair>& pairs, const std::vector<motion::PairIndex>& usable,
                                   const NoiseModel& noise, const PairTilts& tilts_rad) {
  constexpr double kNothing = 1e-6;  // a sigma of a kilometre, of a thousand radians: any motion
  std::vector<NoisyPair> out;
  out.reserve(usable.size());
  for (const motion::PairIndex i : usable) {
    const Pair& pair = pairs[i];
    const Matrix6d information = noise.registration_information(pair.registration.information);
    const Matrix6d regular = information + kNothing * Matrix6d::Identity();
    const double tilt = tilt_of(tilts_rad, i);
    const Matrix6d ins = noise.ins_covariance(), drift = noise.drift_covariance(std::abs(pair.gap_s));
    out.push_back({pair.ins_b_from_ins_a, pair.lidar_b_from_lidar_a, information, symmetric_inverse(regular),
                   2.0 * ins(0, 0) + drift(0, 0), ins(3, 3), ins(3, 3) + drift(3, 3), tilt * tilt});
  }
  return out;
}

namespace {

// d_a A d_a' + d_b B d_b' of linearise_pair for covariances A and B that are alike along all axes: the rotations in
// d_a and d_b then cancel, which leaves a tenth of the work.
void add_ins_errors(const NoisyPair& pair, const RigidTransform& x, const Eigen::Matrix3d& log_jacobian,
                    Matrix6d& covariance) {
  const double of_a = pair.attitude_variance_a_rad2, of_b = pair.attitude_variance_b_rad2;
  const Eigen::Matrix3d lidar_from_ins = x.linear().transpose();
  const Eigen::Vector3d arm_in_ins_b = pair.ins_b_from_ins_a.linear() * x.translation();
  const Eigen::Vector3d arm = lidar_from_ins * arm_in_ins_b;
  const Eigen::Vector3d reach = lidar_from_ins * (arm_in_ins_b + pair.ins_b_from_ins_a.translation());
  // skew(v) skew(v)' = |v|^2 - v v'.
  covariance.topLeftCorner<3, 3>() -= of_a * arm * arm.transpose() + of_b * reach * reach.transpose();
  covariance.topLeftCorner<3, 3>().diagonal().array() +=
      pair.ins_position_variance_m2 + of_a * arm.squaredNorm() + of_b * reach.squaredNorm();
  const Eigen::Matrix3d mixed = log_jacobian * skew(of_a * arm + of_b * reach);  // transposed: the skew changes sign
  covariance.bottomLeftCorner<3, 3>() += mixed;
  covariance.topRightCorner<3, 3>() += mixed.transpose();
  covariance.bottomRightCorner<3, 3>() += (of_a + of_b) * log_jacobian * log_jacobian.transpose();
}

// What an assumed roll and pitch of both poses add; these are not alike along all axes.
void add_assumed_tilt(const NoisyPair& pair, const RigidTransform& x, Matrix6d& covariance) {
  const PairEquation equation = linearise_pair(pair.ins_b_from_ins_a, pair.lidar_b_from_lidar_a, x);
  for (const Matrix6d* by_pose : {&equation.d_a, &equation.d_b}) {
    const Eigen::Matrix<double, 6, 2> by_tilt = by_pose->middleCols<2>(3);
    covariance += pair.assumed_tilt_variance_rad2 * by_tilt * by_tilt.transpose();
  }
}

}  // namespace

std::vector<double> distances2(const std::vector<NoisyPair>& pairs, const RigidTransform& x) {
  std::vector<double> out;
  out.reserve(pairs.size());
  for (const NoisyPair& pair : pairs) {
    const Vector6d residual = difference(pair.lidar_b_from_lidar_a, predicted_lidar_motion(pair.ins_b_from_ins_a, x));
    Matrix6d covariance = pair.registration_covariance;
    add_ins_errors(pair, x, so3_left_jacobian_inverse(residual.tail<3>()), covariance);
    if (pair.assumed_tilt_variance_rad2 > 0.0) add_assumed_tilt(pair, x, covariance);
    const double distance2 = covariance.llt().matrixL().solve(residual).squaredNorm();
    out.push_back(std::isfinite(distance2) ? std::max(0.0, distance2) : std::numeric_limits<double>::max());
  }
  return out;
}

// Sigma of the two screw invariants from the noise of P and Q.
void test_screws(std::vector<Pair>& pairs, const std::vector<motion::PairIndex>& usable, const NoiseModel& noise,
                 double threshold, const PairTilts& tilts_rad) {
  const double translation_sigma = std::hypot(std::sqrt(2.0) * noise.ins_position_sigma_m, noise.registration_floor_m);
  for (const motion::PairIndex i : usable) {
    Pair& pair = pairs[i];
    const double attitude_sigma = std::hypot(noise.ins_attitude_sigma_rad, tilt_of(tilts_rad, i));
    const double rotation_sigma = std::hypot(std::sqrt(2.0) * attitude_sigma, noise.registration_floor_rad);
    pair.screw = motion::screw_test(pair.ins_b_from_ins_a, pair.lidar_b_from_lidar_a, rotation_sigma, translation_sigma,
                                    threshold);
  }
}

namespace {

// How far each usable pair lies from X, in sigma of what the pairs together scatter.
std::vector<double> scores_of(const std::vector<Pair>& pairs, const std::vector<motion::PairIndex>& usable,
                              const RigidTransform& ins_from_lidar, const NoiseModel& noise,
                              const PairTilts& tilts_rad) {
  std::vector<double> scores = distances2(noisy_pairs(pairs, usable, noise, tilts_rad), ins_from_lidar);
  const double scale2 = residual_scale2(scores);
  for (double& score : scores) score = sigma_equivalent(score / scale2);
  return scores;
}

}  // namespace

int judge_pairs(std::vector<Pair>& pairs, const std::vector<motion::PairIndex>& usable,
                const RigidTransform& ins_from_lidar, const NoiseModel& noise, double threshold,
                const PairTilts& tilts_rad) {
  int changed = 0;
  const std::vector<double> scores = scores_of(pairs, usable, ins_from_lidar, noise, tilts_rad);
  for (std::size_t k = 0; k < usable.size(); ++k) {
    Pair& pair = pairs[usable[k]];
    set_residual(ins_from_lidar, pair);
    const double score = scores[k];
    const bool slid = slid_away(pair);
    pair.weight = pair.decided_by == motion::DecidedBy::User ? 1.0 : score <= threshold && !slid ? 1.0 : 0.0;
    if (pair.decided_by == motion::DecidedBy::User) continue;
    const motion::PairState state = pair.weight > 0.0 ? motion::PairState::Accepted : motion::PairState::Rejected;
    changed += state != pair.state ? 1 : 0;
    pair.state = state;
    pair.decided_by = motion::DecidedBy::Program;
    pair.reason = state == motion::PairState::Accepted ? open_directions(pair)
                  : score <= threshold                 ? slid_reason(pair)
                                                       : outlier_reason(pair, score);
  }
  return changed;
}

void tell_residuals(std::vector<Pair>& pairs, const std::vector<motion::PairIndex>& usable,
                    const RigidTransform& judged_by, const RigidTransform& ins_from_lidar, const NoiseModel& noise,
                    double threshold, const PairTilts& tilts_rad) {
  const std::vector<double> scores = scores_of(pairs, usable, judged_by, noise, tilts_rad);
  for (std::size_t k = 0; k < usable.size(); ++k) {
    Pair& pair = pairs[usable[k]];
    if (pair.state != motion::PairState::Rejected || pair.decided_by != motion::DecidedBy::Program) continue;
    set_residual(judged_by, pair);
    const bool slid = scores[k] <= threshold && slid_away(pair);
    set_residual(ins_from_lidar, pair);
    pair.reason = slid ? slid_reason(pair) : outlier_reason(pair, scores[k]);
  }
  set_residuals(pairs, ins_from_lidar);
}

void set_residuals(std::vector<Pair>& pairs, const RigidTransform& ins_from_lidar) {
  for (Pair& pair : pairs)
    if (motion::unusable_reason(pair).empty()) set_residual(ins_from_lidar, pair);
}

}  // namespace remount::calibration
