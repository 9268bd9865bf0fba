// The mounting from the multi-sensor odometry, where scans do not tell all of the motion.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iostream>

#include "algorithms/messages/render.h"
#include "model/method_registry/calibration_method.h"
#include "model/pipeline/pipeline.h"
#include "model/project/project.h"
#include "model/results/deciding_notes.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/draws.h"
#include "tests/support/findings.h"
#include "tests/support/kept_scans.h"
#include "tests/support/tunnel_drive.h"

namespace remount::methods {
namespace {

/// The middle of a drive.
class MiddleScans : public drive::ScanSource {
 public:
  MiddleScans(std::shared_ptr<const ScanSource> scans, std::size_t first, std::size_t count)
      : scans_(std::move(scans)), first_(first), count_(count) {}
  std::size_t size() const override { return count_; }
  std::int64_t stamp_ns(std::size_t scan) const override { return scans_->stamp_ns(first_ + scan); }
  std::string name(std::size_t scan) const override { return scans_->name(first_ + scan); }
  cloud::PointCloud load(std::size_t scan) const override { return scans_->load(first_ + scan); }

 private:
  std::shared_ptr<const ScanSource> scans_;
  std::size_t first_, count_;
};

/// Featureless throughout: cabinets hang on the walls for 60 m from either end.
struct InsideTunnel {
  pipeline::PipelineInput input;
  RigidTransform truth;
};
InsideTunnel inside_tunnel(double length_m, int seed, int azimuth_steps = 480) {
  constexpr double kOutside_m = 140.0;
  simulator::SimulationOptions options = testing::tunnel_options(length_m + 2.0 * kOutside_m);
  options.seed = seed;
  options.beams = 16;
  options.azimuth_steps = azimuth_steps;
  options.standstill_s = 0.0;
  const simulator::SimulatedDrive drive = testing::simulate_drive(options);
  auto session = std::make_shared<drive::Session>(drive.session);
  const double share = kOutside_m / (length_m + 2.0 * kOutside_m);
  const auto scans = static_cast<double>(session->scans->size());
  session->scans = std::make_shared<MiddleScans>(session->scans, static_cast<std::size_t>(share * scans),
                                                 static_cast<std::size_t>((1.0 - 2.0 * share) * scans));
  InsideTunnel tunnel{{}, drive.ins_from_lidar};
  tunnel.input.sessions.push_back(session);
  tunnel.input.nominal_ins_from_lidar = drive.ins_from_lidar;
  tunnel.input.settings = testing::settings_of(drive);
  return tunnel;
}

RigidTransform off_by(const RigidTransform& truth) {
  return truth * make_rigid(rotation_from_yaw_pitch_roll({degrees_to_radians(2.0), degrees_to_radians(-1.0), 0.01}),
                            Eigen::Vector3d(0.2, -0.15, 0.1));
}

pipeline::PipelineOutput run_fusion(const pipeline::PipelineInput& input) {
  Progress progress;
  return method_registry::calibration_method("fusion-odometry").run(input, progress);
}

std::string all_words(const calibration::CalibrationResult& result) {
  std::string words = english(result.message);
  for (const std::string& advice : english(result.advice)) words += " " + advice;
  return words;
}

void print(const calibration::CalibrationResult& result, const RigidTransform& truth) {
  testing::error_of(result, truth);
  const std::array<double, 6> normalised = testing::normalised_errors(result, truth);
  for (std::size_t i = 0; i < 6; ++i)
    if (const auto sigma = result.estimate(calibration::kParameters[i]).sigma)
      std::cout << "    " << to_string(calibration::kParameters[i]) << ": sigma "
                << (i < 3 ? *sigma : radians_to_degrees(*sigma)) << ", " << normalised[i] << " of them off\n";
  std::cout << "    " << english(result.message) << "\n";
}

TEST(fusion_method, a_tunnel_gives_what_its_walls_show_and_no_more) {
  for (const int seed : testing::some_of({1, 2})) {
    InsideTunnel tunnel = inside_tunnel(testing::draws_all() ? 400.0 : 250.0, seed);
    tunnel.input.nominal_ins_from_lidar = off_by(tunnel.truth);
    const pipeline::PipelineOutput output = run_fusion(tunnel.input);
    print(output.result, tunnel.truth);
    ASSERT_TRUE(calibration::is_usable(output.result)) << english(output.result.message);
    EXPECT_TRUE(output.result.known[calibration::Parameter::Yaw].observed &&
                output.result.known[calibration::Parameter::Pitch].observed)
        << "the walls show yaw and pitch";
    EXPECT_FALSE(output.result.known[calibration::Parameter::Y].observed)
        << "it shows in how much farther the LiDAR travels in bends";
    testing::expect_within_sigma(output.result, tunnel.truth, 3.5);
    EXPECT_TRUE(testing::has_code(output.findings, results::kOdometryByWheels));
    EXPECT_FALSE(testing::has_code(output.findings, "odometry-breaks"));
    EXPECT_EQ(all_words(output.result).find("pairing"), std::string::npos) << all_words(output.result);
  }
}

// What decides is read where the result is, not in the log.
TEST(fusion_method, the_result_file_says_that_it_rests_on_wheels) {
  const InsideTunnel tunnel = inside_tunnel(100.0, 1);
  const pipeline::PipelineOutput output = run_fusion(tunnel.input);
  const results::ResultFile file = project::make_result_file(tunnel.input, output, {});
  EXPECT_TRUE(testing::has_code(file.findings, results::kOdometryByWheels));
}

TEST(fusion_method, without_sensors_or_nominal_a_tunnel_is_refused_with_the_real_reason) {
  InsideTunnel tunnel = inside_tunnel(100.0, 1);
  const auto refused = [&](const pipeline::PipelineInput& input) {
    const pipeline::PipelineOutput output = run_fusion(input);
    const calibration::CalibrationResult& result = output.result;
    EXPECT_EQ(result.status, calibration::Status::TooFewPairs);
    EXPECT_NE(english(result.message).find("do not tell of every direction"), std::string::npos)
        << english(result.message);
    EXPECT_EQ(all_words(result).find("pairing"), std::string::npos) << all_words(result);
    EXPECT_NE(all_words(result).find("wheel speeds"), std::string::npos) << all_words(result);
    return output;
  };
  pipeline::PipelineInput unknown = tunnel.input;
  unknown.nominal_ins_from_lidar.reset();
  // There are wheels and an IMU: why they are not used is said, not that there is nothing.
  const pipeline::PipelineOutput unused = refused(unknown);
  const std::string said = testing::said_of(unused.findings, "odometry-breaks");
  std::printf("  %s\n", said.c_str());
  EXPECT_NE(said.find("no nominal is given"), std::string::npos) << said;
  EXPECT_NE(all_words(unused.result).find("were not used"), std::string::npos) << all_words(unused.result);
  pipeline::PipelineInput blind = tunnel.input;
  auto session = std::make_shared<drive::Session>(*blind.sessions[0]);
  session->wheels.clear();
  session->imu.clear();
  session->barometer.clear();
  blind.sessions = {session};
  refused(blind);
}

// Where the INS sits on the vehicle is often not set: what wheels say of the LiDAR is then wrong, and must not count.
TEST(fusion_method, a_vehicle_that_is_described_wrongly_does_not_bend_the_mounting) {
  ONLY_IN_LONG_TESTS();
  InsideTunnel tunnel = inside_tunnel(300.0, 3);
  odometry::FusionOptions& fusion = tunnel.input.settings.fusion;
  fusion.ins_yaw_deg += 1.0;
  fusion.ins_pitch_deg -= 0.7;
  fusion.ins_x_m += 0.5;
  const pipeline::PipelineOutput output = run_fusion(tunnel.input);
  print(output.result, tunnel.truth);
  ASSERT_TRUE(calibration::is_usable(output.result)) << english(output.result.message);
  testing::expect_within_sigma(output.result, tunnel.truth, 3.5);
}

/// Changes the option of a number, to something that the drive can feel.
class ChangeOption {
 public:
  explicit ChangeOption(int number) : number_(number) {}
  void operator()(const OptionInfo& info, bool& value) {
    if (is_it(info)) value = !value;
  }
  void operator()(const OptionInfo& info, int& value) {
    if (is_it(info)) value = std::max(static_cast<int>(info.minimum), value / 6);
  }
  void operator()(const OptionInfo& info, double& value) {
    if (!is_it(info)) return;
    const double other = value == 0.0 ? std::min(info.maximum, 0.3) : std::max(info.minimum, 0.4 * value);
    value = other != value ? other : std::min(info.maximum, 2.0 * value);
  }
  const std::string& name() const { return name_; }

 private:
  bool is_it(const OptionInfo& info) {
    if (count_++ != number_) return false;
    name_ = info.name;
    return true;
  }
  int number_, count_ = 0;
  std::string name_;
};

// All that the method tells.
std::vector<double> told_numbers(const pipeline::PipelineOutput& output) {
  std::vector<double> numbers;
  for (const calibration::Plot& plot : output.plots)
    for (const calibration::Curve& curve : plot.curves)
      for (const std::vector<double>* values : {&curve.x, &curve.y, &curve.z, &curve.sigma})
        numbers.insert(numbers.end(), values->begin(), values->end());
  return numbers;
}

TEST(fusion_method, every_option_has_an_effect) {
  constexpr int kFewAzimuths = 200;  // many runs, and none is asked how well it does
  const InsideTunnel tunnel = inside_tunnel(20.0, 1, kFewAzimuths);
  const auto told_by = [&](const settings::Settings& settings, bool gyroscope) {
    pipeline::PipelineInput input = tunnel.input;
    input.settings = settings;
    if (!gyroscope) {
      auto session = std::make_shared<drive::Session>(*input.sessions[0]);
      session->imu.clear();
      input.sessions = {session};
    }
    return told_numbers(run_fusion(input));
  };
  const std::vector<double> usual = told_by(tunnel.input.settings, true);
  int changed = 0;
  for (int number = 0;; ++number) {
    settings::Settings base = tunnel.input.settings, settings = base;
    ChangeOption change(number);
    odometry::FusionOptions::visit(settings.fusion, change);
    if (change.name().empty()) break;
    // Of two that do the same the other must not do it; without a gyroscope the wheels say the turn.
    if (change.name() == "map_step_deg") base.fusion.map_step_m = settings.fusion.map_step_m = 10.0;
    if (change.name() == "map_step_m") settings.fusion.map_step_m = 4.0;
    if (change.name() == "map_step_deg") settings.fusion.map_step_deg = 0.01;
    if (change.name() == "min_range_m") settings.fusion.min_range_m = 6.0;
    if (change.name() == "max_range_m") settings.fusion.max_range_m = 15.0;
    if (change.name() == "most_lines") settings.fusion.most_lines = 10;
    const bool gyroscope = change.name() != "track_width_m";
    const bool as_it_is = gyroscope && change.name() != "map_step_deg";
    EXPECT_NE(as_it_is ? usual : told_by(base, gyroscope), told_by(settings, gyroscope)) << change.name();
    ++changed;
  }
  std::cout << "    " << changed << " options\n";
  EXPECT_GT(changed, 40);
}

}  // namespace
}  // namespace remount::methods
