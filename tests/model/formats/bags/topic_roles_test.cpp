// Which topic of a bag serves as INS or IMU where its type alone does not tell.
#include "model/formats/bags/topic_roles.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "model/formats/bags/ros_messages.h"
#include "tests/model/formats/bags/bag_maker.h"

namespace remount::bags {

using drive::Session;

namespace {

class topic_roles : public ::testing::Test {
 protected:
  fs::path path() const { return folder_.path() / "drive.bag"; }
  Session open_with(const drive::TopicChoice& topics = {}) const {
    Progress progress;
    return formats::open_session(path(), topics, progress);
  }
  static std::string user_of(const Session& session, const std::string& role) {
    for (const drive::SessionTopic& topic : session.topics)
      if (std::count(topic.used_as.begin(), topic.used_as.end(), role) > 0) return topic.name;
    return "none";
  }
  std::string why(const std::string& name, const std::string& role) const {
    Progress progress;
    const std::optional<drive::TopicOffer> offer = formats::offer_topics(path(), progress);
    for (const drive::OfferedTopic& offered : offer->topics)
      if (offered.topic.name == name) return offered.use(role) ? english(offered.use(role)->why) : "it cannot be that";
    return "is not listed";
  }
  static std::string said(const Session& session, const std::string& code) {
    const drive::Finding* finding = formats::find(session, code);
    if (finding) std::printf("[%s] %s\n", code.c_str(), english(finding->explanation).c_str());
    return finding ? english(finding->explanation) : "";
  }
  /// A constant turn of an IMU that has seen the orientation `yaw`.
  static BagMaker::ImuContent turning(double yaw, double orientation_variance, double rate_variance) {
    return {Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ())),
            orientation_variance,
            {0.0, 0.0, 1.0},
            rate_variance};
  }
  formats::TemporaryFolder folder_;
};

TEST_F(topic_roles, an_ins_of_one_position_a_second_stands_behind_one_of_twenty) {
  BagMaker bag(path());
  bag.add_scans("/points", 90, 30);
  bag.add_inspvax("/novatel/oem7/inspvax", 11, 20);
  bag.add_odometry("/novatel/oem7/odom", 201);
  bag.finish();
  const Session session = open_with();
  EXPECT_EQ(user_of(session, "ins"), "/novatel/oem7/odom");
  EXPECT_EQ(said(session, "ins-slow"), "");
  EXPECT_EQ(why("/novatel/oem7/inspvax", "ins"), "slow: 1.0 Hz, where /novatel/oem7/odom has 20.0 Hz");
  EXPECT_EQ(said(open_with({{"ins", "/novatel/oem7/inspvax"}}), "ins-slow"),
            "The INS has a position every 1.00 s only; between them the motion is interpolated. /novatel/oem7/odom has "
            "20.0 Hz: --topic ins=/novatel/oem7/odom takes it, where it is of the same INS.");
}

TEST_F(topic_roles, inspva_is_the_ins_where_inspvax_comes_once_a_second) {
  BagMaker bag(path());
  bag.add_scans("/points", 90, 30);
  bag.add_inspvax("/novatel/oem7/inspvax", 11, 20);
  bag.add_inspva("/novatel/oem7/inspva", 201);
  bag.add_odometry("/novatel/oem7/odom", 201);
  bag.finish();
  const Session session = open_with();
  EXPECT_EQ(user_of(session, "ins"), "/novatel/oem7/inspva");
  EXPECT_EQ(why("/novatel/oem7/inspva", "ins"), "position and attitude of the INS itself, without errors");
  ASSERT_EQ(session.ins.size(), 201U);
  EXPECT_EQ(session.ins_axes, drive::InsAxes::RightForwardUp);
  for (int i = 0; i < 201; i += 40) {
    const motion::InsSample &read = session.ins[static_cast<std::size_t>(i)], written = BagMaker::on_circle(i);
    EXPECT_EQ(read.stamp_ns, written.stamp_ns);
    EXPECT_NEAR(read.latitude_rad, written.latitude_rad, 1e-12);
    EXPECT_EQ(read.quality, motion::InsQuality::Good);
    EXPECT_NEAR(read.sigma.position_enu_m.x(), 0.02, 1e-6) << "as INSPVAX beside it states";
  }
  EXPECT_EQ(said(session, "ins-slow"), "");
}

TEST_F(topic_roles, of_inspvax_and_inspva_the_one_that_comes_more_often_is_the_ins) {
  for (const bool inspva_is_faster : {true, false}) {
    fs::remove(path());
    BagMaker bag(path());
    bag.add_scans("/points", 90, 30);
    bag.add_inspvax("/novatel/oem7/inspvax", inspva_is_faster ? 101 : 201, inspva_is_faster ? 2 : 1);
    bag.add_inspva("/novatel/oem7/inspva", inspva_is_faster ? 201 : 50);
    bag.finish();
    const Session session = open_with();
    EXPECT_EQ(user_of(session, "ins"), inspva_is_faster ? "/novatel/oem7/inspva" : "/novatel/oem7/inspvax");
    ASSERT_EQ(session.ins.size(), 201U);
    EXPECT_NEAR(session.ins[100].sigma.position_enu_m.x(), 0.02, 1e-6);
  }
}

TEST_F(topic_roles, inspva_has_the_errors_of_insstdev_beside_it) {
  BagMaker bag(path());
  bag.add_scans("/points", 90, 30);
  bag.add_inspva("/novatel/oem7/inspva", 201);
  bag.add_insstdev("/novatel/oem7/insstdev", 6, 20, 0.03);  // for the first five seconds, and two more
  bag.finish();
  const Session session = open_with();
  EXPECT_EQ(user_of(session, "ins"), "/novatel/oem7/inspva");
  ASSERT_EQ(session.ins.size(), 201U);
  for (std::size_t i = 0; i < 201; ++i) EXPECT_EQ(std::isnan(session.ins[i].sigma.position_enu_m.x()), i > 140) << i;
  EXPECT_NEAR(session.ins[100].sigma.position_enu_m.x(), 0.03, 1e-6);
  EXPECT_NEAR(session.ins[100].sigma.attitude_rad.x(), degrees_to_radians(0.01), 1e-8);
  EXPECT_EQ(said(session, "ins-log-chosen"),
            "The INS is taken from INSPVA (201 samples). Its errors are those of INSSTDEV, the nearest in time and not "
            "more than 2 s away. 60 samples have none.");
  Progress progress;
  const std::optional<drive::TopicOffer> offer = formats::offer_topics(path(), progress);
  for (const drive::OfferedTopic& offered : offer->topics)
    if (offered.topic.name == "/novatel/oem7/insstdev") {
      EXPECT_EQ(english(offered.unusable), "errors of the INS, which INSPVA is given where it serves");
    }
}

TEST_F(topic_roles, orientations_that_nobody_fills_in_are_named_and_the_topics_listed) {
  for (const double value : {0.0, std::nan("")}) {
    fs::remove(path());
    BagMaker bag(path());
    bag.add_scans("/points", 90, 30);
    bag.add_unoriented("/odom", 201, value);
    bag.finish();
    const Session session = open_with();
    EXPECT_EQ(session.topics.size(), 2U);
    EXPECT_EQ(user_of(session, "ins"), "none");
    EXPECT_TRUE(formats::contains(said(session, "no-orientation"), "it is all zero, or no number"));
    EXPECT_EQ(drive::english(formats::find(session, "no-orientation")->where), "/odom");
    EXPECT_ERROR(open_with({{"ins", "/odom"}}), "no usable INS is in this topic");
  }
}

TEST_F(topic_roles, another_ins_serves_where_one_has_no_orientation) {
  BagMaker bag(path());
  bag.add_scans("/points", 90, 30);
  bag.add_unoriented("/gps/odom", 201);
  bag.add_odometry("/odom", 201);
  bag.finish();
  EXPECT_EQ(user_of(open_with(), "ins"), "/odom");
  EXPECT_EQ(why("/gps/odom", "ins"), "it cannot be that");
}

TEST_F(topic_roles, packets_of_sensors_are_named_as_such) {
  for (const char* type : {"velodyne_msgs/VelodyneScan", "velodyne_msgs/VelodynePacket", "pandar_msgs/PandarScan",
                           "hesai_lidar/PandarScan", "hesai_ros_driver/UdpFrame", "ouster_ros/PacketMsg",
                           "ouster_sensor_msgs/PacketMsg", "rslidar_msgs/rslidarScan", "rslidar_msg/RslidarPacket",
                           "nebula_msgs/NebulaPackets", "lslidar_msgs/LslidarPacket"}) {
    fs::remove(path());
    BagMaker bag(path());
    for (int i = 0; i < 10; ++i) bag.add(kStart_ns + i * kStep_ns, "/lidar_packets", type, std::string(1200, 'x'));
    bag.add_odometry("/odom", 201);
    bag.finish();
    const Session session = open_with();
    EXPECT_TRUE(formats::contains(said(session, "raw-packets"), type)) << type;
    EXPECT_EQ(drive::english(formats::find(session, "raw-packets")->where), "/lidar_packets");
  }
  EXPECT_FALSE(is_raw_packets("sensor_msgs/LaserScan"));
  EXPECT_FALSE(is_raw_packets("sensor_msgs/PointCloud2"));
  EXPECT_FALSE(is_raw_packets("scan"));
}

TEST_F(topic_roles, of_fixes_with_one_stamp_the_best_counts_in_either_order) {
  for (const bool better_first : {true, false}) {
    fs::remove(path());
    BagMaker bag(path());
    bag.add_scans("/points", 90, 30);
    for (int i = 0; i < 201; ++i) {
      bag.add_imu("/ins/imu", i, turning(0.05 * i, 1e-6, 1e-6));
      for (const bool better : {better_first, !better_first}) {
        if (better) {
          bag.add_fix("/ins/fix", i, 2);
          continue;
        }
        const motion::InsSample sample = BagMaker::on_circle(i);
        motion::GnssFix fix{sample.stamp_ns, sample.latitude_rad + 1e-6, sample.longitude_rad, sample.height_m, {}};
        fix.covariance_enu_m2 = 4.0 * Eigen::Matrix3d::Identity();
        bag.add(sample.stamp_ns + 10'000'000, "/ins/fix", "sensor_msgs/NavSatFix", fix_message(fix, 0, "gps", kRos1));
      }
    }
    bag.finish();
    const Session session = open_with();
    ASSERT_EQ(session.ins.size(), 201U);
    ASSERT_EQ(session.gnss.size(), 201U);
    for (int i = 0; i < 201; ++i) {
      EXPECT_NEAR(session.ins[static_cast<std::size_t>(i)].latitude_rad, BagMaker::on_circle(i).latitude_rad, 1e-9);
      EXPECT_NEAR(session.gnss[static_cast<std::size_t>(i)].latitude_rad, BagMaker::on_circle(i).latitude_rad, 1e-9);
    }
    EXPECT_NE(said(session, "gnss-duplicate-stamps"), "");
  }
}

TEST_F(topic_roles, an_ins_of_ten_positions_a_second_is_kept) {
  BagMaker bag(path());
  bag.add_scans("/points", 90, 30);
  bag.add_inspvax("/novatel/oem7/inspvax", 101, 2);
  bag.add_odometry("/novatel/oem7/odom", 201);
  bag.finish();
  const Session session = open_with();
  EXPECT_EQ(user_of(session, "ins"), "/novatel/oem7/inspvax");
  EXPECT_EQ(said(session, "ins-slow"), "");
  EXPECT_EQ(why("/novatel/oem7/inspvax", "ins"), "position and attitude of the INS itself");
}

TEST_F(topic_roles, a_slow_ins_is_kept_where_the_faster_topic_may_be_of_another_sensor) {
  BagMaker bag(path());
  bag.add_scans("/points", 90, 30);
  bag.add_inspvax("/inspvax", 11, 20);
  bag.add_odometry("/odom", 201);
  bag.add_odometry("/wheel/odom", 201);
  bag.finish();
  const Session session = open_with();
  EXPECT_EQ(user_of(session, "ins"), "/inspvax");
  EXPECT_TRUE(formats::contains(said(session, "ins-slow"), " /odom has 20.0 Hz: --topic ins=/odom "));
}

TEST_F(topic_roles, a_slow_ins_that_is_the_only_one_is_told_to_be_set_faster) {
  BagMaker bag(path());
  bag.add_scans("/points", 90, 30);
  bag.add_inspvax("/inspvax", 11, 20);
  bag.finish();
  EXPECT_TRUE(formats::contains(said(open_with(), "ins-slow"), "No other topic has it much more often"));
}

TEST_F(topic_roles, fixes_that_are_rare_make_the_ins_slow_and_the_faster_ones_are_named) {
  BagMaker bag(path());
  bag.add_scans("/points", 90, 30);
  for (int i = 0; i < 201; ++i) {
    bag.add_imu("/ins/imu", i, turning(0.05 * i, 1e-6, 1e-6));
    if (i % 20 == 0) bag.add_fix("/ins/fix", i, 2);
    bag.add_fix("/receiver/fix", i, 2);
  }
  bag.finish();
  const Session session = open_with();
  EXPECT_EQ(user_of(session, "ins-position"), "/ins/fix");
  EXPECT_TRUE(formats::contains(said(session, "ins-slow"), "--topic ins-position=/receiver/fix"));
}

TEST_F(topic_roles, positions_of_another_device_than_the_orientation_may_be_of_an_antenna) {
  BagMaker bag(path());
  bag.add_scans("/points", 90, 30);
  for (int i = 0; i < 201; ++i) {
    bag.add_imu("/ins/imu", i, turning(0.05 * i, 1e-6, 1e-6));
    bag.add_fix("/ins/fix", i, 2);
    bag.add_fix("/receiver/fix", i, 2);
  }
  bag.finish();
  EXPECT_EQ(said(open_with(), "antenna-position"), "");
  const Session session = open_with({{"ins-position", "/receiver/fix"}});
  EXPECT_TRUE(formats::contains(said(session, "antenna-position"), "may be those of an antenna"));
  EXPECT_FALSE(session.ins.empty()) << "it is used all the same";
}

TEST_F(topic_roles, an_orientation_that_nobody_fills_in_is_no_ins) {
  BagMaker bag(path());
  bag.add_scans("/points", 20, 30);
  for (int i = 0; i < 41; ++i) {
    BagMaker::ImuContent content;
    content.rate = {0.0, 0.0, 1.0};
    bag.add_imu("/livox/imu", i, content);
    bag.add_fix("/gps/fix", i, 2);
  }
  bag.finish();
  const Session session = open_with();
  EXPECT_EQ(user_of(session, "ins"), "none");
  EXPECT_EQ(user_of(session, "imu"), "/livox/imu");
  EXPECT_EQ(why("/livox/imu", "ins"), "it cannot be that");
  EXPECT_ERROR(open_with({{"ins", "/livox/imu"}}), "its orientation is never filled in, it is the identity throughout");
}

TEST_F(topic_roles, an_ins_may_begin_at_the_identity) {
  BagMaker bag(path());
  bag.add_scans("/points", 20, 30);
  for (int i = 0; i < 41; ++i) {
    bag.add_imu("/ins/imu", i, turning(i < 5 ? 0.0 : 0.05 * (i - 4), 0.0, 0.0));
    bag.add_fix("/ins/fix", i, 2);
  }
  bag.finish();
  const Session session = open_with();
  EXPECT_EQ(user_of(session, "ins"), "/ins/imu");
  EXPECT_EQ(session.ins.size(), 41U);
  EXPECT_EQ(why("/ins/imu", "ins"), "an orientation without its error, to which fixes give the position");
}

TEST_F(topic_roles, an_orientation_that_states_its_error_comes_first) {
  BagMaker bag(path());
  bag.add_scans("/points", 20, 30);
  for (int i = 0; i < 41; ++i) {
    bag.add_imu("/a/imu", i, turning(0.05 * i, 0.0, 0.0));
    bag.add_imu("/b/imu", i, turning(0.05 * i, 1e-6, 0.0));
    bag.add_fix("/fix", i, 2);
  }
  bag.finish();
  EXPECT_EQ(user_of(open_with(), "ins"), "/b/imu");
  EXPECT_EQ(user_of(open_with({{"ins", "/a/imu"}}), "ins"), "/a/imu");
}

TEST_F(topic_roles, an_imu_that_begins_before_its_ins_has_aligned_is_an_ins_and_an_imu) {
  BagMaker bag(path());
  bag.add_scans("/points", 20, 30);
  for (int i = 0; i < 41; ++i) {
    BagMaker::ImuContent content = turning(0.05 * i, 1e-6, -1.0);
    if (i < 5) content.orientation.coeffs().setZero();
    if (i < 5) content.orientation_variance = 0.0;
    bag.add_imu("/novatel/imu", i, content);
    bag.add_fix("/novatel/fix", i, 2);
  }
  bag.finish();
  for (const drive::TopicChoice& choice :
       {drive::TopicChoice{}, drive::TopicChoice{{"ins", "/novatel/imu"}, {"imu", "/novatel/imu"}}}) {
    const Session session = open_with(choice);
    EXPECT_EQ(user_of(session, "ins"), "/novatel/imu");
    EXPECT_EQ(user_of(session, "imu"), "/novatel/imu");
    EXPECT_EQ(session.ins.size(), 36U);
    EXPECT_EQ(session.imu.size(), 41U);
    EXPECT_EQ(said(session, "no-orientation"),
              "5 messages have no orientation, 5 of them before the first that has one: left out.");
    EXPECT_TRUE(
        formats::contains(said(session, "rates-denied"), "41 messages say that turn rates or accelerations are not"));
    EXPECT_EQ(formats::find(session, "no-orientation")->severity, drive::Severity::Note);
  }
}

TEST_F(topic_roles, what_is_asked_for_is_read_though_the_messages_that_were_looked_at_lack_it) {
  BagMaker bag(path());
  bag.add_scans("/points", 20, 30);
  for (int i = 0; i < 41; ++i) {
    BagMaker::ImuContent content = turning(0.05 * i, 1e-6, -1.0);
    if (i == 0 || i == 20 || i == 40) content = {Eigen::Quaterniond(0.0, 0.0, 0.0, 0.0), 0.0, {0.0, 0.0, 0.0}, -1.0};
    bag.add_imu("/imu", i, content);
    bag.add_fix("/fix", i, 2);
  }
  bag.finish();
  EXPECT_EQ(why("/imu", "ins"), "it cannot be that");
  const Session session = open_with({{"ins", "/imu"}, {"imu", "/imu"}});
  EXPECT_EQ(session.ins.size(), 39U) << "between the others it is interpolated where the step is short";
  EXPECT_EQ(session.imu.size(), 38U);
  EXPECT_TRUE(
      formats::contains(said(session, "no-orientation"), "3 messages have no orientation, 1 of them before the first"));
  EXPECT_TRUE(formats::contains(said(session, "no-rates"), "3 messages have no turn rates"));
}

TEST_F(topic_roles, what_is_asked_for_and_has_nothing_is_refused) {
  BagMaker bag(path());
  bag.add_scans("/points", 20, 30);
  for (int i = 0; i < 41; ++i) {
    bag.add_imu("/imu", i, {Eigen::Quaterniond(0.0, 0.0, 0.0, 0.0), 0.0, {0.0, 0.0, 0.0}, -1.0});
    bag.add_fix("/fix", i, 2);
  }
  bag.finish();
  EXPECT_ERROR(open_with({{"ins", "/imu"}}), "none of its messages has an orientation");
  EXPECT_ERROR(open_with({{"imu", "/imu"}}), "no message of this topic has turn rates");
}

}  // namespace
}  // namespace remount::bags
