#include "model/results/beam_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "model/results/deciding_notes.h"
#include "model/results/exporters/exporter.h"
#include "model/results/vehicle_file.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/no_scans.h"

namespace remount::results {
namespace {

cloud::BeamEstimate some_beams() {
  cloud::BeamEstimate beams;
  beams.nodes = cloud::BeamNodes::all_around();
  beams.errors.setLinSpaced(beams.nodes.errors(), -0.01, 0.02);
  beams.sigmas.setConstant(beams.nodes.errors(), 0.001);
  beams.elevation = {0.003, 0.0001, true};
  return beams;
}

ResultFile result_with_beams() {
  ResultFile file;
  file.result.status = calibration::Status::Ok;
  file.result.set_observed(calibration::ParameterSet::all(), {});
  file.result.covariance = Matrix6d::Identity() * 1e-6;
  file.result.beams = some_beams();
  return file;
}

double largest_difference(const cloud::BeamEstimate& a, const cloud::BeamEstimate& b) {
  return std::max({(a.errors - b.errors).cwiseAbs().maxCoeff(), (a.sigmas - b.sigmas).cwiseAbs().maxCoeff(),
                   std::abs(a.elevation.error - b.elevation.error), std::abs(a.range.sigma - b.range.sigma)});
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from << " is not in " << text;
  return text.replace(at, from.size(), to);
}

class beam_files : public ::testing::Test {
 protected:
  cloud::BeamEstimate loaded(const std::string& text) const { return load_beams(folder_.write("beams.yaml", text)); }

  const formats::TemporaryFolder folder_;
  const std::string exported_ = exporter("beams").write(result_with_beams(), {});
};

TEST_F(beam_files, hold_what_was_written_and_so_does_a_result) {
  const cloud::BeamEstimate read = loaded(exported_);
  const double off = largest_difference(read, some_beams());
  std::printf("  beams.yaml has %zu bytes, off by %.1e\n", exported_.size(), off);
  EXPECT_LT(off, 1e-14);
  EXPECT_TRUE(read.elevation.told);
  EXPECT_FALSE(read.range.told) << "null";
  EXPECT_NE(exported_.find("elevations over its x-y plane (up)"), std::string::npos) << exported_;
  EXPECT_EQ(exported_.find("Axes of the INS"), std::string::npos);
  save_result(result_with_beams(), folder_.path() / "result.yaml");
  EXPECT_LT(largest_difference(load_beams(folder_.path() / "result.yaml"), some_beams()), 1e-14);
  EXPECT_EQ(loaded(formats::to_yaml(beams_document(read))).errors, read.errors);
}

TEST_F(beam_files, of_results_that_tell_none_are_refused_with_what_to_do) {
  ResultFile none = result_with_beams();
  none.result.beams = {};
  EXPECT_ERROR(exporter("beams").write(none, {}), "The method pairwise finds them");
  save_result(none, folder_.path() / "none.yaml");
  EXPECT_ERROR(load_beams(folder_.path() / "none.yaml"), "The method pairwise finds them");
  ResultFile open = result_with_beams();
  open.result.status = calibration::Status::Degenerate;
  EXPECT_ERROR(exporter("beams").write(open, {}), "may be errors of the INS");
}

TEST_F(beam_files, that_are_damaged_or_mean_something_else_are_refused_with_the_place) {
  EXPECT_ERROR(load_beams(folder_.path() / "gone.yaml"), "Correct the setting beams.file");
  EXPECT_ERROR(loaded("format: remount-fleet/1\n"), "expected \"remount-beams/1\"");
  EXPECT_ERROR(loaded(with(exported_, "remount-beams/1", "remount-beams/2")), "a later version");
  EXPECT_ERROR(loaded(with(exported_, "range_scale_sigma: 0.001", "range_scale_sigma: -0.001")), "negative");
  EXPECT_ERROR(loaded(with(exported_, "range_scale: 0.02", "range_scale: 0.2")), "look at the units");
  EXPECT_ERROR(loaded(with(exported_, "-23.2", "-29.5")), "each larger than the one before");
  EXPECT_ERROR(loaded(with(exported_, "range_scale: ", "rangescale: ")), "range_scale");
  cloud::BeamEstimate unsure = some_beams();
  unsure.sigmas.setZero();
  EXPECT_ERROR(loaded(formats::to_yaml(beams_document(unsure))), "above 0");
}

TEST_F(beam_files, are_no_mounting_and_replace_only_their_like) {
  const std::filesystem::path path = folder_.write("beams.yaml", exported_);
  EXPECT_ERROR(read_any_mounting(path), "Give it by the setting beams.file");
  EXPECT_ERROR(exporter("beams").read(exported_, "x"), "Give it by the setting beams.file");
  EXPECT_NO_THROW(check_replaces_export(path, exporter("beams")));
  EXPECT_THROW(check_replaces_export(path, exporter("matrix")), Error);
  save_result(result_with_beams(), folder_.path() / "result.yaml");
  EXPECT_THROW(check_replaces_export(folder_.path() / "result.yaml", exporter("beams")), Error);
}

TEST_F(beam_files, are_of_scans_only_where_these_were_mended) {
  ResultFile file = result_with_beams();
  EXPECT_TRUE(beams_of_scans(file).empty());
  file.findings.push_back({drive::Severity::Note, kMendedBeams, Message::verbatim("LiDAR"), {}});
  EXPECT_EQ(beams_of_scans(file).errors, some_beams().errors);
}

TEST_F(beam_files, are_of_no_use_to_sessions_without_scans) {
  cloud::BeamOptions options;
  EXPECT_TRUE(known_beams(options, {}).empty());
  options.file = folder_.write("beams.yaml", exported_).string();
  const auto session = std::make_shared<drive::Session>();
  EXPECT_ERROR(known_beams(options, {session}), "no session has scans");
}

TEST_F(beam_files, of_several_lidars_are_those_of_the_lidar_of_the_sessions) {
  VehicleFile vehicle;
  for (const char* name : {"front", "rear", "lidar"}) vehicle.lidars.push_back({name, true, result_with_beams()});
  vehicle.lidars[0].file.result.beams = {};
  vehicle.lidars[2].file.result.beams.errors *= 2.0;
  save_vehicle(vehicle, folder_.path() / "vehicle.yaml");
  cloud::BeamOptions options;
  options.file = (folder_.path() / "vehicle.yaml").string();
  const auto known_of = [&](const std::string& lidar) {
    const auto session = std::make_shared<drive::Session>();
    session->lidar_name = lidar;
    session->scans = std::make_shared<testing::NoScans>(1, 0.1);
    return known_beams(options, {session});
  };
  EXPECT_LT(largest_difference(known_of("rear"), some_beams()), 1e-14);
  EXPECT_LT((known_of("").errors - 2.0 * some_beams().errors).norm(), 1e-14) << "as the only one is called";
  EXPECT_ERROR(known_of("front"), "The method pairwise finds them");
  EXPECT_ERROR(known_of("roof"), "It has: front, rear, lidar");
  EXPECT_ERROR(load_beams(options.file), "remount-cli beams");
}

}  // namespace
}  // namespace remount::results
