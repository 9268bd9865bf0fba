#include "model/simulator/world.h"

#include <algorithm>
#include <cmath>

#include "algorithms/core/index.h"

namespace remount::simulator {

using Eigen::Vector2d;

namespace {

/// Keeps divisions finite for rays parallel to a face.
double away_from_zero(double v) { return std::abs(v) < 1e-12 ? std::copysign(1e-12, v) : v; }

/// Half extents of the axis-aligned rectangle around an object.
Vector2d reach(const Box& box) {
  const double c = std::abs(std::cos(box.yaw_rad)), s = std::abs(std::sin(box.yaw_rad));
  return {c * box.half.x() + s * box.half.y(), s * box.half.x() + c * box.half.y()};
}
Vector2d reach(const Cylinder& cylinder) { return Vector2d::Constant(cylinder.radius_m); }

void cast_cylinder(const Cylinder& cylinder, const Ray& ray, double inverse_flat2, RayHit& hit) {
  const double px = ray.origin.x() - cylinder.centre.x(), py = ray.origin.y() - cylinder.centre.y();
  const double b = (px * ray.direction.x() + py * ray.direction.y()) * inverse_flat2;
  const double c = (px * px + py * py - cylinder.radius_m * cylinder.radius_m) * inverse_flat2;
  const double discriminant = b * b - c;
  if (discriminant <= 0.0) return;
  const double distance = -b - std::sqrt(discriminant);
  if (distance <= 0.0 || distance >= hit.distance_m) return;
  const double z = ray.origin.z() + distance * ray.direction.z();
  if (z >= cylinder.bottom_m && z <= cylinder.top_m) hit = {distance, cylinder.albedo};
}

}  // namespace

BoxCaster::BoxCaster(const Box& box)
    : x_(box.centre.x()),
      y_(box.centre.y()),
      cosine_(std::cos(box.yaw_rad)),
      sine_(std::sin(box.yaw_rad)),
      half_x_(box.half.x()),
      half_y_(box.half.y()),
      bottom_(box.bottom_m),
      top_(box.top_m),
      albedo_(box.albedo) {}

void BoxCaster::cast(const Ray& ray, double inverse_dz, RayHit& hit) const {
  const double px = ray.origin.x() - x_, py = ray.origin.y() - y_;
  const double lx = cosine_ * px + sine_ * py, ly = cosine_ * py - sine_ * px;
  const double inverse_x = 1.0 / away_from_zero(cosine_ * ray.direction.x() + sine_ * ray.direction.y());
  const double inverse_y = 1.0 / away_from_zero(cosine_ * ray.direction.y() - sine_ * ray.direction.x());
  const double x1 = (-half_x_ - lx) * inverse_x, x2 = (half_x_ - lx) * inverse_x;
  const double y1 = (-half_y_ - ly) * inverse_y, y2 = (half_y_ - ly) * inverse_y;
  const double z1 = (bottom_ - ray.origin.z()) * inverse_dz, z2 = (top_ - ray.origin.z()) * inverse_dz;
  const double enter = std::max({std::min(x1, x2), std::min(y1, y2), std::min(z1, z2)});
  const double leave = std::min({std::max(x1, x2), std::max(y1, y2), std::max(z1, z2)});
  if (enter <= leave && enter > 0.0 && enter < hit.distance_m) hit = {enter, albedo_};
}

void cast_tilted_box(const TiltedBox& box, const Ray& ray, RayHit& hit) {
  const Eigen::Matrix3d box_from_world = box.world_from_box.linear().transpose();
  const Eigen::Vector3d origin = box_from_world * (ray.origin - box.world_from_box.translation());
  const Eigen::Vector3d direction = box_from_world * ray.direction;
  double enter = -Ground::kNoHit, leave = Ground::kNoHit;
  for (int axis = 0; axis < 3; ++axis) {
    const double inverse = 1.0 / away_from_zero(direction[axis]);
    const double a = (-box.half[axis] - origin[axis]) * inverse, b = (box.half[axis] - origin[axis]) * inverse;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  if (enter <= leave && enter > 0.0 && enter < hit.distance_m) hit = {enter, box.albedo};
}

World::World(Ground ground, std::vector<Box> boxes, std::vector<Cylinder> cylinders)
    : ground_(std::move(ground)), boxes_(std::move(boxes)), cylinders_(std::move(cylinders)) {
  casters_.reserve(boxes_.size());
  for (const Box& box : boxes_) casters_.emplace_back(box);
  index_objects();
}

void World::index_objects() {
  if (boxes_.empty() && cylinders_.empty()) return;
  Vector2d low = Vector2d::Constant(1e300), high = -low;
  const auto widen = [&](const auto& object) {
    low = low.cwiseMin(object.centre - reach(object));
    high = high.cwiseMax(object.centre + reach(object));
  };
  for (const Box& box : boxes_) widen(box);
  for (const Cylinder& cylinder : cylinders_) widen(cylinder);
  grid_min_ = low;
  columns_ = static_cast<int>((high.x() - low.x()) / kCell_m) + 1;
  rows_ = static_cast<int>((high.y() - low.y()) / kCell_m) + 1;
  const std::size_t cells = cell_count(rows_, columns_);
  cell_begin_.assign(cells + 1, 0);
  cell_top_m_.assign(cells, -1e30f);

  const auto for_cells_of = [&](const auto& object, auto&& body) {
    const Vector2d r = reach(object);
    const Vector2d first = (object.centre - r - grid_min_) / kCell_m, last = (object.centre + r - grid_min_) / kCell_m;
    for (int y = std::max(0, static_cast<int>(first.y())); y <= std::min(rows_ - 1, static_cast<int>(last.y())); ++y)
      for (int x = std::max(0, static_cast<int>(first.x())); x <= std::min(columns_ - 1, static_cast<int>(last.x()));
           ++x)
        body(cell_at(y, x, columns_));
  };
  const auto for_objects = [&](auto&& body) {
    std::uint32_t item = 0;
    for (const Box& box : boxes_) body(item++, box);
    for (const Cylinder& cylinder : cylinders_) body(item++, cylinder);
  };
  for_objects([&](std::uint32_t, const auto& object) {
    for_cells_of(object, [&](std::size_t cell) {
      ++cell_begin_[cell + 1];
      cell_top_m_[cell] = std::max(cell_top_m_[cell], static_cast<float>(object.top_m) + 1e-3f);
    });
  });
  for (std::size_t cell = 0; cell < cells; ++cell) cell_begin_[cell + 1] += cell_begin_[cell];
  cell_items_.resize(cell_begin_.back());
  std::vector<std::uint32_t> next(cell_begin_.begin(), cell_begin_.end() - 1);
  for_objects([&](std::uint32_t item, const auto& object) {
    for_cells_of(object, [&](std::size_t cell) { cell_items_[next[cell]++] = item; });
  });
}

RayHit World::cast(const Ray& ray, double max_range_m) const {
  RayHit hit;
  hit.distance_m = ground_.cast(ray, max_range_m);
  const bool on_ground = hit.found();
  if (!on_ground) hit.distance_m = max_range_m;
  hit.albedo = on_ground ? 0.25f : -1.0f;
  cast_objects(ray, hit);
  if (hit.albedo < 0.0f) hit.distance_m = Ground::kNoHit;
  return hit;
}

void World::cast_cell(std::size_t cell, const Ray& ray, double inverse_dz, double inverse_flat2, RayHit& hit) const {
  for (std::uint32_t i = cell_begin_[cell]; i < cell_begin_[cell + 1]; ++i) {
    const std::size_t item = cell_items_[i];
    if (item < casters_.size())
      casters_[item].cast(ray, inverse_dz, hit);
    else
      cast_cylinder(cylinders_[item - casters_.size()], ray, inverse_flat2, hit);
  }
}

void World::cast_objects(const Ray& ray, RayHit& hit) const {
  if (columns_ == 0) return;
  const double dx = away_from_zero(ray.direction.x()), dy = away_from_zero(ray.direction.y());
  const double inverse_x = 1.0 / dx, inverse_y = 1.0 / dy, inverse_dz = 1.0 / away_from_zero(ray.direction.z());
  const double inverse_flat2 = 1.0 / (dx * dx + dy * dy);
  const double px = ray.origin.x() - grid_min_.x(), py = ray.origin.y() - grid_min_.y();
  // Where the ray enters and leaves the grid.
  const double x1 = -px * inverse_x, x2 = (columns_ * kCell_m - px) * inverse_x;
  const double y1 = -py * inverse_y, y2 = (rows_ * kCell_m - py) * inverse_y;
  double distance = std::max({0.0, std::min(x1, x2), std::min(y1, y2)});
  const double leave = std::min(std::max(x1, x2), std::max(y1, y2));
  if (distance >= leave) return;
  int column = std::clamp(static_cast<int>((px + distance * dx) / kCell_m), 0, columns_ - 1);
  int row = std::clamp(static_cast<int>((py + distance * dy) / kCell_m), 0, rows_ - 1);
  const int step_x = dx > 0.0 ? 1 : -1, step_y = dy > 0.0 ? 1 : -1;
  double next_x = ((column + (dx > 0.0 ? 1 : 0)) * kCell_m - px) * inverse_x;
  double next_y = ((row + (dy > 0.0 ? 1 : 0)) * kCell_m - py) * inverse_y;
  const double delta_x = kCell_m * std::abs(inverse_x), delta_y = kCell_m * std::abs(inverse_y);
  while (distance < hit.distance_m) {
    const double exit = std::min(next_x, next_y);
    const std::size_t cell = cell_at(row, column, columns_);
    const double lowest = ray.origin.z() + ray.direction.z() * (ray.direction.z() < 0.0 ? exit : distance);
    if (lowest <= cell_top_m_[cell]) cast_cell(cell, ray, inverse_dz, inverse_flat2, hit);
    distance = exit;
    if (next_x < next_y) {
      column += step_x;
      next_x += delta_x;
      if (column < 0 || column >= columns_) return;
    } else {
      row += step_y;
      next_y += delta_y;
      if (row < 0 || row >= rows_) return;
    }
  }
}

}  // namespace remount::simulator
