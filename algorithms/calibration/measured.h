// What is known of X beside the pairs: components measured by hand, and the ground under the vehicle.
#pragma once

#include <optional>
#include <vector>

#include "algorithms/calibration/parameter.h"
#include "algorithms/core/options.h"
#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/messages/message.h"
#include "messages/options.h"

namespace remount::calibration {

/// Values measured by hand, each with its own sigma; a sigma of 0 says that it was not measured.
struct MeasuredOptions {
  double x_m = 0.0, x_sigma_m = 0.0;
  double y_m = 0.0, y_sigma_m = 0.0;
  double z_m = 0.0, z_sigma_m = 0.0;
  double yaw_deg = 0.0, yaw_sigma_deg = 0.0;
  double pitch_deg = 0.0, pitch_sigma_deg = 0.0;
  double roll_deg = 0.0, roll_sigma_deg = 0.0;
  double ins_height_m = 0.0, ins_height_sigma_m = 0.0;
  double ins_tilt_sigma_deg = 0.5;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor({"x_m", "m", say::option_measured_x_m, say::option_measured_x_m_help, -1000.0, 1000.0}, self.x_m);
    visitor({"x_sigma_m", "m", say::option_measured_x_sigma_m, say::option_measured_sigma_help, 0.0, 100.0},
            self.x_sigma_m);
    visitor({"y_m", "m", say::option_measured_y_m, say::option_measured_y_m_help, -1000.0, 1000.0}, self.y_m);
    visitor({"y_sigma_m", "m", say::option_measured_y_sigma_m, say::option_measured_sigma_help, 0.0, 100.0},
            self.y_sigma_m);
    visitor({"z_m", "m", say::option_measured_z_m, say::option_measured_z_m_help, -1000.0, 1000.0}, self.z_m);
    visitor({"z_sigma_m", "m", say::option_measured_z_sigma_m, say::option_measured_sigma_help, 0.0, 100.0},
            self.z_sigma_m);
    visitor({"yaw_deg", "deg", say::option_measured_yaw_deg, say::option_measured_yaw_deg_help, -180.0, 180.0},
            self.yaw_deg);
    visitor({"yaw_sigma_deg", "deg", say::option_measured_yaw_sigma_deg, say::option_measured_sigma_help, 0.0, 180.0},
            self.yaw_sigma_deg);
    visitor({"pitch_deg", "deg", say::option_measured_pitch_deg, say::option_measured_pitch_deg_help, -90.0, 90.0},
            self.pitch_deg);
    visitor(
        {"pitch_sigma_deg", "deg", say::option_measured_pitch_sigma_deg, say::option_measured_sigma_help, 0.0, 180.0},
        self.pitch_sigma_deg);
    visitor({"roll_deg", "deg", say::option_measured_roll_deg, say::option_measured_roll_deg_help, -180.0, 180.0},
            self.roll_deg);
    visitor({"roll_sigma_deg", "deg", say::option_measured_roll_sigma_deg, say::option_measured_sigma_help, 0.0, 180.0},
            self.roll_sigma_deg);
    visitor(
        {"ins_height_m", "m", say::option_measured_ins_height_m, say::option_measured_ins_height_m_help, 0.0, 100.0},
        self.ins_height_m);
    visitor({"ins_height_sigma_m", "m", say::option_measured_ins_height_sigma_m,
             say::option_measured_ins_height_sigma_m_help, 0.0, 100.0},
            self.ins_height_sigma_m);
    visitor({"ins_tilt_sigma_deg", "deg", say::option_measured_ins_tilt_sigma_deg,
             say::option_measured_ins_tilt_sigma_deg_help, 0.001, 45.0},
            self.ins_tilt_sigma_deg);
  }
};

/// The ground as the scans see it, mean over a drive.
struct ObservedGround {
  Eigen::Vector3d up_in_lidar = Eigen::Vector3d::UnitZ();  ///< normal, unit length
  double lidar_height_m = 0.0;                             ///< of the lidar's origin above the plane
  double height_sigma_m = 0.0;                             ///< of that mean
  double up_sigma_rad = 0.0;                               ///< of each of the normal's two angles
};

/// One scalar that is known of X, linearised under `perturb`: residual = known - said by X, to first order
/// residual - row . delta.
struct MeasuredRow {
  double residual = 0.0;
  Vector6d row = Vector6d::Zero();
  double sigma = 1.0;
  enum class Of { Parameter, GroundHeight, GroundTilt } of = Of::Parameter;
  Parameter parameter = Parameter::X;  ///< of Of::Parameter only
};

class Measured {
 public:
  Measured() = default;
  Measured(const MeasuredOptions& options, const std::optional<ObservedGround>& ground)
      : options_(options), ground_(ground) {}

  /// Those that were measured by hand, or follow from the ground.
  ParameterSet parameters() const;
  /// Everything that is known, at this X (m, rad). Angles are compared along the shorter way.
  std::vector<MeasuredRow> rows(const RigidTransform& ins_from_lidar) const;
  /// Their information on X under `perturb`.
  Matrix6d information(const RigidTransform& ins_from_lidar) const;

 private:
  bool uses_ground() const { return ground_.has_value() && options_.ins_height_sigma_m > 0.0; }

  MeasuredOptions options_;
  std::optional<ObservedGround> ground_;
};

/// A measurement against which the drive speaks.
struct Contradiction {
  Message text;  ///< "The measured z contradicts the drive by 4.1 sigma ..."
  /// To be added to the covariance as doubt doubt', for nobody knows which is wrong: errors of both that explain their
  /// distance (the Birge ratio), or how far the measurement drew X away from the pairs, whichever is more.
  Vector6d doubt = Vector6d::Zero();
};

/// Those that contradict by more than three sigma.
/// @param joint covariance of X under `perturb` with which the measurements took part in `ins_from_lidar`
/// @param trusted the covariance that is believed, the measurements included
std::vector<Contradiction> contradictions(const Measured& measured, const RigidTransform& ins_from_lidar,
                                          const Matrix6d& joint, const Matrix6d& trusted);

}  // namespace remount::calibration
