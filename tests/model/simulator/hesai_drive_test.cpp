// A drive as the packets of a PandarXT-32: what is read is what was simulated.
#include <gtest/gtest.h>

#include "tests/model/simulator/written_drive.h"

namespace remount::simulator {
namespace {

TEST(hesai_drive, points_and_times_are_those_that_were_simulated) {
  const PointErrors errors = point_errors(kHesaiSpinner, 1.0);
  EXPECT_GT(errors.read, errors.simulated - 300) << "the last turn ends within a packet";
  EXPECT_LT(errors.worst_m, 2.2e-3) << "ranges are multiples of 4 mm";
  EXPECT_LT(errors.worst_s, 1e-6);
}

TEST(hesai_drive, is_calibrated_to_the_truth) { expect_calibrated_on_ramp(lasting(8.0), "hesai"); }

}  // namespace
}  // namespace remount::simulator
