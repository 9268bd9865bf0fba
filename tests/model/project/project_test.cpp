#include "model/project/project.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "model/formats/files/input_file.h"
#include "model/settings/settings_file.h"

namespace remount::project {
namespace {

class project : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("remount_project_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_ / "jobs");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string error_of(const std::string& text) const {
    std::ofstream(folder_ / "bad.remount") << text;
    try {
      load_project(folder_ / "bad.remount");
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path folder_;
};

Project example(const std::filesystem::path& folder) {
  Project project;
  project.sessions = {folder / "drives" / "one", folder / "two"};
  project.settings.pairing.max_gap_s = 2.5;
  project.nominal_ins_from_lidar = rigid_from_six({1, 0, 1, 0.1, 0, 0});
  project.verdicts.push_back(
      {motion::SessionIndex{1}, 100, 200, motion::PairState::Rejected, Message::verbatim("a lorry")});
  pipeline::PipelineOutput output;
  constexpr motion::SessionIndex kSecond{1};
  output.keyframes = {{kSecond, motion::ScanIndex{0}, 100, 0.0},
                      {kSecond, motion::ScanIndex{5}, 200, 3.0},
                      {kSecond, motion::ScanIndex{9}, 300, 6.0}};
  for (int i = 0; i < 2; ++i) {
    motion::Pair pair;
    pair.keyframe_a = index_at<motion::KeyframeIndex>(i), pair.keyframe_b = index_at<motion::KeyframeIndex>(i + 1);
    pair.gap_s = 0.1;
    pair.ins_b_from_ins_a = rigid_from_six({1, 2, 3, 0.1, 0.2, 0.3});
    pair.lidar_b_from_lidar_a = rigid_from_six({3, 2, 1, -0.1, 0.2, 0.3});
    pair.registration.information = Matrix6d::Identity() * 7;
    pair.registration.information(0, 5) = pair.registration.information(5, 0) = 0.25;
    pair.registration.rmse_m = std::nan("");
    pair.state = motion::PairState::Accepted;
    pair.decided_by = motion::DecidedBy::Program;
    output.pairs.push_back(pair);
  }
  output.result.status = calibration::Status::Ok;
  output.result.set_observed(calibration::ParameterSet::all(), {});
  output.result.covariance = Matrix6d::Identity() * 1e-6;
  output.result.mounting.reference_from_sensor = rigid_from_six({0.9, 0, 1, 0.1, 0, 0});
  output.findings.push_back(
      {drive::Severity::Warning, "ins-gap", std::string("ins.csv"), Message::verbatim("a gap of 2 s")});
  output.initial_ins_from_lidar = *project.nominal_ins_from_lidar;
  output.nominal_known = true;
  output.session_uses_sweep = {true, false};
  output.clock_bias = Vector6d::Constant(0.25);
  output.up_in_lidar = Eigen::Vector3d(0.0, 0.6, 0.8);
  project.output = output;
  project.basis = {2, project.settings, project.nominal_ins_from_lidar};
  project.inputs.push_back({"one", "ins.csv", 5, "abc"});
  return project;
}

TEST_F(project, reads_back_what_it_saved) {
  const auto path = folder_ / "jobs" / "a.remount";
  save_project(example(folder_), path);
  const Project back = load_project(path);
  EXPECT_EQ(back.sessions, (std::vector<std::filesystem::path>{folder_ / "drives" / "one", folder_ / "two"}));
  EXPECT_EQ(settings::settings_text(back.settings), settings::settings_text(example(folder_).settings));
  EXPECT_EQ(english(back.verdicts.at(0).reason), "a lorry");
  ASSERT_TRUE(back.output && back.nominal_ins_from_lidar);
  EXPECT_EQ(back.output->pairs.size(), 2U);
  EXPECT_EQ(back.output->pairs[1].registration.information, example(folder_).output->pairs[1].registration.information);
  EXPECT_LT(
      (back.output->pairs[1].lidar_b_from_lidar_a.matrix() - rigid_from_six({3, 2, 1, -0.1, 0.2, 0.3}).matrix()).norm(),
      1e-14);
  EXPECT_EQ(back.output->findings.at(0).code, "ins-gap");
  EXPECT_EQ(back.output->session_uses_sweep, (std::vector<bool>{true, false}));
  EXPECT_EQ(back.output->clock_bias, example(folder_).output->clock_bias);
  EXPECT_EQ(back.output->up_in_lidar, example(folder_).output->up_in_lidar);
  EXPECT_EQ(back.inputs.at(0).sha256, "abc");
  const std::string first = formats::read_regular_file(path);
  save_project(back, path);
  const Project again = load_project(path);
  EXPECT_EQ(again.output->result.mounting.reference_from_sensor.matrix(),
            back.output->result.mounting.reference_from_sensor.matrix());
  EXPECT_EQ(formats::read_regular_file(path).size(), first.size());
}

TEST_F(project, knows_that_its_solution_does_not_answer_the_decisions) {
  const auto path = folder_ / "a.remount";
  Project pending = example(folder_);
  save_project(pending, path);
  EXPECT_FALSE(load_project(path).solution_pending);
  pending.solution_pending = true;
  save_project(pending, path);
  EXPECT_TRUE(load_project(path).solution_pending);
  EXPECT_EQ(load_project(path).changes_since_calibration().size(), 1U);
}

TEST_F(project, remembers_that_its_result_was_confirmed_and_exported) {
  const auto path = folder_ / "a.remount";
  Project kept = example(folder_);
  save_project(kept, path);
  for (const char* key : {"confirmed", "exported"})
    EXPECT_FALSE(formats::read_regular_file(path).find(key) != std::string::npos)
        << "as files of earlier versions: " << key;
  EXPECT_FALSE(load_project(path).confirmed);
  EXPECT_FALSE(load_project(path).exported);
  kept.confirmed = true;
  save_project(kept, path);
  EXPECT_TRUE(load_project(path).confirmed);
  EXPECT_FALSE(load_project(path).exported);
  kept.exported = true;
  save_project(kept, path);
  EXPECT_TRUE(load_project(path).exported);
}

TEST_F(project, knows_that_a_calibration_was_made_with_other_settings) {
  const auto path = folder_ / "a.remount";
  Project edited = example(folder_);
  EXPECT_TRUE(edited.changes_since_calibration().empty());
  edited.settings.pairing.max_gap_s = 1.25;
  edited.settings.run.cache_mb = 77;
  edited.nominal_ins_from_lidar.reset();
  edited.sessions.push_back(folder_ / "three");
  save_project(edited, path);
  const Project back = load_project(path);
  EXPECT_EQ(back.settings.pairing.max_gap_s, 1.25);
  EXPECT_EQ(back.basis.settings.pairing.max_gap_s, 2.5);
  EXPECT_EQ(english(back.changes_since_calibration()),
            (std::vector<std::string>{"2 sessions, now 3", "nominal mounting given, now unknown",
                                      "pairing.max_gap_s 2.5, now 1.25"}));
}

TEST_F(project, an_untouched_project_reopens_as_current) {
  save_project(example(folder_), folder_ / "a.remount");
  EXPECT_TRUE(load_project(folder_ / "a.remount").changes_since_calibration().empty());
}

TEST_F(project, moves_with_its_data) {
  save_project(example(folder_ / "jobs"), folder_ / "jobs" / "a.remount");
  std::filesystem::rename(folder_ / "jobs", folder_ / "moved");
  EXPECT_EQ(load_project(folder_ / "moved" / "a.remount").sessions.at(0), folder_ / "moved" / "drives" / "one");
}

TEST_F(project, what_was_moved_together_is_found_together) {
  const std::filesystem::path old_place = "/gone/2026/drives", now = folder_ / "disk" / "2026" / "drives";
  std::filesystem::create_directories(now / "one");
  std::filesystem::create_directories(now / "two");
  EXPECT_EQ(relocate(old_place / "two", old_place / "one", now / "one"), now / "two");
  EXPECT_EQ(relocate(old_place / "three", old_place / "one", now / "one"), "") << "nothing lies there";
  EXPECT_EQ(relocate("/elsewhere/two", old_place / "one", now / "one"), "") << "it was not below the moved folder";
  EXPECT_EQ(relocate(old_place / "two", old_place / "one", folder_ / "renamed"), "");
}

TEST_F(project, says_what_is_wrong_and_where) {
  EXPECT_NE(error_of("format: remount-project/3\n").find("bad.remount:1: format: is \"remount-project/3\""),
            std::string::npos)
      << error_of("format: remount-project/3\n");
  EXPECT_NE(error_of("format: remount-project/3\n").find("later version"), std::string::npos);
  EXPECT_NE(error_of("x: 1\n").find("\"format\" is missing"), std::string::npos);
  EXPECT_NE(error_of("[1]").find("expected a map"), std::string::npos);
  EXPECT_NE(error_of("").find("empty"), std::string::npos);
  const auto path = folder_ / "a.remount";
  save_project(example(folder_), path);
  std::string text = formats::read_regular_file(path);
  text.replace(text.find("keyframe_b: 1"), 13, "keyframe_b: 9");
  EXPECT_NE(error_of(text).find("keyframe_b: expected a whole number from 0 to 2"), std::string::npos)
      << error_of(text);
}

}  // namespace
}  // namespace remount::project
