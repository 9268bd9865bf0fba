#include <algorithm>

#include "algorithms/core/error.h"
#include "algorithms/core/index.h"
#include "messages/simulation.h"
#include "model/drive/session_frames.h"
#include "model/formats/documents/document.h"
#include "model/formats/documents/transform_document.h"
#include "model/formats/files/output_file.h"
#include "model/simulator/drive_formats.h"
#include "model/simulator/lidar_model.h"
#include "model/simulator/simulator.h"

namespace remount::simulator {

using formats::DocumentNode;

namespace fs = std::filesystem;

namespace {

/// Options as a map, in the order in which they describe themselves.
struct OptionWriter {
  DocumentNode& map;
  void operator()(const OptionInfo& info, bool value) { map.add(std::string(info.name), DocumentNode::boolean(value)); }
  void operator()(const OptionInfo& info, int value) { map.add(std::string(info.name), DocumentNode::integer(value)); }
  void operator()(const OptionInfo& info, double value) {
    map.add(std::string(info.name), DocumentNode::number(value));
  }
  template <class T>
  void choice(const OptionInfo& info, const T& value, const std::vector<std::string_view>& names) {
    map.add(std::string(info.name), DocumentNode::string(names[index_of(value)]));
  }
};

DocumentNode numbers(const Eigen::Vector3d& v) { return DocumentNode::numbers({v.x(), v.y(), v.z()}); }

void add_sensors(const SimulatedDrive& drive, DocumentNode& root) {
  const SensorTruth& sensors = drive.sensors;
  const drive::Session& session = drive.session;
  root.add("vehicle_from_ins", formats::transform_document(sensors.vehicle_from_ins));
  root.add("vehicle_from_lidar", formats::transform_document(sensors.vehicle_from_ins * drive.ins_from_lidar));
  if (!session.imu.empty()) {
    root.add("ins_from_imu", formats::transform_document(sensors.ins_from_imu));
    DocumentNode& biases = root.add("imu_biases", DocumentNode::map());
    for (const auto& [when, errors] : {std::pair{"start", sensors.imu_at_start}, {"end", sensors.imu_at_end}}) {
      DocumentNode& node = biases.add(when, DocumentNode::map());
      node.add("gyro_radps", numbers(errors.gyro_bias_radps));
      node.add("accelerometer_mps2", numbers(errors.accelerometer_bias_mps2));
    }
  }
  if (!session.gnss.empty()) {
    root.add("antenna_in_ins_m", numbers(sensors.antenna_in_ins_m));
    DocumentNode& outliers = root.add("gnss_outlier_stamps_ns", DocumentNode::sequence());
    for (const std::int64_t stamp_ns : sensors.gnss_outlier_stamps_ns) outliers.add(DocumentNode::integer(stamp_ns));
  }
  if (!session.wheels.empty()) root.add("track_m", DocumentNode::number(sensors.track_m));
}

void add_other_truth(const SimulatedDrive& drive, OtherTruth what, DocumentNode& root) {
  const Eigen::Vector3d& antenna_in_ins_m = drive.sensors.antenna_in_ins_m;
  switch (what) {
    case OtherTruth::None:
      return;
    case OtherTruth::Sensors:
      add_sensors(drive, root);
      return;
    case OtherTruth::AntennaInVehicle:
      root.add("antenna_in_vehicle_m", numbers(drive.sensors.vehicle_from_ins * antenna_in_ins_m));
      return;
    case OtherTruth::AntennaInLidar:
      root.add("antenna_in_lidar_m", numbers(drive.ins_from_lidar.inverse() * antenna_in_ins_m));
      return;
  }
}

DocumentNode numbers_in_degrees(std::vector<double> angles_rad) {
  for (double& angle : angles_rad) angle = radians_to_degrees(angle);
  return DocumentNode::numbers(angles_rad);
}

void add_lidar_errors(const LidarTruth& lidar, DocumentNode& root) {
  if (lidar.perfect()) return;
  DocumentNode& errors = root.add("lidar_errors", DocumentNode::map());
  errors.add("elevation_offset_deg", DocumentNode::number(radians_to_degrees(lidar.elevation_offset_rad)));
  errors.add("range_offset_m", DocumentNode::number(lidar.range_offset_m));
  errors.add("range_scale", DocumentNode::number(lidar.range_scale));
  errors.add("ring_elevation_deg", numbers_in_degrees(lidar.ring_elevation_rad));
  errors.add("ring_range_m", DocumentNode::numbers(lidar.ring_range_m));
}

DocumentNode truth(const SimulatedDrive& drive, const DriveFormat& format) {
  DocumentNode root = DocumentNode::map();
  root.add("format", DocumentNode::string("remount-truth/1"));
  const bool right_forward_up = format.ins_axes == drive::InsAxes::RightForwardUp;
  if (right_forward_up) root.add("ins_axes", DocumentNode::string("right-forward-up"));
  const RigidTransform ins_from_lidar =
      right_forward_up ? drive::forward_left_up_from(drive::InsAxes::RightForwardUp).inverse() * drive.ins_from_lidar
                       : drive.ins_from_lidar;
  DocumentNode& mounting = root.add("ins_from_lidar", formats::transform_document(ins_from_lidar));
  const SixParameters six = six_from_rigid(ins_from_lidar);
  DocumentNode& parameters = mounting.add("six_parameters", DocumentNode::map());
  parameters.on_one_line = true;
  parameters.add("x_m", DocumentNode::number(six.x_m));
  parameters.add("y_m", DocumentNode::number(six.y_m));
  parameters.add("z_m", DocumentNode::number(six.z_m));
  parameters.add("yaw_deg", DocumentNode::number(radians_to_degrees(six.yaw_rad)));
  parameters.add("pitch_deg", DocumentNode::number(radians_to_degrees(six.pitch_rad)));
  parameters.add("roll_deg", DocumentNode::number(radians_to_degrees(six.roll_rad)));
  add_other_truth(drive, format.other_truth, root);
  add_lidar_errors(drive.sensors.lidar, root);
  if (const Scene* scene = scene_of(drive.session.scans)) {
    DocumentNode& options = root.add("simulation", DocumentNode::map());
    SimulationOptions::visit(scene->options(), OptionWriter{options});
  }
  return root;
}

void require_empty(const fs::path& folder) {
  std::error_code failure;
  if (!fs::exists(folder, failure)) return;
  if (!fs::is_directory(folder, failure)) throw Error(ErrorCode::Io, folder.string(), say::simulation_no_folder());
  if (!fs::is_empty(folder, failure) || failure)
    throw Error(ErrorCode::Io, folder.string(), say::simulation_folder_not_empty());
}

}  // namespace

const std::vector<std::string>& drive_formats() {
  static const std::vector<std::string> formats = [] {
    std::vector<std::string> ids;
    for (const DriveFormat& format : drive_format_list()) ids.emplace_back(format.id);
    return ids;
  }();
  return formats;
}

void write_drive(const SimulatedDrive& drive, const fs::path& folder, const std::string& format, int threads,
                 Progress& progress) {
  const std::vector<DriveFormat>& formats = drive_format_list();
  const auto chosen =
      std::find_if(formats.begin(), formats.end(), [&](const DriveFormat& one) { return one.id == format; });
  if (chosen == formats.end()) throw Error(ErrorCode::Contract, format, say::simulation_no_such_format());
  if (chosen->check) chosen->check(drive);
  require_empty(folder);
  formats::make_directories(folder);
  chosen->write(drive, folder, threads, progress);
  if (!progress.cancelled()) formats::write_file(folder / "truth.yaml", formats::to_yaml(truth(drive, *chosen)));
}

}  // namespace remount::simulator
