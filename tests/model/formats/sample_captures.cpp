#include "tests/model/formats/sample_captures.h"

#include <vector>

#include "tests/model/formats/packets/capture_bytes.h"
#include "tests/model/formats/packets/livox_bytes.h"
#include "tests/model/formats/packets/robosense_bytes.h"

namespace remount::formats::samples {

namespace {

constexpr std::int64_t kCaptured_ns = 1'700'000'000'000'000'000;

/// A few packets of a LiDAR and of the receiver it hangs on.
std::vector<TimedFrame> captured_frames() {
  std::vector<TimedFrame> frames = vlp16_drive(8, kCaptured_ns, 800e6);
  const std::string sentence = "$GPRMC,221320.00,A,4846.8000,N,00910.8000,E,0.0,0.0,141123,,,A*6F\r\n";
  frames.push_back({kCaptured_ns + 1, ethernet_udp(position_packet(sentence, 2), {.port = 8308})});
  const std::string datagram = frames[0].bytes.substr(14 + 20);
  frames.push_back({kCaptured_ns + 2, ethernet(ipv4(datagram.substr(0, 800), {.id = 3}, 0, true), {0x8100})});
  frames.push_back({kCaptured_ns + 3, ethernet(ipv4(datagram.substr(800), {.id = 3}, 800))});
  return frames;
}

}  // namespace

Bytes captured_velodyne() { return pcap(captured_frames()); }

Bytes captured_helios() { return pcap(helios_drive(4, kCaptured_ns, kCaptured_ns / 1000)); }

Bytes captured_pcapng() {
  Bytes file = pcapng_section(true) + pcapng_interface(true, 9);
  for (const TimedFrame& frame : captured_frames())
    file += pcapng_packet(frame.bytes, static_cast<std::uint64_t>(frame.time_ns), true);
  return file;
}

/// Few shots a packet, so that many packets are short.
Bytes captured_livox() {
  std::vector<TimedFrame> frames;
  for (std::size_t i = 0; i < 12; ++i) {
    const auto time_ns = static_cast<std::uint64_t>(kCaptured_ns) + 30'000'000 * i;
    const std::string points = i % 2 == 0 ? numbered_shots(i, 4) : repeated(spherical({9'000, 6'000, 3'000}, true), 4);
    frames.push_back({static_cast<std::int64_t>(time_ns) + 400'000,
                      ethernet_udp(sdk2_packet(1, i % 2 == 0 ? 1 : 3, time_ns, 200, 4, points), {.port = 56301})});
  }
  return pcap(frames);
}

Bytes captured_former_livox() {
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

Bytes captured_m1() {
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

Bytes captured_rs16() {
  MsopPacket packet;
  packet.former = true, packet.legacy_type = 1, packet.type = packet.variant = 0;
  packet.time = big(23, 1) + big(11, 1) + big(14, 1) + big(22, 1) + big(13, 1) + big(20, 1) + big(123, 2) + big(456, 2);
  packet.azimuths = block_azimuths(35'800, 40);
  return pcap({{kCaptured_ns, ethernet_udp(packet.bytes(), {.port = 6699})}});
}

Bytes recorded_lvx(int minor) {
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

}  // namespace remount::formats::samples
