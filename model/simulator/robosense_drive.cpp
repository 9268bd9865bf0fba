// The network packets of an RS-Helios, as somebody captured them beside an INS's log.
#include <cmath>

#include "algorithms/core/parallel.h"
#include "model/formats/files/output_file.h"
#include "model/simulator/captured_datagrams.h"
#include "model/simulator/drive_formats.h"
#include "model/simulator/helios.h"

namespace remount::simulator {

namespace fs = std::filesystem;

namespace {

constexpr std::uint16_t kMsopPort = 6699, kDifopPort = 7788;

/// Seconds since 1970, and microseconds.
std::string helios_time(std::int64_t stamp_ns) {
  const std::int64_t time_us = (stamp_ns + 500) / 1000;
  return network_bytes(static_cast<std::uint64_t>(time_us / 1'000'000), 6) +
         network_bytes(static_cast<std::uint64_t>(time_us % 1'000'000), 4);
}

std::string msop_packet(const Scene& scene, std::size_t packet) {
  constexpr std::size_t kHead = 42, kBlockBytes = 100;
  constexpr double kUnit_m = 0.0025, kMostUnits = 65535.0;
  const std::int64_t stamp_ns = lidar_stamp_ns(scene, static_cast<double>(packet) * kHeliosPacket_s);
  std::string payload = network_bytes(0x55aa055a, 4) + network_bytes(1, 2) + std::string(14, '\0') +
                        helios_time(stamp_ns) + network_bytes(0x0601, 3);
  payload.resize(kHead);
  for (int round = 0; round < kHeliosRoundsInPacket; ++round)
    payload += network_bytes(0xffee, 2) +
               network_bytes(static_cast<std::uint64_t>(helios_azimuth(scene.options(), packet, round)), 2) +
               std::string(kBlockBytes - 4, '\0');
  for (const HeliosReturn& found : helios_returns(scene, packet)) {
    const double units = std::round(found.range_m / kUnit_m);
    if (units < 1.0 || units > kMostUnits) continue;
    const auto light = static_cast<std::uint64_t>(std::lround(255.0 * std::min(1.0f, found.reflectance)));
    payload.replace(
        kHead + static_cast<std::size_t>(found.round) * kBlockBytes + 4 + static_cast<std::size_t>(found.laser) * 3, 3,
        network_bytes(static_cast<std::uint64_t>(units), 2) + network_bytes(light, 1));
  }
  payload += network_bytes(0x00ff, 6);
  constexpr std::int64_t kDelay_ns = 200'000;  // of the computer that captures
  return captured_datagram(stamp_ns + std::llround(1e9 * kHeliosPacket_s) + kDelay_ns, kMsopPort, payload);
}

std::string angle_bytes(int hundredths) {
  return network_bytes(hundredths < 0 ? 1 : 0, 1) + network_bytes(static_cast<std::uint64_t>(std::abs(hundredths)), 2);
}

/// What the sensor says of itself, with the receiver's sentence.
std::string difop_packet(const motion::InsSample& sample) {
  constexpr std::uint8_t kStrongest = 4, kSynchronised = 1;
  std::string payload(1248, '\0');
  payload.replace(0, 8, network_bytes(0xa5ff005a11115555, 8));
  payload[300] = kStrongest;
  payload[302] = kSynchronised;
  payload.replace(303, 10, helios_time(sample.stamp_ns));
  const std::string sentence = nmea_minimum(sample);
  payload.replace(382, sentence.size(), sentence);
  for (std::size_t i = 0; i < helios_lasers().size(); ++i) {
    payload.replace(468 + 3 * i, 3, angle_bytes(helios_lasers()[i].elevation));
    payload.replace(564 + 3 * i, 3, angle_bytes(helios_lasers()[i].offset));
  }
  payload.replace(1246, 2, network_bytes(0x0ff0, 2));
  return captured_datagram(sample.stamp_ns, kDifopPort, payload);
}

}  // namespace

void write_robosense_drive(const SimulatedDrive& drive, const fs::path& folder, int threads, Progress& progress) {
  const Scene& scene = scene_of_capture(drive, "robosense", "RS-Helios");
  std::vector<std::string> packets(helios_packets(scene.options()));
  parallel_for(packets.size(), threads, [&](std::size_t packet) {
    if (!progress.cancelled()) packets[packet] = msop_packet(scene, packet);
  });
  constexpr std::size_t kDescriptionsApart = 10;  // samples of the INS
  const std::vector<motion::InsSample>& ins = drive.session.ins;
  std::size_t described = 0;
  std::string capture = capture_head();
  for (std::size_t packet = 0; packet < packets.size(); ++packet) {
    const std::int64_t stamp_ns = lidar_stamp_ns(scene, static_cast<double>(packet) * kHeliosPacket_s);
    for (; described < ins.size() && ins[described].stamp_ns < stamp_ns; described += kDescriptionsApart)
      capture += difop_packet(ins[described]);
    capture += packets[packet];
  }
  const std::string log = nmea_log(drive.session, progress);
  if (progress.cancelled()) return;
  formats::write_file(folder / "capture.pcap", capture);
  formats::write_file(folder / "receiver.nmea", log);
}

}  // namespace remount::simulator
