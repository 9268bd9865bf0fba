#include "model/formats/packets/frames.h"

#include <algorithm>
#include <optional>

#include "model/formats/files/number_bytes.h"

namespace remount::formats {

namespace {

constexpr std::uint16_t kIpv4 = 0x0800;

/// Where what a frame carries begins, and what it is.
struct Carried {
  std::size_t begin = 0;
  std::uint16_t protocol = 0;
};

/// Loopback of BSD: the family of addresses in the byte order of whoever captured; 2 is IPv4 everywhere.
std::optional<Carried> behind_loopback(std::string_view frame) {
  if (frame.size() < 4) return Carried{};
  const bool ipv4 = number_in<std::uint32_t>(frame, 0, true) == 2 || number_in<std::uint32_t>(frame, 0, false) == 2;
  return Carried{4, ipv4 ? kIpv4 : std::uint16_t{0}};
}

std::optional<Carried> behind_header(std::string_view frame, std::size_t protocol_at, std::size_t header_bytes) {
  if (frame.size() < header_bytes) return Carried{};
  return Carried{header_bytes, network_number<std::uint16_t>(frame, protocol_at)};
}

/// Nothing for a link that is not read. What is too short carries no known protocol.
std::optional<Carried> behind_link(std::uint32_t link_type, std::string_view frame) {
  switch (link_type) {
    case 1:
      return behind_header(frame, 12, 14);  // Ethernet
    case 113:
      return behind_header(frame, 14, 16);  // Linux cooked
    case 276:
      return behind_header(frame, 0, 20);  // Linux cooked, version 2
    case 12:
    case 14:
    case 101:
    case 228:
      return Carried{0, kIpv4};  // raw IP, as several systems number it
    case 0:
    case 108:
      return behind_loopback(frame);
    default:
      return std::nullopt;
  }
}

/// Tags of virtual networks, one or several.
Carried behind_tags(std::string_view frame, Carried carried) {
  constexpr std::size_t kTagBytes = 4, kMostTags = 4;
  for (std::size_t tag = 0; tag < kMostTags; ++tag) {
    const bool tagged = carried.protocol == 0x8100 || carried.protocol == 0x88a8 || carried.protocol == 0x9100;
    if (!tagged || frame.size() < carried.begin + kTagBytes) break;
    carried = {carried.begin + kTagBytes, network_number<std::uint16_t>(frame, carried.begin + 2)};
  }
  return carried;
}

}  // namespace

std::string address_text(const DatagramRoute& route) {
  std::string text = route.topic.substr(std::min(route.topic.find_first_not_of('/'), route.topic.size()));
  std::ranges::replace(text, '/', '_');
  if (!route.topic.empty()) return text;
  for (int byte = 3; byte >= 0; --byte)
    text += std::to_string(route.address >> (8U * static_cast<unsigned>(byte)) & 0xffU) + (byte > 0 ? "." : "");
  return text;
}

std::string to_string(const DatagramRoute& route) {
  return route.topic.empty() ? address_text(route) + ":" + std::to_string(route.port) : route.topic;
}

FrameContent find_udp(std::uint32_t link_type, std::string_view frame, UdpPart& part) {
  constexpr std::size_t kLeastHeader = 20;
  constexpr std::uint8_t kUdp = 17;
  const std::optional<Carried> link = behind_link(link_type, frame);
  if (!link) return FrameContent::UnknownLink;
  const Carried carried = behind_tags(frame, *link);
  if (carried.protocol != kIpv4 || frame.size() < carried.begin + kLeastHeader) return FrameContent::Other;
  const std::string_view ip = frame.substr(carried.begin);
  const auto first = static_cast<unsigned char>(ip[0]);
  const std::size_t header = 4U * (first & 0x0fU);
  if (first >> 4U != 4 || header < kLeastHeader || static_cast<unsigned char>(ip[9]) != kUdp)
    return FrameContent::Other;
  // A network card that cuts datagrams itself leaves the length zero in what is captured before it.
  std::size_t total = network_number<std::uint16_t>(ip, 2);
  if (total == 0) total = ip.size();
  if (total < header) return FrameContent::Other;
  if (total > ip.size()) return FrameContent::Truncated;
  const auto fragment = network_number<std::uint16_t>(ip, 6);
  part.source = network_number<std::uint32_t>(ip, 12);
  part.destination = network_number<std::uint32_t>(ip, 16);
  part.id = network_number<std::uint16_t>(ip, 4);
  part.begin = carried.begin + header;
  part.bytes = total - header;
  part.at = 8U * (fragment & 0x1fffU);
  part.last = (fragment & 0x2000U) == 0;
  return FrameContent::Udp;
}

}  // namespace remount::formats
