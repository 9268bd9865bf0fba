// The network packets of a PandarXT-32, as somebody captured them beside an INS's log, with the sensor's angles.
#include <cmath>
#include <ctime>

#include "algorithms/core/parallel.h"
#include "model/formats/files/number_text.h"
#include "model/formats/files/output_file.h"
#include "model/simulator/captured_datagrams.h"
#include "model/simulator/drive_formats.h"
#include "model/simulator/hesai_spinner.h"

namespace remount::simulator {

namespace fs = std::filesystem;

namespace {

constexpr std::uint16_t kBlocksPort = 2368;
/// From when the sensor is told to fire a block, which its stamp is of, to the time of that block.
constexpr std::int64_t kTrigger_ns = 5'632;

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

std::string blocks_packet(const Scene& scene, std::size_t packet) {
  constexpr std::size_t kHeadBytes = 12, kUnitBytes = 4, kBlockBytes = 2 + kSpinnerChannels * kUnitBytes;
  constexpr double kUnit_m = 0.004, kMostUnits = 65535.0;
  std::string payload = little_bytes(0xffee, 2) + little_bytes(6, 1) + little_bytes(1, 1) + little_bytes(0, 2) +
                        little_bytes(kSpinnerChannels, 1) + little_bytes(kSpinnerBlocks, 1) + little_bytes(0, 1) +
                        little_bytes(4, 1) + little_bytes(1, 1) + little_bytes(1, 1);
  for (int block = 0; block < kSpinnerBlocks; ++block)
    payload += little_bytes(static_cast<std::uint64_t>(spinner_azimuth(scene.options(), packet, block)), 2) +
               std::string(kBlockBytes - 2, '\0');
  for (const SpinnerReturn& found : spinner_returns(scene, packet)) {
    const double units = std::round(found.range_m / kUnit_m);
    if (units < 1.0 || units > kMostUnits) continue;
    const auto block = static_cast<std::size_t>(found.block), channel = static_cast<std::size_t>(found.channel);
    const auto light = static_cast<std::uint64_t>(std::lround(255.0 * std::min(1.0f, found.reflectance)));
    payload.replace(kHeadBytes + block * kBlockBytes + 2 + channel * kUnitBytes, 3,
                    little_bytes(static_cast<std::uint64_t>(units), 2) + little_bytes(light, 1));
  }
  const double last_s = static_cast<double>(packet + 1) * kSpinnerPacket_s - kSpinnerBlock_s;
  const std::int64_t stamp_ns = lidar_stamp_ns(scene, last_s) - kTrigger_ns;
  const std::int64_t stamp_us = (stamp_ns + 500) / 1000 % 1'000'000;
  payload += std::string(10, '\0') + little_bytes(0x37, 1) +
             little_bytes(static_cast<std::uint64_t>(spinner_speed_rpm(scene.options())), 2) +
             date_bytes(stamp_ns + 500) + little_bytes(static_cast<std::uint64_t>(stamp_us), 4) +
             little_bytes(0x42, 1) + little_bytes(packet, 4);
  constexpr std::int64_t kDelay_ns = 250'000;  // of the computer that captures, from the last block on
  return captured_datagram(stamp_ns + kDelay_ns, kBlocksPort, payload);
}

/// As the sensor gives it.
std::string spinner_angles() {
  std::string table = "Laser id,Elevation,Azimuth\n";
  for (int channel = 0; channel < kSpinnerChannels; ++channel)
    table += std::to_string(channel + 1) + "," + formats::exact_text(spinner_elevation_deg(channel)) + "," +
             formats::exact_text(spinner_azimuth_deg(channel)) + "\n";
  return table;
}

}  // namespace

void write_hesai_drive(const SimulatedDrive& drive, const fs::path& folder, int threads, Progress& progress) {
  const Scene& scene = scene_of_capture(drive, "hesai", "PandarXT-32");
  std::vector<std::string> packets(spinner_packets(scene.options()));
  parallel_for(packets.size(), threads, [&](std::size_t packet) {
    if (!progress.cancelled()) packets[packet] = blocks_packet(scene, packet);
  });
  std::string capture = capture_head();
  for (const std::string& packet : packets) capture += packet;
  const std::string log = nmea_log(drive.session, progress);
  if (progress.cancelled()) return;
  formats::write_file(folder / "capture.pcap", capture);
  formats::write_file(folder / "capture.csv", spinner_angles());
  formats::write_file(folder / "receiver.nmea", log);
}

}  // namespace remount::simulator
