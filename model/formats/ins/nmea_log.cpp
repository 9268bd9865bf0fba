#include "model/formats/ins/nmea_log.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithms/core/stamps.h"
#include "messages/ins_logs.h"
#include "messages/sessions.h"
#include "model/conventions/assumed_tilt.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/text_file.h"
#include "model/formats/ins/nmea_records.h"
#include "model/formats/ins/position_lag_prior.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

constexpr std::int64_t kNearAttitude_ns = 250'000'000;

/// What the quality of a GGA usually means, m; NaN where none is stated.
double usual_sigma_m(const NmeaFix& fix) {
  switch (fix.quality) {
    case 0:
      return std::nan("");
    case 4:
      return 0.02;
    case 5:
      return 0.3;
    case 2:
    case 9:
      return 0.8;
    default:
      return 2.0 * std::clamp(static_cast<double>(fix.hdop), 1.0, 20.0);
  }
}

motion::InsQuality quality_of(const NmeaFix& fix) {
  if (fix.quality == 0) return motion::InsQuality::Unknown;
  return fix.quality == 4 ? motion::InsQuality::Good : motion::InsQuality::Degraded;
}

/// In the order of their times: as the log measures them, or of headings alone where it has nothing better. Headings
/// are kept as they are, for an attitude takes four times as much.
struct Attitudes {
  std::vector<NmeaAttitude> measured;
  std::vector<TimedHeading> headings;

  std::size_t size() const { return measured.size() + headings.size(); }
  bool empty() const { return size() == 0; }
  std::int64_t time_ns(std::size_t i) const { return measured.empty() ? headings[i].time_ns : measured[i].time_ns; }
  NmeaAttitude at(std::size_t i) const {
    if (!measured.empty()) return measured[i];
    return {headings[i].time_ns,
            drive::enu_from_ins({headings[i].heading_rad, 0.0, 0.0}, drive::AttitudeConvention::Heading),
            {conventions::kAssumedTilt_rad, conventions::kAssumedTilt_rad, conventions::kAntennaHeading_rad}};
  }
  /// The first that is not before a time.
  std::size_t since(std::int64_t time) const {
    std::size_t first = 0, last = size();
    while (first < last) {
      const std::size_t middle = first + (last - first) / 2;
      if (time_ns(middle) < time)
        first = middle + 1;
      else
        last = middle;
    }
    return first;
  }
  /// Whether there is one at a time.
  bool have(std::int64_t time) const {
    const std::size_t after = since(time);
    return after < size() && time_ns(after) == time;
  }
  /// Whether there is one at a time, or around it, near enough.
  bool reach(std::int64_t time) const {
    const std::size_t after = since(time);
    if (have(time)) return true;
    return after > 0 && after < size() && time_ns(after) - time_ns(after - 1) <= kNearAttitude_ns;
  }
  /// Of a time that is reached.
  NmeaAttitude around(std::int64_t time) const {
    const NmeaAttitude after = at(since(time));
    if (after.time_ns == time) return after;
    const NmeaAttitude before = at(since(time) - 1);
    const double share =
        static_cast<double>(time - before.time_ns) / static_cast<double>(after.time_ns - before.time_ns);
    return {time, before.enu_from_ins.slerp(share, after.enu_from_ins), after.sigma_rad};
  }
};

/// Makes the streams of a session of what the log holds, and frees each part of that once it is in them.
class NmeaAssembly {
 public:
  NmeaAssembly(NmeaRecords records, const fs::path& path, std::vector<drive::Finding>& findings)
      : records_(std::move(records)), path_(path), findings_(findings) {}

  NmeaLog made() {
    records_.bad.report(findings_, "bad-nmea", path_.string(), say::left_out_lines);
    if (records_.cut_line > 0)
      findings_.push_back(
          drive::make_finding(drive::Severity::Warning, "log-cut", at_line(path_, records_.cut_line), say::nmea_cut()));
    take_attitudes();
    records_.keep_best_fixes();  // those of an INS and of an antenna are of two places
    drive::report_one_stamp(records_.of_one_time, true, "gnss", path_.string(), findings_);
    NmeaLog log;
    log.ins = ins();
    log.position_lag_sigma_s = position_lag_sigma_s(
        log.ins.size(), static_cast<std::size_t>(std::ranges::count_if(
                            records_.fixes, [&](const NmeaFix& fix) { return attitudes_.have(fix.time_ns); })));
    tell(log);
    tell_missing(log);
    attitudes_ = {};
    log.fixes = fixes();
    drive::keep_near(log.fixes, path_.string(), findings_);
    drive::keep_ascending(log.fixes, "gnss", path_.string(), findings_);
    std::vector<drive::Finding> told_already;
    drive::keep_near(log.ins, path_.string(), told_already);
    drive::keep_ascending(log.ins, "ins", path_.string(), told_already);
    return log;
  }

 private:
  void take_attitudes() {
    const HeadingPlaces places = std::exchange(records_.places, {});
    const auto best = records_.best_attitudes();
    // Attitudes that come too rarely give no motion; headings that come often give some of it.
    const bool rather_headings = best && places.count() > 4 * records_.of(*best).samples.size();
    if (best && !rather_headings) return take_measured(*best);
    records_.attitudes = {};
    HeadingTimes times = places.times();
    attitudes_.headings = std::move(times.headings);
    if (times.order == HeadingOrder::Unknown)
      findings_.push_back(
          drive::make_finding(drive::Severity::Warning, "heading-order", path_.string(), say::nmea_heading_order()));
  }

  void take_measured(NmeaAttitudeKind kind) {
    const std::size_t other_fixes = records_.keep_fixes_of(kind);
    std::string others;
    for (std::size_t i = 0; i < records_.attitudes.size(); ++i) {
      const auto other = static_cast<NmeaAttitudeKind>(i);
      if (other != kind && !records_.attitudes[i].samples.empty())
        others += (others.empty() ? "" : "; ") + std::string(NmeaRecords::name(other));
    }
    tell_chosen(std::string(NmeaRecords::name(kind)), others, other_fixes);
    const bool rolls = records_.of(kind).rolls;
    attitudes_.measured = std::move(records_.of(kind).samples);
    records_.attitudes = {};
    std::stable_sort(attitudes_.measured.begin(), attitudes_.measured.end(),
                     [](const NmeaAttitude& a, const NmeaAttitude& b) { return a.time_ns < b.time_ns; });
    if (rolls) return;
    for (NmeaAttitude& attitude : attitudes_.measured) conventions::assume_roll(attitude.sigma_rad);
    findings_.push_back(drive::make_finding(
        drive::Severity::Warning, "roll-assumed", path_.string(),
        say::nmea_roll_assumed(std::string(NmeaRecords::name(kind)), Angle{conventions::kAssumedTilt_rad})));
  }

  void tell_chosen(const std::string& chosen, const std::string& others, std::size_t other_fixes) const {
    if (others.empty() && other_fixes == 0) return;
    findings_.push_back(drive::make_finding(drive::Severity::Note, "attitude-chosen", path_.string(),
                                            other_fixes == 0 ? say::nmea_attitude_chosen(chosen, others)
                                            : others.empty()
                                                ? say::nmea_attitude_and_position(chosen, other_fixes)
                                                : say::nmea_attitude_position_and_others(chosen, other_fixes, others)));
  }

  Eigen::Vector3d sigma_enu_m(const NmeaFix& fix) const {
    if (const NmeaErrors* error = records_.errors_of(fix)) return {error->east_m, error->north_m, error->up_m};
    const double usual = usual_sigma_m(fix);
    return {usual, usual, 1.5 * usual};
  }

  std::int64_t stamp_ns(const NmeaFix& fix) const { return records_.midnight_ns + fix.time_ns; }

  std::vector<motion::InsSample> ins() const {
    std::vector<motion::InsSample> samples;
    const auto reached = [&](const NmeaFix& fix) { return attitudes_.reach(fix.time_ns); };
    samples.reserve(static_cast<std::size_t>(std::count_if(records_.fixes.begin(), records_.fixes.end(), reached)));
    for (const NmeaFix& fix : records_.fixes) {
      if (!reached(fix)) continue;
      const NmeaAttitude attitude = attitudes_.around(fix.time_ns);
      samples.push_back({stamp_ns(fix),
                         fix.latitude_rad,
                         fix.longitude_rad,
                         fix.height_m,
                         attitude.enu_from_ins,
                         {sigma_enu_m(fix), attitude.sigma_rad},
                         quality_of(fix)});
    }
    return samples;
  }

  std::vector<motion::GnssFix> fixes() const {
    std::vector<motion::GnssFix> fixes;
    fixes.reserve(records_.fixes.size());
    constexpr double kUnstated_m = 1.0;
    for (const NmeaFix& fix : records_.fixes) {
      const Eigen::Vector3d stated_m = sigma_enu_m(fix);
      const Eigen::Vector3d sigma_m = stated_m.allFinite() ? stated_m : Eigen::Vector3d::Constant(kUnstated_m);
      fixes.push_back({stamp_ns(fix), fix.latitude_rad, fix.longitude_rad, fix.height_m,
                       Eigen::Matrix3d(sigma_m.cwiseAbs2().asDiagonal())});
    }
    return fixes;
  }

  void tell(const NmeaLog& log) const {
    if (records_.errors.empty())
      findings_.push_back(
          drive::make_finding(drive::Severity::Note, "gnss-sigma-assumed", path_.string(), say::nmea_errors_assumed()));
    if (records_.without_geoid > 0)
      findings_.push_back(
          drive::make_finding(drive::Severity::Note, "height-above-sea", path_.string(), say::nmea_above_sea()));
    if (attitudes_.measured.empty() && !log.ins.empty())
      findings_.push_back(drive::make_finding(drive::Severity::Warning, "heading-alone", path_.string(),
                                              say::nmea_heading_alone(Angle{conventions::kAssumedTilt_rad})));
  }

  /// Positions between the first attitude and the last that got none; all where there is no INS.
  void tell_missing(const NmeaLog& log) const {
    if (attitudes_.empty()) return;
    const std::int64_t first_ns = attitudes_.time_ns(0), last_ns = attitudes_.time_ns(attitudes_.size() - 1);
    const auto missing = std::count_if(records_.fixes.begin(), records_.fixes.end(), [&](const NmeaFix& fix) {
      const bool within = fix.time_ns >= first_ns && fix.time_ns <= last_ns;
      return (within || log.ins.empty()) && !attitudes_.reach(fix.time_ns);
    });
    if (missing == 0) return;
    std::int64_t longest_ns = 0;
    for (std::size_t i = 1; i < attitudes_.size(); ++i)
      longest_ns = std::max(longest_ns, attitudes_.time_ns(i) - attitudes_.time_ns(i - 1));
    findings_.push_back(
        drive::make_finding(drive::Severity::Warning, "attitude-sparse", path_.string(),
                            say::nmea_attitude_sparse(missing, records_.fixes.size(), attitudes_.size(),
                                                      Duration{1e-9 * static_cast<double>(longest_ns)},
                                                      Duration{1e-9 * static_cast<double>(kNearAttitude_ns)})));
  }

  NmeaRecords records_;
  const fs::path& path_;
  std::vector<drive::Finding>& findings_;
  Attitudes attitudes_;
};

}  // namespace

bool recognise_nmea(const fs::path& path) {
  try {
    const std::string head = read_text_head(path, 64 * 1024);
    LineReader lines(head);
    std::size_t known = 0, other = 0;
    for (std::string_view line; lines.next(line) && known + other < 40;) {
      NmeaSentence sentence;
      if (trim(line).empty()) continue;
      // With a wrong checksum, too: a log that has nothing else is to be refused for that, not as something unknown.
      if (parse_nmea(line, sentence) == NmeaLine::NoSentence)
        ++other;
      else if (!sentence.talker.empty() || NmeaRecords::reads(sentence.type))
        ++known;
      // Sentences of makers say neither: receivers write many between those that are read.
    }
    return known > 0 && known >= 3 * other;
  } catch (const Error&) {
    return false;
  }
}

NmeaLog read_nmea(const fs::path& path, std::vector<drive::Finding>& findings) {
  return NmeaAssembly(NmeaRecords::read(path), path, findings).made();
}

NmeaLog parse_nmea_log(std::string_view text, const fs::path& path, std::vector<drive::Finding>& findings) {
  return NmeaAssembly(NmeaRecords::parse(text, path), path, findings).made();
}

}  // namespace remount::formats
