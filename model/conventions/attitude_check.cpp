#include "model/conventions/attitude_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "algorithms/calibration/observability.h"
#include "algorithms/core/symmetric_eigen.h"
#include "messages/checks.h"
#include "model/conventions/attitude_columns.h"
#include "model/conventions/inverted_poses.h"
#include "model/conventions/travel_steps.h"
#include "model/drive/attitude_convention.h"
#include "model/drive/session_frames.h"

namespace remount::conventions {
namespace {

constexpr const char* kAttitudeConvention = "attitude-convention";
constexpr const char* kAttitudeUnit = "attitude-unit";
constexpr const char* kPositionColumns = "position-columns";
constexpr double kFarBetter = 0.1;  ///< of what is left of the disagreement

/// How well the direction of travel, seen from the INS, keeps to one axis, forwards or backwards: 1 where it does, 0
/// where it spreads over a whole plane.
template <class Convention>
double agreement(const std::vector<TravelStep>& steps, Convention&& world_from_ins) {
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const TravelStep& step : steps) {
    const Eigen::Vector3d direction = world_from_ins(step.world_from_ins).transpose() * step.direction;
    scatter += direction * direction.transpose();
  }
  const double share = symmetric_eigen(scatter).eigenvalues()[2] / scatter.trace();
  return 2.0 * share - 1.0;
}

Eigen::Matrix3d inverse(const Eigen::Matrix3d& rotation) { return rotation.transpose(); }

/// North-east-down and forward-right-down taken for east-north-up and forward-left-up, or the other way round; also a
/// heading from north clockwise for a yaw from east counter-clockwise.
Eigen::Matrix3d other_way_up(const Eigen::Matrix3d& rotation) {
  const Eigen::Matrix3d ned_from_enu{{0, 1, 0}, {1, 0, 0}, {0, 0, -1}};
  return ned_from_enu * rotation * Eigen::Vector3d(1, -1, -1).asDiagonal();
}

/// A heading from north clockwise taken for a yaw from east counter-clockwise; pitch and roll are right.
Eigen::Matrix3d yaw_was_heading(const Eigen::Matrix3d& rotation) {
  const YawPitchRoll angles = yaw_pitch_roll_from_rotation(rotation);
  return rotation_from_yaw_pitch_roll({0.5 * kPi - angles.yaw_rad, angles.pitch_rad, angles.roll_rad});
}

/// The scalar part taken from the wrong end.
Eigen::Matrix3d scalar_was_last(const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond q(rotation);
  return Eigen::Quaterniond(q.z(), q.w(), q.x(), q.y()).toRotationMatrix();
}
Eigen::Matrix3d scalar_was_first(const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond q(rotation);
  return Eigen::Quaterniond(q.x(), q.y(), q.z(), q.w()).toRotationMatrix();
}

/// Of columns that were taken for each other the one that was taken for the yaw is small: pitch or roll.
drive::AttitudeAngles with_small_yaw(const Eigen::Matrix3d& rotation, drive::AttitudeConvention convention) {
  const drive::AttitudeAngles angles = drive::angles_from(Eigen::Quaterniond(rotation), convention);
  if (std::abs(wrap_angle_rad(angles.yaw_rad)) <= 0.5 * kPi) return angles;
  return {wrap_angle_rad(angles.yaw_rad + kPi), wrap_angle_rad(kPi - angles.pitch_rad),
          wrap_angle_rad(angles.roll_rad + kPi)};
}

template <drive::AttitudeConvention convention>
Eigen::Matrix3d yaw_was_pitch(const Eigen::Matrix3d& rotation) {
  const drive::AttitudeAngles taken = with_small_yaw(rotation, convention);
  return drive::enu_from_ins({taken.pitch_rad, taken.yaw_rad, taken.roll_rad}, convention).toRotationMatrix();
}
template <drive::AttitudeConvention convention>
Eigen::Matrix3d yaw_was_roll(const Eigen::Matrix3d& rotation) {
  const drive::AttitudeAngles taken = with_small_yaw(rotation, convention);
  return drive::enu_from_ins({taken.roll_rad, taken.pitch_rad, taken.yaw_rad}, convention).toRotationMatrix();
}

/// Radians that were taken for degrees: what is left is nearly the same attitude all the time.
template <drive::AttitudeConvention convention>
Eigen::Matrix3d degrees_were_radians(const Eigen::Matrix3d& rotation) {
  const drive::AttitudeAngles taken = drive::angles_from(Eigen::Quaterniond(rotation), convention);
  const auto grown = [](double angle_rad) { return radians_to_degrees(wrap_angle_rad(angle_rad)); };
  return drive::enu_from_ins({grown(taken.yaw_rad), grown(taken.pitch_rad), grown(taken.roll_rad)}, convention)
      .toRotationMatrix();
}

struct Alternative {
  Eigen::Matrix3d (*convention)(const Eigen::Matrix3d&);
  Message (*words)();
};
constexpr std::array<Alternative, 5> kAlternatives{{
    {other_way_up, say::attitude_as_other_way_up},
    {yaw_was_heading, say::attitude_as_heading},
    {inverse, say::attitude_as_inverse},
    {scalar_was_last, say::attitude_as_other_scalar},
    {scalar_was_first, say::attitude_as_other_scalar},
}};
/// Of angles in columns only; axes forward, left, up.
constexpr std::array<Alternative, 4> kColumnAlternatives{{
    {yaw_was_pitch<drive::AttitudeConvention::EnuYaw>, say::attitude_yaw_was_pitch},
    {yaw_was_pitch<drive::AttitudeConvention::Heading>, say::attitude_yaw_was_pitch},
    {yaw_was_roll<drive::AttitudeConvention::EnuYaw>, say::attitude_yaw_was_roll},
    {yaw_was_roll<drive::AttitudeConvention::Heading>, say::attitude_yaw_was_roll},
}};
constexpr std::array<Alternative, 2> kUnitAlternatives{{
    {degrees_were_radians<drive::AttitudeConvention::EnuYaw>, nullptr},
    {degrees_were_radians<drive::AttitudeConvention::Heading>, nullptr},
}};

/// What would make the heading follow the direction of travel.
struct Explanation {
  double follows = 0.0;
  const char* code = nullptr;
  Message words;
};

/// Poses of the INS with latitude and longitude exchanged; none where they cannot be.
std::vector<motion::StampedPose> poses_with_places_exchanged(const drive::Session& session) {
  drive::Session exchanged;
  for (const motion::InsSample& sample : session.ins) {
    if (std::abs(sample.longitude_rad) > 0.5 * kPi) return {};
    exchanged.ins.push_back(sample);
    std::swap(exchanged.ins.back().latitude_rad, exchanged.ins.back().longitude_rad);
  }
  return exchanged.ins.empty() ? std::vector<motion::StampedPose>{} : drive::metric_poses(exchanged);
}

/// On level ground several fit; tilts, and the shape of the path, tell them apart.
Explanation best_explanation(const drive::Session& session, const std::vector<TravelStep>& steps) {
  Explanation best;
  const auto offer = [&](double follows, const char* code, auto&& words) {
    if (follows > best.follows) best = {follows, code, words()};
  };
  for (const Alternative& one : kAlternatives)
    offer(agreement(steps, one.convention), kAttitudeConvention, [&] { return say::attitude_convention(one.words()); });
  if (session.ins.empty()) return best;
  const Eigen::Matrix3d axes_from_level = drive::forward_left_up_from(session.ins_axes).linear().transpose();
  const auto level = [&](auto* convention) {
    return [convention, axes_from_level](const Eigen::Matrix3d& rotation) -> Eigen::Matrix3d {
      return convention(rotation * axes_from_level);
    };
  };
  // Where the road is straight, no rotation at all follows it, too; so does what passes for yaw and hardly changes.
  const double unmoved =
      agreement(steps, [](const Eigen::Matrix3d&) { return Eigen::Matrix3d(Eigen::Matrix3d::Identity()); });
  const auto offer_moving = [&](const Alternative& one, const char* code, auto&& words) {
    const double follows = agreement(steps, level(one.convention));
    if (1.0 - follows < kFarBetter * (1.0 - unmoved)) offer(follows, code, words);
  };
  for (const Alternative& one : kColumnAlternatives)
    offer_moving(one, kAttitudeColumns, [&] { return say::attitude_columns(one.words()); });
  for (const Alternative& one : kUnitAlternatives) offer_moving(one, kAttitudeUnit, say::attitude_unit);
  const std::vector<TravelStep> exchanged = travel_steps(poses_with_places_exchanged(session));
  if (2 * exchanged.size() > steps.size())
    offer(agreement(exchanged, [](const Eigen::Matrix3d& same) { return same; }), kPositionColumns,
          say::position_columns);
  return best;
}

void judge_heading(const drive::Session& session, const std::vector<TravelStep>& steps,
                   std::vector<drive::Finding>& findings) {
  constexpr std::size_t kFewSteps = 10, kManySteps = 30;
  constexpr double kFollows = 0.95, kAgainst = 0.6, kAtRandom = 0.2;
  if (steps.size() < kFewSteps) return;
  const double declared = agreement(steps, [](const Eigen::Matrix3d& same) { return same; });
  if (declared > kFollows) return;
  const Explanation best = best_explanation(session, steps);
  // Side slip of a vehicle that turns on the spot is no better explained by any other attitude.
  if (best.follows > kFollows && (declared < kAgainst || 1.0 - best.follows < kFarBetter * (1.0 - declared)))
    findings.push_back({drive::Severity::Problem, best.code, session.name, best.words});
  else if (steps.size() >= kManySteps && declared < kAtRandom)
    findings.push_back(
        {drive::Severity::Warning, "heading-against-travel", session.name, say::heading_against_travel()});
}

/// The reader has compared the units of the angles with the direction of travel: that is the cause, then.
bool unit_is_to_blame(const drive::Session& session) {
  return std::any_of(session.findings.begin(), session.findings.end(),
                     [](const drive::Finding& finding) { return finding.code == "angle-unit"; });
}

}  // namespace

std::vector<drive::Finding> attitude_findings(const drive::Session& session) {
  return attitude_findings(session, MetricPoses(session));
}

std::vector<drive::Finding> attitude_findings(const drive::Session& session, const MetricPoses& poses) {
  constexpr double kDown = -0.5;
  std::vector<drive::Finding> findings;
  if (unit_is_to_blame(session)) return findings;
  if (std::vector<drive::Finding> inverted = inverted_pose_findings(session); !inverted.empty()) return inverted;
  judge_heading(session, travel_steps(poses), findings);
  double up = 0.0;
  for (const motion::StampedPose pose : poses) up += pose.pose.linear()(2, 2) / static_cast<double>(poses.size());
  if (!session.ins.empty() && up < kDown)
    findings.push_back({drive::Severity::Warning, "attitude-upside-down", session.name, say::attitude_upside_down()});
  // Where yaw is something else, slopes and forces prove nothing.
  if (findings.empty())
    if (std::optional<drive::Finding> finding = attitude_column_finding(session, poses))
      findings.push_back(std::move(*finding));
  return findings;
}

void blame_attitude(const std::vector<drive::Finding>& findings, calibration::CalibrationResult& result) {
  const auto found = [&](std::string_view code) {
    return std::any_of(findings.begin(), findings.end(),
                       [&](const drive::Finding& finding) { return finding.code == code; });
  };
  const bool convention = found(kAttitudeConvention);
  const bool columns = found(kAttitudeColumns) || found(kAttitudeUnit) || found(kPositionColumns);
  const bool inverted = found(kPosesInverted);
  if ((!convention && !columns && !inverted) || result.status == calibration::Status::Cancelled) return;
  if (calibration::is_solved(result.status)) {
    result.conclude(calibration::Status::Inconsistent, inverted     ? say::result_of_inverted_poses()
                                                       : convention ? say::result_of_convention()
                                                                    : say::result_of_columns());
    result.advice.clear();
  }
  calibration::claim_nothing(inverted ? say::poses_are_inverted() : say::ins_contradicts_itself(), result);
  result.advice.insert(result.advice.begin(), inverted     ? say::invert_poses_first()
                                              : convention ? say::correct_convention_first()
                                                           : say::correct_columns_first());
}

}  // namespace remount::conventions
