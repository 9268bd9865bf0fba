// Motion of a vehicle from the speed of its wheels and the rates of its IMU, integrated three ways.
// docs/maths/vehicle-frame.md (V1) to (V4)
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/motion/ins_sample.h"
#include "algorithms/motion/sensor_samples.h"

namespace remount::motion {

/// What the sensors say of a short time, in which rate and speed count as constant.
struct MotionStep {
  double duration_s = 0.0;
  Eigen::Vector3d turn_in_imu_rad = Eigen::Vector3d::Zero();  ///< integral of the angular rate, axes of the IMU
  double travel_m = 0.0;                                      ///< integral of the speed of the rear axle's centre
  double wheel_difference_m = 0.0;                            ///< travel of the right wheel minus that of the left
};

/// Rates and wheel speeds of one drive, aligned in time by linear interpolation.
class WheelImuSignals {
 public:
  /// Samples that repeat or step back in time, or are not finite, are left out.
  WheelImuSignals(const std::vector<ImuSample>& imu, const std::vector<WheelSample>& wheels);

  /// Steps between two times, cut at every sample of the IMU; nothing outside the data of either, across a gap of
  /// either (longer than five median distances and 0.25 s), or where `to` is not after `from`.
  std::optional<std::vector<MotionStep>> steps(std::int64_t from_ns, std::int64_t to_ns) const;

  std::int64_t begin_ns() const;  ///< first time at which both are known; 0 where there is none
  std::int64_t end_ns() const;
  bool wheels_differ() const { return wheels_differ_; }    ///< false: the log has one speed for both rear wheels
  bool rates_about_one_axis() const { return one_axis_; }  ///< the log has a yaw rate only
  const std::vector<ImuSample>& imu() const { return imu_; }

 private:
  std::vector<ImuSample> imu_;
  std::vector<WheelSample> wheels_;
  std::int64_t imu_gap_ns_ = 0, wheel_gap_ns_ = 0;
  bool wheels_differ_ = false, one_axis_ = false;
};

enum class WheelIntegration {
  ClosedForm,  ///< on the group: p += R J(alpha) u, R <- R Exp(alpha), with the left Jacobian J
  Euler,       ///< p += R u, R <- R Exp(alpha): the arc within a step is taken for its tangent
  Planar,      ///< yaw alone, in the plane: what wheel odometry without an IMU does
};

/// One step: world_from_vehicle after it. @param turn_rad rotation vector of the step in vehicle axes
RigidTransform advance(const RigidTransform& world_from_vehicle, const Eigen::Vector3d& turn_rad, double travel_m,
                       WheelIntegration integration);

/// world_from_vehicle after each step, the start first: one pose more than steps.
/// @param vehicle_from_imu rotation that takes axes of the IMU to those of the vehicle
/// @param rate_bias_radps of the IMU, in its axes; taken off
std::vector<RigidTransform> integrate_steps(const std::vector<MotionStep>& steps,
                                            const RigidTransform& world_from_vehicle_start,
                                            const Eigen::Matrix3d& vehicle_from_imu,
                                            const Eigen::Vector3d& rate_bias_radps, WheelIntegration integration);

/// How far ahead of the rear axle the point is that does not move along z as the vehicle pitches, for all that is known
/// beforehand: the middle between the axles of anything from a small car to a lorry.
inline constexpr double kPitchCentre_m = 1.3, kPitchCentreSigma_m = 1.3;

/// The closed form over many steps, freed of the mounting of the IMU: with R = vehicle_from_imu the motion of the
/// vehicle is start_from_end = (R imu_turn R', R travel_map R' e_x + lift), where `lift` is what the rear axle moves
/// along z as the vehicle pitches. A vehicle stands on four wheels: over a crest its axes are a chord of the road, and
/// the road is parallel to them under the middle of the chord, not under the rear axle.
struct WheelPreintegration {
  Eigen::Matrix3d imu_start_from_imu_end = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d travel_map_m = Eigen::Matrix3d::Zero();      ///< sum of R_k J(alpha_k) u_k, in axes of the IMU
  Eigen::Matrix3d difference_map_m = Eigen::Matrix3d::Zero();  ///< the same of the right wheel's way minus the left's
  std::array<Eigen::Matrix3d, 3> turn_maps_rad{Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Zero(),
                                               Eigen::Matrix3d::Zero()};  ///< sum of R_k e_j alpha_k', for each axis j
  Eigen::Vector3d turn_in_imu_rad = Eigen::Vector3d::Zero();              ///< plain sum of the steps' rotation vectors
  double duration_s = 0.0;
  double travel_m = 0.0;
  double wheel_difference_m = 0.0;

  /// @param pitch_centre_m how far ahead of the rear axle the point is that does not move along z
  /// @param wheel_asymmetry the true way of the right wheel is longer by this share than its scale says, that of the
  ///        left shorter
  RigidTransform start_from_end(const Eigen::Matrix3d& vehicle_from_imu, double wheel_scale = 1.0,
                                double pitch_centre_m = 0.0, double wheel_asymmetry = 0.0) const;
};

/// @param rate_scale true rates per measured ones, for each axis of the IMU; the bias is taken off after it
WheelPreintegration preintegrate(const std::vector<MotionStep>& steps, const Eigen::Vector3d& rate_bias_radps,
                                 const Eigen::Vector3d& rate_scale = Eigen::Vector3d::Ones());

}  // namespace remount::motion
