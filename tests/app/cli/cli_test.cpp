// Runs the program itself: exit codes, bytes, messages.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

#include "algorithms/geometry/rigid_transform.h"
#include "model/formats/session_readers.h"
#include "model/project/project.h"
#include "model/results/exporters/exporter.h"
#include "tests/app/cli/program_fixture.h"

namespace remount::cli {
namespace {

class cli : public ProgramFixture<cli> {
 protected:
  static void SetUpTestSuite() {
    make_folder_with_drive(
        "--duration-s 3 --beams 24 --azimuth-steps 400 --scan-rate-hz 5 --ins-from-lidar 1.2,-0.3,0.8,5,1,-1");
  }

  /// Motion pairs for a known X; `planar` turns about the vertical only.
  static std::string pairs_file(const std::string& name, bool planar, bool straight = false) {
    const RigidTransform x = rigid_from_six({0.5, -0.2, 0.7, 0.3, 0.02, -0.01});
    std::ofstream file(path(name));
    file.precision(15);
    file << "# exact pairs\nset,i,j";
    for (const char letter : {'P', 'Q'})
      for (int i = 0; i < 12; ++i) file << "," << letter << i / 4 << i % 4;
    file << "\n";
    for (int k = 0; k < 30; ++k) {
      const double turn = straight ? 0.0 : 0.2 + 0.01 * k;
      const RigidTransform p = rigid_from_six({2.0 + 0.1 * k, straight ? 0.0 : 0.3 * std::sin(k), 0.0,
                                               k % 2 ? turn : -turn, planar || straight ? 0.0 : 0.3 * std::sin(1.7 * k),
                                               planar || straight ? 0.0 : 0.3 * std::cos(2.3 * k)});
      const RigidTransform q = x.inverse() * p * x;
      file << "s," << k << "," << k + 1;
      for (const RigidTransform& motion : {p, q})
        for (int i = 0; i < 12; ++i) file << "," << motion(i / 4, i % 4);
      file << "\n";
    }
    return path(name);
  }
};

TEST_F(cli, wrong_usage_is_exit_code_1) {
  for (const std::string& arguments : std::vector<std::string>{
           "", "nothing", "calibrate", "calibrate " + path("drive") + " --range 1:2",
           "calibrate " + path("drive") + " --range x=2:1", "calibrate " + path("drive") + " --set solve.nothing=1",
           "calibrate " + path("drive") + " -o " + path("r.txt"), "calibrate " + path("drive") + " --nominal 1,2,3",
           "calibrate " + path("drive") + " --unknown", "simulate nowhere " + path("x"),
           "simulate street " + path("x") + " --beams 0", "solve " + pairs_file("p.csv", false) + " -j -3"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 1) << arguments << "\n" << outcome.err;
    EXPECT_FALSE(outcome.err.empty()) << arguments;
  }
  EXPECT_EQ(run("--help").code, 0);
  EXPECT_EQ(run("--version").code, 0);
  EXPECT_EQ(run("calibrate --help").code, 0);
}

TEST_F(cli, a_file_that_is_something_else_is_not_replaced) {
  const std::string manifest = path("drive/session.yaml"), ins = path("drive/ins.csv");
  const std::string before = text_of(manifest), samples = text_of(ins);
  ASSERT_FALSE(before.empty() || samples.empty());
  for (const std::string& arguments :
       {"calibrate " + path("drive") + " -o " + manifest, "calibrate " + path("drive") + " --save-project " + manifest,
        "inspect " + path("drive") + " --log " + ins}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 1) << arguments << "\n" << outcome.err;
    EXPECT_NE(outcome.err.find("is there and"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(text_of(manifest), before);
  EXPECT_EQ(text_of(ins), samples);
  const std::string result = path("kept.yaml");
  ASSERT_EQ(run("calibrate " + path("drive") + " -q -o " + result).code, 0);
  const std::string kept = text_of(result);
  EXPECT_EQ(run("export " + result + " --to matrix -o " + result).code, 1);
  EXPECT_EQ(text_of(result), kept);
  const std::string log = path("run.log");
  EXPECT_EQ(run("inspect " + path("drive") + " --log " + log).code, 0);
  EXPECT_EQ(run("inspect " + path("drive") + " --log " + log).code, 0) << "a log follows a log";
}

TEST_F(cli, unreadable_input_is_exit_code_2_and_named) {
  std::ofstream(path("broken.yaml")) << "pairing:\n  max_gap_s: often\n  typo: 1\n";
  std::ofstream(path("broken.csv")) << "a,b,c\n1,2,3\n";
  std::filesystem::create_directories(path("empty"));
  const std::vector<std::pair<std::string, std::string>> cases{
      {"calibrate " + path("none"), "none"},
      {"calibrate " + path("empty"), "empty"},
      {"calibrate " + path("drive") + " --config " + path("broken.yaml"), "broken.yaml:2"},
      {"calibrate " + path("drive") + " --config " + path("broken.yaml"), "broken.yaml:3"},
      {"calibrate " + path("drive") + " --nominal " + path("none.yaml"), "none.yaml"},
      {"calibrate " + path("drive") + " --nominal " + path("broken.csv"), "broken.csv"},
      {"calibrate --project " + path("broken.yaml"), "broken.yaml"},
      {"solve " + path("broken.csv"), "broken.csv:1"},
      {"solve " + path("none.csv"), "none.csv"},
      {"solve " + path(""), path("")},
      {"export " + path("broken.yaml") + " --to ros2", "broken.yaml"},
      {"export " + path("none.yaml") + " --to kitti --lidar rear", "none.yaml"},
      {"export " + path("none.yaml") + " --to urdf --relative-to front", "none.yaml"},
      {"report " + path("none.yaml") + " --lidar rear -o " + path("none.html"), "none.yaml"},
      {"compare " + path("none.yaml") + " " + path("none.json") + " --lidar rear", "none.yaml"},
      {"obstacles " + path("drive") + " --scan 0 --lidar rear --result " + path("none.yaml"), "none.yaml"},
      {"inspect " + path("empty"), "empty"},
      {"obstacles " + path("drive") + " --scan 0 --result " + path("none.yaml"), "none.yaml"}};
  for (const auto& [arguments, named] : cases) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments << "\n" << outcome.err;
    EXPECT_NE(outcome.err.find(named), std::string::npos) << arguments << "\n" << outcome.err;
  }
}

TEST_F(cli, an_output_that_cannot_be_written_is_exit_code_2_before_any_work) {
  std::filesystem::create_directories(path("folder.yaml"));
  for (const std::string& output : {" -o " + path("none/r.yaml"), " -o " + path("folder.yaml"),
                                    std::string(" -o /proc/r.yaml"), " --save-project " + path("none/r.remount")}) {
    const std::string log = path("unwritable.log");
    const Outcome outcome = run("calibrate " + path("drive") + output + " --log " + log);
    EXPECT_EQ(outcome.code, 2) << output << "\n" << outcome.err;
    EXPECT_NE(outcome.err.find("cannot be saved"), std::string::npos) << output << "\n" << outcome.err;
    EXPECT_EQ(text_of(log).find("reading"), std::string::npos) << output << "\n" << text_of(log);
  }
  EXPECT_EQ(run("solve " + pairs_file("w.csv", false) + " -o " + path("none/r.yaml")).code, 2);
}

TEST_F(cli, a_nominal_outside_the_search_range_is_refused_in_the_units_typed) {
  for (const std::string& verb : {"calibrate " + path("drive"), "solve " + pairs_file("n.csv", false)}) {
    const Outcome outcome = run(verb + " --nominal 1.2,-0.3,0.8,50,0,0 --range yaw=-10:10");
    EXPECT_EQ(outcome.code, 1) << verb << "\n" << outcome.err;
    EXPECT_NE(outcome.err.find("yaw 50.00 deg (at most 10.00 deg)"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("search range"), std::string::npos) << outcome.err;
  }
}

TEST_F(cli, errors_of_a_range_speak_the_units_that_were_typed) {
  const std::string verb = "calibrate " + path("drive");
  const std::vector<std::pair<std::string, std::string>> cases{
      {" --range yaw=-200:10", "--range yaw=-200:10: yaw -200 deg is outside -180 to 180 deg"},
      {" --range pitch=20:10", "pitch: the minimum 20 deg exceeds the maximum 10 deg"},
      {" --range x=0:2000", "x 2000 m is outside -1000 to 1000 m"},
      {" --set range.yaw_min_rad=-4",
       "-4 rad (-229.183 deg) is outside -3.14159 rad to 3.14159 rad (-180 deg to 180 deg)"},
      {" --set range.roll_max_rad=-3.14 --range roll=-10:10 --set range.yaw_max_rad=-3.1 --set range.yaw_min_rad=0",
       "range.yaw: the minimum 0 deg exceeds the maximum -177.617 deg"}};
  for (const auto& [arguments, said] : cases) {
    const Outcome outcome = run(verb + arguments);
    EXPECT_EQ(outcome.code, 1) << arguments << "\n" << outcome.err;
    EXPECT_NE(outcome.err.find(said), std::string::npos) << arguments << "\n" << outcome.err;
  }
}

TEST_F(cli, a_wrong_verb_is_answered_with_the_right_ones) {
  for (const std::string& arguments : std::vector<std::string>{"calibrat " + path("drive"), "-q calibrat", ""}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 1);
    for (const char* said :
         {arguments.empty() ? "no verb is given" : "there is no verb \"calibrat\"",
          "the verbs are inspect, describe, calibrate, solve, export, ", ", simulate, settings, doctor."})
      EXPECT_NE(outcome.err.find(said), std::string::npos) << outcome.err;
  }
}

TEST_F(cli, a_failed_solve_says_nothing_of_clocks) {
  const Outcome outcome = run("calibrate " + path("drive") + " --range x=4:5 -o " + path("failed.yaml"));
  ASSERT_EQ(outcome.code, 3) << outcome.out << outcome.err;
  for (const std::string& text : {outcome.out, outcome.err})
    for (const char* word : {"clock", "time offset", "early", "late by", "apply_time_offset"})
      EXPECT_EQ(text.find(word), std::string::npos) << word << "\n" << text;
  EXPECT_FALSE(std::isfinite(results::load_result(path("failed.yaml")).result.time_offset.offset_s));
}

TEST_F(cli, calibrates_and_writes_the_same_bytes_for_any_number_of_threads) {
  const Outcome one = run("calibrate " + path("drive") + " -j 1 -o " + path("j1.yaml"));
  ASSERT_EQ(one.code, 0) << one.err;
  ASSERT_EQ(run("calibrate " + path("drive") + " -j 3 -o " + path("j3.yaml")).code, 0);
  EXPECT_TRUE(text_of(path("j1.yaml")) == text_of(path("j3.yaml")));  // too long to print
  ASSERT_EQ(run("calibrate " + path("drive") + " -j 2 -o " + path("j2.json")).code, 0);
  EXPECT_EQ(results::load_result(path("j1.yaml")).result.mounting.reference_from_sensor.matrix(),
            results::load_result(path("j2.json")).result.mounting.reference_from_sensor.matrix());
  EXPECT_NE(one.out.find("1-sigma"), std::string::npos) << one.out;
  EXPECT_NE(one.out.find("rejected"), std::string::npos) << one.out;
  EXPECT_TRUE(one.err.empty() || one.err.find("warning") == 0) << one.err;
  const results::ResultFile result = results::load_result(path("j1.yaml"));
  const RigidTransform truth =
      rigid_from_six({1.2, -0.3, 0.8, degrees_to_radians(5), degrees_to_radians(1), degrees_to_radians(-1)});
  const Vector6d error = difference(truth, result.result.mounting.reference_from_sensor);
  EXPECT_LT(error.tail<3>().norm(), degrees_to_radians(0.3)) << error.transpose();
  EXPECT_LT(error.head<2>().norm(), 0.05) << error.transpose();
  ASSERT_FALSE(result.inputs.empty());
  EXPECT_EQ(result.inputs.front().sha256.size(), 64U);
}

TEST_F(cli, compares_results_and_ends_with_3_where_they_contradict_each_other) {
  ASSERT_EQ(run("solve " + pairs_file("agree.csv", false) + " -o " + path("first.yaml")).code, 0);
  ASSERT_EQ(run("solve " + path("agree.csv") + " -o " + path("second.yaml")).code, 0);
  const Outcome agree = run("compare " + path("first.yaml") + " " + path("second.yaml"));
  EXPECT_EQ(agree.code, 0) << agree.out << agree.err;
  EXPECT_NE(agree.out.find("first and second agree within what they claim"), std::string::npos) << agree.out;
  results::ResultFile moved = results::load_result(path("second.yaml"));
  moved.result.mounting.reference_from_sensor.translation().x() += 5.0;
  results::save_result(moved, path("moved.yaml"));
  const Outcome contradict = run("compare " + path("first.yaml") + " " + path("moved.yaml"));
  EXPECT_EQ(contradict.code, 3) << contradict.out << contradict.err;
  EXPECT_NE(contradict.err.find("first and moved contradict each other: x differs by 5 m"), std::string::npos)
      << contradict.err;
  EXPECT_EQ(run("compare " + path("first.yaml")).code, 1) << "one result has nothing to be compared with";
}

TEST_F(cli, compare_shows_no_more_digits_than_sigma_justifies) {
  ASSERT_EQ(run("solve " + pairs_file("digits.csv", false) + " -o " + path("digits.yaml")).code, 0);
  results::ResultFile vague = results::load_result(path("digits.yaml"));
  vague.result.mounting.reference_from_sensor = rigid_from_six({0.76441, -0.25021, 0.5, 0.0, 0.0, 0.0});
  vague.result.covariance = Matrix6d::Identity() * 0.0132 * 0.0132;
  results::save_result(vague, path("vague.yaml"));
  const Outcome table = run("compare " + path("vague.yaml") + " " + path("vague.yaml"));
  EXPECT_NE(table.out.find("0.764 +- 0.013"), std::string::npos) << table.out;
  EXPECT_NE(table.out.find("-0.250 +- 0.013"), std::string::npos) << table.out;
  EXPECT_EQ(table.out.find("0.7644"), std::string::npos) << table.out;
}

TEST_F(cli, a_report_is_one_page_and_replaces_only_its_like) {
  ASSERT_EQ(run("solve " + pairs_file("reported.csv", false) + " -o " + path("reported.yaml")).code, 0);
  ASSERT_EQ(run("report " + path("reported.yaml") + " " + path("drive") + " -o " + path("page.html")).code, 0);
  const std::string page = text_of(path("page.html"));
  EXPECT_NE(page.find("0.5000 m"), std::string::npos);
  EXPECT_NE(page.find("north up"), std::string::npos) << "the session's track";
  EXPECT_EQ(run("report " + path("reported.yaml") + " -o " + path("page.html")).code, 0) << "a page may be replaced";
  EXPECT_EQ(run("report " + path("reported.yaml") + " -o " + path("reported.yaml")).code, 1);
  EXPECT_EQ(run("report " + path("reported.yaml") + " -o " + path("drive/ins.csv")).code, 1);
}

TEST_F(cli, a_report_takes_no_session_that_the_result_was_not_made_of) {
  ASSERT_EQ(run("solve " + pairs_file("made.csv", false) + " -o " + path("made.yaml")).code, 0);
  results::ResultFile made = results::load_result(path("made.yaml"));
  Progress progress;
  made.inputs =
      results::list_inputs({std::make_shared<const drive::Session>(formats::open_session(path("drive"), progress))});
  ASSERT_FALSE(made.inputs.empty());
  results::save_result(made, path("made.yaml"));
  ASSERT_EQ(run("report " + path("made.yaml") + " " + path("drive") + " -o " + path("made.html")).code, 0);
  made.inputs.back().bytes += 1;
  results::save_result(made, path("made.yaml"));
  const Outcome other = run("report " + path("made.yaml") + " " + path("drive") + " -o " + path("other.html"));
  EXPECT_EQ(other.code, 1);
  EXPECT_NE(other.err.find("is not what the result was made of: there is no "), std::string::npos) << other.err;
  EXPECT_FALSE(std::filesystem::exists(path("other.html")));
}

TEST_F(cli, a_result_is_a_nominal_an_export_and_an_obstacle_check) {
  ASSERT_EQ(run("calibrate " + path("drive") + " -o " + path("r.yaml") + " --save-project " + path("r.remount")).code,
            0);
  const RigidTransform x = results::load_result(path("r.yaml")).result.mounting.reference_from_sensor;
  for (const auto& format : results::exporters()) {
    if (!format->holds_mounting()) continue;
    const std::string file = path("export_" + std::string(format->id()));
    ASSERT_EQ(run("export " + path("r.yaml") + " --to " + std::string(format->id()) + " -o " + file).code, 0);
    EXPECT_LT((format->read(text_of(file), file).matrix() - x.matrix()).cwiseAbs().maxCoeff(), 1e-12) << format->id();
  }
  const Outcome text = run("export " + path("r.yaml") + " --to kitti");
  EXPECT_EQ(text.out, text_of(path("export_kitti")));
  EXPECT_EQ(run("export " + path("r.yaml") + " --to nothing").code, 1);
  const std::string table = path("drive/ins.csv"), before = text_of(table);
  const Outcome slip = run("export " + path("r.yaml") + " --to matrix -o " + table);
  EXPECT_EQ(slip.code, 1) << slip.out;
  EXPECT_NE(slip.err.find("is no export"), std::string::npos) << slip.err;
  EXPECT_TRUE(text_of(table) == before) << "the recording is as it was";

  const Outcome obstacles =
      run("obstacles " + path("drive") + " --scan 2 --result " + path("r.yaml") + " --nominal 1.2,-0.3,0.8,0,0,0");
  EXPECT_EQ(obstacles.code, 0) << obstacles.err;
  EXPECT_NE(obstacles.out.find("decision at 2 m"), std::string::npos) << obstacles.out;
  const Outcome alone = run("obstacles " + path("drive") + " --scan 2 --result " + path("r.yaml"));
  EXPECT_EQ(alone.code, 0) << alone.err;
  EXPECT_NE(alone.out.find("calibrated: nearest"), std::string::npos) << alone.out;
  EXPECT_NE(alone.out.find("give --nominal to compare"), std::string::npos) << alone.out;
  EXPECT_EQ(alone.out.find("nominal   "), std::string::npos) << alone.out;
  for (const auto& [scan, said] : {std::pair("999", "scans are 0 to 14"), std::pair("-1", "numbered from 0")}) {
    const Outcome none = run("obstacles " + path("drive") + " --scan " + scan + " --result " + path("r.yaml"));
    EXPECT_EQ(none.code, 1) << scan;
    EXPECT_NE(none.err.find(said), std::string::npos) << scan << "\n" << none.err;
  }

  const project::Project project = project::load_project(path("r.remount"));
  ASSERT_TRUE(project.output);
  EXPECT_EQ(project.sessions.at(0), std::filesystem::path(path("drive")));
  ASSERT_EQ(
      run("calibrate --project " + path("r.remount") + " --nominal " + path("r.yaml") + " -o " + path("again.yaml"))
          .code,
      0);
  const Vector6d change = difference(x, results::load_result(path("again.yaml")).result.mounting.reference_from_sensor);
  EXPECT_LT(change.norm(), 0.05) << change.transpose();
}

TEST_F(cli, solves_pairs_and_names_what_is_not_observed) {
  ASSERT_EQ(run("solve " + pairs_file("full.csv", false) + " -o " + path("full.json")).code, 0);
  const results::ResultFile full = results::load_result(path("full.json"));
  const Vector6d error =
      difference(rigid_from_six({0.5, -0.2, 0.7, 0.3, 0.02, -0.01}), full.result.mounting.reference_from_sensor);
  EXPECT_LT(error.norm(), 1e-6) << error.transpose();
  EXPECT_EQ(full.result.status, calibration::Status::Ok);

  const Outcome planar = run("solve " + pairs_file("planar.csv", true) + " -o " + path("planar.json"));
  EXPECT_EQ(planar.code, 0) << planar.err;
  EXPECT_FALSE(results::load_result(path("planar.json")).result.known[calibration::Parameter::Z].observed);
  EXPECT_NE(planar.out.find("not observed"), std::string::npos) << planar.out;
  const Outcome exported = run("export " + path("planar.json") + " --to matrix");
  EXPECT_NE(exported.err.find("not observed"), std::string::npos) << exported.err;
  EXPECT_NE(exported.out.find("WARNING"), std::string::npos) << exported.out;
}

TEST_F(cli, no_usable_result_is_exit_code_3_with_reason_and_file) {
  const Outcome outcome =
      run("solve " + pairs_file("out.csv", false) + " --range x=3:4,y=3:4,z=3:4,yaw=-3:-1 -q -o " + path("out.yaml"));
  EXPECT_EQ(outcome.code, 3) << outcome.out << outcome.err;
  EXPECT_NE(outcome.err.find("no usable result"), std::string::npos) << outcome.err;
  EXPECT_TRUE(outcome.out.empty()) << "--quiet: " << outcome.out;
  EXPECT_FALSE(calibration::is_usable(results::load_result(path("out.yaml")).result));
  EXPECT_EQ(run("export " + path("out.yaml") + " --to ros1").code, 3);
  EXPECT_EQ(run("calibrate " + path("drive") + " --nominal " + path("out.yaml")).code, 2);
}

TEST_F(cli, negative_numbers_are_values_and_settings_round_trip) {
  EXPECT_EQ(run("solve " + pairs_file("neg.csv", false) +
                " --nominal -0.5,0.2,0,-10,0,0 --range -5:5,-5:5,-5:5,-180:180,-90:90,-180:180")
                .code,
            0);
  ASSERT_EQ(run("settings -o " + path("all.yaml")).code, 0);
  const Outcome checked = run("settings --config " + path("all.yaml"));
  EXPECT_EQ(checked.code, 0) << checked.err;
  EXPECT_EQ(checked.out, text_of(path("all.yaml")));
  EXPECT_EQ(run("settings -o " + path("all.yaml")).code, 0) << "settings replace settings";
}

TEST_F(cli, settings_replace_nothing_but_settings) {
  const std::string session = path("drive") + "/session.yaml", before = text_of(session);
  ASSERT_FALSE(before.empty());
  EXPECT_EQ(run("settings -o " + session).code, 1);
  EXPECT_EQ(text_of(session), before);
}

TEST_F(cli, inspect_says_what_a_session_is) {
  const Outcome outcome = run("inspect " + path("drive"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  for (const char* expected : {"scans: 15", "5.0 Hz", "INS samples", "usable: yes"})
    EXPECT_NE(outcome.out.find(expected), std::string::npos) << expected << "\n" << outcome.out;
}

TEST_F(cli, logs_and_stays_silent_without_a_terminal) {
  const Outcome outcome = run("solve " + pairs_file("log.csv", false) + " --log " + path("run.log"));
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(text_of(path("run.log")).find("status: ok"), std::string::npos) << text_of(path("run.log"));
  EXPECT_EQ(run("solve " + path("log.csv") + " --log " + path("none/run.log")).code, 2);
}

TEST_F(cli, a_stop_signal_cancels_cleanly) {
  // Long enough that the signal always comes in the middle.
  ASSERT_EQ(run("simulate street " + path("long") + " --duration-s 12 --beams 48 --azimuth-steps 900").code, 0);
  const std::string output = path("cancelled.yaml"), error = path("err2.txt"), log = path("cancelled.log");
  const pid_t child = start({"calibrate", path("long"), "-o", output, "--log", log}, error);
  ASSERT_TRUE(eventually([&] { return text_of(log).find("registering") != std::string::npos; })) << text_of(log);
  ::kill(child, SIGTERM);
  const auto asked = std::chrono::steady_clock::now();
  // timeout(1) signals the process and then its group: that is one wish.
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  ::kill(child, SIGTERM);
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - asked).count();
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 3) << text_of(error);
  EXPECT_LT(seconds, 20.0);
  const calibration::CalibrationResult result = results::load_result(output).result;
  EXPECT_EQ(result.status, calibration::Status::Cancelled);
  EXPECT_GT(result.pairs_proposed, 0) << "what was found until then is counted";
  EXPECT_NE(text_of(error).find("cancelled"), std::string::npos) << text_of(error);
}

}  // namespace
}  // namespace remount::cli
