// Captures of network packets (pcap), as simulated sensors are written into them.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/core/progress.h"
#include "model/simulator/scene.h"

namespace remount::simulator {

std::string little_bytes(std::uint64_t value, std::size_t count);   ///< least significant byte first
std::string network_bytes(std::uint64_t value, std::size_t count);  ///< most significant byte first

/// What a capture of Ethernet begins with.
std::string capture_head();
/// What a sensor sends, when the computer that records it has it.
struct SentDatagram {
  std::int64_t time_ns = 0;  ///< of the computer, Unix time
  std::uint16_t port = 0;
  std::string payload;
};

/// The port that most go to: that of the points. 0 where there is none.
std::uint16_t port_of_points(const std::vector<SentDatagram>& sent);

/// A datagram of a sensor at 192.168.1.201, broadcast to a port. @param time_ns of the computer, Unix time
std::string captured_datagram(std::int64_t time_ns, std::uint16_t port, const std::string& payload);
inline std::string captured_datagram(const SentDatagram& sent) {
  return captured_datagram(sent.time_ns, sent.port, sent.payload);
}

/// Pieces of a capture, by several threads. What is not made when `progress` is cancelled is empty.
std::vector<std::string> pieces_of_capture(std::size_t count, int threads, const Progress& progress,
                                           const std::function<std::string(std::size_t piece)>& make);

/// A range in a packet's units; nothing where it has no place among 1 to `most` of them.
std::optional<std::uint64_t> range_units(double range_m, double unit_m, double most);
/// A reflectance as packets have it: 255 for one of 1 and more.
std::uint64_t light_byte(float reflectance);

/// Unix time that the LiDAR's clock has at a time of the drive.
std::int64_t lidar_stamp_ns(const Scene& scene, double time_s);

}  // namespace remount::simulator
