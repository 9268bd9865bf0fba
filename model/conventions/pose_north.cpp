#include "model/conventions/pose_north.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "algorithms/geodesy/geodesy.h"
#include "messages/checks.h"
#include "model/conventions/north_hypotheses.h"
#include "model/drive/bad_items.h"
#include "model/formats/files/input_file.h"

namespace remount::conventions {
namespace {

/// UTM's false easting keeps eastings from 100 to 900 km, and its northings count from the equator. National grids have
/// such numbers, too, or smaller, larger and negative ones: no world of its own begins ten kilometres away.
bool has_numbers_of_a_grid(const std::vector<motion::StampedPose>& poses) {
  return std::all_of(poses.begin(), poses.end(), [](const motion::StampedPose& pose) {
    const Eigen::Vector3d at = pose.pose.translation();
    return std::abs(at.x()) > 1e4 && std::abs(at.x()) < 5e7 && std::abs(at.y()) > 1e4 && std::abs(at.y()) < 1e7 &&
           std::abs(at.z()) < 1e4;
  });
}

geodesy::GridFix utm_at(double latitude_rad, double longitude_rad) {
  return geodesy::UtmGrid(latitude_rad, longitude_rad).project(latitude_rad, longitude_rad);
}

double apart_m(const Eigen::Vector3d& position_m, const geodesy::GridFix& fix) {
  return (position_m.head<2>() - Eigen::Vector2d(fix.easting_m, fix.northing_m)).norm();
}

/// Whether the drive lies on the grid where its fixes are: with its origin, not only its axes.
bool lies_on_grid(const TurnedByFixes& turned, const geodesy::GridFix& fix) {
  constexpr double kSame_m = 1000.0;
  return apart_m(turned.middle_in_world, fix) < kSame_m;
}

/// By any fix, which may be of another moment; nothing where there is none.
std::optional<bool> lies_on_utm(const drive::Session& session) {
  constexpr double kSameRegion_m = 20e3;
  if (session.gnss.empty()) return std::nullopt;
  const motion::GnssFix& fix = session.gnss[session.gnss.size() / 2];
  const geodesy::GridFix there = utm_at(fix.latitude_rad, fix.longitude_rad);
  return std::any_of(
      session.world_from_ins.begin(), session.world_from_ins.end(),
      [&](const motion::StampedPose& pose) { return apart_m(pose.pose.translation(), there) < kSameRegion_m; });
}

/// Of another grid: its scale is not known, and its convergence is what the fixes say.
void turn_attitudes(double by_rad, drive::Session& session) {
  for (motion::StampedPose& pose : session.world_from_ins)
    pose.pose.linear() = rotation_from_yaw_pitch_roll({by_rad, 0.0, 0.0}) * pose.pose.linear();
}

/// Of UTM. @param place where numbers do not say it
void correct(const NorthHypothesis& taken, const std::optional<geodesy::GridFix>& place, drive::Session& session) {
  Eigen::Vector3d at_m = Eigen::Vector3d::Zero(), before_m = at_m;
  geodesy::GridFix here = place.value_or(geodesy::GridFix{});
  bool first = true;
  for (motion::StampedPose& pose : session.world_from_ins) {
    const Eigen::Vector3d logged_m = pose.pose.translation();
    if (!place) here = geodesy::grid_fix_at(logged_m.x(), logged_m.y(), taken.northern).value_or(here);
    if (first) at_m = before_m = logged_m;
    first = false;
    const double metres = geodesy::metres_per_grid_metre(here.point_scale, place ? 0.0 : logged_m.z());
    const Eigen::Vector3d step_m = logged_m - before_m;
    at_m += Eigen::Vector3d(metres * step_m.x(), metres * step_m.y(), step_m.z());
    before_m = logged_m;
    pose.pose.translation() = at_m;
    if (taken.correction_rad != 0.0)
      pose.pose.linear() = rotation_from_yaw_pitch_roll({here.convergence_rad, 0.0, 0.0}) * pose.pose.linear();
  }
}

void report_taken(const NorthHypothesis& taken, drive::Session& session) {
  const std::string where = drive::path_or_name(session);
  const Angle convergence{taken.correction_rad};
  if (taken.world == PoseWorld::Utm && taken.correction_rad != 0.0) {
    session.findings.push_back(
        drive::make_finding(drive::Severity::Warning, "utm-true-north", where, say::utm_true_north(convergence)));
  } else if (taken.world == PoseWorld::Utm) {
    session.findings.push_back(
        drive::make_finding(drive::Severity::Note, "utm-grid-north", where, say::utm_grid_north()));
  } else if (taken.correction_rad != 0.0) {
    session.findings.push_back(
        drive::make_finding(drive::Severity::Warning, "utm-true-north", where, say::grid_true_north(convergence)));
  }
}

void report_doubt(const NorthHypothesis& taken, bool by_travel, bool by_numbers, double doubt_rad,
                  drive::Session& session) {
  constexpr double kNoDoubt_rad = 0.02 * kPi / 180.0;
  if (doubt_rad < kNoDoubt_rad) return;
  session.ins_north_sigma_rad = doubt_rad;
  const Angle doubt{doubt_rad};
  session.findings.push_back(
      drive::make_finding(drive::Severity::Warning, "north-unknown", drive::path_or_name(session),
                          by_numbers && taken.world == PoseWorld::OtherGrid ? say::north_unknown_on_grid(doubt)
                          : by_travel                                       ? say::north_by_travel(doubt)
                                                                            : say::north_unknown(doubt)));
}

/// Neither numbers nor fixes say where the drive is: a constant angle between heading and travel may be a convergence.
void settle_without_place(const std::optional<HeadingApart>& heading, drive::Session& session) {
  constexpr double kLeast_rad = 0.5 * kPi / 180.0, kMost_rad = 3.5 * kPi / 180.0, kSure = 3.0;
  constexpr double kConvergences = 0.19 * 180.0 / kPi;  // density of those of zones, per radian
  if (!heading) return;
  const double apart_rad = std::abs(heading->apart_rad);
  if (apart_rad < std::max(kLeast_rad, kSure * heading->sigma_rad) || apart_rad > kMost_rad) return;
  const bool named =
      formats::lower_case(session.world_frame).find("utm") != std::string::npos || session.attitudes_to_true_north;
  const double share = named ? 0.5 : 0.2;
  const double grid = share * kConvergences, own = (1.0 - share) * setup_density(apart_rad, heading->sigma_rad);
  session.ins_north_sigma_rad = apart_rad * std::sqrt(grid / (grid + own));
  session.findings.push_back(
      drive::make_finding(drive::Severity::Warning, "north-unknown", drive::path_or_name(session),
                          say::north_or_mounting(Angle{heading->apart_rad}, Angle{session.ins_north_sigma_rad})));
}

}  // namespace

void settle_north(drive::Session& session) {
  if (session.world_from_ins.empty() || !session.ins.empty()) return;
  const std::optional<HeadingApart> heading = heading_apart(session);
  const std::optional<TurnedByFixes> turned = turned_by_fixes(session);
  const std::optional<bool> northern =
      session.gnss.empty() ? std::nullopt : std::optional(session.gnss.front().latitude_rad >= 0.0);
  const std::optional<geodesy::GridFix> here =
      turned ? std::optional(utm_at(turned->latitude_rad, turned->longitude_rad)) : std::nullopt;
  const bool of_a_grid = has_numbers_of_a_grid(session.world_from_ins);
  const bool numbers = of_a_grid && (!turned || lies_on_grid(*turned, *here));
  if (!numbers && !turned) return settle_without_place(heading, session);
  const std::optional<bool> on_utm = lies_on_utm(session);
  std::vector<NorthHypothesis> norths =
      numbers ? norths_by_numbers(session, on_utm, northern) : norths_by_fixes(session, *turned, *here, of_a_grid);
  weigh_norths(numbers ? std::nullopt : turned, heading, norths);
  NorthHypothesis taken = likeliest_north(norths);
  // What the drive does not speak for is left as it is, and nothing is turned by a guess.
  const bool supported = on_utm.value_or(false) || !heading || fits_travel(taken, *heading);
  if (numbers && (taken.world == PoseWorld::OtherGrid || !supported)) taken = {.world = PoseWorld::OtherGrid};
  const double doubt_rad = north_doubt_rad(norths, taken);
  if (taken.world == PoseWorld::Utm)
    correct(taken, numbers ? std::nullopt : here, session);
  else if (taken.correction_rad != 0.0)
    turn_attitudes(taken.correction_rad, session);
  report_taken(taken, session);
  report_doubt(taken, heading.has_value(), numbers, doubt_rad, session);
}

}  // namespace remount::conventions
