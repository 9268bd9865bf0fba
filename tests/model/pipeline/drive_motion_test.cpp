#include "model/pipeline/drive_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "algorithms/core/error.h"
#include "model/pipeline/scan_times.h"

namespace remount::pipeline {
namespace {

constexpr std::int64_t kStart_ns = 1'700'000'000'000'000'000;

std::int64_t at_ns(double time_s) { return kStart_ns + static_cast<std::int64_t>(std::llround(time_s * 1e9)); }

RigidTransform on_curve(double time_s) {
  return rigid_from_six({8.0 * time_s, 3.0 * std::sin(0.7 * time_s), 0.2 * std::sin(0.5 * time_s),
                         0.3 * std::cos(0.7 * time_s), 0.02 * std::sin(0.9 * time_s), 0.01 * std::cos(time_s)});
}

/// 20 s at 100 Hz, with white noise on every sample; the lidar's odometry has a pose every 0.1 s.
std::shared_ptr<drive::Session> driven_session(double position_sigma_m = 0.0, double attitude_sigma_rad = 0.0) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  const auto vector = [&](double sigma) -> Eigen::Vector3d {
    return sigma * Eigen::Vector3d(normal(random), normal(random), normal(random));
  };
  auto session = std::make_shared<drive::Session>();
  session->name = "drive";
  for (int i = 0; i <= 2000; ++i) {
    RigidTransform pose = on_curve(0.01 * i);
    pose.translation() += vector(position_sigma_m);
    pose.linear() *= so3_exp(vector(attitude_sigma_rad));
    session->world_from_ins.push_back({at_ns(0.01 * i), pose});
  }
  for (int i = 0; i <= 200; ++i) session->odometry_from_lidar.push_back({at_ns(0.1 * i), RigidTransform::Identity()});
  return session;
}

/// A scan that begins at its stamp and takes 0.1 s.
class SweptScan final : public drive::ScanSource {
 public:
  explicit SweptScan(float latest_s) : latest_s_(latest_s) {}
  std::size_t size() const override { return 3; }
  std::int64_t stamp_ns(std::size_t scan) const override { return at_ns(5.0 + 0.1 * static_cast<double>(scan)); }
  std::string name(std::size_t) const override { return "scan"; }
  cloud::PointCloud load(std::size_t) const override {
    cloud::PointCloud cloud;
    for (int i = 0; i <= 100; ++i) {
      cloud.points.emplace_back(10.0f, 0.1f * static_cast<float>(i), 0.0f);
      cloud.time_from_stamp_s.push_back(0.01f * latest_s_ * static_cast<float>(i));
    }
    cloud.time_from_stamp_s[50] = std::numeric_limits<float>::quiet_NaN();
    return cloud;
  }

 private:
  float latest_s_;
};

/// Root mean square over the drive of the errors of local_from_ins: position in m, attitude in rad, each per axis.
std::pair<double, double> rms_error(const DriveMotion& motion) {
  double position2 = 0.0, attitude2 = 0.0;
  int count = 0;
  for (double t = 0.5; t < 19.5; t += 0.0731, ++count) {
    const RigidTransform pose = *motion.local_from_ins(motion::SessionIndex{0}, at_ns(t));
    position2 += (pose.translation() - on_curve(t).translation()).squaredNorm() / 3.0;
    attitude2 += so3_log(on_curve(t).linear().transpose() * pose.linear()).squaredNorm() / 3.0;
  }
  return {std::sqrt(position2 / count), std::sqrt(attitude2 / count)};
}

TEST(drive_motion, poses_follow_the_ins_between_its_samples) {
  const DriveMotion motion({driven_session()});
  const auto [position_m, attitude_rad] = rms_error(motion);
  EXPECT_LT(position_m, 1e-5);
  EXPECT_LT(attitude_rad, 1e-5);
  EXPECT_FALSE(motion.local_from_ins(motion::SessionIndex{0}, at_ns(-0.1)));
  EXPECT_FALSE(motion.local_from_ins(motion::SessionIndex{0}, at_ns(20.1)));
}

TEST(drive_motion, noise_of_samples_is_averaged_and_the_noise_model_told_so) {
  constexpr double kPosition_m = 0.02, kAttitude_rad = 1e-3;
  const auto noisy = driven_session(kPosition_m, kAttitude_rad);
  noisy->ins_position_white_sigma_m = kPosition_m;
  noisy->ins_attitude_white_sigma_rad = kAttitude_rad;
  const DriveMotion motion({noisy});
  const auto [position_m, attitude_rad] = rms_error(motion);
  EXPECT_LT(position_m, 0.5 * kPosition_m);
  EXPECT_LT(attitude_rad, 0.5 * kAttitude_rad);
  const calibration::SessionNoise said = motion.noise().at(0);
  EXPECT_NEAR(position_m / said.position_white_sigma_m, 1.0, 0.2);
  EXPECT_NEAR(attitude_rad / said.attitude_white_sigma_rad, 1.0, 0.2);
  EXPECT_TRUE(std::isnan(said.attitude_bias_sigma_rad)) << "what the data do not state stays open";
}

TEST(drive_motion, the_noise_is_least_in_the_middle_of_a_scan) {
  const auto session = driven_session(0.005, 3.5e-4);
  session->scans = std::make_shared<SweptScan>(0.1f);
  session->scan_timing = drive::ScanTiming::PerPoint;
  const std::vector<motion::Sweep> swept = swept_times({session}, settings::DeskewMode::Auto);
  EXPECT_NEAR(swept.at(0).middle_s(), 0.05, 1e-6);
  const DriveMotion motion({session}, swept);
  double sum = 0.0, about_stamps = 0.0;
  for (double t = 0.5; t < 19.5; t += 0.0731) {
    const auto off2 = [&](const motion::Passage& passage) {
      return (passage.at(0.1)->translation() - on_curve(t + 0.1).translation()).squaredNorm();
    };
    sum += off2(*motion.passage(motion::SessionIndex{0}, at_ns(t)));
    about_stamps += off2(*motion.track(motion::SessionIndex{0}).around(at_ns(t)));
  }
  EXPECT_LT(std::sqrt(sum / about_stamps), 0.7);
}

TEST(drive_motion, times_that_no_scan_can_take_are_none) {
  const auto session = driven_session();
  session->scan_timing = drive::ScanTiming::PerPoint;
  for (const float latest_s : {0.25f, 1e9f, std::numeric_limits<float>::infinity()}) {
    session->scans = std::make_shared<SweptScan>(latest_s);
    EXPECT_EQ(swept_times({session}, settings::DeskewMode::Auto).at(0).length_s(), 0.0) << latest_s;
  }
  session->scans = std::make_shared<SweptScan>(0.1f);
  EXPECT_EQ(swept_times({session}, settings::DeskewMode::Off).at(0).length_s(), 0.0);
}

TEST(drive_motion, the_clock_offset_moves_the_lidar_along_the_trajectory) {
  DriveMotion motion({driven_session()});
  motion.set_offset_s(motion::SessionIndex{0}, 0.25);
  const RigidTransform pose = *motion.local_from_ins(motion::SessionIndex{0}, at_ns(3.0));
  EXPECT_LT((pose.translation() - on_curve(3.25).translation()).norm(), 1e-5);
  EXPECT_FALSE(motion.local_from_ins(motion::SessionIndex{0}, at_ns(19.9)));
}

TEST(drive_motion, nodes_carry_pose_time_and_velocity_and_stay_where_the_offset_leaves_the_data) {
  DriveMotion motion({driven_session()});
  motion.set_offset_s(motion::SessionIndex{0}, 0.25);
  const std::vector<calibration::JointNode> nodes =
      motion.nodes({{motion::SessionIndex{0}, motion::ScanIndex{50}, at_ns(5.0), 0.0},
                    {motion::SessionIndex{0}, motion::ScanIndex{199}, at_ns(19.9), 0.0}});
  ASSERT_EQ(nodes.size(), 2U);
  EXPECT_NEAR(nodes[0].time_s, 5.0, 1e-9);
  EXPECT_LT((nodes[0].local_from_ins.translation() - on_curve(5.25).translation()).norm(), 1e-5);
  const RigidTransform step = on_curve(5.25).inverse() * on_curve(5.251);
  EXPECT_LT((nodes[0].body_velocity.head<3>() - step.translation() * 1000.0).norm(), 0.02);
  EXPECT_LT((nodes[1].local_from_ins.translation() - on_curve(19.9).translation()).norm(), 1e-5);
  EXPECT_TRUE(nodes[1].body_velocity.isZero(0.0));
}

TEST(drive_motion, geodetic_samples_become_metres) {
  auto session = std::make_shared<drive::Session>();
  for (int i = 0; i <= 100; ++i) {
    motion::InsSample sample;
    sample.stamp_ns = at_ns(0.01 * i);
    sample.latitude_rad = degrees_to_radians(48.0) + 0.1 * i / 6'362'000.0;  // northwards, 10 m in all
    sample.longitude_rad = degrees_to_radians(9.0);
    session->ins.push_back(sample);
  }
  const DriveMotion motion({session});
  const double travelled_m = (motion.local_from_ins(motion::SessionIndex{0}, at_ns(1.0))->translation() -
                              motion.local_from_ins(motion::SessionIndex{0}, at_ns(0.0))->translation())
                                 .norm();
  EXPECT_NEAR(travelled_m, 10.0, 0.02);
}

TEST(drive_motion, a_session_without_ins_is_refused_with_its_path) {
  auto session = std::make_shared<drive::Session>();
  session->path = "/data/drive7";
  try {
    const DriveMotion motion({session});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "/data/drive7");
  }
}

TEST(drive_motion, no_pair_spans_a_break_of_the_odometry) {
  const auto session = driven_session();
  session->odometry_breaks_ns = {at_ns(0.5)};
  const DriveMotion motion({session});
  std::vector<motion::Keyframe> keyframes;
  std::vector<motion::Pair> pairs;
  for (int i = 0; i < 4; ++i) {
    motion::Keyframe keyframe;
    keyframe.session = motion::SessionIndex{0};
    keyframe.stamp_ns = at_ns(0.25 * i);
    keyframes.push_back(keyframe);
    if (i == 0) continue;
    motion::Pair pair;
    pair.keyframe_a = index_at<motion::KeyframeIndex>(i - 1);
    pair.keyframe_b = index_at<motion::KeyframeIndex>(i);
    pairs.push_back(pair);
  }
  keep_independent_odometry(motion, keyframes, pairs);
  ASSERT_EQ(pairs.size(), 2u);  // the motion to the pose at 0.5 s is a guess; that from it is not
  EXPECT_EQ(pairs[0].keyframe_a, motion::KeyframeIndex{0});
  EXPECT_EQ(pairs[1].keyframe_a, motion::KeyframeIndex{2});
}

// A motion that wheels filled in through an assumed mounting would confirm it.
TEST(drive_motion, what_the_lidar_did_not_tell_of_its_motion_is_no_information) {
  const auto session = driven_session();
  session->odometry_from_lidar.clear();
  std::vector<Matrix6d> untold_motions;
  const Eigen::Matrix3d turned = so3_exp({0.0, 0.0, 0.3});
  for (int i = 0; i < 3; ++i) {
    session->odometry_from_lidar.push_back(
        {at_ns(0.25 * i), make_rigid(turned, turned * Eigen::Vector3d(i, 0.0, 0.0))});
    Matrix6d untold = Matrix6d::Zero();
    if (i > 0) untold(0, 0) = 1.0;  // a metre along its x
    untold_motions.push_back(untold);
  }
  const DriveMotion motion({session});
  std::vector<motion::Keyframe> keyframes(2);
  keyframes[0].stamp_ns = at_ns(0.0);
  keyframes[1].scan = motion::ScanIndex{2};
  keyframes[1].stamp_ns = at_ns(0.5);
  std::vector<motion::Pair> pairs(1);
  pairs[0].keyframe_b = motion::KeyframeIndex{1};
  pairs[0].baseline_m = 2.0;
  use_odometry(motion, keyframes, {untold_motions}, pairs);
  const Matrix6d partly = pairs[0].registration.information;
  use_odometry(motion, keyframes, {}, pairs);
  const Matrix6d all = pairs[0].registration.information;
  EXPECT_LT(partly(0, 0), 1e-3);  // a sigma of more than thirty metres
  EXPECT_GT(all(0, 0), 1e3);
  for (int i = 1; i < 6; ++i) EXPECT_NEAR(partly(i, i), all(i, i), 1e-6 * all(i, i)) << i;
}

}  // namespace
}  // namespace remount::pipeline
