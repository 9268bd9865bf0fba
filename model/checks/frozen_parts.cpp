// One half of the INS solution that stands still while the other tells that the vehicle does not.
#include <algorithm>
#include <cmath>
#include <optional>

#include "algorithms/core/median.h"
#include "algorithms/geometry/rotation.h"
#include "messages/checks.h"
#include "messages/places.h"
#include "model/checks/builtin.h"
#include "model/checks/check_times.h"

namespace remount::checks {
namespace {

constexpr double kShortest_s = 1.0;
constexpr double kTimesUsualHold = 5.0;       ///< position or attitude may be logged at a lower rate than the other
constexpr double kFrozenAttitude_rad = 1e-8;  ///< interpolating between two that are the same rounds
constexpr double kStretch_m = 5.0;    ///< over which the direction of travel is taken: noise of fixes is shorter
constexpr double kSlowest_mps = 1.0;  ///< what is slower may be noise about a place
constexpr double kTurn_rad = 15.0 * kPi / 180.0;
constexpr double kTurnAtTheEnd_rad = 45.0 * kPi / 180.0;
constexpr double kJump_m = 0.5;

/// Poses of one position, or of one attitude: from the first to the last.
struct Hold {
  std::size_t first = 0, last = 0;
};

template <class Same>
std::vector<Hold> holds_of(std::size_t count, Same&& same) {
  std::vector<Hold> holds;
  holds.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    if (!holds.empty() && same(holds.back().first, i))
      holds.back().last = i;
    else
      holds.push_back({i, i});
  return holds;
}

class FrozenParts {
 public:
  explicit FrozenParts(const CheckedSession& checked) : checked_(checked), poses_(checked.poses) {}

  double longest_attitude_s() const {
    return longest_s(
        holds_of(poses_.size(), [&](std::size_t a, std::size_t b) { return turned_rad(a, b) < kFrozenAttitude_rad; }),
        [&](const Hold& hold) { return path_turns(hold); });
  }
  double longest_position_s() const {
    return longest_s(holds_of(poses_.size(), [&](std::size_t a, std::size_t b) { return place(a) == place(b); }),
                     [&](const Hold& hold) { return vehicle_went_on(hold); });
  }

 private:
  Eigen::Vector3d place(std::size_t i) const { return poses_[i].pose.translation(); }
  double turned_rad(std::size_t a, std::size_t b) const {
    return checked_.logged_attitude(a).angularDistance(checked_.logged_attitude(b));
  }
  double duration_s(const Hold& hold) const {
    return seconds_between(poses_[hold.first].stamp_ns, poses_[hold.last].stamp_ns);
  }

  /// Of the holds that are far longer than usual, and that `contradicted` confirms.
  template <class Contradicted>
  double longest_s(const std::vector<Hold>& holds, Contradicted&& contradicted) const {
    if (holds.empty()) return 0.0;
    std::vector<double> usual_s;
    usual_s.reserve(holds.size());
    for (std::size_t i = 1; i < holds.size(); ++i)
      usual_s.push_back(seconds_between(poses_[holds[i - 1].first].stamp_ns, poses_[holds[i].first].stamp_ns));
    const bool tells = usual_s.size() >= 10;  // otherwise all of the drive may be frozen
    const double limit_s = std::max(kShortest_s, tells ? kTimesUsualHold * median_of(std::move(usual_s)) : 0.0);
    double longest = 0.0;
    for (const Hold& hold : holds)
      if (const double hold_s = duration_s(hold); hold_s > std::max(limit_s, longest) && contradicted(hold))
        longest = hold_s;
    return longest;
  }

  /// A straight road keeps the attitude of a log that rounds it; driving backwards turns the direction by half a turn.
  bool path_turns(const Hold& hold) const {
    std::optional<Eigen::Vector3d> before;
    for (std::size_t from = hold.first, i = hold.first; i <= hold.last; ++i) {
      const Eigen::Vector3d way = place(i) - place(from);
      const double way_s = seconds_between(poses_[from].stamp_ns, poses_[i].stamp_ns);
      if (way.norm() < kStretch_m) continue;
      const bool driven = way.norm() > kSlowest_mps * way_s;
      if (driven && before && before->cross(way.normalized()).norm() > std::sin(kTurn_rad)) return true;
      if (driven && !before) before = way.normalized();
      from = i;
    }
    return false;
  }

  /// A standing vehicle keeps its place, and its attitude trembles. One that drove on is elsewhere at the next
  /// position.
  bool vehicle_went_on(const Hold& hold) const {
    double most_rad = 0.0;
    for (std::size_t i = hold.first; i <= hold.last; ++i) most_rad = std::max(most_rad, turned_rad(hold.first, i));
    if (hold.last + 1 == poses_.size()) return most_rad > kTurnAtTheEnd_rad;
    const double hold_s = duration_s(hold),
                 step_s = seconds_between(poses_[hold.last].stamp_ns, poses_[hold.last + 1].stamp_ns);
    const double jump_m = (place(hold.last + 1) - place(hold.last)).norm();
    const bool gap = step_s > 0.5 * hold_s;  // it drove on then
    return most_rad > kFrozenAttitude_rad && !gap && jump_m > std::max(kJump_m, 0.5 * kSlowest_mps * hold_s);
  }

  const CheckedSession& checked_;
  const conventions::MetricPoses& poses_;
};

void look_for_frozen_parts(const CheckedSession& checked, std::vector<drive::Finding>& findings, const Progress&) {
  const FrozenParts frozen(checked);
  if (const double frozen_s = frozen.longest_attitude_s(); frozen_s > 0.0)
    findings.push_back({drive::Severity::Warning, "ins-attitude-frozen", say::place_ins(),
                        say::ins_attitude_frozen(Duration{frozen_s})});
  if (const double frozen_s = frozen.longest_position_s(); frozen_s > 0.0)
    findings.push_back({drive::Severity::Warning, "ins-position-frozen", say::place_ins(),
                        say::ins_position_frozen(Duration{frozen_s})});
}

}  // namespace

DataCheck frozen_part_check() {
  return {.kinds = {{"ins-attitude-frozen", say::ins_attitude_frozen_meaning, say::ins_attitude_frozen_remedy},
                    {"ins-position-frozen", say::ins_position_frozen_meaning, say::ins_position_frozen_remedy}},
          .look = look_for_frozen_parts};
}

}  // namespace remount::checks
