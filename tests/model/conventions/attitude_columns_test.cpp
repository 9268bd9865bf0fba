#include "model/conventions/attitude_columns.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <string>

#include "algorithms/messages/render.h"
#include "model/conventions/attitude_check.h"
#include "model/drive/session_frames.h"
#include "model/formats/session_readers.h"
#include "model/overview/session_report.h"
#include "model/simulator/simulator.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/kept_scans.h"
#include "tests/support/peak_memory.h"
#include "tests/support/recorded_drives.h"

namespace remount::conventions {

using drive::AttitudeAngles;
using drive::Session;
using simulator::ScenarioKind;

namespace {

simulator::SimulatedDrive simulated(ScenarioKind scenario, double duration_s = 60.0, int seed = 1) {
  simulator::SimulationOptions options;
  options.scenario = scenario;
  options.duration_s = duration_s;
  options.seed = seed;
  options.beams = 4;
  options.azimuth_steps = 60;
  return testing::simulate_drive(options);
}

using Columns = std::function<AttitudeAngles(const AttitudeAngles&)>;

/// The log with its columns mixed up.
Session mixed(Session session, const Columns& columns,
              drive::AttitudeConvention convention = drive::AttitudeConvention::EnuYaw) {
  for (motion::InsSample& sample : session.ins)
    sample.enu_from_ins = drive::enu_from_ins(columns(drive::angles_from(sample.enu_from_ins, convention)), convention);
  return session;
}

AttitudeAngles pitch_negated(const AttitudeAngles& a) { return {a.yaw_rad, -a.pitch_rad, a.roll_rad}; }
AttitudeAngles roll_negated(const AttitudeAngles& a) { return {a.yaw_rad, a.pitch_rad, -a.roll_rad}; }
AttitudeAngles both_negated(const AttitudeAngles& a) { return {a.yaw_rad, -a.pitch_rad, -a.roll_rad}; }
AttitudeAngles exchanged(const AttitudeAngles& a) { return {a.yaw_rad, a.roll_rad, a.pitch_rad}; }
AttitudeAngles yaw_with_pitch(const AttitudeAngles& a) { return {a.pitch_rad, a.yaw_rad, a.roll_rad}; }
AttitudeAngles yaw_with_roll(const AttitudeAngles& a) { return {a.roll_rad, a.pitch_rad, a.yaw_rad}; }

std::string said(const Session& session) {
  std::string text;
  for (const drive::Finding& finding : attitude_findings(session))
    text += "[" + finding.code + "] " + english(finding.explanation);
  std::printf("%s\n", text.c_str());
  return text;
}

Session without_imu(Session session) {
  session.imu.clear();
  return session;
}

/// Poses that a perfect odometry of the LiDAR would give.
Session with_odometry(const simulator::SimulatedDrive& drive) {
  Session session = without_imu(drive.session);
  session.scans = nullptr;
  const RigidTransform first_from_enu = (drive.enu_from_ins.front().pose * drive.ins_from_lidar).inverse();
  for (const motion::StampedPose& pose : drive.enu_from_ins)
    session.odometry_from_lidar.push_back({pose.stamp_ns, first_from_enu * pose.pose * drive.ins_from_lidar});
  return session;
}

TEST(attitude_columns, pitch_that_counts_the_other_way_goes_against_the_slope) {
  for (const ScenarioKind scenario : {ScenarioKind::Hill, ScenarioKind::ParkingRamp}) {
    const Session hill = without_imu(simulated(scenario).session);
    EXPECT_NE(said(mixed(hill, pitch_negated)).find("contradict the slope of its path"), std::string::npos);
    EXPECT_NE(said(mixed(hill, pitch_negated)).find("with pitch counted the other way they"), std::string::npos);
    EXPECT_NE(said(mixed(hill, exchanged)).find("with pitch and roll exchanged"), std::string::npos);
    EXPECT_EQ(said(mixed(hill, roll_negated)), "") << "the path knows nothing of roll";
  }
}

TEST(attitude_columns, forces_of_the_imu_tell_pitch_from_roll) {
  const Session street = simulated(ScenarioKind::Street).session;
  EXPECT_NE(said(mixed(street, roll_negated)).find("with roll counted the other way"), std::string::npos);
  EXPECT_NE(said(mixed(street, pitch_negated)).find("with pitch counted the other way"), std::string::npos);
  EXPECT_NE(said(mixed(street, both_negated)).find("with pitch and roll both counted the other way"),
            std::string::npos);
  EXPECT_NE(said(mixed(street, exchanged)).find("with pitch and roll exchanged they"), std::string::npos);
  EXPECT_NE(
      said(mixed(street, exchanged, drive::AttitudeConvention::Heading)).find("with pitch and roll exchanged they"),
      std::string::npos);
}

TEST(attitude_columns, turns_of_the_lidar_show_a_mirrored_tilt) {
  const Session street = with_odometry(simulated(ScenarioKind::Street));
  for (const Columns& columns : {Columns(pitch_negated), Columns(roll_negated), Columns(exchanged)})
    EXPECT_NE(said(mixed(street, columns)).find("[attitude-columns]"), std::string::npos);
  EXPECT_EQ(said(street), "");
}

TEST(attitude_columns, a_yaw_in_the_wrong_column_is_named) {
  for (const ScenarioKind scenario : {ScenarioKind::Street, ScenarioKind::FigureEight, ScenarioKind::Hill}) {
    const Session session = simulated(scenario).session;
    for (const drive::AttitudeConvention convention :
         {drive::AttitudeConvention::EnuYaw, drive::AttitudeConvention::Heading}) {
      EXPECT_NE(said(mixed(session, yaw_with_pitch, convention)).find("[attitude-columns]"), std::string::npos);
      EXPECT_NE(said(mixed(session, yaw_with_pitch, convention)).find("with yaw and pitch exchanged"),
                std::string::npos);
      EXPECT_NE(said(mixed(session, yaw_with_roll, convention)).find("with yaw and roll exchanged"), std::string::npos);
    }
  }
}

TEST(attitude_columns, radians_for_degrees_and_exchanged_places_have_one_advice) {
  const Session street = simulated(ScenarioKind::Street).session;
  for (const drive::AttitudeConvention convention :
       {drive::AttitudeConvention::EnuYaw, drive::AttitudeConvention::Heading}) {
    const Session shrunk = mixed(
        street,
        [](const AttitudeAngles& a) {
          return AttitudeAngles{degrees_to_radians(wrap_angle_rad(a.yaw_rad)), degrees_to_radians(a.pitch_rad),
                                degrees_to_radians(a.roll_rad)};
        },
        convention);
    ASSERT_EQ(attitude_findings(shrunk).size(), 1U);
    EXPECT_NE(said(shrunk).find("[attitude-unit]"), std::string::npos);
  }
  Session places = street;
  for (motion::InsSample& sample : places.ins) std::swap(sample.latitude_rad, sample.longitude_rad);
  ASSERT_EQ(attitude_findings(places).size(), 1U);
  EXPECT_NE(said(places).find("[position-columns]"), std::string::npos);
  Session known = mixed(street, yaw_with_pitch);
  known.findings.push_back({drive::Severity::Problem, "angle-unit", std::string("ins.csv"), {}});
  EXPECT_TRUE(attitude_findings(known).empty()) << "the reader found the cause";
}

TEST(attitude_columns, sound_drives_are_silent_however_the_sensors_are_mounted) {
  for (const ScenarioKind scenario : {ScenarioKind::Street, ScenarioKind::Flat, ScenarioKind::Straight,
                                      ScenarioKind::FigureEight, ScenarioKind::ParkingRamp, ScenarioKind::Hill,
                                      ScenarioKind::Highway, ScenarioKind::Tunnel, ScenarioKind::SlewYard})
    for (const int seed : {1, 2}) {
      const simulator::SimulatedDrive drive = simulated(scenario, 30.0, seed);
      EXPECT_EQ(said(drive.session), "") << static_cast<int>(scenario);
      if (scenario == ScenarioKind::SlewYard) continue;
      EXPECT_EQ(said(with_odometry(drive)), "") << static_cast<int>(scenario);
      // Turned and tilted in the vehicle, as the IMU is.
      for (const YawPitchRoll& mounted :
           {YawPitchRoll{0.5 * kPi, 0.1, 0.0}, YawPitchRoll{kPi, 0.0, -0.1}, YawPitchRoll{-0.7, 0.05, 0.2}}) {
        Session turned = drive.session;
        const Eigen::Quaterniond by(rotation_from_yaw_pitch_roll(mounted));
        for (motion::InsSample& sample : turned.ins) sample.enu_from_ins = sample.enu_from_ins * by;
        EXPECT_EQ(said(turned), "") << static_cast<int>(scenario) << " " << mounted.yaw_rad;
      }
    }
  simulator::SimulationOptions noisy;
  noisy.duration_s = 30.0;
  noisy.ins_position_noise_m = 0.5;
  noisy.ins_attitude_noise_deg = 1.0;
  EXPECT_EQ(said(testing::simulate_drive(noisy).session), "");
  EXPECT_EQ(said(Session{}), "");
}

TEST(attitude_columns, of_samples_that_are_far_apart_take_no_memory_for_what_is_between_them) {
  Session session = simulated(ScenarioKind::Street, 20.0).session;
  session.ins.resize(40);
  session.imu.resize(40);
  constexpr std::int64_t kApart_ns = 10'000'000'000'000;
  for (std::size_t i = 0; i < session.ins.size(); ++i)
    session.ins[i].stamp_ns = session.imu[i].stamp_ns += static_cast<std::int64_t>(i) * kApart_ns;
  const double before_mb = testing::peak_mb();
  EXPECT_EQ(said(session), "");
  std::printf("memory grew by %.1f MB\n", testing::peak_mb() - before_mb);
  EXPECT_LT(testing::peak_mb() - before_mb, 20.0);
}

TEST(attitude_columns, inspect_names_columns_that_are_exchanged) {
  const simulator::SimulatedDrive right = simulated(ScenarioKind::Street, 30.0);
  for (const auto& [columns, code] : {std::pair(Columns(exchanged), "problem [attitude-columns]"),
                                      std::pair(Columns(yaw_with_pitch), "problem [attitude-columns]")}) {
    simulator::SimulatedDrive drive = right;
    drive.session = mixed(right.session, columns);
    const formats::TemporaryFolder folder;
    Progress progress;
    simulator::write_drive(drive, folder.path() / "drive", "native", 1, progress);
    const Session session = formats::open_session(folder.path() / "drive", progress);
    const std::string inspected = overview::describe(session, overview::report_session(session, progress));
    EXPECT_NE(inspected.find(code), std::string::npos) << inspected;
  }
}

TEST(attitude_columns, recorded_drives_are_silent_until_their_columns_are_mixed_up) {
  if (!std::filesystem::exists(testing::kData / "zxl19")) GTEST_SKIP() << "no recorded drives beside the checkout";
  for (const char* bag : {"bag1", "bag2", "bag4"}) {
    Progress progress;
    const Session session = formats::open_session(testing::kData / "zxl19" / bag, progress);
    EXPECT_EQ(said(session), "") << bag;
    for (const Columns& columns : {Columns(pitch_negated), Columns(roll_negated), Columns(exchanged)})
      EXPECT_NE(
          said(mixed(session, columns, drive::AttitudeConvention::NovAtel)).find("contradict the turns of the LiDAR"),
          std::string::npos)
          << bag;
    EXPECT_NE(
        said(mixed(session, yaw_with_pitch, drive::AttitudeConvention::NovAtel)).find("with yaw and pitch exchanged"),
        std::string::npos)
        << bag;
  }
}

TEST(attitude_columns, turns_alone_are_judged_as_they_are_registered) {
  const simulator::SimulatedDrive drive = simulated(ScenarioKind::Street);
  std::vector<SharedTurn> sound, mirrored;
  for (std::size_t i = 10; i < drive.enu_from_ins.size(); i += 10) {
    const RigidTransform &a = drive.enu_from_ins[i - 10].pose, &b = drive.enu_from_ins[i].pose;
    const RigidTransform q = (b * drive.ins_from_lidar).inverse() * (a * drive.ins_from_lidar);
    sound.push_back({a.linear(), b.linear(), q.linear()});
    const auto turned_over = [](const RigidTransform& pose) {
      YawPitchRoll angles = yaw_pitch_roll_from_rotation(pose.linear());
      angles.pitch_rad = -angles.pitch_rad;
      return rotation_from_yaw_pitch_roll(angles);
    };
    mirrored.push_back({turned_over(a), turned_over(b), q.linear()});
  }
  EXPECT_FALSE(attitude_column_finding(sound, "drive"));
  const std::optional<drive::Finding> finding = attitude_column_finding(mirrored, "drive");
  ASSERT_TRUE(finding);
  EXPECT_NE(english(finding->explanation).find("the turns of the LiDAR"), std::string::npos)
      << english(finding->explanation);
  EXPECT_FALSE(attitude_column_finding({}, "drive"));
}

}  // namespace
}  // namespace remount::conventions
