// A data set in the layout of nuScenes.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "algorithms/geometry/rotation.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {

/// Half a turn is 180 degrees: of a rotation by `deg` about `axis`, as w, x, y, z.
inline std::string wxyz(double deg, const Eigen::Vector3d& axis) {
  const Eigen::Quaterniond q(Eigen::AngleAxisd(degrees_to_radians(deg), axis));
  char text[160];
  std::snprintf(text, sizeof text, "[%.17g, %.17g, %.17g, %.17g]", q.w(), q.x(), q.y(), q.z());
  return text;
}

inline std::string five_floats(float ring) {
  std::string bytes;
  for (int point = 0; point < 3; ++point)
    for (const float value : {1.0F + static_cast<float>(point), 2.0F, -1.5F, 40.0F, ring})
      bytes.append(reinterpret_cast<const char*>(&value), 4);
  return bytes;
}

struct NuscenesFixture {
  std::string sensors =
      R"([{"token": "s0", "channel": "CAM_FRONT", "modality": "camera"}, {"token": "s1", "channel": "LIDAR_TOP", "modality": "lidar"}])";
  std::string calibrated =
      R"([{"token": "c0", "sensor_token": "s0", "translation": [9, 9, 9], "rotation": [1, 0, 0, 0], "camera_intrinsic": [[1, 0, 0]]},)"
      R"({"token": "c1", "sensor_token": "s1", "translation": [0.943713, 0.0, 1.84023], "rotation": )" +
      wxyz(-90.0, Eigen::Vector3d::UnitZ()) + R"(, "camera_intrinsic": []}])";
  std::string scenes, samples, sample_data, poses;
  int rows = 0;
  std::string prefix;  ///< of the names of sweeps
  std::string pcd;     ///< in the place of floats

  void add_scene(const TemporaryFolder& folder, const std::string& name, int sweeps = 4,
                 const std::vector<std::string>& calibrated_by = {"c1"}) {
    scenes += (scenes.empty() ? "" : ",") + std::string(R"({"token": "t)") + name + R"(", "name": ")" + name + R"("})";
    samples += (samples.empty() ? "" : ",") + std::string(R"({"token": "m)") + name + R"(", "scene_token": "t)" + name +
               R"("})";
    for (int i = 0; i < sweeps; ++i)
      for (const std::string& sensor : calibrated_by) add_sweep(folder, name, i, sensor);
  }
  void add_sweep(const TemporaryFolder& folder, const std::string& scene, int i, const std::string& sensor) {
    const std::string between = rows == 0 ? "" : ",", number = std::to_string(rows++);
    const std::string stamp = std::to_string(1'532'402'927'647'951LL + 50'000 * i);
    const std::string channel = sensor == "c1" ? "LIDAR_TOP" : "LIDAR_REAR";
    const std::string file = (i == 0 ? "samples/" : "sweeps/") + channel + "/" + prefix + scene + "__" + channel +
                             "__" + stamp + (pcd.empty() ? ".pcd.bin" : ".pcd");
    sample_data += between + R"({"token": "d)" + number + R"(", "sample_token": "m)" + scene +
                   R"(", "ego_pose_token": "p)" + number + R"(", "calibrated_sensor_token": ")" + sensor +
                   R"(", "timestamp": )" + stamp + R"(, "fileformat": "pcd", "is_key_frame": true, "filename": ")" +
                   file + R"("})";
    sample_data += R"(,{"token": "x", "sample_token": "m)" + scene +
                   R"(", "ego_pose_token": "q", "calibrated_sensor_token": "c0",)"
                   R"("timestamp": 1, "filename": "samples/CAM_FRONT/a.jpg"})";
    poses += between + R"({"token": "p)" + number + R"(", "timestamp": )" + stamp + R"(, "rotation": )" +
             wxyz(30.0, i == 0   ? Eigen::Vector3d::UnitZ()
                        : i == 1 ? Eigen::Vector3d::UnitY()
                                 : Eigen::Vector3d::UnitX()) +
             R"(, "translation": [)" + std::to_string(411.5 + i) + R"(, 1181.25, 0.0]})";
    folder.write(file, pcd.empty() ? five_floats(static_cast<float>(sensor == "c1" ? 7 : 9)) : pcd);
  }
  void write(const TemporaryFolder& folder, const std::string& version = "v1.0-mini") const {
    folder.write(version + "/sensor.json", sensors);
    folder.write(version + "/calibrated_sensor.json", calibrated);
    folder.write(version + "/scene.json", "[" + scenes + "]");
    folder.write(version + "/sample.json", "[" + samples + "]");
    folder.write(version + "/sample_data.json", "[" + sample_data + "]");
    folder.write(version + "/ego_pose.json", "[" + poses + "]");
  }
};

}  // namespace remount::formats
