// What chance does to single ranges of a LiDAR: noise, loss, edges, rain.
#pragma once

#include <optional>

#include "model/simulator/random_stream.h"
#include "model/simulator/surroundings.h"

namespace remount::simulator {

/// Shorter ranges are not measured.
inline constexpr double kNearestRange_m = 0.5;

/// What a beam with a width meets.
struct Footprint {
  double tan_incidence = 0.0;        ///< of the beam to the surface's normal, at most that of 80 degrees
  double near_m = 0.0, far_m = 0.0;  ///< the surfaces at an edge; the same where there is none
  bool on_edge() const { return far_m > near_m; }
};

/// From rays at the beam's rim.
/// @param hit of the beam's middle
Footprint look_at_footprint(const Surroundings& around, const Eigen::Vector3d& direction_in_lidar, const RayHit& hit,
                            double divergence_rad);

/// 1-sigma, m, of the range to a surface: the LiDAR's own noise, that of a dark surface, and what the beam's width adds
/// where it falls aslant. The reflectance is that of the surface, of one.
double range_sigma_m(const SimulationOptions& options, double range_m, double reflectance, double tan_incidence);

/// What rain does to a beam; the rate in mm/h, 0: nothing.
double rain_loss_share(double rate_mmph, double range_m);  ///< of returns from there that get lost
double rain_drop_share(double rate_mmph);                  ///< of beams that a drop near the sensor returns

/// Of one scan, firing by firing.
class RangeScatter {
 public:
  RangeScatter(const SimulationOptions& options, std::size_t scan);

  struct Return {
    double range_m = 0.0;  ///< to what has returned the beam
    double noise_m = 0.0;
    float reflectance = 0.0f;
  };
  /// Nothing where no return comes back. Numbers are drawn for every firing, so that one object more or less does not
  /// change the noise of all others; noise, edges and rain have streams of their own for the same reason.
  std::optional<Return> next(const Surroundings& around, const Eigen::Vector3d& direction_in_lidar);

 private:
  void mix(const Footprint& footprint, RayHit& hit);
  bool rain_takes(RayHit& hit);

  const SimulationOptions& options_;
  RandomStream noise_, edges_, rain_;
};

}  // namespace remount::simulator
