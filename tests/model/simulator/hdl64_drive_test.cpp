// A drive as the packets of an HDL-64E with its calibration: what is read is what was simulated.
#include <gtest/gtest.h>

#include "tests/model/simulator/written_drive.h"

namespace remount::simulator {
namespace {

TEST(hdl64_drive, points_and_times_are_those_that_were_simulated) {
  const PointErrors errors = point_errors(kHdl64, 0.5);
  EXPECT_GT(errors.read, errors.simulated - 800) << "the last turn ends within a packet";
  EXPECT_LT(errors.worst_m, 1.1e-3) << "half a step of 2 mm";
  EXPECT_LT(errors.worst_s, 1e-6);
}

}  // namespace
}  // namespace remount::simulator
