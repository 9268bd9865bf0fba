#include "model/simulator/packet_shots.h"

#include <cmath>

namespace remount::simulator {

namespace {

constexpr int kWholeTurn = 36000;  // hundredths of a degree

}  // namespace

PacketShots::PacketShots(const Scene& scene, std::size_t packet, double begins_s, int rings)
    : options_(scene.options()),
      truth_(draw_lidar_truth(options_, rings)),
      scatter_(options_, packet),
      around_(scene, begins_s) {}

void PacketShots::move_to(double time_s) {
  if (options_.motion_distortion) around_.move_to(time_s);
}

void PacketShots::fire(const Shot& shot) {
  const auto direction = [&](double elevation_rad) -> Eigen::Vector3d {
    return std::cos(elevation_rad) * shot.level_direction + std::sin(elevation_rad) * Eigen::Vector3d::UnitZ();
  };
  const auto ring = static_cast<std::size_t>(shot.ring);
  around_.begin_beams_at(shot.begins_m);
  const auto found = scatter_.next(around_, direction(shot.elevation_rad + truth_.elevation_error_rad(ring)));
  if (!found) return;
  const double range_m = truth_.measured_range_m(ring, found->range_m) + found->noise_m;
  returns_.push_back({shot.block, shot.laser, shot.ring, shot.time_s, range_m, found->reflectance,
                      range_m * direction(shot.elevation_rad) + shot.begins_m});
}

int head_azimuth(const SimulationOptions& options, double time_s) {
  const double turns = options.scan_rate_hz * time_s;
  return static_cast<int>(std::lround(kWholeTurn * (turns - std::floor(turns)))) % kWholeTurn;
}

double head_rate(int from_azimuth, int to_azimuth, double within_s) {
  return (to_azimuth - from_azimuth + kWholeTurn) % kWholeTurn / within_s;
}

Eigen::Vector3d level_direction_clockwise(double from_x_rad) {
  return {std::cos(from_x_rad), -std::sin(from_x_rad), 0.0};
}

}  // namespace remount::simulator
