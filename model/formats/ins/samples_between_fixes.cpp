#include "model/formats/ins/samples_between_fixes.h"

#include <algorithm>
#include <cmath>

#include "algorithms/core/stamps.h"
#include "algorithms/motion/cubic_between.h"
#include "algorithms/motion/sample_spacing.h"
#include "model/drive/stamped_streams.h"

namespace remount::formats {
namespace {

constexpr double kMoreOften = 2.0;

double apart_s(const motion::InsSample& from, const motion::InsSample& to) {
  return seconds(to.stamp_ns - from.stamp_ns);
}

// That nothing is known of one says more against it than that the other is good.
motion::InsQuality worse_of(motion::InsQuality a, motion::InsQuality b) {
  const bool unknown = a == motion::InsQuality::Unknown || b == motion::InsQuality::Unknown;
  return unknown && std::max(a, b) == motion::InsQuality::Good ? motion::InsQuality::Unknown : std::max(a, b);
}

// Latitude, longitude and height as steps from `origin`: what is near stays near also at the date line.
Eigen::Vector3d from_origin(const motion::InsSample& sample, const motion::InsSample& origin) {
  return {sample.latitude_rad - origin.latitude_rad,
          std::remainder(sample.longitude_rad - origin.longitude_rad, 2.0 * kPi), sample.height_m - origin.height_m};
}

}  // namespace

double longest_turn_s(const std::vector<StampedAttitude>& attitudes) {
  constexpr double kLeast_s = 0.05, kOfUsual = 3.0;
  return std::max(kLeast_s, kOfUsual * drive::median_period_s(attitudes));
}

double longest_way_s(const std::vector<motion::InsSample>& fixes) {
  constexpr double kLeast_s = 0.25, kOfUsual = 5.0;
  return std::max(kLeast_s, kOfUsual * drive::median_period_s(fixes));
}

std::optional<AttitudeAt> attitude_at(const std::vector<StampedAttitude>& attitudes, std::int64_t stamp_ns,
                                      double longest_s) {
  const auto after = std::ranges::lower_bound(attitudes, stamp_ns, {}, &StampedAttitude::stamp_ns);
  if (after == attitudes.end()) return std::nullopt;
  if (after->stamp_ns == stamp_ns) return AttitudeAt{after->enu_from_ins.normalized(), after->sigma_rad, true};
  if (after == attitudes.begin()) return std::nullopt;
  const StampedAttitude& before = *(after - 1);
  const double step_s = seconds(after->stamp_ns - before.stamp_ns);
  if (step_s > longest_s) return std::nullopt;
  const double share =
      static_cast<double>(stamp_ns - before.stamp_ns) / static_cast<double>(after->stamp_ns - before.stamp_ns);
  return AttitudeAt{before.enu_from_ins.slerp(share, after->enu_from_ins).normalized(), after->sigma_rad, false};
}

motion::InsSample sample_between(const std::vector<motion::InsSample>& fixes, std::size_t before,
                                 const StampedAttitude& attitude, double longest_s) {
  const motion::InsSample &from = fixes[before], &to = fixes[before + 1];
  motion::CubicNeighbours around;
  around.has_first = before > 0 && apart_s(fixes[before - 1], from) <= longest_s;
  around.has_last = before + 2 < fixes.size() && apart_s(to, fixes[before + 2]) <= longest_s;
  for (std::size_t i = around.has_first ? 0 : 1; i < (around.has_last ? 4U : 3U); ++i) {
    around.times_s[i] = apart_s(from, fixes[before + i - 1]);
    around.values[i] = from_origin(fixes[before + i - 1], from);
  }
  const Eigen::Vector3d step = motion::cubic_between(around, seconds(attitude.stamp_ns - from.stamp_ns));
  motion::InsSample sample = from;
  sample.stamp_ns = attitude.stamp_ns;
  sample.latitude_rad += step.x();
  sample.longitude_rad = std::remainder(from.longitude_rad + step.y(), 2.0 * kPi);
  sample.height_m += step.z();
  sample.enu_from_ins = attitude.enu_from_ins;
  sample.sigma.position_enu_m = from.sigma.position_enu_m.cwiseMax(to.sigma.position_enu_m);
  sample.sigma.attitude_rad = attitude.sigma_rad;
  sample.quality = worse_of(from.quality, to.quality);
  return sample;
}

SamplesBetweenFixes samples_between_fixes(std::vector<motion::InsSample> at_fixes,
                                          const std::vector<StampedAttitude>& attitudes) {
  const double period_s = drive::median_period_s(at_fixes), attitude_s = drive::median_period_s(attitudes);
  SamplesBetweenFixes out;
  if (attitudes.size() < 2 || period_s < motion::kSlowSamples_s || !(kMoreOften * attitude_s <= period_s)) {
    out.ins = std::move(at_fixes);
    return out;
  }
  const double longest_s = longest_way_s(at_fixes);
  for (const motion::InsSample& sample : at_fixes) out.fix_stamps_ns.push_back(sample.stamp_ns);
  auto next = attitudes.begin();
  for (std::size_t k = 0; k < at_fixes.size(); ++k) {
    out.ins.push_back(at_fixes[k]);
    if (k + 1 == at_fixes.size() || apart_s(at_fixes[k], at_fixes[k + 1]) > longest_s) continue;
    while (next != attitudes.end() && next->stamp_ns <= at_fixes[k].stamp_ns) ++next;
    for (; next != attitudes.end() && next->stamp_ns < at_fixes[k + 1].stamp_ns; ++next)
      out.ins.push_back(sample_between(at_fixes, k, *next, longest_s));
  }
  return out;
}

}  // namespace remount::formats
