// An Ouster OS1 with 32 beams that stands in place of a drive's LiDAR, its packets, and its metadata.
#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "model/formats/documents/document.h"
#include "model/simulator/captured_datagrams.h"
#include "model/simulator/captured_sensor.h"

namespace remount::simulator {

namespace {

using formats::DocumentNode;

constexpr std::uint16_t kColumnsPort = 7502;
constexpr std::uint64_t kHeadSerial = 122'201'000'998, kHeadStart = 7'109'750;
constexpr int kHeadBeams = 32, kHeadColumns = 1024, kHeadColumnsInPacket = 16;  // beam 0 is the highest
constexpr int kPacketsInTurn = kHeadColumns / kHeadColumnsInPacket;
/// Of the head above the housing's frame, and of where beams begin ahead of the head's axis.
constexpr double kHeadHeight_m = 0.03618, kHeadBeamsAhead_m = 0.015806;
constexpr std::size_t kPixelBytes = 12, kColumnBytes = 12 + kHeadBeams * kPixelBytes, kEndBytes = 32;
/// PTP counts without leap seconds.
constexpr std::int64_t kTaiAhead_ns = 37'000'000'000;

/// Nearly even, as those that were measured are.
double head_elevation_deg(int beam) { return 21.0 - 1.36 * beam + 0.02 * (beam % 3); }

/// The beams come from four columns of lasers. Clockwise, beside the encoder's angle.
double head_azimuth_deg(int beam) {
  constexpr double kColumns_deg[] = {4.23, 1.41, -1.42, -4.22};
  return kColumns_deg[beam % 4];
}

std::size_t head_packets(const SimulationOptions& options) {
  return static_cast<std::size_t>(std::floor(options.duration_s * options.scan_rate_hz * kPacketsInTurn + 1e-6));
}

/// Of a column of a packet, since the start of the drive.
double head_column_time_s(const SimulationOptions& options, std::size_t packet, int column) {
  const double columns = static_cast<double>(packet) * kHeadColumnsInPacket + column;
  return columns / (kHeadColumns * options.scan_rate_hz);
}

double head_begins_s(const SimulationOptions& options, std::size_t packet) {
  return head_column_time_s(options, packet, 0);
}

/// In the frame of the housing: x ahead, y left, z up.
std::vector<PacketReturn> head_returns(const Scene& scene, std::size_t packet) {
  const SimulationOptions& options = scene.options();
  PacketShots shots(scene, packet, head_begins_s(options, packet), kHeadBeams);
  for (int column = 0; column < kHeadColumnsInPacket; ++column) {
    const double time_s = head_column_time_s(options, packet, column);
    shots.move_to(time_s);
    const int place = static_cast<int>(packet % kPacketsInTurn) * kHeadColumnsInPacket + column;
    // At encoder 0 beams look to the back of the housing; it counts clockwise.
    const double clockwise_deg = 180.0 + 360.0 * place / kHeadColumns;
    const auto level = [](double deg) { return level_direction_clockwise(degrees_to_radians(deg)); };
    const Eigen::Vector3d begins_m =
        kHeadBeamsAhead_m * level(clockwise_deg) + kHeadHeight_m * Eigen::Vector3d::UnitZ();
    for (int beam = 0; beam < kHeadBeams; ++beam)
      shots.fire({column, beam, kHeadBeams - 1 - beam, time_s, level(clockwise_deg + head_azimuth_deg(beam)),
                  degrees_to_radians(head_elevation_deg(beam)), begins_m});
  }
  return shots.take_returns();
}

std::string column_head(const Scene& scene, std::size_t packet, int column) {
  const std::int64_t stamp_ns = lidar_stamp_ns(scene, head_column_time_s(scene.options(), packet, column));
  const std::size_t place = packet * kHeadColumnsInPacket % kHeadColumns + static_cast<std::size_t>(column);
  constexpr std::uint64_t kValid = 1;
  return little_bytes(static_cast<std::uint64_t>(stamp_ns + kTaiAhead_ns), 8) + little_bytes(place, 2) +
         little_bytes(kValid, 2);
}

SentDatagram columns_packet(const Scene& scene, std::size_t packet) {
  constexpr double kUnit_m = 0.001, kMostUnits = 0x7ffff;
  constexpr std::uint64_t kPoints = 1, kFrames = 65536;
  const std::uint64_t frame = packet * kHeadColumnsInPacket / kHeadColumns % kFrames;
  std::string payload = little_bytes(kPoints, 2) + little_bytes(frame, 2) + little_bytes(kHeadStart, 3) +
                        little_bytes(kHeadSerial, 5) + std::string(kEndBytes - 12, '\0');
  for (int column = 0; column < kHeadColumnsInPacket; ++column)
    payload += column_head(scene, packet, column) + std::string(kHeadBeams * kPixelBytes, '\0');
  for (const PacketReturn& found : head_returns(scene, packet)) {
    const auto units = range_units(found.range_m + kHeadBeamsAhead_m, kUnit_m, kMostUnits);  // from the axis
    if (!units) continue;
    const auto column = static_cast<std::size_t>(found.block), beam = static_cast<std::size_t>(found.laser);
    payload.replace(kEndBytes + column * kColumnBytes + 12 + beam * kPixelBytes, 5,
                    little_bytes(*units, 4) + little_bytes(light_byte(found.reflectance), 1));
  }
  payload += std::string(kEndBytes, '\0');
  constexpr std::int64_t kDelay_ns = 200'000;  // of the computer that captures
  const double complete_s = head_begins_s(scene.options(), packet + 1);
  return {lidar_stamp_ns(scene, complete_s) + kDelay_ns, kColumnsPort, payload};
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

const CapturedSensor kOusterHead{.format = "ouster",
                                 .model = "OS1",
                                 .packets = head_packets,
                                 .begins_s = head_begins_s,
                                 .returns = head_returns,
                                 .datagram = columns_packet,
                                 .description = head_metadata,
                                 .description_ending = ".json"};

}  // namespace remount::simulator
