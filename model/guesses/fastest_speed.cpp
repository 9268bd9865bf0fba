#include "model/guesses/fastest_speed.h"

#include <algorithm>
#include <cmath>

namespace remount::guesses {

std::vector<std::size_t> distinct_fixes(const std::vector<Eigen::Vector3d>& places_m,
                                        const std::vector<double>& times_s) {
  std::vector<std::size_t> fixes;
  for (std::size_t i = 1; i < places_m.size(); ++i)
    if (places_m[i].head<2>() != places_m[i - 1].head<2>() && places_m[i].allFinite() && std::isfinite(times_s[i]))
      fixes.push_back(i);
  return fixes;
}

double fastest_speed_mps(const std::vector<Eigen::Vector3d>& places_m, const std::vector<double>& times_s,
                         const std::vector<std::size_t>& fixes) {
  constexpr double kStretch_s = 0.5, kFewestStretches = 20.0;
  if (fixes.empty()) return 0.0;
  const double all_s = times_s[fixes.back()] - times_s[fixes.front()];
  // A unit of time that is wrong makes a drive of it that takes no half second.
  const double least_s = std::min(kStretch_s, all_s / kFewestStretches);
  std::vector<double> speeds_mps;
  for (std::size_t from = 0, to = 1; to < fixes.size(); ++to) {
    const auto since = [&](std::size_t i) { return times_s[fixes[to]] - times_s[fixes[i]]; };
    while (from + 1 < to && since(from + 1) >= least_s) ++from;
    if (!(since(from) >= least_s && since(from) > 0.0)) continue;
    speeds_mps.push_back((places_m[fixes[to]] - places_m[fixes[from]]).head<2>().norm() / since(from));
  }
  if (speeds_mps.empty()) return 0.0;
  const auto place = speeds_mps.begin() + static_cast<std::ptrdiff_t>(speeds_mps.size() * 99 / 100);
  std::ranges::nth_element(speeds_mps, place);
  return *place;
}

}  // namespace remount::guesses
