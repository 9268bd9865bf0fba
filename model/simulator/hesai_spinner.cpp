#include "model/simulator/hesai_spinner.h"

#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "model/simulator/range_scatter.h"
#include "model/simulator/surroundings.h"

namespace remount::simulator {

namespace {

constexpr double kSpinnerTurn = 36000.0;  // hundredths of a degree

/// When channels fire, from the time of their block on.
double fires_after_s(int channel) { return 0.368e-6 + 1.512e-6 * channel; }

double block_time_s(std::size_t packet, int block) {
  return static_cast<double>(packet) * kSpinnerPacket_s + block * kSpinnerBlock_s;
}

}  // namespace

double spinner_elevation_deg(int channel) { return 15.0 - channel + 0.03 * (channel % 4); }
double spinner_azimuth_deg(int channel) { return 0.05 * (channel % 5) - 0.08; }

std::size_t spinner_packets(const SimulationOptions& options) {
  return static_cast<std::size_t>(options.duration_s / kSpinnerPacket_s);
}

int spinner_azimuth(const SimulationOptions& options, std::size_t packet, int block) {
  const double turns = options.scan_rate_hz * block_time_s(packet, block);
  return static_cast<int>(std::lround(kSpinnerTurn * (turns - std::floor(turns)))) % static_cast<int>(kSpinnerTurn);
}

int spinner_speed_rpm(const SimulationOptions& options) {
  return static_cast<int>(std::lround(60.0 * options.scan_rate_hz));
}

std::vector<SpinnerReturn> spinner_returns(const Scene& scene, std::size_t packet) {
  const SimulationOptions& options = scene.options();
  const LidarTruth truth = draw_lidar_truth(options, kSpinnerChannels);
  RangeScatter scatter(options, packet);
  const double deg_per_s = 6.0 * spinner_speed_rpm(options);
  Surroundings around(scene, block_time_s(packet, 0));
  std::vector<SpinnerReturn> returns;
  for (int block = 0; block < kSpinnerBlocks; ++block)
    for (int channel = 0; channel < kSpinnerChannels; ++channel) {
      const double time_s = block_time_s(packet, block) + fires_after_s(channel);
      if (options.motion_distortion && channel == 0) around.move_to(time_s);
      const double azimuth_rad = degrees_to_radians(0.01 * spinner_azimuth(options, packet, block) +
                                                    spinner_azimuth_deg(channel) + deg_per_s * fires_after_s(channel));
      const auto direction = [&](double elevation_rad) -> Eigen::Vector3d {
        const double flat = std::cos(elevation_rad);
        return {flat * std::sin(azimuth_rad), flat * std::cos(azimuth_rad), std::sin(elevation_rad)};
      };
      const double elevation_rad = degrees_to_radians(spinner_elevation_deg(channel));
      const auto ring = static_cast<std::size_t>(kSpinnerChannels - 1 - channel);
      const auto found = scatter.next(around, direction(elevation_rad + truth.elevation_error_rad(ring)));
      if (!found) continue;
      const double range_m = truth.measured_range_m(ring, found->range_m) + found->noise_m;
      returns.push_back({block, channel, time_s, range_m, found->reflectance, range_m * direction(elevation_rad)});
    }
  return returns;
}

}  // namespace remount::simulator
