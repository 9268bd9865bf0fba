// Calibration files of driving stacks: Autoware and Apollo.
#include "algorithms/core/error.h"
#include "messages/exports.h"
#include "model/drive/session_frames.h"
#include "model/formats/documents/parse_document.h"
#include "model/formats/documents/transform_document.h"
#include "model/results/exporters/export_text.h"
#include "model/results/exporters/several_exporter.h"

namespace remount::results {

using formats::DocumentNode;

namespace {

std::string with_header(DocumentNode document, const std::vector<std::string>& header,
                        const std::vector<std::string>& more = {}) {
  for (const std::string& line : header) document.comment += line + "\n";
  for (const std::string& line : more) document.comment += line + "\n";
  return formats::to_yaml(document);
}

class AutowareExporter final : public SeveralExporter {
 public:
  std::string_view id() const override { return "autoware"; }
  Message description() const override { return say::export_autoware(); }
  Message direction() const override { return say::export_direction_autoware(); }
  bool names_frames() const override { return true; }
  std::string_view file_name() const override { return "sensor_kit_calibration.yaml"; }
  int strictness() const override { return 10; }
  std::string write_all(const VehicleFile& vehicle, const ExportNames& names) const override {
    const FrameNames frames = frame_names(vehicle, names, "sensor_kit_base_link", "lidar_base_link", "_base_link");
    DocumentNode root = DocumentNode::map();
    DocumentNode& kit = root.add(frames.parent, DocumentNode::map());
    for (std::size_t l = 0; l < vehicle.lidars.size(); ++l)
      kit.add(frames.lidars[l], sensor_of(vehicle.lidars[l].file.result.mounting.reference_from_sensor));
    std::vector<std::string> more;
    if (names.relative_to.empty())
      more = {"The base link of the sensor kit is taken to be the INS frame: put sensor_kit_base_link there in",
              "sensors_calibration.yaml, or chain its own pose before these numbers."};
    return with_header(root, export_header(*this, vehicle, names), more);
  }
  RigidTransform read(std::string_view text, const std::string& where) const override {
    const std::vector<NamedTransform> sensors = read_all(text, where);
    if (sensors.size() != 1) throw Error(ErrorCode::Format, where, say::mounting_autoware_sensor());
    return sensors.front().ins_from_lidar;
  }
  std::vector<NamedTransform> read_all(std::string_view text, const std::string& where) const override {
    const DocumentNode document = formats::parse_yaml(text, where);
    const auto kits = formats::DocumentView(document, where).entries();
    if (kits.size() != 1) throw Error(ErrorCode::Format, where, say::mounting_autoware_base());
    std::vector<NamedTransform> sensors;
    for (const auto& [name, sensor] : kits.front().second.entries())
      sensors.push_back(
          {name, rigid_from_six({sensor.at("x").number(), sensor.at("y").number(), sensor.at("z").number(),
                                 sensor.at("yaw").number(), sensor.at("pitch").number(), sensor.at("roll").number()})});
    if (sensors.empty()) throw Error(ErrorCode::Format, where, say::mounting_autoware_sensor());
    return sensors;
  }

 private:
  static DocumentNode sensor_of(const RigidTransform& kit_from_sensor) {
    const Eigen::Vector3d t = kit_from_sensor.translation();
    const YawPitchRoll angles = exact_angles(kit_from_sensor.linear());
    DocumentNode sensor = DocumentNode::map();
    sensor.add("x", DocumentNode::number(t.x()));
    sensor.add("y", DocumentNode::number(t.y()));
    sensor.add("z", DocumentNode::number(t.z()));
    sensor.add("roll", DocumentNode::number(angles.roll_rad));
    sensor.add("pitch", DocumentNode::number(angles.pitch_rad));
    sensor.add("yaw", DocumentNode::number(angles.yaw_rad));
    return sensor;
  }
};

/// Says in the data, not only in a comment, which way x points: comments are lost when a program rewrites the file.
/// Apollo reads the keys it knows and leaves this one alone.
constexpr std::string_view kAxesKey = "ins_axes";
constexpr std::string_view kRightForwardUp = "right-forward-up", kAsInResult = "as-in-the-result";

/// Apollo's transform file. Its own "novatel" frame has x right, y forward, z up, as NovAtel's logs have; a result from
/// any other log has x forward, y left, z up. So there are two of these exporters, and each says which axes it has.
class ApolloExporter final : public Exporter {
 public:
  explicit ApolloExporter(bool right_forward_up) : right_forward_up_(right_forward_up) {}

  std::string_view id() const override { return right_forward_up_ ? "apollo-rfu" : "apollo"; }
  Message description() const override { return right_forward_up_ ? say::export_apollo_rfu() : say::export_apollo(); }
  Message direction() const override {
    return right_forward_up_ ? say::export_direction_apollo_rfu() : say::export_direction_apollo();
  }
  std::string_view file_name() const override { return "lidar_novatel_extrinsics.yaml"; }
  // Its own files do not say which axes they have, and are taken as the result's: the other of the two is never tried.
  int strictness() const override { return right_forward_up_ ? 0 : 50; }

  std::string write(const ResultFile& result, const ExportNames& names) const override {
    if (right_forward_up_ && result.ins_axes == drive::InsAxes::RightForwardUp)
      throw Error(ErrorCode::Contract, "apollo-rfu", say::export_axes_are_rfu());
    if (right_forward_up_ && !result.ins_axes)
      throw Error(ErrorCode::Contract, "apollo-rfu", say::export_axes_not_known());
    const RigidTransform axes_from_ins =
        right_forward_up_ ? rfu_from_flu() * drive::forward_left_up_from(result.ins_axes) : RigidTransform::Identity();
    const RigidTransform x = axes_from_ins * result.result.mounting.reference_from_sensor;
    const Eigen::Quaterniond q = formats::canonical_quaternion(x.linear());
    DocumentNode root = DocumentNode::map();
    DocumentNode& header = root.add("header", DocumentNode::map());
    header.add("seq", DocumentNode::integer(0));
    DocumentNode& stamp = header.add("stamp", DocumentNode::map());
    stamp.add("secs", DocumentNode::integer(0));
    stamp.add("nsecs", DocumentNode::integer(0));
    header.add("frame_id", DocumentNode::string(names.ins_frame.empty() ? "novatel" : names.ins_frame));
    DocumentNode& transform = root.add("transform", DocumentNode::map());
    add_vector(transform.add("translation", DocumentNode::map()), {"x", "y", "z"},
               {x.translation().x(), x.translation().y(), x.translation().z()});
    add_vector(transform.add("rotation", DocumentNode::map()), {"x", "y", "z", "w"}, {q.x(), q.y(), q.z(), q.w()});
    root.add("child_frame_id", DocumentNode::string(names.lidar_frame.empty() ? "lidar" : names.lidar_frame));
    const bool right_forward_up = right_forward_up_ || result.ins_axes == drive::InsAxes::RightForwardUp;
    root.add(std::string(kAxesKey), DocumentNode::string(right_forward_up ? kRightForwardUp : kAsInResult));
    return with_header(root, export_header(*this, result),
                       {right_forward_up ? "The numbers below are in axes x right, y forward, z up, as Apollo's own."
                                         : "Apollo's own novatel frame has x right, y forward, z up: use apollo-rfu "
                                           "unless the log has these axes too."});
  }

  RigidTransform read(std::string_view text, const std::string& where) const override {
    const DocumentNode document = formats::parse_yaml(text, where);
    const formats::DocumentView root(document, where), transform = root.at("transform");
    const formats::DocumentView t = transform.at("translation"), q = transform.at("rotation");
    const RigidTransform x =
        rigid_from_quaternion({t.at("x").number(), t.at("y").number(), t.at("z").number()},
                              {q.at("x").number(), q.at("y").number(), q.at("z").number(), q.at("w").number()}, where);
    return (is_right_forward_up(root) ? rfu_from_flu().inverse() : RigidTransform::Identity()) * x;
  }

  std::optional<drive::InsAxes> axes(std::string_view text) const override {
    const DocumentNode document = formats::parse_yaml(text, "");
    return is_right_forward_up(formats::DocumentView(document, "")) ? std::optional(drive::InsAxes::ForwardLeftUp)
                                                                    : std::nullopt;
  }

  Message doubt(std::string_view text) const override {
    if (text.find(kAxesKey) != std::string_view::npos) return {};
    return say::mounting_apollo_axes(Angle{degrees_to_radians(90.0)});
  }

 private:
  /// Of a file; one that does not say has the axes of the format's name.
  bool is_right_forward_up(const formats::DocumentView& root) const {
    return root.has(kAxesKey) ? root.at(kAxesKey).choice({kAsInResult, kRightForwardUp}) == 1 : right_forward_up_;
  }
  static RigidTransform rfu_from_flu() { return drive::forward_left_up_from(drive::InsAxes::RightForwardUp).inverse(); }
  static void add_vector(DocumentNode& map, const std::vector<std::string>& keys, const std::vector<double>& values) {
    for (std::size_t i = 0; i < keys.size(); ++i) map.add(keys[i], DocumentNode::number(values[i]));
  }

  bool right_forward_up_;
};

}  // namespace

std::unique_ptr<Exporter> make_autoware_exporter() { return std::make_unique<AutowareExporter>(); }
std::unique_ptr<Exporter> make_apollo_exporter() { return std::make_unique<ApolloExporter>(false); }
std::unique_ptr<Exporter> make_apollo_rfu_exporter() { return std::make_unique<ApolloExporter>(true); }

}  // namespace remount::results
