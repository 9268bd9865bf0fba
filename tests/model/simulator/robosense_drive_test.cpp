// A drive as the packets of an RS-Helios: what is read is what was simulated.
#include <gtest/gtest.h>

#include <iostream>

#include "algorithms/geometry/rotation.h"
#include "tests/model/simulator/written_drive.h"
#include "tests/support/draws.h"

namespace remount::simulator {
namespace {

TEST(robosense_drive, points_and_times_are_those_that_were_simulated) {
  const PointErrors errors = point_errors(kHelios, 0.6);
  EXPECT_EQ(errors.read, errors.simulated);
  EXPECT_LT(errors.worst_m, 2e-3);
  EXPECT_LT(errors.worst_s, 1e-6);
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
  ONLY_IN_LONG_TESTS();
  expect_calibrated_on_ramp(lasting(15.0), "robosense");
}

}  // namespace
}  // namespace remount::simulator
