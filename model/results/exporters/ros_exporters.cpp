// ROS: static transforms of both generations, and a URDF joint. All three give the pose of the child (the LiDAR) in
// the parent (the INS), which is ins_from_lidar.
#include <array>

#include "algorithms/core/error.h"
#include "messages/exports.h"
#include "model/formats/documents/transform_document.h"
#include "model/formats/files/input_file.h"
#include "model/results/exporters/export_text.h"

namespace remount::results {
namespace {

std::string xml_escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

/// Two hyphens in a row would end or break an XML comment.
std::string xml_header(const Exporter& exporter, const ResultFile& result) {
  std::vector<std::string> lines = export_header(exporter, result);
  for (std::string& line : lines)
    for (std::size_t at; (at = line.find("--")) != std::string::npos;) line.replace(at, 2, "- -");
  return comment_out(lines, "  <!-- ", " -->");
}

std::string ins_name(const ExportNames& names) { return names.ins_frame.empty() ? "ins_link" : names.ins_frame; }
std::string lidar_name(const ExportNames& names) {
  return names.lidar_frame.empty() ? "lidar_link" : names.lidar_frame;
}

std::vector<double> translation_of(const ResultFile& result) {
  const Eigen::Vector3d t = result.result.mounting.reference_from_sensor.translation();
  return {t.x(), t.y(), t.z()};
}

std::vector<double> quaternion_of(const ResultFile& result) {
  const Eigen::Quaterniond q = formats::canonical_quaternion(result.result.mounting.reference_from_sensor.linear());
  return {q.x(), q.y(), q.z(), q.w()};
}

class Ros1Exporter final : public Exporter {
 public:
  std::string_view id() const override { return "ros1"; }
  Message description() const override { return say::export_ros1(); }
  Message direction() const override { return say::export_direction_ros(); }
  std::string_view file_name() const override { return "lidar_static_transform.launch"; }
  int strictness() const override { return 70; }
  std::string write(const ResultFile& result, const ExportNames& names) const override {
    return "<launch>\n" + xml_header(*this, result) + "  <!-- args: x y z qx qy qz qw frame_id child_frame_id -->\n" +
           "  <node pkg=\"tf2_ros\" type=\"static_transform_publisher\" name=\"ins_from_lidar\" args=\"" +
           join(translation_of(result)) + " " + join(quaternion_of(result)) + " " + xml_escaped(ins_name(names)) + " " +
           xml_escaped(lidar_name(names)) + "\"/>\n</launch>\n";
  }
  RigidTransform read(std::string_view text, const std::string& where) const override {
    const std::string xml = without_xml_comments(text);
    const std::string arguments = attribute(xml, "args", xml.find("static_transform_publisher"), where);
    std::vector<std::string_view> tokens;
    formats::split_blanks(arguments, tokens);
    if (tokens.size() < 9) throw Error(ErrorCode::Format, where, say::mounting_ros1_arguments());
    std::vector<double> numbers;
    for (std::size_t i = 0; i < 7; ++i) numbers.push_back(formats::require_number(tokens[i], "args", where, 1));
    return rigid_from_quaternion({numbers.begin(), numbers.begin() + 3}, {numbers.begin() + 3, numbers.end()}, where);
  }
};

class Ros2Exporter final : public Exporter {
 public:
  std::string_view id() const override { return "ros2"; }
  Message description() const override { return say::export_ros2(); }
  Message direction() const override { return say::export_direction_ros(); }
  std::string_view file_name() const override { return "lidar_static_transform.launch.xml"; }
  int strictness() const override { return 80; }
  std::string write(const ResultFile& result, const ExportNames& names) const override {
    static constexpr std::array<std::string_view, 7> kFlags{"--x ",   " --y ",  " --z ", " --qx ",
                                                            " --qy ", " --qz ", " --qw "};
    std::vector<double> numbers = translation_of(result);
    for (const double value : quaternion_of(result)) numbers.push_back(value);
    std::string arguments;
    for (std::size_t i = 0; i < 7; ++i) arguments += std::string(kFlags[i]) + formats::shortest(numbers[i]);
    return "<launch>\n" + xml_header(*this, result) +
           "  <node pkg=\"tf2_ros\" exec=\"static_transform_publisher\" name=\"ins_from_lidar\" args=\"" + arguments +
           " --frame-id " + xml_escaped(ins_name(names)) + " --child-frame-id " + xml_escaped(lidar_name(names)) +
           "\"/>\n</launch>\n";
  }
  RigidTransform read(std::string_view text, const std::string& where) const override {
    const std::string xml = without_xml_comments(text);
    const std::string arguments = attribute(xml, "args", xml.find("static_transform_publisher"), where);
    std::vector<std::string_view> tokens;
    formats::split_blanks(arguments, tokens);
    const auto value = [&](std::string_view flag) {
      for (std::size_t i = 0; i + 1 < tokens.size(); ++i)
        if (tokens[i] == flag) return formats::require_number(tokens[i + 1], flag, where, 1);
      throw Error(ErrorCode::Format, where, say::mounting_ros2_argument(std::string(flag)));
    };
    return rigid_from_quaternion({value("--x"), value("--y"), value("--z")},
                                 {value("--qx"), value("--qy"), value("--qz"), value("--qw")}, where);
  }
};

class UrdfExporter final : public Exporter {
 public:
  std::string_view id() const override { return "urdf"; }
  Message description() const override { return say::export_urdf(); }
  Message direction() const override { return say::export_direction_ros(); }
  std::string_view file_name() const override { return "lidar_joint.urdf"; }
  int strictness() const override { return 60; }
  std::string write(const ResultFile& result, const ExportNames& names) const override {
    const YawPitchRoll angles = exact_angles(result.result.mounting.reference_from_sensor.linear());
    return "<robot name=\"remount\">\n" + xml_header(*this, result) +
           "  <!-- rpy in radians: R = Rz(yaw) Ry(pitch) Rx(roll) -->\n" + "  <link name=\"" +
           xml_escaped(ins_name(names)) + "\"/>\n  <link name=\"" + xml_escaped(lidar_name(names)) + "\"/>\n" +
           "  <joint name=\"ins_from_lidar\" type=\"fixed\">\n    <parent link=\"" + xml_escaped(ins_name(names)) +
           "\"/>\n    <child link=\"" + xml_escaped(lidar_name(names)) + "\"/>\n    <origin xyz=\"" +
           join(translation_of(result)) + "\" rpy=\"" + join({angles.roll_rad, angles.pitch_rad, angles.yaw_rad}) +
           "\"/>\n  </joint>\n</robot>\n";
  }
  RigidTransform read(std::string_view text, const std::string& where) const override {
    const std::string xml = without_xml_comments(text);
    const std::size_t origin = xml.find("<origin", xml.find("<joint"));
    const std::vector<double> xyz = numbers_in(attribute(xml, "xyz", origin, where), where);
    const std::vector<double> rpy = numbers_in(attribute(xml, "rpy", origin, where), where);
    if (xyz.size() != 3 || rpy.size() != 3) throw Error(ErrorCode::Format, where, say::mounting_urdf_numbers());
    return rigid_from_six({xyz[0], xyz[1], xyz[2], rpy[2], rpy[1], rpy[0]});
  }
};

}  // namespace

std::unique_ptr<Exporter> make_ros1_exporter() { return std::make_unique<Ros1Exporter>(); }
std::unique_ptr<Exporter> make_ros2_exporter() { return std::make_unique<Ros2Exporter>(); }
std::unique_ptr<Exporter> make_urdf_exporter() { return std::make_unique<UrdfExporter>(); }

}  // namespace remount::results
