// Positions that leave the earth: left out and counted by readers, survived by everything behind them.
#include "model/conventions/impossible_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <string>
#include <vector>

#include "algorithms/cloud/deskew.h"
#include "algorithms/messages/render.h"
#include "algorithms/registration/registration.h"
#include "model/drive/session_frames.h"
#include "model/method_registry/calibration_method.h"
#include "model/pipeline/pipeline.h"
#include "model/simulator/drive_formats.h"
#include "tests/model/formats/bags/bag_maker.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/motion_drive.h"

namespace remount::conventions {
namespace {

constexpr double kBeyond_m[] = {1e10, 4e15, 1e38, 1e200};

simulator::SimulatedDrive short_drive() {
  simulator::SimulationOptions options;
  options.scenario = simulator::ScenarioKind::FigureEight;
  options.duration_s = 4.0;
  options.beams = 8;
  options.azimuth_steps = 120;
  options.ins_rate_hz = 50.0;
  options.scan_rate_hz = 5.0;
  options.imu.rate_hz = 50.0;
  options.wheels.rate_hz = 20.0;
  return simulator::simulate_drive(options);
}

/// Poses of the INS instead of its samples, one of them somewhere else.
drive::Session with_a_leap(const simulator::SimulatedDrive& drive, double to_m) {
  drive::Session session = drive.session;
  session.world_from_ins = drive::metric_poses(session);
  session.ins.clear();
  session.world_from_ins[session.world_from_ins.size() / 2].pose.translation().x() = to_m;
  return session;
}

/// Half a minute and more, by poses of the LiDAR: long enough for every method that takes them.
simulator::SimulatedDrive long_drive() {
  simulator::SimulationOptions options = testing::motion_options(simulator::ScenarioKind::FigureEight, 40.0, 50.0);
  options.wheels.rate_hz = 20.0;
  return simulator::simulate_drive(options);
}

/// What comes of it: a result, or an Error.
struct MethodOutcome {
  pipeline::PipelineOutput output;
  std::string error;
};
MethodOutcome outcome_of(const method_registry::CalibrationMethod& method, const pipeline::PipelineInput& input) {
  Progress progress;
  try {
    return {method.run(input, progress), ""};
  } catch (const Error& error) {
    return {{}, error.what()};
  }
}

bool tells_of_leaving_out(const pipeline::PipelineOutput& output) {
  return std::any_of(output.findings.begin(), output.findings.end(),
                     [](const drive::Finding& finding) { return finding.code == "off-earth"; });
}

/// A result of this status that says why, and what was left out.
void expect_result(const MethodOutcome& outcome, calibration::Status status) {
  ASSERT_EQ(outcome.error, "");
  const calibration::CalibrationResult& result = outcome.output.result;
  std::printf("  %s: %s\n", std::string(to_string(result.status)).c_str(), english(result.message).c_str());
  EXPECT_EQ(result.status, status) << english(result.message);
  EXPECT_NE(english(result.message), "");
  EXPECT_TRUE(result.mounting.reference_from_sensor.matrix().allFinite());
  EXPECT_TRUE(tells_of_leaving_out(outcome.output));
}

/// Of four seconds, which are too few for every method.
calibration::Status status_of_short_drive(std::string_view method) {
  if (method == "pairwise" || method == "vehicle-frame") return calibration::Status::Degenerate;
  return method == "fusion-odometry" ? calibration::Status::TooFewPairs : calibration::Status::TooLittleData;
}

TEST(impossible_motion, of_the_ins_ends_no_method_otherwise_than_with_an_outcome) {
  const simulator::SimulatedDrive drive = short_drive();
  for (const double to_m : {1e10, 1e200})
    for (const method_registry::CalibrationMethod* method : method_registry::calibration_methods())
      for (const bool nominal : {false, true}) {
        SCOPED_TRACE(std::string(method->id) + (nominal ? " with a nominal, to " : ", to ") + std::to_string(to_m));
        if (to_m > 1e12 && nominal) continue;  // a few are enough for what does not differ
        pipeline::PipelineInput input;
        input.sessions = {std::make_shared<const drive::Session>(with_a_leap(drive, to_m))};
        if (nominal) input.nominal_ins_from_lidar = drive.ins_from_lidar;
        expect_result(outcome_of(*method, input), status_of_short_drive(method->id));
      }
}

TEST(impossible_motion, of_ins_or_lidar_leaves_a_result_where_the_drive_is_long_enough) {
  const simulator::SimulatedDrive drive = long_drive();
  for (const bool lidar : {false, true})
    for (const double to_m :
         lidar ? std::vector<double>(std::begin(kBeyond_m), std::end(kBeyond_m)) : std::vector<double>{1e10, 1e200})
      for (const method_registry::CalibrationMethod* method : method_registry::calibration_methods()) {
        SCOPED_TRACE(std::string(method->id) + (lidar ? ", LiDAR to " : ", INS to ") + std::to_string(to_m));
        drive::Session session = lidar ? drive.session : with_a_leap(drive, to_m);
        session.scans.reset();
        session.odometry_from_lidar = simulator::exact_odometry(drive);
        if (lidar) session.odometry_from_lidar[30].pose.translation().y() = -to_m;
        pipeline::PipelineInput input;
        input.sessions = {std::make_shared<const drive::Session>(std::move(session))};
        const MethodOutcome outcome = outcome_of(*method, input);
        if (method->id == "fusion-odometry") {
          EXPECT_TRUE(formats::contains(outcome.error, "has no scans; the multi-sensor odometry needs them"))
              << outcome.error;
          continue;
        }
        expect_result(outcome, method->id == "slew" ? calibration::Status::TooLittleData : calibration::Status::Ok);
        if (outcome.output.result.mounting.reference == calibration::BodyFrame::Ins)
          testing::expect_within_sigma(outcome.output.result, drive.ins_from_lidar, 4.0);
      }
}

TEST(impossible_motion, is_left_out_and_counted_before_a_drive_is_solved) {
  const simulator::SimulatedDrive drive = short_drive();
  for (const double to_m : {4e15, 1e200, 8e8}) {
    pipeline::PipelineInput input;
    input.sessions = {std::make_shared<const drive::Session>(with_a_leap(drive, to_m))};
    input.nominal_ins_from_lidar = drive.ins_from_lidar;
    Progress progress;
    pipeline::PipelineOutput output = pipeline::run_pipeline(input, progress);
    const auto told = std::find_if(output.findings.begin(), output.findings.end(),
                                   [](const drive::Finding& finding) { return finding.code == "off-earth"; });
    ASSERT_NE(told, output.findings.end());
    EXPECT_EQ(english(told->explanation).substr(0, 9), "1 sample ");
    EXPECT_TRUE(pipeline::solve_again(input, output, progress));
    pipeline::check_map(input, output, progress);
    EXPECT_GT(pipeline::load_map_scans(input, output, motion::SessionIndex{0}, 1000, progress).points_recorded, 0u);
    if (calibration::is_usable(output.result)) testing::expect_within_sigma(output.result, drive.ins_from_lidar, 4.0);
  }
}

TEST(impossible_motion, throughout_is_refused_with_the_reason) {
  drive::Session session = with_a_leap(short_drive(), 0.0);
  session.name = "far";
  for (motion::StampedPose& pose : session.world_from_ins) pose.pose.translation() *= 1e200;
  for (motion::StampedPose& pose : session.world_from_ins) pose.pose.translation().x() += 1e200;
  EXPECT_ERROR(leave_out_impossible(session), "no position of the INS lies on the earth");
}

TEST(impossible_motion, of_other_sensors_is_left_out) {
  const simulator::SimulatedDrive drive = short_drive();
  drive::Session session = drive.session;
  session.imu.at(5).angular_rate_radps.x() = 1e200;
  session.wheels.at(5).rear_left_mps = 1e200;
  session.ins.at(5).height_m = 1e200;
  const std::size_t imu = session.imu.size(), wheels = session.wheels.size(), ins = session.ins.size();
  leave_out_impossible(session);
  EXPECT_EQ(session.imu.size(), imu - 1);
  EXPECT_EQ(session.wheels.size(), wheels - 1);
  EXPECT_EQ(session.ins.size(), ins - 1);
  std::vector<std::string> told;
  for (const drive::Finding& finding : session.findings)
    if (finding.code == "off-earth")
      told.push_back(drive::english(finding.where) + ": " + english(finding.explanation));
  ASSERT_EQ(told.size(), 3u);
  EXPECT_TRUE(formats::contains(told[0], "INS: 1 sample is beyond anything that a vehicle reaches (no latitude,"))
      << told[0];
  EXPECT_TRUE(formats::contains(told[1], "IMU: 1 sample is beyond anything that a vehicle reaches (values")) << told[1];
  EXPECT_TRUE(formats::contains(told[2], "wheels: 1 sample is beyond anything that a vehicle reaches (values"))
      << told[2];
}

TEST(impossible_motion, in_a_pair_rejects_the_pair) {
  for (const double by_m : kBeyond_m) {
    const RigidTransform x = rigid_from_six({0.9, -0.25, 0.75, 0.03, -0.02, 0.015});
    std::vector<motion::Keyframe> keyframes;
    std::vector<motion::Pair> pairs;
    for (int i = 0; i < 24; ++i) {
      keyframes.push_back({motion::SessionIndex{0}, index_at<motion::ScanIndex>(2 * i), 0, 0.0});
      keyframes.push_back({motion::SessionIndex{0}, index_at<motion::ScanIndex>(2 * i + 1), 0, 0.0});
      motion::Pair pair;
      pair.keyframe_a = index_at<motion::KeyframeIndex>(2 * i),
      pair.keyframe_b = index_at<motion::KeyframeIndex>(2 * i + 1);
      pair.ins_b_from_ins_a = rigid_from_six({1.0, 0.1 * i, 0.05 * (i % 5), 0.1 + 0.01 * i, 0.05 * (i % 3), 0.04});
      pair.lidar_b_from_lidar_a = x.inverse() * pair.ins_b_from_ins_a * x;
      pairs.push_back(pair);
    }
    pairs[4].ins_b_from_ins_a.translation().x() = by_m;
    pairs[9].lidar_b_from_lidar_a.translation().z() = -by_m;
    Progress progress;
    const calibration::CalibrationResult result =
        pipeline::solve_motion_pairs(keyframes, pairs, {}, std::nullopt, progress);
    EXPECT_TRUE(calibration::is_usable(result)) << english(result.message);
    EXPECT_EQ(pairs[4].state, motion::PairState::Rejected);
    EXPECT_EQ(pairs[9].state, motion::PairState::Rejected);
    EXPECT_EQ(pairs[4].ins_b_from_ins_a.translation().x(), by_m) << "what was given is not changed";
    EXPECT_LT((result.mounting.reference_from_sensor.translation() - x.translation()).norm(), 1e-3);
  }
}

TEST(impossible_motion, leads_no_registration_and_no_compensation_astray) {
  cloud::PointCloud cloud;
  for (int i = 0; i < 60; ++i)
    for (int k = 0; k < 60; ++k) {
      cloud.points.emplace_back(0.3f * static_cast<float>(i), 0.3f * static_cast<float>(k), -1.5f);
      cloud.points.emplace_back(18.0f, 0.3f * static_cast<float>(i), 0.1f * static_cast<float>(k));
      cloud.points.emplace_back(0.3f * static_cast<float>(i), 18.0f, 0.1f * static_cast<float>(k));
    }
  registration::RegistrationOptions options;
  options.search_when_doubtful = true;
  const registration::PreparedCloud prepared(cloud, options);
  for (const double away_m : {2e3, 1e9, 1e10, 4e15, 1e38, 1e200, 1e308}) {
    RigidTransform start = RigidTransform::Identity();
    start.translation() = Eigen::Vector3d(away_m, -away_m, 0.0);
    Progress progress;
    EXPECT_FALSE(registration::align_scans(prepared, prepared, start, options, progress).quality.failure.empty())
        << away_m;
    const std::vector<float> times(cloud.size(), 0.05f);
    const cloud::PointCloud moved = cloud::deskew(cloud, times, [&](double) { return start; });
    EXPECT_TRUE(moved.points.empty()) << away_m;
    EXPECT_EQ(moved.dropped_points, cloud.size());
  }
}

TEST(impossible_motion, of_one_message_of_a_bag_is_left_out_and_named) {
  for (const double to_m : kBeyond_m) {
    const formats::TemporaryFolder folder;
    bags::BagMaker bag(folder.path() / "drive.bag");
    for (int i = 0; i < 60; ++i) {
      bags::MessageWriter writer(bags::kRos1);
      writer.header(bags::kStart_ns + i * bags::kStep_ns, "map").string("base");
      for (const double value : {i == 30 ? to_m : 0.5 * i, 0.1 * i, 0.0, 0.0, 0.0, 0.0, 1.0}) writer.number(value);
      for (int k = 0; k < 36 + 6 + 36; ++k) writer.number(0.0);
      bag.add(bags::kStart_ns + i * bags::kStep_ns, "/ins/odom", "nav_msgs/Odometry", writer.bytes());
    }
    bag.add_scans("/points", 20, 30);
    bag.finish();
    Progress progress;
    const drive::Session session = formats::open_session(folder.path() / "drive.bag", progress);
    EXPECT_EQ(session.world_from_ins.size(), 59u);
    std::string told;
    for (const drive::Finding& finding : session.findings)
      if (finding.code == "bad-messages") told = english(finding.explanation);
    EXPECT_TRUE(formats::contains(told, "1 message cannot be used and is left out")) << told;
    EXPECT_TRUE(formats::contains(told, "message 31: the position is beyond 1e9 m")) << told;
  }
}

}  // namespace
}  // namespace remount::conventions
