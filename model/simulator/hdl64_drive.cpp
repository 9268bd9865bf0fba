// An HDL-64E that stands in place of a drive's LiDAR, its packets and its calibration.
#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "model/formats/files/number_text.h"
#include "model/simulator/captured_datagrams.h"
#include "model/simulator/captured_sensor.h"

namespace remount::simulator {

namespace {

constexpr int kHdlLasers = 64, kHdlBlockLasers = 32, kHdlColumns = 6;
constexpr double kHdlColumn_s = 48e-6, kHdlPacket_s = kHdlColumns * kHdlColumn_s;

std::size_t hdl_packets(const SimulationOptions& options) {
  return static_cast<std::size_t>(options.duration_s / kHdlPacket_s);
}

double hdl_begins_s(const SimulationOptions&, std::size_t packet) { return static_cast<double>(packet) * kHdlPacket_s; }

/// A laser of both blocks after another, the fourth of each four a little sooner.
double hdl_fires_after_s(int laser) {
  constexpr double kOfFour_us[] = {0.0, 1.26, 2.46, 3.66};
  const int place = laser % kHdlBlockLasers;
  return 1e-6 * (6.0 * (place / 4) + kOfFour_us[place % 4]);
}

/// How a laser of this sensor was calibrated: degrees and centimetres, as its file has them.
struct HdlLaser {
  double rot_deg, vert_deg, dist_cm, up_cm, aside_cm;
};
HdlLaser hdl_laser(int laser) {
  const bool upper = laser < kHdlBlockLasers;
  const int place = laser % kHdlBlockLasers;
  constexpr double kRot_deg[] = {-4.5, 2.25, -2.25, 4.5};
  return {kRot_deg[place % 4] + 0.0625 * (place % 3), upper ? 2.0 - place / 4.0 * 1.3125 : -8.875 - 0.5 * place,
          110.0 + 0.5 * (laser % 7), upper ? 21.5 - 0.0625 * place : 16.0 - 0.125 * place, laser % 2 == 0 ? 2.5 : -2.5};
}

int hdl_azimuth(const SimulationOptions& options, std::size_t packet, int column) {
  return head_azimuth(options, hdl_begins_s(options, packet) + column * kHdlColumn_s);
}

std::vector<PacketReturn> hdl_returns(const Scene& scene, std::size_t packet) {
  const SimulationOptions& options = scene.options();
  const double begins_s = hdl_begins_s(options, packet);
  const double per_s = head_rate(hdl_azimuth(options, packet, 0), hdl_azimuth(options, packet, kHdlColumns - 1),
                                 (kHdlColumns - 1) * kHdlColumn_s);
  PacketShots shots(scene, packet, begins_s, kHdlLasers);
  for (int column = 0; column < kHdlColumns; ++column)
    for (int laser = 0; laser < kHdlLasers; ++laser) {
      const HdlLaser its = hdl_laser(laser);
      const double after_s = hdl_fires_after_s(laser), time_s = begins_s + column * kHdlColumn_s + after_s;
      const double azimuth_rad =
          degrees_to_radians(0.01 * (hdl_azimuth(options, packet, column) + per_s * after_s) - its.rot_deg);
      const Eigen::Vector3d level = level_direction_clockwise(azimuth_rad), up = Eigen::Vector3d::UnitZ();
      const double up_rad = degrees_to_radians(its.vert_deg);
      // Across the beam: to the left of where it looks, and up.
      const Eigen::Vector3d begins_m =
          0.01 * its.up_cm * (std::cos(up_rad) * up - std::sin(up_rad) * level) + 0.01 * its.aside_cm * up.cross(level);
      if (laser == 0) shots.move_to(time_s);
      shots.fire({column, laser, kHdlLasers - 1 - laser, time_s, level, up_rad, begins_m});
    }
  return shots.take_returns();
}

/// What the sensor says of itself, a byte a packet: here whether it has its receiver's time, and its firmware.
std::string hdl_status(std::size_t packet) { return packet % 2 == 0 ? "GA" : "V\x48"; }

SentDatagram hdl_packet(const Scene& scene, std::size_t packet) {
  constexpr std::size_t kBlockBytes = 100;
  constexpr double kUnit_m = 0.002, kMostUnits = 65535.0;
  constexpr std::int64_t kHour_us = 3'600'000'000, kDelay_ns = 200'000;
  std::string payload;
  for (int block = 0; block < 2 * kHdlColumns; ++block)
    payload += little_bytes(block % 2 == 0 ? 0xeeff : 0xddff, 2) +
               little_bytes(static_cast<std::uint64_t>(hdl_azimuth(scene.options(), packet, block / 2)), 2) +
               std::string(kBlockBytes - 4, '\0');
  for (const PacketReturn& found : hdl_returns(scene, packet)) {
    const auto units = range_units(found.range_m - 0.01 * hdl_laser(found.laser).dist_cm, kUnit_m, kMostUnits);
    if (!units) continue;
    const auto block = static_cast<std::size_t>(2 * found.block + found.laser / kHdlBlockLasers),
               place = static_cast<std::size_t>(found.laser % kHdlBlockLasers);
    payload.replace(block * kBlockBytes + 4 + 3 * place, 3,
                    little_bytes(*units, 2) + little_bytes(light_byte(found.reflectance), 1));
  }
  // It has the time when the packet is complete.
  const std::int64_t stamp_ns = lidar_stamp_ns(scene, hdl_begins_s(scene.options(), packet) + kHdlPacket_s);
  payload += little_bytes(static_cast<std::uint64_t>((stamp_ns + 500) / 1000 % kHour_us), 4) + hdl_status(packet);
  return {stamp_ns + kDelay_ns, 2368, payload};
}

/// "db.xml", as the maker delivers it.
std::string hdl_calibration(const SimulationOptions&) {
  using formats::format_numbers;
  std::string xml =
      "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\" ?>\n<!DOCTYPE boost_serialization>\n"
      "<boost_serialization signature=\"serialization::archive\" version=\"4\">\n"
      "<DB class_id=\"0\" tracking_level=\"1\" version=\"0\" object_id=\"_0\">\n"
      "<distLSB_>0.2</distLSB_>\n<enabled_><count>64</count>";
  for (int laser = 0; laser < kHdlLasers; ++laser) xml += "<item>1</item>";
  xml += "</enabled_>\n<points_><count>64</count>\n";
  for (int laser = 0; laser < kHdlLasers; ++laser) {
    const HdlLaser its = hdl_laser(laser);
    xml += "<item><px><id_>" + std::to_string(laser) + "</id_>";
    for (const auto& [name, value] :
         {std::pair{"rotCorrection_", its.rot_deg}, std::pair{"vertCorrection_", its.vert_deg},
          std::pair{"distCorrection_", its.dist_cm}, std::pair{"distCorrectionX_", 0.0},
          std::pair{"distCorrectionY_", 0.0}, std::pair{"vertOffsetCorrection_", its.up_cm},
          std::pair{"horizOffsetCorrection_", its.aside_cm}, std::pair{"focalDistance_", 0.0},
          std::pair{"focalSlope_", 0.0}})
      xml += std::string("<") + name + ">" + format_numbers("%.10g", value) + "</" + name + ">";
    xml += "</px></item>\n";
  }
  return xml + "</points_>\n</DB>\n</boost_serialization>\n";
}

}  // namespace

const CapturedSensor kHdl64{.format = "velodyne-hdl64",
                            .model = "HDL-64E",
                            .packets = hdl_packets,
                            .begins_s = hdl_begins_s,
                            .returns = hdl_returns,
                            .datagram = hdl_packet,
                            .description = hdl_calibration,
                            .description_ending = ".xml"};

}  // namespace remount::simulator
