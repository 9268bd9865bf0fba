// Attitudes or positions, or one number of them, that are logged more often than they are computed: each value is
// repeated for a while, then jumps to the next.
#include <algorithm>
#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "messages/checks.h"
#include "messages/places.h"
#include "model/checks/builtin.h"
#include "model/conventions/held_positions.h"
#include "model/conventions/held_values.h"

namespace remount::checks {
namespace {

void add(std::vector<drive::Finding>& findings, const char* code, Message explanation) {
  findings.push_back({drive::Severity::Warning, code, say::place_ins(), std::move(explanation)});
}

double heading_rad(const Eigen::Quaterniond& q) {
  return std::atan2(2.0 * (q.w() * q.z() + q.x() * q.y()), 1.0 - 2.0 * (q.y() * q.y() + q.z() * q.z()));
}

void look_at_attitude(const CheckedSession& checked, std::vector<drive::Finding>& findings) {
  const auto steps = [&](auto&& turned_rad) {
    return conventions::held_steps(checked.poses, conventions::kSameAttitude_rad, conventions::kTurning_rad,
                                   conventions::kLeastTurn_rad, turned_rad);
  };
  if (const auto all = steps([&](std::size_t a, std::size_t b) {
        return checked.logged_attitude(a).angularDistance(checked.logged_attitude(b));
      })) {
    add(findings, "ins-attitude-held", say::ins_attitude_held(Duration{all->hold_s}, all->samples, Angle{all->jump}));
    return;
  }
  // Headings may come from another receiver, of two antennas, than pitch and roll.
  if (const auto heading = steps([&](std::size_t a, std::size_t b) {
        return std::abs(
            wrap_angle_rad(heading_rad(checked.logged_attitude(a)) - heading_rad(checked.logged_attitude(b))));
      });
      heading && !heading->rounded)
    add(findings, "ins-attitude-held",
        say::ins_heading_held(Duration{heading->hold_s}, heading->samples, Angle{heading->jump}));
}

void look_at_position(const CheckedSession& checked, std::vector<drive::Finding>& findings) {
  const conventions::MetricPoses& poses = checked.poses;
  const std::vector<motion::InsSample>& ins = checked.session.ins;
  const bool geodetic = ins.size() == poses.size();
  const auto step = [&](std::size_t a, std::size_t b) -> Eigen::Vector3d {
    return poses[a].pose.translation() - poses[b].pose.translation();
  };
  if (const auto all = conventions::held_positions(checked.session, poses)) {
    add(findings, "ins-position-held", say::ins_position_held(Duration{all->hold_s}, all->samples, Length{all->jump}));
    return;
  }
  const auto look_at_number = [&](int axis, const Message& name, double motion::InsSample::*angle_rad) {
    const auto along = [&](std::size_t a, std::size_t b) {
      return geodetic && ins[a].*angle_rad == ins[b].*angle_rad ? 0.0 : std::abs(step(a, b)[axis]);
    };
    if (const auto one = conventions::held_steps(poses, 0.0, conventions::kDriving_m, conventions::kLeastStep_m, along);
        one && !one->rounded)
      add(findings, "ins-position-held",
          say::ins_number_held(name, Duration{one->hold_s}, one->samples, Length{one->jump}));
  };
  look_at_number(1, geodetic ? say::check_latitude() : Message::verbatim("y"), &motion::InsSample::latitude_rad);
  look_at_number(0, geodetic ? say::check_longitude() : Message::verbatim("x"), &motion::InsSample::longitude_rad);
}

void look_for_held_parts(const CheckedSession& checked, std::vector<drive::Finding>& findings, const Progress&) {
  look_at_attitude(checked, findings);
  look_at_position(checked, findings);
}

}  // namespace

DataCheck held_part_check() {
  return {.kinds = {{"ins-attitude-held", say::ins_attitude_held_meaning, say::ins_attitude_held_remedy},
                    {"ins-position-held", say::ins_position_held_meaning, say::ins_position_held_remedy},
                    {conventions::kPositionsInterpolated, say::ins_positions_interpolated_meaning,
                     say::ins_positions_interpolated_remedy}},
          .look = look_for_held_parts};
}

}  // namespace remount::checks
