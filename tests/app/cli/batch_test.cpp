// The verb "batch": processes, tables, resuming.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <csignal>

#include "model/fleet/fleet.h"
#include "model/results/result_file.h"
#include "tests/app/cli/program_fixture.h"

namespace remount::cli {
namespace {

class cli_batch : public ProgramFixture<cli_batch> {
 protected:
  static void SetUpTestSuite() {
    make_folder_with_drive(kDrive + "--ins-from-lidar 1.2,-0.3,0.8,5,1,-1");
    ASSERT_EQ(run("simulate street " + path("turned") + " " + kDrive + "--ins-from-lidar 1.2,-0.3,0.8,8,1,-1").code, 0);
  }

  static fleet::Fleet fleet_of(const std::string& name, const std::string& vehicles, const std::string& more = "") {
    std::ofstream(path(name)) << "format: remount-fleet/1\nsettings: {run: {map_check: false}}\n"
                              << more << "vehicles:\n"
                              << vehicles;
    return fleet::load_fleet(path(name));
  }
  static struct stat status_of(const std::filesystem::path& file) {
    struct stat status {};
    EXPECT_EQ(::stat(file.c_str(), &status), 0) << file;
    return status;
  }
  static void expect_contains(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\nin\n" << text;
  }

  inline static const std::string kDrive = "--duration-s 3 --beams 24 --azimuth-steps 400 --scan-rate-hz 5 ";
};

TEST_F(cli_batch, one_failing_job_stops_no_other_and_drift_is_an_alarm) {
  const fleet::Fleet fleet = fleet_of("all.yaml",
                                      "  - {name: broken, sessions: [none]}\n"
                                      "  - {name: turned, sessions: [drive, turned]}\n",
                                      "drift: {rotation_deg: 1}\n");
  const Outcome outcome = run("batch " + path("all.yaml") + " --jobs 2");
  EXPECT_EQ(outcome.code, 3) << "an alarm is not lost in a failure: " << outcome.out << outcome.err;
  expect_contains(outcome.err, "none: does not exist");
  expect_contains(outcome.err, "alarm: turned, turned: yaw has changed by +");
  EXPECT_TRUE(calibration::is_usable(results::load_result(fleet.jobs[1].result).result));
  EXPECT_TRUE(calibration::is_usable(results::load_result(fleet.jobs[2].result).result));
  const std::string csv = text_of(fleet.results / "fleet.csv"), html = text_of(fleet.results / "fleet.html");
  expect_contains(csv, "broken,1,none,failed,");
  expect_contains(csv, ",yes,");
  expect_contains(html, "3 jobs: 2 solved, 1 failed; drift in 1");

  EXPECT_EQ(run("batch " + path("all.yaml") + " --table -q").code, 3) << "nor in the table";
  fleet_of("all.yaml",
           "  - {name: broken, sessions: [none]}\n"
           "  - {name: turned, sessions: [drive, turned]}\n",
           "drift: {rotation_deg: 4}\n");
  EXPECT_EQ(run("batch " + path("all.yaml") + " --table -q").code, 2) << "the failure alone";
  EXPECT_EQ(run("batch " + path("all.yaml") + " -q").code, 2);
  fleet_of("all.yaml", "  - {name: turned, sessions: [drive, turned]}\n", "drift: {rotation_deg: 1}\n");
  EXPECT_EQ(run("batch " + path("all.yaml") + " --table -q").code, 3) << "drift alone";
  fleet_of("all.yaml", "  - {name: turned, sessions: [drive, turned]}\n", "drift: {rotation_deg: 4}\n");
  const Outcome quiet =
      run("batch " + path("all.yaml") + " --table --csv " + path("t.csv") + " --html " + path("t.html"));
  EXPECT_EQ(quiet.code, 0) << "beyond what is asked to be told: " << quiet.err;
  expect_contains(text_of(path("t.csv")), "turned,2,turned,done,");
  EXPECT_EQ(run("batch " + path("all.yaml") + " --table --csv " + path("drive/ins.csv")).code, 1)
      << "a recording is not replaced";
}

TEST_F(cli_batch, a_job_is_done_once_until_what_it_stands_on_changes) {
  std::filesystem::copy(path("drive"), path("own"), std::filesystem::copy_options::recursive);
  const std::string vehicle = "  - {name: v, sessions: [own]}\n";
  const fleet::Fleet fleet = fleet_of("once.yaml", vehicle);
  const std::string job = "batch " + path("once.yaml") + " --job 1";
  const std::filesystem::path result = fleet.jobs[0].result;
  const auto said = [&](const std::string& words) {
    const Outcome outcome = run(job);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    expect_contains(outcome.out, words);
  };
  said("there is no result yet");
  const std::string first = text_of(result);
  const auto made = status_of(result);
  said("done already, ok");
  EXPECT_EQ(status_of(result).st_ino, made.st_ino) << "not written again";
  for (int time = 0; time < 2; ++time)
    expect_contains(run("batch " + path("once.yaml")).out, "solved before, nothing has changed since");

  // A new time of the same bytes: hashed, and found to be the same.
  std::filesystem::last_write_time(path("own/ins.csv"), std::filesystem::file_time_type::clock::now());
  said("done already, ok");
  std::string samples = text_of(path("own/ins.csv"));
  const std::size_t digit = samples.find_last_of("0123456789");
  samples[digit] = samples[digit] == '0' ? '1' : '0';
  std::ofstream(path("own/ins.csv")) << samples;
  said("/ins.csv has changed");
  EXPECT_NE(text_of(result), first);
  const auto scan = std::filesystem::directory_iterator(path("own/scans"))->path();
  std::filesystem::remove(scan);
  said("/scans/" + scan.filename().string() + " has changed");
  fleet_of("once.yaml", vehicle, "drift: {sigmas: 9}\n");
  said("done already, ok");
  fleet_of("once.yaml", "  - {name: v, settings: {pairing: {max_gap_s: 1.9}}, sessions: [own]}\n");
  said("pairing.max_gap_s");
  fleet_of("once.yaml",
           "  - {name: v, settings: {pairing: {max_gap_s: 1.9}}, nominal: [1.2, -0.3, 0.8, 4, 0, 0], "
           "sessions: [own]}\n");
  said("nominal mounting");
}

TEST_F(cli_batch, the_table_names_what_has_changed_since_a_result_was_made) {
  std::filesystem::copy(path("drive"), path("kept"), std::filesystem::copy_options::recursive);
  const std::string vehicle = "  - {name: v, sessions: [[kept, drive]]}\n";
  fleet_of("aged.yaml", vehicle);
  ASSERT_EQ(run("batch " + path("aged.yaml") + " --job 1").code, 1) << "one recording, twice";
  fleet_of("aged.yaml", "  - {name: v, sessions: [kept]}\n");
  const std::string table = "batch " + path("aged.yaml") + " --table";
  ASSERT_EQ(run("batch " + path("aged.yaml") + " --job 1").code, 0);
  EXPECT_EQ(run(table + " -q").code, 0);
  const auto says = [&](const std::string& words) {
    const Outcome outcome = run(table);
    EXPECT_EQ(outcome.code, 3) << outcome.out << outcome.err;
    expect_contains(outcome.out, "v, kept: out of date, ");
    expect_contains(outcome.out, words);
  };
  // A new time of the same bytes is no change.
  std::filesystem::last_write_time(path("kept/ins.csv"), std::filesystem::file_time_type::clock::now());
  EXPECT_EQ(run(table + " -q").code, 0);
  const std::string samples = text_of(path("kept/ins.csv"));
  std::ofstream(path("kept/ins.csv"), std::ios::app) << samples.substr(samples.rfind('\n', samples.size() - 2) + 1);
  says("/ins.csv has changed");
  expect_contains(text_of(path("aged.results/fleet.html")), "ins.csv has changed");
  std::ofstream(path("kept/ins.csv")) << samples;
  EXPECT_EQ(run(table + " -q").code, 0) << "as it was";
  const auto scan = std::filesystem::directory_iterator(path("kept/scans"))->path();
  std::filesystem::rename(scan, path("elsewhere"));
  says("/scans/" + scan.filename().string() + " has changed");
  std::filesystem::rename(path("elsewhere"), scan);
  fleet_of("aged.yaml", "  - {name: v, nominal: [1.2, -0.3, 0.8, 4, 0, 0], sessions: [kept]}\n");
  says("nominal mounting");
  fleet_of("aged.yaml", "  - {name: v, settings: {pairing: {max_gap_s: 1.9}}, sessions: [kept]}\n");
  says("pairing.max_gap_s");
  fleet_of("aged.yaml", "  - {name: v, sessions: [kept]}\n");
  std::filesystem::rename(path("kept"), path("gone"));
  says("kept: does not exist");
}

TEST_F(cli_batch, a_job_that_failed_is_tried_again_and_its_failure_forgotten) {
  const fleet::Fleet fleet = fleet_of("later.yaml", "  - {name: v, sessions: [later]}\n");
  EXPECT_EQ(run("batch " + path("later.yaml") + " --job 1").code, 2);
  expect_contains(text_of(fleet.jobs[0].failure), "later: does not exist");
  EXPECT_EQ(run("batch " + path("later.yaml") + " --table -q").code, 2);
  std::filesystem::copy(path("drive"), path("later"), std::filesystem::copy_options::recursive);
  const Outcome waiting = run("batch " + path("later.yaml") + " --table");
  EXPECT_EQ(waiting.code, 3) << "it is to be run again";
  expect_contains(waiting.out, "v, later: waiting, ");
  expect_contains(waiting.out, "later has changed; before that it failed: ");
  EXPECT_EQ(run("batch " + path("later.yaml") + " --job 1").code, 0);
  EXPECT_FALSE(std::filesystem::exists(fleet.jobs[0].failure));
  EXPECT_EQ(run("batch " + path("later.yaml") + " --table -q").code, 0);
}

TEST_F(cli_batch, the_log_of_a_calibration_outlives_runs_that_find_it_done) {
  const fleet::Fleet fleet = fleet_of("logged.yaml", "  - {name: v, sessions: [drive]}\n");
  ASSERT_EQ(run("batch " + path("logged.yaml")).code, 0);
  const std::string log = text_of(fleet.jobs[0].log);
  ASSERT_FALSE(log.empty());
  ASSERT_EQ(run("batch " + path("logged.yaml")).code, 0);
  const std::string both = text_of(fleet.jobs[0].log);
  EXPECT_TRUE(both.starts_with(log)) << both;
}

TEST_F(cli_batch, killed_in_the_middle_it_goes_on_where_it_was) {
  const fleet::Fleet fleet = fleet_of("killed.yaml",
                                      "  - {name: a, sessions: [drive]}\n  - {name: b, sessions: [turned]}\n"
                                      "  - {name: c, sessions: [drive]}\n");
  const pid_t batch = start({"batch", path("killed.yaml"), "--jobs", "1"}, path("killed.err"));
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(fleet.jobs[0].result); })) << text_of(path("killed.err"));
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(fleet.jobs[1].lock); }));
  ::kill(batch, SIGKILL);
  ASSERT_EQ(::waitpid(batch, nullptr, 0), batch);
  const auto first = status_of(fleet.jobs[0].result);
  const bool second_was_done = std::filesystem::exists(fleet.jobs[1].result);

  // What a process leaves that is killed while it saves.
  std::ofstream(fleet.jobs[1].result.string() + ".a1B2c3") << "format: rem";
  const Outcome resumed = run("batch " + path("killed.yaml") + " --jobs 1");
  EXPECT_EQ(resumed.code, 0) << resumed.out << resumed.err;
  EXPECT_EQ(status_of(fleet.jobs[0].result).st_ino, first.st_ino) << "what was done is not done again";
  for (const fleet::FleetJob& job : fleet.jobs) {
    EXPECT_TRUE(calibration::is_usable(results::load_result(job.result).result));
    for (const auto& file : std::filesystem::directory_iterator(job.result.parent_path()))
      EXPECT_TRUE(file.path() == job.result || file.path() == job.log || file.path() == job.lock) << file.path();
  }
  std::printf("killed while the second of three ran (done by then: %s)\n", second_was_done ? "yes" : "no");
}

TEST_F(cli_batch, a_stop_signal_stops_every_process_and_leaves_no_half_result) {
  ASSERT_EQ(run("simulate street " + path("long") + " --duration-s 12 --beams 48 --azimuth-steps 900").code, 0);
  const fleet::Fleet fleet = fleet_of("stopped.yaml",
                                      "  - {name: a, sessions: [long]}\n  - {name: b, sessions: [long]}\n"
                                      "  - {name: c, sessions: [drive]}\n");
  const pid_t batch = start({"batch", path("stopped.yaml"), "--jobs", "2", "-j", "1"}, path("stopped.err"));
  for (const std::size_t i : {0U, 1U})
    ASSERT_TRUE(eventually([&] { return text_of(fleet.jobs[i].log).find("registering") != std::string::npos; }))
        << text_of(path("stopped.err"));
  ::kill(-batch, SIGINT);  // as a terminal sends it: to the whole group in front
  const auto asked = std::chrono::steady_clock::now();
  int status = 0;
  ASSERT_EQ(::waitpid(batch, &status, 0), batch);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - asked).count();
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 3) << text_of(path("stopped.err"));
  EXPECT_LT(seconds, 20.0);
  for (const fleet::FleetJob& job : fleet.jobs) {
    EXPECT_FALSE(std::filesystem::exists(job.result)) << job.result;
    EXPECT_FALSE(std::filesystem::exists(job.failure)) << "stopping is no failure: " << text_of(job.failure);
  }
  EXPECT_FALSE(std::filesystem::exists(fleet.jobs[2].lock)) << "nothing is started any more";
  expect_contains(text_of(path("stopped.err")), "goes on where this one was");
  // Both children are gone: a job of theirs would wait for its lock.
  for (const std::size_t i : {0U, 1U}) EXPECT_NE(text_of(fleet.jobs[i].log).find("cancelled"), std::string::npos);
  std::printf("stopped after %.1f s\n", seconds);
}

TEST_F(cli_batch, two_processes_at_one_job_make_it_once) {
  const fleet::Fleet fleet = fleet_of("twice.yaml", "  - {name: v, sessions: [drive]}\n");
  const pid_t first = start({"batch", path("twice.yaml"), "--job", "1", "--log", path("twice.log")}, path("twice.err"));
  ASSERT_TRUE(eventually([&] { return text_of(path("twice.log")).find("there is no result") != std::string::npos; }));
  const Outcome second = run("batch " + path("twice.yaml") + " --job 1");
  int status = 0;
  ASSERT_EQ(::waitpid(first, &status, 0), first);
  EXPECT_EQ(WEXITSTATUS(status), 0) << text_of(path("twice.err"));
  EXPECT_EQ(second.code, 0) << second.err;
  expect_contains(second.out, "waiting for process " + std::to_string(first));
  expect_contains(second.out, "done already");
}

TEST_F(cli_batch, wrong_usage_and_broken_fleets_are_said_with_the_place) {
  const fleet::Fleet fleet = fleet_of("small.yaml", "  - {name: v, sessions: [drive]}\n");
  EXPECT_EQ(run("batch " + path("small.yaml") + " --count").out, "1\n");
  EXPECT_EQ(run("batch " + path("small.yaml") + " --job 2").code, 1);
  EXPECT_EQ(run("batch " + path("small.yaml") + " --job 0").code, 1);
  EXPECT_EQ(run("batch " + path("small.yaml") + " --job 1 --table").code, 1);
  EXPECT_EQ(run("batch " + path("none.yaml")).code, 2);
  std::ofstream(path("typo.yaml")) << "format: remount-fleet/1\nvehicles:\n  - name: v\n    session: [drive]\n";
  const Outcome typo = run("batch " + path("typo.yaml"));
  EXPECT_EQ(typo.code, 2);
  expect_contains(typo.err, "typo.yaml:4: vehicles[0].session: is not a key");
  EXPECT_EQ(run("batch " + path("small.yaml") + " --table").code, 3) << "waiting";
}

}  // namespace
}  // namespace remount::cli
