#include "model/formats/ins/sbet_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "algorithms/core/error.h"
#include "algorithms/geometry/rotation.h"
#include "messages/ins_logs.h"
#include "model/drive/bad_items.h"
#include "model/drive/plausible_values.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/number_bytes.h"
#include "model/formats/files/number_text.h"
#include "model/formats/files/running_period.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/ins/novatel_values.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kSbetBytes = 17 * sizeof(double), kSmrmsgBytes = 10 * sizeof(double);
/// So many records at the beginning of a file say what it is.
constexpr std::size_t kToldRecords = 8, kLeastRecords = 2;
constexpr double kWeek_s = 604'800.0, kShortestStep_s = 1e-6;
constexpr double kLargestError_m = 1e5, kLargestError_arcmin = 180.0 * 60.0;

template <std::size_t count>
std::array<double, count> doubles_at(std::string_view bytes, std::size_t at) {
  std::array<double, count> values{};
  for (std::size_t i = 0; i < count; ++i) values[i] = little_number<double>(bytes, at + i * sizeof(double));
  return values;
}

/// The first numbers of a record; behind them stand accelerations and rates.
struct SbetRecord {
  double time_s, latitude_rad, longitude_rad, height_m, roll_rad, pitch_rad, platform_heading_rad, wander_rad;

  static SbetRecord at(std::string_view bytes, std::size_t place) {
    const auto v = doubles_at<11>(bytes, place);  // v[4] to v[6]: the velocity
    return {v[0], v[1], v[2], v[3], v[7], v[8], v[9], v[10]};
  }
  bool has_place() const {
    return drive::plausible_geodetic(latitude_rad, longitude_rad, height_m) &&
           (latitude_rad != 0.0 || longitude_rad != 0.0);
  }
  bool has_attitude() const {
    return std::abs(roll_rad) <= 2.0 * kPi && std::abs(pitch_rad) <= kPi / 2.0 + 1e-9 &&
           std::abs(platform_heading_rad) <= 4.0 * kPi && std::abs(wander_rad) <= 4.0 * kPi;
  }
};

struct SmrmsgRecord {
  double time_s;
  std::array<double, 3> position_ned_m, roll_pitch_heading_arcmin;

  static SmrmsgRecord at(std::string_view bytes, std::size_t place) {
    const auto v = doubles_at<10>(bytes, place);  // v[4] to v[6]: of the velocity
    return {v[0], {v[1], v[2], v[3]}, {v[7], v[8], v[9]}};
  }
  bool is_possible() const {
    const auto within = [](double most) { return [most](double value) { return value >= 0.0 && value <= most; }; };
    return std::ranges::all_of(position_ned_m, within(kLargestError_m)) &&
           std::ranges::all_of(roll_pitch_heading_arcmin, within(kLargestError_arcmin));
  }
  motion::InsSigma sigma() const {
    const auto rad = [&](std::size_t i) { return degrees_to_radians(roll_pitch_heading_arcmin[i] / 60.0); };
    motion::InsSigma sigma;
    sigma.position_enu_m = {position_ned_m[1], position_ned_m[0], position_ned_m[2]};
    sigma.attitude_rad = drive::axis_sigma_rad({rad(2), rad(1), rad(0)}, drive::AttitudeConvention::Heading);
    return sigma;
  }
};

/// Taken for doubles, digits are so close to 0 that all of them are possible.
bool is_text(std::string_view bytes) {
  return std::ranges::all_of(bytes, [](char c) { return (c >= ' ' && c <= '~') || (c >= '\t' && c <= '\r'); });
}

/// Whether the first records have times that ascend, a little each, and are what they should be.
template <class Record, class Possible>
bool begins_with(const fs::path& path, std::size_t record_bytes, double longest_step_s, Possible&& possible) {
  try {
    const std::string head = read_file_head(path, kToldRecords * record_bytes);
    if (head.size() < kLeastRecords * record_bytes || is_text(head)) return false;
    double before_s = 0.0;
    for (std::size_t at = 0; at + record_bytes <= head.size(); at += record_bytes) {
      const Record record = Record::at(head, at);
      if (!possible(record) || !(record.time_s >= 0.0 && record.time_s < 1e10)) return false;
      const double step_s = record.time_s - before_s;
      if (at > 0 && !(step_s >= kShortestStep_s && step_s <= longest_step_s) && !(step_s < -0.5 * kWeek_s))
        return false;
      before_s = record.time_s;
    }
    return true;
  } catch (const Error&) {
    return false;  // not readable: not recognised
  }
}

/// In week 0.
std::int64_t stamp_ns(RunningPeriod& weeks, double time_s, const std::string& where) {
  if (!(time_s >= 0.0 && time_s * 1e9 <= static_cast<double>(kLatestInWeek_ns)))
    throw Error(ErrorCode::Format, where, say::sbet_time(exact_text(time_s)));
  const auto running_ns = weeks.running_ns(std::llround(time_s * 1e9));
  if (!running_ns) throw Error(ErrorCode::Format, where, say::log_time_jumps(exact_text(time_s)));
  return unix_ns_from_gps_ns(*running_ns);
}

motion::InsSample sample_of(const SbetRecord& record, const std::string& where) {
  if (!record.has_place()) throw Error(ErrorCode::Format, where, say::log_place_impossible());
  if (!record.has_attitude()) throw Error(ErrorCode::Format, where, say::log_angles_impossible());
  motion::InsSample sample;
  sample.latitude_rad = record.latitude_rad;
  sample.longitude_rad = record.longitude_rad;
  sample.height_m = record.height_m;
  sample.enu_from_ins =
      drive::enu_from_ins({record.platform_heading_rad - record.wander_rad, record.pitch_rad, record.roll_rad},
                          drive::AttitudeConvention::Heading);
  return sample;
}

std::string record_place(const fs::path& path, std::size_t at) {
  return path.string() + ", byte " + std::to_string(at);
}

/// What is behind the last whole record was cut off.
void tell_cut(std::size_t bytes, std::size_t record_bytes, const fs::path& path,
              std::vector<drive::Finding>& findings) {
  if (bytes % record_bytes == 0) return;
  findings.push_back(drive::make_finding(drive::Severity::Warning, "log-cut",
                                         record_place(path, bytes - bytes % record_bytes),
                                         say::ins_log_cut(Bytes{record_bytes}, Bytes{bytes % record_bytes})));
}

std::vector<StampedSigma> read_smrmsg(const fs::path& path, std::vector<drive::Finding>& findings) {
  const std::string bytes = read_regular_file(path);
  std::vector<StampedSigma> errors;
  errors.reserve(bytes.size() / kSmrmsgBytes);
  drive::BadItems bad;
  RunningPeriod weeks = count_weeks();
  for (std::size_t at = 0; at + kSmrmsgBytes <= bytes.size(); at += kSmrmsgBytes) try {
      const SmrmsgRecord record = SmrmsgRecord::at(bytes, at);
      if (!record.is_possible()) throw Error(ErrorCode::Format, record_place(path, at), say::smrmsg_no_errors());
      errors.push_back({stamp_ns(weeks, record.time_s, record_place(path, at)), record.sigma()});
    } catch (const Error& error) {
      bad.add(error);
    }
  bad.report(findings, "bad-ins", path.string(), say::left_out_records);
  tell_cut(bytes.size(), kSmrmsgBytes, path, findings);
  std::erase_if(errors, [](const StampedSigma& stated) { return !states_any(stated.sigma); });
  std::ranges::stable_sort(errors, {}, &StampedSigma::stamp_ns);
  return errors;
}

/// A name in small letters without the word for what the file is: "sbet_Mission 1.out" and "smrmsg_Mission 1.out" are
/// of one drive.
std::string name_beside(const fs::path& path, std::string_view word) {
  std::string name = lower_case(path.stem().string());
  if (const std::size_t at = name.find(word); at != std::string::npos) name.erase(at, word.size());
  return name;
}

/// The errors of a trajectory; nothing where there are none, or nobody knows which.
std::optional<fs::path> smrmsg_beside(const fs::path& sbet) {
  std::vector<fs::path> found;
  for (const fs::path& file : files_in(sbet.parent_path().empty() ? fs::path(".") : sbet.parent_path()))
    if (recognise_smrmsg(file)) found.push_back(file);
  if (found.size() > 1)
    std::erase_if(found,
                  [&](const fs::path& file) { return name_beside(file, "smrmsg") != name_beside(sbet, "sbet"); });
  return found.size() == 1 ? std::optional(found.front()) : std::nullopt;
}

void take_errors(InsLog& log, std::vector<drive::Finding>& findings) {
  const fs::path sbet = log.files.front();
  const std::optional<fs::path> file = smrmsg_beside(sbet);
  const auto tell = [&](Message words) {
    findings.push_back(drive::make_finding(drive::Severity::Note, "ins-log-chosen", sbet.string(), std::move(words)));
  };
  if (!file) return tell(say::sbet_without_errors());
  log.files.push_back(*file);
  const std::size_t without = give_errors(log.ins, read_smrmsg(*file, findings));
  tell(say::sbet_errors_of(file->filename().string(), log.ins.size() - without, log.ins.size()));
}

}  // namespace

bool recognise_sbet(const fs::path& path) {
  constexpr double kLongestStep_s = 10.0;
  return begins_with<SbetRecord>(path, kSbetBytes, kLongestStep_s,
                                 [](const SbetRecord& record) { return record.has_place() && record.has_attitude(); });
}

bool recognise_smrmsg(const fs::path& path) {
  constexpr double kLongestStep_s = 100.0;
  return begins_with<SmrmsgRecord>(path, kSmrmsgBytes, kLongestStep_s,
                                   [](const SmrmsgRecord& record) { return record.is_possible(); });
}

InsLog read_sbet(const fs::path& path, std::vector<drive::Finding>& findings) {
  InsLog log;
  log.stamps_from_gps = log.week_open = true;
  log.files = {path};
  {
    const std::string bytes = read_regular_file(path);
    log.ins.reserve(bytes.size() / kSbetBytes);
    drive::BadItems bad;
    RunningPeriod weeks = count_weeks();
    for (std::size_t at = 0; at + kSbetBytes <= bytes.size(); at += kSbetBytes) try {
        const SbetRecord record = SbetRecord::at(bytes, at);
        motion::InsSample sample = sample_of(record, record_place(path, at));
        sample.stamp_ns = stamp_ns(weeks, record.time_s, record_place(path, at));
        log.ins.push_back(sample);
      } catch (const Error& error) {
        bad.add(error);
      }
    if (log.ins.empty()) throw Error(ErrorCode::Format, path.string(), bad.after(say::ins_none_usable()));
    bad.report(findings, "bad-ins", path.string(), say::left_out_records);
    tell_cut(bytes.size(), kSbetBytes, path, findings);
  }
  drive::keep_near(log.ins, path.string(), findings);
  drive::keep_ascending(log.ins, "ins", path.string(), findings);
  take_errors(log, findings);
  return log;
}

}  // namespace remount::formats
