// Whole calibrations of recorded drives, against what is known of their mounting. Skipped where the data are absent.
#include <gtest/gtest.h>

#include <filesystem>

#include "algorithms/messages/render.h"
#include "model/formats/session_readers.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/recorded_drives.h"

namespace remount::pipeline {
namespace {

PipelineOutput calibrate(const std::vector<std::filesystem::path>& folders, const settings::Settings& settings = {}) {
  Progress progress;
  PipelineInput input;
  input.settings = settings;
  for (const auto& folder : folders)
    input.sessions.push_back(std::make_shared<drive::Session>(formats::open_session(folder, progress)));
  return run_pipeline(input, progress);
}

RigidTransform kitti_truth() {
  RigidTransform truth = RigidTransform::Identity();
  truth.matrix().topRows<3>() << 0.999997642, -0.000785403, 0.002024406, 0.810543938, 0.000755307, 0.999889825,
      0.014824542, -0.307054366, -0.002035826, -0.014822978, 0.999888061, 0.802724026;
  return truth;
}

TEST(kitti, four_short_drives_without_nominal_agree_with_the_published_calibration) {
  if (!std::filesystem::exists(testing::kData / "kitti")) GTEST_SKIP() << "no recorded data at " << testing::kData;
  const PipelineOutput output = calibrate({testing::kData / "kitti/00", testing::kData / "kitti/05",
                                           testing::kData / "kitti/07", testing::kData / "kitti/10"});
  const testing::CalibrationError error = testing::error_of(output.result, kitti_truth());
  EXPECT_LE(error.rotation_deg, 0.3);
  EXPECT_LE(std::abs(error.x_m), 0.15);
  EXPECT_LE(std::abs(error.y_m), 0.15);
  EXPECT_FALSE(output.result.known[calibration::Parameter::Z].observed)
      << "ten scans on flat roads do not show the height";
  testing::expect_within_sigma(output.result, kitti_truth(), 3.5);
  int rejected = 0, of_first = 0;
  for (const motion::Pair& pair : output.pairs) {
    if (output.keyframes[pair.keyframe_a].session != motion::SessionIndex{0}) continue;
    ++of_first;
    if (pair.state != motion::PairState::Rejected) continue;
    ++rejected;
    EXPECT_NE(english(pair.reason).find("contradicts the INS motion"), std::string::npos) << english(pair.reason);
  }
  EXPECT_GT(rejected, of_first / 2) << "the INS of the first drive contradicts its scans";
}

TEST(zxl19, three_drives_from_raw_logs_agree_with_the_reference_and_with_each_other) {
  if (!std::filesystem::exists(testing::kData / "zxl19")) GTEST_SKIP() << "no recorded data at " << testing::kData;
  settings::Settings settings;
  settings.solve.apply_time_offset = calibration::ClockOffsetUse::Yes;
  std::vector<calibration::CalibrationResult> alone;
  for (const char* bag : {"bag1", "bag2", "bag4"}) {
    alone.push_back(calibrate({testing::kData / "zxl19" / bag}, settings).result);
    testing::error_of(alone.back(), testing::zxl19_reference());
  }
  for (std::size_t a = 0; a < alone.size(); ++a)
    for (std::size_t b = a + 1; b < alone.size(); ++b)
      for (std::size_t i = 0; i < 6; ++i) {
        if (!alone[a].estimate(calibration::kParameters[i]).sigma ||
            !alone[b].estimate(calibration::kParameters[i]).sigma)
          continue;
        const std::array<double, 6> in_sigma_a =
            testing::normalised_errors(alone[a], alone[b].mounting.ins_from_lidar());
        const double difference = in_sigma_a[i] * *alone[a].estimate(calibration::kParameters[i]).sigma;
        EXPECT_LT(std::abs(difference), 3.0 * std::hypot(*alone[a].estimate(calibration::kParameters[i]).sigma,
                                                         *alone[b].estimate(calibration::kParameters[i]).sigma))
            << to_string(calibration::kParameters[i]) << " of drives " << a << " and " << b;
      }
  const PipelineOutput together = calibrate(
      {testing::kData / "zxl19/bag1", testing::kData / "zxl19/bag2", testing::kData / "zxl19/bag4"}, settings);
  const testing::CalibrationError error = testing::error_of(together.result, testing::zxl19_reference());
  EXPECT_LE(error.rotation_deg, 0.5);
  EXPECT_LE(std::abs(error.x_m), 0.08);
  EXPECT_LE(std::abs(error.y_m), 0.08);
}

}  // namespace
}  // namespace remount::pipeline
