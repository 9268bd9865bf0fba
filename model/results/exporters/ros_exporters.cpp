// ROS: static transforms of both generations, and a URDF joint. All three give the pose of the child (the LiDAR) in
// the parent (the INS), which is ins_from_lidar.
#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "algorithms/core/error.h"
#include "messages/exports.h"
#include "messages/rig.h"
#include "model/formats/documents/transform_document.h"
#include "model/formats/files/input_file.h"
#include "model/results/exporters/export_text.h"
#include "model/results/exporters/several_exporter.h"

namespace remount::results {
namespace {

/// Two hyphens in a row would end or break an XML comment.
std::string xml_header(const Exporter& exporter, const VehicleFile& vehicle, const ExportNames& names) {
  std::vector<std::string> lines = export_header(exporter, vehicle, names);
  for (std::string& line : lines)
    for (std::size_t at; (at = line.find("--")) != std::string::npos;) line.replace(at, 2, "- -");
  return comment_out(lines, "  <!-- ", " -->");
}

FrameNames ros_frames(const VehicleFile& vehicle, const ExportNames& names) {
  return frame_names(vehicle, names, "ins_link", "lidar_link");
}

std::vector<double> translation_of(const ResultFile& result) {
  const Eigen::Vector3d t = result.result.mounting.reference_from_sensor.translation();
  return {t.x(), t.y(), t.z()};
}

std::vector<double> quaternion_of(const ResultFile& result) {
  const Eigen::Quaterniond q = formats::canonical_quaternion(result.result.mounting.reference_from_sensor.linear());
  return {q.x(), q.y(), q.z(), q.w()};
}

struct StaticTransform {
  std::string parent, child;
  RigidTransform parent_from_child = RigidTransform::Identity();
};

/// Of each transform the one that places its parent; nothing where no other does, or the file names no parent.
std::vector<std::optional<std::size_t>> places_of_parents(const std::vector<StaticTransform>& transforms) {
  std::map<std::string_view, std::size_t> places;
  for (std::size_t i = 0; i < transforms.size(); ++i) places.emplace(transforms[i].child, i);
  std::vector<std::optional<std::size_t>> above(transforms.size());
  for (std::size_t i = 0; i < transforms.size(); ++i) {
    const auto parent = places.find(transforms[i].parent);
    if (parent != places.end() && !transforms[i].parent.empty()) above[i] = parent->second;
  }
  return above;
}

/// Frames that are placed in others of the file are taken to the frame that is placed in none. Throws Error(Format)
/// where there is no such frame, and where there are more than any vehicle has.
std::vector<NamedTransform> from_the_root(const std::vector<StaticTransform>& transforms, const std::string& where) {
  constexpr std::size_t kMost = 4096;
  if (transforms.size() > kMost)
    throw Error(ErrorCode::Format, where, say::mounting_too_many_frames(transforms.size(), kMost));
  const std::vector<std::optional<std::size_t>> above = places_of_parents(transforms);
  std::vector<NamedTransform> placed;
  for (std::size_t i = 0; i < transforms.size(); ++i) {
    RigidTransform root_from_child = transforms[i].parent_from_child;
    std::size_t steps = 0;
    for (std::optional<std::size_t> parent = above[i]; parent; parent = above[*parent]) {
      // More steps than there are transforms: some frame is met twice.
      if (++steps >= transforms.size())
        throw Error(ErrorCode::Format, where, say::mounting_frames_in_a_circle(transforms[*parent].child));
      root_from_child = transforms[*parent].parent_from_child * root_from_child;
    }
    placed.push_back({transforms[i].child, root_from_child});
  }
  return placed;
}

/// Those nodes of a launch file that publish a static transform; none is an error.
std::vector<std::string_view> publishers(std::string_view xml, const std::string& where) {
  std::vector<std::string_view> nodes = xml_elements(xml, "node");
  std::erase_if(nodes, [](std::string_view node) { return node.find("static_transform_publisher") == node.npos; });
  if (nodes.empty()) throw Error(ErrorCode::Format, where, say::mounting_attribute("args"));
  return nodes;
}

/// A launch file: a node for each LiDAR, which differ between the generations of ROS.
class LaunchExporter : public SeveralExporter {
 public:
  Message direction() const override { return say::export_direction_ros(); }
  bool names_frames() const override { return true; }
  std::string write_all(const VehicleFile& vehicle, const ExportNames& names) const override {
    const FrameNames frames = ros_frames(vehicle, names);
    const std::vector<std::string> transforms = transform_names(vehicle, names);
    std::string text = "<launch>\n" + xml_header(*this, vehicle, names) + remark();
    for (std::size_t l = 0; l < vehicle.lidars.size(); ++l) {
      const LidarResult& lidar = vehicle.lidars[l];
      text += "  <node pkg=\"tf2_ros\" " + std::string(program()) + "=\"static_transform_publisher\" name=\"" +
              transforms[l] + "\" args=\"" +
              arguments(lidar.file, xml_escaped(frames.parent), xml_escaped(frames.lidars[l])) + "\"/>\n";
    }
    return text + "</launch>\n";
  }
  RigidTransform read(std::string_view text, const std::string& where) const override {
    const std::string xml = without_xml_comments(text);
    return transform_in(publishers(xml, where).front(), where).parent_from_child;
  }
  std::vector<NamedTransform> read_all(std::string_view text, const std::string& where) const override {
    const std::string xml = without_xml_comments(text);
    std::vector<StaticTransform> transforms;
    for (const std::string_view node : publishers(xml, where)) transforms.push_back(transform_in(node, where));
    return from_the_root(transforms, where);
  }

 protected:
  virtual std::string_view program() const = 0;  ///< the attribute that names the program of a node
  virtual std::string remark() const { return {}; }
  virtual std::string arguments(const ResultFile& result, const std::string& parent,
                                const std::string& child) const = 0;
  virtual StaticTransform transform_of(const std::vector<std::string_view>& arguments,
                                       const std::string& where) const = 0;

 private:
  StaticTransform transform_in(std::string_view node, const std::string& where) const {
    const std::string arguments = attribute(node, "args", 0, where);
    std::vector<std::string_view> tokens;
    formats::split_blanks(arguments, tokens);
    StaticTransform transform = transform_of(tokens, where);
    transform.parent = xml_unescaped(transform.parent), transform.child = xml_unescaped(transform.child);
    return transform;
  }
};

class Ros1Exporter final : public LaunchExporter {
 public:
  std::string_view id() const override { return "ros1"; }
  Message description() const override { return say::export_ros1(); }
  std::string_view file_name() const override { return "lidar_static_transform.launch"; }
  int strictness() const override { return 70; }

 private:
  std::string_view program() const override { return "type"; }
  std::string remark() const override { return "  <!-- args: x y z qx qy qz qw frame_id child_frame_id -->\n"; }
  std::string arguments(const ResultFile& result, const std::string& parent, const std::string& child) const override {
    return join(translation_of(result)) + " " + join(quaternion_of(result)) + " " + parent + " " + child;
  }
  StaticTransform transform_of(const std::vector<std::string_view>& tokens, const std::string& where) const override {
    if (tokens.size() < 9) throw Error(ErrorCode::Format, where, say::mounting_ros1_arguments());
    std::vector<double> numbers;
    for (std::size_t i = 0; i < 7; ++i) numbers.push_back(formats::require_number(tokens[i], "args", where, 1));
    return {std::string(tokens[7]), std::string(tokens[8]),
            rigid_from_quaternion({numbers.begin(), numbers.begin() + 3}, {numbers.begin() + 3, numbers.end()}, where)};
  }
};

class Ros2Exporter final : public LaunchExporter {
 public:
  std::string_view id() const override { return "ros2"; }
  Message description() const override { return say::export_ros2(); }
  std::string_view file_name() const override { return "lidar_static_transform.launch.xml"; }
  int strictness() const override { return 80; }

 private:
  std::string_view program() const override { return "exec"; }
  std::string arguments(const ResultFile& result, const std::string& parent, const std::string& child) const override {
    static constexpr std::array<std::string_view, 7> kFlags{"--x ",   " --y ",  " --z ", " --qx ",
                                                            " --qy ", " --qz ", " --qw "};
    std::vector<double> numbers = translation_of(result);
    for (const double value : quaternion_of(result)) numbers.push_back(value);
    std::string arguments;
    for (std::size_t i = 0; i < 7; ++i) arguments += std::string(kFlags[i]) + formats::shortest(numbers[i]);
    return arguments + " --frame-id " + parent + " --child-frame-id " + child;
  }
  StaticTransform transform_of(const std::vector<std::string_view>& tokens, const std::string& where) const override {
    const auto text_of = [&](std::string_view flag) {
      for (std::size_t i = 0; i + 1 < tokens.size(); ++i)
        if (tokens[i] == flag) return tokens[i + 1];
      return std::string_view();
    };
    const auto value = [&](std::string_view flag) {
      if (text_of(flag).empty()) throw Error(ErrorCode::Format, where, say::mounting_ros2_argument(std::string(flag)));
      return formats::require_number(text_of(flag), flag, where, 1);
    };
    return {std::string(text_of("--frame-id")), std::string(text_of("--child-frame-id")),
            rigid_from_quaternion({value("--x"), value("--y"), value("--z")},
                                  {value("--qx"), value("--qy"), value("--qz"), value("--qw")}, where)};
  }
};

class UrdfExporter final : public SeveralExporter {
 public:
  std::string_view id() const override { return "urdf"; }
  Message description() const override { return say::export_urdf(); }
  Message direction() const override { return say::export_direction_ros(); }
  bool names_frames() const override { return true; }
  std::string_view file_name() const override { return "lidar_joint.urdf"; }
  int strictness() const override { return 60; }
  std::string write_all(const VehicleFile& vehicle, const ExportNames& names) const override {
    const FrameNames frames = ros_frames(vehicle, names);
    const std::vector<std::string> transforms = transform_names(vehicle, names);
    std::string links = "  <link name=\"" + xml_escaped(frames.parent) + "\"/>\n", joints;
    for (std::size_t l = 0; l < vehicle.lidars.size(); ++l) {
      const LidarResult& lidar = vehicle.lidars[l];
      const YawPitchRoll angles = exact_angles(lidar.file.result.mounting.reference_from_sensor.linear());
      links += "  <link name=\"" + xml_escaped(frames.lidars[l]) + "\"/>\n";
      joints += "  <joint name=\"" + transforms[l] + "\" type=\"fixed\">\n    <parent link=\"" +
                xml_escaped(frames.parent) + "\"/>\n    <child link=\"" + xml_escaped(frames.lidars[l]) +
                "\"/>\n    <origin xyz=\"" + join(translation_of(lidar.file)) + "\" rpy=\"" +
                join({angles.roll_rad, angles.pitch_rad, angles.yaw_rad}) + "\"/>\n  </joint>\n";
    }
    return "<robot name=\"remount\">\n" + xml_header(*this, vehicle, names) +
           "  <!-- rpy in radians: R = Rz(yaw) Ry(pitch) Rx(roll) -->\n" + links + joints + "</robot>\n";
  }
  RigidTransform read(std::string_view text, const std::string& where) const override {
    const std::string xml = without_xml_comments(text);
    return origin_of(xml, xml.find("<joint"), where);
  }
  std::vector<NamedTransform> read_all(std::string_view text, const std::string& where) const override {
    const std::string xml = without_xml_comments(text);
    std::vector<StaticTransform> transforms;
    for (std::size_t at = joint_at(xml, 0), next = 0; at != std::string::npos; at = next) {
      next = joint_at(xml, at + 1);
      std::string_view joint = std::string_view(xml).substr(at, next == std::string::npos ? next : next - at);
      joint = joint.substr(0, joint.find("</joint>"));
      if (find_attribute(joint, "type", 0) != "fixed") continue;  // what moves places no LiDAR
      const bool at_the_parent = joint.find("<origin") == std::string::npos;
      transforms.push_back({xml_unescaped(attribute(joint, "link", joint.find("<parent"), where)),
                            xml_unescaped(attribute(joint, "link", joint.find("<child"), where)),
                            at_the_parent ? RigidTransform::Identity() : origin_of(joint, 0, where)});
    }
    if (transforms.empty()) throw Error(ErrorCode::Format, where, say::mounting_attribute("xyz"));
    return from_the_root(transforms, where);
  }

 private:
  /// The next joint that has attributes: "<joint>" stands in other elements, and names one.
  static std::size_t joint_at(std::string_view xml, std::size_t from) {
    constexpr std::string_view kOpening = "<joint";
    std::size_t at = xml.find(kOpening, from);
    while (at != std::string_view::npos) {
      const std::size_t behind = at + kOpening.size();
      if (behind < xml.size() && std::string_view(" \t\r\n").find(xml[behind]) != std::string_view::npos) return at;
      at = xml.find(kOpening, behind);
    }
    return at;
  }
  static RigidTransform origin_of(std::string_view xml, std::size_t from, const std::string& where) {
    const std::size_t origin = xml.find("<origin", from);
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
