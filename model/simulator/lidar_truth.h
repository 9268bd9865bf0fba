// The errors that the LiDAR of one drive has.
#pragma once

#include <vector>

#include "model/simulator/simulation_options.h"
#include "model/simulator/smooth_field.h"

namespace remount::simulator {

/// Of each channel, of the whole sensor and of the direction beside that. A beam's true elevation is its nominal one
/// and all three errors; what is measured is (1 + range_scale) times the true range, and the three other errors.
struct LidarTruth {
  std::vector<double> ring_elevation_rad, ring_range_m;
  double elevation_offset_rad = 0.0, range_offset_m = 0.0, range_scale = 0.0;

  PointingField pointing;     ///< where beams look beside that
  SmoothField range_field_m;  ///< over where they are believed to look

  double elevation_error_rad(std::size_t channel) const { return elevation_offset_rad + ring_elevation_rad[channel]; }
  double measured_range_m(std::size_t channel, double true_range_m) const {
    return true_range_m * (1.0 + range_scale) + (range_offset_m + ring_range_m[channel]);
  }
  bool has_fields() const { return !pointing.zero() || !range_field_m.zero(); }
  /// Neither directions nor ranges are wrong.
  bool perfect() const;
};

/// From the seed alone and the sizes: none changes what the other draws, and more channels change none of the
/// first ones.
LidarTruth draw_lidar_truth(const SimulationOptions& options, int channels);

/// The pattern of the chosen LiDAR.
std::unique_ptr<const ScanPattern> make_scan_pattern(const SimulationOptions& options);

}  // namespace remount::simulator
