// Drives as a Septentrio records them, read back.
#include "model/simulator/sbf_drive.h"

#include <gtest/gtest.h>

#include "tests/model/simulator/written_drive.h"

namespace remount::simulator {
namespace {

TEST(sbf_drive, holds_the_samples_of_the_drive_and_their_errors) {
  const SimulationOptions options = in_the_south_west();
  const SimulatedDrive drive = simulate_drive(options);
  const formats::TemporaryFolder folder;
  const drive::Session session = read_back(drive, "sbf", folder);
  const SampleErrors errors = sample_errors(session.ins, drive.session.ins);
  EXPECT_EQ(errors.latitude_rad, 0.0);
  EXPECT_EQ(errors.longitude_rad, 0.0);
  EXPECT_EQ(errors.height_m, 0.0);
  EXPECT_LT(errors.turned_rad, 1e-6) << "floats of degrees";
  for (const motion::InsSample& read : session.ins) {
    ASSERT_NEAR(read.sigma.position_enu_m.x(), options.ins_position_noise_m, 1e-6);
    ASSERT_NEAR(read.sigma.attitude_rad.z(), degrees_to_radians(options.ins_attitude_noise_deg), 1e-7);
  }
}

}  // namespace
}  // namespace remount::simulator
