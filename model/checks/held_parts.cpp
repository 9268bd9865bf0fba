// Attitudes or positions, or one number of them, that are logged more often than they are computed: each value is
// repeated for a while, then jumps to the next.
#include <algorithm>
#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "model/checks/builtin.h"
#include "model/checks/check_text.h"
#include "model/held_positions.h"
#include "model/held_values.h"

namespace remount {
namespace {

void add(std::vector<Finding>& findings, const char* code, std::string explanation) {
  findings.push_back({Severity::Warning, code, "INS", std::move(explanation)});
}

double heading_rad(const Eigen::Quaterniond& q) {
  return std::atan2(2.0 * (q.w() * q.z() + q.x() * q.y()), 1.0 - 2.0 * (q.y() * q.y() + q.z() * q.z()));
}

void look_at_attitude(const CheckedSession& checked, std::vector<Finding>& findings) {
  const auto steps = [&](auto&& turned_rad) {
    return held_steps(checked.poses, kSameAttitude_rad, kTurning_rad, kLeastTurn_rad, turned_rad);
  };
  if (const auto all = steps([&](std::size_t a, std::size_t b) {
        return checked.logged_attitude(a).angularDistance(checked.logged_attitude(b));
      })) {
    add(findings, "ins-attitude-held",
        check_text("The attitude stands still for %.3f s at a time (%.0f samples) and then jumps, by %.2f degrees "
                   "where the vehicle turns: it is logged more often than it is computed.",
                   all->hold_s, all->samples, radians_to_degrees(all->jump)));
    return;
  }
  // Headings may come from another receiver, of two antennas, than pitch and roll.
  if (const auto heading = steps([&](std::size_t a, std::size_t b) {
        return std::abs(
            wrap_angle_rad(heading_rad(checked.logged_attitude(a)) - heading_rad(checked.logged_attitude(b))));
      });
      heading && !heading->rounded)
    add(findings, "ins-attitude-held",
        check_text("The heading alone stands still for %.3f s at a time (%.0f samples) and then jumps, by %.2f degrees "
                   "where the vehicle turns: it is logged more often than it is computed.",
                   heading->hold_s, heading->samples, radians_to_degrees(heading->jump)));
}

void look_at_position(const CheckedSession& checked, std::vector<Finding>& findings) {
  const MetricPoses& poses = checked.poses;
  const std::vector<InsSample>& ins = checked.session.ins;
  const bool geodetic = ins.size() == poses.size();
  const auto step = [&](std::size_t a, std::size_t b) -> Eigen::Vector3d {
    return poses[a].pose.translation() - poses[b].pose.translation();
  };
  if (const auto all = held_positions(checked.session, poses)) {
    add(findings, "ins-position-held",
        check_text("The position stands still for %.3f s at a time (%.0f samples) and then jumps, by %.2f m where the "
                   "vehicle drives: it is logged more often than it is computed.",
                   all->hold_s, all->samples, all->jump));
    return;
  }
  const auto look_at_number = [&](int axis, const char* name, double InsSample::*angle_rad) {
    const auto along = [&](std::size_t a, std::size_t b) {
      return geodetic && ins[a].*angle_rad == ins[b].*angle_rad ? 0.0 : std::abs(step(a, b)[axis]);
    };
    if (const auto one = held_steps(poses, 0.0, kDriving_m, kLeastStep_m, along); one && !one->rounded)
      add(findings, "ins-position-held",
          check_text("One number of the position, %s, stands still for %.3f s at a time (%.0f samples) and then jumps, "
                     "by %.2f m where the vehicle drives: it is logged more often than it is computed.",
                     name, one->hold_s, one->samples, one->jump));
  };
  look_at_number(1, geodetic ? "latitude" : "y", &InsSample::latitude_rad);
  look_at_number(0, geodetic ? "longitude" : "x", &InsSample::longitude_rad);
}

void look_for_held_parts(const CheckedSession& checked, std::vector<Finding>& findings, const Progress&) {
  look_at_attitude(checked, findings);
  look_at_position(checked, findings);
}

}  // namespace

DataCheck held_part_check() {
  return {.kinds =
              {{"ins-attitude-held",
                "Attitudes are late by half such a step on average, and jump: X is off by as much where the vehicle "
                "turns, and no sigma says so.",
                "Log the attitude as it is computed, with all digits; or keep only the first sample of each that "
                "repeats: between those the motion is interpolated."},
               {"ins-position-held",
                "Positions are late by half such a step on average, and jump: X is off by the way that is driven "
                "meanwhile, and no sigma says so.",
                "Log the position as it is computed, with all digits; or keep only the first sample of each that "
                "repeats: between those the motion is interpolated."},
               {kPositionsInterpolated,
                "Repeats of a position are no measurements. Between those that were measured the way is interpolated, "
                "which is right where each is logged as soon as it is computed.",
                "Log the position as it is computed, with all digits. Where each comes later than its stamp says, take "
                "the delay out of the stamps."}},
          .look = look_for_held_parts};
}

}  // namespace remount
