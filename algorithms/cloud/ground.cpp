#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/cloud/level_frame.h"
#include "algorithms/cloud/objects.h"
#include "algorithms/core/index.h"

namespace remount::cloud {

using Eigen::Vector3f;

namespace {

constexpr float kReach_m = 100.0f;  ///< ground is mapped this far from the sensor; beyond, the edge goes on
constexpr float kStep_m = 0.1f;     ///< a kerb, roughness
constexpr float kSteepest = 0.15f;  ///< slope against the level frame
constexpr float kLongestUnseen_m = 8.0f;
constexpr float kBlind_m = 3.0f;  ///< most sensors see no ground nearer than this
constexpr float kSeedRadius_m = 6.0f;
constexpr int kEnoughPoints = 8;  ///< from here on a cell's lowest point may be a stray below the ground

/// Height of the ground in cells of the level plane around the sensor.
class GroundMap {
 public:
  GroundMap(const std::vector<Vector3f>& points_level, float cell_m)
      : cell_m_(cell_m), side_(2 * static_cast<int>(std::ceil(kReach_m / cell_m)) + 1) {
    collect(points_level);
    grow(seed_height());
  }

  float height_m(const Vector3f& p) const { return ground_[index(p)].height_m; }

 private:
  struct Lowest {
    float first = std::numeric_limits<float>::infinity(), second = first;
    int count = 0;
    float robust() const { return count >= kEnoughPoints ? second : first; }
  };

  struct Known {
    float height_m = std::numeric_limits<float>::quiet_NaN();
    float unseen_m = 0.0f;  ///< how far back ground was really seen
  };

  std::size_t at(int column, int row) const { return cell_at(row, column, side_); }

  std::size_t index(const Vector3f& p) const {
    const auto along = [&](float v) {
      const float cell = std::floor(v / cell_m_) + static_cast<float>(side_ / 2);
      // Also for what is not a number.
      return cell > 0.0f ? static_cast<int>(std::min(cell, static_cast<float>(side_ - 1))) : 0;
    };
    return at(along(p.x()), along(p.y()));
  }

  float distance_m(int column, int row) const {
    return cell_m_ * static_cast<float>(std::max(std::abs(column - side_ / 2), std::abs(row - side_ / 2)));
  }

  void collect(const std::vector<Vector3f>& points_level) {
    lowest_.resize(cell_count(side_, side_));
    for (const Vector3f& p : points_level) {
      Lowest& cell = lowest_[index(p)];
      ++cell.count;
      if (p.z() < cell.first) {
        cell.second = cell.first;
        cell.first = p.z();
      } else if (p.z() < cell.second) {
        cell.second = p.z();
      }
    }
  }

  /// Ground near the vehicle: the lower quartile of the cells' lowest points, as most cells around a vehicle show
  /// ground.
  float seed_height() const {
    std::vector<float> heights;
    for (float radius_m = kSeedRadius_m; heights.size() < 20 && radius_m <= kReach_m; radius_m *= 2.0f) {
      heights.clear();
      for (int row = 0; row < side_; ++row)
        for (int column = 0; column < side_; ++column) {
          const Lowest& lowest = lowest_[at(column, row)];
          if (lowest.count > 0 && distance_m(column, row) < radius_m) heights.push_back(lowest.robust());
        }
    }
    if (heights.empty()) return 0.0f;
    const auto quartile = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 4);
    std::nth_element(heights.begin(), quartile, heights.end());
    return *quartile;
  }

  /// From the vehicle outwards, ring by ring.
  void grow(float seed_m) {
    ground_.assign(lowest_.size(), {});
    const int middle = side_ / 2;
    for (int ring = 0; ring <= middle; ++ring) {
      for (int column = middle - ring; column <= middle + ring; ++column) {
        settle(column, middle - ring, seed_m);
        settle(column, middle + ring, seed_m);
      }
      for (int row = middle - ring + 1; row < middle + ring; ++row) {
        settle(middle - ring, row, seed_m);
        settle(middle + ring, row, seed_m);
      }
    }
  }

  /// A cell's lowest point is ground where a slope that can be driven leads to it from the last ground seen on the way
  /// from the vehicle; otherwise something stands there, or nothing was seen, and the ground goes on level.
  void settle(int column, int row, float seed_m) {
    Known known = known_around(column, row, seed_m);
    const Lowest& lowest = lowest_[at(column, row)];
    const float margin_m = kStep_m + kSteepest * (known.unseen_m + 1.5f * cell_m_);
    if (lowest.count > 0 && std::abs(lowest.robust() - known.height_m) <= margin_m)
      known = {lowest.robust(), 0.0f};
    else
      known.unseen_m = std::min(known.unseen_m + cell_m_, kLongestUnseen_m);
    ground_[at(column, row)] = known;
  }

  Known known_around(int column, int row, float seed_m) const {
    if (distance_m(column, row) < kBlind_m) return {seed_m, kBlind_m};
    float sum = 0.0f;
    Known known{seed_m, kLongestUnseen_m};
    int count = 0;
    for (int y = std::max(0, row - 1); y <= std::min(side_ - 1, row + 1); ++y)
      for (int x = std::max(0, column - 1); x <= std::min(side_ - 1, column + 1); ++x) {
        const Known& neighbour = ground_[at(x, y)];
        if (std::isnan(neighbour.height_m)) continue;
        // What was seen most recently decides; what was only carried on does not dilute it.
        if (neighbour.unseen_m < known.unseen_m || count == 0) {
          known.unseen_m = neighbour.unseen_m;
          sum = 0.0f;
          count = 0;
        }
        if (neighbour.unseen_m > known.unseen_m) continue;
        sum += neighbour.height_m;
        ++count;
      }
    if (count > 0) known.height_m = sum / static_cast<float>(count);
    return known;
  }

  float cell_m_;
  int side_;
  std::vector<Lowest> lowest_;
  std::vector<Known> ground_;
};

}  // namespace

std::vector<bool> ground_mask(const PointCloud& cloud_in_lidar, const Vector3f& up_in_lidar,
                              const ObjectOptions& options) {
  const Eigen::Matrix3f level = level_from_lidar(up_in_lidar);
  std::vector<Vector3f> points(cloud_in_lidar.size());
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = level * cloud_in_lidar.points[i];
  const GroundMap map(points, static_cast<float>(options.ground_cell_m));
  const float highest = static_cast<float>(options.ground_height_m);
  std::vector<bool> mask(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) mask[i] = points[i].z() < map.height_m(points[i]) + highest;
  return mask;
}

}  // namespace remount::cloud
