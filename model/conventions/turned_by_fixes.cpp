#include "model/conventions/turned_by_fixes.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>
#include <vector>

#include "algorithms/geodesy/local_level.h"
#include "algorithms/geometry/rotation.h"
#include "algorithms/motion/motion_track.h"

namespace remount::conventions {
namespace {

using Complex = std::complex<double>;  // a place or a direction on the plane, east or x real

/// Fixes beside poses of the same time.
struct Places {
  std::vector<Complex> in_enu, in_world, headings;
  Eigen::Vector3d middle_in_world = Eigen::Vector3d::Zero();
  double latitude_rad = 0.0, longitude_rad = 0.0;  ///< in the mean
};

Places places_of(const drive::Session& session) {
  constexpr std::size_t kMost = 2000;
  Places places;
  const motion::GnssFix& first = session.gnss.front();
  const geodesy::LocalLevel level(first.latitude_rad, first.longitude_rad, first.height_m);
  const motion::MotionTrack track(session.world_from_ins);
  const std::size_t step = std::max<std::size_t>(1, session.gnss.size() / kMost);
  for (std::size_t i = 0; i < session.gnss.size(); i += step) {
    const motion::GnssFix& fix = session.gnss[i];
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

}  // namespace

std::optional<TurnedByFixes> turned_by_fixes(const drive::Session& session) {
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
  return TurnedByFixes{std::arg(fit.turn),     std::abs(fit.turn),  std::max(fit.left_m, kLeast_m) * fit.sigma,
                       places.middle_in_world, places.latitude_rad, places.longitude_rad};
}

}  // namespace remount::conventions
