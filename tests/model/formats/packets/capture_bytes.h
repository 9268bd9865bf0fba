// Captures as tests make them, byte by byte, and the packets of a Velodyne.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace remount::formats {

inline std::string number_bytes(std::uint64_t value, std::size_t count, bool big) {
  std::string bytes;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t place = big ? count - 1 - i : i;
    bytes.push_back(place < sizeof(value) ? static_cast<char>(value >> (8 * place) & 0xffU) : '\0');
  }
  return bytes;
}
inline std::string big(std::uint64_t value, std::size_t count) { return number_bytes(value, count, true); }
inline std::string little(std::uint64_t value, std::size_t count) { return number_bytes(value, count, false); }

struct FrameOptions {
  std::uint32_t address = 0xc0a801c9;  ///< 192.168.1.201
  std::uint16_t port = 2368;
  std::uint16_t id = 0;
  int option_words = 0;  ///< of IPv4
};

inline std::string udp(const std::string& payload, const FrameOptions& options = {}) {
  return big(2368, 2) + big(options.port, 2) + big(payload.size() + 8, 2) + big(0, 2) + payload;
}
/// @param at in the datagram
inline std::string ipv4(const std::string& part, const FrameOptions& options = {}, std::size_t at = 0,
                        bool more = false) {
  const std::size_t header = 20 + 4 * static_cast<std::size_t>(options.option_words);
  return big(0x40U + header / 4, 1) + big(0, 1) + big(header + part.size(), 2) + big(options.id, 2) +
         big((more ? 0x2000U : 0U) + at / 8, 2) + big(64, 1) + big(17, 1) + big(0, 2) + big(options.address, 4) +
         big(0xffffffff, 4) + std::string(header - 20, '\0') + part;
}
inline std::string ethernet(const std::string& ip, const std::vector<std::uint16_t>& tags = {}) {
  std::string frame(12, '\x01');
  for (const std::uint16_t tag : tags) frame += big(tag, 2) + big(7, 2);
  return frame + big(0x0800, 2) + ip;
}
inline std::string ethernet_udp(const std::string& payload, const FrameOptions& options = {}) {
  return ethernet(ipv4(udp(payload, options), options));
}

/// A frame with the time of its capture.
struct TimedFrame {
  std::int64_t time_ns = 0;
  std::string bytes;
};

struct PcapOptions {
  bool big = false, nanoseconds = false;
  std::uint32_t link_type = 1;
  std::size_t most_bytes = 65535;
};
inline std::string pcap(const std::vector<TimedFrame>& frames, const PcapOptions& options = {}) {
  const auto number = [&](std::uint64_t value, std::size_t count) { return number_bytes(value, count, options.big); };
  std::string file = number(options.nanoseconds ? 0xa1b23c4d : 0xa1b2c3d4, 4) + number(2, 2) + number(4, 2) +
                     number(0, 8) + number(options.most_bytes, 4) + number(options.link_type, 4);
  for (const TimedFrame& frame : frames) {
    const std::string bytes = frame.bytes.substr(0, options.most_bytes);
    file += number(static_cast<std::uint64_t>(frame.time_ns / 1'000'000'000), 4) +
            number(static_cast<std::uint64_t>(frame.time_ns % 1'000'000'000) / (options.nanoseconds ? 1 : 1000), 4) +
            number(bytes.size(), 4) + number(frame.bytes.size(), 4) + bytes;
  }
  return file;
}

/// A block of a pcapng.
inline std::string block(std::uint32_t type, std::string body, bool big) {
  body.resize((body.size() + 3) / 4 * 4);
  const std::string length = number_bytes(body.size() + 12, 4, big);
  return number_bytes(type, 4, big) + length + body + length;
}
inline std::string pcapng_section(bool big) {
  return block(
      0x0a0d0d0a,
      number_bytes(0x1a2b3c4d, 4, big) + number_bytes(1, 2, big) + number_bytes(0, 2, big) + std::string(8, '\xff'),
      big);
}
/// @param resolution as if_tsresol has it; 0: the usual microseconds
inline std::string pcapng_interface(bool big, std::uint8_t resolution = 0, std::uint16_t link_type = 1) {
  std::string body = number_bytes(link_type, 2, big) + number_bytes(0, 2, big) + number_bytes(0, 4, big);
  if (resolution != 0)
    body += number_bytes(9, 2, big) + number_bytes(1, 2, big) + std::string(1, static_cast<char>(resolution)) +
            std::string(3, '\0') + number_bytes(0, 4, big);
  return block(1, body, big);
}
inline std::string pcapng_packet(const std::string& frame, std::uint64_t ticks, bool big, std::uint32_t interface = 0) {
  return block(6,
               number_bytes(interface, 4, big) + number_bytes(ticks >> 32U, 4, big) +
                   number_bytes(ticks & 0xffffffffU, 4, big) + number_bytes(frame.size(), 4, big) +
                   number_bytes(frame.size(), 4, big) + frame,
               big);
}

/// A data packet of a Velodyne.
struct VelodynePacket {
  std::uint8_t product = 0x22, mode = 0x37;
  std::uint32_t stamp_us = 0;
  std::vector<std::uint16_t> azimuths;  ///< of its 12 blocks, hundredths of a degree
  std::vector<std::uint16_t> flags = std::vector<std::uint16_t>(12, 0xeeff);
  /// Range in the sensor's units and intensity, of a return of a block.
  std::function<std::pair<std::uint16_t, std::uint8_t>(std::size_t block, std::size_t place)> returns;

  std::string bytes() const {
    std::string payload;
    for (std::size_t b = 0; b < 12; ++b) {
      payload += little(flags[b], 2) + little(azimuths[b], 2);
      for (std::size_t place = 0; place < 32; ++place) {
        const auto [range, intensity] = returns ? returns(b, place) : std::pair<std::uint16_t, std::uint8_t>{5000, 100};
        payload += little(range, 2) + little(intensity, 1);
      }
    }
    return payload + little(stamp_us, 4) + little(mode, 1) + little(product, 1);
  }
};

/// Packets of a VLP-16 that turns ten times a second, one after the other.
/// @param sensor_us at the first, past the hour
inline std::vector<TimedFrame> vlp16_drive(std::size_t packets, std::int64_t host_ns, double sensor_us,
                                           const FrameOptions& options = {}, std::uint8_t mode = 0x37) {
  std::vector<TimedFrame> frames;
  const double blocks = mode == 0x39 ? 6.0 : 12.0, block_us = 110.592;
  for (std::size_t i = 0; i < packets; ++i) {
    VelodynePacket packet;
    packet.mode = mode;
    const double at_us = blocks * block_us * static_cast<double>(i);
    packet.stamp_us = static_cast<std::uint32_t>(std::fmod(sensor_us + at_us, 3.6e9));
    for (std::size_t b = 0; b < 12; ++b) {
      const double azimuth = (at_us + block_us * static_cast<double>(mode == 0x39 ? b / 2 : b)) * 0.36;
      packet.azimuths.push_back(static_cast<std::uint16_t>(std::lround(azimuth) % 36000));
    }
    frames.push_back({host_ns + std::llround(1e3 * at_us), ethernet_udp(packet.bytes(), options)});
  }
  return frames;
}

/// A position packet of a Velodyne. @param pps 2: the clock is locked
inline std::string position_packet(const std::string& sentence, std::uint8_t pps) {
  std::string payload(512, '\0');
  payload[0xca] = static_cast<char>(pps);
  payload.replace(0xce, sentence.size(), sentence);
  return payload;
}

}  // namespace remount::formats
