// Random rotations, motions and mountings with fixed seeds, for laws that hold for all of them.
#pragma once

#include <random>
#include <vector>

#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/search/scoring.h"

namespace remount::testing {

inline Eigen::Vector3d random_vector(std::mt19937_64& random, double sigma) {
  std::normal_distribution<double> normal(0.0, sigma);
  const double x = normal(random), y = normal(random), z = normal(random);
  return {x, y, z};
}

inline Vector6d random_step(std::mt19937_64& random, double translation_sigma_m, double rotation_sigma_rad) {
  Vector6d step;
  step << random_vector(random, translation_sigma_m), Eigen::Vector3d::Zero();
  step.tail<3>() = random_vector(random, rotation_sigma_rad);
  return step;
}

/// Any orientation, uniformly.
inline Eigen::Matrix3d random_rotation(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
  return Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
}

inline RigidTransform random_rigid(std::mt19937_64& random, double translation_sigma_m) {
  const Eigen::Matrix3d rotation = random_rotation(random);
  return make_rigid(rotation, random_vector(random, translation_sigma_m));
}

/// The exact Q of a P, and both as a pair.
inline search::MotionPair exact_pair(const RigidTransform& ins_b_from_ins_a, const RigidTransform& ins_from_lidar) {
  return {ins_b_from_ins_a, ins_from_lidar.inverse() * ins_b_from_ins_a * ins_from_lidar, 1.0};
}

/// Exact pairs of a vehicle's motions: metres of travel, turns of some ten degrees about `axes` (1: allowed).
inline std::vector<search::MotionPair> exact_pairs(std::mt19937_64& random, const RigidTransform& ins_from_lidar,
                                                   int count, const Eigen::Vector3d& axes = {1, 1, 1},
                                                   const Eigen::Vector3d& travel = {1, 1, 1}) {
  std::vector<search::MotionPair> pairs;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d turn = random_vector(random, 0.3).cwiseProduct(axes);
    const Eigen::Vector3d way = random_vector(random, 4.0).cwiseProduct(travel);
    pairs.push_back(exact_pair(make_rigid(so3_exp(turn), way), ins_from_lidar));
  }
  return pairs;
}

/// Metres and radians in one number, for "equal".
inline double distance_of(const RigidTransform& first, const RigidTransform& second) {
  return difference(first, second).norm();
}

}  // namespace remount::testing
