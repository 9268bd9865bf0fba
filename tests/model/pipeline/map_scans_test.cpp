#include <gtest/gtest.h>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "model/pipeline/pipeline.h"

namespace remount::pipeline {
namespace {

/// Scans whose points were measured one after the other; every third cannot be read.
class TwoPointScans : public drive::ScanSource {
 public:
  std::size_t size() const override { return 20; }
  std::int64_t stamp_ns(std::size_t scan) const override {
    return 1'000'000'000 + 100'000'000 * static_cast<std::int64_t>(scan);
  }
  std::string name(std::size_t scan) const override { return std::to_string(scan); }
  cloud::PointCloud load(std::size_t scan) const override {
    if (scan % 3 == 2) throw Error(ErrorCode::Io, name(scan), Message::verbatim("is damaged"));
    cloud::PointCloud cloud;
    cloud.points = {{10.0F, 0.0F, 0.0F}, {10.0F, 0.0F, 0.0F}};
    cloud.time_from_stamp_s = {0.0F, 0.05F};
    return cloud;
  }
};

class keyframe_scan : public ::testing::Test {
 protected:
  keyframe_scan() {
    auto session = std::make_shared<drive::Session>();
    for (int i = 0; i < 400; ++i)  // straight ahead at 10 m/s
      session->world_from_ins.push_back({10'000'000LL * i, rigid_from_six({0.1 * i, 0, 0, 0, 0, 0})});
    session->scans = std::make_shared<TwoPointScans>();
    session->scan_timing = drive::ScanTiming::PerPoint;
    input_.sessions = {session};
    for (int scan = 0; scan < 6; ++scan)
      output_.keyframes.push_back({motion::SessionIndex{0}, index_at<motion::ScanIndex>(scan),
                                   session->scans->stamp_ns(static_cast<std::size_t>(scan)), 0.0});
    output_.session_uses_sweep = {false};
  }
  PipelineInput input_;
  PipelineOutput output_;
  Progress progress_;
};

TEST_F(keyframe_scan, is_compensated_for_motion_as_the_calibration_did) {
  const cloud::PointCloud cloud = load_keyframe_scan(input_, output_, motion::KeyframeIndex{1}, progress_);
  ASSERT_EQ(cloud.size(), 2U);
  EXPECT_NEAR(cloud.points[0].x(), 10.0F, 1e-3F);
  EXPECT_NEAR(cloud.points[1].x(), 10.5F, 1e-3F) << "measured half a metre farther on";
  input_.settings.run.deskew = settings::DeskewMode::Off;
  EXPECT_NEAR(load_keyframe_scan(input_, output_, motion::KeyframeIndex{1}, progress_).points[1].x(), 10.0F, 1e-3F);
}

TEST_F(keyframe_scan, that_cannot_be_read_is_named) {
  try {
    load_keyframe_scan(input_, output_, motion::KeyframeIndex{2}, progress_);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(english(error.what_happened()), "is damaged");
  }
}

TEST_F(keyframe_scan, that_is_no_longer_wanted_is_not_read) {
  std::stop_source stop;
  stop.request_stop();
  Progress progress(stop.get_token(), {});
  EXPECT_EQ(load_keyframe_scan(input_, output_, motion::KeyframeIndex{2}, progress).size(), 0U)
      << "this one would fail";
}

TEST_F(keyframe_scan, of_lidar_poses_is_empty) {
  auto poses = std::make_shared<drive::Session>(*input_.sessions[0]);
  poses->scans.reset();
  input_.sessions = {poses};
  EXPECT_EQ(load_keyframe_scan(input_, output_, motion::KeyframeIndex{0}, progress_).size(), 0U);
}

}  // namespace
}  // namespace remount::pipeline
