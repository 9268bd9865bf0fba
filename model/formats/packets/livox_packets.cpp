#include "model/formats/packets/livox_packets.h"

#include <limits>
#include <utility>

#include "model/formats/files/number_bytes.h"
#include "model/formats/packets/livox_points.h"
#include "model/formats/packets/packet_times.h"

namespace remount::formats {

namespace {

constexpr std::size_t kSdk1Head = 18, kSdk2Head = 36, kLvx2Head = 27, kLivoxImuBytes = 24;
constexpr std::uint8_t kSdk1Version = 5, kSdk1Imu = 6, kSdk2Imu = 0;
/// A scan is what the sensor sends in a tenth of a second: it has no turns.
constexpr std::int64_t kFrame_ns = 100'000'000, kPlace_ns = 1000;

struct LivoxTime {
  std::int64_t time_ns = 0;
  bool follows = false;     ///< the sensor says that its clock is set by another
  bool pulse_only = false;  ///< which tells it where seconds begin, but not which
};

std::optional<std::int64_t> counted_ns(std::string_view bytes, std::size_t at) {
  const auto time_ns = little_number<std::uint64_t>(bytes, at);
  constexpr auto kMost_ns = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max() / 2);
  return time_ns > kMost_ns ? std::nullopt : std::optional(static_cast<std::int64_t>(time_ns));
}

/// Year, month, day and hour in a byte each, and microseconds of the hour.
std::optional<std::int64_t> spelt_ns(std::string_view bytes, std::size_t at) {
  constexpr std::uint32_t kHour_us = 3'600'000'000;
  const auto past_us = little_number<std::uint32_t>(bytes, at + 4);
  const auto hour_ns =
      unix_ns({2000 + byte_at(bytes, at), byte_at(bytes, at + 1), byte_at(bytes, at + 2), byte_at(bytes, at + 3)});
  if (!hour_ns || past_us > kHour_us) return std::nullopt;
  return *hour_ns + std::int64_t{1000} * past_us;
}

std::optional<LivoxTime> time_of_sdk1(std::uint8_t type, std::string_view bytes, std::size_t at) {
  constexpr std::uint8_t kNone = 0, kPtp = 1, kReceiver = 3, kPulseOnly = 4;
  if (type == kReceiver) {
    const auto time_ns = spelt_ns(bytes, at);
    return time_ns ? std::optional(LivoxTime{*time_ns, true}) : std::nullopt;
  }
  if (type != kNone && type != kPtp && type != kPulseOnly) return std::nullopt;
  const auto time_ns = counted_ns(bytes, at);
  if (!time_ns) return std::nullopt;
  if (type == kPulseOnly) return LivoxTime{*time_ns, true, true};
  return LivoxTime{*time_ns, type == kPtp && has_date(*time_ns)};
}

std::optional<LivoxTime> time_of_sdk2(std::uint8_t type, std::string_view bytes, std::size_t at) {
  constexpr std::uint8_t kNone = 0;
  const auto time_ns = counted_ns(bytes, at);
  if (!time_ns) return std::nullopt;
  return LivoxTime{*time_ns, type != kNone && has_date(*time_ns)};
}

struct LivoxPacket {
  LivoxTime time;
  LivoxPointLayout layout;
  std::size_t shots = 0;
  std::string_view points;
  double shot_ns = 0.0;      ///< from one to the next; 0: the packet does not say
  std::uint16_t source = 0;  ///< of several sensors behind a hub
};

std::optional<LivoxPacket> read_sdk1(std::string_view bytes, bool floats) {
  if (bytes.size() < kSdk1Head || byte_at(bytes, 0) != kSdk1Version) return std::nullopt;
  const auto time = time_of_sdk1(byte_at(bytes, 8), bytes, 10);
  const auto layout = floats ? std::optional(kLivoxFloatPoints) : livox_layout_of_sdk1(byte_at(bytes, 9));
  if (!time || !layout) return std::nullopt;
  const std::size_t shots = livox_shots_of_sdk1(*layout);
  if (bytes.size() != kSdk1Head + shots * layout->bytes) return std::nullopt;
  return LivoxPacket{*time, *layout, shots, bytes.substr(kSdk1Head), 0.0, little_number<std::uint16_t>(bytes, 1)};
}

std::optional<LivoxPacket> read_sdk2(std::string_view bytes) {
  constexpr double kInterval_ns = 100.0;
  if (bytes.size() < kSdk2Head || byte_at(bytes, 0) != 0) return std::nullopt;
  if (little_number<std::uint16_t>(bytes, 1) != bytes.size()) return std::nullopt;
  const auto layout = livox_layout_of_sdk2(byte_at(bytes, 10));
  const std::size_t shots = little_number<std::uint16_t>(bytes, 5);
  if (!layout || shots == 0 || bytes.size() != kSdk2Head + shots * layout->bytes) return std::nullopt;
  const auto time = time_of_sdk2(byte_at(bytes, 11), bytes, 28);
  if (!time) return std::nullopt;
  const double taken_ns = kInterval_ns * little_number<std::uint16_t>(bytes, 3);
  return LivoxPacket{*time, *layout, shots, bytes.substr(kSdk2Head), taken_ns / static_cast<double>(shots), 0};
}

std::optional<LivoxPacket> read_lvx2(std::string_view bytes) {
  if (livox_packet_bytes(LivoxHead::Lvx2, bytes) != bytes.size()) return std::nullopt;
  const auto layout = livox_layout_of_sdk2(byte_at(bytes, 17));
  const auto time = time_of_sdk2(byte_at(bytes, 6), bytes, 7);
  if (!layout || !time) return std::nullopt;
  const std::string_view points = bytes.substr(kLvx2Head);
  if (points.empty() || points.size() % layout->bytes != 0) return std::nullopt;
  return LivoxPacket{*time, *layout, points.size() / layout->bytes, points, 0.0, 0};
}

std::optional<LivoxPacket> read_livox_packet(LivoxHead head, std::string_view bytes) {
  switch (head) {
    case LivoxHead::Sdk1:
    case LivoxHead::Lvx:
      return read_sdk1(bytes, head == LivoxHead::Lvx);
    case LivoxHead::Sdk2:
      return read_sdk2(bytes);
    case LivoxHead::Lvx2:
      return read_lvx2(bytes);
  }
  return std::nullopt;
}

/// Of one sensor: behind a hub are several, which packets tell apart by their numbers.
class LivoxDecoder final : public PacketDecoder {
 public:
  LivoxDecoder(LivoxHead head, std::string model, std::uint16_t source)
      : head_(head), model_(std::move(model)), source_(source) {}

  std::string model() const override { return model_; }
  std::uint32_t places() const override { return kFrame_ns / kPlace_ns; }

  std::optional<PacketGlance> glance(std::string_view payload) const override {
    const std::optional<LivoxPacket> packet = read_livox_packet(head_, payload);
    if (!packet || packet->source != source_) return std::nullopt;
    PacketGlance glance;
    glance.sensor_time_ns = packet->time.time_ns;
    glance.clock_follows = packet->time.follows;
    // It changes once the sensor has found a receiver.
    glance.clock_period_s = packet->time.pulse_only ? 1 : 0;
    // Frames end between packets, as those of Livox's driver.
    glance.first_place = glance.last_place = static_cast<std::uint32_t>(packet->time.time_ns % kFrame_ns / kPlace_ns);
    return glance;
  }

  void decode(std::string_view payload, const PacketColumns&, const PacketSurroundings& around,
              cloud::PointCloud& cloud) const override {
    const std::optional<LivoxPacket> packet = read_livox_packet(head_, payload);
    if (!packet) return;
    const double shot_s = 1e-9 * (packet->shot_ns > 0.0 ? packet->shot_ns : shot_ns(*packet));
    for (std::size_t shot = 0; shot < packet->shots; ++shot) {
      const std::string_view bytes = packet->points.substr(shot * packet->layout.bytes, packet->layout.bytes);
      Eigen::Vector3f before = Eigen::Vector3f::Zero();
      for (std::size_t which = 0; which < packet->layout.returns; ++which) {
        const LivoxReturn found = livox_return(packet->layout, bytes, which);
        const Eigen::Vector3f point = found.point_m.cast<float>();
        if (point == before) continue;  // no return, or one that was there before
        if (!point.allFinite() || point.cwiseAbs().maxCoeff() > cloud::kFarthestReturn_m) {
          ++cloud.dropped_points;
          continue;
        }
        before = point;
        cloud.points.push_back(point);
        cloud.intensity.push_back(found.reflectivity);
        cloud.time_from_stamp_s.push_back(
            static_cast<float>(around.time_from_stamp_s + shot_s * static_cast<double>(shot)));
      }
    }
  }

  bool has_no_points(std::string_view payload) const override {
    const bool of_imu = head_ == LivoxHead::Sdk2   ? payload.size() > kSdk2Head && byte_at(payload, 10) == kSdk2Imu
                        : head_ == LivoxHead::Sdk1 ? payload.size() > kSdk1Head && byte_at(payload, 9) == kSdk1Imu
                                                   : false;
    return of_imu && livox_packet_bytes(head_, payload) == payload.size();
  }

  bool is_of_another(std::string_view payload) const override {
    const std::optional<LivoxPacket> packet = read_livox_packet(head_, payload);
    return packet && packet->source != source_;
  }

  void tune(const PacketSequence& packets, const std::string&) override { packet_interval_ns_ = packets.interval_ns; }

 private:
  /// Shots follow each other evenly, and packets do without a pause.
  double shot_ns(const LivoxPacket& packet) const {
    constexpr std::int64_t kLongestStep_ns = 5'000'000;  // beyond, packets are missing more often than not
    constexpr double kUsual_ns = 1e9 / 200'000.0;
    const bool known = packet_interval_ns_ > 0 && packet_interval_ns_ < kLongestStep_ns;
    return known ? static_cast<double>(packet_interval_ns_) / static_cast<double>(packet.shots) : kUsual_ns;
  }

  LivoxHead head_;
  std::string model_;
  std::uint16_t source_;
  std::int64_t packet_interval_ns_ = 0;
};

std::unique_ptr<PacketDecoder> recognise_livox(std::string_view payload, const std::string&) {
  auto decoder = livox_decoder(LivoxHead::Sdk2, payload, "Livox");
  return decoder ? std::move(decoder) : livox_decoder(LivoxHead::Sdk1, payload, "Livox");
}

}  // namespace

std::optional<std::size_t> livox_packet_bytes(LivoxHead head, std::string_view bytes) {
  if (head == LivoxHead::Lvx2) {
    if (bytes.size() < kLvx2Head) return std::nullopt;
    return kLvx2Head + std::size_t{little_number<std::uint32_t>(bytes, 18)};
  }
  if (head == LivoxHead::Sdk2) {
    if (bytes.size() < kSdk2Head) return std::nullopt;
    return std::size_t{little_number<std::uint16_t>(bytes, 1)};
  }
  if (bytes.size() < kSdk1Head || byte_at(bytes, 0) != kSdk1Version) return std::nullopt;
  const std::uint8_t type = byte_at(bytes, 9);
  if (head == LivoxHead::Sdk1 && type == kSdk1Imu) return kSdk1Head + kLivoxImuBytes;
  const auto layout = head == LivoxHead::Lvx ? std::optional(kLivoxFloatPoints) : livox_layout_of_sdk1(type);
  if (!layout) return std::nullopt;
  return kSdk1Head + livox_shots_of_sdk1(*layout) * layout->bytes;
}

std::unique_ptr<PacketDecoder> livox_decoder(LivoxHead head, std::string_view packet, std::string model) {
  const std::optional<LivoxPacket> read = read_livox_packet(head, packet);
  if (!read) return nullptr;
  return std::make_unique<LivoxDecoder>(head, std::move(model), read->source);
}

PacketFormat livox_packets() { return {"livox", recognise_livox, nullptr}; }

}  // namespace remount::formats
