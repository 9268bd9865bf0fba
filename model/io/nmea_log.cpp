#include "model/io/nmea_log.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>

#include "model/io/heading_times.h"
#include "model/io/input_file.h"
#include "model/io/nmea_sentence.h"
#include "model/io/stream_tools.h"
#include "model/io/time_stamp.h"

namespace remount {

namespace fs = std::filesystem;

namespace {

constexpr std::int64_t kDay_ns = 86'400'000'000'000;
constexpr std::int64_t kLate_ns = 60'000'000'000;  ///< more than any sentence comes behind those of a later time
constexpr std::int64_t kNearAttitude_ns = 250'000'000;
constexpr double kUnknownTilt_rad = 3.0 * kPi / 180.0;

struct Fix {
  std::int64_t time_ns = 0;  ///< since midnight of the first day
  double latitude_rad = 0.0, longitude_rad = 0.0, height_m = 0.0;
  double hdop = 1.0;
  int quality = 0;
};

struct Attitude {
  std::int64_t time_ns = 0;
  Eigen::Quaterniond enu_from_ins;
  Eigen::Vector3d sigma_rad;
};

/// Standard deviations of a GST sentence, m.
struct Stated {
  double north_m = 0.0, east_m = 0.0, up_m = 0.0;
};

std::optional<Stated> stated(const NmeaSentence& sentence) {
  const auto north = parse_number(sentence.field(5)), east = parse_number(sentence.field(6)),
             up = parse_number(sentence.field(7));
  if (!north || !east || !up || !(*north > 0.0 && *east > 0.0 && *up > 0.0)) return std::nullopt;
  return Stated{*north, *east, *up};
}

/// An angle in degrees; nothing where it is none or beyond two turns.
std::optional<double> angle_rad(std::string_view text) {
  const auto degrees = parse_number(text);
  if (!degrees || std::abs(*degrees) > 720.0) return std::nullopt;
  return degrees_to_radians(*degrees);
}

/// What the quality of a GGA usually means, m.
double usual_sigma_m(const Fix& fix) {
  switch (fix.quality) {
    case 4:
      return 0.02;
    case 5:
      return 0.3;
    case 2:
      return 0.8;
    default:
      return 2.0 * std::clamp(fix.hdop, 1.0, 20.0);
  }
}

/// Sentences of a log in order, with a clock that runs over midnight.
class NmeaReader {
 public:
  explicit NmeaReader(const fs::path& path) : path_(path) {}

  NmeaLog read(std::vector<Finding>& findings) {
    take_lines(read_regular_file(path_));
    if (fixes_.empty())
      throw Error(ErrorCode::Format, path_.string(),
                  "holds no GGA sentence with a fix." + (bad_.count() ? " First problem: " + bad_.first() : ""));
    if (!midnight_ns_)
      throw Error(ErrorCode::Format, path_.string(),
                  "holds no date: GGA tells the time of day alone. Log RMC or ZDA as well");
    bad_.report(findings, "bad-nmea", path_.string(), "lines");
    return assembled(findings);
  }

 private:
  void take_lines(const std::string& text) {
    LineReader lines(text);
    for (std::string_view line; lines.next(line);) {
      NmeaSentence sentence;
      const NmeaLine kind = parse_nmea(line, sentence);
      if (kind == NmeaLine::WrongChecksum)
        bad_.add(at_line(path_, lines.line_number()) + ": the checksum is wrong");
      else if (kind == NmeaLine::Sentence && !take(sentence))
        bad_.add(at_line(path_, lines.line_number()) + ": " + std::string(sentence.type) + " without usable values");
    }
  }

  /// False where the sentence is of a kind that is read, and cannot be.
  bool take(const NmeaSentence& sentence) {
    timed_ = false;
    const bool taken = take_kind(sentence);
    if (!timed_ && sentence.type != "HDT") places_.add_other();
    return taken;
  }

  bool take_kind(const NmeaSentence& sentence) {
    if (sentence.type == "GGA") return take_fix(sentence);
    if (sentence.type == "RMC") return take_date(sentence.field(0), sentence.field(8));
    if (sentence.type == "ZDA")
      return take_date(sentence.field(0), std::string(sentence.field(1)) + std::string(sentence.field(2)) +
                                              std::string(sentence.field(3)));
    if (sentence.type == "GST") return take_error(sentence);
    if (sentence.type == "HDT") return take_heading(sentence);
    if (sentence.type == "PASHR" && sentence.field(2) == "T") return take_attitude(sentence);
    return true;
  }

  /// Time of day to time since the first midnight: a step back by most of a day is a new one, and a step ahead by
  /// nearly all of one a sentence from before midnight that comes late.
  std::optional<std::int64_t> running(std::string_view text) {
    const auto time = nmea_time_ns(text);
    if (!time) return std::nullopt;
    std::int64_t now = days_ * kDay_ns + *time;
    if (now < last_ns_ - kDay_ns / 2)
      ++days_, now += kDay_ns;
    else if (last_ns_ >= 0 && now > last_ns_ + kDay_ns - kLate_ns)
      now -= kDay_ns;
    last_ns_ = std::max(last_ns_, now);
    places_.add_time(last_ns_);
    timed_ = true;
    return now;
  }

  bool take_fix(const NmeaSentence& sentence) {
    places_.add_position();
    const auto time = running(sentence.field(0));
    const auto quality = parse_integer(sentence.field(5));
    if (!time || !quality) return sentence.field(0).empty();  // before the first fix receivers leave all empty
    if (*quality <= 0 || *quality > 8) return true;
    const auto latitude = nmea_angle_rad(sentence.field(1), sentence.field(2));
    const auto longitude = nmea_angle_rad(sentence.field(3), sentence.field(4));
    const auto height = parse_number(sentence.field(8)), geoid = parse_number(sentence.field(10));
    if (!latitude || !longitude || !height || !plausible_geodetic(*latitude, *longitude, *height + geoid.value_or(0.0)))
      return false;
    without_geoid_ += !geoid;
    fixes_.push_back({*time, *latitude, *longitude, *height + geoid.value_or(0.0),
                      parse_number(sentence.field(7)).value_or(1.0), static_cast<int>(*quality)});
    return true;
  }

  /// ddmmyy or ddmmyyyy
  bool take_date(std::string_view time_text, std::string_view date) {
    const auto time = running(time_text);
    if (!time || midnight_ns_ || date.empty()) return true;
    if (date.size() != 6 && date.size() != 8) return false;
    const std::string year = (date.size() == 6 ? "20" : "") + std::string(date.substr(4));
    const auto midnight =
        parse_date_ns(year + "-" + std::string(date.substr(2, 2)) + "-" + std::string(date.substr(0, 2)) + " 00:00:00");
    if (!midnight) return false;
    const std::int64_t day = *time < 0 ? -1 : *time / kDay_ns;  // a late sentence has the date of the day before
    midnight_ns_ = *midnight - day * kDay_ns;
    return true;
  }

  bool take_error(const NmeaSentence& sentence) {
    const auto time = running(sentence.field(0));
    const auto error = stated(sentence);
    if (time && error) errors_[*time] = *error;
    return time.has_value();
  }

  bool take_heading(const NmeaSentence& sentence) {
    const auto heading = angle_rad(sentence.field(0));
    if (heading) places_.add_heading(*heading);
    return heading || sentence.field(0).empty();
  }

  bool take_attitude(const NmeaSentence& sentence) {
    const auto time = running(sentence.field(0));
    const auto heading = angle_rad(sentence.field(1)), roll = angle_rad(sentence.field(3)),
               pitch = angle_rad(sentence.field(4));
    if (!time || !heading || !roll || !pitch) return false;
    const auto sigma = [&](std::size_t field) {
      const auto value = parse_number(sentence.field(field));
      return value && *value > 0.0 ? degrees_to_radians(*value) : std::nan("");
    };
    attitudes_.push_back({*time, enu_from_ins({*heading, *pitch, *roll}, AttitudeConvention::Heading),
                          axis_sigma_rad({sigma(8), sigma(7), sigma(6)}, AttitudeConvention::Heading)});
    return true;
  }

  /// Between the attitudes around it, or at one; nothing where none is near.
  static std::optional<Attitude> attitude_at(const std::vector<Attitude>& attitudes, std::int64_t time_ns) {
    const auto after = std::lower_bound(attitudes.begin(), attitudes.end(), time_ns,
                                        [](const Attitude& one, std::int64_t time) { return one.time_ns < time; });
    if (after != attitudes.end() && after->time_ns == time_ns) return *after;
    if (after == attitudes.end() || after == attitudes.begin()) return std::nullopt;
    const Attitude& before = *(after - 1);
    if (after->time_ns - before.time_ns > kNearAttitude_ns) return std::nullopt;
    const double share =
        static_cast<double>(time_ns - before.time_ns) / static_cast<double>(after->time_ns - before.time_ns);
    return Attitude{time_ns, before.enu_from_ins.slerp(share, after->enu_from_ins), after->sigma_rad};
  }

  Eigen::Vector3d sigma_enu_m(const Fix& fix) const {
    if (const auto error = errors_.find(fix.time_ns); error != errors_.end())
      return {error->second.east_m, error->second.north_m, error->second.up_m};
    const double usual = usual_sigma_m(fix);
    return {usual, usual, 1.5 * usual};
  }

  /// Of headings alone where the log has nothing better.
  std::vector<Attitude> attitudes(std::vector<Finding>& findings) const {
    std::vector<Attitude> attitudes = attitudes_;
    std::stable_sort(attitudes.begin(), attitudes.end(),
                     [](const Attitude& a, const Attitude& b) { return a.time_ns < b.time_ns; });
    if (!attitudes.empty()) return attitudes;
    const HeadingTimes times = places_.times();
    attitudes.reserve(times.headings.size());
    for (const TimedHeading& one : times.headings)
      attitudes.push_back({one.time_ns,
                           enu_from_ins({one.heading_rad, 0.0, 0.0}, AttitudeConvention::Heading),
                           {kUnknownTilt_rad, kUnknownTilt_rad, degrees_to_radians(0.5)}});
    if (times.order == HeadingOrder::Unknown)
      findings.push_back(make_finding(Severity::Warning, "heading-order", path_.string(),
                                      "The log does not show whether a heading (HDT) stands before or behind the "
                                      "position of its time: it is taken to stand behind. Otherwise headings "
                                      "come one position too early."));
    return attitudes;
  }

  NmeaLog assembled(std::vector<Finding>& findings) {
    NmeaLog log;
    const std::vector<Attitude> attitudes = this->attitudes(findings);
    log.fixes.reserve(fixes_.size());
    if (!attitudes.empty()) log.ins.reserve(fixes_.size());
    for (const Fix& fix : fixes_) {
      const Eigen::Vector3d sigma = sigma_enu_m(fix);
      const std::int64_t stamp_ns = *midnight_ns_ + fix.time_ns;
      log.fixes.push_back({stamp_ns, fix.latitude_rad, fix.longitude_rad, fix.height_m,
                           Eigen::Matrix3d(sigma.cwiseAbs2().asDiagonal())});
      if (const auto attitude = attitude_at(attitudes, fix.time_ns))
        log.ins.push_back({stamp_ns,
                           fix.latitude_rad,
                           fix.longitude_rad,
                           fix.height_m,
                           attitude->enu_from_ins,
                           {sigma, attitude->sigma_rad},
                           fix.quality == 4 ? InsQuality::Good : InsQuality::Degraded});
    }
    tell(log, findings);
    tell_missing(log, attitudes, findings);
    keep_ascending(log.fixes, "gnss", path_.string(), findings);
    std::vector<Finding> told_already;
    keep_ascending(log.ins, "ins", path_.string(), told_already);
    return log;
  }

  void tell(const NmeaLog& log, std::vector<Finding>& findings) const {
    if (errors_.empty())
      findings.push_back(make_finding(Severity::Note, "gnss-sigma-assumed", path_.string(),
                                      "The log does not state errors (GST): what the quality of a fix usually means is "
                                      "assumed."));
    if (without_geoid_ > 0)
      findings.push_back(make_finding(Severity::Note, "height-above-sea", path_.string(),
                                      "Heights are above sea level, for the log does not give the geoid's."));
    if (attitudes_.empty() && !log.ins.empty())
      findings.push_back(make_finding(Severity::Warning, "heading-alone", path_.string(),
                                      "The log has a heading (HDT) and no roll and pitch: they are taken to be zero, "
                                      "good to some degrees."));
  }

  /// Positions between the first attitude and the last that got none; all where there is no INS.
  void tell_missing(const NmeaLog& log, const std::vector<Attitude>& attitudes, std::vector<Finding>& findings) const {
    if (attitudes.empty()) return;
    const auto missing = static_cast<std::size_t>(std::count_if(fixes_.begin(), fixes_.end(), [&](const Fix& fix) {
      const bool within = fix.time_ns >= attitudes.front().time_ns && fix.time_ns <= attitudes.back().time_ns;
      return (within || log.ins.empty()) && !attitude_at(attitudes, fix.time_ns);
    }));
    if (missing == 0) return;
    std::vector<std::int64_t> steps_ns{0};
    for (std::size_t i = 1; i < attitudes.size(); ++i)
      steps_ns.push_back(attitudes[i].time_ns - attitudes[i - 1].time_ns);
    char longest_s[32];
    std::snprintf(longest_s, sizeof longest_s, "%.2f",
                  1e-9 * static_cast<double>(*std::max_element(steps_ns.begin(), steps_ns.end())));
    findings.push_back(
        make_finding(Severity::Warning, "attitude-sparse", path_.string(),
                     std::to_string(missing) + " of " + std::to_string(fixes_.size()) +
                         " positions have no attitude near them and are left out of the INS: the log has " +
                         std::to_string(attitudes.size()) + " attitudes, up to " + longest_s +
                         " s apart, and none is interpolated over more than 0.25 s."));
  }

  const fs::path& path_;
  BadItems bad_;
  std::vector<Fix> fixes_;
  std::vector<Attitude> attitudes_;
  HeadingPlaces places_;  ///< of headings
  std::map<std::int64_t, Stated> errors_;
  std::optional<std::int64_t> midnight_ns_;  ///< of the first day
  std::int64_t days_ = 0, last_ns_ = -1;
  std::size_t without_geoid_ = 0;
  bool timed_ = false;  ///< the sentence that is taken has a time
};

}  // namespace

bool recognise_nmea(const fs::path& path) {
  try {
    const std::string head = read_file_head(path, 16 * 1024);
    LineReader lines(head);
    std::size_t known = 0, other = 0;
    for (std::string_view line; lines.next(line) && known + other < 40;) {
      NmeaSentence sentence;
      if (trimmed(line).empty()) continue;
      const bool is_one =
          parse_nmea(line, sentence) == NmeaLine::Sentence && (sentence.type.size() == 3 || sentence.type == "PASHR");
      ++(is_one ? known : other);
    }
    return known > 0 && known >= 3 * other;
  } catch (const Error&) {
    return false;
  }
}

NmeaLog read_nmea(const fs::path& path, std::vector<Finding>& findings) { return NmeaReader(path).read(findings); }

}  // namespace remount
