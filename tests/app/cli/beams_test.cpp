// Corrections of the LiDAR's beams, out of a result and into other files, as the program is called.
#include <gtest/gtest.h>

#include "model/results/beam_file.h"
#include "model/results/vehicle_file.h"
#include "tests/app/cli/program_fixture.h"

namespace remount::cli {
namespace {

constexpr const char* kFactory =
    "lasers:\n- {laser_id: 0, rot_correction: 0.0, vert_correction: -0.2, dist_correction: 1.0}\nnum_lasers: 1\n";

class cli_beams : public ProgramFixture<cli_beams> {
 protected:
  static void SetUpTestSuite() {
    make_folder_with_drive("--duration-s 1.5 --beams 8 --azimuth-steps 100");
    results::ResultFile file;
    file.ins_axes = drive::InsAxes::ForwardLeftUp;
    file.result.status = calibration::Status::Ok;
    file.result.set_observed(calibration::ParameterSet::all(), {});
    file.result.covariance = Matrix6d::Identity() * 1e-6;
    results::save_result(file, path("none.yaml"));
    cloud::BeamEstimate& beams = file.result.beams;
    beams.nodes = cloud::BeamNodes::all_around();
    beams.errors.setConstant(beams.nodes.errors(), 0.001), beams.sigmas.setConstant(beams.nodes.errors(), 0.0002);
    results::save_result(file, path("r.yaml"));
    std::ofstream(path("db.yaml")) << kFactory;
  }
  static void expect_refused(const std::string& arguments, const std::string& reason) {
    const Outcome outcome = run(arguments);
    EXPECT_NE(outcome.code, 0) << arguments << outcome.out;
    EXPECT_NE(outcome.err.find(reason), std::string::npos) << arguments << "\n" << outcome.err;
  }
};

TEST_F(cli_beams, are_exported_and_written_into_the_calibration_of_the_lidar) {
  const Outcome exported = run("export " + path("r.yaml") + " --to beams -o " + path("beams.yaml"));
  ASSERT_EQ(exported.code, 0) << exported.err;
  EXPECT_EQ(results::load_beams(path("beams.yaml")).errors, results::load_beams(path("r.yaml")).errors);
  for (const std::string from : {"beams.yaml", "r.yaml"}) {
    const Outcome mended = run("beams " + path(from) + " --into " + path("db.yaml") + " -o " + path("new.yaml"));
    ASSERT_EQ(mended.code, 0) << mended.err;
    EXPECT_NE(mended.out.find("elevations and ranges of 1 laser corrected"), std::string::npos) << mended.out;
    EXPECT_NE(mended.err.find("+0.100 % (± 0.020 %) is left out"), std::string::npos) << mended.err;
    const std::string text = text_of(path("new.yaml"));
    EXPECT_NE(text.find("vert_correction: -0.199"), std::string::npos) << text;
    EXPECT_NE(text.find("dist_correction: 1.001"), std::string::npos) << text;
  }
  EXPECT_EQ(text_of(path("db.yaml")), kFactory);
}

TEST_F(cli_beams, of_several_lidars_are_those_of_the_one_that_is_named) {
  results::VehicleFile vehicle;
  vehicle.lidars = {{"front", true, results::load_result(path("none.yaml"))},
                    {"rear", true, results::load_result(path("r.yaml"))}};
  results::save_vehicle(vehicle, path("vehicle.yaml"));
  const std::string mend = "beams " + path("vehicle.yaml") + " --into " + path("db.yaml") + " -o " + path("rear.yaml");
  const Outcome rear = run(mend + " --lidar rear");
  EXPECT_EQ(rear.code, 0) << rear.err;
  EXPECT_NE(text_of(path("rear.yaml")).find("vert_correction: -0.199"), std::string::npos);
  expect_refused(mend, "expected --lidar NAME with one of front, rear");
  expect_refused(mend + " --lidar front", "The method pairwise finds them");
  expect_refused(mend + " --lidar left", "It has: front, rear");
}

TEST_F(cli_beams, that_are_not_there_or_would_replace_something_are_refused) {
  expect_refused("export " + path("none.yaml") + " --to beams", "The method pairwise finds them");
  expect_refused("beams " + path("none.yaml") + " --into " + path("db.yaml") + " -o " + path("x.yaml"),
                 "The method pairwise finds them");
  const std::string into = "beams " + path("r.yaml") + " --into " + path("db.yaml") + " -o ";
  expect_refused(into + path("db.yaml"), "a file that is corrected twice is wrong");
  expect_refused(into + path("r.yaml"), "no such calibration file");
  expect_refused("beams " + path("r.yaml") + " --into " + path("none.yaml") + " -o " + path("x.yaml"), "lasers");
  EXPECT_FALSE(std::filesystem::exists(path("x.yaml")));
}

TEST_F(cli_beams, are_named_by_a_setting_and_mend_scans_for_any_method) {
  ASSERT_EQ(run("export " + path("r.yaml") + " --to beams -o " + path("known.yaml")).code, 0);
  std::ofstream(path("settings.yaml")) << "beams: {file: known.yaml}\n";
  const std::string poses = " --nominal none --config " + path("settings.yaml") + " -o ";
  ASSERT_EQ(run("odometry " + path("drive") + " --nominal none -o " + path("as_is.txt")).code, 0);
  const Outcome mended = run("odometry " + path("drive") + poses + path("mended.txt"));
  ASSERT_EQ(mended.code, 0) << mended.err;
  EXPECT_NE(text_of(path("mended.txt")), text_of(path("as_is.txt")));
  expect_refused("calibrate " + path("drive") + " --set beams.file=" + path("gone.yaml") + " -o " + path("y.yaml"),
                 "Correct the setting beams.file");
}

}  // namespace
}  // namespace remount::cli
