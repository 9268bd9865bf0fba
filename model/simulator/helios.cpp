#include "model/simulator/helios.h"

#include <algorithm>
#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "model/simulator/range_scatter.h"
#include "model/simulator/surroundings.h"

namespace remount::simulator {

namespace {

constexpr int kHeliosTurn = 36000;   // hundredths of a degree
constexpr double kLens_m = 0.03498;  // from the axis to where beams begin

double helios_packet_time_s(std::size_t packet) { return static_cast<double>(packet) * kHeliosPacket_s; }

int helios_ring(int laser) {
  const auto& lasers = helios_lasers();
  const int elevation = lasers[static_cast<std::size_t>(laser)].elevation;
  return static_cast<int>(std::count_if(lasers.begin(), lasers.end(),
                                        [&](const HeliosLaser& other) { return other.elevation < elevation; }));
}

}  // namespace

const std::array<HeliosLaser, kHeliosLasers>& helios_lasers() {
  static const std::array<HeliosLaser, kHeliosLasers> lasers = [] {
    constexpr int kElevations[] = {1500,  1300,  1100,  900,   700,   550,   400,   267,   133,   0,     -133,
                                   -267,  -400,  -533,  -667,  -800,  -1000, -1600, -1300, -1900, -2200, -2800,
                                   -2500, -3100, -3400, -3700, -4000, -4300, -4600, -4900, -5200, -5500};
    std::array<HeliosLaser, kHeliosLasers> made;
    for (std::size_t i = 0; i < made.size(); ++i) made[i] = {kElevations[i], i % 2 == 0 ? -403 : 361};
    return made;
  }();
  return lasers;
}

std::size_t helios_packets(const SimulationOptions& options) {
  return static_cast<std::size_t>(options.duration_s / kHeliosPacket_s);
}

int helios_azimuth(const SimulationOptions& options, std::size_t packet, int round) {
  const double turns = options.scan_rate_hz * (helios_packet_time_s(packet) + round * kHeliosRound_s);
  return static_cast<int>(std::lround(kHeliosTurn * (turns - std::floor(turns)))) % kHeliosTurn;
}

std::vector<HeliosReturn> helios_returns(const Scene& scene, std::size_t packet) {
  const SimulationOptions& options = scene.options();
  const LidarTruth truth = draw_lidar_truth(options, kHeliosLasers);
  RangeScatter scatter(options, packet);
  const int turned =
      (helios_azimuth(options, packet, kHeliosRoundsInPacket - 1) - helios_azimuth(options, packet, 0) + kHeliosTurn) %
      kHeliosTurn;
  const double per_s = turned / ((kHeliosRoundsInPacket - 1) * kHeliosRound_s);
  Surroundings around(scene, helios_packet_time_s(packet));
  std::vector<HeliosReturn> returns;
  for (int round = 0; round < kHeliosRoundsInPacket; ++round)
    for (int laser = 0; laser < kHeliosLasers; ++laser) {
      const HeliosLaser& looks = helios_lasers()[static_cast<std::size_t>(laser)];
      const double after_s = laser * kHeliosLaser_s;
      const double time_s = helios_packet_time_s(packet) + round * kHeliosRound_s + after_s;
      const double head_rad = degrees_to_radians(0.01 * (helios_azimuth(options, packet, round) + per_s * after_s));
      const double azimuth_rad = head_rad + degrees_to_radians(0.01 * looks.offset);
      const auto direction = [&](double elevation_rad) -> Eigen::Vector3d {
        const double flat = std::cos(elevation_rad);
        return {flat * std::cos(azimuth_rad), -flat * std::sin(azimuth_rad), std::sin(elevation_rad)};
      };
      const double elevation_rad = degrees_to_radians(0.01 * looks.elevation);
      const int ring = helios_ring(laser);
      const auto channel = static_cast<std::size_t>(ring);
      const Eigen::Vector3d lens = kLens_m * Eigen::Vector3d(std::cos(head_rad), -std::sin(head_rad), 0.0);
      if (options.motion_distortion && laser == 0) around.move_to(time_s);
      around.begin_beams_at(lens);
      const auto found = scatter.next(around, direction(elevation_rad + truth.elevation_error_rad(channel)));
      if (!found) continue;
      const double range_m = truth.measured_range_m(channel, found->range_m) + found->noise_m;
      returns.push_back(
          {round, laser, ring, time_s, range_m, found->reflectance, range_m * direction(elevation_rad) + lens});
    }
  return returns;
}

}  // namespace remount::simulator
