// Own engine: plane-to-plane alignment (generalized ICP, Segal 2009) with normals only. With covariances
// I - (1 - e) n n' the combined inverse has a closed form in the two normals, so no 3x3 inverse is taken.
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "algorithms/registration/registration.h"

namespace remount {
namespace {

constexpr double kThickness = 1e-3;  // variance along a normal against that in the plane

struct Match {
  int target = -1;
  float reach_m = -1.0f;  // the match holds while the query has moved less than this
  Eigen::Vector3f searched_at = Eigen::Vector3f::Zero();
};

// Finds, and keeps while it is provably unchanged, the neighbour of every source point: with a distance gap g between
// first and second neighbour the first stays first until the query has moved by g / 2.
class Matcher {
 public:
  Matcher(const PreparedCloud& source, const PreparedCloud& target)
      : source_(source), target_(target), matches_(source.size()) {}

  int find(std::size_t i, const Eigen::Vector3f& query_in_target, float radius_m) {
    Match& match = matches_[i];
    const float moved_m = (query_in_target - match.searched_at).norm();
    if (match.target < 0 || moved_m >= match.reach_m) {
      // One search radius for all iterations, so that a kept match is the one that a new search would find.
      const Neighbour found = target_.nearest(query_in_target, kSearchRadiusFactor * radius_m);
      match.target = found.index;
      match.searched_at = query_in_target;
      match.reach_m = found.index < 0 ? -1.0f : 0.5f * (found.next_distance_m - found.distance_m);
    }
    if (match.target < 0) return -1;
    const auto t = static_cast<std::size_t>(match.target);
    return (target_.points()[t] - query_in_target).squaredNorm() <= radius_m * radius_m ? match.target : -1;
  }

 private:
  static constexpr float kSearchRadiusFactor = 1.0f;
  const PreparedCloud& source_;
  const PreparedCloud& target_;
  std::vector<Match> matches_;
};

struct Sums {
  Matrix6d hessian = Matrix6d::Zero();
  Vector6d gradient = Vector6d::Zero();
  double squared_normal_residuals = 0.0;
  double weights = 0.0;
  std::size_t inliers = 0;
};

// Inverse of 2 I - (1 - e)(n n' + m m'): eigenvectors n + m, n - m and their normal.
Eigen::Matrix3f combined_information(const Eigen::Vector3f& n, const Eigen::Vector3f& m, float cosine) {
  constexpr auto kKeep = static_cast<float>(1.0 - kThickness);
  Eigen::Matrix3f information = 0.5f * Eigen::Matrix3f::Identity();
  const Eigen::Vector3f sum = n + m, difference = n - m;
  const float sum2 = sum.squaredNorm(), difference2 = difference.squaredNorm();
  information.noalias() += ((1.0f / (2.0f - kKeep * (1.0f + cosine)) - 0.5f) / sum2) * sum * sum.transpose();
  if (difference2 > 1e-10f)
    information.noalias() +=
        ((1.0f / (2.0f - kKeep * (1.0f - cosine)) - 0.5f) / difference2) * difference * difference.transpose();
  return information;
}

// Normal equations at one transform. `kernel_m`: residuals along the normal much larger than this hardly count
// (Geman-McClure), so that moving objects and occlusions do not pull.
Sums accumulate(const PreparedCloud& source, const PreparedCloud& target, const RigidTransform& target_from_source,
                float radius_m, float kernel_m, Matcher& matcher, std::vector<float>* residuals) {
  const Eigen::Matrix3f rotation = target_from_source.linear().cast<float>();
  const Eigen::Vector3f translation = target_from_source.translation().cast<float>();
  Sums sums;
  if (residuals) residuals->clear();
  for (std::size_t i = 0; i < source.size(); ++i) {
    const Eigen::Vector3f arm = rotation * source.points()[i];
    const Eigen::Vector3f query = arm + translation;
    const int j = matcher.find(i, query, radius_m);
    if (j < 0) continue;
    const auto t = static_cast<std::size_t>(j);
    const Eigen::Vector3f& n = target.normals()[t];
    Eigen::Vector3f m = rotation * source.normals()[i];
    float cosine = n.dot(m);
    if (cosine < 0.0f) {
      m = -m;
      cosine = -cosine;
    }
    if (cosine < 0.7f) continue;
    const Eigen::Vector3f error = query - target.points()[t];
    const Eigen::Vector3f middle = (n + m) / std::sqrt(2.0f + 2.0f * cosine);
    const float along = middle.dot(error);
    const float ratio = along / kernel_m;
    const float soft = 1.0f / (1.0f + ratio * ratio);
    const float weight = soft * soft * source.planarity()[i] * target.planarity()[t];
    const Eigen::Matrix3d information = (weight * combined_information(n, m, cosine)).cast<double>();
    Eigen::Matrix<double, 3, 6> jacobian;
    jacobian.leftCols<3>().setIdentity();
    jacobian.rightCols<3>() = -skew(arm.cast<double>());
    const Eigen::Matrix<double, 3, 6> weighted = information * jacobian;
    sums.hessian.noalias() += jacobian.transpose() * weighted;
    sums.gradient.noalias() += weighted.transpose() * error.cast<double>();
    sums.squared_normal_residuals += static_cast<double>(weight * along * along);
    sums.weights += static_cast<double>(weight);
    ++sums.inliers;
    if (residuals) residuals->push_back(std::abs(along));
  }
  return sums;
}

float robust_kernel_m(std::vector<float>& residuals, float smallest_m, float largest_m) {
  if (residuals.empty()) return largest_m;
  const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
  std::nth_element(residuals.begin(), middle, residuals.end());
  return std::clamp(4.0f * 1.4826f * *middle, smallest_m, largest_m);
}

std::uint64_t cell_of(const Eigen::Vector3f& point) {
  constexpr float kCell_m = 2.0f;
  const auto index = [&](float v) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(v / kCell_m)) + (1LL << 20));
  };
  return (index(point.z()) << 42) | (index(point.y()) << 21) | index(point.x());
}

}  // namespace

RegistrationResult align_plane_to_plane(const PreparedCloud& source, const PreparedCloud& target,
                                        const RigidTransform& target_from_source_start,
                                        const RegistrationOptions& options, const Progress& progress) {
  RegistrationResult result;
  RigidTransform current = target_from_source_start;
  Matcher matcher(source, target);
  std::vector<float> residuals;
  const auto final_radius = static_cast<float>(options.max_correspondence_m);
  float kernel_m = 0.5f * final_radius;
  for (int iteration = 0; iteration < options.max_iterations && !progress.cancelled(); ++iteration) {
    const Sums sums = accumulate(source, target, current, final_radius, kernel_m, matcher, &residuals);
    result.quality.iterations = iteration + 1;
    if (sums.inliers < 50) break;
    // A trace of damping keeps a direction without information (open field, corridor) where it is.
    Matrix6d damped = sums.hessian;
    damped.diagonal() *= 1.0 + 1e-9;
    damped.diagonal().array() += 1e-9 * sums.hessian.diagonal().maxCoeff();
    const Vector6d step = damped.ldlt().solve(-sums.gradient);
    if (!step.allFinite()) break;
    current = perturbed(current, step);
    const float previous_kernel_m = kernel_m;
    kernel_m = robust_kernel_m(residuals, 0.03f, 0.5f * final_radius);
    const bool kernel_settled = std::abs(kernel_m - previous_kernel_m) < 0.02f * previous_kernel_m;
    if (kernel_settled && step.head<3>().norm() < 2e-5 && step.tail<3>().norm() < 1e-6) {
      result.quality.converged = true;
      break;
    }
    // The last steps may swing between two equal sets of neighbours; that far below the noise is converged as well.
    if (iteration + 1 == options.max_iterations)
      result.quality.converged = step.head<3>().norm() < 2e-3 && step.tail<3>().norm() < 2e-4;
  }
  current.linear() = nearest_rotation(current.linear());
  result.target_from_source = current;
  return result;
}

AlignmentEquations alignment_equations(const PreparedCloud& source, const PreparedCloud& target,
                                       const RigidTransform& target_from_source, double max_correspondence_m) {
  const Eigen::Matrix3f rotation = target_from_source.linear().cast<float>();
  const Eigen::Vector3f translation = target_from_source.translation().cast<float>();
  const auto radius_m = static_cast<float>(max_correspondence_m);
  struct Term {
    Vector6d row;
    double residual_m;
    double weight;
    std::uint64_t cell;
  };
  std::vector<Term> terms;
  std::vector<float> residuals;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const Eigen::Vector3f arm = rotation * source.points()[i], query = arm + translation;
    const Neighbour found = target.nearest(query, radius_m);
    if (found.index < 0) continue;
    const auto t = static_cast<std::size_t>(found.index);
    Eigen::Vector3f m = rotation * source.normals()[i];
    const Eigen::Vector3f& n = target.normals()[t];
    if (n.dot(m) < 0.0f) m = -m;
    if (n.dot(m) < 0.7f) continue;
    const Eigen::Vector3d normal = (n + m).normalized().cast<double>();
    const double along = normal.dot((query - target.points()[t]).cast<double>());
    Term term{Vector6d::Zero(), along, static_cast<double>(source.planarity()[i] * target.planarity()[t]),
              cell_of(query)};
    term.row << normal, arm.cast<double>().cross(normal);
    terms.push_back(term);
    residuals.push_back(static_cast<float>(std::abs(along)));
  }
  AlignmentEquations equations;
  if (terms.empty()) return equations;
  const double kernel_m = robust_kernel_m(residuals, 0.03f, 0.5f * radius_m);
  double squares = 0.0, weights = 0.0;
  std::size_t inliers = 0;
  for (Term& term : terms) {
    const double ratio = term.residual_m / kernel_m;
    if (std::abs(ratio) < 1.0) ++inliers;
    term.weight /= (1.0 + ratio * ratio) * (1.0 + ratio * ratio);
    squares += term.weight * term.residual_m * term.residual_m;
    weights += term.weight;
  }
  equations.overlap = static_cast<double>(inliers) / static_cast<double>(source.size());
  equations.rmse_m = weights > 0.0 ? std::sqrt(squares / weights) : 0.0;
  const double variance = std::max(equations.rmse_m * equations.rmse_m, 25e-6);
  for (const Term& term : terms) {
    equations.hessian.noalias() += term.weight / variance * term.row * term.row.transpose();
    equations.gradient.noalias() += term.weight / variance * term.residual_m * term.row;
  }
  // Errors on one surface are alike, and few surfaces face a direction: the scatter of the cells' gradients says how
  // well the minimum is known, the number of points does not.
  Matrix6d damped = equations.hessian;
  damped.diagonal().head<3>().array() += 1.0 / (0.1 * 0.1);
  damped.diagonal().tail<3>().array() += 1.0 / (0.005 * 0.005);
  const Vector6d step = damped.ldlt().solve(-equations.gradient);
  std::unordered_map<std::uint64_t, Vector6d> cells;
  for (const Term& term : terms) {
    const auto found = cells.try_emplace(term.cell, Vector6d::Zero()).first;
    found->second += term.weight / variance * (term.residual_m + term.row.dot(step)) * term.row;
  }
  Matrix6d scatter = 0.3 * equations.hessian;
  for (const auto& [cell, gradient] : cells) scatter.noalias() += gradient * gradient.transpose();
  equations.information = equations.hessian * scatter.ldlt().solve(equations.hessian);
  return equations;
}

}  // namespace remount
