// What the reader of bags says of streams that lack something.
#include "model/formats/bags/bag_streams.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "model/checks/data_check.h"
#include "tests/model/formats/bags/bag_maker.h"

namespace remount::bags {
namespace {

class bag_streams : public ::testing::Test {
 protected:
  fs::path path(const std::string& name = "drive.bag") const { return folder_.path() / name; }
  static std::string said(const drive::Session& session, const std::string& code, drive::Severity severity) {
    const drive::Finding* finding = formats::find(session, code);
    if (!finding) return "";
    std::printf("%s: [%s] %s\n", drive::english(finding->where).c_str(), code.c_str(),
                english(finding->explanation).c_str());
    EXPECT_EQ(finding->severity, severity);
    return english(finding->explanation);
  }
  formats::TemporaryFolder folder_;
};

TEST_F(bag_streams, messages_without_stamps_have_those_of_the_recorder) {
  BagMaker bag(path());
  bag.add_odometry("/ins/odometry", 41, false);
  bag.add_scans("/points", 20, 30, false);
  bag.finish();
  const drive::Session session = formats::open(path());
  EXPECT_TRUE(formats::contains(said(session, "no-stamps", drive::Severity::Warning),
                                "the times at which they were recorded are used"));
  EXPECT_EQ(drive::english(formats::find(session, "no-stamps")->where), "/ins/odometry");
  ASSERT_EQ(session.world_from_ins.size(), 41U);
  for (int i = 0; i < 41; ++i)
    EXPECT_EQ(session.world_from_ins[static_cast<std::size_t>(i)].stamp_ns, kStart_ns + i * kStep_ns / 2);
}

TEST_F(bag_streams, fixes_without_fix_or_orientation_are_left_out_and_counted) {
  BagMaker bag(path());
  bag.add_scans("/points", 20, 30);
  for (int i = 0; i < 41; ++i) {
    bag.add_fix("/fix", i, i < 3 ? -1 : 0, false);
    if (i >= 5)
      bag.add(kStart_ns + i * kStep_ns / 2 + 10'000'000, "/imu", "sensor_msgs/Imu",
              attitude_message(BagMaker::on_circle(i), 0.001, "ins", kRos1));
  }
  bag.finish();
  const drive::Session session = formats::open(path());
  EXPECT_EQ(said(session, "ins-incomplete", drive::Severity::Warning),
            "3 messages have no fix and 2 no orientation beside: left out.");
  EXPECT_EQ(said(session, "no-fix", drive::Severity::Note), "3 messages have no fix: left out.");
  EXPECT_EQ(said(session, "gnss-covariance-unknown", drive::Severity::Note),
            "38 fixes do not state their covariance; a sigma of 1 m is assumed.");
  EXPECT_EQ(session.ins.size(), 36U);
  EXPECT_EQ(session.gnss.size(), 38U);
  for (const char* code : {"no-fix", "gnss-covariance-unknown", "no-orientation", "rates-denied", "no-rates"})
    EXPECT_TRUE(checks::finding_kind(code)) << code;
}

TEST_F(bag_streams, poses_that_are_rare_are_slow_as_well) {
  BagMaker bag(path());
  bag.add_scans("/points", 20, 30);
  for (int i = 0; i < 5; ++i) {
    MessageWriter writer(kRos1);
    writer.header(kStart_ns + i * 500'000'000LL, "map");
    for (const double value : {1.0 * i, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}) writer.number(value);
    bag.add(kStart_ns + i * 500'000'000LL, "/ins/pose", "geometry_msgs/PoseStamped", writer.bytes());
  }
  bag.add_static_transform("base", "lidar", 1.0);
  bag.finish();
  const drive::Session session = formats::open(path());
  EXPECT_TRUE(formats::contains(said(session, "ins-slow", drive::Severity::Warning), "a position every 0.50 s only"));
  EXPECT_TRUE(
      formats::contains(said(session, "nominal-not-found", drive::Severity::Note), "name no frame of their own"));
}

TEST_F(bag_streams, static_transforms_that_cannot_serve_are_told_with_the_reason) {
  BagMaker bag(path());
  bag.add_scans("/points", 20, 30);
  bag.add_inspvax("/inspvax", 41, 1);
  bag.add_static_transform("base", "lidar", 1.0);
  bag.finish();
  const drive::Session session = formats::open(path());
  ASSERT_EQ(session.ins.size(), 41U);
  EXPECT_LT(session.ins[7].enu_from_ins.angularDistance(
                BagMaker::on_circle(7).enu_from_ins *
                Eigen::Quaterniond(Eigen::AngleAxisd(-kPi / 2.0, Eigen::Vector3d::UnitZ()))),
            1e-9);
  EXPECT_FALSE(session.nominal_ins_from_lidar);
  EXPECT_TRUE(
      formats::contains(said(session, "nominal-not-found", drive::Severity::Note), "INSPVAX has axes of its own"));
}

/// Two publishers of one topic, message by message in turns.
void write_in_turns(BagWriter& writer) {
  const auto twice = [&](const char* topic, const char* type) {
    const std::uint32_t first = writer.add_topic(topic, definition(type));
    return std::array{first, writer.add_topic(topic, definition(type))};
  };
  const auto points = twice("/points", "sensor_msgs/PointCloud2"), imu = twice("/ins/imu", "sensor_msgs/Imu"),
             fix = twice("/ins/fix", "sensor_msgs/NavSatFix");
  for (int i = 0; i < 40; ++i) {
    const motion::InsSample sample = BagMaker::on_circle(i);
    const std::size_t publisher = i % 3 == 0;
    writer.write(imu[publisher], sample.stamp_ns, attitude_message(sample, 0.001, "ins", kRos1));
    motion::GnssFix at{sample.stamp_ns, sample.latitude_rad, sample.longitude_rad, sample.height_m, {}};
    writer.write(fix[publisher], sample.stamp_ns + 1, fix_message(at, 2, "ins", kRos1));
    cloud::PointCloud cloud;
    for (int k = 0; k < 10; ++k) cloud.points.emplace_back(1.0f + static_cast<float>(k), static_cast<float>(i), 0.0f);
    writer.write(points[publisher], sample.stamp_ns + 2, cloud_message(cloud, sample.stamp_ns, "lidar", kRos1));
  }
  writer.finish();
}

TEST_F(bag_streams, topics_of_several_publishers_are_read_whole_and_in_order) {
  write_in_turns(*make_rosbag1_writer(path("two.bag"), ChunkCompression::Lz4, 2000));
  write_in_turns(*make_mcap_writer(path("two.mcap"), kRos1, ChunkCompression::Lz4, 2000));
  for (const char* name : {"two.bag", "two.mcap"}) {
    const drive::Session session = formats::open(path(name));
    ASSERT_EQ(session.ins.size(), 40U) << name;
    ASSERT_TRUE(session.scans) << name;
    ASSERT_EQ(session.scans->size(), 40U) << name;
    EXPECT_EQ(session.topics.size(), 3U) << name;
    EXPECT_FALSE(formats::find(session, "ins-reversed-stamps")) << name;
    for (std::size_t i = 0; i < 40; ++i) {
      EXPECT_EQ(session.ins[i].stamp_ns, kStart_ns + static_cast<std::int64_t>(i) * kStep_ns / 2) << name;
      EXPECT_EQ(session.scans->stamp_ns(i), session.ins[i].stamp_ns) << name;
      EXPECT_EQ(session.scans->load(i).points[0].y(), static_cast<float>(i)) << name;
    }
    std::printf("%s: %zu scans and %zu samples of two publishers\n", name, session.scans->size(), session.ins.size());
  }
}

}  // namespace
}  // namespace remount::bags
