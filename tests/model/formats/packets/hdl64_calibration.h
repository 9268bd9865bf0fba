// Calibrations of an HDL-64E as tests need them.
#pragma once

#include <functional>
#include <string>

namespace remount::formats {

/// Of a laser: degrees and centimetres.
struct Hdl64Laser {
  double rot_deg = 0.0, vert_deg = 0.0, dist_cm = 0.0, near_x_cm = 0.0, near_y_cm = 0.0, up_cm = 0.0, aside_cm = 0.0;
};
using Hdl64Lasers = std::function<Hdl64Laser(int laser)>;

inline std::string hdl64_xml(const Hdl64Lasers& laser_of, int lasers = 64) {
  std::string xml =
      "<?xml version=\"1.0\"?>\n<boost_serialization><DB class_id=\"0\"><distLSB_>0.2</distLSB_><points_>\n";
  for (int i = 0; i < lasers; ++i) {
    const Hdl64Laser laser = laser_of(i);
    const auto field = [](const char* name, double value) {
      return "<" + std::string(name) + ">" + std::to_string(value) + "</" + name + ">";
    };
    xml += "<item><px><id_>" + std::to_string(i) + "</id_>" + field("rotCorrection_", laser.rot_deg) +
           field("vertCorrection_", laser.vert_deg) + field("distCorrection_", laser.dist_cm) +
           field("distCorrectionX_", laser.near_x_cm) + field("distCorrectionY_", laser.near_y_cm) +
           field("vertOffsetCorrection_", laser.up_cm) + field("horizOffsetCorrection_", laser.aside_cm) +
           "</px></item>\n";
  }
  return xml + "</points_></DB></boost_serialization>\n";
}

inline std::string hdl64_yaml(const Hdl64Lasers& laser_of) {
  constexpr double kRadian = 3.14159265358979323846 / 180.0;
  std::string yaml = "lasers:\n";
  for (int i = 0; i < 64; ++i) {
    const Hdl64Laser laser = laser_of(i);
    char line[400];
    std::snprintf(line, sizeof line,
                  "- {dist_correction: %.9f, dist_correction_x: %.9f, dist_correction_y: %.9f, laser_id: %d,\n"
                  "  horiz_offset_correction: %.9f, rot_correction: %.9f, vert_correction: %.9f, "
                  "vert_offset_correction: %.9f, two_pt_correction_available: true}\n",
                  0.01 * laser.dist_cm, 0.01 * laser.near_x_cm, 0.01 * laser.near_y_cm, i, 0.01 * laser.aside_cm,
                  kRadian * laser.rot_deg, kRadian * laser.vert_deg, 0.01 * laser.up_cm);
    yaml += line;
  }
  return yaml + "num_lasers: 64\ndistance_resolution: 0.002\n";
}

}  // namespace remount::formats
