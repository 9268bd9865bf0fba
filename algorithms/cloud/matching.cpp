#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "algorithms/cloud/objects.h"
#include "algorithms/core/index.h"
#include "algorithms/core/median.h"

namespace remount::cloud {

using Eigen::Vector3f;

namespace {

constexpr float kStandingOverlap = 0.7f;  ///< what is found again so far at its old place has not moved

/// An object of scan a where it is predicted in scan b.
struct Predicted {
  Vector3f centroid_in_b = Vector3f::Zero();
  std::vector<Vector3f> outline_in_b;
};

std::vector<Predicted> predict(const std::vector<SceneObject>& objects, const RigidTransform& b_from_a) {
  const Eigen::Isometry3f motion = b_from_a.cast<float>();
  std::vector<Predicted> result;
  for (const SceneObject& object : objects) {
    Predicted at{motion * object.centroid_in_lidar, {}};
    for (const Vector3f& p : object.outline_in_lidar) at.outline_in_b.push_back(motion * p);
    result.push_back(std::move(at));
  }
  return result;
}

/// How unlike two shapes are; what is partly hidden changes its class to a neighbouring one. Above 1: not the same
/// object.
float unlikeness(ObjectShape a, ObjectShape b) {
  if (a == b) return 0.0f;
  const auto either = [&](ObjectShape first, ObjectShape second) {
    return (a == first && b == second) || (a == second && b == first);
  };
  if (either(ObjectShape::Facade, ObjectShape::Large) || either(ObjectShape::Pole, ObjectShape::Small)) return 0.2f;
  if (a == ObjectShape::Pole || b == ObjectShape::Pole) return 2.0f;
  return 0.5f;
}

float unlikeness(const SceneObject& a, const SceneObject& b) {
  // Extents below a decimetre are noise; of the others the ratio counts.
  const Eigen::Array3f ratio = ((a.extent_m.array() + 0.1f) / (b.extent_m.array() + 0.1f)).log().abs();
  return unlikeness(a.shape, b.shape) + 0.5f * ratio.maxCoeff();
}

struct Association {
  std::size_t a = 0, b = 0;
};

/// One to one, cheapest first.
std::vector<Association> associate(const std::vector<SceneObject>& objects_a, const std::vector<SceneObject>& objects_b,
                                   const std::vector<Predicted>& at, const Vector3f& common, float farthest_m) {
  constexpr float kMostUnlike = 1.2f;
  std::vector<std::tuple<float, std::size_t, std::size_t>> costs;
  for (std::size_t a = 0; a < objects_a.size(); ++a)
    for (std::size_t b = 0; b < objects_b.size(); ++b) {
      const float distance = (objects_b[b].centroid_in_lidar - at[a].centroid_in_b - common).norm() / farthest_m;
      if (!(distance <= 1.0f)) continue;
      const float unlike = unlikeness(objects_a[a], objects_b[b]);
      if (unlike <= kMostUnlike) costs.emplace_back(distance + unlike, a, b);
    }
  std::sort(costs.begin(), costs.end());
  std::vector<bool> used_a(objects_a.size(), false), used_b(objects_b.size(), false);
  std::vector<Association> result;
  for (const auto& [cost, a, b] : costs) {
    if (used_a[a] || used_b[b]) continue;
    used_a[a] = used_b[b] = true;
    result.push_back({a, b});
  }
  return result;
}

/// Median displacement of the associated objects from where they were predicted, axis by axis. Objects whose middle
/// depends on what is visible of them count only where there is nothing better.
Vector3f common_displacement(const std::vector<Association>& associations, const std::vector<SceneObject>& objects_b,
                             const std::vector<SceneObject>& objects_a, const std::vector<Predicted>& at) {
  std::array<std::vector<float>, 3> all, compact;
  for (const auto& [a, b] : associations) {
    const Vector3f d = objects_b[b].centroid_in_lidar - at[a].centroid_in_b;
    const bool is_compact = objects_a[a].shape == ObjectShape::Pole || objects_a[a].shape == ObjectShape::Small;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float along = d[signed_of(axis)];
      all[axis].push_back(along);
      if (is_compact) compact[axis].push_back(along);
    }
  }
  Vector3f median = Vector3f::Zero();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<float>& values = compact[0].size() >= 5 ? compact[axis] : all[axis];
    if (values.empty()) continue;
    median[signed_of(axis)] = median_of(values);  // a copy: the others are judged by how many these are
  }
  return median;
}

/// How far an object has moved at least. What is visible of it changes with the place it is seen from, but of a
/// standing object one end stays along each of its axes; of a moving one both ends and the middle move together.
float least_displacement_m(const Predicted& from, const SceneObject& to, const Vector3f& common) {
  Vector3f mean = Vector3f::Zero();
  for (const Vector3f& p : to.outline_in_lidar) mean += p;
  mean /= static_cast<float>(to.outline_in_lidar.size());
  Eigen::Matrix3f moments = Eigen::Matrix3f::Zero();
  for (const Vector3f& p : to.outline_in_lidar) moments += (p - mean) * (p - mean).transpose();
  const Eigen::Matrix3f axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f>(moments).eigenvectors();
  const auto bounds = [&](const std::vector<Vector3f>& outline, const Vector3f& shift) {
    Eigen::Matrix<float, 3, 2> box;
    box.col(0).setConstant(1e9f);
    box.col(1).setConstant(-1e9f);
    for (const Vector3f& p : outline) {
      const Vector3f q = axes.transpose() * (p + shift);
      box.col(0) = box.col(0).cwiseMin(q);
      box.col(1) = box.col(1).cwiseMax(q);
    }
    return box;
  };
  const Eigen::Matrix<float, 3, 2> change =
      bounds(to.outline_in_lidar, Vector3f::Zero()) - bounds(from.outline_in_b, common);
  Vector3f least = Vector3f::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    const float low = change(axis, 0), high = change(axis, 1);
    if (low * high > 0.0f) least[axis] = std::min(std::abs(low), std::abs(high));
  }
  return least.norm();
}

/// Share of the points that lie near a point of any of the outlines.
template <class Outlines>
float covered_share(const std::vector<Vector3f>& points, const Vector3f& shift, const Outlines& outlines) {
  constexpr float kNear_m = 0.3f;
  int count = 0;
  for (const Vector3f& p : points) {
    const Vector3f at = p + shift;
    const auto near = [&](const Vector3f& q) { return (at - q).squaredNorm() < kNear_m * kNear_m; };
    count += std::any_of(outlines.begin(), outlines.end(), [&](const std::vector<Vector3f>* outline) {
      return std::any_of(outline->begin(), outline->end(), near);
    });
  }
  return static_cast<float>(count) / static_cast<float>(points.size());
}

/// Whether something stands in the other scan where the object is in this one, of either scan: what stands shows at
/// least a part of the same surface in both, even where occlusion cuts it into other pieces.
bool stands(const Predicted& from, const SceneObject& to, const Vector3f& common, const std::vector<Predicted>& all_a,
            const std::vector<SceneObject>& all_b) {
  constexpr float kFar_m = 15.0f;
  std::vector<const std::vector<Vector3f>*> in_a, in_b;
  for (const Predicted& a : all_a)
    if ((a.centroid_in_b - from.centroid_in_b).norm() < kFar_m) in_a.push_back(&a.outline_in_b);
  for (const SceneObject& b : all_b)
    if ((b.centroid_in_lidar - to.centroid_in_lidar).norm() < kFar_m) in_b.push_back(&b.outline_in_lidar);
  return covered_share(from.outline_in_b, common, in_b) > kStandingOverlap ||
         covered_share(to.outline_in_lidar, -common, in_a) > kStandingOverlap;
}

}  // namespace

std::vector<ObjectMatch> match_objects(const std::vector<SceneObject>& objects_a,
                                       const std::vector<SceneObject>& objects_b,
                                       const RigidTransform& lidar_b_from_lidar_a, const ObjectOptions& options) {
  const std::vector<Predicted> at = predict(objects_a, lidar_b_from_lidar_a);
  const float farthest_m = static_cast<float>(options.association_distance_m);
  // Twice: once to see by how much the prediction is off for all, then where they are expected with that.
  Vector3f common = Vector3f::Zero();
  std::vector<Association> associations = associate(objects_a, objects_b, at, common, farthest_m);
  common = common_displacement(associations, objects_b, objects_a, at);
  associations = associate(objects_a, objects_b, at, common, farthest_m);
  common = common_displacement(associations, objects_b, objects_a, at);
  std::vector<ObjectMatch> matches;
  for (const Association& pair : associations) {
    const SceneObject& b = objects_b[pair.b];
    const ObjectShape shape = objects_a[pair.a].shape;
    const float displacement = least_displacement_m(at[pair.a], b, common);
    // Buildings do not move; their visible part does.
    const bool can_move = shape != ObjectShape::Facade && b.shape != ObjectShape::Facade &&
                          shape != ObjectShape::Large && b.shape != ObjectShape::Large;
    const bool moving = can_move && displacement > static_cast<float>(options.moving_distance_m) &&
                        !stands(at[pair.a], b, common, at, objects_b);
    matches.push_back({pair.a, pair.b, moving, static_cast<double>(displacement)});
  }
  std::sort(matches.begin(), matches.end(),
            [](const ObjectMatch& x, const ObjectMatch& y) { return x.object_a < y.object_a; });
  return matches;
}

}  // namespace remount::cloud
