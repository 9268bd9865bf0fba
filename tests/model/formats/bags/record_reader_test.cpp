// Records of Apollo as sessions.
#include <gtest/gtest.h>

#include <iostream>

#include "algorithms/core/stamps.h"
#include "algorithms/messages/render.h"
#include "model/drive/session_frames.h"
#include "tests/model/formats/bags/record_bags.h"

namespace remount::bags {
namespace {

using testing::has_code;
using testing::said_of;

constexpr const char *kRaw = "/apollo/sensor/velodyne128/PointCloud2", *kSide = "/apollo/sensor/velodyne16/PointCloud2",
                     *kCompensated = "/apollo/sensor/velodyne128/compensator/PointCloud2",
                     *kFused = "/apollo/sensor/velodyne/fusion/PointCloud2",
                     *kOdometry = "/apollo/sensor/gnss/odometry", *kPose = "/apollo/localization/pose";

class record_sessions : public ::testing::Test {
 protected:
  fs::path path() const { return folder_.path() / "drive.record.00000"; }
  RecordMaker record() const { return RecordMaker(path()); }
  drive::Session open(const drive::TopicChoice& topics = {}) const {
    Progress progress;
    return formats::open_session(path(), topics, progress);
  }
  std::vector<std::string> lidars() const {
    Progress progress;
    std::vector<std::string> names;
    for (const drive::LidarOffer& offer : formats::offer_lidars(path(), progress)) names.push_back(offer.name);
    return names;
  }
  const drive::SessionTopic& topic(const drive::Session& session, std::string_view name) const {
    return *std::ranges::find(session.topics, name, &drive::SessionTopic::name);
  }
  formats::TemporaryFolder folder_;
};

TEST_F(record_sessions, have_scans_poses_and_fixes) {
  RecordMaker made = record();
  made.add_clouds(kRaw, 20, 300);
  made.add_gps(60);
  motion::GnssFix fix{kStart_ns, 0.0, 0.0, 0.0, 0.0004 * Eigen::Matrix3d::Identity()};
  for (int i = 0; i < 20; ++i) {
    const motion::InsSample sample = BagMaker::on_circle(2 * i);
    fix.stamp_ns = sample.stamp_ns, fix.latitude_rad = sample.latitude_rad, fix.longitude_rad = sample.longitude_rad;
    made.add(fix.stamp_ns + 7'000'000, "/apollo/sensor/gnss/best_pose", kApolloFix, apollo_fix_message(fix, 50));
  }
  made.finish();
  const drive::Session session = open();
  EXPECT_EQ(session.format, "apollo-record");
  EXPECT_EQ(session.lidar_name, kRaw);
  ASSERT_EQ(session.scans->size(), 20U);
  EXPECT_EQ(session.scan_timing, drive::ScanTiming::PerPoint);
  const cloud::PointCloud cloud = session.scans->load(3);
  EXPECT_EQ(cloud.size(), 300U);
  EXPECT_NEAR(cloud.time_from_stamp_s.front(), -0.0897f, 1e-6f);
  EXPECT_EQ(cloud.time_from_stamp_s.back(), 0.0f) << "stamped with its last point";
  EXPECT_NEAR(seconds(session.scans->stamp_ns(3) - kStart_ns), 0.3897, 1e-7);
  ASSERT_EQ(session.world_from_ins.size(), 60U);
  EXPECT_TRUE(session.ins.empty());
  EXPECT_EQ(session.ins_axes, drive::InsAxes::RightForwardUp);
  EXPECT_TRUE(session.attitudes_to_true_north);
  EXPECT_EQ(session.world_frame, "utm");
  EXPECT_EQ(session.gnss.size(), 20U);
  EXPECT_NEAR(static_cast<double>(session.gnss[5].stamp_ns - BagMaker::on_circle(10).stamp_ns), 0.0, 240.0);
  EXPECT_EQ(topic(session, kOdometry).used_as, std::vector<std::string>{"ins"});
  EXPECT_EQ(topic(session, "/apollo/sensor/gnss/best_pose").used_as, std::vector<std::string>{"gnss"});
  for (const drive::Finding& finding : session.findings)
    std::cout << finding.code << ": " << english(finding.explanation) << "\n";
}

TEST_F(record_sessions, offer_each_lidar_but_what_was_made_of_them) {
  RecordMaker made = record();
  made.add_clouds(kRaw, 20, 300);
  made.add_clouds(kSide, 20, 30, "velodyne16");
  made.add_clouds(kCompensated, 20, 300);
  made.add_clouds(kFused, 20, 330);
  made.add_gps(60);
  made.finish();
  EXPECT_EQ(lidars(), (std::vector<std::string>{kRaw, kSide}));
  EXPECT_EQ(open().lidar_name, kRaw);
  EXPECT_EQ(open({{"lidar", kSide}}).scans->load(0).size(), 30U);
  EXPECT_EQ(open({{"lidar", kFused}}).scans->load(0).size(), 330U) << "where it is asked for";
}

TEST_F(record_sessions, of_a_compensator_alone_are_scans_taken_at_once) {
  RecordMaker made = record();
  made.add_clouds(kCompensated, 20, 300);
  made.add_gps(60);
  made.finish();
  const drive::Session session = open();
  EXPECT_EQ(session.lidar_name, kCompensated);
  EXPECT_EQ(session.scan_timing, drive::ScanTiming::Instant);
  EXPECT_TRUE(session.scans->load(0).time_from_stamp_s.empty());
  EXPECT_TRUE(has_code(session.findings, "scans-compensated"));
  EXPECT_FALSE(has_code(session.findings, "no-point-times"));
}

TEST_F(record_sessions, take_the_ins_before_what_rests_on_lidars) {
  RecordMaker made = record();
  made.add_clouds(kRaw, 20, 300);
  made.add_gps(60);
  made.add_estimates(60);
  made.add_estimates(60, "/apollo/localization/msf_lidar");
  made.finish();
  EXPECT_EQ(topic(open(), kOdometry).used_as, std::vector<std::string>{"ins"});
  const drive::Session session = open({{"ins", kPose}});
  ASSERT_EQ(session.world_from_ins.size(), 60U);
  EXPECT_NEAR(static_cast<double>(session.world_from_ins[4].stamp_ns - BagMaker::on_circle(4).stamp_ns), 0.0, 240.0)
      << "measured, not published";
  EXPECT_EQ(session.ins_axes, drive::InsAxes::RightForwardUp);
  RecordMaker alone = record();
  alone.add_clouds(kRaw, 20, 300);
  alone.add_estimates(60);
  alone.finish();
  EXPECT_EQ(topic(open(), kPose).used_as, std::vector<std::string>{"ins"});
}

TEST_F(record_sessions, have_the_nominal_of_static_transforms) {
  PoseMessage novatel_from_lidar{{0, "novatel"}, "velodyne128", RigidTransform::Identity()};
  novatel_from_lidar.world_from_child.translate(Eigen::Vector3d(0.1, 0.8, 1.2));
  novatel_from_lidar.world_from_child.rotate(Eigen::AngleAxisd(0.5 * kPi, Eigen::Vector3d::UnitZ()));
  PoseMessage localization_from_novatel{{0, "localization"}, "novatel", RigidTransform::Identity()};
  localization_from_novatel.world_from_child.translate(Eigen::Vector3d(0.0, -0.5, 0.0));
  RecordMaker made = record();
  made.add_clouds(kRaw, 20, 300);
  made.add_gps(60);
  made.add_estimates(60);
  made.add(kStart_ns, "/tf_static", kApolloTransforms,
           apollo_transforms_message({novatel_from_lidar, localization_from_novatel}));
  made.finish();
  const drive::Session session = open(), of_estimates = open({{"ins", kPose}});
  ASSERT_TRUE(session.nominal_ins_from_lidar && of_estimates.nominal_ins_from_lidar);
  EXPECT_LT((session.nominal_ins_from_lidar->matrix() - novatel_from_lidar.world_from_child.matrix()).norm(), 1e-12);
  EXPECT_NEAR(of_estimates.nominal_ins_from_lidar->translation().y(), 0.3, 1e-12);
  EXPECT_EQ(topic(session, "/tf_static").used_as, std::vector<std::string>{std::string(drive::kNominalRole)});
}

TEST_F(record_sessions, say_where_corrections_were_lost) {
  RecordMaker made = record();
  made.add_clouds(kRaw, 20, 300);
  made.add_gps(60);
  for (int i = 0; i < 20; ++i)
    made.add(kStart_ns + i * kStep_ns, "/apollo/sensor/gnss/ins_stat", kApolloStat,
             apollo_status_message(kStart_ns + i * kStep_ns, i < 15 ? 56 : 53));
  made.finish();
  EXPECT_NE(said_of(open().findings, "rtk-lost").find("INS_RTKFIXED"), std::string::npos);
}

TEST_F(record_sessions, whose_clouds_have_no_times_say_so) {
  RecordMaker made = record();
  made.add_clouds(kRaw, 20, 300, "velodyne128", false);
  made.add_gps(60);
  made.finish();
  const drive::Session session = open();
  EXPECT_EQ(session.scan_timing, drive::ScanTiming::Unknown);
  EXPECT_TRUE(has_code(session.findings, "no-point-times"));
}

}  // namespace
}  // namespace remount::bags
