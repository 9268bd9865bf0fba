#include "model/fleet/lidar_keys.h"

#include <gtest/gtest.h>

#include <fstream>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "model/fleet/failed_job.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::fleet {
namespace {

class fleet_lidars : public ::testing::Test {
 protected:
  Fleet read(const std::string& text) {
    std::ofstream(folder_.path() / "fleet.yaml") << "format: remount-fleet/1\n" << text;
    return load_fleet(folder_.path() / "fleet.yaml");
  }
  void refuses(const std::string& keys, const std::string& expectation) {
    try {
      read("vehicles:\n  - name: v\n    " + keys + "\n");
      ADD_FAILURE() << "accepted: " << keys;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::Format) << error.what();
      EXPECT_NE(std::string(error.what()).find("fleet.yaml:"), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(expectation), std::string::npos) << error.what() << "\nof " << keys;
    }
  }

  formats::TemporaryFolder folder_;
};

TEST_F(fleet_lidars, are_those_of_the_job_of_its_vehicle_or_of_all) {
  const Fleet fleet = read(
      "lidars: all\nvehicles:\n"
      "  - {name: a, sessions: [mon, {sessions: [tue/a, tue/b], lidars: [rear]}, {sessions: wed, lidars: null}]}\n"
      "  - {name: b, lidars: [/front/points, rear], sessions: [mon, {sessions: tue}, {sessions: wed, lidars: all}]}\n"
      "  - {name: c, lidars: null, sessions: [mon]}\n");
  std::vector<std::string> lidars;
  for (const FleetJob& job : fleet.jobs) lidars.push_back(job.lidars);
  EXPECT_EQ(lidars,
            (std::vector<std::string>{"all", "rear", "", "/front/points,rear", "/front/points,rear", "all", ""}));
  EXPECT_EQ(fleet.jobs[1].name, "tue/a + tue/b");
  EXPECT_EQ(fleet.jobs[1].sessions.size(), 2U);
  const Fleet plain = read("vehicles: [{name: a, sessions: [mon, [tue/a, tue/b]]}]\n");
  EXPECT_EQ(plain.jobs[1].result, fleet.jobs[1].result) << "a job keeps its files whatever is calibrated of it";
  EXPECT_EQ(plain.jobs[0].lidars, "");
}

TEST_F(fleet_lidars, have_nominals_by_their_names_or_in_one_file) {
  const std::string sessions = ", lidars: all, sessions: [mon]}]\n";
  const FleetVehicle by_names =
      read("vehicles: [{name: v, nominal: {front: [1.2, 0, 1.6, 0, 0, 0], rear: apollo:n/rear.yaml, /x: kit.yaml}" +
           sessions)
          .vehicles[0];
  const std::string here = folder_.path().string();
  EXPECT_EQ(by_names.nominal, "");
  EXPECT_EQ(by_names.nominal_of_lidars, (std::map<std::string, std::string>{{"front", "1.2,0,1.6,0,0,0"},
                                                                            {"rear", "apollo:" + here + "/n/rear.yaml"},
                                                                            {"/x", here + "/kit.yaml"}}));
  EXPECT_EQ(nominal_text(by_names),
            "/x=" + here + "/kit.yaml; front=1.2,0,1.6,0,0,0; rear=apollo:" + here + "/n/rear.yaml");
  EXPECT_EQ(read("vehicles: [{name: v, nominal: kit.yaml" + sessions).vehicles[0].nominal, here + "/kit.yaml");
  EXPECT_EQ(read("vehicles: [{name: v, nominal: none" + sessions).vehicles[0].nominal, "none");
}

TEST_F(fleet_lidars, that_cannot_be_are_refused_with_the_line) {
  const std::string job = "sessions: [mon]\n    ";
  refuses(job + "lidars: front", "expected all, null for one");
  refuses(job + "lidars: []", "expected all, null for one");
  refuses(job + "lidars: {front: rear}", "expected all, null for one");
  refuses(job + "lidars: [front, 'a,b']", "expected to name a LiDAR");
  refuses(job + "lidars: [front, all]", "expected to name a LiDAR");
  refuses(job + "lidars: [front, front]", "names a LiDAR twice");
  refuses(job + "lidars: all\n    topics: {lidar: /front}", "both choose LiDARs");
  refuses(job + "lidars: all\n    nominal: [1, 2, 3, 0, 0, 0]", "a map from their names");
  refuses(job + "lidars: all\n    nominal: {front: none}", "expected nominal: none");
  refuses(job + "lidars: all\n    nominal: {front: [1, 2]}", "expected a list of 6 numbers");
  refuses(job + "lidars: [front]\n    nominal: {fornt: [1, 2, 3, 0, 0, 0]}",
          "names a LiDAR that no job of the vehicle has");
  refuses(job + "lidars: [front]\n    reference: {rear: a.yaml}", "names a LiDAR that no job of the vehicle has");
  refuses(job + "last: {front: a.yaml}", "expected \"lidars\" for each of its jobs");
  refuses(job + "nominal: {front: [1, 2, 3, 0, 0, 0]}", "expected \"lidars\" for each of its jobs");
  refuses(job + "lidars: all\n    settings: {run: {method: trajectory}}", "only the method pairwise");
  refuses("sessions: [{sessions: mon, lidar: all}]", "known are sessions, lidars");
  refuses("sessions: [{lidars: all}]", "\"sessions\" is missing");
}

TEST_F(fleet_lidars, a_failure_of_other_lidars_or_nominals_counts_no_more) {
  const auto why_old = [&](const std::string& keys) {
    const Fleet fleet = read("vehicles: [{name: v, sessions: [mon], " + keys + "}]\n");
    return english(why_failure_is_old(fleet, fleet.jobs[0]));
  };
  const Fleet fleet = read("vehicles: [{name: v, sessions: [mon], lidars: [front, rear]}]\n");
  make_job_folder(fleet.jobs[0]);
  note_failure(fleet, fleet.jobs[0], Message::verbatim("mon: does not exist"));
  EXPECT_EQ(why_old("lidars: [front, rear]"), "");
  EXPECT_EQ(why_old("lidars: all"), "LiDARs: all; before: front, rear");
  EXPECT_EQ(why_old("lidars: null"), "LiDARs: one; before: front, rear");
  EXPECT_EQ(why_old("lidars: [front, rear], nominal: {rear: [1, 2, 3, 0, 0, 0]}"),
            "the nominal is rear=1,2,3,0,0,0, it was left to the sessions");
}

}  // namespace
}  // namespace remount::fleet
