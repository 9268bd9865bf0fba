#include "model/fleet/fleet.h"

#include <gtest/gtest.h>

#include <fstream>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "model/formats/documents/document.h"
#include "tests/model/formats/random_values.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::fleet {
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
      EXPECT_NE(english(error.what_happened()).find(expectation), std::string::npos) << error.what();
    }
  }

  formats::TemporaryFolder folder_;
};

constexpr const char* kFleetHead = "format: remount-fleet/1\n";

TEST_F(fleet_file, every_entry_of_sessions_is_a_job_with_files_of_its_own) {
  const Fleet fleet = read(std::string(kFleetHead) +
                           "results: made\n"
                           "drift: {sigmas: 4, translation_m: 0.05, rotation_deg: 0.5}\n"
                           "settings: {pairing: {max_gap_s: 3}, beams: {file: b/beams.yaml}}\n"
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
  EXPECT_EQ(fleet.vehicles[0].settings.beams.file, (here / "b/beams.yaml").string());
  EXPECT_EQ(fleet.vehicles[0].nominal, "1.2,0,1.6,-90,0,0");
  EXPECT_EQ(fleet.vehicles[0].last.file, here / "old/bus12.yaml");
  EXPECT_EQ(fleet.vehicles[0].reference.file, here / "new/bus12.yaml");
  EXPECT_TRUE(fleet.vehicles[1].reference.file.empty());
  EXPECT_EQ(fleet.vehicles[1].nominal, "apollo-rfu:" + (here / "x/novatel.yaml").string());
  EXPECT_EQ(fleet.vehicles[0].settings.pairing.max_gap_s, 3.0) << "of the fleet";
  EXPECT_EQ(fleet.vehicles[0].settings.pairing.min_distance_m, 0.5) << "of the vehicle";
  EXPECT_EQ(fleet.vehicles[1].settings.pairing.min_distance_m, settings::Settings{}.pairing.min_distance_m);
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
  const std::string vehicle = std::string(kFleetHead) + "vehicles:\n  - name: v\n    sessions: ";
  const Fleet before = read(vehicle + "[b/drive]\n"), after = read(vehicle + "[a/drive, b/drive, [b/drive, c]]\n");
  EXPECT_EQ(before.jobs[0].result, after.jobs[1].result);
  EXPECT_EQ(before.jobs[0].result.extension(), ".yaml");
  EXPECT_EQ(before.results.filename(), "fleet.results") << "where the file names no folder";
}

TEST_F(fleet_file, topics_of_a_vehicle_change_those_of_the_fleet_role_by_role) {
  const Fleet fleet = read(std::string(kFleetHead) +
                           "topics: {lidar: /front/points, ins: /novatel/oem7/inspvax, gnss: none}\n"
                           "vehicles:\n"
                           "  - {name: front, sessions: [drive.bag]}\n"
                           "  - {name: rear, topics: {lidar: /rear/points, gnss: null}, sessions: [drive.bag]}\n");
  const drive::TopicChoice front{{"lidar", "/front/points"}, {"ins", "/novatel/oem7/inspvax"}, {"gnss", "none"}};
  EXPECT_EQ(fleet.vehicles[0].topics, front);
  EXPECT_EQ(fleet.vehicles[1].topics,
            (drive::TopicChoice{{"lidar", "/rear/points"}, {"ins", "/novatel/oem7/inspvax"}}));
  EXPECT_NE(fleet.jobs[0].result, fleet.jobs[1].result) << "two LiDARs of one bag";
  EXPECT_TRUE(read(std::string(kFleetHead) + "vehicles: [{name: v, sessions: [a]}]\n").vehicles[0].topics.empty());
}

TEST_F(fleet_file, errors_name_file_line_and_expectation) {
  const std::string head = kFleetHead, one = "  - name: v\n    sessions: [a]\n";
  refuses("vehicles: []\n", ":1", "\"format\" is missing");
  refuses("[1, 2]\n", ":1", "format: remount-fleet/1");
  refuses("format: remount-session/1\n", ":1", "expected \"remount-fleet/1\"");
  refuses(head + "vehicles: []\n", ":2", "expected at least one vehicle");
  refuses(head + "vehicels: []\n", ":2", "known are format, results, drift, settings, topics, lidars, vehicles");
  refuses(head + "vehicles:\n  - sessions: [a]\n", ":3", "\"name\" is missing");
  refuses(head + "vehicles:\n  - name: v\n", ":3", "\"sessions\" is missing");
  refuses(head + "vehicles:\n  - name: v\n    sessions: []\n", ":4", "the oldest first");
  refuses(head + "vehicles:\n  - name: v\n    sessions: [a, []]\n", ":4", "a session or a list");
  refuses(head + "vehicles:\n  - name: v\n    sessions: [a, {b: c}]\n", ":4", "known are sessions, lidars");
  refuses(head + "vehicles:\n  - name: v\n    sessions:\n      - a\n      - b\n      - a\n", ":7", "stands in line 5");
  refuses(head + "vehicles:\n  - name: ../v\n    sessions: [a]\n", ":3", "names a folder of results");
  refuses(head + "vehicles:\n" + one + one, ":5", "names a vehicle before it already");
  refuses(head + "vehicles:\n" + one + "    nominal: [1, 2, 3]\n", ":5", "expected a list of 6 numbers");
  refuses(head + "vehicles:\n" + one + "    settings: {pairing: {max_gap: 3}}\n", "", "fleet.yaml:5");
  refuses(head + "drift: {sigmas: 0}\nvehicles:\n" + one, ":2", "expected a number above 0");
  refuses(head + "drift: {rotation_deg: -1}\nvehicles:\n" + one, ":2", "not below 0");
  refuses(head + "drift: {metres: 1}\nvehicles:\n" + one, ":2", "known are sigmas, translation_m, rotation_deg");
  refuses(head + "topics: {camera: /x}\nvehicles:\n" + one, ":2", "known are lidar, ins, ins-position, gnss, imu");
  refuses(head + "topics: [lidar=/x]\nvehicles:\n" + one, ":2", "expected a map");
  refuses(head + "vehicles:\n" + one + "    topics: {lidar: ''}\n", ":5", "expected a topic of a bag");
  refuses(head + "vehicles:\n" + one + "    topics: {lidar: [/a, /b]}\n", ":5", "expected a text");
  EXPECT_THROW(load_fleet(folder_.path() / "none.yaml"), Error);
}

/// As JSON, which is YAML as well, writes a text.
std::string in_quotes(const std::string& text) {
  std::string line = formats::to_json(formats::DocumentNode::string(text));
  line.resize(line.find_last_of('"') + 1);
  return line;
}

TEST_F(fleet_file, any_fleet_reads_back_as_it_was_written) {
  formats::RandomValues random(39);
  std::size_t jobs = 0;
  for (int draw = 0; draw < 100; ++draw) {
    SCOPED_TRACE("draw " + std::to_string(draw));
    const auto topics_text = [&](drive::TopicChoice& topics) {
      std::string text;
      for (const std::string_view role : drive::kTopicRoles) {
        if (random.flip()) continue;
        const std::string topic = random.below(3) == 0 ? "none" : "/" + random.text();
        topics.insert_or_assign(std::string(role), topic);
        text += (text.empty() ? "" : ", ") + std::string(role) + ": " + in_quotes(topic);
      }
      return "topics: {" + text + "}\n";
    };
    Fleet written;
    drive::TopicChoice of_all;
    written.drift = {random.between(0.1, 9.0), random.between(0.0, 1.0), random.between(0.0, 5.0)};
    std::string text = std::string(kFleetHead) + "drift: {sigmas: " + formats::shortest(written.drift.sigmas) +
                       ", translation_m: " + formats::shortest(written.drift.translation_m) +
                       ", rotation_deg: " + formats::shortest(written.drift.rotation_deg) + "}\n" +
                       topics_text(of_all) + "vehicles:\n";
    for (std::size_t v = 0, count = 1 + random.below(4); v < count; ++v) {
      FleetVehicle& vehicle = written.vehicles.emplace_back();
      vehicle.name = "v" + std::to_string(v) + (random.flip() ? " \xe5\x85\xac\xe4\xba\xa4 'a': \"b\" #1" : "");
      vehicle.topics = of_all;
      text += "  - name: " + in_quotes(vehicle.name) + "\n    " + topics_text(vehicle.topics);
      std::string lidars;
      if (!vehicle.topics.contains("lidar") && random.flip()) {  // a topic chooses the LiDAR
        lidars = random.flip() ? "all" : "/front/points,r" + std::to_string(v);
        text += "    lidars: " + (lidars == "all" ? lidars : "[" + lidars + "]") + "\n";
      } else if (random.flip()) {
        std::string list;
        for (int i = 0; i < 6; ++i) {
          const std::string number = formats::shortest(random.between(-180.0, 180.0));
          vehicle.nominal += (i > 0 ? "," : "") + number, list += (i > 0 ? ", " : "") + number;
        }
        text += "    nominal: [" + list + "]\n";
      }
      text += "    sessions:\n";
      for (std::size_t s = 0, sessions = 1 + random.below(4); s < sessions; ++s) {
        FleetJob& job = written.jobs.emplace_back();
        job.lidars = lidars;
        std::string list;
        for (std::size_t i = 0, paths = 1 + random.below(3); i < paths; ++i) {
          const std::string path = "s" + std::to_string(s) + std::to_string(i) + random.text();
          job.sessions.push_back((folder_.path() / path).lexically_normal());
          list += (i > 0 ? ", " : "") + in_quotes(path);
        }
        text += "      - [" + list + "]\n";
      }
    }
    const Fleet read = this->read(text);
    EXPECT_EQ(read.drift.sigmas, written.drift.sigmas);
    EXPECT_EQ(read.drift.translation_m, written.drift.translation_m);
    EXPECT_EQ(read.drift.rotation_deg, written.drift.rotation_deg);
    ASSERT_EQ(read.vehicles.size(), written.vehicles.size());
    for (std::size_t v = 0; v < read.vehicles.size(); ++v) {
      EXPECT_EQ(read.vehicles[v].name, written.vehicles[v].name);
      EXPECT_EQ(read.vehicles[v].topics, written.vehicles[v].topics);
      EXPECT_EQ(read.vehicles[v].nominal, written.vehicles[v].nominal);
    }
    ASSERT_EQ(read.jobs.size(), written.jobs.size());
    for (std::size_t j = 0; j < read.jobs.size(); ++j) {
      EXPECT_EQ(read.jobs[j].sessions, written.jobs[j].sessions);
      EXPECT_EQ(read.jobs[j].lidars, written.jobs[j].lidars);
    }
    jobs += read.jobs.size();
  }
  std::printf("100 fleets with %zu jobs\n", jobs);
}

TEST_F(fleet_file, names_become_plain_file_names_whatever_sessions_are_called) {
  const Fleet fleet =
      read(std::string(kFleetHead) + "vehicles:\n  - name: ü-Bahn\n    sessions: ['../../../etc/x y;$(z)', " + "'" +
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
}  // namespace remount::fleet
