// Captures of network packets, as tcpdump writes them.
#pragma once

#include <cstdint>
#include <string>

namespace remount::simulator {

/// The least significant byte first.
std::string little_bytes(std::uint64_t value, std::size_t count);
/// The most significant byte first, as networks have it.
std::string network_bytes(std::uint64_t value, std::size_t count);

/// What a pcap begins with.
std::string capture_head();
/// A datagram that a sensor sends to everybody. @param time_ns Unix time at which it was captured
std::string captured_datagram(std::int64_t time_ns, std::uint32_t address, std::uint16_t port,
                              const std::string& payload);

}  // namespace remount::simulator
