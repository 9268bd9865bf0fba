#include "model/formats/bags/bag_reader.h"

#include <gtest/gtest.h>

#include "algorithms/geometry/rotation.h"
#include "algorithms/messages/render.h"
#include "model/overview/session_report.h"
#include "tests/model/formats/bags/bag_maker.h"

namespace remount::bags {

using drive::Session;

namespace {

class bag_reader : public ::testing::Test {
 protected:
  fs::path path(const std::string& name = "drive.bag") const { return folder_.path() / name; }
  Session open_with(const drive::TopicChoice& topics) const {
    Progress progress;
    return formats::open_session(path(), topics, progress);
  }
  const drive::SessionTopic& topic(const Session& session, const std::string& name) const {
    for (const drive::SessionTopic& candidate : session.topics)
      if (candidate.name == name) return candidate;
    throw Error(ErrorCode::Contract, name, Message::verbatim("is not listed"));
  }
  formats::TemporaryFolder folder_;
};

TEST_F(bag_reader, makes_a_session_of_fixes_orientations_and_scans) {
  BagMaker bag(path());
  bag.add_ins("/ins", 41);
  bag.add_scans("/points", 20, 30);
  bag.finish();
  const Session session = formats::open(path());
  EXPECT_EQ(session.format, "ros-bag");
  ASSERT_EQ(session.ins.size(), 41u);
  for (int i = 0; i < 41; ++i) {
    const motion::InsSample expected = BagMaker::on_circle(i), &read = session.ins[static_cast<std::size_t>(i)];
    EXPECT_EQ(read.stamp_ns, expected.stamp_ns);
    EXPECT_NEAR(read.latitude_rad, expected.latitude_rad, 1e-14);
    EXPECT_NEAR(read.longitude_rad, expected.longitude_rad, 1e-14);
    EXPECT_LT(read.enu_from_ins.angularDistance(expected.enu_from_ins), 1e-9);
    EXPECT_NEAR(read.sigma.position_enu_m.x(), 0.02, 1e-12);
    EXPECT_NEAR(read.sigma.attitude_rad.z(), 0.001, 1e-12);
    EXPECT_EQ(read.quality, motion::InsQuality::Good);
  }
  ASSERT_TRUE(session.scans);
  ASSERT_EQ(session.scans->size(), 20u);
  EXPECT_EQ(session.scans->stamp_ns(3), kStart_ns + 3 * kStep_ns);
  EXPECT_EQ(session.scans->load(3).points[7], Eigen::Vector3f(8.0f, 3.0f, 1.0f));
  EXPECT_EQ(session.scan_timing, drive::ScanTiming::PerPoint);
  EXPECT_EQ(session.ins_axes, drive::InsAxes::ForwardLeftUp);
  EXPECT_EQ(session.files, std::vector<fs::path>{path()});
}

TEST_F(bag_reader, lists_topics_with_rates_and_what_they_are_used_as) {
  BagMaker bag(path());
  bag.add_ins("/ins", 41);
  bag.add_scans("/points", 20, 30);
  bag.add(kStart_ns, "/chatter", "std_msgs/String", "x");
  bag.finish();
  const Session session = formats::open(path());
  EXPECT_EQ(session.topics.size(), 4u);
  EXPECT_EQ(topic(session, "/points").count, 20u);
  EXPECT_NEAR(topic(session, "/points").rate_hz, 10.0, 1e-6);
  EXPECT_EQ(topic(session, "/points").used_as, std::vector<std::string>{"lidar"});
  EXPECT_EQ(topic(session, "/ins/fix").used_as, (std::vector<std::string>{"ins-position", "gnss"}));
  EXPECT_TRUE(topic(session, "/chatter").can_be.empty());
  Progress progress;
  const std::string text = overview::describe(session, overview::report_session(session, progress));
  std::cout << text;
  EXPECT_TRUE(formats::contains(text, "/points (sensor_msgs/PointCloud2): 20, 10.0 Hz, used as lidar"));
  EXPECT_TRUE(formats::contains(text, "/chatter (std_msgs/String): 1\n"));
}

void add_two_lidars_and_a_map(BagMaker& bag) {
  bag.add_ins("/ins", 41);
  bag.add_scans("/front", 20, 30);
  bag.add_scans("/top", 20, 50);
  bag.add_scans("/map", 2, 5000, false);
}

TEST_F(bag_reader, says_which_of_several_lidars_it_takes_and_takes_another_when_asked) {
  BagMaker bag(path());
  add_two_lidars_and_a_map(bag);
  bag.finish();
  const Session session = formats::open(path());
  EXPECT_EQ(topic(session, "/top").used_as, std::vector<std::string>{"lidar"});
  const drive::Finding* finding = formats::find(session, "topic-chosen");
  ASSERT_TRUE(finding);
  EXPECT_TRUE(formats::contains(english(finding->explanation), "/front")) << english(finding->explanation);
  EXPECT_TRUE(formats::contains(english(finding->explanation), "--topic lidar="));
  const Session other = open_with({{"lidar", "/front"}});
  EXPECT_EQ(topic(other, "/front").used_as, std::vector<std::string>{"lidar"});
  EXPECT_EQ(topic(other, "/top").used_as, std::vector<std::string>{});
  EXPECT_EQ(other.scans->load(0).size(), 30u);
  EXPECT_FALSE(formats::find(other, "topic-chosen"));
  EXPECT_EQ(other.topic_choice, (drive::TopicChoice{{"lidar", "/front"}}));
}

TEST_F(bag_reader, offers_every_lidar_and_says_which_comes_too_rarely_to_be_one) {
  BagMaker bag(path());
  add_two_lidars_and_a_map(bag);
  bag.add_odometry("/lidar_odometry", 41);
  bag.finish();
  Progress progress;
  const std::vector<drive::LidarOffer> offers = formats::offer_lidars(path(), progress);
  ASSERT_EQ(offers.size(), 3u);
  for (const drive::LidarOffer& offer : offers) {
    const Session session = open_with(offer.choice);
    EXPECT_EQ(session.lidar_name, offer.name);
    EXPECT_EQ(session.scans->size(), offer.scans);
    EXPECT_EQ(offer.rare, offer.name == "/map") << offer.name;
    EXPECT_EQ(session.ins.size(), 41u);
  }
  EXPECT_EQ(formats::open(path()).lidar_name, "/top");
}

TEST_F(bag_reader, each_lidar_has_the_nominal_of_its_own_frame) {
  BagMaker bag(path());
  bag.add_odometry("/odom", 41);
  bag.add_scans("/front", 20, 30, true, 0, kStep_ns, 20'000'000, "front");
  bag.add_scans("/rear", 20, 30, true, 0, kStep_ns, 20'000'000, "rear");
  bag.add_scans("/side", 20, 30, true, 0, kStep_ns, 20'000'000, "side");
  bag.add_static_transform("base", "front", 2.0);
  bag.add_static_transform("base", "rear", -1.0);
  bag.finish();
  const auto x_m = [&](const char* topic) {
    const Session session = open_with({{"lidar", topic}});
    return session.nominal_ins_from_lidar ? session.nominal_ins_from_lidar->translation().x() : std::nan("");
  };
  EXPECT_DOUBLE_EQ(x_m("/front"), 2.0);
  EXPECT_DOUBLE_EQ(x_m("/rear"), -1.0);
  EXPECT_TRUE(std::isnan(x_m("/side")));
}

TEST_F(bag_reader, refuses_topics_that_are_not_there_or_cannot_be_what_is_asked) {
  BagMaker bag(path());
  bag.add_ins("/ins", 41);
  bag.add_scans("/points", 20, 30);
  bag.finish();
  EXPECT_ERROR(open_with({{"lidar", "/pints"}}), "/points (sensor_msgs/PointCloud2)");
  EXPECT_ERROR(open_with({{"ins", "/points"}}), "cannot serve as ins");
  EXPECT_ERROR(open_with({{"ins", "/ins/imu"}, {"ins-position", "none"}}), "no NavSatFix");
  EXPECT_FALSE(open_with({{"lidar", "none"}}).scans);
  drive::TopicChoice choice;
  EXPECT_ERROR(drive::add_topic_choice(choice, "lidar"), "ROLE=TOPIC");
  EXPECT_ERROR(drive::add_topic_choice(choice, "lindar=/points"), "lidar, ins, ins-position");
  drive::add_topic_choice(choice, "lidar=/a=b");
  EXPECT_EQ(choice.at("lidar"), "/a=b");
  EXPECT_ERROR(drive::add_topic_choice(choice, "lidar=/c"), "has a topic already");
  Progress progress;
  const fs::path log = folder_.write("other/a.log", formats::inspvaxa(2183, 100.0, 90.0));
  EXPECT_ERROR(formats::open_session(log, {{"lidar", "/points"}}, progress), "has no topics");
}

TEST_F(bag_reader, takes_poses_and_the_nominal_from_static_transforms) {
  BagMaker bag(path());
  bag.add_odometry("/ins/odometry", 41);
  bag.add_odometry("/lidar/odometry", 41);
  bag.add_scans("/points", 20, 30);
  bag.add_static_transform("base", "mast", 1.0);
  bag.add_static_transform("mast", "lidar", 0.25);
  bag.finish();
  const Session session = formats::open(path());
  EXPECT_TRUE(session.ins.empty());
  ASSERT_EQ(session.world_from_ins.size(), 41u);
  EXPECT_NEAR(so3_log(session.world_from_ins[10].pose.linear()).z(), 0.5, 1e-9);
  ASSERT_TRUE(session.nominal_ins_from_lidar);
  EXPECT_LT((session.nominal_ins_from_lidar->translation() - Eigen::Vector3d(1.25, 0.0, 3.0)).norm(), 1e-12);
  EXPECT_EQ(topic(session, "/lidar/odometry").used_as, std::vector<std::string>{});
  const Session poses = open_with({{"lidar", "/lidar/odometry"}});
  EXPECT_FALSE(poses.scans);
  EXPECT_EQ(poses.odometry_from_lidar.size(), 41u);
}

// As late after the last of 30 points, 87 ms behind the stamp, as samples of the INS are after theirs.
constexpr std::int64_t kRecordedAfter_ns = 87'000'000 + 10'000'000;

TEST_F(bag_reader, brings_an_ins_of_another_clock_to_the_lidars) {
  BagMaker bag(path());
  bag.add_ins("/ins", 41, -214'300'000'000);
  bag.add_scans("/points", 20, 30, true, 0, kStep_ns, kRecordedAfter_ns);
  bag.finish();
  const Session session = formats::open(path());
  const drive::Finding* finding = formats::find(session, "clock-moved");
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->severity, drive::Severity::Warning);
  EXPECT_NEAR(static_cast<double>(session.ins[0].stamp_ns - kStart_ns) * 1e-9, 0.0, 0.011);
  EXPECT_EQ(session.ins[1].stamp_ns - session.ins[0].stamp_ns, kStep_ns / 2);
}

// However long a sweep lasts, the INS is moved by what the clocks are apart, and why is named where it is known.
TEST_F(bag_reader, moves_an_ins_by_its_clock_and_not_by_the_sweep) {
  const auto moved_to_s = [&](std::int64_t lidar_clock_ns, std::int64_t period_ns, const char* cause) {
    BagMaker bag(path());
    bag.add_ins("/ins", 200);
    const std::int64_t sweep_ns = period_ns * 9 / 10;
    bag.add_scans("/points", 10, 300, true, lidar_clock_ns, period_ns, sweep_ns + 10'000'000);
    bag.finish();
    const Session session = formats::open(path());
    const drive::Finding* finding = formats::find(session, "clock-moved");
    EXPECT_TRUE(finding) << lidar_clock_ns;
    if (finding && *cause != 0) {
      EXPECT_TRUE(formats::contains(english(finding->explanation), cause)) << english(finding->explanation);
    }
    return static_cast<double>(session.ins[0].stamp_ns - kStart_ns) * 1e-9;
  };
  for (const std::int64_t period_ns : {50'000'000, 100'000'000, 200'000'000, 500'000'000}) {
    const double rounding_s = 1e-2 * static_cast<double>(period_ns) * 1e-9;
    for (const std::int64_t clock_ns : {-1'800'000'000LL, 1'800'000'000LL, 12'345'000'000LL})
      EXPECT_NEAR(moved_to_s(clock_ns, period_ns, ""), static_cast<double>(clock_ns) * 1e-9, rounding_s) << period_ns;
  }
  EXPECT_NEAR(moved_to_s(28'800'000'000'000, kStep_ns, "about 8 h: likely a time zone"), 28800.0, 2e-3);
  EXPECT_NEAR(moved_to_s(-kStart_ns + 3'000'000'000'000, kStep_ns, "counts from when it was switched on"),
              -static_cast<double>(kStart_ns) * 1e-9 + 3000.0, 2e-3);
}

TEST_F(bag_reader, leaves_both_alone_where_the_recorders_clock_is_off) {
  BagMaker bag(path());
  bag.add_ins("/ins", 41, 214'300'000'000);
  bag.add_scans("/points", 20, 30, true, 214'300'000'000);
  bag.finish();
  const Session session = formats::open(path());
  EXPECT_FALSE(formats::find(session, "clock-moved"));
  EXPECT_EQ(session.ins[0].stamp_ns, kStart_ns + 214'300'000'000);
}

// A LiDAR that publishes once a second stamps its scans by their first points: they are taken down a second later.
TEST_F(bag_reader, leaves_an_ins_alone_whose_lidar_is_late_by_the_duration_of_its_scans) {
  for (const bool timed : {true, false}) {
    BagMaker bag(path());
    bag.add_ins("/ins", 200);
    bag.add_scans("/points", 10, 30, timed, 0, 1'000'000'000, timed ? 920'000'000 : 1'020'000'000);
    bag.finish();
    const Session session = formats::open(path());
    EXPECT_FALSE(formats::find(session, "clock-moved")) << english(formats::find(session, "clock-moved")->explanation);
    EXPECT_FALSE(formats::find(session, "host-clock")) << english(formats::find(session, "host-clock")->explanation);
    EXPECT_EQ(session.ins[0].stamp_ns, kStart_ns);
  }
}

TEST_F(bag_reader, names_a_clock_that_is_off_by_less_than_what_is_moved) {
  for (const std::int64_t clock_ns : {-300'000'000, 300'000'000}) {
    BagMaker bag(path());
    bag.add_ins("/ins", 41, clock_ns);
    bag.add_scans("/points", 20, 30, true, 0, kStep_ns, kRecordedAfter_ns);
    bag.finish();
    const Session session = formats::open(path());
    EXPECT_FALSE(formats::find(session, "clock-moved"));
    EXPECT_EQ(session.ins[0].stamp_ns, kStart_ns + clock_ns) << "nothing is moved";
    const drive::Finding* finding = formats::find(session, "host-clock");
    ASSERT_TRUE(finding);
    EXPECT_EQ(finding->severity, drive::Severity::Warning);
    EXPECT_TRUE(formats::contains(drive::english(finding->where), "/ins/imu")) << drive::english(finding->where);
    EXPECT_TRUE(formats::contains(english(finding->explanation), clock_ns < 0 ? " 0.300 s apart" : "-0.300 s apart"))
        << english(finding->explanation);
    std::cout << english(finding->explanation) << "\n";
  }
}

TEST_F(bag_reader, takes_ordinary_delays_for_no_clocks) {
  constexpr std::int64_t kMs = 1'000'000;
  const std::pair<std::int64_t, std::int64_t> delays[] = {
      {5 * kMs, 5 * kMs}, {5 * kMs, 180 * kMs}, {90 * kMs, 95 * kMs}, {120 * kMs, 20 * kMs}, {1 * kMs, 130 * kMs}};
  for (const auto& [ins_ns, scan_ns] : delays) {
    BagMaker bag(path());
    bag.add_ins("/ins", 41, 0, ins_ns);
    bag.add_scans("/points", 20, 30, true, 0, kStep_ns, scan_ns);
    bag.finish();
    const Session session = formats::open(path());
    EXPECT_FALSE(formats::find(session, "host-clock")) << ins_ns / kMs << " ms and " << scan_ns / kMs << " ms";
    EXPECT_FALSE(formats::find(session, "clock-moved"));
  }
}

TEST_F(bag_reader, says_that_points_have_no_times) {
  BagMaker bag(path());
  bag.add_ins("/ins", 41);
  bag.add_scans("/points", 20, 30, false);
  bag.finish();
  const Session session = formats::open(path());
  EXPECT_EQ(session.scan_timing, drive::ScanTiming::Unknown);
  const drive::Finding* finding = formats::find(session, "no-point-times");
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->severity, drive::Severity::Warning);
  EXPECT_TRUE(formats::contains(english(finding->explanation), "columns: x y z")) << english(finding->explanation);
}

TEST_F(bag_reader, takes_times_that_are_all_zero_for_none) {
  BagMaker bag(path());
  bag.add_ins("/ins", 41);
  for (int i = 0; i < 20; ++i) {
    cloud::PointCloud cloud;
    for (int k = 0; k < 30; ++k) cloud.points.emplace_back(static_cast<float>(k + 1), static_cast<float>(i), 1.0f);
    cloud.time_from_stamp_s.assign(cloud.size(), 0.0f);
    bag.add(kStart_ns + i * kStep_ns, "/points", "sensor_msgs/PointCloud2",
            cloud_message(cloud, kStart_ns + i * kStep_ns, "lidar", kRos1));
  }
  bag.finish();
  const Session session = formats::open(path());
  EXPECT_EQ(session.scan_timing, drive::ScanTiming::Unknown);
  EXPECT_TRUE(formats::find(session, "no-point-times"));
  EXPECT_EQ(session.scans->load(3).size(), 30U);
}

/// A layout as Hesai's driver has it, its clock counting from the sensor's start.
std::string hesai_message(std::int64_t stamp_ns, double first_s) {
  MessageWriter writer(kRos1);
  writer.header(stamp_ns, "lidar").number<std::uint32_t>(1).number<std::uint32_t>(100).number<std::uint32_t>(4);
  std::uint32_t offset = 0;
  for (const char* name : {"x", "y", "z", "timestamp"}) {
    writer.string(name).number(offset).number<std::uint8_t>(offset < 12 ? 7 : 8).number<std::uint32_t>(1);
    offset += 4;
  }
  writer.number<std::uint8_t>(0).number<std::uint32_t>(20).number<std::uint32_t>(2000);
  std::string data;
  for (int i = 0; i < 100; ++i) data += raw(1.0f) + raw(2.0f) + raw(static_cast<float>(i)) + raw(first_s + 0.001 * i);
  return writer.byte_sequence(data).number<std::uint8_t>(1).bytes();
}

TEST_F(bag_reader, keeps_the_sweep_of_a_sensor_on_its_own_clock_and_says_so) {
  BagMaker bag(path());
  bag.add_ins("/ins", 41);
  for (int i = 0; i < 20; ++i)
    bag.add(kStart_ns + i * kStep_ns, "/hesai", "sensor_msgs/PointCloud2",
            hesai_message(kStart_ns + i * kStep_ns, 1234.5 + 0.1 * i));
  bag.finish();
  const Session session = formats::open(path());
  EXPECT_EQ(session.scan_timing, drive::ScanTiming::PerPoint);
  EXPECT_TRUE(formats::find(session, "point-clock"));
  const cloud::PointCloud cloud = session.scans->load(7);
  EXPECT_NEAR(cloud.time_from_stamp_s.back(), 0.099f, 1e-6f);
}

TEST_F(bag_reader, leaves_out_damaged_messages_and_counts_them) {
  BagMaker bag(path());
  bag.add_ins("/ins", 41);
  bag.add(kStart_ns + 1, "/ins/fix", "sensor_msgs/NavSatFix", "short");
  bag.add_scans("/points", 20, 30);
  bag.finish();
  const Session session = formats::open(path());
  EXPECT_EQ(session.ins.size(), 41u);
  const drive::Finding* finding = formats::find(session, "bad-messages");
  ASSERT_TRUE(finding);
  EXPECT_TRUE(formats::contains(english(finding->explanation), "1 message cannot be used"))
      << english(finding->explanation);
}

}  // namespace
}  // namespace remount::bags
