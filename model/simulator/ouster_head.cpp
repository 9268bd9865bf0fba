#include "model/simulator/ouster_head.h"

#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "model/simulator/range_scatter.h"
#include "model/simulator/surroundings.h"

namespace remount::simulator {

namespace {

constexpr int kPacketsInTurn = kHeadColumns / kHeadColumnsInPacket;

}  // namespace

/// Nearly even, as those that were measured are.
double head_elevation_deg(int beam) { return 21.0 - 1.36 * beam + 0.02 * (beam % 3); }

/// The beams come from four columns of lasers.
double head_azimuth_deg(int beam) {
  constexpr double kColumns_deg[] = {4.23, 1.41, -1.42, -4.22};
  return kColumns_deg[beam % 4];
}

std::size_t head_packets(const SimulationOptions& options) {
  return static_cast<std::size_t>(std::floor(options.duration_s * options.scan_rate_hz * kPacketsInTurn + 1e-6));
}

double head_column_time_s(const SimulationOptions& options, std::size_t packet, int column) {
  const double columns = static_cast<double>(packet) * kHeadColumnsInPacket + column;
  return columns / (kHeadColumns * options.scan_rate_hz);
}

std::vector<HeadReturn> head_returns(const Scene& scene, std::size_t packet) {
  const SimulationOptions& options = scene.options();
  const LidarTruth truth = draw_lidar_truth(options, kHeadBeams);
  RangeScatter scatter(options, packet);
  Surroundings around(scene, head_column_time_s(options, packet, 0));
  std::vector<HeadReturn> returns;
  for (int column = 0; column < kHeadColumnsInPacket; ++column) {
    const double time_s = head_column_time_s(options, packet, column);
    if (options.motion_distortion) around.move_to(time_s);
    const int place = static_cast<int>(packet % kPacketsInTurn) * kHeadColumnsInPacket + column;
    // At encoder 0 beams look to the back of the housing; it counts clockwise.
    const double clockwise_deg = 180.0 + 360.0 * place / kHeadColumns;
    const auto flat = [](double deg) -> Eigen::Vector3d {
      return {std::cos(degrees_to_radians(deg)), -std::sin(degrees_to_radians(deg)), 0.0};
    };
    const Eigen::Vector3d begin = kHeadBeamsAhead_m * flat(clockwise_deg) + kHeadHeight_m * Eigen::Vector3d::UnitZ();
    around.begin_beams_at(begin);
    for (int beam = 0; beam < kHeadBeams; ++beam) {
      const auto channel = static_cast<std::size_t>(kHeadBeams - 1 - beam);
      const auto direction = [&](double elevation_rad) -> Eigen::Vector3d {
        return std::cos(elevation_rad) * flat(clockwise_deg + head_azimuth_deg(beam)) +
               std::sin(elevation_rad) * Eigen::Vector3d::UnitZ();
      };
      const double elevation_rad = degrees_to_radians(head_elevation_deg(beam));
      const auto found = scatter.next(around, direction(elevation_rad + truth.elevation_error_rad(channel)));
      if (!found) continue;
      const double from_begin_m = truth.measured_range_m(channel, found->range_m) + found->noise_m;
      returns.push_back({column, beam, time_s, from_begin_m + kHeadBeamsAhead_m, found->reflectance,
                         from_begin_m * direction(elevation_rad) + begin});
    }
  }
  return returns;
}

}  // namespace remount::simulator
