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
  bool (*wanted)(std::string_view name) = [](std::string_view) { return true; };
  void operator()(const OptionInfo& info, bool value) { add(info, DocumentNode::boolean(value)); }
  void operator()(const OptionInfo& info, int value) { add(info, DocumentNode::integer(value)); }
  void operator()(const OptionInfo& info, double value) { add(info, DocumentNode::number(value)); }
  template <class T>
  void choice(const OptionInfo& info, const T& value, const std::vector<std::string_view>& names) {
    add(info, DocumentNode::string(names[index_of(value)]));
  }
  void add(const OptionInfo& info, DocumentNode value) const {
    if (wanted(info.name)) map.add(std::string(info.name), std::move(value));
  }
};

DocumentNode numbers(const Eigen::Vector3d& v) { return DocumentNode::numbers({v.x(), v.y(), v.z()}); }

/// What `add_mounting` has not said.
void add_sensors(const SimulatedDrive& drive, DocumentNode& root) {
  const SensorTruth& sensors = drive.sensors;
  const drive::Session& session = drive.session;
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

RigidTransform vehicle_from_lidar(const SimulatedDrive& drive) {
  return drive.sensors.vehicle_from_ins * drive.ins_from_lidar;
}

void add_other_truth(const SimulatedDrive& drive, OtherTruth what, DocumentNode& root) {
  const Eigen::Vector3d& antenna_in_ins_m = drive.sensors.antenna_in_ins_m;
  switch (what) {
    case OtherTruth::None:
      return;
    case OtherTruth::Sensors:
      root.add("vehicle_from_ins", formats::transform_document(drive.sensors.vehicle_from_ins));
      root.add("vehicle_from_lidar", formats::transform_document(vehicle_from_lidar(drive)));
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

/// Of one LiDAR, in the axes of the format's INS.
void add_mounting(const SimulatedDrive& drive, const DriveFormat& format, DocumentNode& root) {
  const RigidTransform ins_from_lidar =
      format.ins_axes == drive::InsAxes::RightForwardUp
          ? drive::forward_left_up_from(drive::InsAxes::RightForwardUp).inverse() * drive.ins_from_lidar
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
}

DocumentNode truth_document(const DriveFormat& format) {
  DocumentNode root = DocumentNode::map();
  root.add("format", DocumentNode::string("remount-truth/1"));
  if (format.ins_axes == drive::InsAxes::RightForwardUp) root.add("ins_axes", DocumentNode::string("right-forward-up"));
  return root;
}

DocumentNode truth(const SimulatedDrive& drive, const DriveFormat& format) {
  DocumentNode root = truth_document(format);
  add_mounting(drive, format, root);
  add_other_truth(drive, format.other_truth, root);
  add_lidar_errors(drive.sensors.lidar, root);
  if (const SimulationOptions* options = lidar_options_of(drive.session.scans))
    SimulationOptions::visit(*options, OptionWriter{root.add("simulation", DocumentNode::map())});
  return root;
}

/// The truth of each LiDAR under its name, and what is the vehicle's beside them.
DocumentNode truth(const SimulatedVehicle& vehicle, const DriveFormat& format) {
  DocumentNode root = truth_document(format);
  DocumentNode& lidars = root.add("lidars", DocumentNode::map());
  const bool with_sensors = format.other_truth == OtherTruth::Sensors;
  for (const SimulatedDrive& drive : vehicle.lidars) {
    DocumentNode& lidar = lidars.add(drive.session.lidar_name, DocumentNode::map());
    add_mounting(drive, format, lidar);
    if (with_sensors) lidar.add("vehicle_from_lidar", formats::transform_document(vehicle_from_lidar(drive)));
    add_lidar_errors(drive.sensors.lidar, lidar);
    const SimulationOptions* options = lidar_options_of(drive.session.scans);
    if (!options) continue;
    DocumentNode& simulation = lidar.add("simulation", DocumentNode::map());
    SimulationOptions::visit(*options, OptionWriter{simulation, is_lidar_option});
    simulation.add("seed", DocumentNode::integer(options->seed));
    simulation.add("scan_phase_s", DocumentNode::number(options->scan_phase_s));
  }
  const SimulatedDrive& any = vehicle.lidars.front();
  if (with_sensors) {
    root.add("vehicle_from_ins", formats::transform_document(any.sensors.vehicle_from_ins));
    add_sensors(any, root);
  }
  if (const Scene* scene = scene_of(any.session.scans))
    SimulationOptions::visit(scene->options(),
                             OptionWriter{root.add("simulation", DocumentNode::map()),
                                          [](std::string_view name) { return !is_lidar_option(name); }});
  return root;
}

void require_empty(const fs::path& folder) {
  std::error_code failure;
  if (!fs::exists(folder, failure)) return;
  if (!fs::is_directory(folder, failure)) throw Error(ErrorCode::Io, folder.string(), say::simulation_no_folder());
  if (!fs::is_empty(folder, failure) || failure)
    throw Error(ErrorCode::Io, folder.string(), say::simulation_folder_not_empty());
}

const DriveFormat& format_named(const std::string& id) {
  const std::vector<DriveFormat>& formats = drive_format_list();
  const auto chosen =
      std::find_if(formats.begin(), formats.end(), [&](const DriveFormat& one) { return one.id == id; });
  if (chosen == formats.end()) throw Error(ErrorCode::Contract, id, say::simulation_no_such_format());
  return *chosen;
}

std::vector<std::string> format_ids(bool of_vehicles) {
  std::vector<std::string> ids;
  for (const DriveFormat& format : drive_format_list())
    if (!of_vehicles || format.write_vehicle) ids.emplace_back(format.id);
  return ids;
}

/// A part of a drive would pass for one. The folder was empty before.
void remove_contents(const fs::path& folder) {
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) fs::remove_all(entry.path(), none);
}

}  // namespace

const std::vector<std::string>& drive_formats() {
  static const std::vector<std::string> formats = format_ids(false);
  return formats;
}

const std::vector<std::string>& vehicle_formats() {
  static const std::vector<std::string> formats = format_ids(true);
  return formats;
}

void write_drive(const SimulatedDrive& drive, const fs::path& folder, const std::string& format, int threads,
                 Progress& progress) {
  const DriveFormat& chosen = format_named(format);
  if (chosen.check) chosen.check(drive);
  require_empty(folder);
  formats::make_directories(folder);
  chosen.write(drive, folder, threads, progress);
  if (progress.cancelled()) return remove_contents(folder);
  formats::write_file(folder / "truth.yaml", formats::to_yaml(truth(drive, chosen)));
}

void write_vehicle(const SimulatedVehicle& vehicle, const fs::path& folder, const std::string& format, int threads,
                   Progress& progress) {
  const DriveFormat& chosen = format_named(format);
  if (!chosen.write_vehicle) throw Error(ErrorCode::Contract, format, say::simulation_one_lidar(vehicle_formats()));
  require_empty(folder);
  formats::make_directories(folder);
  chosen.write_vehicle(vehicle, folder, threads, progress);
  if (progress.cancelled()) return remove_contents(folder);
  formats::write_file(folder / "truth.yaml", formats::to_yaml(truth(vehicle, chosen)));
}

}  // namespace remount::simulator
