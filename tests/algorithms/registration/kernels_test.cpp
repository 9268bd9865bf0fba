// What the inner loops weigh: the pull within surfaces, and surfaces that are thick.
#include "algorithms/registration/kernels.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

#include "algorithms/geometry/rotation.h"
#include "algorithms/registration/block_tree.h"

namespace remount::registration {
namespace {

std::vector<InstructionSet> both_builds() {
  std::vector<InstructionSet> sets{InstructionSet::Portable};
  if (has_fast_kernels()) sets.push_back(InstructionSet::Best);
  return sets;
}

/// One point at the origin of either scan but for `apart_m`, with these normals.
AlignmentSums sums_of_one_match(InstructionSet instructions, const Eigen::Vector3f& source_normal,
                                const Eigen::Vector3f& target_normal, const Eigen::Vector3f& apart_m) {
  PointBlock source{};
  MatchBlock match{};
  ResidualBlock residuals{};
  for (int i = 0; i < kBlockSize; ++i) {
    source.x[i] = match.target.x[i] = kFarAway_m;
    match.index[i] = -1;
  }
  const auto set = [](PointBlock& block, const Eigen::Vector3f& point, const Eigen::Vector3f& normal) {
    block.x[0] = point.x(), block.y[0] = point.y(), block.z[0] = point.z();
    block.nx[0] = normal.x(), block.ny[0] = normal.y(), block.nz[0] = normal.z();
    block.planarity[0] = 1.0f;
  };
  set(source, apart_m, source_normal);
  set(match.target, Eigen::Vector3f::Zero(), target_normal);
  match.index[0] = 0;
  SumsTask task;
  task.source = &source;
  task.matches = &match;
  task.last = 1;
  task.target_from_source = {{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}};
  task.kernel_m = 1e6f;  // no residual is large
  task.residuals = &residuals;
  AlignmentSums sums;
  kernels(instructions).accumulate(task, sums);
  return sums;
}

Eigen::Matrix3d translation_part(const AlignmentSums& sums) {
  const double* h = sums.hessian;
  Eigen::Matrix3d part;
  part << h[0], h[1], h[2], h[1], h[6], h[7], h[2], h[7], h[11];
  return part;
}

/// Plane to plane as it is written (generalized ICP): (2 I - keep (n n' + m m'))^-1, which is I / 2 without normals. Of
/// this, what the normals add along n + m counts in full, all else a tenth.
Eigen::Matrix3d expected_weight(const Eigen::Vector3d& n, const Eigen::Vector3d& m) {
  const double keep = kKeep;
  const Eigen::Matrix3d inverse =
      (2.0 * Eigen::Matrix3d::Identity() - keep * (n * n.transpose() + m * m.transpose())).inverse();
  const Eigen::Vector3d normal = (n + m).normalized();  // an eigenvector
  const Eigen::Matrix3d added = (normal.dot(inverse * normal) - 0.5) * normal * normal.transpose();
  return added + 0.1 * (inverse - added);
}

TEST(kernels, distances_within_a_surface_pull_a_tenth_of_what_plane_to_plane_says) {
  for (const InstructionSet instructions : both_builds())
    for (const double angle_rad : {0.0, 0.1, 0.5}) {
      const Eigen::Vector3f n(0.6f, 0.0f, 0.8f);
      const Eigen::Vector3f m = (so3_exp({0.0, angle_rad, 0.0}) * n.cast<double>()).cast<float>().eval();
      const Eigen::Matrix3d expected = expected_weight(m.cast<double>(), n.cast<double>());
      const Eigen::Vector3f apart_m(0.02f, 0.3f, -0.01f);
      const AlignmentSums sums = sums_of_one_match(instructions, m, n, apart_m);
      EXPECT_EQ(sums.inliers, 1.0);
      const Eigen::Matrix3d found = translation_part(sums);
      // Across both surfaces nothing but the pull within them is left: y.
      EXPECT_NEAR(found(1, 1), expected(1, 1), 1e-5) << angle_rad;
      EXPECT_LT((found - expected).norm(), 2e-3 * expected.norm()) << angle_rad << "\n" << found << "\n" << expected;
      const Eigen::Vector3d pull(sums.gradient[0], sums.gradient[1], sums.gradient[2]);
      const Eigen::Vector3d expected_pull = expected * apart_m.cast<double>();
      EXPECT_NEAR(pull.y(), expected_pull.y(), 1e-5) << angle_rad;
      EXPECT_LT((pull - expected_pull).norm(), 2e-3 * (expected.norm() * apart_m.norm())) << angle_rad;
    }
}

/// Planarity in the middle of points that scatter across a round plate, all lengths times `size`.
double planarity_of_plate(InstructionSet instructions, double thickness_m, double size) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 400; ++i) {
    const Eigen::Vector3d point(0.2 * normal(random), 0.2 * normal(random), thickness_m * normal(random));
    points.push_back((size * point + Eigen::Vector3d(0.0, 0.0, 5.0)).cast<float>());
  }
  points.emplace_back(0.0f, 0.0f, 5.0f);
  BlockTree tree(points);
  std::vector<std::int32_t> scratch(tree.blocks().size());
  NormalTask task;
  task.blocks = tree.blocks().data();
  task.last = tree.view().block_count;
  task.radius_m = static_cast<float>(size);
  task.scratch = scratch.data();
  kernels(instructions).fit_normals(tree.view(), task);
  double middle = -1.0;
  for (const PointBlock& block : tree.blocks())
    for (int i = 0; i < kBlockSize; ++i)
      if (block.x[i] == 0.0f && block.y[i] == 0.0f && block.z[i] == 5.0f) middle = block.planarity[i];
  return middle;
}

TEST(kernels, a_surface_as_thick_as_a_kerb_counts_half_of_a_thin_one_of_its_shape) {
  for (const InstructionSet instructions : both_builds()) {
    // The same shape a hundred times smaller: nothing of it is thick.
    const double thick = planarity_of_plate(instructions, 0.1, 1.0),
                 small = planarity_of_plate(instructions, 0.1, 0.01);
    ASSERT_GT(small, 0.3);
    EXPECT_NEAR(thick / small, 0.5, 0.06);  // 400 points tell their thickness to 4%
    const double thin = planarity_of_plate(instructions, 0.015, 1.0);
    EXPECT_NEAR(thin / planarity_of_plate(instructions, 0.015, 0.01), 1.0 / (1.0 + 0.15 * 0.15), 0.01);
    EXPECT_GT(thin, 0.85) << "range noise alone is no thickness";
  }
}

}  // namespace
}  // namespace remount::registration
