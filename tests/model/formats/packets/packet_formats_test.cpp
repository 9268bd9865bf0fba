// The list of makes: packets of one are not taken for those of another.
#include <gtest/gtest.h>

#include "algorithms/core/error.h"
#include "model/formats/packets/packet_decoder.h"
#include "tests/model/formats/packets/hesai_bytes.h"
#include "tests/model/formats/packets/livox_bytes.h"
#include "tests/model/formats/packets/ouster_bytes.h"
#include "tests/model/formats/packets/robosense_bytes.h"

namespace remount::formats {
namespace {

/// Those that take a packet of points for one of theirs, read or not.
std::string makes_of(const std::string& payload) {
  std::string makes;
  for (const PacketFormat& format : packet_formats()) {
    bool taken = false;
    try {
      taken = format.recognise(payload, "capture") != nullptr;
    } catch (const Error&) {
      taken = true;
    }
    if (taken) makes += std::string(makes.empty() ? "" : " ") + std::string(format.id);
  }
  return makes;
}

std::string payload_of(const TimedFrame& frame) {
  constexpr std::size_t kEthernetIpUdp = 14 + 20 + 8;
  return frame.bytes.substr(kEthernetIpUdp);
}

TEST(packet_formats, a_packet_is_of_one_make) {
  constexpr std::int64_t kBegins_ns = 1'700'000'000'000'000'000;
  EXPECT_EQ(makes_of(payload_of(vlp16_drive(1, kBegins_ns, 800e6)[0])), "velodyne");
  EXPECT_EQ(makes_of(payload_of(mid360_drive(1, kBegins_ns, kBegins_ns, 1)[0])), "livox");
  EXPECT_EQ(makes_of(sdk1_packet(1, 2, little(static_cast<std::uint64_t>(kBegins_ns), 8), numbered_shots(0, 96))),
            "livox");
  EXPECT_EQ(makes_of(payload_of(helios_drive(1, kBegins_ns, kBegins_ns / 1000).back())), "robosense");
  const auto points = [](std::size_t, std::size_t) { return std::array<int, 3>{2000, 100, 7}; };
  EXPECT_EQ(makes_of(m1_packet(1, 2, kBegins_ns / 1000, points)), "robosense");
  for (const char* profile : {"LEGACY", "RNG19_RFL8_SIG16_NIR16", "RNG19_RFL8_SIG16_NIR16_DUAL", "RNG15_RFL8_NIR8",
                              "FUSA_RNG15_RFL8_NIR8_DUAL"}) {
    OusterPacket packet;
    packet.profile = profile, packet.fusa = std::string_view(profile).starts_with("FUSA");
    const std::string payload =
        payload_of(ouster_drive(1, kBegins_ns, static_cast<std::uint64_t>(kBegins_ns), packet)[0]);
    EXPECT_EQ(makes_of(payload), "ouster") << profile;
  }
  for (HesaiPacket packet : {HesaiPacket(), HesaiPacket::pandar40(), HesaiPacket::pandar64(), HesaiPacket::qt64(),
                             HesaiPacket::pandar128(), HesaiPacket::at128()}) {
    packet.azimuths.assign(packet.blocks, 1200);
    EXPECT_EQ(makes_of(packet.bytes()), "hesai") << packet.channels << " channels, " << packet.blocks << " blocks";
  }
}

}  // namespace
}  // namespace remount::formats
