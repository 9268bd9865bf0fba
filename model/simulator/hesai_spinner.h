// A PandarXT-32 in the simulated world, block by block: written apart from the decoder of its packets, or an error in
// one would hide in the other.
#pragma once

#include <cstdint>
#include <vector>

#include "model/simulator/lidar_truth.h"
#include "model/simulator/scene.h"

namespace remount::simulator {

inline constexpr int kSpinnerChannels = 32, kSpinnerBlocks = 8;
inline constexpr double kSpinnerBlock_s = 50e-6, kSpinnerPacket_s = kSpinnerBlocks * kSpinnerBlock_s;

/// As they were measured of this one: degrees, azimuths clockwise.
double spinner_elevation_deg(int channel);
double spinner_azimuth_deg(int channel);

/// One shot that came back. LiDAR frame: x to the right, y ahead, z up.
struct SpinnerReturn {
  int block = 0;        ///< in the packet
  int channel = 0;      ///< 0 is the highest
  double time_s = 0.0;  ///< since the start of the drive, on the INS clock
  double range_m = 0.0;
  float reflectance = 0.0f;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< as the sensor takes it to be
};

/// How many packets a drive takes.
std::size_t spinner_packets(const SimulationOptions& options);
/// Azimuth at a block of a packet, as the sensor states it: hundredths of a degree, clockwise from y.
int spinner_azimuth(const SimulationOptions& options, std::size_t packet, int block);
/// As the sensor states it.
int spinner_speed_rpm(const SimulationOptions& options);
/// What comes back from the 256 shots of a packet, by the errors of ranges that the drive's LiDAR has.
std::vector<SpinnerReturn> spinner_returns(const Scene& scene, std::size_t packet);

}  // namespace remount::simulator
