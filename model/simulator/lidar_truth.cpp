#include "model/simulator/lidar_truth.h"

#include <algorithm>

#include "model/simulator/random_stream.h"

namespace remount::simulator {

namespace {

constexpr std::uint64_t kRingElevations = 40, kRingRanges = 41, kPointingField = 42, kRangeField = 44;

std::vector<double> draw_rings(int seed, std::uint64_t stream, double sigma, int channels) {
  RandomStream random(static_cast<std::uint64_t>(seed), stream);
  std::vector<double> errors;
  for (int channel = 0; channel < channels; ++channel) {
    const double drawn = random.normal();
    errors.push_back(sigma > 0.0 ? sigma * drawn : 0.0);
  }
  return errors;
}

}  // namespace

bool LidarTruth::perfect() const {
  const auto none = [](double error) { return error == 0.0; };
  return std::all_of(ring_elevation_rad.begin(), ring_elevation_rad.end(), none) &&
         std::all_of(ring_range_m.begin(), ring_range_m.end(), none) && none(elevation_offset_rad) &&
         none(range_offset_m) && none(range_scale) && !has_fields();
}

LidarTruth draw_lidar_truth(const SimulationOptions& options, int channels) {
  const SimulatedLidarErrors& errors = options.lidar_errors;
  return {draw_rings(options.seed, kRingElevations, degrees_to_radians(errors.ring_elevation_deg), channels),
          draw_rings(options.seed, kRingRanges, errors.ring_range_m, channels),
          degrees_to_radians(errors.elevation_offset_deg),
          errors.range_offset_m,
          errors.range_scale,
          PointingField(options.seed, kPointingField, degrees_to_radians(errors.field_angle_deg)),
          SmoothField(options.seed, kRangeField, errors.field_range_m)};
}

std::unique_ptr<const ScanPattern> make_scan_pattern(const SimulationOptions& options) {
  return lidar_model(options.lidar.model)
      .make({.frame_rate_hz = options.scan_rate_hz,
             .points_per_frame = options.lidar.points_per_scan,
             .beams = options.beams,
             .azimuth_steps = options.azimuth_steps,
             .clockwise = options.clockwise,
             .field_deg = options.lidar.field_deg,
             .backwards = options.lidar.backwards});
}

}  // namespace remount::simulator
