// The verb "batch" with vehicles that have several LiDARs.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <csignal>

#include "model/fleet/fleet.h"
#include "model/results/vehicle_file.h"
#include "tests/app/cli/program_fixture.h"
#include "tests/support/draws.h"

namespace remount::cli {
namespace {

/// Three drives of one vehicle: as built, with its rear LiDAR moved by 5 cm and a degree, and with its INS turned by
/// two degrees, which moves and turns both LiDARs in its frame.
class cli_batch_vehicles : public ProgramFixture<cli_batch_vehicles> {
 protected:
  static constexpr const char* kDrive = " --duration-s 5 --beams 16 --azimuth-steps 250 ";
  static constexpr const char* kFront = "--mount front=at:1.2/0/1.6/0/0/-2.5 ";

  static void SetUpTestSuite() {
    make_folder_with_drive(std::string(kDrive) + kFront + "--mount rear=at:-1.5/0/0.9/180/0/0");
    simulate("moved", std::string(kFront) + "--mount rear=at:-1.5/0.05/0.9/179/0/0");
    simulate("turned",
             "--mount front=at:1.1992690/0.0418794/1.6/2/0/-2.5 --mount rear=at:-1.4990862/-0.0523492/0.9/182/0/0");
    fleet_of("all.yaml",
             "  - {name: bumped, nominal: {rear: [-1.5, 0, 0.9, 180, 0, 0]}, sessions: [drive, moved]}\n"
             "  - {name: turned, lidars: [rear, front], sessions: [drive, turned]}\n");
    all_ = run("batch " + path("all.yaml") + " --jobs 2 -j 1");
  }

  static void simulate(const std::string& name, const std::string& mounts) {
    const Outcome made = run("simulate street " + path(name) + kDrive + mounts);
    ASSERT_EQ(made.code, 0) << made.err;
  }
  static fleet::Fleet fleet_of(const std::string& name, const std::string& vehicles) {
    std::ofstream(path(name)) << "format: remount-fleet/1\nsettings: {run: {map_check: false}}\nlidars: all\n"
                              << "drift: {rotation_deg: 0.5, translation_m: 0.03}\nvehicles:\n"
                              << vehicles;
    return fleet::load_fleet(path(name));
  }
  static fleet::Fleet all() { return fleet::load_fleet(path("all.yaml")); }
  static void expect_in(const std::string& text, std::initializer_list<const char*> parts) {
    for (const char* part : parts) EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  }

  inline static Outcome all_;
};

TEST_F(cli_batch_vehicles, give_the_result_of_a_vehicle_and_a_row_for_each_lidar) {
  const fleet::Fleet fleet = all();
  EXPECT_EQ(all_.code, 3) << all_.out << all_.err;
  const results::VehicleFile first = results::load_vehicle(fleet.jobs[0].result),
                             third = results::load_vehicle(fleet.jobs[2].result);
  EXPECT_EQ(results::lidar_names(first), (std::vector<std::string>{"front", "rear"}));
  EXPECT_EQ(results::lidar_names(third), (std::vector<std::string>{"rear", "front"})) << "as they are named";
  EXPECT_EQ(first.relatives.size(), 1U);
  EXPECT_TRUE(first.lidars[1].joined);
  EXPECT_TRUE(first.lidars[1].file.nominal_ins_from_lidar);
  EXPECT_FALSE(first.lidars[0].file.nominal_ins_from_lidar);
  EXPECT_FALSE(first.lidars[0].file.inputs.empty());
  const std::string csv = text_of(fleet.results / "fleet.csv"), html = text_of(fleet.results / "fleet.html");
  EXPECT_EQ(csv.find("vehicle,job,sessions,state,status,x_m"), 0U) << csv.substr(0, 200);
  expect_in(csv, {"bumped,1,drive,done,ok,", "turned,4,turned,done,ok,", ",front,yes,", ",rear,yes,", ",yes,yes,0,\n"});
  expect_in(html, {"LiDAR</th>", "4 jobs: 4 solved; drift in 2"});
  expect_in(all_.out, {"1  bumped, drive, front: ok", "1  bumped, drive, rear: ok", "4 jobs: 4 solved; drift in 2"});
}

TEST_F(cli_batch_vehicles, alarm_by_the_lidar_that_moved_or_say_that_it_was_the_ins) {
  std::printf("%s", all_.err.c_str());
  expect_in(all_.err, {"alarm: bumped, moved, rear: ",
                       "alarm: turned, turned: since drive: All LiDARs sit against each other as before"});
  EXPECT_EQ(all_.err.find("alarm: turned, turned, "), std::string::npos) << "one alarm for all: " << all_.err;
  expect_in(all_.out, {"DRIFT: "});
  EXPECT_EQ(all_.err.find("alarm: bumped, moved, front"), std::string::npos) << all_.err;
  EXPECT_EQ(all_.err.find("alarm: bumped, moved: since"), std::string::npos) << all_.err;
}

TEST_F(cli_batch_vehicles, are_done_until_what_they_stand_on_changes) {
  const std::string table = "batch " + path("all.yaml") + " --table";
  const fleet::Fleet fleet = all();
  const std::string before = text_of(fleet.jobs[0].result);
  const Outcome again = run("batch " + path("all.yaml") + " --job 1");
  EXPECT_EQ(again.code, 0) << again.err;
  expect_in(again.out, {"done already, front ok, rear ok"});
  EXPECT_EQ(text_of(fleet.jobs[0].result), before);
  const auto says = [&](const std::string& vehicle, const char* words) {
    fleet_of("all.yaml", "  - {name: bumped, " + vehicle + ", sessions: [drive]}\n");
    const Outcome outcome = run(table + " --csv " + path("t.csv") + " --html " + path("t.html"));
    EXPECT_NE(outcome.out.find(words), std::string::npos) << words << " in\n" << outcome.out << outcome.err;
  };
  const std::string rear = "nominal: {rear: [-1.5, 0, 0.9, 180, 0, 0]}";
  says(rear, "1 solved");
  says(rear + ", lidars: [front, rear]", "1 solved");
  says(rear + ", lidars: [rear]", "out of date, LiDARs: rear; before: front, rear");
  says("lidars: null", "out of date, LiDARs: one; before: front, rear");
  says("nominal: {rear: [-1.5, 0, 0.9, 170, 0, 0]}", "out of date, rear: ");
  says("nominal: {rear: [-1.5, 0, 0.9, 180, 0, 0], front: [1.2, 0, 1.6, 0, 0, 0]}", "out of date, front: ");
  says("nominal: none", "out of date, rear: ");
  says(rear + ", settings: {pairing: {max_gap_s: 1.9}}", "out of date, pairing.max_gap_s");
  const auto scan = std::filesystem::directory_iterator(path("drive/rear/scans"))->path();
  std::filesystem::rename(scan, path("elsewhere"));
  says(rear, "has changed");
  std::filesystem::rename(path("elsewhere"), scan);
  says(rear, "1 solved");
  fleet_of("all.yaml",
           "  - {name: bumped, nominal: {rear: [-1.5, 0, 0.9, 180, 0, 0]}, sessions: [drive, moved]}\n"
           "  - {name: turned, lidars: [rear, front], sessions: [drive, turned]}\n");
}

TEST_F(cli_batch_vehicles, a_lidar_that_cannot_be_calibrated_has_its_row_with_the_reason) {
  simulate("blind", std::string(kFront) + "--mount rear=at:-1.5/0/0.9/180/0/0,rate:0.5");
  const fleet::Fleet fleet = fleet_of("blind.yaml", "  - {name: v, lidars: [front, rear], sessions: [blind]}\n");
  const Outcome outcome = run("batch " + path("blind.yaml"));
  EXPECT_EQ(outcome.code, 3) << outcome.out << outcome.err;
  expect_in(outcome.out, {"1  v, blind, front: ok", "1  v, blind, rear: too_few_pairs, it takes no part",
                          "1 job: 0 solved, 1 without a usable result"});
  expect_in(outcome.err, {"a LiDAR has no usable result"});
  EXPECT_FALSE(std::filesystem::exists(fleet.jobs[0].failure));
  expect_in(run("batch " + path("blind.yaml")).err, {"nothing has changed since: a LiDAR has no usable result"});
  // Of the others all is there, as `calibrate` has it.
  EXPECT_EQ(results::find_lidar(results::load_vehicle(fleet.jobs[0].result), "front")->file.result.status,
            calibration::Status::Ok);
}

TEST_F(cli_batch_vehicles, jobs_that_cannot_be_run_say_why) {
  const fleet::Fleet fleet =
      fleet_of("wrong.yaml",
               "  - {name: a, lidars: [front, left], sessions: [drive]}\n"
               "  - {name: b, nominal: kit.yaml, sessions: [drive]}\n"
               "  - {name: c, settings: {measured: {z_m: 1, z_sigma_m: 0.1}}, sessions: [drive]}\n");
  const Outcome outcome = run("batch " + path("wrong.yaml"));
  EXPECT_EQ(outcome.code, 2) << outcome.out << outcome.err;
  expect_in(outcome.err, {"left: is no LiDAR of these recordings. They have: front, rear",
                          "kit.yaml: each of several LiDARs has a nominal of its own",
                          "measured x, y, z and angles are of one LiDAR, and the job has 2"});
  expect_in(text_of(fleet.results / "fleet.csv"), {"a,1,drive,failed,"});
  const Outcome line = [] {
    std::ofstream(path("typo.yaml")) << "format: remount-fleet/1\nvehicles:\n  - name: v\n    lidars: front\n"
                                     << "    sessions: [drive]\n";
    return run("batch " + path("typo.yaml"));
  }();
  EXPECT_EQ(line.code, 2);
  expect_in(line.err, {"typo.yaml:4: vehicles[0].lidars: is \"front\", expected all"});
}

TEST_F(cli_batch_vehicles, one_lidar_by_its_name_is_a_vehicle_with_one) {
  std::ofstream(path("kit.txt")) << "1.2,0,1.6,0,0,-2.5\n";
  const fleet::Fleet fleet = fleet_of("one.yaml",
                                      "  - {name: v, nominal: {front: kit.txt, rear: [0, 0, 0, 0, 0, 0]}, sessions: "
                                      "[{sessions: drive, lidars: [front]},"
                                      " moved]}\n");
  const Outcome outcome = run("batch " + path("one.yaml") + " --job 1");
  ASSERT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  expect_in(outcome.err, {"the nominal of rear is not used"});
  EXPECT_EQ(outcome.out.find("against each other"), std::string::npos) << outcome.out;
  const results::VehicleFile file = results::load_vehicle(fleet.jobs[0].result);
  EXPECT_EQ(results::lidar_names(file), std::vector<std::string>{"front"});
  EXPECT_TRUE(file.lidars[0].file.nominal_ins_from_lidar);
  expect_in(run("batch " + path("one.yaml") + " --job 1").out, {"done already, front ok"});
}

TEST_F(cli_batch_vehicles, a_stop_leaves_no_half_result_and_the_next_run_goes_on) {
  ONLY_IN_LONG_TESTS();
  const fleet::Fleet fleet = fleet_of("stopped.yaml", "  - {name: v, sessions: [drive]}\n");
  const std::string log = path("stopped.log");
  const pid_t job = start({"batch", path("stopped.yaml"), "--job", "1", "-j", "1", "--log", log}, path("stopped.err"));
  ASSERT_TRUE(eventually([&] { return text_of(log).find("registering") != std::string::npos; })) << text_of(log);
  ::kill(job, SIGINT);
  int status = 0;
  ASSERT_EQ(::waitpid(job, &status, 0), job);
  EXPECT_EQ(WEXITSTATUS(status), 3) << text_of(path("stopped.err"));
  EXPECT_FALSE(std::filesystem::exists(fleet.jobs[0].result));
  EXPECT_FALSE(std::filesystem::exists(fleet.jobs[0].failure));
  expect_in(run("batch " + path("stopped.yaml") + " --job 1 -q").err + "done", {"done"});
  EXPECT_TRUE(results::is_vehicle_file(fleet.jobs[0].result));
}

}  // namespace
}  // namespace remount::cli
