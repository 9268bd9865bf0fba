// Drives as a SPAN logs them: INSPVA often, its errors once a second.
#include "model/simulator/novatel_drive.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "model/drive/session_frames.h"
#include "tests/model/simulator/written_drive.h"
#include "tests/support/draws.h"
#include "tests/support/findings.h"

namespace remount::simulator {
namespace {

constexpr const char* kFormatsOfInspva[] = {"novatel-ascii", "novatel-binary", "mcap-novatel"};

TEST(novatel_drive, holds_the_samples_of_the_drive_and_the_errors_beside_them) {
  SimulationOptions options = in_the_south_west();
  options.ins_trouble.degraded_start_s = 1.0;
  options.ins_trouble.degraded_s = 1.0;
  const SimulatedDrive drive = simulate_drive(options);
  const Eigen::Quaterniond flu_from_rfu(drive::forward_left_up_from(drive::InsAxes::RightForwardUp).linear());
  for (const char* format : kFormatsOfInspva) {
    const formats::TemporaryFolder folder;
    const drive::Session session = read_back(drive, format, folder);
    EXPECT_EQ(session.ins_axes, drive::InsAxes::RightForwardUp) << format;
    const SampleErrors errors = sample_errors(session.ins, drive.session.ins, flu_from_rfu);
    EXPECT_LT(errors.latitude_rad, 1e-14) << format;
    EXPECT_LT(errors.longitude_rad, 1e-14) << format;
    EXPECT_LT(errors.height_m, 1e-9) << format;
    EXPECT_LT(errors.turned_rad, 1e-7) << format;
    ASSERT_EQ(session.ins.size(), drive.session.ins.size()) << format;
    std::size_t degraded = 0;
    for (std::size_t i = 0; i < session.ins.size(); ++i) {
      const motion::InsSample& read = session.ins[i];
      ASSERT_EQ(read.quality, drive.session.ins[i].quality) << format;
      ASSERT_TRUE(read.sigma.position_enu_m.allFinite() && read.sigma.attitude_rad.allFinite()) << format << ": " << i;
      degraded += read.quality == motion::InsQuality::Degraded;
    }
    EXPECT_GT(degraded, 50U) << format;
    EXPECT_NEAR(session.ins[0].sigma.position_enu_m.x(), options.ins_position_noise_m, 1e-6) << format;
    EXPECT_NEAR(session.ins[0].sigma.attitude_rad.z(), degrees_to_radians(options.ins_attitude_noise_deg), 1e-7)
        << format;
    const std::string told = testing::said_of(session.findings, "ins-log-chosen");
    EXPECT_TRUE(formats::contains(told, "INSSTDEV, the nearest in time")) << format << ": " << told;
  }
}

TEST(novatel_drive, as_logs_gives_the_mounting_that_stands_beside_it) {
  const SimulatedDrive drive = simulate_drive(parking_ramp());
  for (const char* format : {"novatel-ascii", "novatel-binary"}) {
    const auto [result, truth, error] = calibrated(drive, format, by_trajectories);
    EXPECT_TRUE(calibration::is_usable(result)) << format << ": " << english(result.message);
    EXPECT_LT(error.rotation_deg, 0.05) << format;
    EXPECT_LT(std::hypot(error.x_m, error.y_m), 0.02) << format;
    testing::expect_within_sigma(result, truth, 3.5);
  }
}

TEST(novatel_drive, as_a_bag_gives_its_truth_when_it_is_calibrated) {
  ONLY_IN_LONG_TESTS();
  SimulationOptions options;
  options.beams = 16;
  options.azimuth_steps = 450;
  const auto [result, truth, error] = calibrated(simulate_drive(options), "mcap-novatel", by_pairs);
  EXPECT_TRUE(calibration::is_usable(result)) << english(result.message);
  EXPECT_LE(error.rotation_deg, 0.05);
  EXPECT_LE(std::hypot(error.x_m, error.y_m), 0.02);
  testing::expect_within_sigma(result, truth, 3.5);
}

}  // namespace
}  // namespace remount::simulator
