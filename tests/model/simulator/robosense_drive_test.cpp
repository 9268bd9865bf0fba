// A drive as the packets of an RS-Helios: what is read is what was simulated.
#include <gtest/gtest.h>

#include <iostream>

#include "algorithms/geometry/rotation.h"
#include "model/pipeline/pipeline.h"
#include "model/simulator/helios.h"
#include "model/simulator/lidar_model.h"
#include "tests/model/simulator/written_drive.h"
#include "tests/support/calibration_checks.h"

namespace remount::simulator {
namespace {

TEST(robosense_drive, points_and_times_are_those_that_were_simulated) {
  SimulationOptions options;
  options.duration_s = 0.6;
  const SimulatedDrive drive = simulate_drive(options);
  const formats::TemporaryFolder folder;
  const drive::Session session = read_back(drive, "robosense", folder);
  ASSERT_TRUE(session.scans);
  EXPECT_EQ(session.ins.size(), drive.session.ins.size());
  EXPECT_EQ(session.scans->size(), 6U);

  std::vector<HeliosReturn> truth;
  const Scene& scene = *scene_of(drive.session.scans);
  for (std::size_t packet = 0; packet < helios_packets(options); ++packet)
    for (const HeliosReturn& found : helios_returns(scene, packet)) truth.push_back(found);
  double worst_m = 0.0, worst_s = 0.0;
  std::size_t next = 0;
  for (std::size_t scan = 0; scan < session.scans->size(); ++scan) {
    const cloud::PointCloud cloud = session.scans->load(scan);
    for (std::size_t i = 0; i < cloud.size(); ++i, ++next) {
      ASSERT_LT(next, truth.size());
      const double time_s = 1e-9 * static_cast<double>(session.scans->stamp_ns(scan) - kDriveStart_ns) +
                            static_cast<double>(cloud.time_from_stamp_s[i]);
      worst_s = std::max(worst_s, std::abs(time_s - truth[next].time_s));
      worst_m = std::max(worst_m, (cloud.points[i].cast<double>() - truth[next].point).norm());
      ASSERT_EQ(cloud.ring[i], truth[next].ring);
    }
  }
  std::cout << next << " of " << truth.size() << " points: at most " << 1e3 * worst_m << " mm and " << 1e6 * worst_s
            << " us off\n";
  EXPECT_EQ(next, truth.size());
  EXPECT_LT(worst_m, 2e-3);
  EXPECT_LT(worst_s, 1e-6);
}

TEST(robosense_drive, an_m1_rounds_directions_and_ranges_and_keeps_times) {
  SimulationOptions options;
  options.lidar.model = lidar_named("m1");
  options.duration_s = 0.5;
  const SimulatedDrive drive = simulate_drive(options);
  const formats::TemporaryFolder folder;
  const drive::Session session = read_back(drive, "robosense-m1", folder);
  ASSERT_EQ(session.scans->size(), 5U);
  double worst_m = 0.0, worst_deg = 0.0, worst_s = 0.0;
  std::size_t points = 0;
  for (std::size_t scan = 0; scan < 5; ++scan) {
    const cloud::PointCloud truth = drive.session.scans->load(scan), found = session.scans->load(scan);
    ASSERT_EQ(found.size(), truth.size());
    EXPECT_EQ(session.scans->stamp_ns(scan), drive.session.scans->stamp_ns(scan));
    points += found.size();
    for (std::size_t i = 0; i < found.size(); ++i) {
      const Eigen::Vector3d a = truth.points[i].cast<double>(), b = found.points[i].cast<double>();
      worst_m = std::max(worst_m, std::abs(a.norm() - b.norm()));
      worst_deg = std::max(worst_deg, radians_to_degrees(std::atan2(a.cross(b).norm(), a.dot(b))));
      worst_s = std::max(worst_s, std::abs(static_cast<double>(truth.time_from_stamp_s[i]) -
                                           static_cast<double>(found.time_from_stamp_s[i])));
    }
  }
  std::cout << points << " points: ranges at most " << 1e3 * worst_m << " mm off, directions " << worst_deg
            << " deg, times " << 1e6 * worst_s << " us\n";
  EXPECT_LT(worst_m, 2.6e-3) << "units of 5 mm";
  EXPECT_LT(worst_deg, 0.0072) << "of a hundredth of a degree";
  EXPECT_LT(worst_s, 1.1e-6) << "of a microsecond";
}

TEST(robosense_drive, is_calibrated_to_the_truth) {
  SimulationOptions options;
  options.scenario = ScenarioKind::ParkingRamp;
  options.duration_s = 15.0;
  const formats::TemporaryFolder folder;
  pipeline::PipelineInput input;
  input.sessions = {std::make_shared<drive::Session>(read_back(simulate_drive(options), "robosense", folder))};
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
