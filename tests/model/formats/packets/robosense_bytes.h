// Packets of RoboSense's sensors, byte by byte.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/model/formats/packets/capture_bytes.h"

namespace remount::formats {

inline std::string robosense_seconds(std::int64_t time_us) {
  return big(static_cast<std::uint64_t>(time_us / 1'000'000), 6) +
         big(static_cast<std::uint64_t>(time_us % 1'000'000), 4);
}

/// A packet of points of a sensor that turns.
struct MsopPacket {
  bool former = false;                                  ///< RS-LiDAR-16, RS-LiDAR-32, RS-Bpearl
  std::uint8_t legacy_type = 0, type = 6, variant = 1;  ///< of an RS-Helios
  std::string time = robosense_seconds(1'700'000'000'123'456);
  std::vector<std::uint16_t> azimuths;  ///< of its 12 blocks
  /// Range in the sensor's units and intensity, of a return of a block.
  std::function<std::pair<std::uint16_t, std::uint8_t>(std::size_t block, std::size_t place)> returns;

  std::string bytes() const {
    std::string payload = former ? big(0x55aa050a5aa550a0, 8) : big(0x55aa055a, 4) + big(1, 2) + big(0, 2);
    payload += std::string(12, '\0') + time + big(legacy_type, 1) + big(type, 1) + big(variant, 1);
    payload.resize(42);
    for (std::size_t b = 0; b < 12; ++b) {
      payload += big(0xffee, 2) + big(azimuths[b], 2);
      for (std::size_t place = 0; place < 32; ++place) {
        const auto [range, light] = returns ? returns(b, place) : std::pair<std::uint16_t, std::uint8_t>{4000, 77};
        payload += big(range, 2) + big(light, 1);
      }
    }
    return payload + big(0x00ff, 6);
  }
};

/// Blocks that follow each other.
inline std::vector<std::uint16_t> msop_azimuths(int first, int step, std::size_t of_one = 1) {
  std::vector<std::uint16_t> azimuths;
  for (std::size_t b = 0; b < 12; ++b)
    azimuths.push_back(static_cast<std::uint16_t>((first + static_cast<int>(b / of_one) * step) % 36000));
  return azimuths;
}

/// What a sensor says of itself.
struct DifopPacket {
  std::uint8_t return_mode = 4, sync = 1, status = 0;
  std::string time = robosense_seconds(1'700'000'000'000'000);
  std::string sentence;
  std::vector<std::pair<int, int>> angles;  ///< of each laser in the sensor's units: up, and offset of the azimuth
  std::vector<int> rs16_angles;             ///< ten thousandths of a degree, without signs
  bool upside_down = false;
  std::size_t room = 32;  ///< for angles of so many lasers

  static std::string angle(int value) {
    return big(value < 0 ? 1 : 0, 1) + big(static_cast<std::uint64_t>(std::abs(value)), 2);
  }
  std::string bytes() const {
    std::string payload(1248, '\0');
    payload.replace(0, 8, big(0xa5ff005a11115555, 8));
    payload[300] = static_cast<char>(return_mode);
    payload[302] = static_cast<char>(sync);
    payload.replace(303, time.size(), time);
    payload[337] = upside_down ? 1 : 0;
    payload[357] = static_cast<char>(status);
    payload.replace(382, sentence.size(), sentence);
    for (std::size_t i = 0; i < angles.size(); ++i) {
      payload.replace(468 + 3 * i, 3, angle(angles[i].first));
      payload.replace(468 + 3 * (room + i), 3, angle(angles[i].second));
    }
    for (std::size_t i = 0; i < rs16_angles.size(); ++i)
      payload.replace(1165 + 3 * i, 3, big(static_cast<std::uint64_t>(rs16_angles[i]), 3));
    return payload;
  }
};

/// Lasers half a degree apart from -8 degrees on, in the sensor's units of which `per_deg` are a degree.
inline std::vector<std::pair<int, int>> even_angles(int per_deg, std::size_t lasers = 32) {
  std::vector<std::pair<int, int>> angles;
  for (std::size_t i = 0; i < lasers; ++i)
    angles.emplace_back(-8 * per_deg + static_cast<int>(i) * per_deg / 2, i % 2 == 0 ? 4 * per_deg : -3 * per_deg);
  return angles;
}

/// Packets of an RS-Helios that turns ten times a second, one after the other, behind a description.
inline std::vector<TimedFrame> helios_drive(std::size_t packets, std::int64_t host_ns, std::int64_t time_us,
                                            const FrameOptions& options = {.port = 6699}) {
  std::vector<TimedFrame> frames;
  DifopPacket description;
  description.angles = even_angles(100);
  frames.push_back({host_ns, ethernet_udp(description.bytes(), {.address = options.address, .port = 7788})});
  const double round_us = 55.56;
  for (std::size_t i = 0; i < packets; ++i) {
    const double at_us = 12 * round_us * static_cast<double>(i);
    MsopPacket packet;
    packet.time = robosense_seconds(time_us + std::llround(at_us));
    for (std::size_t b = 0; b < 12; ++b)
      packet.azimuths.push_back(
          static_cast<std::uint16_t>(std::lround((at_us + round_us * static_cast<double>(b)) * 0.36) % 36000));
    frames.push_back({host_ns + std::llround(1e3 * (at_us + 12 * round_us)), ethernet_udp(packet.bytes(), options)});
  }
  return frames;
}

/// A packet of an RS-Ruby: as many blocks as azimuths. @param returns of a block and a laser, in the sensor's units
inline std::string ruby_packet(std::size_t lasers, std::uint8_t type, std::uint8_t variant,
                               const std::vector<std::uint16_t>& azimuths,
                               const std::function<std::uint16_t(std::size_t block, std::size_t laser)>& returns) {
  std::string payload = big(0x55aa055a, 4) + std::string(6, '\0') + robosense_seconds(1'700'000'000'123'456);
  payload.resize(31);
  payload += big(type, 1) + big(variant, 1);
  payload.resize(80);
  for (std::size_t b = 0; b < azimuths.size(); ++b) {
    payload += big(0xfe01, 2) + big(azimuths[b], 2);
    for (std::size_t laser = 0; laser < lasers; ++laser) payload += big(returns(b, laser), 2) + big(77, 1);
  }
  payload.resize(lasers == 48 ? 1268 : 1248);
  return payload;
}

/// Of an RS-LiDAR-M1. @param points distance, up and left, in the sensor's units
inline std::string m1_packet(std::uint16_t sequence, std::uint8_t time_mode, std::int64_t time_us,
                             const std::function<std::array<int, 3>(std::size_t block, std::size_t channel)>& points) {
  std::string payload = big(0x55aa5aa5, 4) + big(sequence, 2) + big(1, 2) + big(4, 1) + big(time_mode, 1) +
                        robosense_seconds(time_us) + std::string(12, '\0');
  for (std::size_t block = 0; block < 25; ++block) {
    payload += big(block * 6, 1) + big(1, 1);
    for (std::size_t channel = 0; channel < 5; ++channel) {
      const auto [range, up, left] = points(block, channel);
      payload += big(static_cast<std::uint64_t>(range), 2) + big(static_cast<std::uint64_t>(32768 + up), 2) +
                 big(static_cast<std::uint64_t>(32768 + left), 2) + big(77, 1) + big(0, 2);
    }
  }
  return payload + std::string(3, '\0');
}

}  // namespace remount::formats
