#include "model/formats/ins/novatel_bodies.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>

#include "algorithms/core/error.h"
#include "messages/files.h"
#include "messages/ins_logs.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/number_bytes.h"
#include "model/formats/files/time_stamp.h"

namespace remount::formats {
namespace {

enum class BinaryNumber { Double, Float };

/// Where a value stands: its field in ASCII, its first byte in binary, both counted from the beginning of the body.
struct BodyValue {
  double NovatelValues::*value;
  Message (*what)();
  std::size_t field, byte;
  BinaryNumber number = BinaryNumber::Double;
};

// OEM7 Commands and Logs Reference Manual: INSPVAX, INSPVA, INSSTDEV and BESTPOS.
constexpr BodyValue kInspvaxBody[] = {{&NovatelValues::latitude_deg, say::log_latitude, 2, 8},
                                      {&NovatelValues::longitude_deg, say::log_longitude, 3, 16},
                                      {&NovatelValues::height_m, say::log_height, 4, 24},
                                      {&NovatelValues::undulation_m, say::log_undulation, 5, 32, BinaryNumber::Float},
                                      {&NovatelValues::roll_deg, say::log_roll, 9, 60},
                                      {&NovatelValues::pitch_deg, say::log_pitch, 10, 68},
                                      {&NovatelValues::azimuth_deg, say::log_azimuth, 11, 76},
                                      {&NovatelValues::latitude_std_m, say::log_error, 12, 84, BinaryNumber::Float},
                                      {&NovatelValues::longitude_std_m, say::log_error, 13, 88, BinaryNumber::Float},
                                      {&NovatelValues::height_std_m, say::log_error, 14, 92, BinaryNumber::Float},
                                      {&NovatelValues::roll_std_deg, say::log_error, 18, 108, BinaryNumber::Float},
                                      {&NovatelValues::pitch_std_deg, say::log_error, 19, 112, BinaryNumber::Float},
                                      {&NovatelValues::azimuth_std_deg, say::log_error, 20, 116, BinaryNumber::Float}};
constexpr BodyValue kInspvaBody[] = {{&NovatelValues::latitude_deg, say::log_latitude, 2, 12},
                                     {&NovatelValues::longitude_deg, say::log_longitude, 3, 20},
                                     {&NovatelValues::height_m, say::log_height, 4, 28},
                                     {&NovatelValues::roll_deg, say::log_roll, 8, 60},
                                     {&NovatelValues::pitch_deg, say::log_pitch, 9, 68},
                                     {&NovatelValues::azimuth_deg, say::log_azimuth, 10, 76}};
constexpr BodyValue kInsstdevBody[] = {{&NovatelValues::latitude_std_m, say::log_error, 0, 0, BinaryNumber::Float},
                                       {&NovatelValues::longitude_std_m, say::log_error, 1, 4, BinaryNumber::Float},
                                       {&NovatelValues::height_std_m, say::log_error, 2, 8, BinaryNumber::Float},
                                       {&NovatelValues::roll_std_deg, say::log_error, 6, 24, BinaryNumber::Float},
                                       {&NovatelValues::pitch_std_deg, say::log_error, 7, 28, BinaryNumber::Float},
                                       {&NovatelValues::azimuth_std_deg, say::log_error, 8, 32, BinaryNumber::Float}};
constexpr BodyValue kBestposBody[] = {{&NovatelValues::latitude_deg, say::log_latitude, 2, 8},
                                      {&NovatelValues::longitude_deg, say::log_longitude, 3, 16},
                                      {&NovatelValues::height_m, say::log_height, 4, 24},
                                      {&NovatelValues::undulation_m, say::log_undulation, 5, 32, BinaryNumber::Float},
                                      {&NovatelValues::latitude_std_m, say::log_error, 7, 40, BinaryNumber::Float},
                                      {&NovatelValues::longitude_std_m, say::log_error, 8, 44, BinaryNumber::Float},
                                      {&NovatelValues::height_std_m, say::log_error, 9, 48, BinaryNumber::Float}};

/// A body, and how long it is at least.
struct BodyLayout {
  std::span<const BodyValue> values;
  std::size_t fields, bytes;
};
constexpr BodyLayout kInspvaxLayout{kInspvaxBody, 23, 126}, kInspvaLayout{kInspvaBody, 12, 88},
    kInsstdevLayout{kInsstdevBody, 9, 52}, kBestposLayout{kBestposBody, 10, 72};

/// Behind the time there is a word of status, then counts in this order: speeds along z, -y, x, turns about z, -y, x.
constexpr std::size_t kRawImuBytes = 40, kRawImuCountsAt = 16, kRawImuCounts = 6, kRawImuFields = 9;

/// Above the ellipsoid: nearer to the centre of the earth than to its surface.
constexpr double kNoHeight_m = -3e6;

/// Little-endian; the length of the body has been checked.
template <class T>
T body_number(const NovatelFrame& frame, std::size_t byte) {
  return little_number<T>(frame.body, byte);
}

[[noreturn]] void fail_log(const std::string& where, Message what) {
  throw Error(ErrorCode::Format, where, std::move(what));
}

double number_of(const BodyValue& value, const NovatelFrame& frame, const std::vector<std::string_view>& fields,
                 const std::string& where) {
  if (frame.binary)
    return value.number == BinaryNumber::Float ? double{body_number<float>(frame, value.byte)}
                                               : body_number<double>(frame, value.byte);
  const std::string_view text = fields[value.field];
  if (const auto number = parse_number(text)) return *number;
  fail_log(where, say::file_no_finite_number(value.what(), std::string(text.substr(0, 20))));
}

/// @param fields become those of an ASCII body
NovatelValues body_values(const NovatelFrame& frame, const BodyLayout& layout, std::vector<std::string_view>& fields,
                          const std::string& where) {
  if (!frame.binary) split_csv(frame.body, fields);
  if (frame.binary && frame.body.size() < layout.bytes)
    fail_log(where, say::novatel_body_bytes(Bytes{frame.body.size()}, Bytes{layout.bytes}));
  if (!frame.binary && fields.size() < layout.fields)
    fail_log(where, say::inspvax_data_fields(fields.size(), layout.fields));
  NovatelValues values;
  for (const BodyValue& value : layout.values) values.*value.value = number_of(value, frame, fields, where);
  return values;
}

std::int64_t require_gps_time(std::optional<std::int64_t> stamp_ns, std::string_view week, std::string_view time,
                              const std::string& where) {
  if (stamp_ns) return *stamp_ns;
  fail_log(where, say::inspvax_no_gps_time(std::string(week.substr(0, 20)), std::string(time.substr(0, 20))));
}

std::int64_t text_stamp_ns(std::string_view week_text, std::string_view seconds_text, const std::string& where) {
  const auto week = parse_integer(week_text);
  const auto time_ns = parse_seconds_ns(seconds_text);
  return require_gps_time(week && time_ns ? unix_ns_from_gps_week(*week, *time_ns) : std::nullopt, week_text,
                          seconds_text, where);
}

std::uint32_t hex_number(std::string_view text, const std::string& where) {
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, 16);
  if (error != std::errc() || end != text.data() + text.size())
    fail_log(where, say::file_no_finite_number(say::log_imu_info(), std::string(text.substr(0, 20))));
  return number;
}

double count_of(std::string_view text, const std::string& where) {
  const auto count = parse_integer(text);
  constexpr std::int64_t kMost = std::int64_t{1} << 31;
  if (!count || *count < -kMost || *count > kMost)
    fail_log(where, say::file_no_finite_number(say::log_imu_count(), std::string(text.substr(0, 20))));
  return static_cast<double>(*count);
}

template <class T>
T header_number(const NovatelFrame& frame, std::size_t byte) {
  return little_number<T>(frame.header, byte);
}

}  // namespace

std::string NovatelBodies::word(const NovatelFrame& frame, std::size_t field, std::size_t byte) const {
  return frame.binary ? std::to_string(body_number<std::uint32_t>(frame, byte)) : std::string(fields_[field]);
}

std::int64_t NovatelBodies::header_stamp_ns(const NovatelFrame& frame, const std::string& where) {
  if (frame.binary) {
    const auto week = header_number<std::uint16_t>(frame, frame.short_header ? 6 : 14);
    const auto time_ms = header_number<std::uint32_t>(frame, frame.short_header ? 8 : 16);
    return require_gps_time(unix_ns_from_gps_week(week, std::int64_t{time_ms} * 1'000'000), std::to_string(week),
                            std::to_string(time_ms) + " ms", where);
  }
  std::vector<std::string_view> fields;
  split_csv(frame.header, fields);
  const std::size_t week_at = frame.short_header ? 1 : 5;
  if (fields.size() < week_at + 2) fail_log(where, say::inspvax_short_header());
  return text_stamp_ns(fields[week_at], fields[week_at + 1], where);
}

std::int64_t NovatelBodies::body_stamp_ns(const NovatelFrame& frame, const std::string& where, std::size_t field) {
  if (!frame.binary) return text_stamp_ns(fields_[field], fields_[field + 1], where);
  // Behind two bytes of the IMU there are two for the week.
  const auto week = field == 0 ? body_number<std::uint32_t>(frame, 0) : body_number<std::uint16_t>(frame, 2);
  const auto seconds = body_number<double>(frame, 4);
  constexpr double kWeek_s = 604'800.0;
  const bool within = seconds >= 0.0 && seconds <= kWeek_s;
  return require_gps_time(within ? unix_ns_from_gps_week(week, std::llround(seconds * 1e9)) : std::nullopt,
                          std::to_string(week), std::to_string(seconds), where);
}

std::optional<NovatelSolution> NovatelBodies::solution(const NovatelFrame& frame, const std::string& where) {
  const bool with_errors = frame.type->use == NovatelUse::Inspvax;
  NovatelValues values = body_values(frame, with_errors ? kInspvaxLayout : kInspvaLayout, fields_, where);
  const std::string status = with_errors ? word(frame, 0, 0) : word(frame, 11, 84);
  values.quality = novatel_quality(status);
  if (values.quality == motion::InsQuality::Invalid && values.height_m < kNoHeight_m) return std::nullopt;
  const std::int64_t stamp_ns = with_errors ? header_stamp_ns(frame, where) : body_stamp_ns(frame, where);
  NovatelSolution solution{ins_sample(values, where), is_of_wrong_table(status)};
  solution.sample.stamp_ns = stamp_ns;
  return solution;
}

StampedSigma NovatelBodies::errors(const NovatelFrame& frame, const std::string& where) {
  const NovatelValues values = body_values(frame, kInsstdevLayout, fields_, where);
  return {header_stamp_ns(frame, where), ins_sigma(values)};
}

std::optional<motion::GnssFix> NovatelBodies::fix(const NovatelFrame& frame, const std::string& where) {
  const NovatelValues values = body_values(frame, kBestposLayout, fields_, where);
  const std::string status = word(frame, 0, 0), type = word(frame, 1, 4);
  if ((status != "0" && status != "SOL_COMPUTED") || type == "0" || type == "NONE") return std::nullopt;
  check_position(values, where);
  const Eigen::Vector3d sigma_m = ins_sigma(values).position_enu_m;
  if (!(sigma_m.minCoeff() > 0.0) || !sigma_m.allFinite()) fail_log(where, say::novatel_fix_without_errors());
  motion::GnssFix fix;
  fix.stamp_ns = header_stamp_ns(frame, where);
  fix.latitude_rad = degrees_to_radians(values.latitude_deg);
  fix.longitude_rad = degrees_to_radians(values.longitude_deg);
  fix.height_m = values.height_m + values.undulation_m;
  fix.covariance_enu_m2 = sigma_m.cwiseAbs2().asDiagonal();
  return fix;
}

std::optional<NovatelRawImu> NovatelBodies::raw_imu(const NovatelFrame& frame, const std::string& where) {
  const bool extended = frame.type->name == "RAWIMUX" || frame.type->name == "RAWIMUSX";
  const std::size_t time_field = extended ? 2 : 0, fields = kRawImuFields + time_field;
  if (!frame.binary) split_csv(frame.body, fields_);
  if (frame.binary && frame.body.size() < kRawImuBytes)
    fail_log(where, say::novatel_body_bytes(Bytes{frame.body.size()}, Bytes{kRawImuBytes}));
  if (!frame.binary && fields_.size() < fields) fail_log(where, say::inspvax_data_fields(fields_.size(), fields));
  NovatelRawImu imu;
  unsigned info = 0;  // 1: an error, 2: encrypted
  if (extended && frame.binary) {
    info = body_number<std::uint8_t>(frame, 0);
    imu.type = body_number<std::uint8_t>(frame, 1);
  } else if (extended) {
    info = hex_number(fields_[0], where);
    const auto type = parse_integer(fields_[1]);
    imu.type = type && *type > 0 && *type < 256 ? static_cast<int>(*type) : 0;
  }
  std::array<double, kRawImuCounts> counts{};
  for (std::size_t i = 0; i < kRawImuCounts; ++i)
    counts[i] = frame.binary ? static_cast<double>(body_number<std::int32_t>(frame, kRawImuCountsAt + 4 * i))
                             : count_of(fields_[time_field + 3 + i], where);
  imu.sample.stamp_ns = body_stamp_ns(frame, where, time_field);
  if ((info & 3U) != 0) return std::nullopt;
  // Right, forward, up in the log.
  imu.sample.specific_force_mps2 = {-counts[1], -counts[2], counts[0]};
  imu.sample.angular_rate_radps = {-counts[4], -counts[5], counts[3]};
  return imu;
}

}  // namespace remount::formats
