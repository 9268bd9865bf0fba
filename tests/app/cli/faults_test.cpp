// What the program says to inputs and arguments that are wrong in ways that happen.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "algorithms/geometry/rigid_transform.h"
#include "model/results/exporters/exporter.h"
#include "tests/app/cli/program_fixture.h"

namespace remount::cli {
namespace {

class cli_faults : public ProgramFixture<cli_faults> {
 protected:
  static void SetUpTestSuite() {
    make_folder_with_drive("--duration-s 1.5 --beams 12 --azimuth-steps 200 --ins-from-lidar 1.2,-0.3,0.8,5,1,-1");
  }

  static void expect(const std::string& arguments, int code, const std::string& said) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, code) << arguments << "\n" << outcome.out << outcome.err;
    EXPECT_NE((outcome.out + outcome.err).find(said), std::string::npos) << said << "\n" << outcome.out << outcome.err;
    std::istringstream lines(outcome.err);
    for (std::string line; code == 1 && std::getline(lines, line);) {
      const bool known =
          line.starts_with("remount-cli: ") || line.starts_with("warning: ") || line.starts_with("problem: ");
      EXPECT_TRUE(known) << line;
    }
  }
  /// A copy of the drive with one text in one of its files replaced by another.
  static std::string changed(const std::string& name, const std::string& file, const std::string& from,
                             const std::string& to) {
    std::filesystem::copy(folder_ / "drive", folder_ / name, std::filesystem::copy_options::recursive);
    std::string text = text_of(folder_ / name / file);
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from << "\n" << text.substr(0, 2000);
    if (at != std::string::npos) text.replace(at, from.size(), to);
    std::ofstream(folder_ / name / file) << text;
    return path(name);
  }
};

// Names and contents of files come from others: they must not steer the terminal, nor look like lines of ours.
TEST_F(cli_faults, names_and_bytes_of_files_reach_terminal_log_and_report_escaped) {
  const std::string evil = "\x1b[2J\x1b]0;title\x07\xe2\x80\xae", folder = path("by " + evil);
  std::filesystem::create_directories(folder + "/scans");
  std::filesystem::copy(folder_ / "drive", folder + "/drive", std::filesystem::copy_options::recursive);
  std::string manifest = text_of(folder + "/drive/session.yaml");
  const std::size_t name = manifest.find("name: ");
  manifest.replace(name, manifest.find('\n', name) - name, R"(name: "of \e[31m\a\u202e")");
  std::ofstream(folder + "/drive/session.yaml") << manifest;
  std::ofstream(folder + "/a.pcap") << "\xd4\xc3\xb2\xa1" << evil;
  std::ofstream(folder + "/session.yaml") << "format: remount-session/1\nname: \x1b[31m\nscans: " << evil << "\n";
  std::ofstream(folder + "/poses.txt") << "1 0 0 0 0 0 0 1\n2 \x1b[31m 0 0 0 0 0 1\n3 0 0 0 0 0 0 1\n";
  const auto expect_clean = [&](const std::string& text) {
    EXPECT_EQ(text.find('\x1b'), std::string::npos) << text;
    EXPECT_EQ(text.find('\x07'), std::string::npos) << text;
    EXPECT_EQ(text.find("\xe2\x80\xae"), std::string::npos) << text;
  };
  for (const std::string& arguments :
       {"inspect '" + folder + "'", "inspect '" + folder + "/a.pcap'", "inspect '" + folder + "/poses.txt'",
        "inspect '" + folder + "/drive'", "calibrate '" + folder + "' -o '" + folder + "/r.yaml'",
        "calibrate '" + folder + "/missing'", "export '" + folder + "/poses.txt' --to yaml", "'" + evil + "'",
        "compare '" + folder + "/poses.txt' '" + folder + "/a.pcap'",
        "calibrate '" + folder + "/drive' -o '" + folder + "/r.yaml'"}) {
    const Outcome outcome = run(arguments + " --log '" + path("evil.log") + "'");
    expect_clean(outcome.out);
    expect_clean(outcome.err);
    expect_clean(text_of(path("evil.log")));
    std::filesystem::remove(path("evil.log"));
  }
  const Outcome lines = run("inspect '" + path("a\nremount-cli: all is well") + "'");
  EXPECT_NE(lines.err.find("a\\x0aremount-cli: all is well: does not exist"), std::string::npos) << lines.err;
  const Outcome report = run("report '" + folder + "/r.yaml' '" + folder + "/drive' -o '" + path("r.html") + "'");
  expect_clean(report.out + report.err);
  ASSERT_TRUE(std::filesystem::exists(path("r.html"))) << report.out << report.err;
  const std::string page = text_of(path("r.html"));
  for (const char* unescaped : {"\x1b", "\x07", "\xe2\x80\xae"}) EXPECT_EQ(page.find(unescaped), std::string::npos);
  EXPECT_NE(page.find("\\x1b"), std::string::npos) << "the name of its input";
}

TEST_F(cli_faults, wrong_usage_is_said_with_one_prefix_and_is_exit_code_1) {
  std::ofstream(path("pairs.csv"))
      << "set,i,j,P00,P01,P02,P03,P10,P11,P12,P13,P20,P21,P22,P23,Q00,Q01,Q02,Q03,Q10,Q11,"
         "Q12,Q13,Q20,Q21,Q22,Q23\nmorning,0,1,1,0,0,1,0,1,0,0,0,0,1,0,1,0,0,1,0,1,0,0,0,0,1,"
         "0\nevening,0,1,1,0,0,1,0,1,0,0,0,0,1,0,1,0,0,1,0,1,0,0,0,0,1,0\n";
  std::ofstream(path("contradiction.yaml")) << "keyframes: {minimum: 500, maximum: 50}\n";
  const std::string drive = path("drive");
  expect("simulate street " + path("x") + " --beams 0", 1, "--beams");
  expect("calibrate " + drive + " --unknown", 1, "--unknown");
  expect("calibrate " + drive + " --nominal 1,2,3,720,0,0", 1, "yaw 720 deg is outside -360 deg to 360 deg");
  expect("solve " + path("pairs.csv") + " --only-set noon", 1, "\"morning\", \"evening\"");
  const std::string both = "keyframes.minimum = 500 exceeds keyframes.maximum = 50";
  expect("calibrate " + drive + " --set keyframes.minimum=500 --set keyframes.maximum=50", 1, both);
  expect("calibrate " + drive + " --config " + path("contradiction.yaml"), 1, both);
  expect("settings --config " + path("contradiction.yaml"), 1, both);
  expect("calibrate " + drive + " --set solve.x=", 1, "--set solve.x=: solve.x: is not a setting; known here are");
  expect("calibrate " + drive + " --set solve.joint_clouds=", 1, R"(expected true or false, found "")");
  expect("calibrate " + drive + " --set pairing.max_gap_s={", 1, "expected a number from 0.01 to 3600 s");
  expect("odometry " + drive + " -o " + path("poses.txt") + " --set run.threads", 1, "expected section.key=value");
  expect("calibrate " + drive + " --set pairing.min_distance_m=50", 1, "exceeds pairing.max_distance_m = 10");
  expect("simulate street " + path("x") + " --format kitti-raw --motion-distortion false", 1, "distorted by motion");
  expect("calibrate " + drive + " " + drive, 1, "same recording");
}

TEST_F(cli_faults, files_that_hold_unknown_or_impossible_settings_are_exit_code_2_with_the_line) {
  std::ofstream(path("unknown.yaml")) << "pairing:\n  gap: 1\n";
  std::ofstream(path("beyond.yaml")) << "pairing:\n  max_gap_s: 1e9\n";
  for (const std::string& verb : {"calibrate " + path("drive") + " --config ", std::string("settings --config ")}) {
    expect(verb + path("unknown.yaml"), 2, "unknown.yaml:2");
    expect(verb + path("beyond.yaml"), 2, "beyond.yaml:2");
    expect(verb + path("none.yaml"), 2, "none.yaml");
  }
}

TEST_F(cli_faults, half_a_session_is_exit_code_2_and_says_which_half) {
  std::filesystem::create_directories(folder_ / "half");
  std::ofstream(folder_ / "half" / "vicon.csv") << "1,0,0,0,0,0,0,1\n2,1,0,0,0,0,0,1\n3,2,0,0,0,0,0,1\n";
  std::filesystem::copy_file(folder_ / "half" / "vicon.csv", folder_ / "camera.csv");
  expect("calibrate " + path("half/vicon.csv"), 2, "neither scans nor LiDAR poses");
  expect("calibrate " + path("camera.csv"), 2, "no motion of an INS");
  expect("inspect " + path("half/vicon.csv"), 3, "neither scans nor LiDAR poses");
}

TEST_F(cli_faults, units_that_are_declared_wrongly_are_said_with_what_to_declare) {
  const std::string ns = changed("ns-as-s", "session.yaml", "unit: ns", "unit: s");
  expect("inspect " + ns, 2, "declare unit: ns");
}

TEST_F(cli_faults, every_export_is_a_nominal_of_the_same_mounting) {
  results::ResultFile file;
  file.ins_axes = drive::InsAxes::ForwardLeftUp;
  file.result.status = calibration::Status::Ok;
  file.result.set_observed(calibration::ParameterSet::all(), {});
  file.result.covariance = Matrix6d::Identity() * 1e-6;
  file.result.mounting.reference_from_sensor = rigid_from_six({1.2, -0.3, 0.8, 0.1, 0.02, -0.02});
  results::save_result(file, path("r.yaml"));
  for (const auto& format : results::exporters()) {
    if (!format->holds_mounting()) continue;
    const std::string exported = path("nominal_" + std::string(format->id()));
    ASSERT_EQ(run("export " + path("r.yaml") + " --to " + std::string(format->id()) + " -o " + exported).code, 0);
    // A nominal outside the range is refused with its numbers: that shows what was read without a calibration.
    for (const std::string& nominal : {exported, std::string(format->id()) + ":" + exported})
      expect("calibrate " + path("drive") + " --nominal " + nominal + " --range x=2:3,y=2:3,z=2:3,yaw=20:30", 1,
             "x 1.20 m (at least 2.00 m), y -0.30 m (at least 2.00 m), z 0.80 m (at least 2.00 m), yaw 5.73 deg (at "
             "least 20.00 deg)");
  }
  std::ofstream(path("novatel.yaml"))
      << "transform:\n  translation: {x: 0, y: 1, z: 0}\n  rotation: {x: 0, y: 0, z: 0, "
         "w: 1}\n";
  expect("calibrate " + path("drive") + " --nominal " + path("novatel.yaml") + " --range x=2:3", 1,
         "does not say which axes");
}

TEST_F(cli_faults, inspect_says_how_many_scans_it_read) {
  expect("inspect " + path("drive"), 0, "(3 of 15 scans were read)");
}

TEST_F(cli_faults, a_log_that_would_wait_for_a_reader_is_refused) {
  ASSERT_EQ(::mkfifo(path("fifo").c_str(), 0600), 0);
  expect("--log " + path("fifo") + " settings", 2, "fifo: the log cannot be written: it is a FIFO that nobody reads");
  expect("--append-log --log " + path("fifo") + " settings", 2, "it is a FIFO that nobody reads");
  expect("--log " + folder_.string() + " settings", 2, "Is a directory");
  expect("--log /dev/null settings", 0, "registration");
  const std::string into_a_pipe = std::string("'") + REMOUNT_CLI + "' --log /dev/stderr inspect " + path("drive") +
                                  " 2>&1 < /dev/null | cat > '" + path("out.txt") + "'";
  EXPECT_EQ(std::system(into_a_pipe.c_str()), 0);
  EXPECT_NE(text_of(path("out.txt")).find("remount-cli "), std::string::npos) << text_of(path("out.txt"));
  EXPECT_NE(text_of(path("out.txt")).find("usable: "), std::string::npos);
}

TEST_F(cli_faults, output_that_gets_lost_on_a_full_disk_is_no_success) {
  const auto with_full_output = [](const std::string& arguments) {
    const std::string command =
        std::string("'") + REMOUNT_CLI + "' " + arguments + " > /dev/full 2> '" + path("err.txt") + "' < /dev/null";
    const int status = std::system(command.c_str());
    EXPECT_NE(text_of(path("err.txt")).find("the output cannot be written: No space left on device"), std::string::npos)
        << text_of(path("err.txt"));
    return testing::exit_code_of(status);
  };
  for (const std::string& arguments : {"inspect " + path("drive"), std::string("settings"), std::string("--help")})
    EXPECT_EQ(with_full_output(arguments), 2) << arguments;
  EXPECT_EQ(with_full_output("--log /dev/full inspect " + path("drive")), 2);
  EXPECT_NE(text_of(path("err.txt")).find("the log cannot be written any further"), std::string::npos);
  expect("--log /dev/full inspect " + path("drive"), 2,
         "/dev/full: the log cannot be written any further: No space left on device");
}

}  // namespace
}  // namespace remount::cli
