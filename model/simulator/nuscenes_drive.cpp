// Simulated drives in the layout of nuScenes.
#include <initializer_list>

#include "algorithms/core/parallel.h"
#include "algorithms/geometry/rotation.h"
#include "model/formats/clouds/cloud_file.h"
#include "model/formats/files/number_text.h"
#include "model/formats/files/output_file.h"
#include "model/simulator/drive_formats.h"

namespace remount::simulator {

namespace fs = std::filesystem;

namespace {

/// `"translation": [x, y, z], "rotation": [w, x, y, z]`.
std::string transform_keys(const RigidTransform& transform) {
  const Eigen::Vector3d t = transform.translation();
  const Eigen::Quaterniond q(transform.linear());
  const auto list = [](std::initializer_list<double> values) {
    std::string text;
    for (const double value : values) (text += text.empty() ? "" : ", ") += formats::exact_text(value);
    return "[" + text + "]";
  };
  return "\"translation\": " + list({t.x(), t.y(), t.z()}) + ",\n\"rotation\": " + list({q.w(), q.x(), q.y(), q.z()});
}

std::string token_of(const char* what, std::size_t number) { return formats::format_numbers("%s%08zx", what, number); }

/// Rows as nuScenes indents them.
void append_row(std::string& table, const std::string& row) {
  table += (table.empty() ? "[\n{\n" : ",\n{\n") + row + "\n}";
}

std::string text_key(const char* key, const std::string& value) {
  return "\"" + std::string(key) + "\": \"" + value + "\"";
}

/// Every tenth scan is of a sample, as with a LiDAR of 20 Hz and samples of 2 Hz.
fs::path file_of_sweep(std::size_t scan, std::int64_t stamp_us) {
  return fs::path(scan % 10 == 0 ? "samples" : "sweeps") / "LIDAR_TOP" /
         ("simulated__LIDAR_TOP__" + std::to_string(stamp_us) + ".pcd.bin");
}

}  // namespace

void write_nuscenes_drive(const SimulatedDrive& drive, const fs::path& folder, int threads, Progress& progress) {
  const drive::ScanSource& scans = *drive.session.scans;
  const fs::path tables = folder / "v1.0-simulated";
  for (const fs::path& below : {fs::path("samples/LIDAR_TOP"), fs::path("sweeps/LIDAR_TOP")})
    formats::make_directories(folder / below);
  formats::make_directories(tables);
  std::string samples, sample_data, poses;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const std::int64_t stamp_us = scans.stamp_ns(i) / 1000;
    const std::string stamp = "\"timestamp\": " + std::to_string(stamp_us), pose = token_of("pose", i);
    if (i % 10 == 0)
      append_row(samples, text_key("token", token_of("sample", i / 10)) + ",\n" + stamp + ",\n" +
                              text_key("scene_token", "scene"));
    append_row(sample_data, text_key("token", token_of("data", i)) + ",\n" +
                                text_key("sample_token", token_of("sample", i / 10)) + ",\n" +
                                text_key("ego_pose_token", pose) + ",\n" +
                                text_key("calibrated_sensor_token", "calibrated") + ",\n" + stamp + ",\n" +
                                text_key("fileformat", "pcd") + ",\n" +
                                text_key("filename", file_of_sweep(i, stamp_us).generic_string()));
    append_row(poses, text_key("token", pose) + ",\n" + stamp + ",\n" + transform_keys(drive.enu_from_ins[i].pose));
  }
  parallel_for(scans.size(), threads, [&](std::size_t i) {
    if (progress.cancelled()) return;
    formats::write_nuscenes_bin(folder / file_of_sweep(i, scans.stamp_ns(i) / 1000), scans.load(i));
  });
  if (progress.cancelled()) return;
  std::string sensors, calibrated, scenes;
  append_row(sensors, text_key("token", "lidar") + ",\n" + text_key("channel", "LIDAR_TOP") + ",\n" +
                          text_key("modality", "lidar"));
  append_row(calibrated, text_key("token", "calibrated") + ",\n" + text_key("sensor_token", "lidar") + ",\n" +
                             transform_keys(drive.session.nominal_ins_from_lidar.value_or(drive.ins_from_lidar)));
  append_row(scenes, text_key("token", "scene") + ",\n" + text_key("name", drive.session.name));
  const std::pair<const char*, const std::string*> all[] = {{"sensor", &sensors}, {"calibrated_sensor", &calibrated},
                                                            {"scene", &scenes},   {"sample", &samples},
                                                            {"ego_pose", &poses}, {"sample_data", &sample_data}};
  for (const auto& [name, table] : all) formats::write_file(tables / (std::string(name) + ".json"), *table + "\n]");
}

}  // namespace remount::simulator
