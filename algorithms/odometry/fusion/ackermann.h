// Dead reckoning between scans: speed of the rear wheels and angular rate of the gyroscope.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/motion/sensor_samples.h"

namespace remount::odometry {

/// What dead reckoning subtracts and multiplies by: estimated on the way.
struct DeadReckoningState {
  Eigen::Vector3d gyro_bias_radps = Eigen::Vector3d::Zero();  ///< vehicle axes; measured = true + bias
  double wheel_scale = 1.0;                                   ///< true speed = scale * measured
};

/// Motion of the vehicle over a stretch of time, relative to its pose at the start.
struct DeadReckonedPath {
  std::vector<double> time_s;                      ///< from the origin asked for; ascending
  std::vector<RigidTransform> start_from_vehicle;  ///< at these times
  RigidTransform at(double time_s) const;          ///< interpolated; held at the ends
  double mean_speed_mps = 0.0;                     ///< NaN without wheels
  bool has_rotation = false, has_speed = false;
  bool by_gyro = false;  ///< the rotation, all of it; otherwise the wheels' difference had to help out
};

/// Rear axle and gyroscope of a vehicle: x forward, y left, z up, the origin at the rear axle's centre, which moves
/// along x alone (Ackermann: the rear wheels do not slip sideways).
class DeadReckoning {
 public:
  /// @param vehicle_from_imu only its rotation is used
  /// @param track_width_m between the rear wheels; the turn where there is no gyroscope
  DeadReckoning(std::vector<motion::ImuSample> imu, std::vector<motion::WheelSample> wheels,
                const RigidTransform& vehicle_from_imu, double track_width_m);

  bool has_gyro() const { return !imu_.empty(); }
  bool has_wheels() const { return !wheels_.empty(); }

  /// Where the gyroscope falls silent the wheels' difference gives the turn. Integrates from `from_ns` to `to_ns` on
  /// the group: R <- R Exp(w dt), p <- p + R J(w dt) v dt, with the left Jacobian J, rates linear between samples.
  /// Times are told relative to `origin_ns`. Nothing where neither sensor covers the stretch, or where samples are more
  /// than 0.25 s apart; up to 0.06 s beyond the ends of the data the last rate is held.
  std::optional<DeadReckonedPath> path(std::int64_t from_ns, std::int64_t to_ns, std::int64_t origin_ns,
                                       const DeadReckoningState& state) const;

  /// Speed of the rear axle's centre, m/s; nothing where the wheels do not say.
  std::optional<double> speed_mps(std::int64_t stamp_ns) const;
  struct Turning {
    Eigen::Vector3d rate_radps;  ///< vehicle axes, the gyroscope's bias taken off
    bool by_gyro;
  };
  /// Of the gyroscope; where it does not say, of the wheels' difference.
  std::optional<Turning> turning(std::int64_t stamp_ns, const DeadReckoningState& state) const;

  /// Mean rate of the gyroscope, vehicle axes, over a stretch in which the wheels stand still: its bias. Nothing where
  /// they do not, or do not say.
  std::optional<Eigen::Vector3d> standstill_rate_radps(std::int64_t from_ns, std::int64_t to_ns) const;

 private:
  std::vector<motion::ImuSample> imu_;  // rates in vehicle axes
  std::vector<motion::WheelSample> wheels_;
  double track_width_m_;
};

}  // namespace remount::odometry
