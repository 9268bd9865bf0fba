// A drive as the packets of a PandarXT-32: what is read is what was simulated.
#include <gtest/gtest.h>

#include <iostream>

#include "model/pipeline/pipeline.h"
#include "model/simulator/hesai_spinner.h"
#include "model/simulator/lidar_model.h"
#include "tests/model/simulator/written_drive.h"
#include "tests/support/calibration_checks.h"

namespace remount::simulator {
namespace {

TEST(hesai_drive, points_and_times_are_those_that_were_simulated) {
  SimulationOptions options;
  options.duration_s = 1.0;
  const SimulatedDrive drive = simulate_drive(options);
  const formats::TemporaryFolder folder;
  const drive::Session session = read_back(drive, "hesai", folder);
  ASSERT_TRUE(session.scans);
  EXPECT_EQ(session.ins.size(), drive.session.ins.size());
  EXPECT_EQ(session.scans->size(), 10U);

  std::vector<SpinnerReturn> truth;
  const Scene& scene = *scene_of(drive.session.scans);
  for (std::size_t packet = 0; packet < spinner_packets(options); ++packet)
    for (const SpinnerReturn& found : spinner_returns(scene, packet)) truth.push_back(found);
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
      ASSERT_EQ(cloud.ring[i], kSpinnerChannels - 1 - truth[next].channel);
    }
  }
  std::cout << next << " of " << truth.size() << " points: at most " << 1e3 * worst_m << " mm and " << 1e6 * worst_s
            << " us off\n";
  EXPECT_GT(next, truth.size() - 300) << "the last turn ends within a packet";
  EXPECT_LT(worst_m, 2.2e-3) << "ranges are multiples of 4 mm";
  EXPECT_LT(worst_s, 1e-6);
}

TEST(hesai_drive, is_calibrated_to_the_truth) {
  SimulationOptions options;
  options.scenario = ScenarioKind::ParkingRamp;
  options.duration_s = 8.0;
  const formats::TemporaryFolder folder;
  pipeline::PipelineInput input;
  input.sessions = {std::make_shared<drive::Session>(read_back(simulate_drive(options), "hesai", folder))};
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
