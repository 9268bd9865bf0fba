#include "model/settings/settings_file.h"

#include <gtest/gtest.h>

#include "algorithms/core/error.h"
#include "model/formats/documents/parse_document.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::settings {
namespace {

Settings from_text(const std::string& text) {
  const formats::DocumentNode document = formats::parse_yaml(text, "c.yaml");
  return settings_from_document(formats::DocumentView(document, "c.yaml"));
}

std::string error_of(const std::string& text) {
  try {
    from_text(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(settings_file, written_settings_read_back_the_same) {
  Settings settings;
  settings.run.deskew = DeskewMode::Off;
  settings.pairing.max_gap_s = 0.1 + 0.2;
  settings.registration.algorithm = registration::RegistrationAlgorithm::PclNdt;
  settings.solve.joint_clouds = false;
  settings.solve.max_listed_candidates = 77;
  settings.range.x_min_m = -1.25;
  for (const bool comments : {false, true}) {
    const Settings back = from_text(settings_text(settings, comments));
    EXPECT_EQ(settings_text(back), settings_text(settings));
    EXPECT_EQ(back.run.deskew, DeskewMode::Off);
    EXPECT_EQ(back.pairing.max_gap_s, 0.1 + 0.2);
    EXPECT_EQ(back.registration.algorithm, registration::RegistrationAlgorithm::PclNdt);
    EXPECT_FALSE(back.solve.joint_clouds);
    EXPECT_EQ(back.solve.max_listed_candidates, 77);
  }
}

TEST(settings_file, defaults_are_valid_and_every_setting_is_explained) {
  EXPECT_TRUE(Settings{}.check().empty());
  const std::string text = settings_text(Settings{});
  Settings settings;
  Settings::visit_sections(settings, [&](std::string_view name, auto&) {
    EXPECT_NE(text.find(std::string(name) + ":\n"), std::string::npos) << name;
  });
  EXPECT_NE(text.find("# Longest time between the two scans of a pair (limit time). [0.01 to 3600 s]"),
            std::string::npos)
      << text;
}

TEST(settings_file, paths_are_relative_to_the_file_or_to_where_they_are_typed) {
  const formats::TemporaryFolder folder;
  const Settings read = load_settings(folder.write("sub/settings.yaml", "beams: {file: ../beams.yaml}\n"));
  EXPECT_EQ(read.beams.file, (folder.path() / "beams.yaml").string());
  EXPECT_EQ(load_settings(folder.write("other.yaml", "run:\n"), read).beams.file, read.beams.file);
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path() / "sub");
  const Settings by_bare_name = load_settings("settings.yaml");
  std::filesystem::current_path(before);
  EXPECT_EQ(by_bare_name.beams.file, read.beams.file) << "a name without a folder";
  Settings typed;
  apply_setting(typed, "beams.file=beams.yaml");
  EXPECT_EQ(typed.beams.file, (std::filesystem::current_path() / "beams.yaml").string());
  EXPECT_EQ(from_text(settings_text(typed)).beams.file, typed.beams.file) << "in projects and results";
  apply_setting(typed, "beams.file=");
  EXPECT_EQ(typed.beams.file, "") << "none";
}

TEST(settings_file, what_is_left_out_keeps_its_value) {
  const Settings settings = from_text("pairing:\n  max_gap_s: 2.5\nrange:\n");
  EXPECT_EQ(settings.pairing.max_gap_s, 2.5);
  EXPECT_EQ(settings.pairing.max_distance_m, motion::PairingOptions{}.max_distance_m);
}

TEST(settings_file, files_of_before_with_settings_that_are_gone_are_read) {
  const Settings settings = from_text("solve:\n  bootstrap_samples: 100\n  seed: 1\n  joint_clouds: false\n");
  EXPECT_FALSE(settings.solve.joint_clouds);
  EXPECT_NE(error_of("solve:\n  seeds: 1\n"), "");
}

TEST(settings_file, every_problem_is_listed_with_its_line) {
  const std::string error = error_of(
      "pairing:\n  max_gap_s: 1e9\n  max_gap: 3\n  limit: often\nrun:\n  cache_mb: 1.5\nsolve:\n  joint_clouds: "
      "1\nplanes: 3\n");
  for (const char* expected :
       {"c.yaml:2: pairing.max_gap_s: 1e+09 s is outside 0.01 to 3600 s", "c.yaml:3: pairing.max_gap: is not a setting",
        "c.yaml:4: pairing.limit: expected one of time, distance, either",
        "c.yaml:6: run.cache_mb: expected a whole number", "c.yaml:8: solve.joint_clouds: expected true or false",
        "c.yaml:9: planes: is not a section"})
    EXPECT_NE(error.find(expected), std::string::npos) << expected << "\nin\n" << error;
}

TEST(settings_file, a_minimum_above_its_maximum_is_refused) {
  EXPECT_NE(error_of("range: {x_min_m: 2, x_max_m: 1}").find("range.x: the minimum 2 m exceeds the maximum 1 m"),
            std::string::npos);
  EXPECT_NE(error_of("[1, 2]").find("expected a map"), std::string::npos);
  EXPECT_NE(error_of("pairing: 3").find("c.yaml:1: pairing: expected a map"), std::string::npos)
      << error_of("pairing: 3");
}

TEST(settings_file, a_full_turn_may_be_rounded_up) {
  for (const char* typed : {"3.15", "3.1416", "3.141592653589793"}) {
    const Settings settings =
        from_text(std::string("range:\n  yaw_min_rad: -") + typed + "\n  roll_max_rad: " + typed + "\n");
    EXPECT_EQ(settings.range.yaw_min_rad, calibration::SearchRange{}.yaw_min_rad) << typed;
    EXPECT_EQ(settings.range.roll_max_rad, calibration::SearchRange{}.roll_max_rad) << typed;
    EXPECT_TRUE(settings.check().empty()) << typed;
  }
  EXPECT_EQ(from_text("range:\n  yaw_max_rad: 3.14\n").range.yaw_max_rad, 3.14);
  EXPECT_NE(error_of("range:\n  yaw_max_rad: 3.2\n"), "");
}

TEST(settings_file, every_pair_of_limits_that_contradict_each_other_is_named_with_both_values) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"keyframes: {minimum: 500, maximum: 50}", "keyframes.minimum = 500 exceeds keyframes.maximum = 50"},
      {"pairing: {min_distance_m: 20}", "pairing.min_distance_m = 20 exceeds pairing.max_distance_m = 10"},
      {"objects: {min_points: 9000, max_points: 8000}", "objects.min_points = 9000 exceeds objects.max_points = 8000"},
      {"registration: {min_range_m: 30, max_range_m: 20}",
       "registration.min_range_m = 30 exceeds registration.max_range_m = 20"},
      {"registration: {min_range_m: 30}\nobjects: {max_range_m: 25}",
       "registration.min_range_m = 30 exceeds objects.max_range_m = 25"}};
  for (const auto& [text, said] : cases) EXPECT_NE(error_of(text).find(said), std::string::npos) << error_of(text);
  EXPECT_EQ(error_of("pairing: {limit: time, min_distance_m: 20}"), "") << "the other distance is not used then";
  EXPECT_EQ(error_of("keyframes: {minimum: 50, maximum: 50}"), "");
}

TEST(settings_file, two_assignments_may_contradict_each_other_until_both_are_made) {
  Settings settings;
  apply_setting(settings, "range.x_min_m=6");
  EXPECT_THROW(require_valid(settings), Error);
  apply_setting(settings, "range.x_max_m=8");
  EXPECT_NO_THROW(require_valid(settings));
}

TEST(settings_file, one_setting_from_an_assignment) {
  Settings settings;
  apply_setting(settings, "registration.algorithm=pcl-gicp");
  apply_setting(settings, "solve.joint_clouds=false");
  apply_setting(settings, "range.x_min_m=-2");
  EXPECT_EQ(settings.registration.algorithm, registration::RegistrationAlgorithm::PclGicp);
  EXPECT_FALSE(settings.solve.joint_clouds);
  EXPECT_EQ(settings.range.x_min_m, -2.0);
  for (const char* wrong : {"solve", "solve.joint_clouds", "joint_clouds=true", "solve.nothing=1",
                            "solve.max_listed_candidates=x", "a.b=[", "x.y="})
    EXPECT_THROW(apply_setting(settings, wrong), Error) << wrong;
}

TEST(settings_file, a_malformed_assignment_is_wrong_usage_and_is_told_what_the_setting_takes) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"solve.joint_clouds=", R"(solve.joint_clouds: expected true or false, found "")"},
      {"solve.joint_clouds={", R"(solve.joint_clouds: expected true or false, found "{")"},
      {"keyframes.minimum=", R"(keyframes.minimum: expected a whole number from 2 to 10000, found "")"},
      {"keyframes.minimum=a: b: c", "keyframes.minimum: expected a whole number from 2 to 10000"},
      {"pairing.max_gap_s=", R"(pairing.max_gap_s: expected a number from 0.01 to 3600 s, found "")"},
      {"pairing.limit=", R"(pairing.limit: expected one of time, distance, either; found "")"},
      {"pairing.limit=&a", R"(pairing.limit: expected one of time, distance, either; found "&a")"},
      {"solve.x=", "solve.x: is not a setting; known here are"},
      {"solve=", "expected section.key=value"}};
  for (const auto& [assignment, said] : cases) {
    Settings settings;
    try {
      apply_setting(settings, assignment);
      ADD_FAILURE() << assignment;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::Contract) << assignment;
      EXPECT_TRUE(std::string(error.what()).starts_with("--set " + assignment + ": ")) << error.what();
      EXPECT_NE(std::string(error.what()).find(said), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace remount::settings
