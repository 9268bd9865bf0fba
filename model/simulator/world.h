// The simulated world: a ground with boxes and upright cylinders on it, and the rays that hit them.
#pragma once

#include <cstdint>
#include <vector>

#include "algorithms/geometry/rigid_transform.h"
#include "model/simulator/ground.h"

namespace remount::simulator {

/// Upright box, turned about z. World frame, metres.
struct Box {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double yaw_rad = 0.0;
  Eigen::Vector2d half = Eigen::Vector2d::Ones();  ///< along its own x and y
  double bottom_m = 0.0;
  double top_m = 1.0;
  float albedo = 0.5f;
};

/// Upright cylinder without caps. World frame, metres.
struct Cylinder {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius_m = 0.1;
  double bottom_m = 0.0;
  double top_m = 1.0;
  float albedo = 0.5f;
};

/// A box in any attitude. World frame, metres.
struct TiltedBox {
  RigidTransform world_from_box = RigidTransform::Identity();
  Eigen::Vector3d half = Eigen::Vector3d::Ones();
  float albedo = 0.5f;
};

struct RayHit {
  double distance_m = Ground::kNoHit;
  float albedo = 0.0f;
  bool found() const { return distance_m < Ground::kNoHit; }
};

/// A box with its rotation worked out, for many rays.
class BoxCaster {
 public:
  explicit BoxCaster(const Box& box);
  /// Shortens `hit` where the ray enters the box before it.
  void cast(const Ray& ray, double inverse_dz, RayHit& hit) const;

 private:
  double x_, y_, cosine_, sine_, half_x_, half_y_, bottom_, top_;
  float albedo_;
};

/// Shortens `hit` where the ray enters the box before it.
void cast_tilted_box(const TiltedBox& box, const Ray& ray, RayHit& hit);

class World {
 public:
  World(Ground ground, std::vector<Box> boxes, std::vector<Cylinder> cylinders);

  const Ground& ground() const { return ground_; }
  const std::vector<Box>& boxes() const { return boxes_; }
  const std::vector<Cylinder>& cylinders() const { return cylinders_; }

  /// The first surface along the ray up to max_range_m. Origins inside a box do not see that box.
  RayHit cast(const Ray& ray, double max_range_m) const;

 private:
  static constexpr double kCell_m = 3.0;

  void index_objects();
  void cast_objects(const Ray& ray, RayHit& hit) const;
  void cast_cell(std::size_t cell, const Ray& ray, double inverse_dz, double inverse_flat2, RayHit& hit) const;

  Ground ground_;
  std::vector<Box> boxes_;
  std::vector<Cylinder> cylinders_;
  std::vector<BoxCaster> casters_;
  // Uniform grid over the plane. cell_items_[cell_begin_[c]] to cell_begin_[c + 1]: boxes first by index, then
  // cylinders.
  Eigen::Vector2d grid_min_ = Eigen::Vector2d::Zero();
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> cell_begin_, cell_items_;
  std::vector<float> cell_top_m_;
};

}  // namespace remount::simulator
