// Drives as a SPAN logs them: INSPVA often, its errors once a second.
#include "model/simulator/novatel_drive.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "model/method_registry/calibration_method.h"
#include "model/pipeline/pipeline.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/simulator/written_drive.h"
#include "tests/support/calibration_checks.h"

namespace remount::simulator {
namespace {

constexpr const char* kFormatsOfInspva[] = {"novatel-ascii", "novatel-binary", "mcap-novatel"};

TEST(novatel_drive, holds_the_samples_of_the_drive_and_the_errors_beside_them) {
  SimulationOptions options;
  options.duration_s = 3.0;
  options.beams = 8;
  options.azimuth_steps = 90;
  options.latitude_deg = -33.9;  // south and west
  options.longitude_deg = -70.6;
  options.ins_trouble.degraded_start_s = 1.0;
  options.ins_trouble.degraded_s = 1.0;
  const SimulatedDrive drive = simulate_drive(options);
  const Eigen::Quaterniond flu_from_rfu(drive::forward_left_up_from(drive::InsAxes::RightForwardUp).linear());
  for (const char* format : kFormatsOfInspva) {
    const formats::TemporaryFolder folder;
    const drive::Session session = read_back(drive, format, folder);
    EXPECT_EQ(session.ins_axes, drive::InsAxes::RightForwardUp) << format;
    ASSERT_EQ(session.ins.size(), drive.session.ins.size()) << format;
    std::size_t degraded = 0;
    for (std::size_t i = 0; i < session.ins.size(); ++i) {
      const motion::InsSample &read = session.ins[i], &written = drive.session.ins[i];
      ASSERT_EQ(read.stamp_ns, written.stamp_ns) << format;
      ASSERT_NEAR(read.latitude_rad, written.latitude_rad, 1e-14) << format;
      ASSERT_NEAR(read.longitude_rad, written.longitude_rad, 1e-14) << format;
      ASSERT_NEAR(read.height_m, written.height_m, 1e-9) << format;
      ASSERT_LT(read.enu_from_ins.angularDistance(written.enu_from_ins * flu_from_rfu), 1e-7) << format;
      ASSERT_EQ(read.quality, written.quality) << format;
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
  SimulationOptions options;
  options.scenario = ScenarioKind::ParkingRamp;
  options.duration_s = 40.0;
  options.beams = 8;
  options.azimuth_steps = 90;
  const SimulatedDrive drive = simulate_drive(options);
  for (const char* format : {"novatel-ascii", "novatel-binary"}) {
    const formats::TemporaryFolder folder;
    pipeline::PipelineInput input;
    input.sessions = {std::make_shared<drive::Session>(read_back(drive, format, folder))};
    Progress progress;
    const calibration::CalibrationResult result =
        method_registry::calibration_method("trajectory").run(input, progress).result;
    EXPECT_TRUE(calibration::is_usable(result)) << format << ": " << english(result.message);
    const testing::CalibrationError error = testing::error_of(result, true_mounting(folder));
    EXPECT_LT(error.rotation_deg, 0.05) << format;
    EXPECT_LT(std::hypot(error.x_m, error.y_m), 0.02) << format;
    testing::expect_within_sigma(result, true_mounting(folder), 3.5);
  }
}

TEST(novatel_drive, as_a_bag_gives_its_truth_when_it_is_calibrated) {
  SimulationOptions options;
  options.beams = 16;
  options.azimuth_steps = 450;
  const formats::TemporaryFolder folder;
  pipeline::PipelineInput input;
  input.sessions = {std::make_shared<drive::Session>(read_back(simulate_drive(options), "mcap-novatel", folder))};
  Progress progress;
  const calibration::CalibrationResult result = pipeline::run_pipeline(input, progress).result;
  EXPECT_TRUE(calibration::is_usable(result)) << english(result.message);
  const testing::CalibrationError error = testing::error_of(result, true_mounting(folder));
  EXPECT_LE(error.rotation_deg, 0.05);
  EXPECT_LE(std::hypot(error.x_m, error.y_m), 0.02);
  testing::expect_within_sigma(result, true_mounting(folder), 3.5);
}

}  // namespace
}  // namespace remount::simulator
