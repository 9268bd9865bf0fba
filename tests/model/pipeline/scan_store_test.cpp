#include "model/pipeline/scan_store.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>

#include "algorithms/core/error.h"
#include "model/pipeline/pair_clouds.h"

namespace remount::pipeline {
namespace {

constexpr std::int64_t kStoreStart_ns = 1'700'000'000'000'000'000;
constexpr double kSpeed_mps = 10.0, kTurn_radps = 0.6;
constexpr int kStoredScans = 8;

/// On a circle, forwards.
RigidTransform world_from_ins(double time_s) {
  const double radius_m = kSpeed_mps / kTurn_radps, angle = kTurn_radps * time_s;
  return rigid_from_six({radius_m * std::sin(angle), radius_m * (1.0 - std::cos(angle)), 0.0, angle, 0.0, 0.0});
}

const RigidTransform& truth() {
  static const RigidTransform ins_from_lidar = rigid_from_six({1.1, -0.2, 1.8, 0.4, 0.02, -0.01});
  return ins_from_lidar;
}

double stamp_s(std::size_t scan) { return 0.3 + 0.2 * static_cast<double>(scan); }

/// A floor around the sensor, seen by a sweep of 0.1 s about the stamp that turns counter-clockwise and faces forward
/// (azimuth 0) at the stamp. Scan 5 cannot be read.
class SweptFloor : public drive::ScanSource {
 public:
  explicit SweptFloor(bool with_times) : with_times_(with_times) {}
  std::size_t size() const override { return kStoredScans; }
  std::int64_t stamp_ns(std::size_t scan) const override {
    return kStoreStart_ns + static_cast<std::int64_t>(std::llround(stamp_s(scan) * 1e9));
  }
  std::string name(std::size_t scan) const override { return std::to_string(scan) + ".pcd"; }
  cloud::PointCloud load(std::size_t scan) const override {
    ++loads;
    if (scan == 5) throw Error(ErrorCode::Io, name(scan), Message::verbatim("cannot be read"));
    cloud::PointCloud cloud;
    for (int i = 0; i < 3000; ++i) {
      const double turn = 2.0 * kPi * (i / 3000.0 - 0.5), radius_m = 3.0 + 0.25 * (i % 40);
      const Eigen::Vector3d at_stamp(radius_m * std::cos(turn), radius_m * std::sin(turn), -1.8);
      const double time_s = 0.1 * turn / (2.0 * kPi);
      const RigidTransform now_from_stamp =
          (world_from_ins(stamp_s(scan) + time_s) * truth()).inverse() * world_from_ins(stamp_s(scan)) * truth();
      cloud.points.push_back((now_from_stamp * at_stamp).cast<float>());
      if (with_times_) cloud.time_from_stamp_s.push_back(static_cast<float>(time_s));
    }
    return cloud;
  }
  mutable std::atomic<int> loads{0};

 private:
  bool with_times_;
};

struct StoredDrive {
  explicit StoredDrive(drive::ScanTiming timing)
      : floor(std::make_shared<SweptFloor>(timing == drive::ScanTiming::PerPoint)) {
    drive::Session made;
    made.name = "drive";
    for (int i = 0; i <= 300; ++i)
      made.world_from_ins.push_back({kStoreStart_ns + i * 10'000'000LL, world_from_ins(0.01 * i)});
    made.scans = floor;
    made.scan_timing = timing;
    made.sweep = {0.1, 0.0, false, true};
    session = std::make_shared<const drive::Session>(std::move(made));
    motion.emplace(std::vector<std::shared_ptr<const drive::Session>>{session});
  }
  motion::Keyframe keyframe(int scan) const {
    return {motion::SessionIndex{0}, index_at<motion::ScanIndex>(scan), floor->stamp_ns(static_cast<std::size_t>(scan)),
            kSpeed_mps * stamp_s(static_cast<std::size_t>(scan))};
  }
  ScanStore store(std::size_t bound_bytes = 1U << 30U) const {
    return {*motion, registration::RegistrationOptions{}, bound_bytes};
  }

  std::shared_ptr<SweptFloor> floor;
  std::shared_ptr<const drive::Session> session;
  std::optional<DriveMotion> motion;
};

/// The largest error of a point: all lie on the floor as it was seen from the sensor at the stamp.
double worst_error_m(const cloud::PointCloud& cloud) {
  double worst_m = 0.0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const double turn = 2.0 * kPi * (static_cast<double>(i) / 3000.0 - 0.5), radius_m = 3.0 + 0.25 * (i % 40);
    const Eigen::Vector3d at_stamp(radius_m * std::cos(turn), radius_m * std::sin(turn), -1.8);
    worst_m = std::max(worst_m, (cloud.points[i].cast<double>() - at_stamp).norm());
  }
  return worst_m;
}

TEST(scan_store, a_compensated_scan_is_as_if_taken_at_its_stamp) {
  const StoredDrive drive(drive::ScanTiming::PerPoint);
  ScanStore store = drive.store();
  EXPECT_GT(worst_error_m(store.load(drive.keyframe(2))), 0.4) << "without a call scans are used as they are";
  store.compensate_motion(truth(), {false});
  const cloud::PointCloud cloud = store.load(drive.keyframe(2));
  EXPECT_LT(worst_error_m(cloud), 2e-3);
  EXPECT_TRUE(cloud.time_from_stamp_s.empty()) << "it cannot be compensated twice";
}

TEST(scan_store, the_sweep_gives_times_only_where_the_session_uses_it) {
  const StoredDrive drive(drive::ScanTiming::SweepAzimuth);
  ScanStore store = drive.store();
  store.compensate_motion(truth(), {false});
  EXPECT_GT(worst_error_m(store.load(drive.keyframe(2))), 0.4);
  store.compensate_motion(truth(), {true});
  // The azimuth is that of the moved point: what is left is the square of the motion within a sweep.
  EXPECT_LT(worst_error_m(store.load(drive.keyframe(2))), 0.05);
}

/// Where points of scans 1, 2 and 3 are seen from the sensor at the stamp of scan 2, in the order of the scans.
std::vector<Eigen::Vector3d> floor_around_scan_2(std::initializer_list<std::size_t> scans) {
  std::vector<Eigen::Vector3d> points;
  const RigidTransform here_from_world = (world_from_ins(stamp_s(2)) * truth()).inverse();
  for (const std::size_t scan : scans)
    for (int i = 0; i < 3000; ++i) {
      const double turn = 2.0 * kPi * (i / 3000.0 - 0.5), radius_m = 3.0 + 0.25 * (i % 40);
      const Eigen::Vector3d at_stamp(radius_m * std::cos(turn), radius_m * std::sin(turn), -1.8);
      points.push_back(here_from_world * world_from_ins(stamp_s(scan)) * truth() * at_stamp);
    }
  return points;
}

double worst_apart_m(const cloud::PointCloud& cloud, const std::vector<Eigen::Vector3d>& points) {
  double worst_m = cloud.size() == points.size() ? 0.0 : std::nan("");
  for (std::size_t i = 0; i < std::min(cloud.size(), points.size()); ++i)
    worst_m = std::max(worst_m, (cloud.points[i].cast<double>() - points[i]).norm());
  return worst_m;
}

TEST(scan_store, scans_are_gathered_where_the_ins_puts_them) {
  const StoredDrive drive(drive::ScanTiming::PerPoint);
  ScanStore store = drive.store();
  store.compensate_motion(truth(), {false});
  store.gather(truth(), {3});
  const cloud::PointCloud cloud = store.load(drive.keyframe(2));
  EXPECT_LT(worst_apart_m(cloud, floor_around_scan_2({2, 1, 3})), 2e-3);
  EXPECT_TRUE(cloud.time_from_stamp_s.empty()) << "it cannot be compensated twice";
  RigidTransform wrong = truth();
  wrong.translation().y() += 0.5;
  store.gather(wrong, {3});
  store.compensate_motion(wrong, {false});
  EXPECT_GT(worst_apart_m(store.load(drive.keyframe(2)), floor_around_scan_2({2, 1, 3})), 0.03)
      << "through the mounting that is given";
}

TEST(scan_store, one_frame_and_other_sessions_are_single_scans) {
  const StoredDrive drive(drive::ScanTiming::PerPoint);
  ScanStore store = drive.store();
  store.compensate_motion(truth(), {false});
  const cloud::PointCloud single = store.load(drive.keyframe(2));
  for (const std::vector<int>& frames : {std::vector<int>{}, std::vector<int>{1}, std::vector<int>{0, 5}}) {
    store.gather(truth(), frames);
    EXPECT_EQ(store.load(drive.keyframe(2)).points, single.points);
  }
}

TEST(scan_store, without_compensation_scans_are_gathered_as_wholes) {
  const StoredDrive drive(drive::ScanTiming::Instant);
  ScanStore store = drive.store();
  store.gather(truth(), {3});
  const cloud::PointCloud cloud = store.load(drive.keyframe(2));
  ASSERT_EQ(cloud.size(), 9000U);
  const cloud::PointCloud single = drive.floor->load(2), before = drive.floor->load(1);
  const RigidTransform here_from_before =
      (world_from_ins(stamp_s(2)) * truth()).inverse() * world_from_ins(stamp_s(1)) * truth();
  double worst_m = 0.0;
  for (std::size_t i = 0; i < 3000; ++i) {
    EXPECT_EQ(cloud.points[i], single.points[i]);
    worst_m = std::max(
        worst_m, (cloud.points[3000 + i].cast<double>() - here_from_before * before.points[i].cast<double>()).norm());
  }
  EXPECT_LT(worst_m, 2e-3);
}

TEST(scan_store, a_neighbour_that_cannot_be_read_is_left_out_but_not_the_keyframe_itself) {
  const StoredDrive drive(drive::ScanTiming::PerPoint);
  ScanStore store = drive.store();
  store.gather(truth(), {3});
  EXPECT_EQ(store.load(drive.keyframe(4)).size(), 6000U) << "scan 5 cannot be read";
  EXPECT_THROW(store.load(drive.keyframe(5)), Error);
  EXPECT_EQ(store.load(drive.keyframe(0)).size(), 6000U) << "there is none before the first";
}

TEST(scan_store, a_scan_is_prepared_once_for_all_its_pairs_and_threads) {
  const StoredDrive drive(drive::ScanTiming::PerPoint);
  ScanStore store = drive.store();
  std::vector<std::shared_ptr<const registration::PreparedCloud>> seen(8);
  {
    std::vector<std::jthread> threads;
    for (auto& mine : seen)
      threads.emplace_back([&] { mine = store.prepare(motion::KeyframeIndex{3}, drive.keyframe(3), {}); });
  }
  EXPECT_EQ(drive.floor->loads, 1);
  for (const auto& cloud : seen) EXPECT_EQ(cloud, seen.front());
  EXPECT_GT(seen.front()->size(), 100U);
}

TEST(scan_store, beyond_the_bound_the_least_recently_used_goes_first) {
  const StoredDrive drive(drive::ScanTiming::PerPoint);
  const std::size_t one = ScanStore(*drive.motion, registration::RegistrationOptions{}, 0)
                              .prepare(motion::KeyframeIndex{0}, drive.keyframe(0), {})
                              ->bytes();
  ScanStore store = drive.store(2 * one + one / 2);
  for (const int scan : {0, 1, 0, 2}) store.prepare(index_at<motion::KeyframeIndex>(scan), drive.keyframe(scan), {});
  const int before = drive.floor->loads;
  store.prepare(motion::KeyframeIndex{0}, drive.keyframe(0), {});
  store.prepare(motion::KeyframeIndex{2}, drive.keyframe(2), {});
  EXPECT_EQ(drive.floor->loads, before) << "0 was used after 1 and is still there";
  store.prepare(motion::KeyframeIndex{1}, drive.keyframe(1), {});
  EXPECT_EQ(drive.floor->loads, before + 1);
}

TEST(scan_store, an_unreadable_scan_fails_for_every_pair_with_its_name) {
  const StoredDrive drive(drive::ScanTiming::PerPoint);
  ScanStore store = drive.store();
  for (int pair = 0; pair < 2; ++pair) {
    try {
      store.prepare(motion::KeyframeIndex{5}, drive.keyframe(5), {});
      FAIL() << "scan 5 cannot be read";
    } catch (const Error& error) {
      EXPECT_STREQ(error.what(), "5.pcd: cannot be read");
    }
  }
  EXPECT_EQ(drive.floor->loads, 1) << "it is not tried again for every pair";
}

TEST(scan_store, what_was_cancelled_is_not_kept) {
  const StoredDrive drive(drive::ScanTiming::PerPoint);
  ScanStore store = drive.store();
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(store.prepare(motion::KeyframeIndex{1}, drive.keyframe(1), {}, Progress(stop.get_token()))->size(), 0U);
  EXPECT_GT(store.prepare(motion::KeyframeIndex{1}, drive.keyframe(1), {})->size(), 100U);
}

TEST(scan_store, points_within_a_box_are_left_out) {
  const StoredDrive drive(drive::ScanTiming::PerPoint);
  ScanStore store = drive.store();
  const LidarBox ahead{{0.0F, -20.0F, -5.0F}, {20.0F, 20.0F, 5.0F}};
  const auto cloud = store.prepare(motion::KeyframeIndex{1}, drive.keyframe(1), {ahead});
  ASSERT_GT(cloud->size(), 50U);
  for (const Eigen::Vector3f& point : cloud->copy_points()) EXPECT_LE(point.x(), 0.0F);
}

// What the window shows of a pair is what was aligned: whether by the sweep is remembered, not judged anew.
TEST(solved_pairs, compensate_as_the_calibration_did) {
  const StoredDrive drive(drive::ScanTiming::SweepAzimuth);
  PipelineInput input;
  input.sessions = {drive.session};
  PipelineOutput output;
  output.keyframes = {drive.keyframe(1), drive.keyframe(2)};
  motion::Pair pair;
  pair.keyframe_b = motion::KeyframeIndex{1};
  output.pairs = {pair};
  output.compensation_ins_from_lidar = truth();
  output.session_uses_sweep = {false};
  output.findings.push_back(
      {drive::Severity::Note, "deskew-on", std::string("drive"), Message::verbatim("in words only")});
  EXPECT_GT(worst_error_m(
                SolvedPairs(input, std::make_shared<PipelineOutput>(output)).load(motion::PairIndex{0}, {}).cloud_b()),
            0.4);
  output.session_uses_sweep = {true};
  output.findings[0].code = "deskew-off";
  EXPECT_LT(worst_error_m(
                SolvedPairs(input, std::make_shared<PipelineOutput>(output)).load(motion::PairIndex{0}, {}).cloud_b()),
            0.05);
}

// Under the true mounting every scan of the map lies on the one floor there is.
TEST(load_map_scans, brings_all_scans_of_a_session_to_one_place_within_the_number_of_points) {
  const StoredDrive drive(drive::ScanTiming::SweepAzimuth);
  PipelineInput input;
  input.sessions = {drive.session};
  PipelineOutput output;
  for (int scan = 1; scan <= 5; ++scan) output.keyframes.push_back(drive.keyframe(scan));
  output.compensation_ins_from_lidar = truth();
  output.session_uses_sweep = {true};
  Progress progress;
  const SessionScans map = load_map_scans(input, output, motion::SessionIndex{0}, 5000, progress);
  ASSERT_EQ(map.scans.points_in_lidar.size(), 4U) << "scan 5 cannot be read";
  EXPECT_EQ(map.unreadable, 1U);
  EXPECT_NE(english(map.first_failure).find("5.pcd"), std::string::npos) << map.first_failure;
  EXPECT_EQ(map.points_recorded, 12000U);
  EXPECT_LT(map.scans.local_from_ins.front().translation().norm(), 1e-9);
  std::size_t points = 0;
  for (std::size_t i = 0; i < map.scans.points_in_lidar.size(); ++i) {
    points += map.scans.points_in_lidar[i].size();
    const Eigen::Vector3d between_stamps =
        world_from_ins(stamp_s(i + 1)).translation() - world_from_ins(stamp_s(1)).translation();
    EXPECT_LT((map.scans.local_from_ins[i].translation() - between_stamps).norm(), 0.02);
    EXPECT_LT(rotation_angle_between_rad(map.scans.local_from_ins[i], world_from_ins(stamp_s(i + 1))), 1e-3);
    for (const Eigen::Vector3f& point : map.scans.points_in_lidar[i]) {
      EXPECT_NEAR(point.z(), -1.8F, 0.06F);
    }
  }
  EXPECT_LE(points, 5000U);
  EXPECT_GT(points, 3000U);
}

TEST(load_map_scans, cancelled_is_empty_and_unreadable_throws) {
  const StoredDrive drive(drive::ScanTiming::SweepAzimuth);
  PipelineInput input;
  input.sessions = {drive.session};
  PipelineOutput output;
  output.keyframes = {drive.keyframe(5)};
  Progress progress;
  EXPECT_THROW(load_map_scans(input, output, motion::SessionIndex{0}, 5000, progress), Error);
  std::stop_source stop;
  stop.request_stop();
  Progress stopped(stop.get_token());
  EXPECT_TRUE(load_map_scans(input, output, motion::SessionIndex{0}, 5000, stopped).scans.points_in_lidar.empty());
}

}  // namespace
}  // namespace remount::pipeline
