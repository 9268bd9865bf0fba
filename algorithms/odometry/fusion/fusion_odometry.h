// Odometry from LiDAR, wheels, IMU and barometer together: runs through where the LiDAR alone slips.
// docs/maths/fusion-odometry.md
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/core/progress.h"
#include "algorithms/messages/message.h"
#include "algorithms/motion/ins_sample.h"
#include "algorithms/odometry/fusion/ackermann.h"
#include "algorithms/odometry/fusion/fusion_options.h"
#include "algorithms/odometry/fusion/joint_step.h"
#include "algorithms/odometry/fusion/state_errors.h"

namespace remount::odometry {

/// Where the sensors sit on the vehicle: x forward, y left, z up, the origin on the ground under the rear axle's
/// centre.
struct FusionMounting {
  RigidTransform vehicle_from_lidar = RigidTransform::Identity();
  RigidTransform vehicle_from_imu = RigidTransform::Identity();
  /// The LiDAR's is what shall be found: wheels and gyroscope, which reach the LiDAR through it, would confirm it. They
  /// then speak of the motion only where the scans do not.
  bool to_be_judged = false;
};

/// Everything but the scans; each ascending in time, empty where the vehicle has none.
struct SensorStreams {
  std::vector<motion::ImuSample> imu;
  std::vector<motion::WheelSample> wheels;
  std::vector<motion::BarometerSample> barometer;
};

struct OdometryScan {
  std::int64_t stamp_ns = 0;
  cloud::PointCloud cloud_in_lidar;
  std::vector<float> time_from_stamp_s;  ///< empty: taken at once, or already compensated
};

/// The vehicle at one scan, and how that was found.
struct FusedScan {
  std::int64_t stamp_ns = 0;
  RigidTransform odometry_from_vehicle = RigidTransform::Identity();
  Matrix6d covariance = Matrix6d::Zero();       ///< of the pose since the start, as in `perturb`
  Matrix6d step_covariance = Matrix6d::Zero();  ///< of the motion since the scan before, in odometry axes
  /// The motion since the scan before as this step has it, without what gravity and barometer corrected of all before.
  RigidTransform before_from_vehicle = RigidTransform::Identity();
  /// Takes a motion (as `perturb`, odometry axes) to that part of it which the features do not tell: there the motion
  /// rests on the other sensors, or on the assumption that it is steady.
  Matrix6d untold = Matrix6d::Identity();
  int line_features = 0, plane_features = 0;  ///< found in the scan
  int line_matches = 0, plane_matches = 0;
  double residual_m = std::numeric_limits<double>::quiet_NaN();  ///< root mean square distance of features from the map
  Message undetermined;             ///< what the scan does not tell of the motion; empty where it tells all
  double wheel_disagreement = 0.0;  ///< of the wheels with the rest, in sigma: slip above about three
  bool dead_reckoned = false, levelled = false, height_measured = false;  ///< terms that took part
  bool usable = false;                                                    ///< false: the prediction was kept
  bool map_restarted = false;  ///< the scans before had lost the map: a new one starts here, at the predicted pose
  double speed_mps = 0.0;
};

/// Takes scans one by one, in the order of their stamps. The odometry frame has its origin at the vehicle of the first
/// scan and its heading; z is up as far as the accelerometer tells (otherwise the vehicle's z). (After CN 113819914 A,
/// "multi-sensor fusion-based odometer"; completed: the correction of the map as a rigid body, drift of the
/// gyroscope and scale of the wheels, directions that the features do not determine.)
class FusionOdometry {
 public:
  /// Throws Error(Contract) for options out of range.
  FusionOdometry(const FusionMounting& mounting, SensorStreams streams, const FusionOptions& options, int threads = 0);

  /// Throws Error(Contract) for a scan not later than the one before.
  FusedScan add(const OdometryScan& scan);

  const DeadReckoningState& drift() const { return drift_; }
  Eigen::Vector4d drift_sigma() const { return errors_.covariance().diagonal().segment<4>(kStateDrift).cwiseSqrt(); }

  /// Errors of the motion since the scan added last are followed from here on, under this number from 0. One must have
  /// been added.
  void mark(std::size_t number) { errors_.mark(number + 1, last_.value().odometry_from_vehicle); }
  /// Covariance of the motion from the scan at a mark to the one added last: of shift (m) and turn (rad), in axes of
  /// the odometry. Less than the two poses' covariances make, since they have most of their errors in common.
  Matrix6d covariance_since(std::size_t number) const {
    return errors_.covariance_since(number + 1, last_.value().odometry_from_vehicle);
  }

 private:
  struct Step;
  void start(const OdometryScan& scan, FusedScan& result);
  FusedScan follow(const OdometryScan& scan);
  std::optional<Vector6d> first_velocity(const OdometryScan& scan) const;
  Step predict(std::int64_t stamp_ns, const std::optional<Vector6d>& velocity) const;
  ScanFeatures features_of(const OdometryScan& scan, const std::optional<Vector6d>& velocity) const;
  void match_and_solve(Step& step, FusedScan& result) const;
  void add_prior(const Step& step, std::vector<WeighedTerm>& terms) const;
  void add_motion(const Step& step, const Matrix6d& untold, std::vector<WeighedTerm>& terms) const;
  void add_absolute(const Step& step, std::vector<WeighedTerm>& terms, FusedScan& result) const;
  bool add_features(const Step& step, int iteration, std::vector<WeighedTerm>& terms, FusedScan& result) const;
  std::optional<LevelMeasurement> level_at(std::int64_t stamp_ns, const RigidTransform& odometry_from_vehicle) const;
  std::optional<double> height_at(std::int64_t stamp_ns) const;
  MotionSigma sigma_of(const Step& step) const;
  void accept(Step& step, FusedScan& result);
  void propagate(const Step& step, FusedScan& result);
  void start_height(FusedScan& result);
  bool enters_map(const ScanFeatures& features, const RigidTransform& odometry_from_vehicle) const;
  void restart_map(const OdometryScan& scan);

  FusionMounting mounting_;
  FusionOptions options_;
  std::vector<motion::ImuSample> imu_;
  std::vector<motion::BarometerSample> barometer_;
  DeadReckoning reckoning_;
  int threads_;

  FeatureMap map_;
  std::optional<FusedScan> last_;
  std::optional<OdometryScan> first_scan_;  // kept until the velocity is known, without wheels
  std::optional<Vector6d> velocity_;        // vehicle axes, of the last step: m/s, rad/s
  DeadReckoningState drift_;
  Eigen::Vector2d steady_rad_ = Eigen::Vector2d::Zero();  // what roll and pitch of the accelerometer lack
  double blind_s_ = 0.0;                   // how long some direction has rested on the assumption of steady motion
  std::optional<double> height_offset_m_;  // barometer - odometry
  StateErrors errors_;                     // its mark 0 is the scan before
  int lost_scans_ = 0;  // in a row: with features of their own, but nothing in the map that they lie on
};

/// The drive as a whole.
struct FusionOdometryResult {
  std::vector<FusedScan> scans;
  DeadReckoningState drift;
  Eigen::Vector4d drift_sigma = Eigen::Vector4d::Zero();
  bool cancelled = false;
};

/// @param load the scan of an index; what it throws is thrown on
FusionOdometryResult solve_fusion_odometry(std::size_t scan_count, const std::function<OdometryScan(std::size_t)>& load,
                                           const FusionMounting& mounting, const SensorStreams& streams,
                                           const FusionOptions& options, int threads, Progress& progress);

}  // namespace remount::odometry
