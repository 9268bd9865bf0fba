#include "algorithms/calibration/trajectory/trajectory_start.h"

#include <algorithm>
#include <cmath>

#include "algorithms/calibration/pairwise/robust_start.h"
#include "algorithms/core/median.h"

namespace remount::calibration {
namespace {

Eigen::Vector3d median(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d out;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const Eigen::Vector3d& point : points) values.push_back(point[axis]);
    out[axis] = median_of(std::move(values));
  }
  return out;
}

// The rotation with the least sum of angles to all others: one of them, so that outliers do not tilt it.
Eigen::Matrix3d median(const std::vector<Eigen::Matrix3d>& rotations) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    double sum = 0.0;
    for (const Eigen::Matrix3d& other : rotations) sum += (rotations[i] - other).norm();
    if (sum < least) best = i;
    least = std::min(least, sum);
  }
  return rotations[best];
}

// Motions of INS and LiDAR over a few seconds, for the start of X.
std::vector<motion::Pair> motion_pairs(const TrajectoryProblem& problem, const TrajectoryOptions& options) {
  constexpr std::size_t kMost = 1500;
  constexpr double kGaps_s[] = {2.0, 6.0};
  std::size_t epochs = 0;
  for (const TrajectorySession& session : problem.sessions) epochs += session.epochs.size();
  const std::size_t stride = std::max<std::size_t>(1, 2 * epochs / kMost);
  const double translation = options.odometry_translation_sigma_m;
  const double rotation = degrees_to_radians(options.odometry_rotation_sigma_deg);
  std::vector<motion::Pair> pairs;
  for (const TrajectorySession& session : problem.sessions)
    for (std::size_t b = 0; b < session.epochs.size(); b += stride)
      for (const double gap_s : kGaps_s) {
        const TrajectoryEpoch& to = session.epochs[b];
        std::size_t a = b;
        while (a > 0 && to.time_s - session.epochs[a].time_s < gap_s) --a;
        const TrajectoryEpoch& from = session.epochs[a];
        if (a == b || !to.ins || !from.ins || to.time_s - from.time_s < 0.9 * gap_s) continue;
        motion::Pair pair;
        pair.gap_s = to.time_s - from.time_s;
        pair.ins_b_from_ins_a = to.ins->enu_from_ins.inverse() * from.ins->enu_from_ins;
        pair.lidar_b_from_lidar_a = to.odometry_from_lidar.inverse() * from.odometry_from_lidar;
        pair.baseline_m = pair.ins_b_from_ins_a.translation().norm();
        const double drift = 0.01 * options.odometry_drift_percent * pair.baseline_m;
        const double turn = degrees_to_radians(options.odometry_drift_deg) * pair.baseline_m;
        pair.registration.information.diagonal()
            << Eigen::Vector3d::Constant(1.0 / (translation * translation + drift * drift)),
            Eigen::Vector3d::Constant(1.0 / (rotation * rotation + turn * turn));
        const double twist =
            so3_log(pair.ins_b_from_ins_a.linear()).norm() - so3_log(pair.lidar_b_from_lidar_a.linear()).norm();
        pair.screw.passed = std::abs(twist) < 5.0 * std::hypot(rotation, turn) + 0.01;
        pairs.push_back(pair);
      }
  return pairs;
}

RigidTransform start_of_x(const TrajectoryProblem& problem, const TrajectoryOptions& options,
                          const Progress& progress) {
  const RigidTransform known = problem.nominal_ins_from_lidar.value_or(RigidTransform::Identity());
  const std::vector<motion::Pair> pairs = motion_pairs(problem, options);
  if (pairs.size() < 3) return known;
  std::vector<motion::PairIndex> usable;
  for (motion::PairIndex i; i < pairs.size(); ++i) usable.push_back(i);
  RotationReference reference;
  if (problem.nominal_ins_from_lidar) {
    reference.ins_from_lidar = known.linear();
  } else {
    reference.up_in_lidar = problem.up_in_lidar.value_or(Eigen::Vector3d::UnitZ());  // most stand upright
    reference.allowance = 0.5;  // each stretch of odometry is in many pairs: by chance they fit a sixth better without
  }
  return robust_start(pairs, usable, NoiseModel{}, problem.nominal_ins_from_lidar, reference, known.translation(),
                      progress)
      .ins_from_lidar;
}

// The up to `count` of the ascending indices `seen` that are nearest to i.
std::pair<std::size_t, std::size_t> nearest(const std::vector<std::size_t>& seen, std::size_t i, std::size_t count) {
  const auto here = static_cast<std::size_t>(std::lower_bound(seen.begin(), seen.end(), i) - seen.begin());
  const std::size_t first = std::min(here - std::min(here, count / 2), seen.size() - std::min(seen.size(), count));
  return {first, std::min(seen.size(), first + count)};
}

constexpr std::size_t kAround = 21;

// Each pose as the INS poses around it, carried there by the odometry, say in the median.
std::vector<RigidTransform> through_ins(const TrajectorySession& session, const std::vector<std::size_t>& seen,
                                        const RigidTransform& x) {
  std::vector<RigidTransform> poses;
  for (std::size_t i = 0; i < session.epochs.size(); ++i) {
    const auto [first, last] = nearest(seen, i, kAround);
    std::vector<Eigen::Vector3d> positions;
    std::vector<Eigen::Matrix3d> rotations;
    for (std::size_t k = first; k < last; ++k) {
      const TrajectoryEpoch& other = session.epochs[seen[k]];
      const RigidTransform said =
          other.ins->enu_from_ins * x * other.odometry_from_lidar.inverse() * session.epochs[i].odometry_from_lidar;
      positions.push_back(said.translation());
      rotations.push_back(said.linear());
    }
    poses.push_back(make_rigid(median(rotations), median(positions)));
  }
  return poses;
}

// enu_from_odometry by points (Kabsch 1976), reweighted so that outliers lose their say.
RigidTransform laid_through(const std::vector<Eigen::Vector3d>& in_odometry, const std::vector<Eigen::Vector3d>& in_enu,
                            const Eigen::Vector3d& up_in_odometry) {
  constexpr int kRounds = 30;
  constexpr double kUp = 1e-3;  // decides where the points do not
  std::vector<double> weights(in_enu.size(), 1.0);
  Eigen::Vector3d from = median(in_odometry), to = median(in_enu);
  RigidTransform out = RigidTransform::Identity();
  for (int round = 0; round < kRounds; ++round) {
    Eigen::Matrix3d correlation = Eigen::Matrix3d::Zero();
    double spread = 0.0;
    for (std::size_t k = 0; k < in_enu.size(); ++k) {
      correlation += weights[k] * (in_enu[k] - to) * (in_odometry[k] - from).transpose();
      spread += weights[k] * (in_odometry[k] - from).squaredNorm();
    }
    correlation += (kUp * spread + 1e-9) * Eigen::Vector3d::UnitZ() * up_in_odometry.transpose();
    out.linear() = nearest_rotation(correlation);
    std::vector<double> squares;
    for (std::size_t k = 0; k < in_enu.size(); ++k)
      squares.push_back((in_enu[k] - to - out.linear() * (in_odometry[k] - from)).squaredNorm());
    const double scale2 = std::max(1e-6, 4.0 * median_of(squares));
    double sum = 0.0;
    from.setZero();
    to.setZero();
    for (std::size_t k = 0; k < in_enu.size(); ++k) {
      const double share = scale2 / (scale2 + squares[k]);
      weights[k] = share * share;
      sum += weights[k];
      from += weights[k] * in_odometry[k];
      to += weights[k] * in_enu[k];
    }
    from /= sum;
    to /= sum;
  }
  out.translation() = to - out.linear() * from;
  return out;
}

std::vector<RigidTransform> through_fixes(const TrajectorySession& session, const std::vector<std::size_t>& seen) {
  std::vector<Eigen::Vector3d> in_odometry, in_enu;
  for (const std::size_t i : seen) {
    in_odometry.push_back(session.epochs[i].odometry_from_lidar.translation());
    in_enu.push_back(session.epochs[i].antenna->position_enu_m);
  }
  const Eigen::Vector3d up = session.epochs.front().odometry_from_lidar.linear().col(2);
  const RigidTransform enu_from_odometry = laid_through(in_odometry, in_enu, up);
  std::vector<RigidTransform> poses;
  for (std::size_t i = 0; i < session.epochs.size(); ++i) {
    RigidTransform pose = enu_from_odometry * session.epochs[i].odometry_from_lidar;
    const auto [first, last] = nearest(seen, i, kAround);
    std::vector<Eigen::Vector3d> away;
    for (std::size_t k = first; k < last; ++k) away.push_back(in_enu[k] - enu_from_odometry * in_odometry[k]);
    pose.translation() += median(away);
    poses.push_back(pose);
  }
  return poses;
}

}  // namespace

TrajectorySolution start_trajectory(const TrajectoryProblem& problem, const TrajectoryOptions& options,
                                    const Progress& progress) {
  TrajectorySolution start;
  TrajectoryState& state = start.state;
  state.ins_from_lidar = start_of_x(problem, options, progress);
  for (const TrajectorySession& session : problem.sessions) {
    std::vector<std::size_t> with_ins, with_fix;
    for (std::size_t i = 0; i < session.epochs.size(); ++i) {
      if (session.epochs[i].ins) with_ins.push_back(i);
      if (session.epochs[i].antenna) with_fix.push_back(i);
    }
    std::vector<RigidTransform> poses;
    if (!with_ins.empty())
      poses = through_ins(session, with_ins, state.ins_from_lidar);
    else if (!with_fix.empty())
      poses = through_fixes(session, with_fix);
    else
      for (const TrajectoryEpoch& epoch : session.epochs) poses.push_back(epoch.odometry_from_lidar);
    state.enu_from_lidar.push_back(std::move(poses));
    state.scale.push_back(0.0);
    state.clock_s.push_back(0.0);
  }
  return start;
}

}  // namespace remount::calibration
