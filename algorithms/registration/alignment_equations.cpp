// The residuals between two scans at a given transform: how well they fit, and how well that determines the transform.
// docs/maths/registration.md (R6) to (R8), (R11), (R12)
#include <Eigen/Cholesky>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "algorithms/cloud/beam_errors.h"
#include "algorithms/core/symmetric_eigen.h"
#include "algorithms/registration/matcher.h"
#include "algorithms/registration/registration.h"
#include "algorithms/registration/robust_scale.h"

namespace remount::registration {
namespace {

// A direction that the surfaces do not show moves by no more than this.
Matrix6d damped(Matrix6d hessian) {
  constexpr double kSpread_m = 0.1, kSpread_rad = 0.005;
  hessian.diagonal().head<3>().array() += 1.0 / (kSpread_m * kSpread_m);
  hessian.diagonal().tail<3>().array() += 1.0 / (kSpread_rad * kSpread_rad);
  return hessian;
}

struct Term {
  Vector6d row;
  double residual_m;
  double weight;
  double source_planarity;
  Eigen::Vector3d arm;
  std::uint64_t cell;
  Eigen::Vector3d source_point, target_point;  // each in the frame of its own LiDAR
};

std::uint64_t cell_of(const Eigen::Vector3f& point) {
  constexpr float kCell_m = 2.0f;  // about the size of one surface; 1 m and 4 m give the same within a tenth
  const auto index = [&](float v) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(v / kCell_m)) + (1LL << 20));
  };
  return (index(point.z()) << 42) | (index(point.y()) << 21) | index(point.x());
}

std::vector<Term> residual_terms(const PreparedCloud& source, const PreparedCloud& target,
                                 const RigidTransform& target_from_source, float radius_m, const Progress& progress,
                                 std::vector<float>& residuals2_m2) {
  Matcher matcher(source.tree().blocks(), target, radius_m, InstructionSet::Best);
  matcher.update(target_from_source, 1, progress);
  const Eigen::Matrix3f rotation = target_from_source.linear().cast<float>();
  const Eigen::Vector3f translation = target_from_source.translation().cast<float>();
  std::vector<Term> terms;
  terms.reserve(source.size());
  residuals2_m2.reserve(source.size());
  for (std::size_t i = 0; i < source.size(); ++i) {
    const MatchBlock& match = matcher.matches()[i / static_cast<std::size_t>(kBlockSize)];
    const std::size_t k = i % static_cast<std::size_t>(kBlockSize);
    if (match.index[k] < 0) continue;
    const PointBlock& near = match.target;
    const Eigen::Vector3f arm = rotation * source.point(i), query = arm + translation;
    const Eigen::Vector3f error = query - Eigen::Vector3f(near.x[k], near.y[k], near.z[k]);
    const Eigen::Vector3f n(near.nx[k], near.ny[k], near.nz[k]);
    Eigen::Vector3f m = rotation * source.normal(i);
    if (n.dot(m) < 0.0f) m = -m;
    if (error.squaredNorm() > radius_m * radius_m || n.dot(m) < kMinCosine) continue;
    const Eigen::Vector3d normal = (n + m).normalized().cast<double>();
    const double along = normal.dot(error.cast<double>());
    // As the aligner weighs it: normals of mixed surfaces (kerb and road) rarely agree.
    const float agreement = 2.0f * (1.0f - kKeep) / (2.0f - kKeep * (1.0f + n.dot(m)));
    Term term{Vector6d::Zero(),
              along,
              static_cast<double>(agreement * source.planarity(i) * near.planarity[k]),
              static_cast<double>(source.planarity(i)),
              arm.cast<double>(),
              cell_of(query),
              source.point(i).cast<double>(),
              Eigen::Vector3d(near.x[k], near.y[k], near.z[k])};
    term.row << normal, arm.cast<double>().cross(normal);
    terms.push_back(term);
    residuals2_m2.push_back(static_cast<float>(along * along));
  }
  return terms;
}

// Errors on one surface are alike, and few surfaces face a direction: the scatter of the cells' gradients says how
// well the minimum is known, the number of points does not.
Matrix6d information_of(const AlignmentEquations& equations, const std::vector<Term>& terms, double variance) {
  const Vector6d step = damped_step(equations);
  std::unordered_map<std::uint64_t, std::size_t> cells;
  std::vector<Vector6d> gradients;
  std::uint64_t last_cell = ~std::uint64_t{0};
  std::size_t at = 0;
  for (const Term& term : terms) {
    if (term.cell != last_cell) {
      at = cells.try_emplace(term.cell, gradients.size()).first->second;
      last_cell = term.cell;
      if (at == gradients.size()) gradients.push_back(Vector6d::Zero());
    }
    gradients[at] += term.weight / variance * (term.residual_m + term.row.dot(step)) * term.row;
  }
  // A share of the points' own noise keeps a direction that few cells see from looking exact.
  constexpr double kOwnNoise = 0.3;
  Matrix6d scatter = kOwnNoise * equations.hessian;
  for (const Vector6d& gradient : gradients) scatter.noalias() += gradient * gradient.transpose();
  return equations.hessian * scatter.ldlt().solve(equations.hessian);
}

UndeterminedDirections undetermined_of(const std::vector<Term>& terms) {
  std::vector<SurfaceElement> elements;
  elements.reserve(terms.size());
  for (const Term& term : terms) elements.push_back({term.row.head<3>(), term.arm, term.weight});
  return undetermined_directions(elements);
}

using BeamCoupling = Eigen::Matrix<double, 6, Eigen::Dynamic>;

// Adds, from column `at` on, what the error of the beam that measured a point does to a term's gradient.
void add_point(const cloud::BeamNodes& nodes, Eigen::Index at, const Eigen::Vector3d& point,
               const Eigen::Vector3d& normal, const Vector6d& weighted, BeamCoupling& coupling) {
  const cloud::BeamPlace place = nodes.place_of(point);
  const cloud::BeamMotion moved = cloud::moved_by_beam(point);
  const double elevation = normal.dot(moved.elevation), range = normal.dot(moved.range),
               azimuth = normal.dot(moved.azimuth);
  for (std::size_t i = 0; i < place.count; ++i) {
    const double share = place.share[i];
    coupling.col(at + nodes.elevation_at(place.node[i])) += share * elevation * weighted;
    coupling.col(at + nodes.range_at(place.node[i])) += share * range * weighted;
    if (nodes.by_azimuth()) coupling.col(at + nodes.azimuth_at(place.node[i])) += share * azimuth * weighted;
  }
  coupling.col(at + nodes.range_scale()) += normal.dot(point) * weighted;
}

// Errors of the beams of source and target: those of the target's have columns of their own behind the source's, or
// the same where both are of one LiDAR.
struct BeamColumns {
  const cloud::BeamNodes &source, &target;
  Eigen::Index target_at;

  bool any() const { return !source.empty() || !target.empty(); }
  Eigen::Index count() const {
    return std::max(source.empty() ? 0 : source.errors(), target.empty() ? 0 : target_at + target.errors());
  }
};

// Of the gradient with the errors of the beams. Every few of a scan's thousands of points tell it as well as all.
BeamCoupling beam_coupling(const BeamColumns& beams, const std::vector<Term>& terms, const Eigen::Matrix3d& rotation,
                           double variance) {
  constexpr std::size_t kLeast = 8000;
  const std::size_t stride = std::max<std::size_t>(1, terms.size() / kLeast);
  BeamCoupling coupling = BeamCoupling::Zero(6, beams.count());
  for (std::size_t i = 0; i < terms.size(); i += stride) {
    const Term& term = terms[i];
    const Eigen::Vector3d normal = term.row.head<3>();
    const Vector6d weighted = static_cast<double>(stride) * term.weight / variance * term.row;
    if (!beams.source.empty())
      add_point(beams.source, 0, term.source_point, rotation.transpose() * normal, weighted, coupling);
    if (!beams.target.empty()) add_point(beams.target, beams.target_at, term.target_point, normal, -weighted, coupling);
  }
  return coupling;
}

// Sum of n n' over the points of a block, by planarity (0 where there is no point).
Eigen::Matrix3f facing_of(const PointBlock& block) {
  float xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  for (int i = 0; i < kBlockSize; ++i) {
    const float x = block.planarity[i] * block.nx[i], y = block.planarity[i] * block.ny[i],
                z = block.planarity[i] * block.nz[i];
    xx += x * block.nx[i], xy += x * block.ny[i], xz += x * block.nz[i];
    yy += y * block.ny[i], yz += y * block.nz[i], zz += z * block.nz[i];
  }
  Eigen::Matrix3f sum;
  sum << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return sum;
}

// The share of the source's surfaces that lie on a surface of the target, by the directions they face.
double agreement_of(const PreparedCloud& source, const RigidTransform& target_from_source,
                    const std::vector<Term>& terms) {
  constexpr double kOnSurface_m = 0.1;
  Eigen::Matrix3d all = Eigen::Matrix3d::Zero(), met = Eigen::Matrix3d::Zero();
  for (const PointBlock& block : source.tree().blocks()) all += facing_of(block).cast<double>();
  all = target_from_source.linear() * all * target_from_source.linear().transpose();
  for (const Term& term : terms) {
    const double ratio = term.residual_m / kOnSurface_m;
    const double weight = term.source_planarity / ((1.0 + ratio * ratio) * (1.0 + ratio * ratio));
    const Eigen::Vector3d normal = term.row.head<3>();
    for (int i = 0; i < 3; ++i) met.col(i) += weight * normal[i] * normal;
  }
  const auto eigen = symmetric_eigen(all);
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d direction = eigen.eigenvectors().col(axis);
    // Directions that next to nothing faces say little.
    const double whole = eigen.eigenvalues()[axis] + 0.02 * eigen.eigenvalues()[2];
    sum += whole > 0.0 ? direction.dot(met * direction) / whole : 0.0;
  }
  return sum / 3.0;
}

AlignmentEquations equations_of(const PreparedCloud& source, const PreparedCloud& target,
                                const RigidTransform& target_from_source, double max_correspondence_m,
                                const Progress& progress, const BeamColumns& beams) {
  const auto radius_m = static_cast<float>(max_correspondence_m);
  std::vector<float> residuals2_m2;
  std::vector<Term> terms = residual_terms(source, target, target_from_source, radius_m, progress, residuals2_m2);
  AlignmentEquations equations;
  if (terms.empty() || progress.cancelled()) return equations;
  equations.agreement = agreement_of(source, target_from_source, terms);
  const double kernel_m = robust_kernel_m(residuals2_m2, kSmallestKernel_m, 0.5f * radius_m);
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
  constexpr double kLeastResidual_m = 0.005;  // exact data must not have infinite weight
  const double variance = std::max(equations.rmse_m * equations.rmse_m, kLeastResidual_m * kLeastResidual_m);
  for (const Term& term : terms) {
    equations.hessian.noalias() += term.weight / variance * term.row * term.row.transpose();
    equations.gradient.noalias() += term.weight / variance * term.residual_m * term.row;
  }
  if (beams.any())
    equations.beam_response = -damped(equations.hessian)
                                   .ldlt()
                                   .solve(beam_coupling(beams, terms, target_from_source.linear(), variance))
                                   .cast<float>();
  equations.undetermined = undetermined_of(terms);
  equations.information = equations.undetermined.removed_from(information_of(equations, terms, variance));
  return equations;
}

}  // namespace

AlignmentEquations alignment_equations(const PreparedCloud& source, const PreparedCloud& target,
                                       const RigidTransform& target_from_source, double max_correspondence_m,
                                       const Progress& progress, const cloud::BeamNodes& beam_nodes) {
  return equations_of(source, target, target_from_source, max_correspondence_m, progress, {beam_nodes, beam_nodes, 0});
}

AlignmentEquations alignment_equations_across(const PreparedCloud& source, const PreparedCloud& target,
                                              const RigidTransform& target_from_source, double max_correspondence_m,
                                              const Progress& progress, const cloud::BeamNodes& source_nodes,
                                              const cloud::BeamNodes& target_nodes) {
  return equations_of(source, target, target_from_source, max_correspondence_m, progress,
                      {source_nodes, target_nodes, source_nodes.empty() ? 0 : source_nodes.errors()});
}

Vector6d damped_step(const AlignmentEquations& equations) {
  return damped(equations.hessian).ldlt().solve(-equations.gradient);
}

}  // namespace remount::registration
