// Packets of an Ouster as its manual lays them out, and its metadata.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tests/model/formats/packets/capture_bytes.h"

namespace remount::formats {

inline constexpr std::uint64_t kOusterSerial = 992'119'000'444;

/// A packet of points.
struct OusterPacket {
  std::string profile = "RNG19_RFL8_SIG16_NIR16";
  bool fusa = false;  ///< the header for functional safety
  std::size_t columns = 16, pixels = 16;
  std::uint32_t frame = 7, initialization = 5'431'287;
  std::uint64_t serial = kOusterSerial, time_ns = 1'000'000'000, step_ns = 97'656;
  std::uint16_t place = 0;
  /// Millimetres of both returns of a pixel.
  std::function<std::array<std::uint32_t, 2>(std::size_t column, std::size_t pixel)> ranges;
  std::function<bool(std::size_t column)> valid;

  std::string bytes() const {
    std::string payload;
    if (profile != "LEGACY")
      payload = fusa ? little(1, 1) + little(initialization, 3) + little(frame, 4) + little(0, 3) + little(serial, 5) +
                           std::string(16, '\0')
                     : little(1, 2) + little(frame, 2) + little(initialization, 3) + little(serial, 5) +
                           std::string(20, '\0');
    for (std::size_t column = 0; column < columns; ++column) payload += column_bytes(column);
    return profile == "LEGACY" ? payload : payload + std::string(32, '\x5a');
  }

 private:
  std::string column_bytes(std::size_t column) const {
    const bool legacy = profile == "LEGACY", measured = !valid || valid(column);
    std::string bytes = little(time_ns + column * step_ns, 8) + little(place + column, 2);
    bytes += legacy ? little(frame, 2) + little((place + column) * 88, 4) : little(measured ? 1 : 0, 2);
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) bytes += pixel_bytes(column, pixel);
    return legacy ? bytes + little(measured ? 0xffffffff : 0, 4) : bytes;
  }
  std::string pixel_bytes(std::size_t column, std::size_t pixel) const {
    const auto [first, second] = ranges ? ranges(column, pixel) : std::array<std::uint32_t, 2>{5000, 0};
    const std::uint64_t light = 77, other_light = 33, noise = 0xf80000;  // flags stand above the 19 bits of a range
    if (profile == "RNG15_RFL8_NIR8") return little(first / 8 | 0x8000, 2) + little(light, 1) + little(9, 1);
    if (profile.ends_with("RNG15_RFL8_NIR8_DUAL"))
      return little(first / 8 | 0x8000, 2) + little(light, 1) + little(9, 1) + little(second / 8, 2) +
             little(other_light, 1) + little(0xff, 1);
    if (profile == "RNG19_RFL8_SIG16_NIR16_DUAL")
      return little(first | noise | light << 24, 4) + little(second | other_light << 24, 4) + little(500, 2) +
             little(400, 2) + little(300, 4);
    const std::uint64_t flags = profile == "LEGACY" ? 0xf0000000 : noise;
    return little(first | flags, 4) + little(light, 2) + little(500, 2) + little(300, 4);
  }
};

/// Of a sensor with these angles; the others as of an OS1.
struct OusterDescription {
  std::string profile = "RNG19_RFL8_SIG16_NIR16", product = "OS-1-16", mode = "TIME_FROM_INTERNAL_OSC";
  std::string serial = std::to_string(kOusterSerial);
  std::size_t pixels = 16, columns = 1024, columns_in_packet = 16;
  int port = 7502, initialization = 5'431'287;
  double highest_deg = 15.0, step_deg = 2.0, azimuth_deg = 3.0, ahead_mm = 15.806;

  std::string list(const std::function<double(std::size_t)>& number) const {
    std::string text = "[";
    for (std::size_t pixel = 0; pixel < pixels; ++pixel)
      text += (pixel == 0 ? "" : ", ") + std::to_string(number(pixel));
    return text + "]";
  }
  std::string beams() const {
    return "\"beam_altitude_angles\": " +
           list([&](std::size_t pixel) { return highest_deg - step_deg * static_cast<double>(pixel); }) +
           ", \"beam_azimuth_angles\": " +
           list([&](std::size_t pixel) { return pixel % 2 == 0 ? azimuth_deg : -azimuth_deg; }) +
           ", \"lidar_origin_to_beam_origin_mm\": " + std::to_string(ahead_mm);
  }
  static std::string housing() { return "\"lidar_to_sensor_transform\": [-1,0,0,0, 0,-1,0,0, 0,0,1,36.18, 0,0,0,1]"; }
  std::string info() const {
    return "\"prod_line\": \"" + product + "\", \"prod_sn\": \"" + serial +
           "\", \"initialization_id\": " + std::to_string(initialization);
  }
  std::string format() const {
    return "{\"columns_per_frame\": " + std::to_string(columns) +
           ", \"columns_per_packet\": " + std::to_string(columns_in_packet) +
           ", \"pixels_per_column\": " + std::to_string(pixels) + ", \"column_window\": [0, " +
           std::to_string(columns - 1) + "], \"udp_profile_lidar\": \"" + profile + "\"}";
  }
  std::string config() const {
    return "\"lidar_mode\": \"" + std::to_string(columns) + "x10\", \"udp_port_lidar\": " + std::to_string(port) +
           ", \"timestamp_mode\": \"" + mode + "\"";
  }
  /// As sensors give it.
  std::string json() const {
    return "{\"sensor_info\": {" + info() + "}, \"beam_intrinsics\": {" + beams() + "}, \"lidar_intrinsics\": {" +
           housing() + "}, \"lidar_data_format\": " + format() + ", \"config_params\": {" + config() + "}}";
  }
  /// As recorders wrote it before.
  std::string flat() const {
    return "{" + info() + ", " + beams() + ", " + housing() + ", \"data_format\": " + format() + ", " + config() + "}";
  }
};

/// Packets of an OS1 that turns ten times a second, one after the other. @param sensor_ns at the first
inline std::vector<TimedFrame> ouster_drive(std::size_t packets, std::int64_t host_ns, std::uint64_t sensor_ns,
                                            OusterPacket packet = {}, const FrameOptions& options = {.port = 7502},
                                            std::size_t columns_in_turn = 1024) {
  std::vector<TimedFrame> frames;
  const std::uint32_t first = packet.frame;
  const std::size_t in_turn = columns_in_turn / 16, packet_ns = 100'000'000 / in_turn;
  packet.step_ns = static_cast<decltype(packet.step_ns)>(100'000'000 / columns_in_turn);
  for (std::size_t i = 0; i < packets; ++i) {
    packet.frame = first + static_cast<std::uint32_t>(i / in_turn);
    packet.place = static_cast<std::uint16_t>(i % in_turn * 16);
    packet.time_ns = sensor_ns + i * packet_ns;
    frames.push_back({host_ns + static_cast<std::int64_t>((i + 1) * packet_ns), ethernet_udp(packet.bytes(), options)});
  }
  return frames;
}

}  // namespace remount::formats
