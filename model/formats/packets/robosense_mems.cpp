#include "model/formats/packets/robosense_mems.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "algorithms/geometry/rotation.h"
#include "model/formats/files/number_bytes.h"
#include "model/formats/packets/packet_times.h"

namespace remount::formats {

namespace {

constexpr std::size_t kM1Bytes = 1210, kM1Head = 32, kM1Blocks = 25, kM1BlockBytes = 47, kM1Channels = 5;
constexpr std::size_t kM1ReturnBytes = 9, kM1PointBytes = 6, kM1SequenceAt = 4, kM1TimeModeAt = 9, kM1TimeAt = 10;
constexpr std::string_view kM1Mark("\x55\xaa\x5a\xa5", 4);

/// An RS-LiDAR-M1: a frame is 630 packets, or 1260 of two returns, which are numbered.
class M1Decoder final : public PacketDecoder {
 public:
  std::string model() const override { return "RS-LiDAR-M1"; }
  std::uint32_t places() const override { return 2048; }

  std::optional<PacketGlance> glance(std::string_view payload) const override {
    if (payload.size() != kM1Bytes || !payload.starts_with(kM1Mark)) return std::nullopt;
    const auto time_ns = seconds_and_part_ns(payload, kM1TimeAt);
    const std::uint32_t sequence = network_number<std::uint16_t>(payload, kM1SequenceAt);
    if (!time_ns || sequence >= places()) return std::nullopt;
    PacketGlance glance;
    glance.sensor_time_ns = *time_ns;
    glance.first_place = glance.last_place = sequence;
    glance.clock_follows = payload[kM1TimeModeAt] != 0 && has_date(*time_ns);
    return glance;
  }

  void decode(std::string_view payload, const PacketColumns& columns, const PacketSurroundings& around,
              cloud::PointCloud& cloud) const override {
    if (payload.size() != kM1Bytes) return;
    const std::string_view first = first_of(payload, around.before);
    const double begins_s = around.time_from_stamp_s - after_first_s(payload, first);
    for (std::size_t block = columns.first; block < std::min<std::size_t>(columns.end, kM1Blocks); ++block) {
      const std::size_t begins = kM1Head + block * kM1BlockBytes;
      const double after_us = byte_at(payload, begins);
      const auto time_s = static_cast<float>(begins_s + 1e-6 * after_us);
      for (std::size_t channel = 0; channel < kM1Channels; ++channel) {
        const std::size_t at = begins + 2 + channel * kM1ReturnBytes;
        const bool same = !first.empty() && first.substr(at, kM1PointBytes) == payload.substr(at, kM1PointBytes);
        if (!same) add_return(payload, at, time_s, cloud);
      }
    }
  }

 private:
  /// The packet of the first returns, where this one has the second of the same shots; else empty.
  static std::string_view first_of(std::string_view payload, std::string_view before) {
    constexpr std::size_t kWhichReturnAt = kM1Head + 1;
    constexpr char kFirst = 1, kSecond = 2;
    if (payload[kWhichReturnAt] != kSecond || before.size() != kM1Bytes || before[kWhichReturnAt] != kFirst) return {};
    const int step =
        network_number<std::uint16_t>(payload, kM1SequenceAt) - network_number<std::uint16_t>(before, kM1SequenceAt);
    return step == 1 ? before : std::string_view();
  }

  /// Shots have one time: that of the packet of their first returns.
  static double after_first_s(std::string_view payload, std::string_view first) {
    if (first.empty()) return 0.0;
    const auto its_ns = seconds_and_part_ns(payload, kM1TimeAt), first_ns = seconds_and_part_ns(first, kM1TimeAt);
    constexpr std::int64_t kLongestStep_ns = 1'000'000;  // more is no time of the same shots
    if (!its_ns || !first_ns || std::abs(*its_ns - *first_ns) > kLongestStep_ns) return 0.0;
    return 1e-9 * static_cast<double>(*its_ns - *first_ns);
  }

  static void add_return(std::string_view payload, std::size_t at, float time_s, cloud::PointCloud& cloud) {
    constexpr double kUnit_m = 0.005;
    constexpr int kAhead = 32768;  // hundredths of a degree count from there
    const auto angle_rad = [&](std::size_t place) {
      return degrees_to_radians(0.01 * (network_number<std::uint16_t>(payload, place) - kAhead));
    };
    const auto range = network_number<std::uint16_t>(payload, at);
    if (range == 0) return;
    const double range_m = range * kUnit_m, up_rad = angle_rad(at + 2), left_rad = angle_rad(at + 4);
    cloud.points.emplace_back(static_cast<float>(range_m * std::cos(up_rad) * std::cos(left_rad)),
                              static_cast<float>(range_m * std::cos(up_rad) * std::sin(left_rad)),
                              static_cast<float>(range_m * std::sin(up_rad)));
    cloud.intensity.push_back(byte_at(payload, at + 6));
    cloud.time_from_stamp_s.push_back(time_s);
  }
};

}  // namespace

std::unique_ptr<PacketDecoder> recognise_robosense_mems(std::string_view payload, const std::string&) {
  auto decoder = std::make_unique<M1Decoder>();
  return decoder->glance(payload) ? std::move(decoder) : nullptr;
}

}  // namespace remount::formats
