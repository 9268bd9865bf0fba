// Packets of Hesai's sensors as their manuals lay them out.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tests/model/formats/packets/capture_bytes.h"

namespace remount::formats {

/// One of these sensors with its blocks, channels and what stands around them.
struct HesaiPacket {
  enum class Kind { Pandar40, Pandar64, Qt64, Xt, Pandar128, At128, Qt128 };

  Kind kind = Kind::Xt;
  std::size_t blocks = 8, channels = 32;
  std::uint8_t mode = 0x37;
  std::uint16_t rpm = 600;
  std::array<std::uint8_t, 6> date{123, 11, 14, 22, 13, 20};  ///< year, month, day, hour, minute, second
  std::uint32_t stamp_us = 250'000;
  std::uint8_t version = 0, holds = 1, state_mode = 0;  ///< of those with 128 channels
  std::uint8_t loop = 1;                                ///< of a QT128, of its first block
  std::uint16_t states = 0;
  bool counted = true;                       ///< a number of the packet at its end
  std::vector<std::uint16_t> azimuths = {};  ///< of its blocks, hundredths of a degree
  /// Range in units of 4 mm, and reflectivity.
  std::function<std::pair<std::uint16_t, std::uint8_t>(std::size_t block, std::size_t channel)> returns = {};

  static HesaiPacket pandar40() {
    return {.kind = Kind::Pandar40, .blocks = 10, .channels = 40, .date = two_thousand()};
  }
  static HesaiPacket pandar64() {
    return {.kind = Kind::Pandar64, .blocks = 6, .channels = 64, .date = two_thousand()};
  }
  static HesaiPacket pandar128() { return {.kind = Kind::Pandar128, .blocks = 2, .channels = 128}; }
  static HesaiPacket at128() { return {.kind = Kind::At128, .blocks = 2, .channels = 128}; }
  /// With the confidence of each return, as sensors send them.
  static HesaiPacket qt128() { return {.kind = Kind::Qt128, .blocks = 2, .channels = 128, .holds = 0x1d}; }
  static HesaiPacket qt64() { return {.kind = Kind::Qt64, .blocks = 4, .channels = 64}; }
  static HesaiPacket xt16() { return {.channels = 16}; }
  static HesaiPacket xt32m() { return {.blocks = 6}; }

  std::string bytes() const {
    std::string payload;
    const auto blocks_8 = static_cast<std::uint64_t>(blocks), channels_8 = static_cast<std::uint64_t>(channels);
    if (kind == Kind::Pandar64)
      payload = "\xee\xff" + little(channels_8, 1) + little(blocks_8, 1) + little(0, 1) + little(4, 1) + little(0, 2);
    if (kind == Kind::Qt64 || kind == Kind::Xt)
      payload = "\xee\xff" + little(kind == Kind::Qt64 ? 3 : 6, 1) + little(1, 1) + little(0, 2) +
                little(channels_8, 1) + little(blocks_8, 1) + little(0, 1) + little(4, 1) + little(0, 1) + little(1, 1);
    const bool checked = kind == Kind::Pandar128 || kind == Kind::At128 || kind == Kind::Qt128;
    if (checked)
      payload = "\xee\xff" + little(protocol_of_128(), 2) + little(version, 2) + little(channels_8, 1) +
                little(blocks_8, 1) + little(0, 1) + little(4, 1) + little(1, 1) + little(holds, 1);
    for (std::size_t block = 0; block < blocks; ++block) {
      if (kind == Kind::Pandar40) payload += "\xff\xee";
      payload += little(azimuths[block], 2);
      if (kind == Kind::At128) payload += little(128, 1);  // half of a hundredth more
      for (std::size_t channel = 0; channel < channels; ++channel) {
        const auto [range, light] =
            returns ? returns(block, channel) : std::pair<std::uint16_t, std::uint8_t>{2500, 50};
        payload += little(range, 2) + little(light, 1);
        const bool confident = (kind == Kind::Pandar128 || kind == Kind::Qt128) && (holds & 0x10) != 0;
        if (kind == Kind::Qt64 || kind == Kind::Xt || kind == Kind::At128 || confident) payload += little(200, 1);
      }
    }
    if (checked) return payload + checked_tail();
    return payload + tail() + (counted ? little(7, 4) : "");
  }

 private:
  static std::array<std::uint8_t, 6> two_thousand() { return {23, 11, 14, 22, 13, 20}; }
  int protocol_of_128() const { return kind == Kind::Pandar128 ? 0x0401 : kind == Kind::Qt128 ? 0x0203 : 0x0304; }
  std::string checked_tail() const {
    const auto of = [&](int what, std::size_t bytes) { return std::string((holds & what) != 0 ? bytes : 0, '\x11'); };
    const std::string day(reinterpret_cast<const char*>(date.data()), date.size());
    const std::string own =
        kind == Kind::Qt128 ? std::string(5, '\0') + little(loop, 1) + std::string(6, '\0') + little(mode, 1) +
                                  little(rpm, 2) + day + little(stamp_us, 4) + little(0x42, 1)
        : kind == Kind::Pandar128
            ? std::string(9, '\0') + little(states, 2) + little(state_mode, 1) + little(mode, 1) + little(rpm, 2) +
                  day + little(stamp_us, 4) + little(0x42, 1)
            : std::string(18, '\0') + little(rpm, 2) + little(stamp_us, 4) + little(mode, 1) + little(0x42, 1) + day;
    return little(0, 4) + of(4, 17) + own + of(1, 4) + of(2, 22) + little(0, 4) + of(8, 32);
  }
  std::string tail() const {
    const std::string day(reinterpret_cast<const char*>(date.data()), date.size());
    switch (kind) {
      case Kind::Pandar128:
      case Kind::At128:
      case Kind::Qt128:
        break;
      case Kind::Pandar40:
      case Kind::Pandar64:
        return std::string(8, '\0') + little(rpm, 2) + little(stamp_us, 4) + little(mode, 1) + little(0x42, 1) + day;
      case Kind::Qt64:
        return std::string(10, '\0') + little(rpm, 2) + little(stamp_us, 4) + little(mode, 1) + little(0x42, 1) + day;
      case Kind::Xt:
        return std::string(10, '\0') + little(mode, 1) + little(rpm, 2) + day + little(stamp_us, 4) + little(0x42, 1);
    }
    return {};
  }
};

/// Angles of an AT128: mirrors from 24 degrees of the encoder on, channels 0.2 degrees apart. What was measured of the
/// fourth: 2 degrees of azimuth, and 0.2 and -0.1 degrees everywhere.
inline std::string mirror_bytes() {
  const auto units = [](double degrees) {
    return little(static_cast<std::uint64_t>(static_cast<std::int64_t>(std::llround(12'800.0 * degrees))), 4);
  };
  std::string bytes = "\xee\xff\x01\x05\x80\x03\x03" + std::string(8, '\0') + "\x02";
  for (const double degrees : {24.0, 144.0, 264.0, 144.0, 264.0, 24.0}) bytes += units(degrees);
  for (int channel = 0; channel < 128; ++channel) bytes += units(channel == 3 ? 2.0 : 0.0);
  for (int channel = 0; channel < 128; ++channel) bytes += units(0.2 * (channel - 64));
  for (const char adjust : {char{10}, char{-5}})
    for (int channel = 0; channel < 128; ++channel) bytes += std::string(180, channel == 3 ? adjust : '\0');
  return bytes + std::string(32, '\x77');
}

/// Of 2023-11-14 22:13:20 UTC, the date of a packet.
inline constexpr std::int64_t kHesaiDate_ns = 1'700'000'000'000'000'000;

/// Packets of a PandarXT-32 that turns ten times a second, one after the other, from that date on.
inline std::vector<TimedFrame> hesai_drive(std::size_t packets, std::int64_t host_ns, HesaiPacket packet = {},
                                           const FrameOptions& options = {}) {
  std::vector<TimedFrame> frames;
  for (std::size_t i = 0; i < packets; ++i) {
    const double begins_us = 400.0 * static_cast<double>(i);
    packet.azimuths.clear();
    for (std::size_t block = 0; block < 8; ++block)
      packet.azimuths.push_back(
          static_cast<std::uint16_t>(std::lround((begins_us + 50.0 * static_cast<double>(block)) * 0.36) % 36000));
    const auto stamp_us = static_cast<std::uint64_t>(begins_us) + 350;
    packet.date[5] = static_cast<std::uint8_t>(20 + stamp_us / 1'000'000);
    packet.stamp_us = static_cast<std::uint32_t>(stamp_us % 1'000'000);
    frames.push_back({host_ns + static_cast<std::int64_t>(400'000 * (i + 1)), ethernet_udp(packet.bytes(), options)});
  }
  return frames;
}

}  // namespace remount::formats
