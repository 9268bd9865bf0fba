#include "model/attitude_check.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <string>

namespace remount {
namespace {

constexpr const char* kAttitudeConvention = "attitude-convention";

/// A stretch of travel in the world, and the attitude in its middle.
struct Step {
  Eigen::Vector3d direction;
  Eigen::Matrix3d world_from_ins;
};

/// Between the mean positions of successive half seconds: single samples are noisy.
std::vector<Step> steps_of(const MetricPoses& poses) {
  constexpr std::int64_t kBlock_ns = 500'000'000;
  constexpr double kSlowest_mps = 2.0, kFastest_mps = 100.0;
  struct Block {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    double count = 0.0, time_s = 0.0;
    std::size_t last = 0;
  };
  std::vector<Block> blocks;
  std::int64_t number = 0;
  std::int64_t begin_ns = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const StampedPose pose = poses[i];
    if (i == 0) begin_ns = pose.stamp_ns;
    const std::int64_t here = (pose.stamp_ns - begin_ns) / kBlock_ns;
    if (i == 0 || here != number) blocks.emplace_back();
    number = here;
    Block& block = blocks.back();
    block.position += pose.pose.translation();
    block.time_s += static_cast<double>(pose.stamp_ns - begin_ns) * 1e-9;
    block.count += 1.0;
    block.last = i;
  }
  std::vector<Step> steps;
  for (std::size_t k = 1; k < blocks.size(); ++k) {
    const Block &from = blocks[k - 1], &to = blocks[k];
    const Eigen::Vector3d step = to.position / to.count - from.position / from.count;
    const double speed_mps = step.norm() / (to.time_s / to.count - from.time_s / from.count);
    if (speed_mps > kSlowest_mps && speed_mps < kFastest_mps)
      steps.push_back({step.normalized(), poses[from.last].pose.linear()});
  }
  return steps;
}

/// How well the direction of travel, seen from the INS, keeps to one axis, forwards or backwards: 1 where it does, 0
/// where it spreads over a whole plane.
template <class Convention>
double agreement(const std::vector<Step>& steps, Convention&& world_from_ins) {
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Step& step : steps) {
    const Eigen::Vector3d direction = world_from_ins(step.world_from_ins).transpose() * step.direction;
    scatter += direction * direction.transpose();
  }
  const double share = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvalues()[2] / scatter.trace();
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

struct Alternative {
  Eigen::Matrix3d (*convention)(const Eigen::Matrix3d&);
  const char* words;
};
constexpr std::array<Alternative, 5> kAlternatives{{
    {other_way_up,
     "NED instead of ENU (or the other way round), or a heading from north instead of a yaw from east (this looks like "
     "a compass heading)"},
    {yaw_was_heading, "a heading from north instead of a yaw from east (this looks like a compass heading)"},
    {inverse, "the inverse rotation"},
    {scalar_was_last, "a quaternion whose scalar part stands at the other end"},
    {scalar_was_first, "a quaternion whose scalar part stands at the other end"},
}};

void judge_heading(const std::vector<Step>& steps, const std::string& where, std::vector<Finding>& findings) {
  constexpr std::size_t kFewSteps = 10, kManySteps = 30;
  constexpr double kFollows = 0.95, kAgainst = 0.6, kAtRandom = 0.2;
  if (steps.size() < kFewSteps) return;
  const double declared = agreement(steps, [](const Eigen::Matrix3d& same) { return same; });
  if (declared > kAgainst) return;
  // On level ground several fit; tilts tell them apart.
  const Alternative* best = nullptr;
  double highest = kFollows;
  for (const Alternative& one : kAlternatives) {
    const double follows = agreement(steps, one.convention);
    if (follows > highest) best = &one, highest = follows;
  }
  if (best != nullptr)
    findings.push_back(
        {Severity::Problem, kAttitudeConvention, where,
         std::string("The heading of the INS does not follow the direction of travel, but it would as ") + best->words +
             ": correct the convention of the attitude. No mounting can be right with this one."});
  else if (steps.size() >= kManySteps && declared < kAtRandom)
    findings.push_back({Severity::Warning, "heading-against-travel", where,
                        "The heading of the INS does not follow the direction of travel: check the convention of the "
                        "attitude, and whether what is taken for yaw is it. A vehicle that moves sideways at will may "
                        "look so too."});
}

}  // namespace

std::vector<Finding> attitude_findings(const Session& session) {
  return attitude_findings(session, MetricPoses(session));
}

std::vector<Finding> attitude_findings(const Session& session, const MetricPoses& poses) {
  constexpr double kDown = -0.5;
  std::vector<Finding> findings;
  judge_heading(steps_of(poses), session.name, findings);
  double up = 0.0;
  for (const StampedPose pose : poses) up += pose.pose.linear()(2, 2) / static_cast<double>(poses.size());
  if (!session.ins.empty() && up < kDown)
    findings.push_back({Severity::Warning, "attitude-upside-down", session.name,
                        "The z axis of the INS points down, where its axes are declared with z up: is it mounted so? "
                        "Otherwise check the convention of the attitude (ENU or NED, roll by 180 degrees)."});
  return findings;
}

void blame_attitude(const std::vector<Finding>& findings, CalibrationResult& result) {
  const bool found = std::any_of(findings.begin(), findings.end(),
                                 [](const Finding& finding) { return finding.code == kAttitudeConvention; });
  if (!found || result.status == Status::Cancelled) return;
  if (result.status == Status::Ok || result.status == Status::Degenerate) {
    result.status = Status::Inconsistent;
    result.message = "The INS contradicts itself: its heading follows its travel only under another convention.";
    result.advice.clear();
  }
  result.advice.insert(result.advice.begin(),
                       "Before anything else correct the convention of the INS attitude: its heading does not follow "
                       "the direction of travel, and would under another one (see the findings).");
}

}  // namespace remount
