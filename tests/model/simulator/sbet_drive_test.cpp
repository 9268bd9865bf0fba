// Drives as POSPac exports them, read back.
#include "model/simulator/sbet_drive.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "model/method_registry/calibration_method.h"
#include "model/pipeline/pipeline.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/simulator/written_drive.h"
#include "tests/support/calibration_checks.h"

namespace remount::simulator {
namespace {

TEST(sbet_drive, holds_the_samples_of_the_drive_and_the_errors_beside_them) {
  SimulationOptions options;
  options.duration_s = 3.0;
  options.beams = 8;
  options.azimuth_steps = 90;
  options.latitude_deg = -33.9;  // south and west
  options.longitude_deg = -70.6;
  const SimulatedDrive drive = simulate_drive(options);
  const formats::TemporaryFolder folder;
  const drive::Session session = read_back(drive, "sbet", folder);
  ASSERT_EQ(session.ins.size(), drive.session.ins.size());
  EXPECT_EQ(session.files.size(), 3U) << "errors and poses are inputs as well";
  double turned_rad = 0.0;
  for (std::size_t i = 0; i < session.ins.size(); ++i) {
    const motion::InsSample &read = session.ins[i], &written = drive.session.ins[i];
    ASSERT_EQ(read.stamp_ns, written.stamp_ns) << "in the LiDAR's week";
    ASSERT_EQ(read.latitude_rad, written.latitude_rad);
    ASSERT_EQ(read.longitude_rad, written.longitude_rad);
    ASSERT_EQ(read.height_m, written.height_m);
    turned_rad = std::max(turned_rad, read.enu_from_ins.angularDistance(written.enu_from_ins));
    ASSERT_NEAR(read.sigma.position_enu_m.x(), options.ins_position_noise_m, 1e-6) << i;
    ASSERT_NEAR(read.sigma.attitude_rad.z(), degrees_to_radians(options.ins_attitude_noise_deg), 1e-7) << i;
  }
  EXPECT_LT(turned_rad, 1e-7);
  std::printf("attitudes as written: to %.2g rad\n", turned_rad);
}

TEST(sbet_drive, gives_the_mounting_that_stands_beside_it) {
  SimulationOptions options;
  options.scenario = ScenarioKind::ParkingRamp;
  options.duration_s = 40.0;
  options.beams = 8;
  options.azimuth_steps = 90;
  const formats::TemporaryFolder folder;
  pipeline::PipelineInput input;
  input.sessions = {std::make_shared<drive::Session>(read_back(simulate_drive(options), "sbet", folder))};
  Progress progress;
  const calibration::CalibrationResult result =
      method_registry::calibration_method("trajectory").run(input, progress).result;
  const testing::CalibrationError error = testing::error_of(result, true_mounting(folder));
  EXPECT_TRUE(calibration::is_usable(result)) << english(result.message);
  EXPECT_LT(error.rotation_deg, 0.05);
  EXPECT_LT(std::hypot(error.x_m, error.y_m), 0.02);
}

}  // namespace
}  // namespace remount::simulator
