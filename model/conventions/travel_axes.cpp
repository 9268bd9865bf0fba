#include "model/conventions/travel_axes.h"

#include <cmath>

#include "messages/checks.h"
#include "model/conventions/travel_direction.h"
#include "model/drive/bad_items.h"

namespace remount::conventions {

using drive::InsAxes;

namespace {

/// By quarter turns from x to the direction of travel, counter-clockwise.
constexpr InsAxes kByQuarters[drive::kInsAxesCount] = {InsAxes::ForwardLeftUp, InsAxes::RightForwardUp,
                                                       InsAxes::BackwardRightUp, InsAxes::LeftBackwardUp};

std::optional<InsAxes> axes_by_travel(const TravelDirection& travel) {
  constexpr double kNear_rad = 20.0 * kPi / 180.0;
  const double quarters = std::round(travel.yaw_rad / (0.5 * kPi));
  if (std::abs(travel.yaw_rad - quarters * 0.5 * kPi) > kNear_rad) return std::nullopt;
  const InsAxes axes = kByQuarters[static_cast<std::size_t>(static_cast<int>(quarters) + 4) % drive::kInsAxesCount];
  const bool usual = axes == InsAxes::ForwardLeftUp || axes == InsAxes::RightForwardUp;
  return usual || travel.forwards ? std::optional(axes) : std::nullopt;
}

/// A vehicle that may be in reverse does not contradict its axes.
bool may_be_reverse(const TravelDirection& travel, const std::optional<InsAxes>& declared, InsAxes told) {
  return !travel.forwards && ((declared == InsAxes::BackwardRightUp && told == InsAxes::ForwardLeftUp) ||
                              (declared == InsAxes::LeftBackwardUp && told == InsAxes::RightForwardUp));
}

/// Forward, right, down in a world whose z points up, say.
bool z_points_down(const MetricPoses& world_from_ins) {
  constexpr double kDown = -0.5;
  double up = 0.0;
  for (const motion::StampedPose pose : world_from_ins)
    up += pose.pose.linear()(2, 2) / static_cast<double>(world_from_ins.size());
  return up < kDown;
}

void leave_axes_open(drive::Session& session) {
  session.ins_axes.reset();
  session.findings.push_back(
      drive::make_finding(drive::Severity::Note, "ins-axes-down", drive::path_or_name(session), say::ins_axes_down()));
}

}  // namespace

void settle_axes(drive::Session& session) {
  if (session.ins.empty() && session.world_from_ins.empty()) return;
  const MetricPoses poses(session);
  const std::optional<TravelDirection> travel = travel_direction(poses);
  if ((travel || session.ins_axes) && z_points_down(poses)) return leave_axes_open(session);
  const std::optional<InsAxes> told = travel ? axes_by_travel(*travel) : std::nullopt;
  if (!told || session.ins_axes == told || may_be_reverse(*travel, session.ins_axes, *told)) return;
  const std::string axes(to_string(*told));
  session.findings.push_back(
      session.ins_axes
          ? drive::make_finding(drive::Severity::Warning, "ins-axes-by-travel", drive::path_or_name(session),
                                say::ins_axes_against_travel(axes, std::string(to_string(*session.ins_axes))))
          : drive::make_finding(drive::Severity::Note, "ins-axes-by-travel", drive::path_or_name(session),
                                say::ins_axes_by_travel(axes)));
  session.ins_axes = told;
  session.ins_axes_by_travel = true;
}

}  // namespace remount::conventions
