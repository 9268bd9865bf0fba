// A drive as a Livox sends it: what is read is what was simulated.
#include <gtest/gtest.h>

#include <iostream>

#include "model/pipeline/pipeline.h"
#include "model/simulator/lidar_model.h"
#include "tests/model/simulator/written_drive.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/findings.h"

namespace remount::simulator {
namespace {

SimulationOptions of_livox(const char* model, double duration_s) {
  SimulationOptions options;
  options.lidar.model = lidar_named(model);
  options.duration_s = duration_s;
  return options;
}

/// A point with its time since the start of the drive.
struct TimedPoint {
  double time_s = 0.0;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
};

std::vector<TimedPoint> timed_points(const drive::ScanSource& scans) {
  std::vector<TimedPoint> points;
  for (std::size_t scan = 0; scan < scans.size(); ++scan) {
    const cloud::PointCloud cloud = scans.load(scan);
    for (std::size_t i = 0; i < cloud.size(); ++i)
      points.push_back({1e-9 * static_cast<double>(scans.stamp_ns(scan) - kDriveStart_ns) +
                            static_cast<double>(cloud.time_from_stamp_s[i]),
                        cloud.points[i].cast<double>()});
  }
  return points;
}

TEST(livox_drive, points_and_times_are_those_that_were_simulated) {
  for (const auto& [format, model] : {std::pair{"livox", "mid-360"}, {"lvx2", "mid-360"}, {"lvx", "avia"}}) {
    const SimulatedDrive drive = simulate_drive(of_livox(model, 0.6));
    const formats::TemporaryFolder folder;
    const drive::Session session = read_back(drive, format, folder);
    ASSERT_TRUE(session.scans);
    EXPECT_EQ(session.ins.size(), drive.session.ins.size());
    EXPECT_EQ(session.scans->size(), 6U) << format;
    EXPECT_FALSE(testing::has_code(session.findings, "capture-missing")) << format;
    const std::vector<TimedPoint> truth = timed_points(*drive.session.scans), found = timed_points(*session.scans);
    double worst_m = 0.0, worst_s = 0.0;
    ASSERT_LE(found.size(), truth.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      worst_m = std::max(worst_m, (found[i].point - truth[i].point).norm());
      worst_s = std::max(worst_s, std::abs(found[i].time_s - truth[i].time_s));
    }
    std::cout << format << ": " << found.size() << " of " << truth.size() << " points: at most " << 1e3 * worst_m
              << " mm and " << 1e6 * worst_s << " us off\n";
    EXPECT_GT(found.size(), truth.size() - 100) << "the last packet is not full";
    EXPECT_LT(worst_m, 1e-3) << format;
    EXPECT_LT(worst_s, 1e-6) << format;
  }
}

TEST(livox_drive, another_lidar_has_a_mid_360_in_its_place) {
  SimulationOptions options;
  options.duration_s = 0.5;
  const formats::TemporaryFolder folder;
  const drive::Session session = read_back(simulate_drive(options), "lvx2", folder);
  ASSERT_EQ(session.scans->size(), 5U);
  EXPECT_GT(session.scans->load(1).size(), 5'000U) << "its field is mostly sky";
  options.motion_distortion = false;
  Progress progress;
  EXPECT_ERROR(write_drive(simulate_drive(options), folder.path() / "other", "livox", 1, progress),
               "motion_distortion");
}

TEST(livox_drive, is_calibrated_to_the_truth) {
  SimulationOptions options = of_livox("mid-360", 15.0);
  options.scenario = ScenarioKind::ParkingRamp;
  const formats::TemporaryFolder folder;
  pipeline::PipelineInput input;
  input.sessions = {std::make_shared<drive::Session>(read_back(simulate_drive(options), "livox", folder))};
  input.nominal_ins_from_lidar = options.ins_from_lidar;
  Progress progress;
  const auto output = pipeline::run_pipeline(input, progress);
  const testing::CalibrationError error = testing::error_of(output.result, true_mounting(folder));
  std::cout << "rotation " << error.rotation_deg << " deg, x " << error.x_m << " m, y " << error.y_m << " m\n";
  EXPECT_LT(error.rotation_deg, 0.1);
  EXPECT_LT(std::hypot(error.x_m, error.y_m), 0.05);
}

}  // namespace
}  // namespace remount::simulator
