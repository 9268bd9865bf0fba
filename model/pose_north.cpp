#include "model/pose_north.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <numeric>
#include <optional>
#include <vector>

#include "algorithms/geometry/geodesy.h"
#include "algorithms/geometry/local_level.h"
#include "algorithms/trajectory/motion_track.h"
#include "model/io/input_file.h"
#include "model/io/stream_tools.h"
#include "model/travel_direction.h"

namespace remount {
namespace {

/// Every way in which positions and attitudes may belong together, and how likely it is before the drive is looked at.
struct North {
  double correction_rad = 0.0;                      ///< that brings attitudes to the axes of the positions
  std::optional<double> turned_rad = std::nullopt;  ///< positions against east and north; nothing: by any angle
  bool grid = false;
  bool northern = true;
  double weight = 0.0;
};

/// How positions are turned against east and north, by fixes of the same drive.
struct Turned {
  double angle_rad = 0.0, sigma_rad = 0.0;
  Eigen::Vector3d middle_in_world = Eigen::Vector3d::Zero();
  double latitude_rad = 0.0, longitude_rad = 0.0;  ///< of the fixes, in the mean
};

double normal_density(double x, double sigma) {
  return std::exp(-0.5 * x * x / (sigma * sigma)) / (sigma * std::sqrt(2.0 * kPi));
}

/// Of the angle between the heading of an INS and the direction of travel, per radian: most are set up in line with
/// their vehicle to some tenths of a degree; one in ten is turned by a degree or some.
double setup_density(double angle_rad, double sigma_rad) {
  constexpr double kInLine_rad = 0.4 * kPi / 180.0, kTurned_rad = 1.5 * kPi / 180.0, kTurnedShare = 0.1;
  const double in_line = normal_density(angle_rad, std::hypot(kInLine_rad, sigma_rad));
  const double turned = normal_density(angle_rad, kTurned_rad);
  return (1.0 - kTurnedShare) * in_line + kTurnedShare * turned + 1e-6;
}

/// What is left of the direction of travel when the nearest axis of the INS is taken for forward.
struct Heading {
  double apart_rad = 0.0, sigma_rad = 0.0;
};
std::optional<Heading> heading_apart(const Session& session) {
  const std::optional<TravelDirection> travel = travel_direction(MetricPoses(session));
  if (!travel) return std::nullopt;
  return Heading{travel->yaw_rad - 0.5 * kPi * std::round(travel->yaw_rad / (0.5 * kPi)), travel->sigma_rad};
}

/// UTM's false easting keeps eastings from 100 to 900 km, and its northings count from the equator.
bool has_numbers_of_utm(const std::vector<StampedPose>& poses) {
  return std::all_of(poses.begin(), poses.end(), [](const StampedPose& pose) {
    const Eigen::Vector3d at = pose.pose.translation();
    return at.x() > 1e5 && at.x() < 9e5 && at.y() > 1e4 && at.y() < 1e7 && std::abs(at.z()) < 1e4;
  });
}

using Complex = std::complex<double>;  // a place or a direction on the plane, east or x real

/// Fixes beside poses of the same time.
struct Places {
  std::vector<Complex> in_enu, in_world, headings;
  Eigen::Vector3d middle_in_world = Eigen::Vector3d::Zero();
  double latitude_rad = 0.0, longitude_rad = 0.0;  ///< in the mean
};

Places places_of(const Session& session) {
  constexpr std::size_t kMost = 2000;
  Places places;
  const GnssFix& first = session.gnss.front();
  const LocalLevel level(first.latitude_rad, first.longitude_rad, first.height_m);
  const MotionTrack track(session.world_from_ins);
  const std::size_t step = std::max<std::size_t>(1, session.gnss.size() / kMost);
  for (std::size_t i = 0; i < session.gnss.size(); i += step) {
    const GnssFix& fix = session.gnss[i];
    const auto pose = track.at(fix.stamp_ns);
    if (!pose) continue;
    const Eigen::Vector3d enu = level.position_enu_m(fix);
    places.in_enu.emplace_back(enu.x(), enu.y());
    places.in_world.emplace_back(pose->translation().x(), pose->translation().y());
    places.headings.emplace_back(pose->linear()(0, 0), pose->linear()(1, 0));
    places.middle_in_world += pose->translation();
    places.latitude_rad += fix.latitude_rad;
    places.longitude_rad += wrap_angle_rad(fix.longitude_rad - first.longitude_rad);
  }
  const double count = std::max(1.0, static_cast<double>(places.in_enu.size()));
  places.middle_in_world /= count;
  places.latitude_rad /= count;
  places.longitude_rad = first.longitude_rad + places.longitude_rad / count;
  return places;
}

/// world = turn * enu + shift - heading * arm of the antenna, by least squares; residuals beside. The arm is some
/// metres at most, which matters where a drive is one bend and the arm cannot be told from a turn.
struct PlaneFitted {
  Complex turn;
  double sigma = 0.0;  ///< of turn, if all fixes together were as good as one
  double left_m = 0.0, spread_m = 0.0;
};
PlaneFitted fit_on_plane(const Places& places) {
  constexpr double kArm = 1e-3;
  const auto count = static_cast<double>(places.in_enu.size());
  const auto mean = [count](const std::vector<Complex>& values) {
    return std::accumulate(values.begin(), values.end(), Complex()) / count;
  };
  const Complex enu = mean(places.in_enu), world = mean(places.in_world);
  Eigen::Matrix3cd normal = Eigen::Matrix3cd::Zero();
  Eigen::Vector3cd side = Eigen::Vector3cd::Zero();
  PlaneFitted out;
  const auto row_of = [&](std::size_t i) { return Eigen::Vector3cd(places.in_enu[i] - enu, 1.0, -places.headings[i]); };
  for (std::size_t i = 0; i < places.in_enu.size(); ++i) {
    normal += row_of(i).conjugate() * row_of(i).transpose();
    side += row_of(i).conjugate() * (places.in_world[i] - world);
    out.spread_m += std::norm(places.in_enu[i] - enu) / count;
  }
  normal(2, 2) += kArm * count;
  const Eigen::Matrix3cd inverse = normal.inverse();
  const Eigen::Vector3cd solution = inverse * side;
  for (std::size_t i = 0; i < places.in_enu.size(); ++i)
    out.left_m += std::norm(places.in_world[i] - world - row_of(i).cwiseProduct(solution).sum()) / count;
  out.left_m = std::sqrt(out.left_m);
  out.spread_m = std::sqrt(out.spread_m);
  out.turn = solution[0];
  out.sigma = std::sqrt(std::max(0.0, count * inverse(0, 0).real()));
  return out;
}

/// Nothing where there are no fixes, where they do not follow the poses, or where the vehicle hardly goes anywhere.
std::optional<Turned> turned_by_fixes(const Session& session) {
  constexpr std::size_t kFewest = 8;
  constexpr double kShortest_m = 10.0, kFollows = 0.2, kLeast_m = 0.01, kSameLength = 0.05;
  if (session.gnss.empty()) return std::nullopt;
  const Places places = places_of(session);
  if (places.in_enu.size() < kFewest) return std::nullopt;
  const PlaneFitted fit = fit_on_plane(places);
  if (!(fit.spread_m > kShortest_m && fit.left_m < kFollows * fit.spread_m &&
        std::abs(std::abs(fit.turn) - 1.0) < kSameLength))
    return std::nullopt;
  // An error that stays the same turns nothing; of those that wander, what turns is about as large as what is left.
  return Turned{std::arg(fit.turn), std::max(fit.left_m, kLeast_m) * fit.sigma, places.middle_in_world,
                places.latitude_rad, places.longitude_rad};
}

/// Whether the drive lies on the grid where its fixes are: with its origin, not only its axes.
bool lies_on_grid(const Turned& turned, const GridFix& fix) {
  constexpr double kSame_m = 1000.0;
  return (turned.middle_in_world.head<2>() - Eigen::Vector2d(fix.easting_m, fix.northing_m)).norm() < kSame_m;
}

/// The numbers are UTM's.
std::vector<North> norths_on_grid(const Session& session, std::optional<bool> northern) {
  constexpr double kNorthern = 0.8;
  const double to_true_north = session.attitudes_to_true_north ? 0.98 : 0.5;
  const Eigen::Vector3d at = session.world_from_ins[session.world_from_ins.size() / 2].pose.translation();
  std::vector<North> norths{{.grid = true, .northern = northern.value_or(true), .weight = 1.0 - to_true_north}};
  for (const bool half : {true, false}) {
    if (northern && *northern != half) continue;
    const std::optional<GridFix> here = grid_fix_at(at.x(), at.y(), half);
    if (!here) continue;
    const double share = northern ? 1.0 : half ? kNorthern : 1.0 - kNorthern;
    norths.push_back(
        {.correction_rad = here->convergence_rad, .grid = true, .northern = half, .weight = to_true_north * share});
  }
  return norths;
}

/// Fixes tell where the drive is, and its numbers are not those of UTM there.
std::vector<North> norths_by_fixes(const Session& session, const GridFix& here, bool northern) {
  const double to_true_north = session.attitudes_to_true_north ? 0.98 : 0.6;
  const double convergence_rad = here.convergence_rad;
  return {{.correction_rad = convergence_rad,
           .turned_rad = convergence_rad,
           .grid = true,
           .northern = northern,
           .weight = 0.5 * to_true_north},
          {.turned_rad = convergence_rad, .grid = true, .northern = northern, .weight = 0.5 * (1.0 - to_true_north)},
          {.turned_rad = 0.0, .weight = 0.3},
          {.weight = 0.2}};
}

void weigh(const std::optional<Turned>& turned, const std::optional<Heading>& heading, std::vector<North>& norths) {
  constexpr double kGrid_rad = 0.05 * kPi / 180.0;
  double sum = 0.0;
  for (North& north : norths) {
    if (turned && north.turned_rad)
      north.weight *= normal_density(wrap_angle_rad(turned->angle_rad - *north.turned_rad),
                                     std::hypot(turned->sigma_rad, kGrid_rad));
    else if (turned)
      north.weight *= 0.5 / kPi;
    if (heading) north.weight *= setup_density(heading->apart_rad - north.correction_rad, heading->sigma_rad);
    sum += north.weight;
  }
  for (North& north : norths) north.weight /= sum;
}

/// How far the others are from the one that is taken, weighed by how likely they are.
double doubt_rad(const std::vector<North>& norths, const North& taken) {
  double sum = 0.0;
  for (const North& north : norths) sum += north.weight * std::pow(north.correction_rad - taken.correction_rad, 2);
  return std::sqrt(sum);
}

std::string north_text(const char* format, double first, double second = 0.0) {
  char text[480];
  std::snprintf(text, sizeof text, format, first, second);
  return text;
}

void correct(const North& taken, const std::optional<GridFix>& place, Session& session) {
  Eigen::Vector3d at_m = Eigen::Vector3d::Zero(), before_m = at_m;
  GridFix here = place.value_or(GridFix{});
  bool first = true;
  for (StampedPose& pose : session.world_from_ins) {
    const Eigen::Vector3d logged_m = pose.pose.translation();
    if (!place) here = grid_fix_at(logged_m.x(), logged_m.y(), taken.northern).value_or(here);
    if (first) at_m = before_m = logged_m;
    first = false;
    const double metres = metres_per_grid_metre(here.point_scale, place ? 0.0 : logged_m.z());
    const Eigen::Vector3d step_m = logged_m - before_m;
    at_m += Eigen::Vector3d(metres * step_m.x(), metres * step_m.y(), step_m.z());
    before_m = logged_m;
    pose.pose.translation() = at_m;
    if (taken.correction_rad != 0.0)
      pose.pose.linear() = rotation_from_yaw_pitch_roll({here.convergence_rad, 0.0, 0.0}) * pose.pose.linear();
  }
}

void report(const North& taken, const std::optional<Heading>& heading, double doubt, Session& session) {
  constexpr double kNoDoubt_rad = 0.02 * kPi / 180.0;
  const std::string where = path_or_name(session);
  const double convergence_deg = radians_to_degrees(taken.correction_rad);
  if (taken.correction_rad != 0.0) {
    session.findings.push_back(make_finding(
        Severity::Warning, "utm-true-north", where,
        north_text("Positions are of the UTM grid and attitudes relative to true north, which are %.2f degrees apart "
                   "there: attitudes were turned to the grid by that, and distances divided by the grid's scale.",
                   convergence_deg)));
  } else if (taken.grid) {
    session.findings.push_back(
        make_finding(Severity::Note, "utm-grid-north", where,
                     "Positions are of the UTM grid, and attitudes are taken to be relative to its north, too; "
                     "distances were divided by the grid's scale."));
  }
  if (doubt < kNoDoubt_rad) return;
  session.ins_north_sigma_rad = doubt;
  session.findings.push_back(make_finding(
      Severity::Warning, "north-unknown", where,
      north_text(heading ? "Which north the attitudes count from was judged by the direction of travel, and may be "
                           "another: yaw is uncertain by %.2f degrees, which its sigma includes."
                         : "Which north the attitudes count from, that of the grid or the true one, is not known: yaw "
                           "is uncertain by %.2f degrees, which its sigma includes.",
                 radians_to_degrees(doubt))));
}

/// Neither numbers nor fixes say where the drive is: a constant angle between heading and travel may be a convergence.
void settle_without_place(const std::optional<Heading>& heading, Session& session) {
  constexpr double kLeast_rad = 0.5 * kPi / 180.0, kMost_rad = 3.5 * kPi / 180.0, kSure = 3.0;
  constexpr double kConvergences = 0.19 * 180.0 / kPi;  // density of those of zones, per radian
  if (!heading) return;
  const double apart_rad = std::abs(heading->apart_rad);
  if (apart_rad < std::max(kLeast_rad, kSure * heading->sigma_rad) || apart_rad > kMost_rad) return;
  const bool named =
      lower_case(session.world_frame).find("utm") != std::string::npos || session.attitudes_to_true_north;
  const double share = named ? 0.5 : 0.2;
  const double grid = share * kConvergences, own = (1.0 - share) * setup_density(apart_rad, heading->sigma_rad);
  session.ins_north_sigma_rad = apart_rad * std::sqrt(grid / (grid + own));
  session.findings.push_back(make_finding(
      Severity::Warning, "north-unknown", path_or_name(session),
      north_text("The heading of the INS keeps %.2f degrees from the direction of travel. Either the INS is turned so "
                 "in the vehicle, or positions are of a grid (UTM) and attitudes relative to true north, which the "
                 "data do not tell: yaw is uncertain by %.2f degrees, which its sigma includes.",
                 radians_to_degrees(heading->apart_rad), radians_to_degrees(session.ins_north_sigma_rad))));
}

}  // namespace

void settle_north(Session& session) {
  if (session.world_from_ins.empty() || !session.ins.empty()) return;
  const std::optional<Heading> heading = heading_apart(session);
  const std::optional<Turned> turned = turned_by_fixes(session);
  const std::optional<bool> northern =
      session.gnss.empty() ? std::nullopt : std::optional(session.gnss.front().latitude_rad >= 0.0);
  std::optional<GridFix> here;
  if (turned)
    here = UtmGrid(turned->latitude_rad, turned->longitude_rad).project(turned->latitude_rad, turned->longitude_rad);
  const bool numbers = has_numbers_of_utm(session.world_from_ins) && (!turned || lies_on_grid(*turned, *here));
  if (!numbers && !turned) return settle_without_place(heading, session);
  std::vector<North> norths = numbers ? norths_on_grid(session, northern) : norths_by_fixes(session, *here, *northern);
  weigh(numbers ? std::nullopt : turned, heading, norths);
  const North taken = *std::max_element(norths.begin(), norths.end(),
                                        [](const North& a, const North& b) { return a.weight < b.weight; });
  const double doubt = doubt_rad(norths, taken);
  if (taken.grid) correct(taken, numbers ? std::nullopt : here, session);
  report(taken, heading, doubt, session);
}

}  // namespace remount
