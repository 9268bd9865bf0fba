#include "model/conventions/attitude_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "algorithms/messages/render.h"
#include "model/drive/attitude_convention.h"
#include "model/drive/session_frames.h"
#include "model/formats/files/input_file.h"
#include "model/formats/session_readers.h"
#include "model/pipeline/pipeline.h"
#include "model/results/result_file.h"
#include "model/simulator/simulator.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::conventions {
namespace {

drive::Session drive(double duration_s = 20.0) {
  simulator::SimulationOptions options;
  options.duration_s = duration_s;
  options.beams = 4;
  options.azimuth_steps = 20;
  return simulator::simulate_drive(options).session;
}

std::string codes(const drive::Session& session) {
  std::string text;
  for (const drive::Finding& finding : attitude_findings(session)) text += finding.code + " ";
  return text;
}

TEST(attitude_check, right_attitudes_pass_however_the_sensor_is_mounted) {
  for (const double yaw_deg : {0.0, 90.0, 180.0, -40.0}) {
    drive::Session session = drive();
    for (motion::InsSample& sample : session.ins)
      sample.enu_from_ins =
          sample.enu_from_ins * Eigen::AngleAxisd(degrees_to_radians(yaw_deg), Eigen::Vector3d::UnitZ());
    EXPECT_EQ(codes(session), "") << yaw_deg;
  }
}

TEST(attitude_check, a_quaternion_of_another_convention_is_named_with_the_right_one) {
  drive::Session as_if_enu = drive(), as_if_ned = drive(), conjugated = drive(), scalar_first = drive(),
                 scalar_last = drive();
  // What each sample says when the log's frames are taken for the other ones.
  const Eigen::Quaterniond ned_from_enu(Eigen::Matrix3d{{0, 1, 0}, {1, 0, 0}, {0, 0, -1}});
  const Eigen::Quaterniond frd_from_flu(Eigen::Matrix3d{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}});
  for (motion::InsSample& sample : as_if_enu.ins)
    sample.enu_from_ins = ned_from_enu * sample.enu_from_ins * frd_from_flu.conjugate();
  for (motion::InsSample& sample : as_if_ned.ins)
    sample.enu_from_ins = drive::enu_from_ins(sample.enu_from_ins, drive::QuaternionConvention::NedFromBody);
  for (motion::InsSample& sample : conjugated.ins) sample.enu_from_ins = sample.enu_from_ins.conjugate();
  for (motion::InsSample& sample : scalar_first.ins) {
    const Eigen::Vector4d xyzw = sample.enu_from_ins.coeffs();
    sample.enu_from_ins = Eigen::Quaterniond(xyzw[0], xyzw[1], xyzw[2], xyzw[3]);
  }
  for (motion::InsSample& sample : scalar_last.ins) {
    const Eigen::Vector4d xyzw = sample.enu_from_ins.coeffs();
    sample.enu_from_ins = Eigen::Quaterniond(xyzw[2], xyzw[3], xyzw[0], xyzw[1]);
  }
  for (const auto& [session, right] :
       {std::pair(&as_if_enu, "as NED instead of ENU"), std::pair(&as_if_ned, "as NED instead of ENU"),
        std::pair(&conjugated, "as the inverse"), std::pair(&scalar_first, "scalar part"),
        std::pair(&scalar_last, "scalar part")}) {
    const std::vector<drive::Finding> findings = attitude_findings(*session);
    ASSERT_FALSE(findings.empty()) << right;
    EXPECT_EQ(findings[0].code, "attitude-convention") << right;
    EXPECT_NE(english(findings[0].explanation).find(right), std::string::npos) << english(findings[0].explanation);
  }
}

TEST(attitude_check, a_heading_from_north_that_is_taken_for_a_yaw_looks_like_a_compass) {
  drive::Session session = drive();
  for (motion::InsSample& sample : session.ins) {
    const YawPitchRoll angles = yaw_pitch_roll_from_rotation(sample.enu_from_ins.toRotationMatrix());
    const double heading_rad = 0.5 * kPi - angles.yaw_rad;  // clockwise from north
    sample.enu_from_ins =
        Eigen::Quaterniond(rotation_from_yaw_pitch_roll({heading_rad, angles.pitch_rad, angles.roll_rad}));
  }
  const std::vector<drive::Finding> findings = attitude_findings(session);
  ASSERT_EQ(findings.size(), 1U) << codes(session);
  EXPECT_EQ(findings[0].code, "attitude-convention");
  EXPECT_EQ(findings[0].severity, drive::Severity::Problem);
  EXPECT_NE(english(findings[0].explanation).find("this looks like a compass heading"), std::string::npos)
      << english(findings[0].explanation);
}

/// Poses of a vehicle on a circle of `radius_m` at 5 m/s, 10 Hz, half to either side; seen `ahead_m` of its rear axle.
drive::Session eight(double radius_m, double ahead_m, double noise_m) {
  drive::Session session;
  session.name = "eight";
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double yaw_rad = 0.3;
  for (int i = 0; i < 600; ++i) {
    yaw_rad += 0.1 * 5.0 / radius_m * (i % 200 < 100 ? 1.0 : -1.0);
    const Eigen::Vector3d forward(std::cos(yaw_rad), std::sin(yaw_rad), 0.0);
    position += 0.5 * forward;
    const Eigen::Vector3d noise = noise_m * Eigen::Vector3d(normal(random), normal(random), normal(random));
    session.world_from_ins.push_back({i * 100'000'000LL, make_rigid(rotation_from_yaw_pitch_roll({yaw_rad, 0, 0}),
                                                                    position + ahead_m * forward + noise)});
  }
  return session;
}

TEST(attitude_check, side_slip_and_noise_are_no_convention) {
  for (const double noise_m : {0.0, 0.5})
    for (const auto& [radius_m, ahead_m] : {std::pair(5.0, 2.7), std::pair(5.5, 3.5), std::pair(10.0, 6.0)})
      EXPECT_EQ(codes(eight(radius_m, ahead_m, noise_m)), "") << radius_m << " " << ahead_m << " " << noise_m;
}

TEST(attitude_check, an_ins_upside_down_is_named_where_its_axes_are_known) {
  drive::Session session = drive();
  const Eigen::Quaterniond over(Eigen::AngleAxisd(kPi, Eigen::Vector3d::UnitX()));
  for (motion::InsSample& sample : session.ins) sample.enu_from_ins = sample.enu_from_ins * over;
  EXPECT_EQ(codes(session), "attitude-upside-down ");
  session.world_from_ins = drive::metric_poses(session);
  session.ins.clear();
  EXPECT_EQ(codes(session), "") << "a pose file may have any axes";
}

TEST(attitude_check, headings_of_their_own_are_named_for_poses_too) {
  drive::Session session = drive(40.0);
  for (motion::InsSample& sample : session.ins)
    sample.enu_from_ins =
        Eigen::AngleAxisd(degrees_to_radians(1e-7) * static_cast<double>(sample.stamp_ns % 7200000000),
                          Eigen::Vector3d::UnitZ()) *
        Eigen::Quaterniond::Identity();
  session.world_from_ins = drive::metric_poses(session);
  session.ins.clear();
  EXPECT_EQ(codes(session), "heading-against-travel ");
}

TEST(attitude_check, no_result_stands_on_another_convention) {
  const std::vector<drive::Finding> findings = {
      {drive::Severity::Problem, "attitude-convention", std::string("drive"), {}}};
  calibration::CalibrationResult good;
  good.status = calibration::Status::Degenerate;
  good.set_observed(calibration::ParameterSet::all(), {});
  good.advice = {Message::verbatim("drive more")};
  calibration::CalibrationResult bad = good, failed = good, cancelled = good, other = good;
  blame_attitude(findings, bad);
  EXPECT_EQ(bad.status, calibration::Status::Inconsistent);
  EXPECT_EQ(calibration::parameter_names(bad.observed()), "") << "nothing is claimed of it";
  ASSERT_EQ(bad.advice.size(), 1U);
  EXPECT_NE(english(bad.advice[0]).find("convention"), std::string::npos);
  failed.status = calibration::Status::TooFewPairs;
  blame_attitude(findings, failed);
  EXPECT_EQ(calibration::parameter_names(failed.observed()), "") << "whatever else went wrong";
  EXPECT_EQ(failed.status, calibration::Status::TooFewPairs);
  ASSERT_EQ(failed.advice.size(), 2U) << "another cause stays known";
  EXPECT_NE(english(failed.advice[0]).find("convention"), std::string::npos);
  cancelled.status = calibration::Status::Cancelled;
  blame_attitude(findings, cancelled);
  EXPECT_EQ(english(cancelled.advice[0]), "drive more");
  blame_attitude({{drive::Severity::Warning, "heading-against-travel", std::string("drive"), {}}}, other);
  EXPECT_EQ(other.status, calibration::Status::Degenerate);
}

TEST(attitude_check, a_log_whose_manifest_declares_another_convention_is_named_when_opened_and_gives_no_result) {
  simulator::SimulationOptions options;
  options.beams = 16;
  options.azimuth_steps = 300;
  options.duration_s = 8.0;
  const simulator::SimulatedDrive right = simulator::simulate_drive(options);
  const formats::TemporaryFolder folder;
  Progress progress;
  simulator::write_drive(right, folder.path() / "drive", "native", 1, progress);
  std::string manifest = formats::read_regular_file(folder.path() / "drive" / "session.yaml");
  const std::size_t at = manifest.find("enu-yaw");
  ASSERT_NE(at, std::string::npos) << manifest;
  folder.write("drive/session.yaml", manifest.replace(at, 7, "heading"));
  pipeline::PipelineInput input;
  input.sessions = {std::make_shared<const drive::Session>(formats::open_session(folder.path() / "drive", progress))};
  input.nominal_ins_from_lidar = right.ins_from_lidar;
  input.settings.pairing.max_partners = 2;  // registrations that fail are searched for, which takes long
  input.settings.run.map_check = false;
  const pipeline::PipelineOutput output = pipeline::run_pipeline(input, progress);
  EXPECT_EQ(std::count_if(output.findings.begin(), output.findings.end(),
                          [](const drive::Finding& finding) { return finding.code == "attitude-convention"; }),
            1);
  EXPECT_FALSE(calibration::is_usable(output.result)) << english(output.result.message);
  ASSERT_FALSE(output.result.advice.empty());
  EXPECT_NE(english(output.result.advice[0]).find("convention"), std::string::npos) << english(output.result.advice[0]);
}

TEST(attitude_check, a_vehicle_that_hardly_moves_tells_nothing) {
  drive::Session session = drive();
  for (motion::InsSample& sample : session.ins) {
    sample.latitude_rad = session.ins.front().latitude_rad;
    sample.longitude_rad = session.ins.front().longitude_rad;
    sample.height_m = 0.0;
    sample.enu_from_ins = sample.enu_from_ins.conjugate();
  }
  EXPECT_EQ(codes(session), "");
  EXPECT_EQ(codes(drive::Session{}), "");
}

}  // namespace
}  // namespace remount::conventions
