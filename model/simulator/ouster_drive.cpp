// The network packets of an Ouster OS1, as somebody captured them beside an INS's log, with the sensor's metadata.
#include <cmath>

#include "algorithms/core/parallel.h"
#include "model/formats/documents/document.h"
#include "model/formats/files/output_file.h"
#include "model/simulator/captured_datagrams.h"
#include "model/simulator/drive_formats.h"
#include "model/simulator/ouster_head.h"

namespace remount::simulator {

namespace fs = std::filesystem;

namespace {

using formats::DocumentNode;

constexpr std::uint16_t kColumnsPort = 7502;
constexpr std::uint64_t kHeadSerial = 122'201'000'998, kHeadStart = 7'109'750;
constexpr std::size_t kPixelBytes = 12, kColumnBytes = 12 + kHeadBeams * kPixelBytes, kEndBytes = 32;
/// PTP counts without leap seconds.
constexpr std::int64_t kTaiAhead_ns = 37'000'000'000;

std::string column_head(const Scene& scene, std::size_t packet, int column) {
  const std::int64_t stamp_ns = lidar_stamp_ns(scene, head_column_time_s(scene.options(), packet, column));
  const std::size_t place = packet * kHeadColumnsInPacket % kHeadColumns + static_cast<std::size_t>(column);
  constexpr std::uint64_t kValid = 1;
  return little_bytes(static_cast<std::uint64_t>(stamp_ns + kTaiAhead_ns), 8) + little_bytes(place, 2) +
         little_bytes(kValid, 2);
}

std::string columns_packet(const Scene& scene, std::size_t packet) {
  constexpr double kUnit_m = 0.001, kMostUnits = 0x7ffff;
  constexpr std::uint64_t kPoints = 1, kFrames = 65536;
  const std::uint64_t frame = packet * kHeadColumnsInPacket / kHeadColumns % kFrames;
  std::string payload = little_bytes(kPoints, 2) + little_bytes(frame, 2) + little_bytes(kHeadStart, 3) +
                        little_bytes(kHeadSerial, 5) + std::string(kEndBytes - 12, '\0');
  for (int column = 0; column < kHeadColumnsInPacket; ++column)
    payload += column_head(scene, packet, column) + std::string(kHeadBeams * kPixelBytes, '\0');
  for (const HeadReturn& found : head_returns(scene, packet)) {
    const double units = std::round(found.range_m / kUnit_m);
    if (units < 1.0 || units > kMostUnits) continue;
    const auto column = static_cast<std::size_t>(found.column), beam = static_cast<std::size_t>(found.beam);
    const auto light = static_cast<std::uint64_t>(std::lround(255.0 * std::min(1.0f, found.reflectance)));
    payload.replace(kEndBytes + column * kColumnBytes + 12 + beam * kPixelBytes, 5,
                    little_bytes(static_cast<std::uint64_t>(units), 4) + little_bytes(light, 1));
  }
  payload += std::string(kEndBytes, '\0');
  constexpr std::int64_t kDelay_ns = 200'000;  // of the computer that captures
  const double complete_s = head_column_time_s(scene.options(), packet + 1, 0);
  return captured_datagram(lidar_stamp_ns(scene, complete_s) + kDelay_ns, kColumnsPort, payload);
}

DocumentNode transform_row_by_row(double turned_about_z, double ahead_mm, double above_mm) {
  return DocumentNode::numbers(
      {turned_about_z, 0, 0, ahead_mm, 0, turned_about_z, 0, 0, 0, 0, 1, above_mm, 0, 0, 0, 1});
}

/// As the sensor gives it.
std::string head_metadata(const SimulationOptions& options) {
  std::vector<double> elevations, azimuths;
  for (int beam = 0; beam < kHeadBeams; ++beam) {
    elevations.push_back(head_elevation_deg(beam));
    azimuths.push_back(head_azimuth_deg(beam));
  }
  const double ahead_mm = std::round(1e6 * kHeadBeamsAhead_m) / 1e3, above_mm = std::round(1e6 * kHeadHeight_m) / 1e3;
  DocumentNode root = DocumentNode::map();
  DocumentNode& info = root.add("sensor_info", DocumentNode::map());
  info.add("prod_line", DocumentNode::string("OS-1-32"));
  info.add("prod_sn", DocumentNode::string(std::to_string(kHeadSerial)));
  info.add("initialization_id", DocumentNode::integer(kHeadStart));
  DocumentNode& beams = root.add("beam_intrinsics", DocumentNode::map());
  beams.add("beam_altitude_angles", DocumentNode::numbers(elevations));
  beams.add("beam_azimuth_angles", DocumentNode::numbers(azimuths));
  beams.add("lidar_origin_to_beam_origin_mm", DocumentNode::number(ahead_mm));
  beams.add("beam_to_lidar_transform", transform_row_by_row(1, ahead_mm, 0));
  root.add("lidar_intrinsics", DocumentNode::map())
      .add("lidar_to_sensor_transform", transform_row_by_row(-1, 0, above_mm));
  DocumentNode& format = root.add("lidar_data_format", DocumentNode::map());
  format.add("udp_profile_lidar", DocumentNode::string("RNG19_RFL8_SIG16_NIR16"));
  format.add("columns_per_frame", DocumentNode::integer(kHeadColumns));
  format.add("columns_per_packet", DocumentNode::integer(kHeadColumnsInPacket));
  format.add("pixels_per_column", DocumentNode::integer(kHeadBeams));
  format.add("column_window", DocumentNode::numbers({0.0, kHeadColumns - 1.0}));
  DocumentNode& config = root.add("config_params", DocumentNode::map());
  config.add("lidar_mode", DocumentNode::string(std::to_string(kHeadColumns) + "x" +
                                                std::to_string(std::lround(options.scan_rate_hz))));
  config.add("timestamp_mode", DocumentNode::string("TIME_FROM_PTP_1588"));
  config.add("udp_port_lidar", DocumentNode::integer(kColumnsPort));
  return formats::to_json(root);
}

}  // namespace

void write_ouster_drive(const SimulatedDrive& drive, const fs::path& folder, int threads, Progress& progress) {
  const Scene& scene = scene_of_capture(drive, "ouster", "OS1");
  std::vector<std::string> packets(head_packets(scene.options()));
  parallel_for(packets.size(), threads, [&](std::size_t packet) {
    if (!progress.cancelled()) packets[packet] = columns_packet(scene, packet);
  });
  std::string capture = capture_head();
  for (const std::string& packet : packets) capture += packet;
  const std::string log = nmea_log(drive.session, progress);
  if (progress.cancelled()) return;
  formats::write_file(folder / "capture.pcap", capture);
  formats::write_file(folder / "capture.json", head_metadata(scene.options()));
  formats::write_file(folder / "receiver.nmea", log);
}

}  // namespace remount::simulator
