#include "model/pipeline/scan_gathering.h"

#include <gtest/gtest.h>

#include <cmath>

#include "model/results/deciding_notes.h"
#include "model/simulator/simulator.h"
#include "tests/support/kept_scans.h"

namespace remount::pipeline {
namespace {

using simulator::SimulationOptions;

SimulationOptions drive_with(const char* lidar) {
  SimulationOptions options;
  options.lidar.model = simulator::lidar_named(lidar);
  options.duration_s = 2.0;
  return options;
}

struct Chosen {
  int frames = 0;
  std::vector<drive::Finding> findings;
};

Chosen choose(const SimulationOptions& drive, const motion::KeyframeOptions& options = {}) {
  const DriveMotion motion({std::make_shared<const drive::Session>(testing::simulate_drive(drive).session)});
  Chosen chosen;
  chosen.frames = choose_gathering(motion, options, chosen.findings, {}).front();
  return chosen;
}

// Six lasers above each other fill most of the Avia's field in one scan.
TEST(scan_gathering, sensors_that_repeat_their_directions_keep_single_scans) {
  for (const int beams : {16, 64}) {
    SimulationOptions options;
    options.beams = beams;
    options.duration_s = 2.0;
    const Chosen chosen = choose(options);
    EXPECT_EQ(chosen.frames, 1) << beams << " beams";
    EXPECT_TRUE(chosen.findings.empty());
  }
  for (const char* lidar : {"e1", "avia"}) EXPECT_EQ(choose(drive_with(lidar)).frames, 1) << lidar;
}

TEST(scan_gathering, rosettes_and_panoramas_are_gathered_and_it_is_said_why) {
  for (const char* lidar : {"rosette", "mid-360"}) {
    const Chosen chosen = choose(drive_with(lidar));
    EXPECT_GE(chosen.frames, 2) << lidar;
    EXPECT_LE(chosen.frames, 3) << lidar << ": at most 0.3 s";
    ASSERT_EQ(chosen.findings.size(), 1U);
    EXPECT_EQ(chosen.findings.front().code, results::kScansGathered);
    std::printf("  %s: %s\n", lidar, english(chosen.findings.front().explanation).c_str());
  }
}

TEST(scan_gathering, is_as_it_is_set) {
  motion::KeyframeOptions options;
  options.gather = motion::Gathering::Off;
  const Chosen off = choose(drive_with("rosette"), options);
  EXPECT_EQ(off.frames, 1);
  EXPECT_TRUE(off.findings.empty());
  options.gather = motion::Gathering::Frames;
  options.gather_frames = 7;
  const Chosen seven = choose(drive_with("spinning"), options);
  EXPECT_EQ(seven.frames, 7);
  EXPECT_EQ(seven.findings.size(), 1U);
}

TEST(scan_gathering, one_scan_each_where_cancelled) {
  std::stop_source stop;
  stop.request_stop();
  const DriveMotion motion(
      {std::make_shared<const drive::Session>(testing::simulate_drive(drive_with("rosette")).session)});
  std::vector<drive::Finding> findings;
  EXPECT_EQ(choose_gathering(motion, {}, findings, Progress(stop.get_token())), std::vector<int>{1});
  EXPECT_TRUE(findings.empty());
}

/// Scans that are never read, with a pause of three seconds before the fifth.
class Paused : public drive::ScanSource {
 public:
  std::size_t size() const override { return 8; }
  std::int64_t stamp_ns(std::size_t scan) const override {
    return static_cast<std::int64_t>(scan) * 100'000'000 + (scan < 4 ? 0 : 3'000'000'000);
  }
  std::string name(std::size_t scan) const override { return std::to_string(scan); }
  cloud::PointCloud load(std::size_t) const override { return {}; }
};

TEST(scan_gathering, takes_no_scan_from_behind_a_pause_nor_beyond_the_drive) {
  const Paused scans;
  const auto around = [&](std::size_t scan, std::size_t count) {
    std::vector<std::size_t> numbers;
    const motion::Keyframe keyframe{motion::SessionIndex{0}, motion::ScanIndex(scan), scans.stamp_ns(scan), 0.0};
    for (const motion::ScanIndex at : gathered_scans(scans, keyframe, {count})) numbers.push_back(at);
    return numbers;
  };
  EXPECT_EQ(around(2, 5), (std::vector<std::size_t>{2, 0, 1, 3}));
  EXPECT_EQ(around(4, 3), (std::vector<std::size_t>{4, 5}));
  EXPECT_EQ(around(7, 4), (std::vector<std::size_t>{7, 6}));
  EXPECT_EQ(around(1, 1), (std::vector<std::size_t>{1}));
}

TEST(scan_gathering, the_drift_within_a_keyframe_is_an_error_of_its_pose) {
  drive::Session session = testing::simulate_drive(drive_with("rosette")).session;
  session.ins_position_drift = 0.02;
  session.ins_attitude_drift = 0.001;
  const DriveMotion motion({std::make_shared<const drive::Session>(session)});
  const std::vector<motion::Keyframe> keyframes{
      {motion::SessionIndex{0}, motion::ScanIndex{3}, session.scans->stamp_ns(3), 0.0}};
  std::vector<calibration::JointNode> nodes(1);
  add_drift_within_gathered(motion, keyframes, {1}, nodes);
  EXPECT_EQ(nodes[0].between_samples_covariance, Matrix6d::Zero());
  add_drift_within_gathered(motion, keyframes, {6}, nodes);
  EXPECT_NEAR(nodes[0].between_samples_covariance(0, 0), 0.02 * 0.02 * 0.6 / 12.0, 1e-9);
  EXPECT_NEAR(nodes[0].between_samples_covariance(5, 5), 0.001 * 0.001 * 0.6 / 12.0, 1e-12);
}

}  // namespace
}  // namespace remount::pipeline
