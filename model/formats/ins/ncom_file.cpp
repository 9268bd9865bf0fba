#include "model/formats/ins/ncom_file.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "algorithms/core/error.h"
#include "algorithms/geometry/rotation.h"
#include "messages/ins_logs.h"
#include "messages/sessions.h"
#include "model/drive/bad_items.h"
#include "model/drive/plausible_values.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/number_bytes.h"
#include "model/formats/files/time_stamp.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

// Places in a packet, and units.
constexpr std::size_t kNcomTime = 1, kNcomStatus = 21, kNcomLatitude = 23, kNcomLongitude = 31, kNcomHeight = 39,
                      kNcomHeading = 52, kNcomPitch = 55, kNcomRoll = 58, kNcomChannel = 62, kNcomChannelBytes = 63;
constexpr double kNcomAngle_rad = 1e-6, kNcomErrorAngle_rad = 1e-5, kNcomError_m = 1e-3;
constexpr int kNotThere = -8'388'608;  // of 24 bits
constexpr int kInitialising = 2, kLocking = 3, kLocked = 4;
constexpr std::size_t kNcomHeadBytes = 64 * 1024;

int signed_24(std::string_view bytes, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<int>(static_cast<unsigned char>(bytes[at + i])); };
  const int value = byte(0) | byte(1) << 8 | byte(2) << 16;
  return value >= 8'388'608 ? value - 16'777'216 : value;
}

motion::InsQuality ncom_quality(int status) {
  return status == kLocked    ? motion::InsQuality::Good
         : status == kLocking ? motion::InsQuality::Degraded
                              : motion::InsQuality::Invalid;
}

/// Gives the packets their minutes. Between two packets that tell the minute and do not agree something is missing, and
/// nobody knows where: samples between them have no time.
class NcomMinutes {
 public:
  /// Of each packet with a solution, in their order.
  void add(const NcomPacket& packet) {
    if (last_ms_ && packet.millisecond < *last_ms_ - kHalfMinute_ms) ++relative_;
    last_ms_ = packet.millisecond;
    const auto minutes = ncom_minutes(packet);
    if (!minutes) return;
    const std::int64_t ahead = *minutes - relative_;
    agrees_ = !ahead_ || ahead == *ahead_;
    ahead_ = ahead;
    told_ = true;
  }
  bool just_told() { return std::exchange(told_, false); }
  bool agrees() const { return agrees_; }
  bool known() const { return ahead_.has_value(); }
  std::int64_t relative() const { return relative_; }
  std::int64_t ahead() const { return ahead_.value_or(0); }

 private:
  static constexpr int kHalfMinute_ms = 30'000;
  std::optional<int> last_ms_;
  std::optional<std::int64_t> ahead_;
  std::int64_t relative_ = 0;
  bool agrees_ = true, told_ = false;
};

class NcomCollector {
 public:
  explicit NcomCollector(const fs::path& path) : path_(path) {}

  void read(std::string_view bytes) {
    ins.reserve(bytes.size() / kNcomPacketBytes);
    for (std::size_t at = 0; at < bytes.size();) {
      const auto packet = ncom_packet(bytes, at);
      if (!packet) {
        const std::size_t next = std::min(bytes.find('\xe7', at + 1), bytes.size());
        stray_bytes += next - at;
        at = next;
        continue;
      }
      take(*packet, at);
      at += kNcomPacketBytes;
    }
    settle(ins.size(), minutes_.ahead());
  }

  std::vector<motion::InsSample> ins;
  std::size_t stray_bytes = 0, without_solution = 0, untimed = 0;
  drive::BadItems bad;
  bool minutes_known() const { return minutes_.known(); }

 private:
  void take(const NcomPacket& packet, std::size_t at) {
    errors_.take(packet);
    if (!has_solution(packet)) {
      ++without_solution;
      return;
    }
    minutes_.add(packet);
    const bool told = minutes_.just_told();
    if (told && !minutes_.agrees()) {
      untimed += ins.size() - settled_;
      ins.resize(settled_);
    }
    add(packet, at);
    if (told) settle(ins.size(), minutes_.ahead());
  }

  void add(const NcomPacket& packet, std::size_t at) {
    try {
      motion::InsSample sample = ncom_sample(packet, errors_.sigma(), path_.string() + ", byte " + std::to_string(at));
      sample.stamp_ns = minutes_.relative() * 60'000 + packet.millisecond;  // until its minute is known
      ins.push_back(sample);
    } catch (const Error& error) {
      if (packet.navigation == kInitialising)
        ++without_solution;  // it has none yet
      else
        bad.add(error);
    }
  }

  /// Times of samples up to `end`, `ahead` minutes after 6 January 1980.
  void settle(std::size_t end, std::int64_t ahead) {
    for (; settled_ < end; ++settled_)
      ins[settled_].stamp_ns = unix_ns_from_gps_ns((ins[settled_].stamp_ns + ahead * 60'000) * 1'000'000);
  }

  const fs::path& path_;
  NcomErrors errors_;
  NcomMinutes minutes_;
  std::size_t settled_ = 0;
};

}  // namespace

std::optional<NcomPacket> ncom_packet(std::string_view bytes, std::size_t at) {
  if (at >= bytes.size() || bytes.size() - at < kNcomPacketBytes || bytes[at] != '\xe7') return std::nullopt;
  const std::string_view packet = bytes.substr(at, kNcomPacketBytes);
  unsigned sum = 0;
  for (std::size_t i = 1; i + 1 < kNcomPacketBytes; ++i) sum += static_cast<unsigned char>(packet[i]);
  if ((sum & 0xffU) != static_cast<unsigned char>(packet.back())) return std::nullopt;
  NcomPacket out;
  out.navigation = static_cast<unsigned char>(packet[kNcomStatus]);
  out.millisecond = little_number<std::uint16_t>(packet, kNcomTime);
  out.latitude_rad = little_number<double>(packet, kNcomLatitude);
  out.longitude_rad = little_number<double>(packet, kNcomLongitude);
  out.height_m = static_cast<double>(little_number<float>(packet, kNcomHeight));
  const auto angle = [&](std::size_t place) {
    const int value = signed_24(packet, place);
    return value == kNotThere ? std::nan("") : value * kNcomAngle_rad;
  };
  out.heading_rad = angle(kNcomHeading), out.pitch_rad = angle(kNcomPitch), out.roll_rad = angle(kNcomRoll);
  out.channel = static_cast<unsigned char>(packet[kNcomChannel]);
  out.channel_bytes = packet.substr(kNcomChannelBytes, 8);
  return out;
}

bool has_solution(const NcomPacket& packet) {
  return packet.navigation >= kInitialising && packet.navigation <= kLocked;
}

std::optional<std::int64_t> ncom_minutes(const NcomPacket& packet) {
  constexpr int kSecond_ms = 1'000, kMinute_ms = 60'000;
  constexpr std::int64_t kLatest = std::int64_t{5'000} * 10'080;  // weeks
  if (packet.channel != 0 || !has_solution(packet) || packet.millisecond < kSecond_ms ||
      packet.millisecond > kMinute_ms - kSecond_ms)
    return std::nullopt;
  const std::int64_t minutes = little_number<std::int32_t>(packet.channel_bytes, 0);
  return minutes > 0 && minutes < kLatest ? std::optional(minutes) : std::nullopt;
}

void NcomErrors::take(const NcomPacket& packet) {
  constexpr unsigned char kTooOld = 150;
  if (packet.channel != 3 && packet.channel != 5) return;
  const bool known = static_cast<unsigned char>(packet.channel_bytes[6]) < kTooOld;
  const auto stated = [&](std::size_t at, double unit) {
    const auto value = little_number<std::uint16_t>(packet.channel_bytes, at);
    return known && value > 0 ? value * unit : std::nan("");
  };
  if (packet.channel == 3)  // north, east, down
    sigma_.position_enu_m = {stated(2, kNcomError_m), stated(0, kNcomError_m), stated(4, kNcomError_m)};
  else  // heading, pitch, roll
    sigma_.attitude_rad = drive::axis_sigma_rad(
        {stated(0, kNcomErrorAngle_rad), stated(2, kNcomErrorAngle_rad), stated(4, kNcomErrorAngle_rad)},
        drive::AttitudeConvention::Heading);
}

motion::InsSample ncom_sample(const NcomPacket& packet, const motion::InsSigma& sigma, const std::string& where) {
  constexpr int kMinute_ms = 60'000;
  if (packet.millisecond >= kMinute_ms) throw Error(ErrorCode::Format, where, say::ncom_no_time());
  if (!drive::plausible_geodetic(packet.latitude_rad, packet.longitude_rad, packet.height_m))
    throw Error(ErrorCode::Format, where, say::log_place_impossible());
  if (!std::isfinite(packet.heading_rad + packet.pitch_rad + packet.roll_rad))
    throw Error(ErrorCode::Format, where, say::ncom_no_attitude());
  motion::InsSample sample;
  sample.latitude_rad = packet.latitude_rad;
  sample.longitude_rad = packet.longitude_rad;
  sample.height_m = packet.height_m;
  sample.enu_from_ins =
      drive::enu_from_ins({packet.heading_rad, packet.pitch_rad, packet.roll_rad}, drive::AttitudeConvention::Heading);
  sample.sigma = sigma;
  sample.quality = ncom_quality(packet.navigation);
  return sample;
}

bool recognise_ncom(const fs::path& path) {
  try {
    const std::string head = read_file_head(path, kNcomHeadBytes);
    for (std::size_t at = head.find('\xe7'); at != std::string::npos; at = head.find('\xe7', at + 1)) {
      if (at > kNcomHeadBytes / 8) return false;
      if (ncom_packet(head, at) && ncom_packet(head, at + kNcomPacketBytes)) return true;
    }
  } catch (const Error&) {
    // not readable: not recognised
  }
  return false;
}

InsLog read_ncom(const fs::path& path, std::vector<drive::Finding>& findings) {
  InsLog log;
  log.stamps_from_gps = true;
  log.files = {path};
  const std::string bytes = read_regular_file(path);
  NcomCollector collector(path);
  collector.read(bytes);
  if (!collector.ins.empty() && !collector.minutes_known())
    throw Error(ErrorCode::Format, path.string(), say::ncom_no_minutes());
  if (collector.ins.empty())
    throw Error(ErrorCode::Format, path.string(),
                collector.bad.after(say::ncom_none_usable(collector.without_solution)));
  log.ins = std::move(collector.ins);
  collector.bad.report(findings, "bad-ins", path.string(), say::left_out_records);
  std::vector<Message> told;
  if (collector.without_solution > 0) told.push_back(say::ncom_without_solution(collector.without_solution));
  if (collector.untimed > 0) told.push_back(say::ncom_untimed(collector.untimed));
  if (collector.stray_bytes > 0) told.push_back(say::ncom_stray(Bytes{collector.stray_bytes}));
  if (!told.empty())
    findings.push_back(drive::make_finding(drive::Severity::Note, "ins-log-chosen", path.string(),
                                           Message::sequence(std::move(told))));
  drive::keep_near(log.ins, path.string(), findings);
  drive::keep_ascending(log.ins, "ins", path.string(), findings);
  return log;
}

}  // namespace remount::formats
