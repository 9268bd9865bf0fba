// Which of ten million points was clicked on, without looking at them all.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "algorithms/core/progress.h"
#include "widgets/scene/picking.h"

namespace remount::scene {

/// Points by the cells of a coarse grid, fine along the ground and coarse in height, as drives are flat. Holds their
/// indices, not the points.
class PointGrid {
 public:
  PointGrid() = default;
  /// Of points that are all finite. Empty where `progress` is cancelled.
  PointGrid(const std::vector<Eigen::Vector3f>& points, const Progress& progress);

  /// What nearest_to_ray finds among the points the grid was made of, given again; the ray is in their frame.
  std::optional<PickedPoint> nearest_to_ray(const std::vector<Eigen::Vector3f>& points, const PickRay& ray,
                                            double reach_px = 12.0) const;
  /// How many points the last search looked at.
  std::size_t looked_at() const { return looked_at_; }

 private:
  struct Cell {
    std::uint32_t begin = 0, end = 0;  // in order_
    Eigen::Vector3f centre_m = Eigen::Vector3f::Zero();
    float radius_m = 0.0F;  // of a ball that holds its points
  };
  void sort_into_cells(const std::vector<Eigen::Vector3f>& points, const Progress& progress);
  void measure_cells(const std::vector<Eigen::Vector3f>& points);

  std::vector<std::uint32_t> order_;  // of the points, cell by cell
  std::vector<Cell> cells_;           // that hold any
  mutable std::size_t looked_at_ = 0;
};

}  // namespace remount::scene
