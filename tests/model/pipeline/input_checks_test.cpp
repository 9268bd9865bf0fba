#include "model/pipeline/input_checks.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "model/formats/session_readers.h"
#include "model/pipeline/pipeline.h"
#include "model/simulator/simulator.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/forwarded_scans.h"

namespace remount::pipeline {
namespace {

simulator::SimulationOptions tiny() {
  simulator::SimulationOptions options;
  options.duration_s = 1.0;
  options.beams = 8;
  options.azimuth_steps = 100;
  return options;
}

std::shared_ptr<drive::Session> tiny_session(int seed = 1) {
  simulator::SimulationOptions options = tiny();
  options.seed = seed;
  return std::make_shared<drive::Session>(simulator::simulate_drive(options).session);
}

PipelineOutput run(std::vector<std::shared_ptr<const drive::Session>> sessions,
                   const settings::Settings& settings = {}) {
  PipelineInput input;
  input.sessions = std::move(sessions);
  input.settings = settings;
  input.nominal_ins_from_lidar = RigidTransform::Identity();
  Progress progress;
  return run_pipeline(input, progress);
}

TEST(input_checks, sessions_with_other_ins_axes_are_refused_and_those_that_do_not_say_are_not) {
  const auto first = tiny_session(1), second = tiny_session(2);
  first->path = "/data/first", second->path = "/data/second";
  second->ins_axes = drive::InsAxes::RightForwardUp;
  EXPECT_ERROR(check_sessions({first, second}), "/data/second: has INS axes x right, y forward, z up, but /data/first");
  second->ins_axes.reset();
  EXPECT_NO_THROW(check_sessions({first, second}));
}

TEST(input_checks, one_recording_given_twice_is_refused_and_both_are_named) {
  const formats::TemporaryFolder folder;
  Progress progress;
  simulator::write_drive(simulator::simulate_drive(tiny()), folder.path() / "one", "native", 1, progress);
  std::filesystem::copy(folder.path() / "one", folder.path() / "copy", std::filesystem::copy_options::recursive);
  const auto open = [&](const char* name) {
    return std::make_shared<const drive::Session>(formats::open_session(folder.path() / name, progress));
  };
  for (const char* again : {"one", "one/", "one/session.yaml", "copy"}) {
    EXPECT_ERROR(check_sessions({open("one"), open(again)}), "one");
    EXPECT_ERROR(check_sessions({open("one"), open(again)}), again);
    EXPECT_ERROR(check_sessions({tiny_session(2), open("one"), open(again)}), "same recording");
  }
  EXPECT_ERROR(run({open("one"), open("copy")}), "same recording");
}

TEST(input_checks, part_of_a_recording_and_shifted_stamps_are_the_same_recording) {
  const auto whole = tiny_session();
  const auto same = tiny_session();
  EXPECT_ERROR(check_sessions({whole, same}), "same recording");
  auto poses = std::make_shared<drive::Session>(*whole), part = std::make_shared<drive::Session>(*whole);
  for (int i = 0; i < 8; ++i) poses->odometry_from_lidar.push_back({i * 100, rigid_from_six({0.1 * i, 0, 0, 0, 0, 0})});
  poses->scans = part->scans = nullptr;
  part->odometry_from_lidar = {poses->odometry_from_lidar.begin() + 3, poses->odometry_from_lidar.begin() + 6};
  EXPECT_ERROR(check_sessions({poses, part}), "same recording");
}

TEST(input_checks, scans_of_the_same_times_beside_the_same_ins_are_the_same_recording_whatever_their_points) {
  const formats::TemporaryFolder folder;
  Progress progress;
  simulator::write_drive(simulator::simulate_drive(tiny()), folder.path() / "pcd", "native", 1, progress);
  simulator::write_drive(simulator::simulate_drive(tiny()), folder.path() / "las", "native-las", 1, progress);
  const auto whole = std::make_shared<const drive::Session>(formats::open_session(folder.path() / "pcd", progress)),
             rounded = std::make_shared<const drive::Session>(formats::open_session(folder.path() / "las", progress));
  ASSERT_NE(whole->scans->load(0).points, rounded->scans->load(0).points) << "LAS rounds";
  EXPECT_ERROR(check_sessions({whole, rounded}), "same recording");
  auto written_anew = std::make_shared<drive::Session>(*rounded);
  for (motion::InsSample& sample : written_anew->ins) {
    sample.latitude_rad += 1e-11;
    sample.enu_from_ins.coeffs() *= -1.0;
  }
  EXPECT_ERROR(check_sessions({whole, written_anew}), "same recording");
  auto other_drive = std::make_shared<drive::Session>(*rounded);
  for (motion::InsSample& sample : other_drive->ins) sample.latitude_rad += 1e-5;
  EXPECT_NO_THROW(check_sessions({whole, other_drive})) << "stamps that count from the start of a drive";
}

TEST(input_checks, drives_that_begin_at_rest_on_relative_stamps_are_not_taken_for_one) {
  const auto drive = [](int poses, int rest, double step_m, double later_step_m) {
    auto session = tiny_session();
    session->scans = nullptr;
    double x_m = 0.0;
    for (int i = 0; i < poses; ++i) {
      x_m += i < rest ? 0.0 : i < poses / 2 ? step_m : later_step_m;
      session->odometry_from_lidar.push_back({i * 100, rigid_from_six({x_m, 0, 0, 0, 0, 0})});
    }
    return session;
  };
  EXPECT_NO_THROW(check_sessions({drive(40, 10, 0.1, 0.1), drive(40, 10, 0.2, 0.2)}));
  EXPECT_NO_THROW(check_sessions({drive(40, 38, 0.1, 0.1), drive(40, 38, 0.2, 0.2)})) << "equal at rest only";
  EXPECT_NO_THROW(check_sessions({drive(40, 10, 0.1, 0.1), drive(40, 10, 0.1, 0.2)})) << "half is not most";
  EXPECT_NO_THROW(check_sessions({drive(6, 2, 0.1, 0.1), drive(6, 2, 0.2, 0.2)}));
  EXPECT_ERROR(check_sessions({drive(40, 10, 0.1, 0.1), drive(40, 10, 0.1, 0.1)}), "same recording");
  EXPECT_ERROR(check_sessions({drive(40, 2, 0.1, 0.1), drive(8, 2, 0.1, 0.1)}), "same recording");
}

TEST(input_checks, recordings_of_a_machine_that_stands_still_are_not_one_for_that) {
  simulator::SimulationOptions options = tiny();
  options.scenario = simulator::ScenarioKind::SlewYard;
  std::vector<std::shared_ptr<const drive::Session>> recordings;
  for (const simulator::SlewRecording kind :
       {simulator::SlewRecording::Ground, simulator::SlewRecording::ArmSweep, simulator::SlewRecording::FullTurn}) {
    options.slew_yard.recording = kind;
    recordings.push_back(std::make_shared<const drive::Session>(simulator::simulate_drive(options).session));
  }
  EXPECT_NO_THROW(check_companions(recordings)) << "their INS stands at one place, at the same times";
  EXPECT_TRUE(same_recording(*recordings[1], *recordings[1]));
}

TEST(input_checks, one_session_at_rest_does_not_make_a_drive_one_at_rest) {
  settings::Settings settings;
  settings.pairing.min_distance_m = 2.0;
  const DriveMotion motion({tiny_session(1), tiny_session(2)});
  std::vector<motion::Keyframe> keyframes(4);
  keyframes[1].travelled_m = 50.0;
  keyframes[2].session = keyframes[3].session = motion::SessionIndex{1};
  const calibration::CalibrationResult driven = result_without_pairs(motion, keyframes, settings);
  ASSERT_EQ(driven.advice.size(), 1U);
  EXPECT_EQ(english(driven.advice[0]).find("stands still"), std::string::npos) << english(driven.advice[0]);
  keyframes[1].travelled_m = 0.0;
  EXPECT_NE(english(result_without_pairs(motion, keyframes, settings).advice.at(0)).find("stands still"),
            std::string::npos);
}

TEST(input_checks, drives_of_one_vehicle_are_not_taken_for_one) {
  EXPECT_NO_THROW(check_sessions({tiny_session(1), tiny_session(2), tiny_session(3)}));
}

TEST(input_checks, half_a_session_is_refused_with_the_half_that_is_missing) {
  auto no_lidar = tiny_session(), no_ins = tiny_session();
  no_lidar->scans = nullptr;
  no_ins->ins.clear();
  EXPECT_ERROR(run({no_lidar}), "neither scans nor LiDAR poses");
  EXPECT_ERROR(run({no_ins}), "no motion of an INS");
  for (const auto& half : {no_lidar, no_ins}) {
    try {
      run({half});
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::Unsupported) << "input that cannot be used, not wrong usage";
    }
  }
}

TEST(input_checks, clocks_that_are_apart_are_named_with_the_difference) {
  auto session = tiny_session();
  for (motion::InsSample& sample : session->ins) sample.stamp_ns += 18'000'000'000;
  const calibration::CalibrationResult result = run({session}).result;
  EXPECT_EQ(result.status, calibration::Status::NoUsableData);
  EXPECT_NE(english(result.message).find("No scan lies within the INS data"), std::string::npos)
      << english(result.message);
  EXPECT_NE(english(result.message).find("leap seconds"), std::string::npos) << english(result.message);
  ASSERT_EQ(result.advice.size(), 1U);
  EXPECT_EQ(english(result.advice[0]).find("rive turns"), std::string::npos) << english(result.advice[0]);
}

TEST(input_checks, settings_that_leave_no_pair_are_named_with_their_values) {
  settings::Settings settings;
  settings.pairing.min_distance_m = 90.0;
  settings.pairing.max_distance_m = 100.0;
  settings.pairing.min_rotation_deg = 90.0;
  const calibration::CalibrationResult result = run({tiny_session()}, settings).result;
  EXPECT_EQ(result.status, calibration::Status::TooFewPairs);
  EXPECT_NE(english(result.message).find("pairing.min_distance_m = 90 m"), std::string::npos)
      << english(result.message);
}

/// Scans none of which can be read.
class BrokenScans final : public testing::ForwardedScans {
 public:
  using ForwardedScans::ForwardedScans;
  cloud::PointCloud load(std::size_t scan) const override {
    throw Error(ErrorCode::Format, name(scan) + ".pcd:11",
                Message::verbatim("promises more points than the file holds"));
  }
};

TEST(input_checks, scans_that_cannot_be_read_at_all_are_said_so) {
  auto session = tiny_session();
  session->scans = std::make_shared<BrokenScans>(session->scans);
  for (const bool nominal : {true, false}) {
    PipelineInput input;
    input.sessions = {session};
    if (nominal) input.nominal_ins_from_lidar = RigidTransform::Identity();
    Progress progress;
    const calibration::CalibrationResult result = run_pipeline(input, progress).result;
    EXPECT_EQ(result.status, calibration::Status::NoUsableData);
    EXPECT_NE(english(result.message).find("scans that are needed can be read. First: 0000"), std::string::npos)
        << english(result.message);
    ASSERT_FALSE(result.advice.empty());
    EXPECT_EQ(english(result.advice[0]).find("rive turns"), std::string::npos) << english(result.advice[0]);
  }
}

TEST(input_checks, a_spacing_that_was_set_larger_is_not_given_up_without_a_word) {
  drive::Session session;
  session.name = "short";
  const auto said = [&](const motion::KeyframeOptions& options, std::size_t asked_for, std::size_t chosen) {
    std::vector<drive::Finding> findings;
    report_closer_keyframes(session, options, asked_for, chosen, findings);
    return findings.empty() ? std::string() : english(findings.front().explanation);
  };
  motion::KeyframeOptions options;
  EXPECT_EQ(said(options, 12, 48), "") << "the default is nobody's wish";
  options.distance_m = 5.0;
  EXPECT_EQ(said(options, 60, 60), "");
  EXPECT_NE(said(options, 12, 48).find("5 m or 5 deg, the drive has 12 keyframes"), std::string::npos)
      << said(options, 12, 48);
  options.mode = motion::KeyframeMode::Time;
  EXPECT_EQ(said(options, 12, 48), "") << "the distance does not matter";
  options.interval_s = 2.0;
  EXPECT_NE(said(options, 12, 48).find("2 s, the drive has 12 keyframes"), std::string::npos);
}

}  // namespace
}  // namespace remount::pipeline
