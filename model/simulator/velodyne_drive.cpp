// The network packets of a VLP-16, as somebody captured them beside an INS's log.
#include <cmath>

#include "algorithms/core/parallel.h"
#include "messages/stages.h"
#include "model/formats/files/output_file.h"
#include "model/simulator/captured_datagrams.h"
#include "model/simulator/drive_formats.h"
#include "model/simulator/puck.h"

namespace remount::simulator {

namespace fs = std::filesystem;

namespace {

constexpr std::uint16_t kPointsPort = 2368, kPositionPort = 8308;

/// Microseconds past the hour, as the receiver gives it.
std::uint32_t past_the_hour_us(std::int64_t stamp_ns) {
  constexpr std::int64_t kHour_us = 3'600'000'000;
  return static_cast<std::uint32_t>((stamp_ns + 500) / 1000 % kHour_us);
}

std::string points_packet(const Scene& scene, std::size_t packet) {
  constexpr std::size_t kBlockBytes = 100, kBlocksOfPuck = kPuckFiringsInPacket / 2;
  constexpr double kUnit_m = 0.002, kMostUnits = 65535.0;
  std::string payload;
  for (std::size_t block = 0; block < kBlocksOfPuck; ++block)
    payload +=
        little_bytes(0xeeff, 2) +
        little_bytes(static_cast<std::uint64_t>(puck_block_azimuth(scene.options(), packet, static_cast<int>(block))),
                     2) +
        std::string(kBlockBytes - 4, '\0');
  for (const PuckReturn& found : puck_returns(scene, packet)) {
    const double units = std::round(found.range_m / kUnit_m);
    if (units < 1.0 || units > kMostUnits) continue;
    const auto firing = static_cast<std::size_t>(found.firing), laser = static_cast<std::size_t>(found.laser);
    const auto light = static_cast<std::uint64_t>(std::lround(255.0 * std::min(1.0f, found.reflectance)));
    payload.replace(firing / 2 * kBlockBytes + 4 + 3 * (firing % 2 * kPuckLasers + laser), 3,
                    little_bytes(static_cast<std::uint64_t>(units), 2) + little_bytes(light, 1));
  }
  const std::int64_t stamp_ns = lidar_stamp_ns(scene, static_cast<double>(packet) * kPuckPacket_s);
  constexpr std::int64_t kDelay_ns = 200'000;  // of the computer that captures
  payload += little_bytes(past_the_hour_us(stamp_ns), 4) + little_bytes(0x37, 1) + little_bytes(0x22, 1);
  return captured_datagram(stamp_ns + std::llround(1e9 * kPuckPacket_s) + kDelay_ns, kPointsPort, payload);
}

/// With the sentence of the receiver, whose pulse the sensor follows.
std::string position_packet(const motion::InsSample& sample) {
  std::string payload(512, '\0');
  payload.replace(0xc6, 4, little_bytes(past_the_hour_us(sample.stamp_ns), 4));
  payload[0xca] = 2;
  const std::string sentence = nmea_minimum(sample);
  payload.replace(0xce, sentence.size(), sentence);
  return captured_datagram(sample.stamp_ns, kPositionPort, payload);
}

}  // namespace

void write_velodyne_drive(const SimulatedDrive& drive, const fs::path& folder, int threads, Progress& progress) {
  const Scene& scene = scene_of_capture(drive, "velodyne", "VLP-16");
  std::vector<std::string> packets(puck_packets(scene.options()));
  parallel_for(packets.size(), threads, [&](std::size_t packet) {
    if (!progress.cancelled()) packets[packet] = points_packet(scene, packet);
  });
  constexpr std::size_t kPositionsApart = 50;  // samples of the INS
  const std::vector<motion::InsSample>& ins = drive.session.ins;
  std::size_t position = 0;
  std::string capture = capture_head();
  for (std::size_t packet = 0; packet < packets.size(); ++packet) {
    const std::int64_t stamp_ns = lidar_stamp_ns(scene, static_cast<double>(packet) * kPuckPacket_s);
    for (; position < ins.size() && ins[position].stamp_ns < stamp_ns; position += kPositionsApart)
      capture += position_packet(ins[position]);
    capture += packets[packet];
  }
  const std::string log = nmea_log(drive.session, progress);
  if (progress.cancelled()) return;
  formats::write_file(folder / "capture.pcap", capture);
  formats::write_file(folder / "receiver.nmea", log);
}

}  // namespace remount::simulator
