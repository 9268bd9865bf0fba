// A VLP-16 that stands in place of a drive's LiDAR, and its packets.
#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "model/simulator/captured_datagrams.h"
#include "model/simulator/captured_sensor.h"
#include "model/simulator/drive_formats.h"

namespace remount::simulator {

namespace {

constexpr std::uint16_t kPointsPort = 2368, kPositionPort = 8308;
constexpr int kPuckLasers = 16, kPuckFirings = 24, kPuckBlocks = kPuckFirings / 2;
constexpr double kPuckFiring_s = 55.296e-6, kPuckLaser_s = 2.304e-6;
constexpr double kPuckPacket_s = kPuckFirings * kPuckFiring_s;

std::size_t puck_packets(const SimulationOptions& options) {
  return static_cast<std::size_t>(options.duration_s / kPuckPacket_s);
}

double puck_begins_s(const SimulationOptions&, std::size_t packet) {
  return static_cast<double>(packet) * kPuckPacket_s;
}

/// The even ones look down from -15 degrees, the odd ones up from 1, in steps of 2.
int puck_elevation_deg(int laser) { return laser % 2 == 0 ? laser - 15 : laser; }

/// Beams cross ahead of the sensor's axis: the lowest begins highest.
double puck_beam_height_m(int elevation) {
  constexpr double kMm[] = {0.7, 2.2, 3.7, 5.1, 6.6, 8.1, 9.7, 11.2};  // of 1, 3, ... 15 degrees
  const double mm = kMm[(std::abs(elevation) - 1) / 2];
  return elevation > 0 ? -1e-3 * mm : 1e-3 * mm;
}

/// As the sensor states it of one of the 12 blocks of a packet, each of two firings.
int puck_azimuth(const SimulationOptions& options, std::size_t packet, int block) {
  return head_azimuth(options, puck_begins_s(options, packet) + 2 * block * kPuckFiring_s);
}

std::vector<PacketReturn> puck_returns(const Scene& scene, std::size_t packet) {
  const SimulationOptions& options = scene.options();
  const double begins_s = puck_begins_s(options, packet);
  const double per_s = head_rate(puck_azimuth(options, packet, 0), puck_azimuth(options, packet, kPuckBlocks - 1),
                                 2.0 * (kPuckBlocks - 1) * kPuckFiring_s);
  PacketShots shots(scene, packet, begins_s, kPuckLasers);
  for (int firing = 0; firing < kPuckFirings; ++firing)
    for (int laser = 0; laser < kPuckLasers; ++laser) {
      const int up_deg = puck_elevation_deg(laser);
      const double after_s = firing % 2 * kPuckFiring_s + laser * kPuckLaser_s;
      const double time_s = begins_s + firing * kPuckFiring_s + laser * kPuckLaser_s;
      const double azimuth_rad =
          degrees_to_radians(0.01 * (puck_azimuth(options, packet, firing / 2) + per_s * after_s));
      if (laser == 0) shots.move_to(time_s);
      shots.fire({firing, laser, (up_deg + 15) / 2, time_s, level_direction_clockwise(azimuth_rad),
                  degrees_to_radians(up_deg), puck_beam_height_m(up_deg) * Eigen::Vector3d::UnitZ()});
    }
  return shots.take_returns();
}

/// Microseconds past the hour, as the receiver gives it.
std::uint32_t past_the_hour_us(std::int64_t stamp_ns) {
  constexpr std::int64_t kHour_us = 3'600'000'000;
  return static_cast<std::uint32_t>((stamp_ns + 500) / 1000 % kHour_us);
}

SentDatagram points_packet(const Scene& scene, std::size_t packet) {
  constexpr std::size_t kBlockBytes = 100;
  constexpr double kUnit_m = 0.002, kMostUnits = 65535.0;
  std::string payload;
  for (int block = 0; block < kPuckBlocks; ++block)
    payload += little_bytes(0xeeff, 2) +
               little_bytes(static_cast<std::uint64_t>(puck_azimuth(scene.options(), packet, block)), 2) +
               std::string(kBlockBytes - 4, '\0');
  for (const PacketReturn& found : puck_returns(scene, packet)) {
    const auto units = range_units(found.range_m, kUnit_m, kMostUnits);
    if (!units) continue;
    const auto firing = static_cast<std::size_t>(found.block), laser = static_cast<std::size_t>(found.laser);
    payload.replace(firing / 2 * kBlockBytes + 4 + 3 * (firing % 2 * kPuckLasers + laser), 3,
                    little_bytes(*units, 2) + little_bytes(light_byte(found.reflectance), 1));
  }
  const std::int64_t stamp_ns = lidar_stamp_ns(scene, puck_begins_s(scene.options(), packet));
  constexpr std::int64_t kDelay_ns = 200'000;  // of the computer that captures
  payload += little_bytes(past_the_hour_us(stamp_ns), 4) + little_bytes(0x37, 1) + little_bytes(0x22, 1);
  return {stamp_ns + std::llround(1e9 * kPuckPacket_s) + kDelay_ns, kPointsPort, payload};
}

/// With the sentence of the receiver, whose pulse the sensor follows.
SentDatagram position_packet(const motion::InsSample& sample) {
  std::string payload(512, '\0');
  payload.replace(0xc6, 4, little_bytes(past_the_hour_us(sample.stamp_ns), 4));
  payload[0xca] = 2;
  const std::string sentence = nmea_minimum(sample);
  payload.replace(0xce, sentence.size(), sentence);
  return {sample.stamp_ns, kPositionPort, payload};
}

}  // namespace

const CapturedSensor kPuck{.format = "velodyne",
                           .model = "VLP-16",
                           .packets = puck_packets,
                           .begins_s = puck_begins_s,
                           .returns = puck_returns,
                           .datagram = points_packet,
                           .told_by_receiver = position_packet,
                           .samples_between = 50};

}  // namespace remount::simulator
