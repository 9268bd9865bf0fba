// A VLP-16 in the simulated world, firing by firing: written apart from the decoder of its packets, or an error in one
// would hide in the other.
#pragma once

#include <cstdint>
#include <vector>

#include "model/simulator/lidar_truth.h"
#include "model/simulator/scene.h"

namespace remount::simulator {

inline constexpr int kPuckLasers = 16, kPuckFiringsInPacket = 24;
inline constexpr double kPuckFiring_s = 55.296e-6, kPuckLaser_s = 2.304e-6;
inline constexpr double kPuckPacket_s = kPuckFiringsInPacket * kPuckFiring_s;

/// One shot that came back. LiDAR frame: x ahead, y left, z up.
struct PuckReturn {
  int firing = 0;       ///< in the packet
  int laser = 0;        ///< in the order in which they fire
  int ring = 0;         ///< 0 is the lowest
  double time_s = 0.0;  ///< since the start of the drive, on the INS clock
  double range_m = 0.0;
  float reflectance = 0.0f;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< as the sensor takes it to be
};

/// How many packets a drive takes.
std::size_t puck_packets(const SimulationOptions& options);
/// Azimuth at one of the 12 blocks of a packet, as the sensor states it: hundredths of a degree, clockwise, 0 ahead
/// when the drive begins.
int puck_block_azimuth(const SimulationOptions& options, std::size_t packet, int block);
/// What comes back from the 384 shots of a packet, by the errors of ranges that the drive's LiDAR has.
std::vector<PuckReturn> puck_returns(const Scene& scene, std::size_t packet);

}  // namespace remount::simulator
