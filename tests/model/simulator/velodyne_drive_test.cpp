// A drive as the packets of a VLP-16: what is read is what was simulated.
#include <gtest/gtest.h>

#include "tests/model/simulator/written_drive.h"
#include "tests/support/draws.h"

namespace remount::simulator {
namespace {

TEST(velodyne_drive, points_and_times_are_those_that_were_simulated) {
  const PointErrors errors = point_errors(kPuck, 1.0);
  EXPECT_GT(errors.read, errors.simulated - 400) << "the last turn ends within a packet";
  EXPECT_LT(errors.worst_m, 2e-3);
  EXPECT_LT(errors.worst_s, 1e-6);
}

TEST(velodyne_drive, is_calibrated_to_the_truth) {
  ONLY_IN_LONG_TESTS();
  expect_calibrated_on_ramp(lasting(15.0), "velodyne");
}

}  // namespace
}  // namespace remount::simulator
