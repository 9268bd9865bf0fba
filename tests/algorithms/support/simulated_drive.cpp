#include "tests/algorithms/support/simulated_drive.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <random>

#include "algorithms/calibration/joint/pair_equation.h"
#include "algorithms/calibration/linear_solutions.h"

namespace remount::testing {

RigidTransform true_pose(const DriveOptions& options, double time_s) {
  const double steps = time_s / options.step_s;
  const double pitch = options.tilt_rad * std::sin(1.1 * time_s),
               roll = options.tilt_rad * std::sin(0.8 * time_s + 1.0);
  return make_rigid(rotation_from_yaw_pitch_roll({options.turn_rad * std::sin(0.35 * time_s), pitch, roll}),
                    {steps * options.step_m, options.turn_rad * options.step_m * std::sin(0.2 * steps), 0.0});
}

Vector6d true_velocity(const DriveOptions& options, double time_s) {
  constexpr double kStep_s = 1e-3;
  const RigidTransform before = true_pose(options, time_s - kStep_s), after = true_pose(options, time_s + kStep_s);
  Vector6d velocity;
  velocity << true_pose(options, time_s).linear().transpose() * (after.translation() - before.translation()),
      so3_log(before.linear().transpose() * after.linear());
  return velocity / (2.0 * kStep_s);
}

Matrix6d root_of_registration_errors(const calibration::NoiseModel& noise) {
  const Matrix6d covariance = calibration::inverse_by_lu(noise.registration_information(registration_information()));
  return covariance.llt().matrixL();
}

SimulatedDrive simulate(const DriveOptions& options, int seed) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  const calibration::NoiseModel& noise = options.noise;
  SimulatedDrive drive;
  drive.ins_from_lidar = mounting();
  std::vector<RigidTransform> truth;
  Vector6d bias = Vector6d::Zero(), drift = Vector6d::Zero();
  for (int session = 0; session < options.sessions; ++session) {
    bias.tail<3>() = random_vector(random, options.attitude_bias_sigma_rad);
    drift.setZero();
    for (int k = 0; k < options.keyframes; ++k) {
      const RigidTransform pose = true_pose(options, k * options.step_s);
      if (k > 0)
        drift += noise.drift_covariance(options.step_s).diagonal().cwiseSqrt().cwiseProduct(random_step(random, 1, 1));
      Vector6d error = random_step(random, noise.ins_position_sigma_m, noise.ins_attitude_sigma_rad) + bias + drift;
      error.head<3>() += pose.linear().transpose() * drift.head<3>() - drift.head<3>();  // it walks in local axes
      calibration::JointNode node;
      node.session = index_at<motion::SessionIndex>(session);
      node.time_s = k * options.step_s;
      node.local_from_ins = calibration::moved_in_body(pose, -error);
      drive.problem.nodes.push_back(node);
      truth.push_back(pose);
    }
  }
  const Matrix6d root = root_of_registration_errors(noise);
  for (int a = 0; a < static_cast<int>(truth.size()); ++a)
    for (int b = a + 1; b <= a + options.partners && b / options.keyframes == a / options.keyframes; ++b) {
      const RigidTransform p = truth[static_cast<std::size_t>(b)].inverse() * truth[static_cast<std::size_t>(a)];
      const RigidTransform q = calibration::predicted_lidar_motion(p, drive.ins_from_lidar);
      drive.problem.terms.push_back({index_at<motion::KeyframeIndex>(a), index_at<motion::KeyframeIndex>(b),
                                     perturb(q, root * random_step(random, 1, 1)), registration_information(), 1.0});
    }
  drive.problem.lidar().prior_ins_from_lidar = drive.ins_from_lidar;
  drive.problem.lidar().prior_information = 1e-6 * Matrix6d::Identity();
  if (options.attitude_bias_sigma_rad > 0.0)
    drive.problem.session_attitude_bias_sigma_rad.assign(static_cast<std::size_t>(options.sessions),
                                                         options.attitude_bias_sigma_rad);
  return drive;
}

std::vector<motion::Pair> pairs_of(const SimulatedDrive& drive) {
  std::vector<motion::Pair> pairs;
  for (const calibration::JointTerm& term : drive.problem.terms) {
    const calibration::JointNode& a = drive.problem.nodes[term.node_a];
    const calibration::JointNode& b = drive.problem.nodes[term.node_b];
    motion::Pair pair;
    pair.keyframe_a = term.node_a;
    pair.keyframe_b = term.node_b;
    pair.gap_s = b.time_s - a.time_s;
    pair.ins_b_from_ins_a = b.local_from_ins.inverse() * a.local_from_ins;
    pair.baseline_m = pair.ins_b_from_ins_a.translation().norm();
    pair.rotation_rad = so3_log(pair.ins_b_from_ins_a.linear()).norm();
    pair.lidar_b_from_lidar_a = term.lidar_b_from_lidar_a;
    pair.registration.attempted = pair.registration.converged = true;
    pair.registration.overlap = 0.9;
    pair.registration.information = term.information;
    pairs.push_back(pair);
  }
  return pairs;
}

calibration::PairwiseInput input_of(const SimulatedDrive& drive, const DriveOptions& options) {
  calibration::PairwiseInput input;
  input.nodes = drive.problem.nodes;
  calibration::SessionNoise noise;
  noise.position_white_sigma_m = std::max(1e-6, options.noise.ins_position_sigma_m);
  noise.attitude_white_sigma_rad = std::max(1e-8, options.noise.ins_attitude_sigma_rad);
  noise.attitude_bias_sigma_rad = options.attitude_bias_sigma_rad;
  noise.position_drift = options.noise.ins_position_drift;
  noise.attitude_drift = options.noise.ins_attitude_drift;
  input.sessions.assign(static_cast<std::size_t>(options.sessions), noise);
  return input;
}

}  // namespace remount::testing
