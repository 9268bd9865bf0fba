// Parts of a step of the multi-sensor odometry: measurements from the streams, weights, linear algebra.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/messages/message.h"
#include "algorithms/odometry/fusion/ackermann.h"
#include "algorithms/odometry/fusion/fusion_options.h"
#include "algorithms/odometry/fusion/joint_step.h"

namespace remount::odometry {

/// Motion at a steady velocity (vehicle axes: m/s, rad/s) after a time: start_from_vehicle.
RigidTransform moved_at(const Vector6d& velocity, double time_s);
/// The steady velocity that leads from one pose to the other: the inverse of moved_at.
Vector6d velocity_between(const RigidTransform& odometry_from_before, const RigidTransform& odometry_from_after,
                          double duration_s);
/// Whether compensating a scan by one velocity instead of the other moves points by more than about a centimetre.
bool changed_too_much(const Vector6d& used, const Vector6d& found);

/// Motion of the vehicle within a scan: by dead reckoning where it says, else at a steady velocity.
class VehicleMotion {
 public:
  /// @param path around the stamp, with times from it
  VehicleMotion(std::optional<DeadReckonedPath> path, const std::optional<Vector6d>& velocity);
  /// vehicle at the stamp <- vehicle at a time, in s from the stamp.
  RigidTransform at_stamp_from_at(double time_s) const;

 private:
  std::optional<DeadReckonedPath> path_;
  Vector6d velocity_;
  RigidTransform stamp_from_start_ = RigidTransform::Identity();
};

struct MotionSigma {
  Eigen::Vector3d travel_m, turn_rad;
};
/// What a step by dead reckoning is worth; where wheels or gyroscope are missing, what the assumption of a steady
/// velocity is worth (accelerations up to 10 m/s^2; `blind_s`: how long that has not been checked).
MotionSigma motion_sigma(const FusionOptions& options, const std::optional<DeadReckonedPath>& path, bool velocity_known,
                         double duration_s, double blind_s);

struct GravityMeasurement {
  Eigen::Vector3d up_mps2;  ///< vehicle axes
  double taken_off_mps2;    ///< the vehicle's own acceleration, which was subtracted
  /// 1-sigma of what could not be, since nothing tells it: a vehicle that brakes reads like one on a slope.
  double forward_unknown_mps2 = 0.0, sideways_unknown_mps2 = 0.0;
};
/// Mean specific force within 0.25 s of a time, less the acceleration of the IMU: change of speed, centripetal, and
/// that of its lever arm. Nothing without samples, or where what is left is not within 1 m/s^2 of gravity.
/// @param velocity of the vehicle, where the wheels do not say its speed
std::optional<GravityMeasurement> gravity_in_vehicle(const std::vector<motion::ImuSample>& imu,
                                                     const DeadReckoning& reckoning,
                                                     const RigidTransform& vehicle_from_imu,
                                                     const DeadReckoningState& drift,
                                                     const std::optional<Vector6d>& velocity, std::int64_t stamp_ns);

/// Roll and pitch by it, and what they are worth.
LevelMeasurement level_of(const GravityMeasurement& gravity, const RigidTransform& odometry_from_vehicle,
                          const FusionOptions& options);

/// The Earth's curvature: the level of the start lies this much above that of a place (6 m after 9 km), and "up" there
/// leans away from "up" at the start.
double drop_of_level_m(const Eigen::Vector3d& place_in_odometry);
/// The vehicle's measured "up", turned to what the same attitude would measure at the start.
Eigen::Vector3d up_at_start(const Eigen::Vector3d& up_in_vehicle, const RigidTransform& odometry_from_vehicle);

/// How many scans share a sample of the windows of 0.5 s that gravity and height are means over: errors of windows that
/// overlap are not independent, and the scans together must not count for more than the samples do.
double window_overlap(double duration_s);

/// Mean within 0.25 s of a time; nothing without samples.
std::optional<double> mean_height_m(const std::vector<motion::BarometerSample>& barometer, std::int64_t stamp_ns);

/// Of all matches; NaN without any.
double median_distance_m(const FeatureMatches& matches);
double rms_distance_m(const FeatureMatches& matches);

/// What the features of a scan can tell of its motion, and their weights.
struct HeardFeatures {
  Matrix6d heard = Matrix6d::Identity();  ///< see FeatureTerm
  Message undetermined;                   ///< what they do not tell
  bool none = false;
  std::vector<double> line_weights, plane_weights;  ///< 1/m
};
/// @param expected_m distances of this size still count: how wrong the prediction may be
HeardFeatures heard_features(const FeatureMatches& matches, const RigidTransform& odometry_from_vehicle,
                             double expected_m, const FusionOptions& options);

/// R with R^T R = covariance^-1, by way of correlations: the units differ.
Eigen::MatrixXd root_information(const Eigen::MatrixXd& covariance);
/// Nothing where the information is singular.
std::optional<FusionInformation> inverse_information(const FusionInformation& information);

}  // namespace remount::odometry
