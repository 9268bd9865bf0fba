#include "model/batch/fleet.h"

#include <gtest/gtest.h>

#include <fstream>

#include "algorithms/core/error.h"
#include "tests/model/io/temporary_folder.h"

namespace remount {
namespace {

class fleet_file : public ::testing::Test {
 protected:
  Fleet read(const std::string& text) {
    std::ofstream(folder_.path() / "fleet.yaml") << text;
    return load_fleet(folder_.path() / "fleet.yaml");
  }
  void refuses(const std::string& text, const std::string& where, const std::string& expectation) {
    try {
      read(text);
      ADD_FAILURE() << "accepted:\n" << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::Format) << error.what();
      EXPECT_NE(std::string(error.what()).find("fleet.yaml" + where), std::string::npos) << error.what() << "\nof\n"
                                                                                         << text;
      EXPECT_NE(error.what_happened().find(expectation), std::string::npos) << error.what();
    }
  }

  TemporaryFolder folder_;
};

constexpr const char* kHead = "format: remount-fleet/1\n";

TEST_F(fleet_file, every_entry_of_sessions_is_a_job_with_files_of_its_own) {
  const Fleet fleet = read(std::string(kHead) +
                           "results: made\n"
                           "drift: {sigmas: 4, translation_m: 0.05, rotation_deg: 0.5}\n"
                           "settings: {pairing: {max_gap_s: 3}}\n"
                           "vehicles:\n"
                           "  - name: bus 12\n"
                           "    nominal: [1.2, 0, 1.6, -90, 0, 0]\n"
                           "    last: old/bus12.yaml\n"
                           "    reference: new/bus12.yaml\n"
                           "    settings: {pairing: {min_distance_m: 0.5}}\n"
                           "    sessions: [mon/drive, [tue/a, tue/b], /abs/drive]\n"
                           "  - {name: bus 13, nominal: apollo-rfu:x/novatel.yaml, sessions: [mon/drive]}\n");
  ASSERT_EQ(fleet.jobs.size(), 4U);
  ASSERT_EQ(fleet.vehicles.size(), 2U);
  const std::filesystem::path here = folder_.path();
  EXPECT_EQ(fleet.results, here / "made");
  EXPECT_EQ(fleet.vehicles[0].nominal, "1.2,0,1.6,-90,0,0");
  EXPECT_EQ(fleet.vehicles[0].last, here / "old/bus12.yaml");
  EXPECT_EQ(fleet.vehicles[0].reference, here / "new/bus12.yaml");
  EXPECT_TRUE(fleet.vehicles[1].reference.empty());
  EXPECT_EQ(fleet.vehicles[1].nominal, "apollo-rfu:" + (here / "x/novatel.yaml").string());
  EXPECT_EQ(fleet.vehicles[0].settings.pairing.max_gap_s, 3.0) << "of the fleet";
  EXPECT_EQ(fleet.vehicles[0].settings.pairing.min_distance_m, 0.5) << "of the vehicle";
  EXPECT_EQ(fleet.vehicles[1].settings.pairing.min_distance_m, Settings{}.pairing.min_distance_m);
  EXPECT_EQ(fleet.drift.sigmas, 4.0);
  EXPECT_EQ(fleet.drift.translation_m, 0.05);
  EXPECT_EQ(fleet.drift.rotation_deg, 0.5);
  EXPECT_EQ(fleet.jobs[1].sessions, (std::vector{here / "tue/a", here / "tue/b"}));
  EXPECT_EQ(fleet.jobs[2].sessions, std::vector{std::filesystem::path("/abs/drive")});
  EXPECT_EQ(title_of(fleet, fleet.jobs[1]), "bus 12, tue/a + tue/b");
  EXPECT_EQ(fleet.jobs[0].result.parent_path(), here / "made/bus 12");
  for (std::size_t a = 0; a < fleet.jobs.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) EXPECT_NE(fleet.jobs[a].result, fleet.jobs[b].result);
}

TEST_F(fleet_file, a_job_keeps_its_files_when_others_are_added_before_it) {
  const std::string vehicle = std::string(kHead) + "vehicles:\n  - name: v\n    sessions: ";
  const Fleet before = read(vehicle + "[b/drive]\n"), after = read(vehicle + "[a/drive, b/drive, [b/drive, c]]\n");
  EXPECT_EQ(before.jobs[0].result, after.jobs[1].result);
  EXPECT_EQ(before.jobs[0].result.extension(), ".yaml");
  EXPECT_EQ(before.results.filename(), "fleet.results") << "where the file names no folder";
}

TEST_F(fleet_file, errors_name_file_line_and_expectation) {
  const std::string head = kHead, one = "  - name: v\n    sessions: [a]\n";
  refuses("vehicles: []\n", ":1", "\"format\" is missing");
  refuses("[1, 2]\n", ":1", "format: remount-fleet/1");
  refuses("format: remount-session/1\n", ":1", "expected \"remount-fleet/1\"");
  refuses(head + "vehicles: []\n", ":2", "expected at least one vehicle");
  refuses(head + "vehicels: []\n", ":2", "known are format, results, drift, settings, vehicles");
  refuses(head + "vehicles:\n  - sessions: [a]\n", ":3", "\"name\" is missing");
  refuses(head + "vehicles:\n  - name: v\n", ":3", "\"sessions\" is missing");
  refuses(head + "vehicles:\n  - name: v\n    sessions: []\n", ":4", "the oldest first");
  refuses(head + "vehicles:\n  - name: v\n    sessions: [a, []]\n", ":4", "a session or a list");
  refuses(head + "vehicles:\n  - name: v\n    sessions: [a, {b: c}]\n", ":4", "expected a text, found a map");
  refuses(head + "vehicles:\n  - name: v\n    sessions:\n      - a\n      - b\n      - a\n", ":7", "stands in line 5");
  refuses(head + "vehicles:\n  - name: ../v\n    sessions: [a]\n", ":3", "names a folder of results");
  refuses(head + "vehicles:\n" + one + one, ":5", "names a vehicle before it already");
  refuses(head + "vehicles:\n" + one + "    nominal: [1, 2, 3]\n", ":5", "expected a list of 6 numbers");
  refuses(head + "vehicles:\n" + one + "    settings: {pairing: {max_gap: 3}}\n", "", "fleet.yaml:5");
  refuses(head + "drift: {sigmas: 0}\nvehicles:\n" + one, ":2", "expected a number above 0");
  refuses(head + "drift: {rotation_deg: -1}\nvehicles:\n" + one, ":2", "not below 0");
  refuses(head + "drift: {metres: 1}\nvehicles:\n" + one, ":2", "known are sigmas, translation_m, rotation_deg");
  EXPECT_THROW(load_fleet(folder_.path() / "none.yaml"), Error);
}

TEST_F(fleet_file, names_become_plain_file_names_whatever_sessions_are_called) {
  const Fleet fleet =
      read(std::string(kHead) + "vehicles:\n  - name: ü-Bahn\n    sessions: ['../../../etc/x y;$(z)', " + "'" +
           std::string(300, 'q') + "/drive', '...']\n");
  for (const FleetJob& job : fleet.jobs) {
    const std::string name = job.result.filename().string();
    EXPECT_LT(name.size(), 200U);
    EXPECT_EQ(name.find_first_of(" /;$()"), std::string::npos) << name;
    EXPECT_NE(name.front(), '.') << name;
    EXPECT_EQ(job.result.parent_path(), fleet.results / "ü-Bahn");
  }
}

}  // namespace
}  // namespace remount
