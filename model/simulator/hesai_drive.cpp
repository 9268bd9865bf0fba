// A PandarXT-32 that stands in place of a drive's LiDAR, its packets, and the table of its angles.
#include <cmath>
#include <ctime>

#include "algorithms/geometry/rotation.h"
#include "model/formats/files/number_text.h"
#include "model/simulator/captured_datagrams.h"
#include "model/simulator/captured_sensor.h"

namespace remount::simulator {

namespace {

constexpr std::uint16_t kBlocksPort = 2368;
constexpr int kSpinnerChannels = 32, kSpinnerBlocks = 8;  // channel 0 is the highest
constexpr double kSpinnerBlock_s = 50e-6, kSpinnerPacket_s = kSpinnerBlocks * kSpinnerBlock_s;
/// From when the sensor is told to fire a block, which its stamp is of, to the time of that block.
constexpr std::int64_t kTrigger_ns = 5'632;

/// As they were measured of this one, azimuths clockwise.
double spinner_elevation_deg(int channel) { return 15.0 - channel + 0.03 * (channel % 4); }
double spinner_azimuth_deg(int channel) { return 0.05 * (channel % 5) - 0.08; }

/// When channels fire, from the time of their block on.
double spinner_fires_after_s(int channel) { return 0.368e-6 + 1.512e-6 * channel; }

std::size_t spinner_packets(const SimulationOptions& options) {
  return static_cast<std::size_t>(options.duration_s / kSpinnerPacket_s);
}

double spinner_begins_s(const SimulationOptions&, std::size_t packet) {
  return static_cast<double>(packet) * kSpinnerPacket_s;
}

double block_time_s(const SimulationOptions& options, std::size_t packet, int block) {
  return spinner_begins_s(options, packet) + block * kSpinnerBlock_s;
}

/// As the sensor states it of a block of a packet, clockwise from y.
int spinner_azimuth(const SimulationOptions& options, std::size_t packet, int block) {
  return head_azimuth(options, block_time_s(options, packet, block));
}

/// As the sensor states it.
int spinner_speed_rpm(const SimulationOptions& options) {
  return static_cast<int>(std::lround(60.0 * options.scan_rate_hz));
}

/// The sensor's x is to the right, y ahead.
std::vector<PacketReturn> spinner_returns(const Scene& scene, std::size_t packet) {
  const SimulationOptions& options = scene.options();
  const double deg_per_s = 6.0 * spinner_speed_rpm(options);
  PacketShots shots(scene, packet, spinner_begins_s(options, packet), kSpinnerChannels);
  for (int block = 0; block < kSpinnerBlocks; ++block)
    for (int channel = 0; channel < kSpinnerChannels; ++channel) {
      const double time_s = block_time_s(options, packet, block) + spinner_fires_after_s(channel);
      const double azimuth_rad =
          degrees_to_radians(0.01 * spinner_azimuth(options, packet, block) + spinner_azimuth_deg(channel) +
                             deg_per_s * spinner_fires_after_s(channel));
      if (channel == 0) shots.move_to(time_s);
      shots.fire({.block = block,
                  .laser = channel,
                  .ring = kSpinnerChannels - 1 - channel,
                  .time_s = time_s,
                  .level_direction = {std::sin(azimuth_rad), std::cos(azimuth_rad), 0.0},
                  .elevation_rad = degrees_to_radians(spinner_elevation_deg(channel))});
    }
  return shots.take_returns();
}

/// Year since 1900, month, day, hour, minute, second.
std::string date_bytes(std::int64_t stamp_ns) {
  const std::time_t seconds = stamp_ns / 1'000'000'000;
  std::tm date{};
  gmtime_r(&seconds, &date);
  std::string bytes;
  for (const int number : {date.tm_year, date.tm_mon + 1, date.tm_mday, date.tm_hour, date.tm_min, date.tm_sec})
    bytes += little_bytes(static_cast<std::uint64_t>(number), 1);
  return bytes;
}

SentDatagram blocks_packet(const Scene& scene, std::size_t packet) {
  constexpr std::size_t kHeadBytes = 12, kUnitBytes = 4, kBlockBytes = 2 + kSpinnerChannels * kUnitBytes;
  constexpr double kUnit_m = 0.004, kMostUnits = 65535.0;
  std::string payload = little_bytes(0xffee, 2) + little_bytes(6, 1) + little_bytes(1, 1) + little_bytes(0, 2) +
                        little_bytes(kSpinnerChannels, 1) + little_bytes(kSpinnerBlocks, 1) + little_bytes(0, 1) +
                        little_bytes(4, 1) + little_bytes(1, 1) + little_bytes(1, 1);
  for (int block = 0; block < kSpinnerBlocks; ++block)
    payload += little_bytes(static_cast<std::uint64_t>(spinner_azimuth(scene.options(), packet, block)), 2) +
               std::string(kBlockBytes - 2, '\0');
  for (const PacketReturn& found : spinner_returns(scene, packet)) {
    const auto units = range_units(found.range_m, kUnit_m, kMostUnits);
    if (!units) continue;
    const auto block = static_cast<std::size_t>(found.block), channel = static_cast<std::size_t>(found.laser);
    payload.replace(kHeadBytes + block * kBlockBytes + 2 + channel * kUnitBytes, 3,
                    little_bytes(*units, 2) + little_bytes(light_byte(found.reflectance), 1));
  }
  const double last_s = spinner_begins_s(scene.options(), packet + 1) - kSpinnerBlock_s;
  const std::int64_t stamp_ns = lidar_stamp_ns(scene, last_s) - kTrigger_ns;
  const std::int64_t stamp_us = (stamp_ns + 500) / 1000 % 1'000'000;
  payload += std::string(10, '\0') + little_bytes(0x37, 1) +
             little_bytes(static_cast<std::uint64_t>(spinner_speed_rpm(scene.options())), 2) +
             date_bytes(stamp_ns + 500) + little_bytes(static_cast<std::uint64_t>(stamp_us), 4) +
             little_bytes(0x42, 1) + little_bytes(packet, 4);
  constexpr std::int64_t kDelay_ns = 250'000;  // of the computer that captures, from the last block on
  return {stamp_ns + kDelay_ns, kBlocksPort, payload};
}

/// As the sensor gives it.
std::string spinner_angles(const SimulationOptions&) {
  std::string table = "Laser id,Elevation,Azimuth\n";
  for (int channel = 0; channel < kSpinnerChannels; ++channel)
    table += std::to_string(channel + 1) + "," + formats::exact_text(spinner_elevation_deg(channel)) + "," +
             formats::exact_text(spinner_azimuth_deg(channel)) + "\n";
  return table;
}

}  // namespace

const CapturedSensor kHesaiSpinner{.format = "hesai",
                                   .model = "PandarXT-32",
                                   .packets = spinner_packets,
                                   .begins_s = spinner_begins_s,
                                   .returns = spinner_returns,
                                   .datagram = blocks_packet,
                                   .description = spinner_angles,
                                   .description_ending = ".csv"};

}  // namespace remount::simulator
