#include "model/pipeline/watched_scans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <set>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "model/methods/calibrate.h"
#include "model/simulator/simulator.h"
#include "tests/support/forwarded_scans.h"

namespace remount::pipeline {
namespace {

/// Every tenth scan cannot be read. Which of them somebody tried to is known.
class HalfRotten final : public testing::ForwardedScans {
 public:
  using ForwardedScans::ForwardedScans;
  cloud::PointCloud load(std::size_t scan) const override {
    if (scan % 10 != 3) return ForwardedScans::load(scan);
    const std::scoped_lock lock(mutex_);
    tried_.insert(scan);
    throw Error(ErrorCode::Format, place_of(scan), Message::verbatim("is no point cloud"));
  }
  static std::string place_of(std::size_t scan) { return "scan-" + std::to_string(scan) + ".pcd"; }
  const std::set<std::size_t>& tried() const { return tried_; }

 private:
  mutable std::mutex mutex_;
  mutable std::set<std::size_t> tried_;
};

struct RottenDrive {
  PipelineInput input;
  std::shared_ptr<HalfRotten> scans;
  RigidTransform ins_from_lidar;

  RottenDrive() {
    simulator::SimulationOptions options;
    options.duration_s = 5.0;
    options.beams = 16;
    options.azimuth_steps = 400;
    const simulator::SimulatedDrive drive = simulator::simulate_drive(options);
    ins_from_lidar = drive.ins_from_lidar;
    scans = std::make_shared<HalfRotten>(drive.session.scans);
    auto session = std::make_shared<drive::Session>(drive.session);
    session->scans = scans;
    input.sessions = {session};
    input.settings.keyframes.distance_m = 3.0;
    input.settings.keyframes.minimum = 2;
  }
  PipelineOutput calibrated() const {
    Progress progress;
    return methods::calibrate(input, progress);
  }
};

std::size_t times_named(const PipelineOutput& output, std::size_t scan) {
  return static_cast<std::size_t>(std::ranges::count_if(output.findings, [&](const drive::Finding& finding) {
    return finding.code == "scan-unreadable" &&
           english(finding.explanation) == "The scan is skipped: " + HalfRotten::place_of(scan) + ": is no point cloud";
  }));
}

TEST(watched_scans, each_that_a_calibration_opened_and_could_not_read_is_named_once_with_the_reason) {
  const RottenDrive drive;
  const PipelineOutput output = drive.calibrated();
  std::set<std::size_t> keyframes;
  for (const motion::Keyframe& keyframe : output.keyframes) keyframes.insert(keyframe.scan);
  ASSERT_FALSE(drive.scans->tried().empty());
  EXPECT_TRUE(std::ranges::any_of(drive.scans->tried(), [&](std::size_t scan) { return !keyframes.contains(scan); }))
      << "one that is no keyframe is tried for the first estimate of the mounting";
  for (const std::size_t scan : drive.scans->tried()) EXPECT_EQ(times_named(output, scan), 1U) << scan;
  std::cout << drive.scans->tried().size() << " scans of " << drive.scans->size() << " named, " << keyframes.size()
            << " keyframes\n";
}

TEST(watched_scans, of_those_that_were_never_opened_nothing_is_said) {
  RottenDrive drive;
  drive.input.nominal_ins_from_lidar = drive.ins_from_lidar;
  const PipelineOutput output = drive.calibrated();
  std::size_t unopened = 0;
  for (std::size_t scan = 3; scan < drive.scans->size(); scan += 10) {
    const bool tried = drive.scans->tried().contains(scan);
    EXPECT_EQ(times_named(output, scan), tried ? 1U : 0U) << scan;
    unopened += tried ? 0 : 1;
  }
  EXPECT_GT(unopened, 0U);
}

TEST(watched_scans, sessions_without_scans_are_as_they_were) {
  const auto poses = std::make_shared<const drive::Session>();
  const WatchedScans watched({poses});
  std::vector<drive::Finding> findings;
  watched.report(findings);
  EXPECT_EQ(watched.sessions().front(), poses);
  EXPECT_TRUE(findings.empty());
}

}  // namespace
}  // namespace remount::pipeline
