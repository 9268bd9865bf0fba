#include "tests/benchmark/pair_sets.h"

#include <algorithm>
#include <filesystem>
#include <random>

#include "model/formats/session_readers.h"
#include "model/simulator/simulator.h"

namespace remount::testing {
namespace {

// Start values off by 0.5 m and 2 degrees.
void set_starts(DataSet& data) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (BenchmarkPair& pair : data.pairs) {
    const Eigen::Vector3d shift = Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
    const Eigen::Vector3d turn = Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
    Vector6d step;
    step << 0.5 * shift, degrees_to_radians(2.0) * turn;
    pair.start = perturb(pair.truth, step);
  }
}

void prepare_all(DataSet& data) {
  for (const cloud::PointCloud& cloud : data.clouds)
    data.prepared.push_back(std::make_unique<registration::PreparedCloud>(cloud, registration::RegistrationOptions{}));
}

// The best of own alignments from several distances travelled.
RigidTransform own_result(const registration::PreparedCloud& source, const registration::PreparedCloud& target) {
  registration::RegistrationResult best;
  for (double ahead_m = 0.0; ahead_m <= 2.5; ahead_m += 0.5) {
    registration::RegistrationOptions options;
    options.max_correspondence_m = 2.0;
    const RigidTransform start = make_rigid(Eigen::Matrix3d::Identity(), {ahead_m, 0.0, 0.0});
    const registration::RegistrationResult result = registration::align_scans(source, target, start, options, {});
    if (result.quality.overlap > best.quality.overlap) best = result;
  }
  return registration::align_scans(source, target, best.target_from_source, {}, {}).target_from_source;
}

}  // namespace

DataSet make_street(std::size_t scans) {
  simulator::SimulationOptions options;
  options.scan_rate_hz = 2.0;
  options.duration_s = static_cast<double>(scans) / options.scan_rate_hz;
  options.azimuth_steps = 2000;
  options.motion_distortion = false;
  const simulator::SimulatedDrive drive = simulator::simulate_drive(options);
  DataSet data;
  const auto pose = [&](std::size_t i) { return RigidTransform(drive.enu_from_ins[i].pose * drive.ins_from_lidar); };
  for (std::size_t i = 0; i < drive.session.scans->size(); ++i) {
    data.clouds.push_back(drive.session.scans->load(i));
    if (i > 0) data.pairs.push_back({i, i - 1, pose(i - 1).inverse() * pose(i)});
  }
  prepare_all(data);
  set_starts(data);
  return data;
}

DataSet make_kitti(const std::vector<std::string>& drives, std::size_t every) {
  DataSet data;
  const std::filesystem::path folder = std::filesystem::path(REMOUNT_SOURCE_DIR) / ".." / "shared" / "data" / "kitti";
  for (const std::string& drive : drives) {
    if (!std::filesystem::exists(folder / drive)) continue;
    Progress progress;
    const drive::Session session = formats::open_session(folder / drive, progress);
    for (std::size_t i = 0; i < session.scans->size(); ++i) {
      data.clouds.push_back(session.scans->load(i));
      if (i > 0 && i % every == 0) data.pairs.push_back({data.clouds.size() - 1, data.clouds.size() - 2});
    }
  }
  prepare_all(data);
  for (BenchmarkPair& pair : data.pairs)
    pair.truth = own_result(*data.prepared[pair.source], *data.prepared[pair.target]);
  set_starts(data);
  return data;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace remount::testing
