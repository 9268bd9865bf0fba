// How scans were swept, told by the scans: simulated drives whose truth is known.
#include "model/sweeps/sweep_trial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "model/methods/calibrate.h"
#include "model/simulator/simulator.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/draws.h"
#include "tests/support/findings.h"
#include "tests/support/forwarded_scans.h"
#include "tests/support/kept_scans.h"
#include "tests/support/sanitized.h"

namespace remount::sweeps {
namespace {

simulator::SimulationOptions swept_options(simulator::ScenarioKind scenario, bool clockwise, double rate_hz, int seed) {
  simulator::SimulationOptions options;
  options.scenario = scenario;
  options.clockwise = clockwise;
  options.scan_rate_hz = rate_hz;
  options.seed = seed;
  options.beams = 16;
  options.azimuth_steps = 360;
  options.duration_s = 16.0;
  options.per_point_time = false;
  options.ins_from_lidar = rigid_from_six({0.9, -0.25, 0.75, 0.03, -0.02, 0.015});
  return options;
}

/// As a bag without times of points has it.
drive::Session untold(const simulator::SimulatedDrive& drive) {
  drive::Session session = drive.session;
  session.scan_timing = drive::ScanTiming::Unknown;
  session.sweep = {};
  return session;
}

/// The points of each scan in no order.
class ShuffledScans final : public testing::ForwardedScans {
 public:
  using ForwardedScans::ForwardedScans;
  cloud::PointCloud load(std::size_t scan) const override {
    cloud::PointCloud shuffled;
    shuffled.points = ForwardedScans::load(scan).points;
    std::shuffle(shuffled.points.begin(), shuffled.points.end(), std::mt19937(static_cast<unsigned>(scan)));
    return shuffled;
  }
};

/// A sensor that looks ahead and stands before the same scene all the time.
class StandingScans final : public testing::ForwardedScans {
 public:
  explicit StandingScans(std::shared_ptr<const ScanSource> scans) : ForwardedScans(std::move(scans)) {
    for (const Eigen::Vector3f& point : ForwardedScans::load(0).points)
      if (point.x() > std::abs(point.y())) ahead_.points.push_back(point);
  }
  cloud::PointCloud load(std::size_t) const override { return ahead_; }

 private:
  cloud::PointCloud ahead_;
};

/// Times of points as somebody else writes them.
class RetimedScans final : public testing::ForwardedScans {
 public:
  RetimedScans(std::shared_ptr<const ScanSource> scans, float factor, float shift_s)
      : ForwardedScans(std::move(scans)), factor_(factor), shift_s_(shift_s) {}
  cloud::PointCloud load(std::size_t scan) const override {
    cloud::PointCloud cloud = ForwardedScans::load(scan);
    for (float& time_s : cloud.time_from_stamp_s) time_s = factor_ * time_s + shift_s_;
    return cloud;
  }

 private:
  float factor_, shift_s_;
};

void expect_sweep(const SweepTrial& trial, bool clockwise, double rate_hz, const std::string& what) {
  ASSERT_TRUE(trial.best) << what;
  EXPECT_TRUE(trial.proved) << what;
  EXPECT_EQ(trial.best->clockwise, clockwise) << what;
  EXPECT_NEAR(trial.best->period_s, 1.0 / rate_hz, 0.01 / rate_hz) << what;
  std::printf("  %s: %s, begins at %.1f deg, gain %.0f %%\n", what.c_str(), trial.best->clockwise ? "cw" : "ccw",
              radians_to_degrees(wrap_angle_rad(trial.best->stamp_azimuth_rad - kPi)), 100.0 * trial.gain);
}

TEST(sweep_trial, the_order_of_points_tells_where_a_sweep_begins_and_which_way_it_turns) {
  for (const bool clockwise : {true, false}) {
    const simulator::SimulatedDrive drive =
        testing::simulate_drive(swept_options(simulator::ScenarioKind::Street, clockwise, 10.0, 4));
    const cloud::PointCloud cloud = drive.session.scans->load(20);
    const auto order = cloud::sweep_order(cloud);
    ASSERT_TRUE(order);
    EXPECT_EQ(order->clockwise, clockwise);
    EXPECT_LT(std::abs(wrap_angle_rad(order->first_azimuth_rad - kPi)), 0.15) << "it begins behind";
    EXPECT_TRUE(cloud::looks_around(cloud));
    EXPECT_FALSE(cloud::sweep_order(ShuffledScans(drive.session.scans).load(20)));
  }
  cloud::PointCloud ahead;
  for (int i = 0; i < 2000; ++i) ahead.points.emplace_back(10.0f, 0.01f * static_cast<float>(i % 500 - 250), 0.5f);
  EXPECT_FALSE(cloud::sweep_order(ahead));
  EXPECT_FALSE(cloud::looks_around(ahead));
}

TEST(sweep_trial, proves_the_direction_of_scans_without_times) {
  const settings::Settings settings;
  Progress progress;
  struct Sweep {
    bool clockwise;
    double rate_hz;
  };
  for (const auto [clockwise, rate_hz] :
       testing::some_of<Sweep>({{false, 5.0}, {true, 5.0}, {false, 10.0}, {true, 10.0}})) {
    const simulator::SimulatedDrive drive = testing::simulate_drive(
        swept_options(simulator::ScenarioKind::FigureEight, clockwise, rate_hz, clockwise ? 11 : 12));
    expect_sweep(try_sweeps(untold(drive), settings, 0, progress), clockwise, rate_hz,
                 std::string(clockwise ? "cw" : "ccw") + " at " + std::to_string(static_cast<int>(rate_hz)) + " Hz");
  }
}

TEST(sweep_trial, finds_where_a_sweep_begins_for_points_in_any_order) {
  ONLY_IN_LONG_TESTS();
  if (testing::kSanitized) GTEST_SKIP() << "many alignments";
  const settings::Settings settings;
  Progress progress;
  simulator::SimulatedDrive drive =
      testing::simulate_drive(swept_options(simulator::ScenarioKind::FigureEight, false, 10.0, 13));
  drive.session.scans = std::make_shared<const ShuffledScans>(drive.session.scans);
  const SweepTrial trial = try_sweeps(untold(drive), settings, 0, progress);
  expect_sweep(trial, false, 10.0, "in no order");
  EXPECT_LT(std::abs(wrap_angle_rad(trial.best->stamp_azimuth_rad)), 0.25);
}

TEST(sweep_trial, leaves_scans_alone_that_are_compensated) {
  const settings::Settings settings;
  Progress progress;
  simulator::SimulationOptions options = swept_options(simulator::ScenarioKind::FigureEight, true, 10.0, 14);
  options.motion_distortion = false;
  const simulator::SimulatedDrive drive = testing::simulate_drive(options);
  const SweepTrial trial = try_sweeps(untold(drive), settings, 0, progress);
  EXPECT_FALSE(trial.best);
  EXPECT_TRUE(trial.proved);
  std::printf("  compensated: gain %.0f %%\n", 100.0 * trial.gain);
}

TEST(sweep_trial, corrects_a_direction_that_the_format_assumes) {
  const settings::Settings settings;
  Progress progress;
  const simulator::SimulatedDrive drive =
      testing::simulate_drive(swept_options(simulator::ScenarioKind::Street, true, 10.0, 15));
  for (const bool certain : testing::some_of({false, true})) {
    drive::Session session = drive.session;
    session.sweep.clockwise = false;
    session.sweep.direction_known = false;
    session.sweep.certain = certain;
    ASSERT_TRUE(needs_sweep_trial(session, settings::DeskewMode::Auto));
    expect_sweep(try_sweeps(session, settings, 0, progress), true, 10.0, certain ? "surely swept" : "perhaps swept");
  }
  EXPECT_FALSE(needs_sweep_trial(drive.session, settings::DeskewMode::Auto)) << "declared";
  EXPECT_FALSE(needs_sweep_trial(untold(drive), settings::DeskewMode::Off));
}

TEST(sweep_trial, of_a_vehicle_that_stands_nothing_is_proved) {
  const settings::Settings settings;
  Progress progress;
  simulator::SimulationOptions options = swept_options(simulator::ScenarioKind::Street, true, 10.0, 16);
  options.duration_s = 8.0;
  options.standstill_s = 8.0;
  EXPECT_FALSE(try_sweeps(untold(testing::simulate_drive(options)), settings, 0, progress).proved);
}

const drive::Finding* found(const pipeline::PipelineOutput& output, const std::string& code) {
  return testing::finding_of(output.findings, code);
}

pipeline::PipelineOutput calibrated(drive::Session session) {
  pipeline::PipelineInput input;
  input.sessions.push_back(std::make_shared<const drive::Session>(std::move(session)));
  input.settings.run.map_check = false;
  Progress progress;
  return methods::calibrate(input, progress);
}

/// Stamps at the end of the sweep, as several drivers have them.
TEST(sweep_trial, a_drive_without_times_of_points_is_calibrated_within_its_sigma) {
  for (const bool clockwise : testing::some_of({true, false})) {
    simulator::SimulationOptions options =
        swept_options(simulator::ScenarioKind::FigureEight, clockwise, 10.0, clockwise ? 21 : 22);
    options.duration_s = 24.0;
    options.lidar_clock_offset_s = -0.05;
    const simulator::SimulatedDrive drive = testing::simulate_drive(options);
    const pipeline::PipelineOutput output = calibrated(untold(drive));
    testing::error_of(output.result, drive.ins_from_lidar);
    testing::expect_within_sigma(output.result, drive.ins_from_lidar, 4.0);
    EXPECT_TRUE(output.clock_told);
    EXPECT_NEAR(output.result.time_offset.offset_s, -0.05, 0.004) << "of sweeps that are compensated";
    EXPECT_TRUE(found(output, "deskew-on"));
  }
}

/// The age of points at a stamp at the end of the sweep.
TEST(sweep_trial, times_that_count_backwards_are_turned_round_where_the_scans_prove_it) {
  simulator::SimulationOptions options = swept_options(simulator::ScenarioKind::FigureEight, true, 10.0, 24);
  options.duration_s = 24.0;
  options.per_point_time = true;
  const simulator::SimulatedDrive drive = testing::simulate_drive(options);
  drive::Session session = drive.session;
  EXPECT_FALSE(needs_sweep_trial(session, settings::DeskewMode::Auto));
  session.scans = std::make_shared<const RetimedScans>(drive.session.scans, -1.0f, 0.0f);
  session.times_count = drive::TimesCount::Open;
  const pipeline::PipelineOutput output = calibrated(session);
  testing::error_of(output.result, drive.ins_from_lidar);
  testing::expect_within_sigma(output.result, drive.ins_from_lidar, 4.0);
  EXPECT_TRUE(found(output, "point-times-backwards"));

  if (!testing::draws_all()) return;
  session.scans = drive.session.scans;  // a suspicion that is unfounded
  const pipeline::PipelineOutput right = calibrated(session);
  testing::expect_within_sigma(right.result, drive.ins_from_lidar, 4.0);
  EXPECT_TRUE(right.clock_told);
  EXPECT_FALSE(found(right, "point-times-backwards"));
  EXPECT_FALSE(found(right, "sweep-open"));
}

TEST(sweep_trial, no_clock_is_told_from_scans_that_may_be_bent) {
  simulator::SimulationOptions options = swept_options(simulator::ScenarioKind::Street, true, 10.0, 23);
  options.lidar_clock_offset_s = -0.05;
  drive::Session session = testing::simulate_drive(options).session;
  pipeline::PipelineInput input;
  input.settings.run.deskew = settings::DeskewMode::Off;
  input.settings.run.map_check = false;
  input.settings.pairing.max_partners = 4;
  Progress progress;
  for (const drive::ScanTiming timing :
       testing::some_of({drive::ScanTiming::Unknown, drive::ScanTiming::SweepAzimuth})) {
    session.scan_timing = timing;
    input.sessions = {std::make_shared<const drive::Session>(session)};
    const pipeline::PipelineOutput output = methods::calibrate(input, progress);
    EXPECT_FALSE(output.clock_told);
    EXPECT_FALSE(std::isfinite(output.result.time_offset.offset_s));
    EXPECT_FALSE(output.result.time_offset.applied);
    EXPECT_FALSE(found(output, "clock-offset"));
  }
}

TEST(sweep_trial, proves_nothing_where_every_length_of_a_sweep_fits_alike) {
  const simulator::SimulatedDrive drive =
      testing::simulate_drive(swept_options(simulator::ScenarioKind::FigureEight, true, 5.0, 8));
  drive::Session session = untold(drive);
  session.scans = std::make_shared<StandingScans>(drive.session.scans);
  settings::Settings settings;
  settings.run.deskew = settings::DeskewMode::On;
  Progress progress;
  const SweepTrial trial = try_sweeps(session, settings, 0, progress);
  EXPECT_FALSE(trial.proved);
  EXPECT_FALSE(trial.others.empty()) << "0.2 s and 0.1 s for a sweep";
  EXPECT_LT(trial.gain, 0.02);
}

}  // namespace
}  // namespace remount::sweeps
