// Packets of Livox's sensors and recordings of its viewer, byte by byte.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/model/formats/packets/capture_bytes.h"

namespace remount::formats {

/// A return in the units of the layout: coordinates of a cartesian one; range, zenith and azimuth of a spherical one.
struct LivoxShot {
  std::int32_t a = 0, b = 0, c = 0;
  std::uint8_t light = 77;
};

inline std::string signed_bytes(std::int64_t value, std::size_t count) {
  return little(static_cast<std::uint64_t>(value), count);
}
inline std::string cartesian(const LivoxShot& shot, std::size_t coordinate_bytes, bool tag) {
  return signed_bytes(shot.a, coordinate_bytes) + signed_bytes(shot.b, coordinate_bytes) +
         signed_bytes(shot.c, coordinate_bytes) + little(shot.light, 1) + (tag ? little(0x10, 1) : "");
}
inline std::string spherical(const LivoxShot& shot, bool tag) {
  return signed_bytes(shot.a, 4) + signed_bytes(shot.b, 2) + signed_bytes(shot.c, 2) + little(shot.light, 1) +
         (tag ? little(0x10, 1) : "");
}
/// Several returns of one direction.
inline std::string spherical_returns(const LivoxShot& shot, const std::vector<std::uint32_t>& ranges_mm) {
  std::string bytes = signed_bytes(shot.b, 2) + signed_bytes(shot.c, 2);
  for (const std::uint32_t range : ranges_mm) bytes += little(range, 4) + little(shot.light, 1) + little(0x10, 1);
  return bytes;
}
inline std::string metres(float x, float y, float z, std::uint8_t light) {
  std::string bytes;
  for (const float value : {x, y, z}) bytes += little(std::bit_cast<std::uint32_t>(value), 4);
  return bytes + little(light, 1);
}
inline std::string repeated(const std::string& bytes, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += bytes;
  return all;
}

/// Of the first SDK. @param time its eight bytes
inline std::string sdk1_packet(std::uint8_t time_type, std::uint8_t data_type, const std::string& time,
                               const std::string& points, std::uint8_t id = 1) {
  return little(5, 1) + little(0, 1) + little(id, 1) + little(0, 1) + little(0, 4) + little(time_type, 1) +
         little(data_type, 1) + time + points;
}
/// Of the second. @param taken in tenths of microseconds
inline std::string sdk2_packet(std::uint8_t time_type, std::uint8_t data_type, std::uint64_t time_ns,
                               std::uint16_t taken, std::uint16_t shots, const std::string& points) {
  return little(0, 1) + little(36 + points.size(), 2) + little(taken, 2) + little(shots, 2) + little(0, 2) +
         little(0, 1) + little(data_type, 1) + little(time_type, 1) + little(0, 12) + little(0, 4) +
         little(time_ns, 8) + points;
}
inline std::string lvx2_package(std::uint32_t id, std::uint8_t time_type, std::uint8_t data_type, std::uint64_t time_ns,
                                const std::string& points) {
  return little(0, 1) + little(id, 4) + little(0, 1) + little(time_type, 1) + little(time_ns, 8) + little(0, 2) +
         little(data_type, 1) + little(points.size(), 4) + little(0, 5) + points;
}

struct LvxDevice {
  std::string serial;
  std::uint32_t id = 0;
  std::uint8_t type = 9;
};

/// @param minor of version 1; 2.0 where it is negative @param frames the packages of each
inline std::string lvx(int minor, const std::vector<LvxDevice>& devices, const std::vector<std::string>& frames) {
  std::string file = "livox_tech";
  file.resize(16);
  file += minor < 0 ? little(2, 4) : little(1, 1) + little(static_cast<std::uint64_t>(minor), 3);
  file += little(0xac0ea767, 4) + (minor == 0 ? "" : little(50, 4)) + little(devices.size(), 1);
  for (const LvxDevice& device : devices) {
    std::string serial = device.serial;
    serial.resize(32);
    file += serial + (minor < 0 ? little(device.id, 4) + little(0, 1) : little(device.id, 1)) + little(device.type, 1) +
            (minor == 0 ? "" : little(0, 1)) + std::string(24, '\0');
  }
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const std::size_t head = minor == 0 ? 32 : 24;
    file += little(file.size(), 8) + little(file.size() + head + frames[i].size(), 8) + little(i, 8) +
            (minor == 0 ? little(1, 8) : "") + frames[i];
  }
  return file;
}

/// Millimetres of a shot that tell which it is.
inline std::string numbered_shots(std::size_t first, std::size_t count) {
  std::string points;
  for (std::size_t i = 0; i < count; ++i)
    points += cartesian({1000 + static_cast<std::int32_t>(first + i), 2000, -300}, 4, true);
  return points;
}

/// A Mid-360: 96 shots every 480 us. @param time_ns of the first packet
inline std::vector<TimedFrame> mid360_drive(std::size_t packets, std::int64_t host_ns, std::int64_t time_ns,
                                            std::uint8_t time_type, const FrameOptions& options = {.port = 56301}) {
  std::vector<TimedFrame> frames;
  for (std::size_t i = 0; i < packets; ++i) {
    const auto after_ns = static_cast<std::int64_t>(i) * 480'000;
    frames.push_back({host_ns + after_ns + 480'000,
                      ethernet_udp(sdk2_packet(time_type, 1, static_cast<std::uint64_t>(time_ns + after_ns), 4800, 96,
                                               numbered_shots(96 * i, 96)),
                                   options)});
  }
  return frames;
}

}  // namespace remount::formats
