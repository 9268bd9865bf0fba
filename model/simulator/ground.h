// The ground of the simulated world: a plane, or a periodic sum of waves.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

namespace remount::simulator {

struct Ray {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();      ///< world, m
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< world, unit length
};

/// One wave of the ground. The numbers of waves per period are whole, so that the ground repeats and a drive of any
/// length needs one tile of memory.
struct GroundWave {
  int waves_x = 0;  ///< per Ground::kPeriod_m
  int waves_y = 0;
  double amplitude_m = 0.0;
  double phase_rad = 0.0;
};

class Ground {
 public:
  static constexpr double kPeriod_m = 128.0;
  static constexpr double kNoHit = std::numeric_limits<double>::infinity();

  explicit Ground(std::vector<GroundWave> waves);

  bool flat() const { return waves_.empty(); }
  /// The smooth surface that vehicles stand on. World, m.
  double height_m(double x, double y) const;
  /// The surface that rays hit: bilinear between samples of the smooth one (they differ by millimetres).
  double surface_height_m(double x, double y) const;
  /// Distance along the ray to the surface, or kNoHit beyond max_range_m. The origin lies above the ground.
  double cast(const Ray& ray, double max_range_m) const;

 private:
  static constexpr int kTile = 256;
  static constexpr double kSamplesPerMetre = kTile / kPeriod_m;

  double refine(const Ray& ray, double before, double gap_before, double at, double gap_at) const;
  double gap_m(const Ray& ray, double distance) const;

  std::vector<GroundWave> waves_;
  std::vector<float> tile_m_;
  double highest_m_ = 0.0;
  double steepest_ = 0.0;  ///< bound on the slope
};

}  // namespace remount::simulator
