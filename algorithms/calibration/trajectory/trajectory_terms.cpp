#include "algorithms/calibration/trajectory/trajectory_terms.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace remount::calibration {
namespace {

// Turns residuals with this covariance into residuals of unit variance.
Eigen::Matrix3d whitening(const Eigen::Matrix3d& covariance) {
  const Eigen::LLT<Eigen::Matrix3d> root(covariance);
  return root.matrixL().solve(Eigen::Matrix3d::Identity());
}

void whiten(const Eigen::Matrix3d& by, TrajectoryTerm& term) {
  term.residual = by * term.residual;
  term.by_pose = by * term.by_pose;
  term.by_before = by * term.by_before;
  term.by_border = by * term.by_border;
}

// Log(R Exp(d)) = Log(R) + J d to first order.
Eigen::Matrix3d right_jacobian_inverse(const Eigen::Vector3d& phi_rad) { return so3_left_jacobian_inverse(-phi_rad); }

struct Place {
  const RigidTransform& enu_from_lidar;
  const RigidTransform& x;
  double clock_s;
  double position_s;  ///< of its positions: the clock, and how much older they are than attitudes
};

TrajectoryTerm ins_position(const InsObservation& ins, const Place& at) {
  const Eigen::Matrix3d enu_from_ins = at.enu_from_lidar.linear() * at.x.linear().transpose();
  const Eigen::Vector3d velocity = ins.body_velocity.head<3>();
  TrajectoryTerm term;
  term.kind = TermKind::InsPosition;
  term.residual = at.enu_from_lidar.translation() - enu_from_ins * (at.x.translation() + velocity * at.position_s) -
                  ins.enu_from_ins.translation();
  // A turn of the pose by R_X omega - phi takes the lever arm along.
  const Eigen::Matrix3d by_turn = enu_from_ins * skew(at.x.translation() + velocity * at.position_s);
  term.by_pose.leftCols<3>() = at.enu_from_lidar.linear();
  term.by_pose.rightCols<3>() = by_turn * at.x.linear();
  term.by_border.block<3, 3>(0, 0) = -enu_from_ins;
  term.by_border.block<3, 3>(0, 3) = -by_turn;
  term.by_border.col(kClockAt) = term.by_border.col(kLagAt) = -enu_from_ins * velocity;
  const double height_sigma_m = std::hypot(ins.position_sigma_m, ins.unmeasured_height_sigma_m);
  if (ins.unmeasured_height_sigma_m > 0.0) term.used.z() = 0.0;  // what is left holds the height, and says nothing
  whiten(Eigen::Matrix3d(
             Eigen::Vector3d(ins.position_sigma_m, ins.position_sigma_m, height_sigma_m).cwiseInverse().asDiagonal()),
         term);
  return term;
}

TrajectoryTerm ins_attitude(const InsObservation& ins, const Place& at) {
  const Eigen::Vector3d rate = ins.body_velocity.tail<3>();
  const Eigen::Matrix3d delay = so3_exp(-rate * at.clock_s);
  TrajectoryTerm term;
  term.kind = TermKind::InsAttitude;
  term.residual =
      so3_log(ins.enu_from_ins.linear().transpose() * at.enu_from_lidar.linear() * at.x.linear().transpose() * delay);
  const Eigen::Matrix3d by_turn = right_jacobian_inverse(term.residual) * delay.transpose();
  term.by_pose.rightCols<3>() = by_turn * at.x.linear();
  term.by_border.block<3, 3>(0, 3) = -by_turn;
  term.by_border.col(kClockAt) = -right_jacobian_inverse(term.residual) * rate;
  whiten(Eigen::Matrix3d::Identity() / ins.attitude_sigma_rad, term);
  return term;
}

// The same, of which only some axes are measured.
TrajectoryTerm part_of(TrajectoryTerm attitude, TermKind kind, const Eigen::Vector3d& used, double sigma_ratio) {
  attitude.kind = kind;
  attitude.used = used;
  whiten(Eigen::Matrix3d((sigma_ratio * used).asDiagonal()), attitude);
  return attitude;
}

void add_ins_attitude(const InsObservation& ins, const Place& at, std::vector<TrajectoryTerm>& out) {
  const TrajectoryTerm attitude = ins_attitude(ins, at);
  if (!(ins.assumed_tilt_sigma_rad > 0.0)) {
    out.push_back(attitude);
    return;
  }
  const Eigen::Vector3d heading = Eigen::Vector3d::UnitZ();
  out.push_back(part_of(attitude, TermKind::InsAttitude, heading, 1.0));
  out.push_back(part_of(attitude, TermKind::InsTilt, Eigen::Vector3d::Ones() - heading,
                        ins.attitude_sigma_rad / std::hypot(ins.attitude_sigma_rad, ins.assumed_tilt_sigma_rad)));
}

TrajectoryTerm antenna_position(const TrajectoryEpoch& epoch, const TrajectoryState& state, const Place& at) {
  const Eigen::Matrix3d& rotation = at.enu_from_lidar.linear();
  const Eigen::Vector3d velocity =
      epoch.lidar_velocity.head<3>() + epoch.lidar_velocity.tail<3>().cross(state.antenna_in_lidar);
  const Eigen::Vector3d seen = state.antenna_in_lidar - velocity * at.clock_s;
  TrajectoryTerm term;
  term.kind = TermKind::Antenna;
  term.residual = at.enu_from_lidar * seen - epoch.antenna->position_enu_m;
  term.by_pose.leftCols<3>() = rotation;
  term.by_pose.rightCols<3>() = -rotation * skew(seen);
  term.by_border.block<3, 3>(0, kAntennaAt) =
      rotation * (Eigen::Matrix3d::Identity() - at.clock_s * skew(epoch.lidar_velocity.tail<3>()));
  term.by_border.col(kClockAt) = -rotation * velocity;
  whiten(whitening(epoch.antenna->covariance_enu_m2), term);
  return term;
}

// By how much a drift by a share of the way moves a step. Along the way it would be the scale of the odometry.
Eigen::Matrix3d drifted_m(const Eigen::Vector3d& way_m) {
  const double length_m = way_m.norm();
  if (!(length_m > 0.0)) return Eigen::Matrix3d::Zero();
  const Eigen::Vector3d ahead = way_m / length_m;
  return length_m * (Eigen::Matrix3d::Identity() - ahead * ahead.transpose());
}

void add_step(const TrajectorySession& session, std::size_t i, const std::vector<RigidTransform>& poses,
              const OwnVector& own, std::vector<TrajectoryTerm>& out) {
  const TrajectoryEpoch& epoch = session.epochs[i];
  const RigidTransform odometry = session.epochs[i - 1].odometry_from_lidar.inverse() * epoch.odometry_from_lidar;
  const RigidTransform step = poses[i - 1].inverse() * poses[i];
  const Eigen::Matrix3d back = odometry.linear().transpose();
  const double scale = own[kScaleAt - kSharedSize];
  const Eigen::Matrix3d drifted = drifted_m(back * odometry.translation());

  TrajectoryTerm translation;
  translation.kind = TermKind::StepTranslation;
  translation.epoch = i;
  translation.residual = back * ((1.0 + scale) * step.translation() - odometry.translation()) + drifted * own.tail<3>();
  translation.by_pose.leftCols<3>() = (1.0 + scale) * back * step.linear();
  translation.by_before.leftCols<3>() = -(1.0 + scale) * back;
  translation.by_before.rightCols<3>() = (1.0 + scale) * back * skew(step.translation());
  translation.by_border.col(kScaleAt) = back * step.translation();
  translation.by_border.middleCols<3>(kDriftAt) = drifted;
  whiten(whitening(epoch.step_translation_m2), translation);
  out.push_back(translation);

  TrajectoryTerm rotation;
  rotation.kind = TermKind::StepRotation;
  rotation.epoch = i;
  rotation.residual = so3_log(back * step.linear());
  const Eigen::Matrix3d by_turn = right_jacobian_inverse(rotation.residual);
  rotation.by_pose.rightCols<3>() = by_turn;
  rotation.by_before.rightCols<3>() = -by_turn * step.linear().transpose();
  whiten(whitening(epoch.step_rotation_rad2), rotation);
  out.push_back(rotation);
}

}  // namespace

std::vector<TrajectoryTerm> trajectory_terms(const TrajectorySession& session, std::size_t index,
                                             const TrajectoryState& state) {
  const std::vector<RigidTransform>& poses = state.enu_from_lidar[index];
  const OwnVector own = state.own(index);
  const double clock_s = own[kClockAt - kSharedSize];
  std::vector<TrajectoryTerm> terms;
  terms.reserve(4 * session.epochs.size());
  for (std::size_t i = 0; i < session.epochs.size(); ++i) {
    const TrajectoryEpoch& epoch = session.epochs[i];
    if (i > 0) add_step(session, i, poses, own, terms);
    const Place at{poses[i], state.ins_from_lidar, clock_s, clock_s + own[kLagAt - kSharedSize]};
    const std::size_t first = terms.size();
    if (epoch.ins) {
      terms.push_back(ins_position(*epoch.ins, at));
      add_ins_attitude(*epoch.ins, at, terms);
    }
    if (epoch.antenna) terms.push_back(antenna_position(epoch, state, at));
    for (std::size_t k = first; k < terms.size(); ++k) terms[k].epoch = i;
  }
  return terms;
}

}  // namespace remount::calibration
