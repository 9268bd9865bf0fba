#include "widgets/scene/point_grid.h"

#include <algorithm>
#include <cmath>

#include "widgets/scene/framing.h"

namespace remount::scene {
namespace {

constexpr int kAlong = 256, kUp = 16;  // cells along the ground and in height
constexpr std::size_t kPointsPerCheck = 1U << 20U;

/// The cell of each point; what lies outside belongs to the cells at the border.
class Cells {
 public:
  explicit Cells(const Framing& framing) {
    const auto edge_m = static_cast<float>(4.0 * framing.radius_m);
    low_m_ = framing.centre_m.cast<float>() - Eigen::Vector3f::Constant(0.5F * edge_m);
    per_m_ = Eigen::Vector3f(kAlong, kAlong, kUp) / edge_m;
  }
  std::size_t of(const Eigen::Vector3f& point) const {
    const Eigen::Vector3f place = ((point - low_m_).cwiseProduct(per_m_))
                                      .cwiseMax(0.0F)
                                      .cwiseMin(Eigen::Vector3f(kAlong - 1, kAlong - 1, kUp - 1));
    return (static_cast<std::size_t>(place.z()) * kAlong + static_cast<std::size_t>(place.y())) * kAlong +
           static_cast<std::size_t>(place.x());
  }
  static constexpr std::size_t kCount = std::size_t{kAlong} * kAlong * kUp;

 private:
  Eigen::Vector3f low_m_, per_m_;
};

/// The least angle to the ray that a point of a ball can have; nothing where all of it lies behind.
std::optional<double> least_angle_rad(const Eigen::Vector3d& from_camera_m, double radius_m,
                                      const Eigen::Vector3d& direction) {
  const double distance_m = from_camera_m.norm();
  if (distance_m <= radius_m) return 0.0;
  const double along_m = from_camera_m.dot(direction);
  const double angle_rad = std::atan2((from_camera_m - along_m * direction).norm(), along_m);
  const double least_rad = angle_rad - std::asin(radius_m / distance_m);
  if (least_rad >= kPi / 2.0) return std::nullopt;
  return std::max(0.0, least_rad);
}

}  // namespace

PointGrid::PointGrid(const std::vector<Eigen::Vector3f>& points, const Progress& progress) {
  if (points.empty()) return;
  sort_into_cells(points, progress);
  if (progress.cancelled()) {
    order_.clear();
    cells_.clear();
    return;
  }
  measure_cells(points);
}

void PointGrid::sort_into_cells(const std::vector<Eigen::Vector3f>& points, const Progress& progress) {
  const Cells cells(robust_framing(points, RigidTransform::Identity()));
  std::vector<std::uint32_t> next(Cells::kCount + 1, 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % kPointsPerCheck == 0 && progress.cancelled()) return;
    ++next[cells.of(points[i]) + 1];
  }
  for (std::size_t cell = 0; cell < Cells::kCount; ++cell) {
    if (next[cell + 1] > 0) cells_.push_back({next[cell], next[cell] + next[cell + 1]});
    next[cell + 1] += next[cell];
  }
  order_.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % kPointsPerCheck == 0 && progress.cancelled()) return;
    order_[next[cells.of(points[i])]++] = static_cast<std::uint32_t>(i);
  }
}

void PointGrid::measure_cells(const std::vector<Eigen::Vector3f>& points) {
  for (Cell& cell : cells_) {
    Eigen::Vector3f low_m = points[order_[cell.begin]], high_m = low_m;
    for (std::uint32_t at = cell.begin; at < cell.end; ++at) {
      low_m = low_m.cwiseMin(points[order_[at]]);
      high_m = high_m.cwiseMax(points[order_[at]]);
    }
    cell.centre_m = 0.5F * (low_m + high_m);
    cell.radius_m = 0.5F * (high_m - low_m).norm() * 1.0001F + 1e-4F;  // never too small by rounding
  }
}

std::optional<PickedPoint> PointGrid::nearest_to_ray(const std::vector<Eigen::Vector3f>& points, const PickRay& ray,
                                                     double reach_px) const {
  looked_at_ = 0;
  const Eigen::Vector3d direction = ray.direction_in_view.normalized();
  const double reach_rad = std::min(reach_px * ray.pixel_rad, 1.5);
  std::vector<std::pair<double, const Cell*>> near;  // by the least angle that a point in it can have
  for (const Cell& cell : cells_) {
    const auto least_rad = least_angle_rad(cell.centre_m.cast<double>() - ray.origin_in_view,
                                           static_cast<double>(cell.radius_m), direction);
    if (least_rad && *least_rad <= reach_rad) near.emplace_back(*least_rad, &cell);
  }
  std::sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  // Once for the smallest angle, once more for what looks like one with it: what the second asks of a cell, the first
  // has bounded.
  double least_tangent = std::tan(reach_rad);
  std::vector<Eigen::Vector3f> some;
  std::optional<PickedPoint> nearest;
  const auto look_at = [&](const Cell& cell) {
    looked_at_ += cell.end - cell.begin;
    some.clear();
    for (std::uint32_t at = cell.begin; at < cell.end; ++at) some.push_back(points[order_[at]]);
  };
  bool any = false;
  for (const auto& [least_rad, cell] : near) {
    if (std::tan(least_rad) > least_tangent) break;
    look_at(*cell);
    const auto found = least_tangent_to_ray(some, ray.origin_in_view, direction, least_tangent);
    if (!found) continue;
    least_tangent = *found;
    any = true;
  }
  if (!any) return std::nullopt;
  const double alike = least_tangent + ray.pixel_rad;
  for (const auto& [least_rad, cell] : near) {
    if (std::tan(least_rad) > alike) break;
    look_at(*cell);
    auto found = first_within(some, ray.origin_in_view, direction, alike);
    if (!found || (nearest && found->distance_m >= nearest->distance_m)) continue;
    found->index = order_[cell->begin + found->index];
    nearest = found;
  }
  return nearest;
}

}  // namespace remount::scene
