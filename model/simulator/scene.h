// Everything of a simulated drive that its scans and its INS samples are taken from.
#pragma once

#include "model/simulator/road.h"
#include "model/simulator/scenery.h"
#include "model/simulator/simulation_options.h"
#include "model/simulator/world.h"

namespace remount::simulator {

/// Time 0 of the drive on the INS clock, Unix time.
inline constexpr std::int64_t kDriveStart_ns = 1'700'000'000'000'000'000;
/// INS and the other sensors report from this long before the first scan to this long after the last.
inline constexpr double kMargin_s = 0.5;

/// World, road and traffic of one set of options. Immutable; safe to use from several threads. The road frame has its
/// origin and first direction at the start of the drive; the ENU frame about the start is turned by the heading, and
/// tilted by the slope of a yard.
class Scene {
 public:
  explicit Scene(const SimulationOptions& options);
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  const SimulationOptions& options() const { return options_; }
  const World& world() const { return world_; }
  const Traffic& traffic() const { return traffic_; }
  RigidTransform vehicle_from_ins() const { return simulator::vehicle_from_ins(options_.scenario); }
  RigidTransform road_from_vehicle(double time_s) const;
  RigidTransform road_from_ins(double time_s) const;
  /// What moves with the vehicle and is seen by its LiDAR, road frame: the arm of an excavator.
  std::vector<TiltedBox> arm(double time_s) const;
  RigidTransform enu_from_road() const { return enu_from_road_; }
  RigidTransform enu_from_ins(double time_s) const { return enu_from_road_ * road_from_ins(time_s); }

 private:
  SimulationOptions options_;
  Road road_;
  Ground ground_;
  World world_;
  Traffic traffic_;
  RigidTransform enu_from_road_ = RigidTransform::Identity();
};

/// Number of scans in the drive; scan k is taken in scan_phase_s + [k, k + 1] / scan_rate_hz. Where the LiDAR spins it
/// is stamped in the middle, otherwise at the start, with the first point.
std::size_t scan_count(const SimulationOptions& options);
/// How much of a scan's time has passed at its stamp, of one.
double stamp_share(const SimulationOptions& options);
/// Time of the stamp since the start, on the INS clock, s.
double scan_time_s(const SimulationOptions& options, std::size_t scan);

}  // namespace remount::simulator
