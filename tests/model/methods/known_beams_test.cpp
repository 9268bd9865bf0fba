// Corrections of the LiDAR's beams that are known beforehand, for methods that find none and for the one that does.
#include <gtest/gtest.h>

#include <cstdio>

#include "model/methods/calibrate.h"
#include "model/pipeline/mended_scans.h"
#include "model/project/project.h"
#include "model/results/beam_file.h"
#include "model/results/deciding_notes.h"
#include "model/simulator/patterns/lidar_models.h"
#include "model/simulator/simulator.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/draws.h"
#include "tests/support/findings.h"
#include "tests/support/kept_scans.h"

namespace remount::methods {
namespace {

// Of a LiDAR whose beams look 0.2 degrees further down than it says.
simulator::SimulatedDrive drive_of_erring_lidar(int seed) {
  simulator::SimulationOptions options;
  options.beams = 32;
  options.azimuth_steps = 600;
  options.seed = seed;
  options.lidar_errors.elevation_offset_deg = 0.2;
  return testing::simulate_drive(options);
}

pipeline::PipelineOutput calibrate_by(const char* method, const simulator::SimulatedDrive& drive,
                                      const std::filesystem::path& beams_file) {
  pipeline::PipelineInput input;
  input.sessions.push_back(std::make_shared<drive::Session>(drive.session));
  input.nominal_ins_from_lidar = drive.ins_from_lidar;
  input.settings.run.method = method_registry::MethodChoice(method);
  input.settings.beams.file = beams_file.string();
  Progress progress;
  return calibrate(input, progress);
}

// What an earlier drive would have told, with errors of its own.
cloud::BeamEstimate told_before() {
  const cloud::BeamNodes& nodes = cloud::BeamNodes::all_around();
  cloud::BeamEstimate known{
      nodes, Eigen::VectorXd::Zero(nodes.errors()), Eigen::VectorXd::Zero(nodes.errors()), {}, {}};
  known.errors.segment(nodes.elevation_at(0), nodes.count()).setConstant(degrees_to_radians(0.205));
  known.sigmas.segment(nodes.elevation_at(0), nodes.count()).setConstant(degrees_to_radians(0.02));
  known.sigmas.segment(nodes.range_at(0), nodes.count()).setConstant(0.01);
  known.sigmas[nodes.range_scale()] = 2e-4;
  known.elevation = {degrees_to_radians(0.205), degrees_to_radians(0.01), true};
  return known;
}

class known_beams : public ::testing::Test {
 protected:
  const formats::TemporaryFolder folder_;
  const std::filesystem::path file_ =
      folder_.write("beams.yaml", formats::to_yaml(results::beams_document(told_before())));
};

TEST_F(known_beams, take_the_error_out_of_a_method_that_knows_nothing_of_beams) {
  ONLY_IN_LONG_TESTS();
  const simulator::SimulatedDrive drive = drive_of_erring_lidar(3);
  const pipeline::PipelineOutput without = calibrate_by("trajectory", drive, {});
  const pipeline::PipelineOutput with = calibrate_by("trajectory", drive, file_);
  std::printf("  without the file, and with it:\n");
  const testing::CalibrationError before = testing::error_of(without.result, drive.ins_from_lidar);
  const testing::CalibrationError after = testing::error_of(with.result, drive.ins_from_lidar);
  EXPECT_LT(std::abs(after.z_m) + after.rotation_deg, 0.5 * (std::abs(before.z_m) + before.rotation_deg));
  EXPECT_TRUE(without.result.beams.empty());
  EXPECT_EQ(with.result.beams.errors, told_before().errors) << "a part of the result";
  EXPECT_EQ(with.mended_beams.values, told_before().errors);
  const std::string said = testing::said_of(with.findings, results::kMendedBeams);
  EXPECT_NE(said.find("the file that beams.file names"), std::string::npos) << said;
  EXPECT_FALSE(testing::has_code(without.findings, results::kMendedBeams));
}

TEST_F(known_beams, are_what_pairs_begin_with_and_their_total_is_told) {
  const simulator::SimulatedDrive drive = drive_of_erring_lidar(4);
  const pipeline::PipelineOutput without = calibrate_by("pairwise", drive, {});
  const pipeline::PipelineOutput with = calibrate_by("pairwise", drive, file_);
  std::printf("  elevation %.4f +- %.4f deg without, %.4f +- %.4f deg with\n",
              radians_to_degrees(without.result.beams.elevation.error),
              radians_to_degrees(without.result.beams.elevation.sigma),
              radians_to_degrees(with.result.beams.elevation.error),
              radians_to_degrees(with.result.beams.elevation.sigma));
  EXPECT_TRUE(with.result.beams.elevation.told);
  EXPECT_LE(with.result.beams.elevation.sigma, without.result.beams.elevation.sigma);
  EXPECT_NEAR(radians_to_degrees(with.result.beams.elevation.error), 0.2, 0.02) << "the total, not what is left";
  testing::expect_within_sigma(with.result, drive.ins_from_lidar, 3.5);
  const SixParameters a = six_from_rigid(without.result.mounting.reference_from_sensor),
                      b = six_from_rigid(with.result.mounting.reference_from_sensor);
  const double z_sigma_m = without.result.estimate(calibration::Parameter::Z).sigma.value_or(0.0);
  std::printf("  z %.4f m without (+- %.4f), %.4f m with\n", a.z_m, z_sigma_m, b.z_m);
  EXPECT_LT(std::abs(a.z_m - b.z_m), 2.0 * z_sigma_m);
  // As recorded is without the corrections of the file, too.
  const std::string said = testing::said_of(with.findings, results::kMendedBeams);
  const std::string said_without = testing::said_of(without.findings, results::kMendedBeams);
  std::printf("  %s\n  %s\n", said.c_str(), said_without.c_str());
  const auto as_recorded_mm = [](const std::string& text) {
    const std::size_t end = text.find(" mm as recorded"), begin = text.rfind(' ', end - 1);
    return end == std::string::npos ? 0.0 : std::stod(text.substr(begin, end - begin));
  };
  EXPECT_GT(as_recorded_mm(said), 0.0);
  EXPECT_NEAR(as_recorded_mm(said), as_recorded_mm(said_without), 0.05 * as_recorded_mm(said));
  // A window that solves again has the sessions as they were opened, and the file may be gone by then.
  pipeline::PipelineInput opened;
  opened.sessions.push_back(std::make_shared<drive::Session>(drive.session));
  opened.nominal_ins_from_lidar = drive.ins_from_lidar;
  pipeline::PipelineOutput again = with;
  Progress progress;
  ASSERT_TRUE(pipeline::solve_again(opened, again, progress));
  EXPECT_NEAR(again.result.beams.elevation.error, with.result.beams.elevation.error,
              0.5 * with.result.beams.elevation.sigma);
}

TEST_F(known_beams, mend_scans_as_they_are_read_and_keep_them_as_recorded_beside_it) {
  const simulator::SimulatedDrive drive = drive_of_erring_lidar(3);
  const auto recorded = std::make_shared<const drive::Session>(drive.session);
  EXPECT_EQ(pipeline::mended_session(recorded, {}), recorded);
  const auto mended = pipeline::mended_session(recorded, told_before());
  cloud::PointCloud expected = recorded->scans->load(0);
  cloud::mend_beams(told_before().beam_errors(), expected);
  EXPECT_EQ(mended->scans->load(0).points, expected.points);
  EXPECT_NE(expected.points, recorded->scans->load(0).points);
  EXPECT_EQ(mended->scans_as_recorded, recorded->scans);
  EXPECT_EQ(mended->scans->stamp_ns(1), recorded->scans->stamp_ns(1));
}

// Of a drive without pairs nothing is compared; what was taken out of its scans is kept with where it is.
TEST_F(known_beams, over_a_field_are_kept_in_the_project_of_a_drive_that_is_not_solved) {
  cloud::BeamEstimate ahead;
  ahead.nodes = cloud::BeamNodes::over(-1.0, 1.0, -0.2, 0.2);
  ahead.errors.setConstant(ahead.nodes.errors(), 0.001), ahead.sigmas.setConstant(ahead.nodes.errors(), 0.0005);
  simulator::SimulationOptions options;
  options.lidar.model = simulator::lidar_named("m1");
  options.lidar.points_per_scan = 3000;
  options.duration_s = 1.0;
  pipeline::PipelineInput input;
  input.sessions.push_back(std::make_shared<drive::Session>(simulator::simulate_drive(options).session));
  input.settings.pairing.min_distance_m = 10.0, input.settings.pairing.min_rotation_deg = 90.0;
  input.settings.beams.file = folder_.write("ahead.yaml", formats::to_yaml(results::beams_document(ahead))).string();
  Progress progress;
  project::Project job;
  job.sessions = {folder_.path() / "drive"};
  job.output = calibrate(input, progress);
  ASSERT_TRUE(job.output->pairs.empty());
  job.basis.session_count = 1;
  ASSERT_FALSE(calibration::is_solved(job.output->result.status));
  EXPECT_EQ(job.output->beam_nodes, ahead.nodes);
  project::save_project(job, folder_.path() / "open.remount");
  const project::Project opened = project::load_project(folder_.path() / "open.remount");
  EXPECT_EQ(opened.output->beam_nodes, ahead.nodes);
  EXPECT_LT((opened.output->mended_beams.values - ahead.errors).cwiseAbs().maxCoeff(), 1e-12);
}

TEST_F(known_beams, of_a_file_that_is_gone_are_an_error) {
  EXPECT_ERROR(calibrate_by("pairwise", drive_of_erring_lidar(3), folder_.path() / "gone.yaml"),
               "Correct the setting beams.file");
}

}  // namespace
}  // namespace remount::methods
