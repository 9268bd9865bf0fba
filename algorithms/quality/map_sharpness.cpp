#include "algorithms/quality/map_sharpness.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

#include "algorithms/core/index.h"
#include "algorithms/core/parallel.h"
#include "algorithms/geometry/rotation.h"
#include "algorithms/quality/sharpness_limits.h"
#include "algorithms/registration/lanes.h"

namespace remount::quality {
namespace {

using Eigen::Vector3f;

// Some of the points of a grid, side by side.
struct PointRange {
  std::size_t first, last;
};

// All points of a map under one X, sorted by the cells of a grid whose edge is the radius.
class PointGrid {
 public:
  PointGrid(const MapScans& map, const RigidTransform& ins_from_lidar, double radius_m)
      : cell_m_(static_cast<float>(radius_m)) {
    std::vector<Vector3f> points;
    std::vector<std::size_t> scans;
    const Eigen::Vector3d origin = map.local_from_ins.front().translation();
    for (std::size_t s = 0; s < map.points_in_lidar.size(); ++s) {
      RigidTransform from_lidar = map.local_from_ins[s] * ins_from_lidar;
      from_lidar.translation() -= origin;
      const Eigen::Isometry3f single = from_lidar.cast<float>();
      for (const Vector3f& p : map.points_in_lidar[s]) points.push_back(single * p);
      scans.resize(points.size(), s);
    }
    sort(points, scans);
  }

  std::size_t size() const { return scan.size(); }
  std::size_t cell_count() const { return cells_.size(); }
  PointRange cell(std::size_t number) const {
    return {cells_[number].first, number + 1 < cells_.size() ? cells_[number + 1].first : size()};
  }

  /// A cell and its neighbours, of which those that follow each other along x are one range.
  std::array<PointRange, 9> around(std::size_t number) const {
    std::array<PointRange, 9> out;
    std::size_t count = 0;
    const auto first_from = [&](std::uint64_t key) {
      const auto found = std::ranges::lower_bound(cells_, key, {}, &Cell::key);
      return found == cells_.end() ? size() : found->first;
    };
    for (std::uint64_t dy = 0; dy < 3; ++dy)
      for (std::uint64_t dz = 0; dz < 3; ++dz) {
        const std::uint64_t middle = cells_[number].key + (dz << 42U) + (dy << 21U) - (1ULL << 42U) - (1ULL << 21U);
        out[count++] = {first_from(middle - 1), first_from(middle + 2)};
      }
    return out;
  }

  std::vector<float> x, y, z;               // m; behind the last point as many more as are loaded at a time
  std::vector<std::size_t> scan, in_order;  // of each point, and its place in the order of the scans

 private:
  struct Cell {
    std::uint64_t key;
    std::size_t first;
  };

  // Cells that follow each other along x have keys that do; none is at the rim.
  std::uint64_t key(const Vector3f& p) const {
    constexpr float kHalf = 1 << 20;
    const auto along = [&](float v) {
      return static_cast<std::uint64_t>(std::clamp(std::floor(v / cell_m_) + kHalf, 1.0f, 2.0f * kHalf - 4.0f));
    };
    return (along(p.z()) << 42U) | (along(p.y()) << 21U) | along(p.x());
  }

  void sort(const std::vector<Vector3f>& points, const std::vector<std::size_t>& scans) {
    std::vector<std::pair<std::uint64_t, std::size_t>> sorted;
    for (std::size_t i = 0; i < points.size(); ++i) sorted.emplace_back(key(points[i]), i);
    std::sort(sorted.begin(), sorted.end());
    for (const auto& [key, i] : sorted) {
      if (cells_.empty() || cells_.back().key != key) cells_.push_back({key, scan.size()});
      x.push_back(points[i].x());
      y.push_back(points[i].y());
      z.push_back(points[i].z());
      scan.push_back(scans[i]);
      in_order.push_back(i);
    }
    for (std::vector<float>* coordinates : {&x, &y, &z}) coordinates->resize(size() + registration::kLanes);
  }

  float cell_m_;
  std::vector<Cell> cells_;
};

// The points within the radius of one, from there.
class NearPoints {
 public:
  NearPoints(const PointGrid& grid, float radius_m) : grid_(grid), radius2_m2_(radius_m * radius_m) {}

  void gather(const std::array<PointRange, 9>& ranges, std::size_t middle) {
    using registration::load;
    constexpr std::size_t kLanes = registration::kLanes;
    make_room(ranges);
    count_ = 0;
    scans_ = 0;
    const float x = grid_.x[middle], y = grid_.y[middle], z = grid_.z[middle];
    for (const PointRange& range : ranges)
      for (std::size_t i = range.first; i < range.last; i += kLanes) {
        const registration::Lanes dx = load(&grid_.x[i]) - x, dy = load(&grid_.y[i]) - y, dz = load(&grid_.z[i]) - z;
        unsigned bits = registration::bits_of(dx * dx + (dy * dy + dz * dz) <= radius2_m2_);
        if (range.last - i < kLanes) bits &= (1U << (range.last - i)) - 1U;
        for (; bits != 0; bits &= bits - 1) {
          const std::size_t at = i + static_cast<unsigned>(std::countr_zero(bits));
          x_[count_] = static_cast<double>(grid_.x[at] - x);
          y_[count_] = static_cast<double>(grid_.y[at] - y);
          z_[count_] = static_cast<double>(grid_.z[at] - z);
          scans_ |= std::uint64_t{1} << (grid_.scan[at] % 64U);
          ++count_;
        }
      }
    x_[count_] = y_[count_] = z_[count_] = 0.0;
  }

  int count() const { return static_cast<int>(count_); }
  /// Scans that they are of; of more than 64 some may pass for one.
  int scans() const { return std::popcount(scans_); }

  Eigen::Matrix3d covariance() const {
    using Two = Eigen::Array2d;  // even and odd points: half as many steps
    Two x = Two::Zero(), y = x, z = x, xx = x, xy = x, xz = x, yy = x, yz = x, zz = x;
    for (std::size_t i = 0; i < count_; i += 2) {
      const Two px = Eigen::Map<const Two>(&x_[i]), py = Eigen::Map<const Two>(&y_[i]),
                pz = Eigen::Map<const Two>(&z_[i]);
      x += px, y += py, z += pz;
      xx += px * px, xy += px * py, xz += px * pz;
      yy += py * py, yz += py * pz, zz += pz * pz;
    }
    const auto count = static_cast<double>(count_);
    const Eigen::Vector3d sum(x.sum(), y.sum(), z.sum());
    Eigen::Matrix3d squares;
    squares << xx.sum(), xy.sum(), xz.sum(), xy.sum(), yy.sum(), yz.sum(), xz.sum(), yz.sum(), zz.sum();
    return squares / count - sum * sum.transpose() / (count * count);
  }

 private:
  void make_room(const std::array<PointRange, 9>& ranges) {
    std::size_t most = 1;  // behind the last, for an odd number of points
    for (const PointRange& range : ranges) most += range.last - range.first;
    for (std::vector<double>* coordinates : {&x_, &y_, &z_})
      if (most > coordinates->size()) coordinates->resize(2 * most);
  }

  const PointGrid& grid_;
  float radius2_m2_;
  std::size_t count_ = 0;
  std::uint64_t scans_ = 0;
  std::vector<double> x_, y_, z_;  // m
};

struct Neighbourhood {
  bool valid = false;
  bool flat = false;
  double entropy = 0.0;
  double variance_m2 = 0.0;  ///< across the plane
};

Neighbourhood describe(const NearPoints& near, const SharpnessOptions& options) {
  Neighbourhood out;
  if (near.count() < options.least_points || near.scans() < options.least_scans) return out;
  Eigen::Matrix3d covariance = near.covariance();
  constexpr double kResolution_m = 1e-3;  // keeps points of an exact plane from an infinite logarithm
  covariance.diagonal().array() += kResolution_m * kResolution_m;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  const Eigen::Vector3d eigenvalues = eigen.computeDirect(covariance, Eigen::EigenvaluesOnly).eigenvalues();
  constexpr double kFlat = 0.03;  // of the next larger variance: no edge or corner
  out.valid = true;
  out.entropy = 1.5 * std::log(2.0 * kPi * std::exp(1.0)) + 0.5 * std::log(covariance.determinant());
  out.flat = eigenvalues[0] < kFlat * eigenvalues[1];
  out.variance_m2 = eigenvalues[0];
  return out;
}

// Neighbourhoods of one map under one X, in the order of the scans' points.
// @param wanted of each, whether it is looked at; the others are not valid
std::vector<Neighbourhood> describe_map(const MapScans& map, const RigidTransform& x, const SharpnessOptions& options,
                                        const std::vector<char>& wanted, int threads, const Progress& progress) {
  const PointGrid grid(map, x, options.radius_m);
  const auto stride = static_cast<std::size_t>(std::max(1, options.stride));
  std::vector<Neighbourhood> out(wanted.size());
  constexpr std::size_t kChunk = 64;
  parallel_for((grid.cell_count() + kChunk - 1) / kChunk, threads, [&](std::size_t chunk) {
    NearPoints near(grid, static_cast<float>(options.radius_m));
    const std::size_t end = std::min(grid.cell_count(), (chunk + 1) * kChunk);
    for (std::size_t cell = chunk * kChunk; cell < end && !progress.cancelled(); ++cell) {
      std::optional<std::array<PointRange, 9>> around;
      const PointRange own = grid.cell(cell);
      for (std::size_t middle = own.first; middle < own.last; ++middle) {
        const std::size_t place = grid.in_order[middle] / stride;
        if (grid.in_order[middle] % stride != 0 || !wanted[place]) continue;
        if (!around) around = grid.around(cell);
        near.gather(*around, middle);
        out[place] = describe(near, options);
      }
    }
  });
  return out;
}

// Neighbourhoods of one map under each X; only as far as they are valid under those before.
std::vector<std::vector<Neighbourhood>> describe_under_each(const MapScans& map,
                                                            const std::vector<RigidTransform>& ins_from_lidar,
                                                            const SharpnessOptions& options, int threads,
                                                            const Progress& progress) {
  std::size_t points = 0;
  for (const std::vector<Vector3f>& scan : map.points_in_lidar) points += scan.size();
  const auto stride = static_cast<std::size_t>(std::max(1, options.stride));
  std::vector<char> wanted((points + stride - 1) / stride, 1);
  std::vector<std::vector<Neighbourhood>> under;
  for (std::size_t k = 0; k < ins_from_lidar.size() && !progress.cancelled(); ++k) {
    const auto same = std::find_if(ins_from_lidar.begin(), ins_from_lidar.begin() + signed_of(k),
                                   [&](const RigidTransform& x) { return x.matrix() == ins_from_lidar[k].matrix(); });
    const std::size_t before = static_cast<std::size_t>(same - ins_from_lidar.begin());
    under.push_back(before < k ? std::vector<Neighbourhood>(under[before])
                               : describe_map(map, ins_from_lidar[k], options, wanted, threads, progress));
    for (std::size_t i = 0; i < wanted.size(); ++i) wanted[i] = wanted[i] && under.back()[i].valid;
  }
  return under;
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
    const std::vector<std::vector<Neighbourhood>> under =
        describe_under_each(map, ins_from_lidar, options, threads, progress);
    if (progress.cancelled()) return std::vector<MapSharpness>(ins_from_lidar.size());
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
