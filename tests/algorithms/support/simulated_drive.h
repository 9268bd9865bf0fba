// A drive with known X whose INS poses and registrations carry exactly the errors of a noise model: what the solvers
// of P X = X Q are tested on.
#pragma once

#include "algorithms/calibration/joint/joint_solver.h"
#include "algorithms/calibration/pairwise/pairwise.h"
#include "tests/algorithms/support/random_motion.h"

namespace remount::testing {

struct DriveOptions {
  int keyframes = 40;
  int partners = 3;
  int sessions = 1;
  double step_m = 2.0;
  double step_s = 0.5;
  double turn_rad = 0.6;          ///< amplitude of the heading
  double tilt_rad = 0.1;          ///< amplitude of pitch and roll; 0: flat driving
  calibration::NoiseModel noise;  ///< the errors that are really made
  double attitude_bias_sigma_rad = 0.0;
};

inline calibration::NoiseModel no_noise() {
  calibration::NoiseModel noise;
  noise.ins_position_sigma_m = noise.ins_attitude_sigma_rad = 1e-12;
  noise.registration_scale = noise.registration_floor_m = noise.registration_floor_rad = 1e-9;
  return noise;
}

/// Keyframes, registrations and the truth.
struct SimulatedDrive {
  RigidTransform ins_from_lidar;
  calibration::JointProblem problem;
};

inline RigidTransform mounting() {
  return make_rigid(rotation_from_yaw_pitch_roll({1.2, 0.2, -0.1}), {1.1, -0.4, 1.6});
}

/// Sigmas of a good registration, before the noise model's scale: 2 mm, 0.1 mrad.
inline Matrix6d registration_information() {
  Vector6d information;
  information << Eigen::Vector3d::Constant(1.0 / (0.002 * 0.002)), Eigen::Vector3d::Constant(1.0 / (1e-4 * 1e-4));
  return information.asDiagonal();
}

RigidTransform true_pose(const DriveOptions& options, double time_s);
/// Velocity of the INS in its own axes, m/s and rad/s.
Vector6d true_velocity(const DriveOptions& options, double time_s);
/// Makes errors of registrations of independent ones of size one: a root of their covariance.
Matrix6d root_of_registration_errors(const calibration::NoiseModel& noise);
SimulatedDrive simulate(const DriveOptions& options, int seed);
/// The same as the input of pairwise calibration.
std::vector<motion::Pair> pairs_of(const SimulatedDrive& drive);
calibration::PairwiseInput input_of(const SimulatedDrive& drive, const DriveOptions& options);

}  // namespace remount::testing
