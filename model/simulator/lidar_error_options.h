// What is wrong with a simulated LiDAR, beside its noise and what it misses. By default nothing.
#pragma once

#include "algorithms/core/options.h"
#include "messages/simulation_options.h"

namespace remount::simulator {

/// Errors of the sensor itself. It reports points at the range that it measures, in the direction that it believes: the
/// nominal one, while the beam goes where elevation errors turn it.
struct SimulatedLidarErrors {
  double ring_elevation_deg = 0.0;
  double ring_range_m = 0.0;
  double field_angle_deg = 0.0;
  double field_range_m = 0.0;
  double elevation_offset_deg = 0.0;
  double range_offset_m = 0.0;
  double range_scale = 0.0;
  double dark_noise_m = 0.0;
  double divergence_mrad = 0.0;
  double mixed_pixels = 0.0;
  double rain_mmph = 0.0;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor({"lidar_ring_elevation_deg", "deg", kNoLabel, say::option_simulate_lidar_ring_elevation_deg, 0.0, 2.0},
            self.ring_elevation_deg);
    visitor({"lidar_ring_range_m", "m", kNoLabel, say::option_simulate_lidar_ring_range_m, 0.0, 1.0},
            self.ring_range_m);
    visitor({"lidar_field_angle_deg", "deg", kNoLabel, say::option_simulate_lidar_field_angle_deg, 0.0, 2.0},
            self.field_angle_deg);
    visitor({"lidar_field_range_m", "m", kNoLabel, say::option_simulate_lidar_field_range_m, 0.0, 1.0},
            self.field_range_m);
    visitor({"lidar_elevation_offset_deg", "deg", kNoLabel, say::option_simulate_lidar_elevation_offset_deg, -5.0, 5.0},
            self.elevation_offset_deg);
    visitor({"lidar_range_offset_m", "m", kNoLabel, say::option_simulate_lidar_range_offset_m, -1.0, 1.0},
            self.range_offset_m);
    visitor({"lidar_range_scale", "", kNoLabel, say::option_simulate_lidar_range_scale, -0.1, 0.1}, self.range_scale);
    visitor({"lidar_dark_noise_m", "m", kNoLabel, say::option_simulate_lidar_dark_noise_m, 0.0, 1.0},
            self.dark_noise_m);
    visitor({"lidar_divergence_mrad", "mrad", kNoLabel, say::option_simulate_lidar_divergence_mrad, 0.0, 20.0},
            self.divergence_mrad);
    visitor({"lidar_mixed_pixels", "", kNoLabel, say::option_simulate_lidar_mixed_pixels, 0.0, 1.0}, self.mixed_pixels);
    visitor({"lidar_rain_mmph", "mm/h", kNoLabel, say::option_simulate_lidar_rain_mmph, 0.0, 200.0}, self.rain_mmph);
  }
};

}  // namespace remount::simulator
