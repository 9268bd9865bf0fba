// A drive as a Livox sends it: what is read is what was simulated.
#include <gtest/gtest.h>

#include "tests/model/simulator/written_drive.h"
#include "tests/support/findings.h"

namespace remount::simulator {
namespace {

SimulationOptions of_livox(const char* model, double duration_s) {
  SimulationOptions options = lasting(duration_s);
  options.lidar.model = lidar_named(model);
  return options;
}

TEST(livox_drive, points_and_times_are_those_that_were_simulated) {
  for (const auto& [format, model] : {std::pair{"livox", "mid-360"}, {"lvx2", "mid-360"}, {"lvx", "avia"}}) {
    const SimulatedDrive drive = simulate_drive(of_livox(model, 0.6));
    const formats::TemporaryFolder folder;
    const drive::Session session = read_back(drive, format, folder);
    ASSERT_TRUE(session.scans);
    EXPECT_EQ(session.ins.size(), drive.session.ins.size());
    EXPECT_EQ(session.scans->size(), 6U) << format;
    EXPECT_FALSE(testing::has_code(session.findings, "capture-missing")) << format;
    const PointErrors errors = point_errors(format, timed_points(*session.scans), timed_points(*drive.session.scans));
    EXPECT_GT(errors.read, errors.simulated - 100) << "the last packet is not full";
    EXPECT_LT(errors.worst_m, 1e-3) << format;
    EXPECT_LT(errors.worst_s, 1e-6) << format;
  }
}

TEST(livox_drive, another_lidar_has_a_mid_360_in_its_place) {
  SimulationOptions options;
  options.duration_s = 0.5;
  const formats::TemporaryFolder folder;
  const drive::Session session = read_back(simulate_drive(options), "lvx2", folder);
  ASSERT_EQ(session.scans->size(), 5U);
  EXPECT_GT(session.scans->load(1).size(), 5'000U) << "its field is mostly sky";
  options.motion_distortion = false;
  Progress progress;
  EXPECT_ERROR(write_drive(simulate_drive(options), folder.path() / "other", "livox", 1, progress),
               "motion_distortion");
}

TEST(livox_drive, is_calibrated_to_the_truth) { expect_calibrated_on_ramp(of_livox("mid-360", 15.0), "livox"); }

}  // namespace
}  // namespace remount::simulator
