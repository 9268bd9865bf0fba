#include "algorithms/quality/map_sharpness.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>

#include "algorithms/core/parallel.h"
#include "algorithms/geometry/rotation.h"
#include "algorithms/quality/sharpness_limits.h"

namespace remount::quality {
namespace {

using Eigen::Vector3f;

// All points of a map under one X, sorted by the cells of a grid whose edge is the radius.
class PointGrid {
 public:
  PointGrid(const MapScans& map, const RigidTransform& ins_from_lidar, double radius_m)
      : cell_m_(static_cast<float>(radius_m)) {
    const Eigen::Vector3d origin = map.local_from_ins.front().translation();
    for (std::size_t s = 0; s < map.points_in_lidar.size(); ++s) {
      RigidTransform from_lidar = map.local_from_ins[s] * ins_from_lidar;
      from_lidar.translation() -= origin;
      const Eigen::Isometry3f single = from_lidar.cast<float>();
      for (const Vector3f& p : map.points_in_lidar[s]) entries_.push_back({key(single * p), single * p, s});
    }
    for (const Entry& entry : entries_) queries_.push_back(entry.point);
    std::sort(entries_.begin(), entries_.end(), [](const Entry& left, const Entry& right) {
      return std::tuple(left.key, left.scan, left.point.x(), left.point.y(), left.point.z()) <
             std::tuple(right.key, right.scan, right.point.x(), right.point.y(), right.point.z());
    });
  }

  /// The points in the order of the scans.
  const std::vector<Vector3f>& points() const { return queries_; }

  template <class Visitor>
  void visit_neighbours(const Vector3f& middle, Visitor&& visitor) const {
    const float limit2 = cell_m_ * cell_m_;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dz = -1; dz <= 1; ++dz) {
        // Cells that follow each other along x have keys that do.
        const Vector3f low = middle + cell_m_ * Vector3f(-1.0f, static_cast<float>(dy), static_cast<float>(dz));
        const std::uint64_t first = key(low), last = first + 2;
        auto entry = std::lower_bound(entries_.begin(), entries_.end(), first,
                                      [](const Entry& e, std::uint64_t k) { return e.key < k; });
        for (; entry != entries_.end() && entry->key <= last; ++entry)
          if ((entry->point - middle).squaredNorm() <= limit2) visitor(*entry);
      }
  }

  struct Entry {
    std::uint64_t key;
    Vector3f point;
    std::size_t scan;
  };

 private:
  std::uint64_t key(const Vector3f& p) const {
    constexpr float kHalf = 1 << 20;
    const auto along = [&](float v) {
      return static_cast<std::uint64_t>(std::clamp(std::floor(v / cell_m_) + kHalf, 0.0f, 2.0f * kHalf - 4.0f));
    };
    return (along(p.z()) << 42U) | (along(p.y()) << 21U) | along(p.x());
  }

  float cell_m_;
  std::vector<Entry> entries_;
  std::vector<Vector3f> queries_;
};

struct Neighbourhood {
  bool valid = false;
  bool flat = false;
  double entropy = 0.0;
  double variance_m2 = 0.0;  ///< across the plane
};

Neighbourhood describe(const PointGrid& grid, const Vector3f& middle, const SharpnessOptions& options) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  int count = 0;
  std::array<std::size_t, 8> scans{};
  std::size_t scan_count = 0;
  grid.visit_neighbours(middle, [&](const PointGrid::Entry& entry) {
    const Eigen::Vector3d p = (entry.point - middle).cast<double>();
    sum += p;
    squares += p * p.transpose();
    ++count;
    const auto end = scans.begin() + static_cast<std::ptrdiff_t>(scan_count);
    if (scan_count < scans.size() && std::find(scans.begin(), end, entry.scan) == end) scans[scan_count++] = entry.scan;
  });
  Neighbourhood out;
  if (count < options.least_points || scan_count < static_cast<std::size_t>(options.least_scans)) return out;
  Eigen::Matrix3d covariance = squares / count - sum * sum.transpose() / (static_cast<double>(count) * count);
  constexpr double kResolution_m = 1e-3;  // keeps points of an exact plane from an infinite logarithm
  covariance.diagonal().array() += kResolution_m * kResolution_m;
  const Eigen::Vector3d eigenvalues =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance, Eigen::EigenvaluesOnly).eigenvalues();
  constexpr double kFlat = 0.03;  // of the next larger variance: no edge or corner
  out.valid = true;
  out.entropy = 1.5 * std::log(2.0 * kPi * std::exp(1.0)) + 0.5 * eigenvalues.array().log().sum();
  out.flat = eigenvalues[0] < kFlat * eigenvalues[1];
  out.variance_m2 = eigenvalues[0];
  return out;
}

// Neighbourhoods of one map under one X, in the order of the scans' points.
std::vector<Neighbourhood> describe_map(const MapScans& map, const RigidTransform& x, const SharpnessOptions& options,
                                        int threads, const Progress& progress) {
  const PointGrid grid(map, x, options.radius_m);
  const auto stride = static_cast<std::size_t>(std::max(1, options.stride));
  std::vector<Neighbourhood> out((grid.points().size() + stride - 1) / stride);
  constexpr std::size_t kChunk = 256;
  parallel_for((out.size() + kChunk - 1) / kChunk, threads, [&](std::size_t chunk) {
    for (std::size_t i = chunk * kChunk; i < std::min(out.size(), (chunk + 1) * kChunk) && !progress.cancelled(); ++i)
      out[i] = describe(grid, grid.points()[i * stride], options);
  });
  return out;
}

struct Sums {
  double entropy = 0.0, variance_m2 = 0.0;
  std::size_t points = 0, flat = 0;
};

}  // namespace

std::vector<MapSharpness> compare_sharpness(const std::vector<MapScans>& maps,
                                            const std::vector<RigidTransform>& ins_from_lidar,
                                            const SharpnessOptions& options, int threads, const Progress& progress) {
  std::vector<Sums> sums(ins_from_lidar.size());
  for (const MapScans& map : maps) {
    if (map.points_in_lidar.empty()) continue;
    std::vector<std::vector<Neighbourhood>> under;
    for (const RigidTransform& x : ins_from_lidar) {
      if (progress.cancelled()) return std::vector<MapSharpness>(ins_from_lidar.size());
      under.push_back(describe_map(map, x, options, threads, progress));
    }
    for (std::size_t i = 0; !under.empty() && i < under.front().size(); ++i) {
      const auto all = [&](bool Neighbourhood::*property) {
        return std::all_of(under.begin(), under.end(), [&](const auto& one) { return one[i].*property; });
      };
      if (!all(&Neighbourhood::valid)) continue;
      // Flat under the sharpest X is flat; a wrong one thickens walls until they are not.
      const bool flat = std::any_of(under.begin(), under.end(), [&](const auto& one) { return one[i].flat; });
      for (std::size_t k = 0; k < under.size(); ++k) {
        sums[k].entropy += under[k][i].entropy;
        ++sums[k].points;
        if (!flat) continue;
        sums[k].variance_m2 += under[k][i].variance_m2;
        ++sums[k].flat;
      }
    }
  }
  std::vector<MapSharpness> out(ins_from_lidar.size());
  for (std::size_t k = 0; k < out.size() && !progress.cancelled(); ++k) {
    out[k].points = sums[k].points;
    if (sums[k].points > 0) out[k].mean_map_entropy = sums[k].entropy / static_cast<double>(sums[k].points);
    if (sums[k].flat > 0) out[k].plane_thickness_m = std::sqrt(sums[k].variance_m2 / static_cast<double>(sums[k].flat));
  }
  return out;
}

SharperUnder compare(const MapSharpness& first, const MapSharpness& second) {
  if (std::min(first.points, second.points) < kFewestPlaces) return SharperUnder::TooFewPlaces;
  if (first.plane_thickness_m > kClearlySharper * second.plane_thickness_m) return SharperUnder::Second;
  if (second.plane_thickness_m > kClearlySharper * first.plane_thickness_m) return SharperUnder::First;
  return SharperUnder::Neither;
}

}  // namespace remount::quality
