#include <algorithm>
#include <cmath>

#include "algorithms/calibration/pairwise/noise_prior.h"
#include "algorithms/calibration/pairwise/uncertainty.h"
#include "algorithms/core/median.h"
#include "algorithms/core/stamps.h"
#include "algorithms/geodesy/local_level.h"
#include "algorithms/motion/motion_track.h"
#include "model/conventions/assumed_tilt.h"
#include "model/conventions/attitude_rounding.h"
#include "model/method_registry/method_needs.h"
#include "model/methods/trajectory/trajectory_feed.h"

namespace remount::methods {
namespace {

// Of items in the order of their stamps the first that is not earlier: what lies far back costs nothing.
template <class Item>
auto first_since(const std::vector<Item>& items, std::int64_t since_ns) {
  return std::lower_bound(items.begin(), items.end(), since_ns,
                          [](const Item& item, std::int64_t stamp_ns) { return item.stamp_ns < stamp_ns; });
}

// INS and GNSS of one session in one metric frame.
struct Positions {
  motion::MotionTrack enu_from_ins;
  std::vector<calibration::AntennaObservation> fixes;
  std::vector<std::int64_t> fix_stamps_ns;
};

// Samples before a range that epochs within it may still hang on: smoothing, and how rough the track is.
std::int64_t needed_since_ns(const EpochRange& range) {
  constexpr std::int64_t kBefore_ns = 30'000'000'000;
  return std::max(range.since_ns, std::numeric_limits<std::int64_t>::min() + kBefore_ns) - kBefore_ns;
}

Positions positions_of(const drive::Session& session, std::int64_t since_ns) {
  Positions out;
  std::optional<geodesy::LocalLevel> level;
  if (!session.ins.empty())
    level.emplace(session.ins.front().latitude_rad, session.ins.front().longitude_rad, session.ins.front().height_m);
  else if (!session.gnss.empty())
    level.emplace(session.gnss.front().latitude_rad, session.gnss.front().longitude_rad, session.gnss.front().height_m);
  std::vector<motion::StampedPose> poses(first_since(session.world_from_ins, since_ns), session.world_from_ins.end());
  for (auto sample = first_since(session.ins, since_ns); sample != session.ins.end(); ++sample)
    if (sample->quality != motion::InsQuality::Invalid)
      poses.push_back({sample->stamp_ns, level->enu_from_ins(*sample)});
  out.enu_from_ins = motion::MotionTrack(poses, 0.0, session.ins_fix_stamps_ns);
  // Poses in somebody's world have no place on the globe that fixes could be brought to.
  if (!session.world_from_ins.empty()) return out;
  for (auto at = first_since(session.gnss, since_ns); at != session.gnss.end(); ++at) {
    const motion::GnssFix& fix = *at;
    // No fix is exact, whatever its receiver states.
    constexpr double kLeast_m2 = 1e-6;
    out.fixes.push_back(
        {level->position_enu_m(fix), level->covariance_enu_m2(fix) + kLeast_m2 * Eigen::Matrix3d::Identity()});
    out.fix_stamps_ns.push_back(fix.stamp_ns);
  }
  return out;
}

// Stamps of the epochs: LiDAR poses thinned where there is an INS, and all fixes. Those of fixes carry their index.
struct EpochStamp {
  std::int64_t stamp_ns = 0;
  std::optional<std::size_t> fix;
};

std::vector<EpochStamp> epoch_stamps(const std::vector<odometry::OdometryPose>& poses, const Positions& positions,
                                     double interval_s, double clock_s, const EpochRange& range) {
  std::vector<EpochStamp> stamps;
  const auto within = [&range](std::int64_t stamp_ns) {
    return stamp_ns >= range.since_ns && stamp_ns <= range.until_ns;
  };
  const auto shift_ns = static_cast<std::int64_t>(std::llround(clock_s * 1e9));
  const auto interval_ns = static_cast<std::int64_t>(std::llround(interval_s * 1e9)) - 1'000'000;
  if (!positions.enu_from_ins.empty())
    for (auto pose = first_since(poses, range.since_ns); pose != poses.end(); ++pose)
      if (within(pose->stamp_ns) && (stamps.empty() || pose->stamp_ns - stamps.back().stamp_ns >= interval_ns))
        stamps.push_back({pose->stamp_ns, std::nullopt});
  for (std::size_t k = 0; k < positions.fixes.size(); ++k) {
    const std::int64_t stamp_ns = positions.fix_stamps_ns[k] - shift_ns;
    if (!poses.empty() && stamp_ns >= poses.front().stamp_ns && stamp_ns <= poses.back().stamp_ns && within(stamp_ns))
      stamps.push_back({stamp_ns, k});
  }
  // A fix at the very stamp of a pose comes first, and stands for both.
  std::stable_sort(stamps.begin(), stamps.end(), [](const EpochStamp& a, const EpochStamp& b) {
    return std::pair(a.stamp_ns, !a.fix) < std::pair(b.stamp_ns, !b.fix);
  });
  constexpr std::int64_t kSame_ns = 1'000'000;
  std::vector<EpochStamp> apart;
  for (const EpochStamp& stamp : stamps)
    if (apart.empty() || stamp.stamp_ns - apart.back().stamp_ns >= kSame_ns)
      apart.push_back(stamp);
    else if (stamp.fix && !apart.back().fix)
      apart.back() = stamp;
  return apart;
}

struct InsNoise {
  double position_m, attitude_rad, position_drift, attitude_drift, bias_rad, assumed_tilt_rad, unmeasured_height_m,
      north_rad;
  bool attitude_declared, declared;
};

// As in pairwise calibration: what a log declares, else what the options assume. Data that declare their white noise
// and no drift have none.
InsNoise ins_noise(const drive::Session& session, const motion::MotionTrack& track,
                   const calibration::SolveOptions& assumed) {
  const bool declared =
      std::isfinite(session.ins_position_white_sigma_m) && std::isfinite(session.ins_attitude_white_sigma_rad);
  constexpr double kLeast_m = 1e-4, kLeast_rad = 1e-6;
  InsNoise out{};
  out.declared = declared;
  out.attitude_declared = std::isfinite(session.ins_attitude_white_sigma_rad);
  out.position_m =
      std::max(kLeast_m, track.position_noise_factor() *
                             calibration::known_or(session.ins_position_white_sigma_m, assumed.ins_position_sigma_m));
  out.attitude_rad =
      std::max(kLeast_rad, track.attitude_noise_factor() *
                               calibration::known_or(session.ins_attitude_white_sigma_rad,
                                                     degrees_to_radians(assumed.ins_attitude_sigma_deg)));
  if (!track.empty()) {
    out.position_drift =
        calibration::known_or(session.ins_position_drift, declared ? 0.0 : assumed.ins_position_drift_m);
    out.attitude_drift = calibration::known_or(session.ins_attitude_drift,
                                               declared ? 0.0 : degrees_to_radians(assumed.ins_attitude_drift_deg));
  }
  out.assumed_tilt_rad = conventions::assumed_tilt_sigma_rad(session);
  out.unmeasured_height_m = session.unmeasured_height_sigma_m;
  out.north_rad = session.ins_north_sigma_rad;
  const conventions::AttitudeRounding rounding = conventions::attitude_rounding(session.ins);
  out.attitude_rad = std::hypot(out.attitude_rad, rounding.sigma_rad);
  out.bias_rad = std::hypot(calibration::known_or(session.ins_attitude_bias_sigma_rad,
                                                  degrees_to_radians(assumed.ins_attitude_bias_sigma_deg)),
                            rounding.lasting_rad);
  return out;
}

// Poses of the INS closer than this share samples: those between two samples, and those smoothed over the same ones.
std::int64_t independent_after_ns(const drive::Session& session, const motion::MotionTrack& track) {
  constexpr std::int64_t kSmoothed_ns = 200'000'000;
  const bool smoothed = track.position_noise_factor() < 1.0 || track.attitude_noise_factor() < 1.0;
  std::vector<std::int64_t> stamps_ns = session.ins_fix_stamps_ns;
  if (stamps_ns.empty())
    for (const motion::StampedPose& sample : track.samples()) stamps_ns.push_back(sample.stamp_ns);
  std::vector<std::int64_t> apart_ns;
  for (std::size_t i = 1; i < stamps_ns.size(); ++i) apart_ns.push_back(stamps_ns[i] - stamps_ns[i - 1]);
  if (apart_ns.empty()) return 0;
  const std::int64_t usual_ns = median_of(std::move(apart_ns));
  return smoothed ? std::max(usual_ns, kSmoothed_ns) : usual_ns;
}

// What lies between two epochs and neither pose tells: maps that began at an uncertain pose, and stretches whose
// surroundings let the map slide. A scan that only failed leaves no trace, for the map stayed.
Matrix6d lost_between(const std::vector<odometry::OdometryPose>& poses, std::int64_t before_ns, std::int64_t here_ns) {
  Matrix6d sum = Matrix6d::Zero();
  auto pose =
      std::upper_bound(poses.begin(), poses.end(), before_ns,
                       [](std::int64_t stamp, const odometry::OdometryPose& one) { return stamp < one.stamp_ns; });
  for (; pose != poses.end() && pose->stamp_ns < here_ns; ++pose) {
    const bool began = pose != poses.begin() && pose->map != (pose - 1)->map;
    if (began || !pose->undetermined.empty()) sum += pose->covariance;
  }
  return sum;
}

const odometry::OdometryPose& nearest_pose(const std::vector<odometry::OdometryPose>& poses, std::int64_t stamp_ns) {
  const auto after =
      std::lower_bound(poses.begin(), poses.end(), stamp_ns,
                       [](const odometry::OdometryPose& pose, std::int64_t stamp) { return pose.stamp_ns < stamp; });
  if (after == poses.end()) return poses.back();
  if (after == poses.begin()) return poses.front();
  return stamp_ns - (after - 1)->stamp_ns < after->stamp_ns - stamp_ns ? *(after - 1) : *after;
}

// Between the poses before and after.
double poses_apart_s(const std::vector<odometry::OdometryPose>& poses, std::int64_t stamp_ns) {
  if (poses.size() < 2) return 0.0;
  const auto after =
      std::lower_bound(poses.begin() + 1, poses.end() - 1, stamp_ns,
                       [](const odometry::OdometryPose& pose, std::int64_t stamp) { return pose.stamp_ns < stamp; });
  return seconds(after->stamp_ns - (after - 1)->stamp_ns);
}

// Of the motion between two epochs: the errors of both poses and of what was lost between them, what grows with the
// distance, and the walk of the INS, which no step can tell from that of the odometry. A step that is only a `part` of
// the way between two poses has that part of the variance of the whole: however many fixes come between the poses, all
// steps together are as uncertain.
void set_step(const Matrix6d& of_poses, double distance_m, double time_s, double part, const InsNoise& ins,
              const calibration::TrajectoryOptions& options, calibration::TrajectoryEpoch& epoch) {
  const double drift = 0.01 * options.odometry_drift_percent * distance_m;
  const double turn = degrees_to_radians(options.odometry_drift_deg) * distance_m;
  epoch.step_translation_m2 = part * of_poses.topLeftCorner<3, 3>();
  epoch.step_translation_m2.diagonal().array() +=
      drift * drift / part + ins.position_drift * ins.position_drift * time_s;
  epoch.step_rotation_rad2 = part * of_poses.bottomRightCorner<3, 3>();
  epoch.step_rotation_rad2.diagonal().array() += turn * turn / part + ins.attitude_drift * ins.attitude_drift * time_s;
}

// Makes the epochs of one session.
class EpochMaker {
 public:
  EpochMaker(const drive::Session& session, const SessionOdometry& odometry, const settings::Settings& settings,
             const SessionTimes& times, const EpochRange& range)
      : poses_(odometry.poses),
        options_(settings.trajectory),
        positions_(positions_of(session, needed_since_ns(range))),
        noise_(ins_noise(session, positions_.enu_from_ins, settings.solve)),
        clock_s_(times.clock_s),
        position_lag_s_(times.position_lag_s),
        range_(range) {
    if (!times.with_fixes && !positions_.enu_from_ins.empty()) {
      positions_.fixes.clear();
      positions_.fix_stamps_ns.clear();
    }
    std::vector<motion::StampedPose> stamped;
    for (auto pose = first_since(poses_, needed_since_ns(range)); pose != poses_.end(); ++pose)
      stamped.push_back({pose->stamp_ns, pose->odometry_from_lidar});
    track_ = motion::MotionTrack(stamped);
    // Fixes may come more often than poses of the INS are to be taken.
    constexpr std::int64_t kSame_ns = 1'000'000;
    ins_apart_ns_ = std::max(independent_after_ns(session, positions_.enu_from_ins),
                             static_cast<std::int64_t>(std::llround(options_.state_interval_s * 1e9))) -
                    kSame_ns;
  }

  void describe(calibration::TrajectorySession& out) const {
    constexpr double kUndeclaredAttitude_rad = 0.005;  // as in pairwise calibration
    out.assumed_tilt_sigma_rad = noise_.assumed_tilt_rad;
    out.unmeasured_height_sigma_m = noise_.unmeasured_height_m;
    out.north_sigma_rad = noise_.north_rad;
    out.doubtful_attitude_rad = noise_.attitude_declared ? 0.0 : kUndeclaredAttitude_rad;
    out.ins_noise_stated = noise_.declared && !positions_.enu_from_ins.empty();
    out.unseen = calibration::registration_limits(false);
    out.unseen.diagonal().tail<3>().array() += noise_.bias_rad * noise_.bias_rad;
  }

  void add_epochs(std::vector<calibration::TrajectoryEpoch>& epochs) {
    if (poses_.empty()) return;
    for (const EpochStamp& stamp : epoch_stamps(poses_, positions_, options_.state_interval_s, clock_s_, range_)) {
      std::optional<calibration::TrajectoryEpoch> epoch = epoch_at(stamp);
      if (!epoch) continue;
      if (!epochs.empty()) link(epochs.back(), stamp.stamp_ns, *epoch);
      epochs.push_back(std::move(*epoch));
    }
    if (noise_.assumed_tilt_rad > 0.0) set_assumed_tilt(epochs);
  }

 private:
  // What is assumed lasts: the poses of the INS say together what one says.
  void set_assumed_tilt(std::vector<calibration::TrajectoryEpoch>& epochs) const {
    double count = 0.0;
    for (const calibration::TrajectoryEpoch& epoch : epochs) count += epoch.ins ? 1.0 : 0.0;
    for (calibration::TrajectoryEpoch& epoch : epochs) {
      if (!epoch.ins) continue;
      epoch.ins->assumed_tilt_sigma_rad = std::sqrt(count) * noise_.assumed_tilt_rad;
      epoch.ins->unmeasured_height_sigma_m = std::sqrt(count) * noise_.unmeasured_height_m;
    }
  }

  // With the position that was logged so much later, where positions are older than attitudes.
  std::optional<RigidTransform> of_one_moment(const motion::Passage& passage, std::int64_t on_ins_clock_ns) const {
    if (position_lag_s_ == 0.0) return passage.pose();
    const auto later = positions_.enu_from_ins.around(on_ins_clock_ns + std::llround(1e9 * position_lag_s_));
    if (!later) return std::nullopt;
    return make_rigid(passage.pose().linear(), later->pose().translation());
  }

  // Of the pose of one moment, in body axes. The velocity is that of the positions: at another time its errors would be
  // those of the position that is logged there, and a lag would seem to be what they make of it.
  Vector6d velocity_of_one_moment(const RigidTransform& pose, std::int64_t on_ins_clock_ns) const {
    const motion::MotionTrack& track = positions_.enu_from_ins;
    Vector6d velocity = track.body_velocity(on_ins_clock_ns).value_or(Vector6d::Zero());
    const std::int64_t later_ns = on_ins_clock_ns + std::llround(1e9 * position_lag_s_);
    const std::optional<motion::Passage> later = position_lag_s_ == 0.0 ? std::nullopt : track.around(later_ns);
    const std::optional<Vector6d> there = later ? track.body_velocity(later_ns) : std::nullopt;
    if (there) velocity.head<3>() = pose.linear().transpose() * later->pose().linear() * there->head<3>();
    return velocity;
  }

  // Nothing where neither INS nor GNSS says anything, or the LiDAR's pose is not known.
  std::optional<calibration::TrajectoryEpoch> epoch_at(const EpochStamp& stamp) {
    const std::optional<RigidTransform> lidar = track_.at(stamp.stamp_ns);
    if (!lidar) return std::nullopt;
    const std::int64_t on_ins_clock_ns = stamp.stamp_ns + static_cast<std::int64_t>(std::llround(clock_s_ * 1e9));
    calibration::TrajectoryEpoch epoch;
    epoch.time_s = seconds(stamp.stamp_ns - poses_.front().stamp_ns);
    epoch.odometry_from_lidar = *lidar;
    epoch.lidar_velocity = track_.body_velocity(stamp.stamp_ns).value_or(Vector6d::Zero());
    if (stamp.fix) epoch.antenna = positions_.fixes[*stamp.fix];
    const std::optional<motion::Passage> passage = positions_.enu_from_ins.around(on_ins_clock_ns);
    const std::optional<RigidTransform> pose = passage ? of_one_moment(*passage, on_ins_clock_ns) : std::nullopt;
    if (pose && (!last_ins_ns_ || stamp.stamp_ns - *last_ins_ns_ >= ins_apart_ns_)) {
      const motion::BetweenSamples between =
          positions_.enu_from_ins.between_samples(on_ins_clock_ns).value_or(motion::BetweenSamples{});
      const Vector6d spread = between.covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
      epoch.ins = calibration::InsObservation{*pose, velocity_of_one_moment(*pose, on_ins_clock_ns),
                                              std::hypot(noise_.position_m, spread.head<3>().maxCoeff()),
                                              std::hypot(noise_.attitude_rad, spread.tail<3>().maxCoeff())};
      last_ins_ns_ = stamp.stamp_ns;
    }
    if (!epoch.ins && !epoch.antenna) return std::nullopt;
    return epoch;
  }

  // What the odometry says of the motion since the epoch before.
  void link(const calibration::TrajectoryEpoch& before, std::int64_t stamp_ns,
            calibration::TrajectoryEpoch& epoch) const {
    const auto before_ns = poses_.front().stamp_ns + static_cast<std::int64_t>(std::llround(before.time_s * 1e9));
    const double distance_m =
        (epoch.odometry_from_lidar.translation() - before.odometry_from_lidar.translation()).norm();
    const odometry::OdometryPose& from = nearest_pose(poses_, before_ns);
    const odometry::OdometryPose& to = nearest_pose(poses_, stamp_ns);
    const double time_s = epoch.time_s - before.time_s;
    const double part = std::min(1.0, time_s / poses_apart_s(poses_, stamp_ns));
    set_step(from.covariance + to.covariance + lost_between(poses_, from.stamp_ns, to.stamp_ns), distance_m, time_s,
             part, noise_, options_, epoch);
  }

  const std::vector<odometry::OdometryPose>& poses_;
  const calibration::TrajectoryOptions& options_;
  Positions positions_;
  InsNoise noise_;
  double clock_s_, position_lag_s_;
  EpochRange range_;
  motion::MotionTrack track_;
  std::int64_t ins_apart_ns_ = 0;
  std::optional<std::int64_t> last_ins_ns_;
};

}  // namespace

calibration::TrajectorySession trajectory_session(const drive::Session& session, const SessionOdometry& odometry,
                                                  const settings::Settings& settings, const SessionTimes& times,
                                                  const EpochRange& range) {
  calibration::TrajectorySession out;
  EpochMaker maker(session, odometry, settings, times, range);
  maker.describe(out);
  out.odometry_over_scans = method_registry::has_scans(session);
  maker.add_epochs(out.epochs);
  return out;
}

}  // namespace remount::methods
