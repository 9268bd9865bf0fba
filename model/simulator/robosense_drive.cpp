// An RS-Helios that stands in place of a drive's LiDAR, and its packets.
#include <algorithm>
#include <array>
#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "model/simulator/captured_datagrams.h"
#include "model/simulator/captured_sensor.h"
#include "model/simulator/drive_formats.h"

namespace remount::simulator {

namespace {

constexpr std::uint16_t kMsopPort = 6699, kDifopPort = 7788;
constexpr int kHeliosLasers = 32, kHeliosRounds = 12;
constexpr double kHeliosRound_s = 55.56e-6, kHeliosLaser_s = 1.73e-6;
constexpr double kHeliosPacket_s = kHeliosRounds * kHeliosRound_s;
constexpr double kLens_m = 0.03498;  // from the axis to where beams begin

std::size_t helios_packets(const SimulationOptions& options) {
  return static_cast<std::size_t>(options.duration_s / kHeliosPacket_s);
}

double helios_begins_s(const SimulationOptions&, std::size_t packet) {
  return static_cast<double>(packet) * kHeliosPacket_s;
}

/// Where a laser looks, hundredths of a degree: up, and clockwise from the azimuth of the head.
struct HeliosLaser {
  int elevation = 0, offset = 0;
};

const std::array<HeliosLaser, kHeliosLasers>& helios_lasers() {
  static const std::array<HeliosLaser, kHeliosLasers> lasers = [] {
    constexpr int kElevations[] = {1500,  1300,  1100,  900,   700,   550,   400,   267,   133,   0,     -133,
                                   -267,  -400,  -533,  -667,  -800,  -1000, -1600, -1300, -1900, -2200, -2800,
                                   -2500, -3100, -3400, -3700, -4000, -4300, -4600, -4900, -5200, -5500};
    std::array<HeliosLaser, kHeliosLasers> made;
    for (std::size_t i = 0; i < made.size(); ++i) made[i] = {kElevations[i], i % 2 == 0 ? -403 : 361};
    return made;
  }();
  return lasers;
}

int helios_ring(const HeliosLaser& laser) {
  const auto& lasers = helios_lasers();
  return static_cast<int>(std::count_if(lasers.begin(), lasers.end(),
                                        [&](const HeliosLaser& other) { return other.elevation < laser.elevation; }));
}

/// As the sensor states it of a round of a packet.
int helios_azimuth(const SimulationOptions& options, std::size_t packet, int round) {
  return head_azimuth(options, helios_begins_s(options, packet) + round * kHeliosRound_s);
}

std::vector<PacketReturn> helios_returns(const Scene& scene, std::size_t packet) {
  const SimulationOptions& options = scene.options();
  const double begins_s = helios_begins_s(options, packet);
  const double per_s = head_rate(helios_azimuth(options, packet, 0), helios_azimuth(options, packet, kHeliosRounds - 1),
                                 (kHeliosRounds - 1) * kHeliosRound_s);
  PacketShots shots(scene, packet, begins_s, kHeliosLasers);
  for (int round = 0; round < kHeliosRounds; ++round)
    for (int laser = 0; laser < kHeliosLasers; ++laser) {
      const HeliosLaser& looks = helios_lasers()[static_cast<std::size_t>(laser)];
      const double after_s = laser * kHeliosLaser_s;
      const double time_s = begins_s + round * kHeliosRound_s + after_s;
      const double head_rad = degrees_to_radians(0.01 * (helios_azimuth(options, packet, round) + per_s * after_s));
      const double azimuth_rad = head_rad + degrees_to_radians(0.01 * looks.offset);
      if (laser == 0) shots.move_to(time_s);
      shots.fire({round, laser, helios_ring(looks), time_s, level_direction_clockwise(azimuth_rad),
                  degrees_to_radians(0.01 * looks.elevation), kLens_m * level_direction_clockwise(head_rad)});
    }
  return shots.take_returns();
}

/// Seconds since 1970, and microseconds.
std::string helios_time(std::int64_t stamp_ns) {
  const std::int64_t time_us = (stamp_ns + 500) / 1000;
  return network_bytes(static_cast<std::uint64_t>(time_us / 1'000'000), 6) +
         network_bytes(static_cast<std::uint64_t>(time_us % 1'000'000), 4);
}

SentDatagram msop_packet(const Scene& scene, std::size_t packet) {
  constexpr std::size_t kHead = 42, kBlockBytes = 100;
  constexpr double kUnit_m = 0.0025, kMostUnits = 65535.0;
  const std::int64_t stamp_ns = lidar_stamp_ns(scene, helios_begins_s(scene.options(), packet));
  std::string payload = network_bytes(0x55aa055a, 4) + network_bytes(1, 2) + std::string(14, '\0') +
                        helios_time(stamp_ns) + network_bytes(0x0601, 3);
  payload.resize(kHead);
  for (int round = 0; round < kHeliosRounds; ++round)
    payload += network_bytes(0xffee, 2) +
               network_bytes(static_cast<std::uint64_t>(helios_azimuth(scene.options(), packet, round)), 2) +
               std::string(kBlockBytes - 4, '\0');
  for (const PacketReturn& found : helios_returns(scene, packet)) {
    const auto units = range_units(found.range_m, kUnit_m, kMostUnits);
    if (!units) continue;
    const auto round = static_cast<std::size_t>(found.block), laser = static_cast<std::size_t>(found.laser);
    payload.replace(kHead + round * kBlockBytes + 4 + laser * 3, 3,
                    network_bytes(*units, 2) + network_bytes(light_byte(found.reflectance), 1));
  }
  payload += network_bytes(0x00ff, 6);
  constexpr std::int64_t kDelay_ns = 200'000;  // of the computer that captures
  return {stamp_ns + std::llround(1e9 * kHeliosPacket_s) + kDelay_ns, kMsopPort, payload};
}

std::string angle_bytes(int hundredths) {
  return network_bytes(hundredths < 0 ? 1 : 0, 1) + network_bytes(static_cast<std::uint64_t>(std::abs(hundredths)), 2);
}

/// What the sensor says of itself, with the receiver's sentence.
SentDatagram difop_packet(const motion::InsSample& sample) {
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
  return {sample.stamp_ns, kDifopPort, payload};
}

}  // namespace

const CapturedSensor kHelios{.format = "robosense",
                             .model = "RS-Helios",
                             .packets = helios_packets,
                             .begins_s = helios_begins_s,
                             .returns = helios_returns,
                             .datagram = msop_packet,
                             .told_by_receiver = difop_packet,
                             .samples_between = 10};

}  // namespace remount::simulator
