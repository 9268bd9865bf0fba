#include "algorithms/registration/registration.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/cloud/beam_errors.h"
#include "algorithms/core/symmetric_eigen.h"
#include "algorithms/messages/render.h"
#include "tests/algorithms/support/random_motion.h"
#include "tests/algorithms/support/room.h"

namespace remount::registration {
namespace {

constexpr double kNoise_m = 0.005;
const RigidTransform kTargetFromSource = make_rigid(so3_exp({0.02, -0.03, 0.12}), {1.0, 0.4, -0.05});
const RigidTransform kStartError = make_rigid(so3_exp({0.01, 0.01, -0.02}), {0.15, -0.12, 0.08});

// What a sensor sees that stands at the origin, and from where `kTargetFromSource` takes it.
struct Scans {
  PreparedCloud source, target;
};

Scans scans_in(const std::vector<testing::Rectangle>& world, double noise_m, const RegistrationOptions& options = {}) {
  return {PreparedCloud(testing::scan_of(world, kTargetFromSource, noise_m, 1), options),
          PreparedCloud(testing::scan_of(world, RigidTransform::Identity(), noise_m, 2), options)};
}

const Scans& room_scans() {
  static const Scans scans = scans_in(testing::room(), kNoise_m);
  return scans;
}

RegistrationResult align(const Scans& scans, const RegistrationOptions& options = {}, const Progress& progress = {}) {
  return align_scans(scans.source, scans.target, kStartError * kTargetFromSource, options, progress);
}

std::string describe(const RegistrationResult& result) {
  const Vector6d error = difference(kTargetFromSource, result.target_from_source);
  return "error " + std::to_string(1000.0 * error.head<3>().norm()) + " mm, " +
         std::to_string(radians_to_degrees(error.tail<3>().norm())) + " deg; overlap " +
         std::to_string(result.quality.overlap) + ", rmse " + std::to_string(result.quality.rmse_m) + " m, " +
         std::to_string(result.quality.iterations) + " iterations; " + english(result.quality.failure);
}

cloud::PointCloud mended(cloud::PointCloud cloud, const cloud::BeamErrors& errors) {
  cloud::mend_beams(errors, cloud);
  return cloud;
}

TEST(registration, recovers_a_motion_in_a_room_to_millimetres) {
  const RegistrationResult result = align(room_scans());
  const Vector6d error = difference(kTargetFromSource, result.target_from_source);
  EXPECT_TRUE(result.quality.attempted && result.quality.converged) << describe(result);
  EXPECT_EQ(result.quality.failure, Message());
  EXPECT_LT(error.head<3>().norm(), 2e-3) << describe(result);
  EXPECT_LT(error.tail<3>().norm(), degrees_to_radians(0.01)) << describe(result);
  EXPECT_GT(result.quality.overlap, 0.8) << describe(result);
  EXPECT_LT(result.quality.rmse_m, 2.0 * kNoise_m) << describe(result);
}

TEST(registration, of_a_scan_with_itself_is_exact) {
  const PreparedCloud cloud(testing::scan_of(testing::room(), RigidTransform::Identity(), kNoise_m, 1), {});
  const RegistrationResult result = align_scans(cloud, cloud, kStartError, {}, {});
  EXPECT_TRUE(result.quality.converged);
  EXPECT_LT(testing::distance_of(result.target_from_source, RigidTransform::Identity()), 2e-6)
      << testing::distance_of(result.target_from_source, RigidTransform::Identity());
  EXPECT_GT(result.quality.overlap, 0.99);
}

TEST(registration, errors_of_many_rooms_are_as_large_as_the_information_says_within_its_scale) {
  // The information counts every point as independent, which the shared normals are not: near one is good enough.
  double sum = 0.0;
  constexpr int kRooms = 12;
  for (int i = 0; i < kRooms; ++i) {
    const PreparedCloud source(testing::scan_of(testing::room(), kTargetFromSource, kNoise_m, 10 + i), {}),
        target(testing::scan_of(testing::room(), RigidTransform::Identity(), kNoise_m, 50 + i), {});
    const RegistrationResult result = align_scans(source, target, kTargetFromSource, {}, {});
    const Vector6d error = difference(kTargetFromSource, result.target_from_source);
    sum += error.dot(result.quality.information * error);
  }
  const double scale = std::sqrt(sum / (6.0 * kRooms));
  EXPECT_GT(scale, 0.4);
  EXPECT_LT(scale, 2.5);
}

TEST(registration, a_corridor_is_weak_along_itself_and_stays_where_it_started) {
  const Scans scans = scans_in(testing::corridor(), kNoise_m);
  const RegistrationResult result = align(scans);
  const auto eigen = symmetric_eigen(result.quality.information);
  EXPECT_GT(std::abs(eigen.eigenvectors()(0, 0)), 0.98) << eigen.eigenvectors().col(0).transpose();
  EXPECT_LT(eigen.eigenvalues()[0], 0.01 * eigen.eigenvalues()[1]) << eigen.eigenvalues().transpose();
  const Vector6d error = difference(kTargetFromSource, result.target_from_source);
  EXPECT_LT(error.segment<2>(1).norm(), 3e-3) << describe(result);
  EXPECT_LT(error.tail<3>().norm(), degrees_to_radians(0.05)) << describe(result);
  EXPECT_LT(std::abs(error.x()), 0.5) << "not driven away: " << describe(result);
}

TEST(registration, says_why_there_is_no_result) {
  const Scans& scans = room_scans();
  const PreparedCloud empty({}, {});
  const RegistrationResult few = align_scans(empty, scans.target, RigidTransform::Identity(), {}, {});
  EXPECT_TRUE(few.quality.attempted);
  EXPECT_FALSE(few.quality.converged);
  EXPECT_EQ(english(few.quality.failure), "too few points with a surface: 0");
  EXPECT_FALSE(align_scans(scans.source, empty, RigidTransform::Identity(), {}, {}).quality.failure.empty());

  const RigidTransform far = make_rigid(Eigen::Matrix3d::Identity(), {500, 0, 0});
  for (int algorithm = 0; algorithm < 4; ++algorithm) {
    RegistrationOptions options;
    options.algorithm = static_cast<RegistrationAlgorithm>(algorithm);
    options.max_iterations = 5;
    const RegistrationResult apart = align_scans(scans.source, scans.target, far, options, {});
    EXPECT_FALSE(apart.quality.failure.empty()) << algorithm;
    EXPECT_LT(apart.quality.overlap, 0.01) << algorithm;
  }
  RegistrationOptions strict;
  strict.max_rmse_m = 0.001;
  EXPECT_NE(english(align(scans, strict).quality.failure).find("residual too large"), std::string::npos);
  strict.max_rmse_m = 1.0;
  strict.min_overlap = 1.0;
  EXPECT_NE(english(align(scans, strict).quality.failure).find("overlap too small"), std::string::npos);
  strict.max_iterations = 1;
  EXPECT_EQ(english(align(scans, strict).quality.failure), "registration did not converge");
}

TEST(registration, every_algorithm_of_the_list_is_selectable_and_close) {
  ASSERT_EQ(registration_methods().size(), 4U);
  RegistrationOptions options;
  const double limits_m[] = {0.002, 0.06, 0.01, 0.06};
  for (int algorithm = 0; algorithm < 4; ++algorithm) {
    options.algorithm = static_cast<RegistrationAlgorithm>(algorithm);
    const RegistrationResult result = align(room_scans(), options);
    const Vector6d error = difference(kTargetFromSource, result.target_from_source);
    EXPECT_LT(error.head<3>().norm(), limits_m[algorithm])
        << registration_methods()[static_cast<std::size_t>(algorithm)].id << ": " << describe(result);
    EXPECT_LT(error.tail<3>().norm(), degrees_to_radians(algorithm == 0 ? 0.02 : 0.5)) << describe(result);
    EXPECT_GT(result.quality.information.diagonal().minCoeff(), 0.0) << "information for every algorithm";
  }
}

TEST(registration, cancelled_is_a_result) {
  std::stop_source stop;
  stop.request_stop();
  const RegistrationResult result = align(room_scans(), {}, Progress(stop.get_token()));
  EXPECT_EQ(english(result.quality.failure), "cancelled");
  EXPECT_FALSE(result.quality.converged);
}

TEST(registration, is_the_same_from_both_builds_of_the_loops) {
  if (!has_fast_kernels()) GTEST_SKIP() << "this processor has no AVX2";
  RegistrationOptions portable;
  portable.instructions = InstructionSet::Portable;
  const RegistrationResult first = align(room_scans()), second = align(room_scans(), portable);
  const Vector6d apart = difference(first.target_from_source, second.target_from_source);
  EXPECT_LE(apart.head<3>().norm(), 1e-9) << apart.transpose();
  EXPECT_LE(apart.tail<3>().norm(), 1e-9) << apart.transpose();
  EXPECT_TRUE(first.quality.information.isApprox(second.quality.information, 1e-9));
}

TEST(registration, same_scans_same_bytes) {
  const RegistrationResult first = align(room_scans()), second = align(scans_in(testing::room(), kNoise_m));
  EXPECT_TRUE(first.target_from_source.matrix() == second.target_from_source.matrix());
  EXPECT_TRUE(first.quality.information == second.quality.information);
  EXPECT_EQ(first.quality.iterations, second.quality.iterations);
}

// Of both scans mended by these errors, and as the response to them says.
void expect_moved_as_told(const cloud::BeamNodes& nodes, const std::vector<Eigen::VectorXd>& all_values) {
  const cloud::PointCloud source = testing::scan_of(testing::room(), kTargetFromSource, 0.0, 1),
                          target = testing::scan_of(testing::room(), RigidTransform::Identity(), 0.0, 2);
  RegistrationOptions options;
  options.beam_nodes = nodes;
  const auto register_mended = [&](const cloud::BeamErrors& errors) {
    return align({PreparedCloud(mended(source, errors), {}), PreparedCloud(mended(target, errors), {})}, options);
  };
  const RegistrationResult before = register_mended({});
  for (const Eigen::VectorXd& values : all_values) {
    const RegistrationResult after = register_mended({nodes, values});
    const Vector6d moved = difference(before.target_from_source, after.target_from_source);
    const Vector6d expected = before.quality.beam_response.cast<double>() * values;
    EXPECT_LT((moved - expected).head<3>().norm(), 0.15 * expected.head<3>().norm() + 5e-5)
        << moved.transpose() << " | " << expected.transpose();
    EXPECT_LT((moved - expected).tail<3>().norm(), 0.15 * expected.tail<3>().norm() + 5e-6)
        << moved.transpose() << " | " << expected.transpose();
  }
}

TEST(alignment_equations, response_to_errors_of_the_beams_is_how_a_registration_moves) {
  EXPECT_TRUE(align(room_scans()).quality.beam_response.cols() == 0) << "nobody asked for it";
  const cloud::BeamNodes& nodes = cloud::BeamNodes::all_around();
  Eigen::VectorXd elevation = Eigen::VectorXd::Zero(nodes.errors()), range = elevation, scale = elevation;
  elevation.segment(nodes.elevation_at(0), nodes.count()).setConstant(degrees_to_radians(0.1));
  range.segment(nodes.range_at(0), nodes.count()).setConstant(0.01);
  scale[nodes.range_scale()] = 1e-3;
  expect_moved_as_told(nodes, {elevation, range, scale});
}

TEST(alignment_equations, response_to_errors_over_a_field_is_how_a_registration_moves) {
  const cloud::BeamNodes nodes({-1.4, -0.3, 0.0, 0.3, 1.4}, {-3.1, -1.5, -0.5, 0.5, 1.5, 3.1});
  Eigen::VectorXd bent = Eigen::VectorXd::Zero(nodes.errors()), raised = bent;
  for (Eigen::Index node = 0; node < nodes.count(); ++node) {
    bent[nodes.azimuth_at(node)] = 1e-3 * std::sin(2.0 * nodes.azimuth_rad(node));
    raised[nodes.elevation_at(node)] = 1e-3 * std::cos(2.0 * nodes.azimuth_rad(node));
  }
  expect_moved_as_told(nodes, {bent, raised});
}

TEST(alignment_equations, gradient_agrees_with_its_hessian_near_the_minimum) {
  // The equations are linear in the step as long as the neighbours stay: g(x + d) = g(x) + H d.
  const PreparedCloud cloud(testing::scan_of(testing::room(), RigidTransform::Identity(), 0.0, 1), {});
  std::mt19937_64 random(1);
  for (int i = 0; i < 10; ++i) {
    const Vector6d step = testing::random_step(random, 2e-4, 2e-5);
    const AlignmentEquations at = alignment_equations(cloud, cloud, perturb(RigidTransform::Identity(), step), 0.5);
    const Vector6d expected = at.hessian * step;
    EXPECT_LT((at.gradient - expected).norm(), 0.02 * expected.norm());
  }
}

}  // namespace
}  // namespace remount::registration
