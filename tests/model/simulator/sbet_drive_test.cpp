// Drives as POSPac exports them, read back.
#include "model/simulator/sbet_drive.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "tests/model/simulator/written_drive.h"

namespace remount::simulator {
namespace {

TEST(sbet_drive, holds_the_samples_of_the_drive_and_the_errors_beside_them) {
  const SimulationOptions options = in_the_south_west();
  const SimulatedDrive drive = simulate_drive(options);
  const formats::TemporaryFolder folder;
  const drive::Session session = read_back(drive, "sbet", folder);
  EXPECT_EQ(session.files.size(), 3U) << "errors and poses are inputs as well";
  const SampleErrors errors = sample_errors(session.ins, drive.session.ins);
  EXPECT_EQ(errors.latitude_rad, 0.0);
  EXPECT_EQ(errors.longitude_rad, 0.0);
  EXPECT_EQ(errors.height_m, 0.0);
  EXPECT_LT(errors.turned_rad, 1e-7);
  for (const motion::InsSample& read : session.ins) {
    ASSERT_NEAR(read.sigma.position_enu_m.x(), options.ins_position_noise_m, 1e-6);
    ASSERT_NEAR(read.sigma.attitude_rad.z(), degrees_to_radians(options.ins_attitude_noise_deg), 1e-7);
  }
}

TEST(sbet_drive, gives_the_mounting_that_stands_beside_it) {
  const auto [result, truth, error] = calibrated(simulate_drive(parking_ramp()), "sbet", by_trajectories);
  EXPECT_TRUE(calibration::is_usable(result)) << english(result.message);
  EXPECT_LT(error.rotation_deg, 0.05);
  EXPECT_LT(std::hypot(error.x_m, error.y_m), 0.02);
}

}  // namespace
}  // namespace remount::simulator
