// An RS-Helios in the simulated world, round by round: written apart from the decoder of its packets, or an error in
// one would hide in the other.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/simulator/lidar_truth.h"
#include "model/simulator/scene.h"

namespace remount::simulator {

inline constexpr int kHeliosLasers = 32, kHeliosRoundsInPacket = 12;
inline constexpr double kHeliosRound_s = 55.56e-6, kHeliosLaser_s = 1.73e-6;
inline constexpr double kHeliosPacket_s = kHeliosRoundsInPacket * kHeliosRound_s;

/// Where its lasers look, hundredths of a degree: up, and clockwise from the azimuth of the head.
struct HeliosLaser {
  int elevation = 0, offset = 0;
};
const std::array<HeliosLaser, kHeliosLasers>& helios_lasers();

/// One shot that came back. LiDAR frame: x ahead, y left, z up.
struct HeliosReturn {
  int round = 0;        ///< in the packet
  int laser = 0;        ///< in the order in which they fire
  int ring = 0;         ///< 0 is the lowest
  double time_s = 0.0;  ///< since the start of the drive, on the INS clock
  double range_m = 0.0;
  float reflectance = 0.0f;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< as the sensor takes it to be
};

/// How many packets a drive takes.
std::size_t helios_packets(const SimulationOptions& options);
/// Azimuth at a round of a packet, as the sensor states it: hundredths of a degree, clockwise, 0 ahead when the drive
/// begins.
int helios_azimuth(const SimulationOptions& options, std::size_t packet, int round);
/// What comes back from the 384 shots of a packet, by the errors of ranges that the drive's LiDAR has.
std::vector<HeliosReturn> helios_returns(const Scene& scene, std::size_t packet);

}  // namespace remount::simulator
