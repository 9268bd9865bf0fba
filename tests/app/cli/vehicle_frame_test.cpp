// Wheel speeds and turn rates alone, from the command line.
#include <gtest/gtest.h>

#include "tests/app/cli/program_fixture.h"
#include "tests/support/recorded_drives.h"

namespace remount::cli {
namespace {

class cli_vehicle_frame : public ProgramFixture<cli_vehicle_frame> {
 protected:
  static void SetUpTestSuite() { make_folder_with_drive("--duration-s 0.5 --beams 1 --azimuth-steps 16"); }

  /// Calibrates and returns the result file's text.
  static std::string calibrated(const std::string& session, const std::string& result) {
    const Outcome outcome = run("calibrate '" + session + "' --method vehicle-frame -o " + path(result));
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    // Positions of an antenna were calibrated: nothing may pass for the pose of a LiDAR.
    EXPECT_NE(outcome.out.find("vehicle_from_antenna (place of the antenna in the vehicle frame"), std::string::npos)
        << outcome.out;
    EXPECT_EQ(outcome.out.find("pose of the lidar"), std::string::npos) << outcome.out;
    return text_of(path(result));
  }
};

TEST_F(cli_vehicle_frame, a_simulated_smartloc_drive_runs_end_to_end) {
  const Outcome made = run("simulate figure-eight " + path("wheels") + " --format smartloc --duration-s 60");
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_NE(text_of(path("wheels/truth.yaml")).find("antenna_in_vehicle_m"), std::string::npos);
  const std::string result = calibrated(path("wheels"), "wheels.yaml");
  EXPECT_NE(result.find("x and y are observed"), std::string::npos) << result;
  EXPECT_NE(result.find("wheel scale"), std::string::npos) << result;
}

TEST_F(cli_vehicle_frame, a_nominal_in_another_frame_is_refused_with_the_reason) {
  const std::string calibrate = "calibrate " + path("drive");
  const std::vector<std::pair<std::string, std::string>> refused{
      {" --method vehicle-frame --nominal 0.9,0,0.7,0,0,0", "places the LiDAR in the INS frame"},
      {" --method slew --nominal vehicle:0.9,0,0.7,0,0,0", "in the vehicle's frame"},
      {" --method trajectory --nominal machine:0.9,0,0.7,0,0,0", "in the machine's frame"},
      {" --nominal vehicle:0.9,0,0.7,0,0,0", "in the vehicle's frame"},
      {" --method vehicle-frame --nominal vehicle:0.9,0,0.7,0,0,0 --range z=1:2", "outside the search range"}};
  for (const auto& [arguments, reason] : refused) {
    const Outcome outcome = run(calibrate + arguments);
    EXPECT_EQ(outcome.code, 1) << arguments << outcome.out;
    EXPECT_NE(outcome.err.find(reason), std::string::npos) << arguments << "\n" << outcome.err;
  }
}

TEST_F(cli_vehicle_frame, the_recorded_smartloc_folder_runs_end_to_end) {
  if (!std::filesystem::exists(testing::kData / "smartloc")) GTEST_SKIP() << "no recorded data at " << testing::kData;
  const std::string result = calibrated((testing::kData / "smartloc").string(), "berlin.yaml");
  EXPECT_NE(result.find("end error"), std::string::npos) << result;
  EXPECT_NE(result.find("calibrated: antenna"), std::string::npos) << result;
}

}  // namespace
}  // namespace remount::cli
