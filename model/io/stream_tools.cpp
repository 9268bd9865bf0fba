#include "model/io/stream_tools.h"

#include <cmath>
#include <set>

#include "algorithms/geometry/rotation.h"
#include "messages/files.h"
#include "messages/general.h"
#include "messages/poses.h"
#include "messages/sessions.h"
#include "model/io/cloud_fields.h"
#include "model/io/input_file.h"
#include "model/io/sweep_misfit.h"

namespace remount {
namespace {

/// 1843 to 2096: differences of two stamps within fit 64 bits.
constexpr std::int64_t kLatestStamp_ns = 4'000'000'000'000'000'000;

/// Far beyond any drive, well within one UTM zone and its neighbours.
constexpr double kFarthest_rad = 2.0 * kPi / 180.0;

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// How much a line of a table holds, as far as it shows whether the line is whole.
struct LineEnd {
  std::size_t fields, digits, decimals;  ///< of the line; of its last field, in all and behind the point
  bool number;                           ///< the last field is one
};

LineEnd end_of(std::string_view line) {
  std::vector<std::string_view> fields;
  if (line.find(',') != std::string_view::npos)
    split_csv(line, fields);
  else
    split_blanks(line, fields);
  const std::string_view last = fields.empty() ? std::string_view{} : fields.back();
  const auto digits_from = [&](std::size_t place) -> std::size_t {
    if (place == std::string_view::npos) return 0;
    return static_cast<std::size_t>(std::count_if(last.begin() + static_cast<std::ptrdiff_t>(place), last.end(),
                                                  [](char c) { return c >= '0' && c <= '9'; }));
  };
  // "1.5e-0" is a number, and was none with two digits of exponent; its decimals then say nothing.
  const std::size_t exponent = last.find_first_of("eE");
  const bool exponent_cut = exponent != std::string_view::npos && digits_from(exponent) < 2;
  return {fields.size(), digits_from(0), exponent_cut ? 0 : digits_from(last.find('.')),
          parse_number(last).has_value()};
}

/// Whether the last number of a line has lost so many digits that it is another.
bool lost_digits(const LineEnd& line, const LineEnd& fewest) {
  if (!line.number || !fewest.number || line.fields != fewest.fields) return false;
  return fewest.decimals > 0 ? 2 * line.decimals < fewest.decimals : line.digits < fewest.digits;
}

}  // namespace

Message message_of(const Error& error) {
  return error.where().empty() ? error.what_happened() : say::of_file(error.where(), error.what_happened());
}

Message BadItems::after(Message sentence) const {
  if (count_ == 0) return sentence;
  return Message::sequence({std::move(sentence), say::file_first_problem(first_)});
}

void BadItems::report(std::vector<Finding>& findings, const std::string& code, const std::string& where,
                      Message (*left_out)(Count count, Message first)) const {
  if (count_ > 0) findings.push_back(make_finding(Severity::Warning, code, where, left_out(count_, first_)));
}

std::string_view without_cut_line(std::string_view text, const std::string& path, std::vector<Finding>& findings) {
  constexpr std::size_t kFewest = 3, kMost = 20;  // numbers that end in zeros are written with fewer digits
  const std::size_t last = text.rfind('\n') + 1;
  const std::string_view line = trimmed(text.substr(last));
  if (line == "\x1a") return text.substr(0, last);  // the end of a file, to DOS
  if (line.empty() || line.starts_with('#')) return text;
  LineEnd fewest{text.size(), text.size(), text.size(), true};
  std::size_t compared = 0;
  for (std::size_t end = last; compared < kMost && end > 0;) {
    const std::size_t begin = end == 1 ? 0 : text.rfind('\n', end - 2) + 1;
    const std::string_view before = trimmed(text.substr(begin, end - 1 - begin));
    end = begin;
    if (before.empty() || before.starts_with('#') || begin == 0) continue;  // the first may be a header
    const LineEnd one = end_of(before);
    fewest = {std::min(fewest.fields, one.fields), std::min(fewest.digits, one.digits),
              std::min(fewest.decimals, one.decimals), fewest.number && one.number};
    ++compared;
  }
  const LineEnd cut = end_of(line);
  if (compared < kFewest || (cut.fields >= fewest.fields && !lost_digits(cut, fewest))) return text;
  const auto number = 1 + static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  findings.push_back(make_finding(Severity::Warning, "log-cut", at_line(path, number), say::stream_cut()));
  return text.substr(0, last);
}

namespace {

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
bool is_better(const GnssFix& later, const GnssFix& first) {
  return 4.0 * later.covariance_enu_m2.trace() < first.covariance_enu_m2.trace();
}
bool is_better(const InsSample& later, const InsSample& first) {
  const auto rank = [](const InsSample& sample) {
    return sample.quality == InsQuality::Good ? 2 : sample.quality == InsQuality::Invalid ? 0 : 1;
  };
  if (rank(later) != rank(first)) return rank(later) > rank(first);
  return 2.0 * later.sigma.position_enu_m.norm() < first.sigma.position_enu_m.norm();
}

}  // namespace

void keep_near(std::vector<InsSample>& ins, const std::string& where, std::vector<Finding>& findings) {
  keep_near_median(ins, "ins-far-away", say::stream_far_samples, where, findings);
}

void keep_near(std::vector<GnssFix>& fixes, const std::string& where, std::vector<Finding>& findings) {
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

template void keep_ascending(std::vector<InsSample>&, const std::string&, const std::string&, std::vector<Finding>&);
template void keep_ascending(std::vector<StampedPose>&, const std::string&, const std::string&, std::vector<Finding>&);
template void keep_ascending(std::vector<ScanFile>&, const std::string&, const std::string&, std::vector<Finding>&);
template void keep_ascending(std::vector<IndexedScan>&, const std::string&, const std::string&, std::vector<Finding>&);
template void keep_ascending(std::vector<ImuSample>&, const std::string&, const std::string&, std::vector<Finding>&);
template void keep_ascending(std::vector<GnssFix>&, const std::string&, const std::string&, std::vector<Finding>&);
template void keep_ascending(std::vector<WheelSample>&, const std::string&, const std::string&, std::vector<Finding>&);
template void keep_ascending(std::vector<BarometerSample>&, const std::string&, const std::string&,
                             std::vector<Finding>&);

const ScanFile& FileScanSource::at(std::size_t scan) const {
  if (scan >= files_.size()) throw Error(ErrorCode::Contract, "", say::scans_no_such(scan, files_.size()));
  return files_[scan];
}

bool has_point_times(const PointCloud& cloud) {
  constexpr float kLeast_s = 1e-3f;
  constexpr std::size_t kMany = 256, kFewest = 8;  // points, and different times of so many
  const std::vector<float>& times_s = cloud.time_from_stamp_s;
  if (times_s.empty()) return false;
  const auto [low, high] = std::minmax_element(times_s.begin(), times_s.end());
  if (!(*high - *low > kLeast_s)) return false;
  std::set<float> different;
  for (std::size_t i = 0; i < times_s.size() && different.size() < kFewest; ++i) different.insert(times_s[i]);
  return times_s.size() < kMany || different.size() >= kFewest;
}

PointCloud TimedScanSource::load(std::size_t scan) const {
  PointCloud cloud = read(scan).cloud;
  // A column or two of a sweep may be all that a torn scan has.
  constexpr std::size_t kMany = 256;
  const bool untimed = cloud.time_from_stamp_s.empty() || (cloud.size() >= kMany && !has_point_times(cloud));
  if (times_ == TimesOfPoints::Required && !cloud.points.empty() && untimed)
    throw Error(ErrorCode::Format, name(scan), say::scans_one_untimed());
  return cloud;
}

namespace {

double scan_interval_s(const TimedScanSource& scans) {
  constexpr std::size_t kMost = 500;
  std::vector<std::int64_t> steps;
  for (std::size_t i = 1; i < std::min(scans.size(), kMost); ++i)
    steps.push_back(scans.stamp_ns(i) - scans.stamp_ns(i - 1));
  if (steps.empty()) return 0.0;
  std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
  return static_cast<double>(steps[steps.size() / 2]) * 1e-9;
}

Message no_times_words(const ReadCloud& read) {
  return read.cloud.time_from_stamp_s.empty() ? say::times_none(read.columns_words())
                                              : say::times_all_the_same(read.columns_words());
}

}  // namespace

FoundPointTimes find_point_times(const TimedScanSource& scans) {
  FoundPointTimes found;
  const double interval_s = scan_interval_s(scans);
  for (std::size_t i = 0; i < std::min<std::size_t>(scans.size(), 3) && !found.usable; ++i) {
    try {
      const ReadCloud read = scans.read(i);
      const Message coarse = coarse_times(read);
      const bool timed = coarse.empty() && has_point_times(read.cloud);
      const Message misfit = timed ? sweep_misfit(read, interval_s) : Message();
      found.usable = timed && misfit.empty();
      if (found.usable) found.count = times_count(read.cloud);
      if (found.misfit || read.cloud.points.empty() || (!found.scan.empty() && misfit.empty())) continue;
      found.scan = scans.name(i);
      found.misfit = !misfit.empty();
      found.problem = found.misfit ? misfit : !coarse.empty() ? coarse : no_times_words(read);
    } catch (const Error&) {
      continue;  // becomes known when the scan is used
    }
  }
  found.misfit = found.misfit && !found.usable;
  return found;
}

Message expected_time_columns() { return say::times_known_columns({std::begin(kTimeColumns), std::end(kTimeColumns)}); }

void report_no_point_times(TimedScanSource& scans, Session& session) {
  const FoundPointTimes found = find_point_times(scans);
  session.scan_timing = ScanTiming::Unknown;
  scans.use_times(TimesOfPoints::Unused);
  if (found.misfit) {
    session.findings.push_back(
        make_finding(Severity::Warning, "point-times-misfit", found.scan, say::times_of_no_sweep(found.problem)));
    return;
  }
  session.findings.push_back(
      make_finding(Severity::Warning, "no-point-times", found.scan.empty() ? scans.name(0) : found.scan,
                   say::times_not_known(found.problem.empty() ? say::times_no_scan_readable() : found.problem)));
}

void report_point_clock(const TimedScanSource& scans, std::vector<Finding>& findings) {
  for (std::size_t i = 0; i < std::min<std::size_t>(scans.size(), 3); ++i) try {
      if (scans.read(i).points_have_another_clock)
        findings.push_back(make_finding(Severity::Warning, "point-clock", scans.name(i), say::times_another_clock()));
      return;
    } catch (const Error&) {
      continue;  // becomes known when the scan is used
    }
}

Eigen::Matrix3d checked_rotation(const Eigen::Matrix3d& logged, const std::string& where, double& defect) {
  if (!logged.allFinite()) throw Error(ErrorCode::Format, where, say::pose_not_finite());
  const Eigen::Matrix3d rotation = nearest_rotation(logged);
  defect = (rotation - logged).cwiseAbs().maxCoeff();
  if (defect > 0.1) throw Error(ErrorCode::Format, where, say::pose_no_rotation(defect));
  return rotation;
}

bool plausible_geodetic(double latitude_rad, double longitude_rad, double height_m) {
  constexpr double kLowest_m = -9000.0, kHighest_m = 1e5;
  return std::abs(latitude_rad) <= kPi / 2.0 && std::abs(longitude_rad) <= 2.0 * kPi && height_m > kLowest_m &&
         height_m < kHighest_m;
}

bool means_not_known(double value) { return !(std::abs(value) < 1e8); }

bool angle_means_not_known(double logged) {
  constexpr double kMostTurns_deg = 1e6;  // of a yaw that counts on
  const double size = std::abs(logged);
  if (!(size < kMostTurns_deg)) return true;
  for (const double nines : {999.0, 9999.0, 99999.0, 999999.0, 32767.0, 32768.0, 65535.0})
    if (size == nines) return true;
  return false;
}

}  // namespace remount
