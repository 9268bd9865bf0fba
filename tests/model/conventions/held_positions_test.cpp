// Positions that are held between the times at which they are measured.
#include "model/conventions/held_positions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "algorithms/messages/render.h"
#include "model/checks/data_check.h"
#include "model/drive/session_frames.h"
#include "model/formats/session_readers.h"
#include "model/formats/sessions/native_session_writer.h"
#include "model/simulator/drive_formats.h"
#include "tests/algorithms/support/random_motion.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/calibration_checks.h"

namespace remount::conventions {

using drive::Session;

namespace {

constexpr std::size_t kHeld = 10;  // samples of 100 a second

simulator::SimulatedDrive turning_drive(double duration_s, double noise) {
  simulator::SimulationOptions options;
  options.scenario = simulator::ScenarioKind::Street;
  options.duration_s = duration_s;
  options.beams = 1;
  options.azimuth_steps = 16;
  options.ins_position_noise_m *= noise;
  options.ins_attitude_noise_deg *= noise;
  return simulator::simulate_drive(options);
}

// The log begins in the midst of a hold.
std::size_t held_from(std::size_t i) { return i < 3 ? 0 : i - (i - 3) % kHeld; }

Session with_held_positions(Session session) {
  for (std::size_t i = session.ins.size(); i-- > 0;) {
    const motion::InsSample& from = session.ins[held_from(i)];
    session.ins[i].latitude_rad = from.latitude_rad;
    session.ins[i].longitude_rad = from.longitude_rad;
    session.ins[i].height_m = from.height_m;
  }
  for (std::size_t i = session.world_from_ins.size(); i-- > 0;)
    session.world_from_ins[i].pose.translation() = session.world_from_ins[held_from(i)].pose.translation();
  return session;
}

Session as_poses(Session session) {
  session.world_from_ins = drive::metric_poses(session);
  session.ins.clear();
  return session;
}

// Largest distance to where the vehicle was, in axes of the start.
double farthest_m(const Session& session, const Session& exact) {
  std::vector<motion::StampedPose> truth = drive::metric_poses(exact), poses = drive::metric_poses(session);
  double farthest = 0.0;
  std::size_t t = 0;
  const bool levelled_anew = !session.ins.empty();  // at the first sample that is left
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    while (truth[t].stamp_ns < poses[i].stamp_ns) ++t;
    const Eigen::Vector3d apart = poses[i].pose.translation() - truth[t].pose.translation();
    if (i == 0 && levelled_anew) shift = apart;
    farthest = std::max(farthest, (apart - shift).norm());
  }
  return farthest;
}

TEST(held_positions, lie_on_the_way_where_they_were_not_measured) {
  const Session exact = turning_drive(20.0, 0.0).session;
  for (const bool poses : {false, true}) {
    const Session whole = poses ? as_poses(exact) : exact;
    Session session = with_held_positions(whole);
    const double before_m = farthest_m(session, whole);
    interpolate_held_positions(session);
    const double after_m = farthest_m(session, whole);
    std::printf("  %s: off by %.3f m before, %.4f m after, %zu measured\n", poses ? "poses" : "samples", before_m,
                after_m, session.ins_fix_stamps_ns.size());
    EXPECT_GT(before_m, 0.4);
    EXPECT_LT(after_m, 0.005);
    EXPECT_NEAR(static_cast<double>(session.ins_fix_stamps_ns.size()), drive::metric_poses(whole).size() / 10.0, 2.0);
    ASSERT_EQ(session.findings.size(), 1U);
    EXPECT_NE(english(session.findings[0].explanation).find("stands still for 0.100 s at a time (10 samples)"),
              std::string::npos);
    Progress progress;
    for (const drive::Finding& finding : checks::data_findings(session, checks::LookAt::Streams, progress))
      EXPECT_NE(finding.code, "ins-position-held") << "they are no longer";
  }
}

TEST(held_positions, stay_where_the_vehicle_stands_and_are_not_told_behind_missing_samples) {
  simulator::SimulationOptions options;
  options.duration_s = 30.0;
  options.standstill_s = 10.0;
  options.beams = 1;
  options.azimuth_steps = 16;
  options.ins_position_noise_m = options.ins_attitude_noise_deg = 0.0;
  const Session exact = simulator::simulate_drive(options).session;
  Session session = with_held_positions(exact);
  // A second is lost, and single samples in which a position was new.
  const std::int64_t lost_ns = exact.ins[2000].stamp_ns;
  std::erase_if(session.ins, [&](const motion::InsSample& sample) {
    const double behind_s = 1e-9 * static_cast<double>(sample.stamp_ns - lost_ns);
    return (behind_s > 0.035 && behind_s < 1.0) || std::abs(behind_s + 2.97) < 1e-4;
  });
  interpolate_held_positions(session);
  std::printf("  off by %.4f m at most, %zu samples of %zu\n", farthest_m(session, exact), session.ins.size(),
              exact.ins.size());
  EXPECT_LT(farthest_m(session, exact), 0.01);
  EXPECT_GT(session.ins.size(), exact.ins.size() - 150);
}

TEST(held_positions, are_left_alone_where_samples_are_only_rounded_or_all_measured) {
  const Session exact = turning_drive(20.0, 0.0).session;
  Session rounded = exact, sound = exact, uneven = exact;
  for (motion::InsSample& sample : rounded.ins) {
    const double place = degrees_to_radians(1e-5);
    sample.latitude_rad = place * std::round(sample.latitude_rad / place);
    sample.longitude_rad = place * std::round(sample.longitude_rad / place);
  }
  std::mt19937_64 random(1);
  for (std::size_t i = 0, from = 0, until = 0; i < uneven.ins.size(); ++i) {
    if (i == until) from = i, until = i + 2 + random() % 30;
    uneven.ins[i].latitude_rad = exact.ins[from].latitude_rad;
    uneven.ins[i].longitude_rad = exact.ins[from].longitude_rad;
  }
  for (Session* session : {&rounded, &sound, &uneven}) {
    const double before = session->ins[777].latitude_rad;
    interpolate_held_positions(*session);
    EXPECT_TRUE(session->findings.empty() && session->ins_fix_stamps_ns.empty());
    EXPECT_EQ(session->ins.size(), exact.ins.size());
    EXPECT_EQ(session->ins[777].latitude_rad, before);
  }
}

TEST(held_positions, with_attitudes_that_are_held_alike_leave_the_measured_samples) {
  const Session exact = turning_drive(30.0, 0.0).session;
  Session session = with_held_positions(exact);
  for (std::size_t i = session.ins.size(); i-- > 0;) session.ins[i].enu_from_ins = exact.ins[held_from(i)].enu_from_ins;
  interpolate_held_positions(session);
  EXPECT_NEAR(static_cast<double>(session.ins.size()), static_cast<double>(exact.ins.size()) / 10.0, 2.0);
  EXPECT_TRUE(session.ins_fix_stamps_ns.empty()) << "all that are left were measured";
  EXPECT_LT(farthest_m(session, exact), 1e-4);
  ASSERT_EQ(session.findings.size(), 1U);
  EXPECT_EQ(english(session.findings[0].explanation).find("Position and attitude stand still for 0.100 s"), 0U);
}

TEST(held_positions, of_a_session_that_is_opened_leave_x_within_its_sigma) {
  const simulator::SimulatedDrive drive = turning_drive(60.0, 1.0);
  Session held = with_held_positions(drive.session);
  std::mt19937_64 random(7);
  std::vector<motion::StampedPose> odometry = simulator::exact_odometry(drive);
  for (motion::StampedPose& pose : odometry) pose.pose = perturb(pose.pose, testing::random_step(random, 0.003, 2e-4));
  const formats::TemporaryFolder folder;
  folder.write("ins.txt", formats::tum_text(drive::metric_poses(held)));
  folder.write("lidar.txt", formats::tum_text(odometry));
  Progress progress;
  for (const bool mended : {false, true}) {
    pipeline::PipelineInput input;
    Session session = formats::open_session(folder.path(), progress);
    if (!mended) {
      session.ins_fix_stamps_ns.clear();
      session.world_from_ins = drive::metric_poses(held);
    }
    input.sessions = {std::make_shared<Session>(std::move(session))};
    input.nominal_ins_from_lidar = drive.ins_from_lidar;
    const calibration::CalibrationResult result = pipeline::run_pipeline(input, progress).result;
    ASSERT_TRUE(calibration::is_usable(result)) << result.message;
    std::printf("  %s, x off by %.1f sigma: ", mended ? "interpolated" : "held",
                testing::normalised_errors(result, drive.ins_from_lidar)[0]);
    testing::error_of(result, drive.ins_from_lidar);
    if (mended) testing::expect_within_sigma(result, drive.ins_from_lidar, 3.5);
  }
}

}  // namespace
}  // namespace remount::conventions
