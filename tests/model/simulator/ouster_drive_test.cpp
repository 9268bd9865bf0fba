// A drive as the packets of an Ouster: what is read is what was simulated.
#include <gtest/gtest.h>

#include "tests/model/simulator/written_drive.h"
#include "tests/support/draws.h"

namespace remount::simulator {
namespace {

TEST(ouster_drive, points_and_times_are_those_that_were_simulated) {
  const PointErrors errors = point_errors(kOusterHead, 1.0);
  EXPECT_EQ(errors.read, errors.simulated);
  EXPECT_LT(errors.worst_m, 0.6e-3) << "ranges are whole millimetres";
  EXPECT_LT(errors.worst_s, 1e-7);
}

TEST(ouster_drive, is_calibrated_to_the_truth) {
  ONLY_IN_LONG_TESTS();
  expect_calibrated_on_ramp(lasting(8.0), "ouster");
}

}  // namespace
}  // namespace remount::simulator
