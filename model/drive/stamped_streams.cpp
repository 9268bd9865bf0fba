#include "model/drive/stamped_streams.h"

#include <algorithm>
#include <cmath>

#include "algorithms/core/error.h"
#include "algorithms/geometry/rotation.h"
#include "messages/sessions.h"
#include "model/drive/bad_items.h"

namespace remount::drive {
namespace {

/// 1843 to 2096: differences of two stamps within fit 64 bits.
constexpr std::int64_t kLatestStamp_ns = 4'000'000'000'000'000'000;

/// Far beyond any drive, well within one UTM zone and its neighbours.
constexpr double kFarthest_rad = 2.0 * kPi / 180.0;

template <class Item>
void keep_near_median(std::vector<Item>& items, const std::string& code, Message (*lie_far)(Count count, Angle most),
                      const std::string& where, std::vector<Finding>& findings) {
  if (items.empty()) return;
  const double first_longitude = items.front().longitude_rad;
  double latitude = 0.0, longitude = 0.0;
  {
    std::vector<double> values(items.size());
    std::transform(items.begin(), items.end(), values.begin(), [](const Item& item) { return item.latitude_rad; });
    latitude = median_of(values);
    // From the first sample, so that a drive across the date line stays in one piece.
    std::transform(items.begin(), items.end(), values.begin(),
                   [&](const Item& item) { return wrap_angle_rad(item.longitude_rad - first_longitude); });
    longitude = median_of(std::move(values)) + first_longitude;
  }
  const std::size_t far = std::erase_if(items, [&](const Item& item) {
    return std::abs(item.latitude_rad - latitude) > kFarthest_rad ||
           std::abs(wrap_angle_rad(item.longitude_rad - longitude)) > kFarthest_rad;
  });
  if (items.empty()) throw Error(ErrorCode::Format, where, say::stream_all_over_the_earth());
  if (far > 0) findings.push_back(make_finding(Severity::Warning, code, where, lie_far(far, Angle{kFarthest_rad})));
}

/// Of two items with one stamp: whether the later is clearly better by what it says of itself. A little better is no
/// reason: where stamps are rounded, items with one stamp are of different moments, and the first has it.
template <class Item>
bool is_better(const Item&, const Item&) {
  return false;
}
bool is_better(const motion::GnssFix& later, const motion::GnssFix& first) {
  return 4.0 * later.covariance_enu_m2.trace() < first.covariance_enu_m2.trace();
}
bool is_better(const motion::InsSample& later, const motion::InsSample& first) {
  const auto rank = [](const motion::InsSample& sample) {
    return sample.quality == motion::InsQuality::Good ? 2 : sample.quality == motion::InsQuality::Invalid ? 0 : 1;
  };
  if (rank(later) != rank(first)) return rank(later) > rank(first);
  return 2.0 * later.sigma.position_enu_m.norm() < first.sigma.position_enu_m.norm();
}

}  // namespace

void keep_near(std::vector<motion::InsSample>& ins, const std::string& where, std::vector<Finding>& findings) {
  keep_near_median(ins, "ins-far-away", say::stream_far_samples, where, findings);
}

void keep_near(std::vector<motion::GnssFix>& fixes, const std::string& where, std::vector<Finding>& findings) {
  keep_near_median(fixes, "gnss-far-away", say::stream_far_fixes, where, findings);
}

void report_one_stamp(std::size_t count, bool best, const std::string& code, const std::string& where,
                      std::vector<Finding>& findings) {
  if (count == 0) return;
  findings.push_back(make_finding(Severity::Note, code + "-duplicate-stamps", where,
                                  best ? say::stream_repeats_best(count) : say::stream_repeats_first(count)));
}

template <class Item>
void keep_ascending(std::vector<Item>& items, const std::string& code, const std::string& where,
                    std::vector<Finding>& findings) {
  const std::size_t impossible = std::erase_if(
      items, [](const Item& item) { return item.stamp_ns > kLatestStamp_ns || item.stamp_ns < -kLatestStamp_ns; });
  if (items.empty() && impossible > 0) throw Error(ErrorCode::Format, where, say::stream_no_possible_time());
  if (impossible > 0)
    findings.push_back(
        make_finding(Severity::Warning, code + "-impossible-stamps", where, say::stream_impossible_times(impossible)));
  std::size_t duplicates = 0, reversed = 0, replaced = 0, kept = 0;  // in place: there may be millions
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::int64_t stamp = items[i].stamp_ns;
    const auto behind_last = [&](std::int64_t other) { return kept == 0 || other > items[kept - 1].stamp_ns; };
    // One stamp ahead of its successor while that goes on from its predecessor: a glitch that would swallow the rest.
    const bool glitch = i + 1 < items.size() && stamp > items[i + 1].stamp_ns && behind_last(items[i + 1].stamp_ns);
    if (!glitch && behind_last(stamp)) {
      if (kept != i) items[kept] = std::move(items[i]);
      ++kept;
      continue;
    }
    const bool repeats = !glitch && stamp == items[kept - 1].stamp_ns;
    ++(repeats ? duplicates : reversed);
    if (!repeats || !is_better(items[i], items[kept - 1])) continue;
    items[kept - 1] = std::move(items[i]);
    ++replaced;
  }
  items.erase(items.begin() + static_cast<std::ptrdiff_t>(kept), items.end());
  report_one_stamp(duplicates, replaced > 0, code, where, findings);
  if (reversed > 0)
    findings.push_back(
        make_finding(Severity::Warning, code + "-reversed-stamps", where, say::stream_reversed(reversed)));
}

template void keep_ascending(std::vector<motion::InsSample>&, const std::string&, const std::string&,
                             std::vector<Finding>&);
template void keep_ascending(std::vector<motion::StampedPose>&, const std::string&, const std::string&,
                             std::vector<Finding>&);
template void keep_ascending(std::vector<ScanFile>&, const std::string&, const std::string&, std::vector<Finding>&);
template void keep_ascending(std::vector<IndexedScan>&, const std::string&, const std::string&, std::vector<Finding>&);
template void keep_ascending(std::vector<motion::ImuSample>&, const std::string&, const std::string&,
                             std::vector<Finding>&);
template void keep_ascending(std::vector<motion::GnssFix>&, const std::string&, const std::string&,
                             std::vector<Finding>&);
template void keep_ascending(std::vector<motion::WheelSample>&, const std::string&, const std::string&,
                             std::vector<Finding>&);
template void keep_ascending(std::vector<motion::BarometerSample>&, const std::string&, const std::string&,
                             std::vector<Finding>&);

}  // namespace remount::drive
