// Captures of network packets (pcap), as simulated sensors are written into them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "model/simulator/simulator.h"

namespace remount::simulator {

std::string little_bytes(std::uint64_t value, std::size_t count);   ///< least significant byte first
std::string network_bytes(std::uint64_t value, std::size_t count);  ///< most significant byte first

/// What a capture of Ethernet begins with.
std::string capture_head();
/// A datagram of a sensor at 192.168.1.201, broadcast to a port. @param time_ns of the computer, Unix time
std::string captured_datagram(std::int64_t time_ns, std::uint16_t port, const std::string& payload);

/// The world of a drive whose LiDAR is to be replaced by a sensor. Throws Error(Contract) for a drive that is not
/// simulated, or turns slower or faster than such sensors do.
/// @param format as drives are asked for @param model of the sensor, for messages
const Scene& scene_of_capture(const SimulatedDrive& drive, std::string_view format, std::string_view model);

/// Unix time that the LiDAR's clock has at a time of the drive.
std::int64_t lidar_stamp_ns(const Scene& scene, double time_s);

}  // namespace remount::simulator
