#include "model/pipeline/drive_motion.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>

#include "algorithms/core/error.h"
#include "algorithms/core/stamps.h"
#include "algorithms/geodesy/geodesy.h"
#include "messages/pipeline.h"
#include "model/conventions/assumed_tilt.h"
#include "model/conventions/impossible_motion.h"
#include "model/pipeline/scan_times.h"

namespace remount::pipeline {

namespace {

constexpr double kOpenLag_s = 1.0;  // what is left of a lag that the drive showed is as open as it was

motion::MotionTrack recorded_track(const drive::Session& session, double sweep_s) {
  return motion::MotionTrack(session.ins.empty() ? session.world_from_ins : geodesy::local_from_ins(session.ins), 0.0,
                             session.ins_fix_stamps_ns, sweep_s);
}

/// Of samples, that which is nearest to each time; ascending.
std::vector<std::int64_t> nearest_stamps_ns(const std::vector<motion::StampedPose>& samples,
                                            const std::vector<std::int64_t>& times_ns, std::int64_t later_ns) {
  std::vector<std::int64_t> stamps_ns;
  for (const std::int64_t time_ns : times_ns) {
    const std::int64_t wanted_ns = time_ns + later_ns;
    auto at =
        std::lower_bound(samples.begin(), samples.end(), wanted_ns,
                         [](const motion::StampedPose& sample, std::int64_t stamp) { return sample.stamp_ns < stamp; });
    if (at == samples.end() || (at != samples.begin() && wanted_ns - (at - 1)->stamp_ns < at->stamp_ns - wanted_ns))
      --at;
    if (stamps_ns.empty() || at->stamp_ns > stamps_ns.back()) stamps_ns.push_back(at->stamp_ns);
  }
  return stamps_ns;
}

}  // namespace

DriveMotion::DriveMotion(std::vector<std::shared_ptr<const drive::Session>> sessions, std::vector<motion::Sweep> swept)
    : sessions_(conventions::possible_sessions(std::move(sessions))), swept_(std::move(swept)) {
  swept_.resize(sessions_.size());
  for (const auto& session : sessions_) {
    tracks_.push_back(recorded_track(*session, swept_[tracks_.size()].length_s()));
    if (tracks_.back().empty())
      throw Error(ErrorCode::Unsupported, session->path.string(), say::pipeline_no_ins_poses());
    offsets_s_.push_back(0.0);
    position_lags_s_.push_back(0.0);
    roundings_.push_back(conventions::attitude_rounding(session->ins));
  }
}

void DriveMotion::set_position_lag_s(motion::SessionIndex index, double lag_s) {
  if (lag_s == position_lags_s_[index]) return;
  const motion::MotionTrack recorded = recorded_track(session(index), swept_[index].length_s());
  const auto lag_ns = static_cast<std::int64_t>(std::llround(lag_s * 1e9));
  std::vector<motion::StampedPose> of_one_moment;
  for (const motion::StampedPose& sample : recorded.samples()) {
    const std::optional<RigidTransform> later = recorded.at(sample.stamp_ns + lag_ns);
    if (!later) continue;
    of_one_moment.push_back(sample);
    of_one_moment.back().pose.translation() = later->translation();
  }
  if (of_one_moment.size() < 2) return;  // no drive is so short that a lag could be told from it
  const std::vector<std::int64_t> fixes_ns =
      nearest_stamps_ns(of_one_moment, session(index).ins_fix_stamps_ns, -lag_ns);
  tracks_[index] = motion::MotionTrack(of_one_moment, recorded.max_gap_s(), fixes_ns, swept_[index].length_s());
  position_lags_s_[index] = lag_s;
}

std::vector<std::int64_t> DriveMotion::lidar_stamps_ns(motion::SessionIndex index) const {
  const drive::Session& drive = session(index);
  std::vector<std::int64_t> stamps;
  if (drive.scans)
    for (std::size_t i = 0; i < drive.scans->size(); ++i) stamps.push_back(drive.scans->stamp_ns(i));
  else
    for (const motion::StampedPose& pose : drive.odometry_from_lidar) stamps.push_back(pose.stamp_ns);
  return stamps;
}

std::optional<RigidTransform> DriveMotion::local_from_ins(motion::SessionIndex index,
                                                          std::int64_t lidar_stamp_ns) const {
  const auto here = passage(index, lidar_stamp_ns);
  return here ? std::optional(here->pose()) : std::nullopt;
}

std::optional<motion::Passage> DriveMotion::passage(motion::SessionIndex index, std::int64_t lidar_stamp_ns) const {
  return track(index).around(lidar_stamp_ns + std::llround(offset_s(index) * 1e9), swept_[index].middle_s());
}

std::vector<calibration::JointNode> DriveMotion::nodes(const std::vector<motion::Keyframe>& keyframes) const {
  std::vector<calibration::JointNode> out;
  for (const motion::Keyframe& keyframe : keyframes) {
    calibration::JointNode node;
    node.session = keyframe.session;
    node.time_s = seconds(keyframe.stamp_ns - track(keyframe.session).samples().front().stamp_ns);
    const auto shift_ns = static_cast<std::int64_t>(std::llround(offset_s(keyframe.session) * 1e9));
    if (const auto shifted =
            track(keyframe.session).around(keyframe.stamp_ns + shift_ns, swept_[keyframe.session].middle_s()))
      node.local_from_ins = shifted->pose();
    else if (const auto unshifted =
                 track(keyframe.session).around(keyframe.stamp_ns, swept_[keyframe.session].middle_s()))
      node.local_from_ins = unshifted->pose();
    if (const auto velocity = track(keyframe.session).body_velocity(keyframe.stamp_ns + shift_ns))
      node.body_velocity = *velocity;
    out.push_back(node);
  }
  add_errors_between_samples(keyframes, out);
  return out;
}

// Poses between the same two samples err alike: all of them say as much as one.
void DriveMotion::add_errors_between_samples(const std::vector<motion::Keyframe>& keyframes,
                                             std::vector<calibration::JointNode>& nodes) const {
  std::map<std::pair<motion::SessionIndex, std::size_t>, double> between;
  std::vector<std::optional<motion::BetweenSamples>> errors;
  for (const motion::Keyframe& keyframe : keyframes) {
    const auto shift_ns = static_cast<std::int64_t>(std::llround(offset_s(keyframe.session) * 1e9));
    errors.push_back(track(keyframe.session).between_samples(keyframe.stamp_ns + shift_ns));
    if (errors.back()) between[{keyframe.session, errors.back()->after}] += 1.0;
  }
  for (std::size_t k = 0; k < nodes.size(); ++k)
    if (errors[k])
      nodes[k].between_samples_covariance = between[{keyframes[k].session, errors[k]->after}] * errors[k]->covariance;
}

std::vector<calibration::SessionNoise> DriveMotion::noise() const {
  std::vector<calibration::SessionNoise> out;
  for (std::size_t s = 0; s < sessions_.size(); ++s)
    out.push_back({tracks_[s].position_noise_factor() * sessions_[s]->ins_position_white_sigma_m,
                   tracks_[s].attitude_noise_factor() * sessions_[s]->ins_attitude_white_sigma_rad,
                   sessions_[s]->ins_attitude_bias_sigma_rad, sessions_[s]->ins_position_drift,
                   sessions_[s]->ins_attitude_drift, conventions::assumed_tilt_sigma_rad(*sessions_[s]),
                   sessions_[s]->ins_north_sigma_rad, roundings_[s].sigma_rad, roundings_[s].lasting_rad,
                   position_lags_s_[s] != 0.0 ? kOpenLag_s : sessions_[s]->ins_position_lag_sigma_s});
  return out;
}

namespace {

bool spans_a_break(const drive::Session& session, std::int64_t from_ns, std::int64_t to_ns) {
  const std::vector<std::int64_t>& breaks = session.odometry_breaks_ns;
  const auto next = std::upper_bound(breaks.begin(), breaks.end(), from_ns);
  return next != breaks.end() && *next <= to_ns;
}

}  // namespace

void keep_independent_odometry(const DriveMotion& motion, const std::vector<motion::Keyframe>& keyframes,
                               std::vector<motion::Pair>& pairs) {
  std::vector<motion::Pair> kept;
  for (const motion::Pair& pair : pairs) {
    const motion::Keyframe& a = keyframes[pair.keyframe_a];
    const motion::Keyframe& b = keyframes[pair.keyframe_b];
    const drive::Session& session = motion.session(a.session);
    const bool scans = session.scans != nullptr;
    if (!scans && spans_a_break(session, a.stamp_ns, b.stamp_ns)) continue;
    const bool first = kept.empty() || kept.back().keyframe_a != pair.keyframe_a;
    if (scans || first) kept.push_back(pair);
  }
  pairs = std::move(kept);
}

namespace {

// Covariance of the LiDAR's motion from one pose to another (axes of the latter) by what it did not tell itself.
// Motions that rest on an assumed mounting would confirm it, all of them alike: what they are off by may have the same
// direction in axes of the vehicle throughout, and is then not known at all; a part is anew with every scan.
// docs/maths/fusion-odometry.md (O16)
Matrix6d untold_covariance(const drive::Session& session, const std::vector<Matrix6d>& untold_motions,
                           motion::ScanIndex from, motion::ScanIndex to) {
  constexpr double kAlike = 30.0, kAnew = 1.0;  // times the motion itself
  Matrix6d anew = Matrix6d::Zero(), alike = Matrix6d::Zero();
  if (untold_motions.empty()) return anew;
  const auto pose = [&](motion::ScanIndex scan) -> const RigidTransform& {
    return session.odometry_from_lidar[scan].pose;
  };
  for (motion::ScanIndex scan(from + 1); scan <= to; ++scan) {
    const Eigen::Vector3d arm = pose(scan).inverse() * pose(from).translation();
    const Eigen::Matrix3d to_axes = pose(to).linear().transpose() * pose(scan).linear();
    Matrix6d carried = Matrix6d::Zero();
    carried.topLeftCorner<3, 3>() = carried.bottomRightCorner<3, 3>() = to_axes;
    carried.topRightCorner<3, 3>() = -to_axes * skew(arm);
    const Matrix6d untold = carried * untold_motions.at(scan);
    anew += untold * untold.transpose();
    alike += untold;
  }
  return kAnew * kAnew * anew + kAlike * kAlike * alike * alike.transpose();
}

}  // namespace

void use_odometry(const DriveMotion& motion, const std::vector<motion::Keyframe>& keyframes,
                  const std::vector<std::vector<Matrix6d>>& untold, std::vector<motion::Pair>& pairs) {
  // No odometry states its errors: a centimetre and a twentieth of a degree, growing with the distance; the noise
  // model's scale is estimated from the residuals.
  constexpr double kTranslation_m = 0.01, kRotation_rad = 0.001, kDrift = 0.002;
  for (motion::Pair& pair : pairs) {
    const motion::Keyframe& a = keyframes[pair.keyframe_a];
    const motion::Keyframe& b = keyframes[pair.keyframe_b];
    const drive::Session& session = motion.session(a.session);
    if (session.scans) continue;
    pair.lidar_b_from_lidar_a =
        session.odometry_from_lidar[b.scan].pose.inverse() * session.odometry_from_lidar[a.scan].pose;
    const double translation_m = std::hypot(kTranslation_m, kDrift * pair.baseline_m);
    const double rotation_rad = std::hypot(kRotation_rad, kDrift * 0.05 * pair.baseline_m);
    pair.registration.attempted = pair.registration.converged = true;
    pair.registration.overlap = 1.0;
    Matrix6d covariance = Matrix6d::Zero();
    if (a.session < untold.size()) covariance = untold_covariance(session, untold[a.session], a.scan, b.scan);
    covariance.diagonal().head<3>().array() += translation_m * translation_m;
    covariance.diagonal().tail<3>().array() += rotation_rad * rotation_rad;
    pair.registration.information = covariance.llt().solve(Matrix6d::Identity());
  }
}

}  // namespace remount::pipeline
