#include "model/conventions/attitude_columns.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "algorithms/core/index.h"
#include "algorithms/motion/motion_track.h"
#include "messages/checks.h"
#include "model/conventions/assumed_tilt.h"
#include "model/conventions/travel_steps.h"
#include "model/drive/session_frames.h"

namespace remount::conventions {
namespace {

/// What may have been done to pitch and roll: bits of a number, 0 for nothing.
enum Mixup : unsigned { kPitchNegated = 1, kRollNegated = 2, kExchanged = 4 };
constexpr unsigned kMixups = 8;
/// How badly each fits what was observed: mean squares.
using Misfits = std::array<double, kMixups>;

constexpr double kFarBetterMisfit = 0.25;  ///< of the misfit as declared
constexpr double kAsGood = 2.0;            ///< times the best misfit
constexpr std::size_t kFewSamples = 20, kFewTurns = 12;
constexpr std::size_t kFewInBlock = 4;  ///< half a second of fewer says nothing

/// Pitch and roll as they would be without that mixup. Axes of the INS: forward, left, up.
Eigen::Matrix3d without(unsigned mixup, const Eigen::Matrix3d& world_from_ins) {
  YawPitchRoll angles = yaw_pitch_roll_from_rotation(world_from_ins);
  if (mixup & kPitchNegated) angles.pitch_rad = -angles.pitch_rad;
  if (mixup & kRollNegated) angles.roll_rad = -angles.roll_rad;
  if (mixup & kExchanged) std::swap(angles.pitch_rad, angles.roll_rad);
  return rotation_from_yaw_pitch_roll(angles);
}

double variance(const std::vector<double>& values) {
  double sum = 0.0, squares = 0.0;
  const double count = static_cast<double>(values.size());
  for (const double value : values) sum += value, squares += value * value;
  return std::max(0.0, squares / count - sum * sum / (count * count));
}

/// The path climbs where the nose points up.
std::optional<Misfits> misfits_of_slope(const std::vector<TravelStep>& steps) {
  constexpr double kLeastSlope_rad = 1.0 * kPi / 180.0;  ///< 1-sigma
  constexpr double kForward = 0.8;  ///< of the usual direction in the vehicle: backwards, the nose points down uphill
  Eigen::Vector3d usual = Eigen::Vector3d::Zero();
  for (const TravelStep& step : steps) usual += step.world_from_ins.transpose() * step.direction;
  usual.normalize();
  std::vector<double> slopes;
  std::array<std::vector<double>, kMixups> errors;
  for (const TravelStep& step : steps) {
    const double level = step.direction.head<2>().norm();
    if (usual.dot(step.world_from_ins.transpose() * step.direction) < kForward || level < 0.5) continue;
    slopes.push_back(step.direction.z() / level);
    for (unsigned mixup = 0; mixup < kMixups; ++mixup) {
      const Eigen::Vector3d up = without(mixup, step.world_from_ins).col(2);
      const double nose_up = -up.head<2>().dot(step.direction.head<2>()) / (level * std::max(up.z(), 0.1));
      errors[mixup].push_back(slopes.back() - nose_up);
    }
  }
  if (slopes.size() < kFewSamples || variance(slopes) < kLeastSlope_rad * kLeastSlope_rad) return std::nullopt;
  Misfits misfits;
  for (unsigned mixup = 0; mixup < kMixups; ++mixup) misfits[mixup] = variance(errors[mixup]);
  // What explains no slope at all is no alternative.
  if (*std::min_element(misfits.begin(), misfits.end()) > kFarBetterMisfit * variance(slopes)) return std::nullopt;
  return misfits;
}

/// Mean square of what is left between vectors that one body sees in two sets of axes, which are turned to fit. With
/// `shifted` a constant difference is left out: the bias of a sensor.
double misfit_of_axes(const std::vector<Eigen::Vector3d>& ours, const std::vector<Eigen::Vector3d>& theirs,
                      bool shifted) {
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < ours.size(); ++i) products += theirs[i] * ours[i].transpose();
  const Eigen::Matrix3d theirs_from_ours = nearest_rotation(products);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double squares = 0.0;
  const double count = static_cast<double>(ours.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const Eigen::Vector3d left = theirs[i] - theirs_from_ours * ours[i];
    mean += left / count;
    squares += left.squaredNorm() / count;
  }
  return shifted ? squares - mean.squaredNorm() : squares;
}

/// Half a second of the drive: what INS and IMU say of it on average.
struct TimeBlock {
  Eigen::Vector3d position = Eigen::Vector3d::Zero(), force = Eigen::Vector3d::Zero();
  std::array<Eigen::Vector3d, kMixups> up_in_ins;
  Eigen::Matrix3d world_from_ins = Eigen::Matrix3d::Identity();  ///< of its middle
  std::size_t poses = 0, forces = 0;
};

std::vector<TimeBlock> blocks_of(const std::vector<motion::StampedPose>& poses,
                                 const std::vector<motion::ImuSample>& imu, std::int64_t length_ns) {
  std::vector<TimeBlock> blocks;
  if (poses.empty() || imu.empty()) return blocks;
  const std::int64_t start_ns = poses.front().stamp_ns, count = (poses.back().stamp_ns - start_ns) / length_ns;
  // Stamps that are far apart promise blocks that nothing fills.
  if (count < 3 || static_cast<std::size_t>(count) > poses.size() / kFewInBlock) return blocks;
  blocks.resize(static_cast<std::size_t>(count));
  const auto block_at = [&](std::int64_t stamp_ns) -> TimeBlock* {
    const std::int64_t number = stamp_ns < start_ns ? -1 : (stamp_ns - start_ns) / length_ns;
    return number >= 0 && number < count ? &blocks[index_at(number)] : nullptr;
  };
  for (TimeBlock& block : blocks) block.up_in_ins.fill(Eigen::Vector3d::Zero());
  for (const motion::StampedPose& pose : poses) {
    TimeBlock* block = block_at(pose.stamp_ns);
    if (block == nullptr) continue;
    block->position += pose.pose.translation();
    for (unsigned mixup = 0; mixup < kMixups; ++mixup)
      block->up_in_ins[mixup] += without(mixup, pose.pose.linear()).row(2).transpose();
    if ((pose.stamp_ns - start_ns) % length_ns <= length_ns / 2) block->world_from_ins = pose.pose.linear();
    ++block->poses;
  }
  for (const motion::ImuSample& sample : imu)
    if (TimeBlock* block = block_at(sample.stamp_ns); block != nullptr && sample.specific_force_mps2.allFinite())
      block->force += sample.specific_force_mps2, ++block->forces;
  for (TimeBlock& block : blocks) {
    const double poses_in = static_cast<double>(std::max<std::size_t>(block.poses, 1));
    block.position /= poses_in;
    for (Eigen::Vector3d& up : block.up_in_ins) up /= poses_in;
    block.force /= static_cast<double>(std::max<std::size_t>(block.forces, 1));
  }
  return blocks;
}

/// An IMU feels gravity and every acceleration of the path, both along axes that the attitude turns into the world.
std::optional<Misfits> misfits_of_force(const drive::Session& session, const std::vector<motion::StampedPose>& poses) {
  constexpr std::int64_t kBlock_ns = 500'000'000;
  constexpr double kBlock_s = 0.5, kGravity_mps2 = 9.81;
  const std::vector<TimeBlock> blocks = blocks_of(poses, session.imu, kBlock_ns);
  std::vector<Eigen::Vector3d> felt;
  std::array<std::vector<Eigen::Vector3d>, kMixups> expected;
  for (std::size_t k = 1; k + 1 < blocks.size(); ++k) {
    const TimeBlock &before = blocks[k - 1], &here = blocks[k], &after = blocks[k + 1];
    const auto full = [](const TimeBlock& block) { return block.poses >= kFewInBlock && block.forces >= kFewInBlock; };
    if (!full(before) || !full(here) || !full(after)) continue;
    const Eigen::Vector3d acceleration =
        (after.position - 2.0 * here.position + before.position) / (kBlock_s * kBlock_s);
    // Second differences of means see an acceleration through these weights: all else must be seen so, too.
    const auto smooth = [&](const auto& of) { return ((of(before) + 4.0 * of(here) + of(after)) / 6.0).eval(); };
    felt.push_back(smooth([](const TimeBlock& block) { return block.force; }));
    for (unsigned mixup = 0; mixup < kMixups; ++mixup)
      expected[mixup].push_back(without(mixup, here.world_from_ins).transpose() * acceleration +
                                kGravity_mps2 * smooth([&](const TimeBlock& block) { return block.up_in_ins[mixup]; }));
  }
  if (felt.size() < kFewSamples) return std::nullopt;
  Misfits misfits;
  for (unsigned mixup = 0; mixup < kMixups; ++mixup) misfits[mixup] = misfit_of_axes(expected[mixup], felt, true);
  return misfits;
}

/// Two sensors of one body turn alike: about axes that one fixed rotation takes to each other.
std::optional<Misfits> misfits_of_turns(const std::vector<SharedTurn>& turns) {
  constexpr double kAlike = 0.3, kNoise_rad = 0.01;
  std::vector<Eigen::Vector3d> theirs;
  std::array<std::vector<Eigen::Vector3d>, kMixups> ours;
  for (const SharedTurn& turn : turns) {
    const Eigen::Vector3d other = so3_log(turn.other_b_from_other_a);
    const double angle = so3_log(turn.world_from_ins_b.transpose() * turn.world_from_ins_a).norm();
    // Registrations that failed are none of the attitude's business; a mixup of small angles changes axes only.
    if (std::abs(angle - other.norm()) > kAlike * std::max(angle, other.norm()) + kNoise_rad) continue;
    theirs.push_back(other);
    for (unsigned mixup = 0; mixup < kMixups; ++mixup)
      ours[mixup].push_back(
          so3_log(without(mixup, turn.world_from_ins_b).transpose() * without(mixup, turn.world_from_ins_a)));
  }
  if (theirs.size() < kFewTurns) return std::nullopt;
  Misfits misfits;
  for (unsigned mixup = 0; mixup < kMixups; ++mixup) misfits[mixup] = misfit_of_axes(ours[mixup], theirs, false);
  return misfits;
}

/// From pose to pose of the LiDAR's odometry, a second apart.
std::vector<SharedTurn> turns_of_odometry(const drive::Session& session,
                                          const std::vector<motion::StampedPose>& poses) {
  constexpr std::int64_t kApart_ns = 1'000'000'000, kGap_ns = 3'000'000'000;
  if (session.odometry_from_lidar.empty()) return {};
  const motion::MotionTrack track(poses);
  std::vector<SharedTurn> turns;
  const motion::StampedPose* before = nullptr;
  std::optional<RigidTransform> ins_before;
  for (const motion::StampedPose& pose : session.odometry_from_lidar) {
    if (before != nullptr && pose.stamp_ns - before->stamp_ns < kApart_ns) continue;
    const std::optional<RigidTransform> ins = track.at(pose.stamp_ns);
    const auto broken = std::upper_bound(session.odometry_breaks_ns.begin(), session.odometry_breaks_ns.end(),
                                         before == nullptr ? 0 : before->stamp_ns);
    const bool whole = broken == session.odometry_breaks_ns.end() || *broken > pose.stamp_ns;
    if (ins && ins_before && whole && pose.stamp_ns - before->stamp_ns < kGap_ns)
      turns.push_back({ins_before->linear(), ins->linear(), pose.pose.linear().transpose() * before->pose.linear()});
    before = &pose;
    ins_before = ins;
  }
  return turns;
}

/// Those that fit far better than what is declared, as bits; 0 where none does.
unsigned suspects(const std::optional<Misfits>& misfits) {
  if (!misfits) return 0;
  const double best = *std::min_element(misfits->begin(), misfits->end());
  if (!(best < kFarBetterMisfit * (*misfits)[0])) return 0;
  unsigned found = 0;
  for (unsigned mixup = 1; mixup < kMixups; ++mixup)
    if ((*misfits)[mixup] <= std::min(kAsGood * best, kFarBetterMisfit * (*misfits)[0])) found |= 1U << mixup;
  return found;
}

/// Of several that fit, the one that happens most easily.
Message words_of(unsigned found) {
  const auto among = [&](unsigned mixup) { return (found >> mixup & 1U) != 0; };
  if (among(kPitchNegated) && among(kRollNegated)) return say::tilt_one_or_exchanged();
  if (among(kPitchNegated)) return say::tilt_pitch_negated();
  if (among(kRollNegated)) return say::tilt_roll_negated();
  if (among(kExchanged) || among(kExchanged | kPitchNegated | kRollNegated)) return say::tilt_exchanged();
  if (among(kPitchNegated | kRollNegated)) return say::tilt_both_negated();
  return say::tilt_exchanged_and_negated();
}

drive::Finding finding_of(unsigned found, Message witness, const std::string& where) {
  return {drive::Severity::Problem, kAttitudeColumns, where, say::tilt_columns(std::move(witness), words_of(found))};
}

}  // namespace

std::optional<drive::Finding> attitude_column_finding(const drive::Session& session, const MetricPoses& metric) {
  // Poses of a file have axes of their own; a tilt that nobody measured is right or wrong in no column.
  if (session.ins.empty() || assumed_tilt_sigma_rad(session) > 0.0) return std::nullopt;
  const Eigen::Matrix3d ins_from_level = drive::forward_left_up_from(session.ins_axes).linear().transpose();
  std::vector<motion::StampedPose> poses;
  poses.reserve(metric.size());
  for (motion::StampedPose pose : metric) {
    pose.pose.linear() = pose.pose.linear() * ins_from_level;
    poses.push_back(pose);
  }
  const unsigned by_slope = suspects(misfits_of_slope(travel_steps(poses))),
                 by_force = suspects(misfits_of_force(session, poses)),
                 by_turns = suspects(misfits_of_turns(turns_of_odometry(session, poses)));
  unsigned common = (1U << kMixups) - 1U;
  for (const unsigned found : {by_slope, by_force, by_turns})
    if (found != 0) common &= found;
  const bool any = (by_slope | by_force | by_turns) != 0;
  if (!any || common == 0) return std::nullopt;  // witnesses that contradict each other prove nothing
  return finding_of(common,
                    by_slope != 0   ? say::tilt_by_slope()
                    : by_force != 0 ? say::tilt_by_force()
                                    : say::tilt_by_turns(),
                    session.name);
}

std::optional<drive::Finding> attitude_column_finding(const std::vector<SharedTurn>& turns, const std::string& where) {
  const unsigned found = suspects(misfits_of_turns(turns));
  if (found == 0) return std::nullopt;
  return finding_of(found, say::tilt_by_turns(), where);
}

}  // namespace remount::conventions
