// The terms of the multi-sensor odometry: what each sensor says about the motion to a new scan, with Jacobians.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/odometry/fusion/feature_map.h"

namespace remount::odometry {

/// What a step solves for, stacked.
///   correction (0-5): of the pose before the step and of the local map with it, as one rigid body: shift m and
///     rotation rad in odometry axes, about the vehicle before the step. What is absolute (gravity, height) is measured
///     against a map that has drifted: this is where the drift is taken back.
///   motion (6-11): `perturb` of the predicted odometry_from_vehicle at the new scan, before the correction.
///   drift (12-15): change of the gyroscope's bias (rad/s, vehicle axes) and of the wheels' scale (share).
///   place in the map (16-21): correction of the pose before the step within the map, likewise about that vehicle. The
///     map is the mean of many scans: it errs less than the pose before, and features tell of the motion only from it.
///   steady errors (22-23): change of what the accelerometer's roll and pitch lack throughout, rad. Were they not asked
///     for, the wheels' scale would have to explain why a climb by pitch is none by the barometer.
inline constexpr int kCorrection = 0, kMotion = 6, kDrift = 12, kInMap = 16, kSteady = 22, kFusionUnknowns = 24;
using FusionVector = Eigen::Matrix<double, kFusionUnknowns, 1>;
using FusionJacobian = Eigen::Matrix<double, Eigen::Dynamic, kFusionUnknowns, Eigen::RowMajor>;

/// odometry_from_vehicle at the scan before, as estimated, and at the new one, as predicted.
struct StepAnchor {
  RigidTransform before = RigidTransform::Identity();
  RigidTransform predicted = RigidTransform::Identity();
};

/// odometry_from_vehicle at the new scan, before the correction.
RigidTransform moved_pose(const StepAnchor& anchor, const FusionVector& x);
/// The same, corrected: the pose that a step results in.
RigidTransform fused_pose(const StepAnchor& anchor, const FusionVector& x);
/// The pose at the new scan as the map sees it, which has not been corrected yet.
RigidTransform pose_in_map(const StepAnchor& anchor, const FusionVector& x);
/// The place in the map before the step as it shows at the new scan (first order: it is small).
Matrix6d carried_to_prediction(const StepAnchor& anchor);
/// d fused_pose / d x, the pose perturbed as in `perturb`.
Eigen::Matrix<double, 6, kFusionUnknowns> fused_pose_jacobian(const StepAnchor& anchor, const FusionVector& x);

/// One term. Residuals are divided by their sigma: the square sum is the term's part of the cost.
class FusionTerm {
 public:
  virtual ~FusionTerm() = default;
  virtual int rows() const = 0;
  /// `jacobian` may be null; both have rows() rows.
  virtual void evaluate(const FusionVector& x, Eigen::Ref<Eigen::VectorXd> residuals,
                        FusionJacobian* jacobian) const = 0;
};

/// Distances of line features from their lines (two rows each, square to the line) or of plane features from their
/// planes (one row each).
class FeatureTerm : public FusionTerm {
 public:
  enum class Kind { Lines, Planes };
  /// @param weights root of the information of each match, 1/m
  /// @param heard what of the motion the features can tell of: they see `heard * (motion + place in the map)`, and the
  ///        prediction in the directions that it takes away
  FeatureTerm(Kind kind, const StepAnchor& anchor, std::vector<FeatureMatch> matches, std::vector<double> weights,
              const Matrix6d& heard);
  int rows() const override;
  void evaluate(const FusionVector& x, Eigen::Ref<Eigen::VectorXd> residuals, FusionJacobian* jacobian) const override;

 private:
  Kind kind_;
  StepAnchor anchor_;
  std::vector<FeatureMatch> matches_;
  std::vector<double> weights_;
  Matrix6d heard_, carried_;
};

/// Rotation of the step against that of the gyroscope (or of the wheels' difference), three rows in vehicle axes.
class TurnTerm : public FusionTerm {
 public:
  TurnTerm(const StepAnchor& anchor, const Eigen::Matrix3d& before_from_after, double duration_s,
           const Eigen::Vector3d& sigma_rad, bool has_bias);
  int rows() const override { return 3; }
  void evaluate(const FusionVector& x, Eigen::Ref<Eigen::VectorXd> residuals, FusionJacobian* jacobian) const override;

 private:
  StepAnchor anchor_;
  Eigen::Matrix3d after_from_before_;
  double bias_factor_s_;
  Eigen::Vector3d sigma_rad_;
};

/// Translation of the step against that of the rear axle, three rows in axes of the vehicle before it.
class TravelTerm : public FusionTerm {
 public:
  /// @param has_scale whether the wheels, whose scale is estimated, measured it
  TravelTerm(const StepAnchor& anchor, const Eigen::Vector3d& travel_in_before_m, const Eigen::Vector3d& sigma_m,
             bool has_scale);
  int rows() const override { return 3; }
  void evaluate(const FusionVector& x, Eigen::Ref<Eigen::VectorXd> residuals, FusionJacobian* jacobian) const override;

 private:
  StepAnchor anchor_;
  Eigen::Vector3d travel_m_, sigma_m_;
  double scale_factor_;
};

/// Another term that hears of the motion only through a filter: residuals are those at `speaks * motion`.
class FilteredTerm : public FusionTerm {
 public:
  FilteredTerm(std::unique_ptr<FusionTerm> term, const Matrix6d& speaks) : term_(std::move(term)), speaks_(speaks) {}
  int rows() const override { return term_->rows(); }
  void evaluate(const FusionVector& x, Eigen::Ref<Eigen::VectorXd> residuals, FusionJacobian* jacobian) const override;

 private:
  std::unique_ptr<FusionTerm> term_;
  Matrix6d speaks_;
};

/// Roll and pitch of the vehicle against those by the direction of gravity. With z up and R = odometry_from_vehicle =
/// Rz Ry Rx, a vehicle at rest reads the specific force g R^T e_z = g (-sin pitch, cos pitch sin roll, cos pitch cos
/// roll): roll = atan2(f_y, f_z) and pitch = atan2(-f_x, |f_yz|). docs/maths/fusion-odometry.md (O8)
struct LevelMeasurement {
  double roll_rad = 0.0, pitch_rad = 0.0;
  double roll_sigma_rad = 0.0, pitch_sigma_rad = 0.0;
};
/// @param gravity_in_vehicle_mps2 specific force less the vehicle's own acceleration: points up
LevelMeasurement level_from_gravity(const Eigen::Vector3d& gravity_in_vehicle_mps2);

class LevelTerm : public FusionTerm {
 public:
  LevelTerm(const StepAnchor& anchor, const LevelMeasurement& measured) : anchor_(anchor), measured_(measured) {}
  int rows() const override { return 2; }  // roll, pitch
  void evaluate(const FusionVector& x, Eigen::Ref<Eigen::VectorXd> residuals, FusionJacobian* jacobian) const override;

 private:
  StepAnchor anchor_;
  LevelMeasurement measured_;
};

/// Height of the vehicle in the odometry frame.
class HeightTerm : public FusionTerm {
 public:
  HeightTerm(const StepAnchor& anchor, double height_in_odometry_m, double sigma_m)
      : anchor_(anchor), height_m_(height_in_odometry_m), sigma_m_(sigma_m) {}
  double sigma_m() const { return sigma_m_; }
  int rows() const override { return 1; }
  void evaluate(const FusionVector& x, Eigen::Ref<Eigen::VectorXd> residuals, FusionJacobian* jacobian) const override;

 private:
  StepAnchor anchor_;
  double height_m_, sigma_m_;
};

/// A linear term A (x - x0) over all of x: what is known beforehand, or measured directly.
class LinearFusionTerm : public FusionTerm {
 public:
  LinearFusionTerm(FusionJacobian root_information, const FusionVector& expected)
      : root_(std::move(root_information)), expected_(expected) {}
  int rows() const override { return static_cast<int>(root_.rows()); }
  void evaluate(const FusionVector& x, Eigen::Ref<Eigen::VectorXd> residuals, FusionJacobian* jacobian) const override;

 private:
  FusionJacobian root_;
  FusionVector expected_;
};

}  // namespace remount::odometry
