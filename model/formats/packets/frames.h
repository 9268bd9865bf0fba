// What a captured frame of a network holds of a UDP datagram: link layer, VLAN tags, IPv4.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace remount::formats {

/// Where a datagram comes from, and the port that it goes to; of a bag, which knows neither, the topic: what tells
/// sensors apart.
struct DatagramRoute {
  std::uint32_t address = 0;  ///< IPv4, of the sender
  std::uint16_t port = 0;     ///< of the receiver
  std::string topic = {};
  friend auto operator<=>(const DatagramRoute&, const DatagramRoute&) = default;
};
/// "192.168.1.201", or the topic as files may be called: "ouster_lidar_packets".
std::string address_text(const DatagramRoute& route);
std::string to_string(const DatagramRoute& route);  ///< "192.168.1.201:2368", or the topic

/// The UDP part of a frame: a whole datagram with its header, or a fragment of one.
struct UdpPart {
  std::uint32_t source = 0, destination = 0;  ///< addresses
  std::uint16_t id = 0;                       ///< of the datagram that it is a fragment of
  std::size_t begin = 0, bytes = 0;           ///< in the frame
  std::uint32_t at = 0;                       ///< in the datagram
  bool last = true;                           ///< nothing of the datagram comes behind it
  bool whole() const { return at == 0 && last; }
};

enum class FrameContent {
  Udp,          ///< over IPv4
  Other,        ///< another protocol
  Truncated,    ///< UDP whose end was not captured
  UnknownLink,  ///< of a kind of network that is not read
};

/// @param link_type as captures number them: Ethernet, Linux cooked (both), raw IP, BSD loopback
FrameContent find_udp(std::uint32_t link_type, std::string_view frame, UdpPart& part);

}  // namespace remount::formats
