#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "model/formats/documents/parse_document.h"
#include "model/formats/documents/transform_document.h"
#include "model/formats/session_readers.h"
#include "model/results/result_file.h"
#include "model/simulator/simulator.h"
#include "tests/support/calibration_checks.h"

namespace remount::simulator {
namespace {

namespace fs = std::filesystem;

class written_drive : public ::testing::Test {
 protected:
  void SetUp() override {
    folder = fs::temp_directory_path() / ("remount-" + std::to_string(::getpid()) + "-" +
                                          ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  static SimulatedDrive small_drive(bool clockwise = true) {
    SimulationOptions options;
    options.clockwise = clockwise;
    options.duration_s = 1.0;
    options.beams = 16;
    options.azimuth_steps = 200;
    return simulate_drive(options);
  }
  static std::map<std::string, std::string> contents(const fs::path& root) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
      if (!entry.is_regular_file()) continue;
      std::ostringstream text;
      text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
      files[fs::relative(entry.path(), root).string()] = text.str();
    }
    return files;
  }

  fs::path folder;
  Progress progress;
};

TEST_F(written_drive, reads_back_as_it_was_simulated) {
  const SimulatedDrive drive = small_drive();
  write_drive(drive, folder, "native", 2, progress);
  const drive::Session read = formats::open_session(folder, progress);
  ASSERT_EQ(read.scans->size(), drive.session.scans->size());
  ASSERT_EQ(read.ins.size(), drive.session.ins.size());
  EXPECT_EQ(read.scan_timing, drive::ScanTiming::PerPoint);
  EXPECT_NEAR(read.ins_position_white_sigma_m, drive.session.ins_position_white_sigma_m, 1e-12);
  for (std::size_t i = 0; i < read.scans->size(); ++i) {
    EXPECT_EQ(read.scans->stamp_ns(i), drive.session.scans->stamp_ns(i));
    const cloud::PointCloud written = drive.session.scans->load(i), found = read.scans->load(i);
    ASSERT_EQ(found.size(), written.size());
    for (std::size_t k = 0; k < found.size(); k += 11) {
      ASSERT_EQ(found.points[k], written.points[k]);
      ASSERT_NEAR(found.time_from_stamp_s[k], written.time_from_stamp_s[k], 1e-7);
    }
  }
  for (std::size_t i = 0; i < read.ins.size(); ++i)
    ASSERT_LT(read.ins[i].enu_from_ins.angularDistance(drive.session.ins[i].enu_from_ins), 1e-9);
}

TEST_F(written_drive, states_the_truth) {
  const SimulatedDrive drive = small_drive(false);
  write_drive(drive, folder, "kitti-raw", 1, progress);
  const std::string text = contents(folder).at("truth.yaml");
  const formats::DocumentNode root = formats::parse_yaml(text, "truth.yaml");
  const RigidTransform found =
      formats::transform_from_document(formats::DocumentView(*root.find("ins_from_lidar"), "truth.yaml"));
  EXPECT_LT((found.matrix() - drive.ins_from_lidar.matrix()).norm(), 1e-12);
  EXPECT_NE(text.find("azimuth_steps: 200"), std::string::npos);
}

TEST_F(written_drive, writes_the_same_bytes_for_any_number_of_threads) {
  const SimulatedDrive drive = small_drive();
  write_drive(drive, folder / "one", "native", 1, progress);
  write_drive(drive, folder / "four", "native", 4, progress);
  EXPECT_EQ(contents(folder / "one"), contents(folder / "four"));
}

TEST_F(written_drive, refuses_a_folder_that_is_not_empty_and_unknown_formats) {
  const SimulatedDrive drive = small_drive();
  fs::create_directories(folder);
  std::ofstream(folder / "precious") << "data";
  EXPECT_THROW(write_drive(drive, folder, "native", 1, progress), Error);
  EXPECT_THROW(write_drive(drive, folder / "new", "bag", 1, progress), Error);
}

// Nothing in a KITTI drive says in which sense its LiDAR turns: readers know, and compensate by it.
TEST_F(written_drive, as_kitti_raw_gives_its_truth_when_it_is_calibrated) {
  SimulationOptions options;
  options.beams = 32;
  options.azimuth_steps = 600;
  options.clockwise = false;
  const SimulatedDrive drive = simulate_drive(options);
  write_drive(drive, folder, "kitti-raw", 0, progress);
  pipeline::PipelineInput input;
  input.sessions.push_back(std::make_shared<drive::Session>(formats::open_session(folder, progress)));
  EXPECT_TRUE(input.sessions[0]->sweep.certain);
  input.settings.pairing.max_partners = 4;
  input.settings.run.map_check = false;
  const calibration::CalibrationResult result = pipeline::run_pipeline(input, progress).result;
  const testing::CalibrationError error = testing::error_of(result, drive.ins_from_lidar);
  EXPECT_TRUE(calibration::is_usable(result)) << english(result.message);
  EXPECT_LE(error.rotation_deg, 0.05);
  EXPECT_LE(std::abs(error.x_m), 0.02);
  EXPECT_LE(std::abs(error.y_m), 0.02);
}

TEST_F(written_drive, is_not_written_as_kitti_raw_where_its_readers_would_compensate_it_wrongly) {
  SimulationOptions options;
  options.duration_s = 1.0;
  options.motion_distortion = false;
  EXPECT_THROW(write_drive(simulate_drive(options), folder, "kitti-raw", 1, progress), Error);
  EXPECT_FALSE(fs::exists(folder));
}

}  // namespace
}  // namespace remount::simulator
