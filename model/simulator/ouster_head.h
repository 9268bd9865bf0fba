// An Ouster OS1 with 32 beams in the simulated world, column by column: written apart from the decoder of its packets,
// or an error in one would hide in the other.
#pragma once

#include <cstdint>
#include <vector>

#include "model/simulator/lidar_truth.h"
#include "model/simulator/scene.h"

namespace remount::simulator {

inline constexpr int kHeadBeams = 32, kHeadColumns = 1024, kHeadColumnsInPacket = 16;
/// Of the head above the housing's frame, and of where beams begin ahead of the head's axis.
inline constexpr double kHeadHeight_m = 0.03618, kHeadBeamsAhead_m = 0.015806;

/// Of a beam, from the highest on: degrees above the horizon, and beside the encoder's angle, both clockwise.
double head_elevation_deg(int beam);
double head_azimuth_deg(int beam);

/// One shot that came back. LiDAR frame: that of the housing, x ahead, y left, z up.
struct HeadReturn {
  int column = 0;        ///< in the packet
  int beam = 0;          ///< 0 is the highest
  double time_s = 0.0;   ///< since the start of the drive, on the INS clock
  double range_m = 0.0;  ///< as the sensor counts it, from the axis
  float reflectance = 0.0f;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< as the sensor takes it to be
};

/// How many packets a drive takes.
std::size_t head_packets(const SimulationOptions& options);
/// Of a column of a packet, since the start of the drive.
double head_column_time_s(const SimulationOptions& options, std::size_t packet, int column);
/// What comes back from the 512 shots of a packet, by the errors of ranges that the drive's LiDAR has.
std::vector<HeadReturn> head_returns(const Scene& scene, std::size_t packet);

}  // namespace remount::simulator
