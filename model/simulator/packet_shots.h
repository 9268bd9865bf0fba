// The shots of a sensor that spins, packet by packet, in the simulated world.
#pragma once

#include <utility>
#include <vector>

#include "model/simulator/lidar_truth.h"
#include "model/simulator/range_scatter.h"
#include "model/simulator/scene.h"
#include "model/simulator/surroundings.h"

namespace remount::simulator {

/// Where a shot stands in its packet, and where it looks. LiDAR frame: that of the sensor's maker.
struct Shot {
  int block = 0;        ///< of shots that the packet has one after the other: firings, rounds or columns
  int laser = 0;        ///< in the order in which the packet has them
  int ring = 0;         ///< 0 is the lowest
  double time_s = 0.0;  ///< since the start of the drive, on the INS clock
  Eigen::Vector3d level_direction = Eigen::Vector3d::UnitX();  ///< but for its elevation: unit length, horizontal
  double elevation_rad = 0.0;
  Eigen::Vector3d begins_m = Eigen::Vector3d::Zero();
};

/// A shot that came back.
struct PacketReturn {
  int block = 0, laser = 0, ring = 0;  ///< as of the shot
  double time_s = 0.0;
  double range_m = 0.0;  ///< as it is measured, from where the beam begins
  float reflectance = 0.0f;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< as the sensor takes it to be
};

/// The shots of one packet, in the order in which they are fired; what comes back has the errors of ranges that the
/// drive's LiDAR has.
class PacketShots {
 public:
  /// @param begins_s of the packet, since the start of the drive @param rings of the sensor
  PacketShots(const Scene& scene, std::size_t packet, double begins_s, int rings);

  /// Shots that follow are fired from where the sensor is then. Without motion distortion it stays for the packet.
  void move_to(double time_s);
  void fire(const Shot& shot);
  std::vector<PacketReturn> take_returns() { return std::move(returns_); }

 private:
  const SimulationOptions& options_;
  LidarTruth truth_;
  RangeScatter scatter_;
  Surroundings around_;
  std::vector<PacketReturn> returns_;
};

/// Where a head looks that turns evenly, as sensors state it: hundredths of a degree clockwise, 0 when the drive
/// begins.
int head_azimuth(const SimulationOptions& options, double time_s);
/// How fast it turned from one such azimuth to another, hundredths of a degree per second.
double head_rate(int from_azimuth, int to_azimuth, double within_s);
/// Where x is ahead and y left.
Eigen::Vector3d level_direction_clockwise(double from_x_rad);

}  // namespace remount::simulator
