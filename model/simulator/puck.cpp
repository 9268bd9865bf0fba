#include "model/simulator/puck.h"

#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "model/simulator/range_scatter.h"
#include "model/simulator/surroundings.h"

namespace remount::simulator {

namespace {

constexpr int kTurn = 36000;  // hundredths of a degree
constexpr int kBlocks = kPuckFiringsInPacket / 2;

/// The even ones look down from -15 degrees, the odd ones up from 1, in steps of 2.
int elevation_deg(int laser) { return laser % 2 == 0 ? laser - 15 : laser; }

/// Beams cross ahead of the sensor's axis: the lowest begins highest.
double height_m(int elevation) {
  constexpr double kMm[] = {0.7, 2.2, 3.7, 5.1, 6.6, 8.1, 9.7, 11.2};  // of 1, 3, ... 15 degrees
  const double mm = kMm[(std::abs(elevation) - 1) / 2];
  return elevation > 0 ? -1e-3 * mm : 1e-3 * mm;
}

double packet_time_s(std::size_t packet) { return static_cast<double>(packet) * kPuckPacket_s; }

}  // namespace

std::size_t puck_packets(const SimulationOptions& options) {
  return static_cast<std::size_t>(options.duration_s / kPuckPacket_s);
}

int puck_block_azimuth(const SimulationOptions& options, std::size_t packet, int block) {
  const double turns = options.scan_rate_hz * (packet_time_s(packet) + 2 * block * kPuckFiring_s);
  return static_cast<int>(std::lround(kTurn * (turns - std::floor(turns)))) % kTurn;
}

std::vector<PuckReturn> puck_returns(const Scene& scene, std::size_t packet) {
  const SimulationOptions& options = scene.options();
  const LidarTruth truth = draw_lidar_truth(options, kPuckLasers);
  RangeScatter scatter(options, packet);
  const int turned =
      (puck_block_azimuth(options, packet, kBlocks - 1) - puck_block_azimuth(options, packet, 0) + kTurn) % kTurn;
  const double per_s = turned / (2.0 * (kBlocks - 1) * kPuckFiring_s);
  Surroundings around(scene, packet_time_s(packet));
  std::vector<PuckReturn> returns;
  for (int firing = 0; firing < kPuckFiringsInPacket; ++firing)
    for (int laser = 0; laser < kPuckLasers; ++laser) {
      const int up_deg = elevation_deg(laser), ring = (up_deg + 15) / 2;
      const double after_s = firing % 2 * kPuckFiring_s + laser * kPuckLaser_s;
      const double time_s = packet_time_s(packet) + firing * kPuckFiring_s + laser * kPuckLaser_s;
      const double azimuth_rad =
          degrees_to_radians(0.01 * (puck_block_azimuth(options, packet, firing / 2) + per_s * after_s));
      const auto channel = static_cast<std::size_t>(ring);
      const auto direction = [&](double elevation_rad) -> Eigen::Vector3d {
        const double flat = std::cos(elevation_rad);
        return {flat * std::cos(azimuth_rad), -flat * std::sin(azimuth_rad), std::sin(elevation_rad)};
      };
      const double elevation_rad = degrees_to_radians(up_deg);
      if (options.motion_distortion && laser == 0) around.move_to(time_s);
      around.begin_beams_at(height_m(up_deg));
      const auto found = scatter.next(around, direction(elevation_rad + truth.elevation_error_rad(channel)));
      if (!found) continue;
      const double range_m = truth.measured_range_m(channel, found->range_m) + found->noise_m;
      returns.push_back({firing, laser, ring, time_s, range_m, found->reflectance,
                         range_m * direction(elevation_rad) + height_m(up_deg) * Eigen::Vector3d::UnitZ()});
    }
  return returns;
}

}  // namespace remount::simulator
