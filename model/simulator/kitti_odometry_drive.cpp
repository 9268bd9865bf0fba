// Simulated drives in the layout of KITTI's odometry benchmark.
#include "algorithms/core/parallel.h"
#include "model/formats/clouds/cloud_file.h"
#include "model/formats/files/number_text.h"
#include "model/formats/files/numbered_file.h"
#include "model/formats/files/output_file.h"
#include "model/formats/sessions/kitti_odometry_reader.h"
#include "model/simulator/drive_formats.h"

namespace remount::simulator {

namespace fs = std::filesystem;

namespace {

/// Twelve numbers, row by row.
std::string matrix_row(const RigidTransform& transform) {
  std::string line;
  for (int i = 0; i < 12; ++i) (line += i == 0 ? "" : " ") += formats::exact_text(transform(i / 4, i % 4));
  return line + "\n";
}

}  // namespace

void write_kitti_odometry_drive(const SimulatedDrive& drive, const fs::path& folder, int threads, Progress& progress) {
  const drive::ScanSource& scans = *drive.session.scans;
  const fs::path sequence = folder / "sequences" / "00", velodyne = sequence / "velodyne";
  const RigidTransform ins_from_camera = make_rigid(formats::forward_left_up_from_camera(), Eigen::Vector3d::Zero());
  const RigidTransform camera_from_ins = ins_from_camera.inverse();
  const RigidTransform first_from_enu = drive.enu_from_ins.front().pose.inverse();
  std::string times, poses;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const std::int64_t since_ns = scans.stamp_ns(i) - scans.stamp_ns(0);
    times += formats::format_numbers("%lld.%09lld\n", static_cast<long long>(since_ns / 1'000'000'000),
                                     static_cast<long long>(since_ns % 1'000'000'000));
    poses += matrix_row(camera_from_ins * first_from_enu * drive.enu_from_ins[i].pose * ins_from_camera);
  }
  formats::make_directories(velodyne);
  parallel_for(scans.size(), threads, [&](std::size_t i) {
    if (progress.cancelled()) return;
    formats::write_kitti_bin(formats::numbered_file(velodyne, i, 6, ".bin"), scans.load(i));
  });
  if (progress.cancelled()) return;
  formats::make_directories(folder / "poses");
  formats::write_file(folder / "poses" / "00.txt", poses);
  formats::write_file(sequence / "times.txt", times);
  if (const auto& nominal = drive.session.nominal_ins_from_lidar)
    formats::write_file(sequence / "calib.txt", "Tr: " + matrix_row(camera_from_ins * *nominal));
}

}  // namespace remount::simulator
