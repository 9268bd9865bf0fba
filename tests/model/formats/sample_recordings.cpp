#include "tests/model/formats/sample_recordings.h"

#include <vector>

#include "tests/model/formats/packets/capture_bytes.h"
#include "tests/model/formats/packets/livox_bytes.h"
#include "tests/model/formats/packets/robosense_bytes.h"

namespace remount::formats {

namespace {

constexpr std::int64_t kCaptured_ns = 1'700'000'000'000'000'000;

std::string captured_helios() { return pcap(helios_drive(4, kCaptured_ns, kCaptured_ns / 1000)); }

/// Few shots a packet, so that many packets are short.
std::string captured_livox() {
  std::vector<TimedFrame> frames;
  for (std::size_t i = 0; i < 12; ++i) {
    const auto time_ns = static_cast<std::uint64_t>(kCaptured_ns) + 30'000'000 * i;
    const std::string points = i % 2 == 0 ? numbered_shots(i, 4) : repeated(spherical({9'000, 6'000, 3'000}, true), 4);
    frames.push_back({static_cast<std::int64_t>(time_ns) + 400'000,
                      ethernet_udp(sdk2_packet(1, i % 2 == 0 ? 1 : 3, time_ns, 200, 4, points), {.port = 56301})});
  }
  return pcap(frames);
}

std::string captured_former_livox() {
  std::vector<TimedFrame> frames;
  const std::string two = repeated(spherical_returns({0, 6'000, 3'000}, {9'000, 12'000}), 48);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::string spelt =
        little(23, 1) + little(11, 1) + little(14, 1) + little(22, 1) + little(800'000'000 + 50'000 * i, 4);
    frames.push_back({kCaptured_ns + static_cast<std::int64_t>(i) * 50'000'000,
                      ethernet_udp(sdk1_packet(3, 5, spelt, two), {.port = 56000})});
  }
  return pcap(frames);
}

std::string captured_m1() {
  const auto points = [](std::size_t block, std::size_t) {
    return std::array<int, 3>{2000, 100, static_cast<int>(block)};
  };
  std::vector<TimedFrame> frames;
  for (std::uint16_t i = 629; i < 633; ++i)
    frames.push_back({kCaptured_ns + i, ethernet_udp(m1_packet(static_cast<std::uint16_t>(1 + i % 630), 2,
                                                               kCaptured_ns / 1000 + 158 * i, points),
                                                     {.port = 6699})});
  return pcap(frames);
}

std::string captured_rs16() {
  MsopPacket packet;
  packet.former = true, packet.legacy_type = 1, packet.type = packet.variant = 0;
  packet.time = big(23, 1) + big(11, 1) + big(14, 1) + big(22, 1) + big(13, 1) + big(20, 1) + big(123, 2) + big(456, 2);
  packet.azimuths = msop_azimuths(35'800, 40);
  return pcap({{kCaptured_ns, ethernet_udp(packet.bytes(), {.port = 6699})}});
}

std::string recorded_lvx(int minor) {
  std::vector<std::string> frames;
  for (std::size_t i = 0; i < 6; ++i) {
    const std::uint64_t time_ns = static_cast<std::uint64_t>(kCaptured_ns) + 50'000'000 * i;
    if (minor < 0)
      frames.push_back(lvx2_package(3, 1, 1, time_ns, numbered_shots(i, 3)) +
                       lvx2_package(3, 1, 2, time_ns, repeated(cartesian({100, 200, 300}, 2, true), 3)));
    else
      frames.push_back(little(0, 1) + (minor == 1 ? sdk1_packet(1, 6, little(time_ns, 8), std::string(24, 'i'))
                                                  : sdk1_packet(1, 0, little(time_ns, 8),
                                                                repeated(metres(1.0f, 2.0f, 3.0f, 4), 100))));
    if (minor == 1) frames.back() += little(0, 1) + sdk1_packet(1, 2, little(time_ns, 8), numbered_shots(i, 96));
  }
  return lvx(minor, {{"47MDL1B0010008", 3, 9}, {"0TFDG3U99102431", 7, 10}}, frames);
}

}  // namespace

std::vector<Sample> recorded_samples() {
  return {{"lidar-capture", "livox", captured_livox()},
          {"lidar-capture", "livox-sdk1", captured_former_livox()},
          {"lidar-capture", "helios", captured_helios()},
          {"lidar-capture", "rs16", captured_rs16()},
          {"lidar-capture", "m1", captured_m1()},
          {"lvx", "1.0", recorded_lvx(0)},
          {"lvx", "1.1", recorded_lvx(1)},
          {"lvx", "2", recorded_lvx(-1)}};
}

}  // namespace remount::formats
