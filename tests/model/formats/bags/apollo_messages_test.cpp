#include "model/formats/bags/apollo_messages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "algorithms/core/stamps.h"
#include "algorithms/geometry/rotation.h"
#include "model/formats/bags/proto_reader.h"
#include "model/formats/files/time_stamp.h"
#include "tests/model/formats/bags/record_bags.h"

namespace remount::bags {
namespace {

MessageReader of_proto(const std::string& bytes) { return {bytes, MessageEncoding::Protobuf, "m"}; }

std::string real_header(double published_s) { return ProtoWriter().real(1, published_s).message(); }

// Azimuth 60 degrees (north-east-east), nose 5 degrees up, right side 3 degrees down: where that points follows from
// the words, and the quaternion from how Apollo's GNSS driver turns NovAtel's angles: about up, right and ahead.
TEST(apollo_messages, a_known_attitude_points_where_its_angles_say) {
  const double azimuth = degrees_to_radians(60.0), pitch = degrees_to_radians(5.0), roll = degrees_to_radians(3.0);
  const Eigen::Quaterniond q = Eigen::AngleAxisd(-azimuth, Eigen::Vector3d::UnitZ()) *
                               Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitX()) *
                               Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitY());
  const ApolloPoseContent content{kStart_ns, {512'345.678, 5'402'345.678, 321.25}, q};
  for (const MessageKind kind : {MessageKind::ApolloGps, MessageKind::ApolloLocalization}) {
    const bool gps = kind == MessageKind::ApolloGps;
    const std::string bytes = gps ? apollo_gps_message(content) : apollo_localization_message(content, 30'000'000);
    MessageReader reader = of_proto(bytes);
    const PoseMessage pose = read_pose(reader, kind);
    const Eigen::Matrix3d enu_from_vehicle = pose.world_from_child.linear();
    const Eigen::Vector3d ahead = enu_from_vehicle.col(1), right = enu_from_vehicle.col(0);
    EXPECT_NEAR(ahead.x(), std::sin(azimuth) * std::cos(pitch), 1e-12);
    EXPECT_NEAR(ahead.y(), std::cos(azimuth) * std::cos(pitch), 1e-12);
    EXPECT_NEAR(ahead.z(), std::sin(pitch), 1e-12);
    EXPECT_NEAR(right.z(), -std::sin(roll) * std::cos(pitch), 1e-12);
    EXPECT_EQ(pose.world_from_child.translation(), content.utm_m);
    EXPECT_NEAR(static_cast<double>(pose.header.stamp_ns - kStart_ns), 0.0, 240.0) << "as a double has it";
    EXPECT_EQ(pose.header.frame, "utm");
    EXPECT_EQ(pose.child_frame, gps ? "novatel" : "localization");
    MessageReader again = of_proto(bytes);
    EXPECT_TRUE(has_orientation(again, kind));
  }
}

TEST(apollo_messages, times_of_gps_and_of_unix_are_told_apart_by_the_header) {
  const double unix_s = 1'600'000'000.25, gps_s = 1'284'035'218.25;  // 18 leap seconds
  const auto stamp_of_estimate = [](double measured_s, double published_s) {
    const std::string inner = ProtoWriter()
                                  .bytes(1, ProtoWriter().real(1, 5e5).real(2, 5e6).message())
                                  .bytes(2, ProtoWriter().real(1, 0.0).real(2, 0.0).real(3, 0.6).message())
                                  .message();
    ProtoWriter message;
    if (published_s > 0.0) message.bytes(1, real_header(published_s));
    message.bytes(2, inner);
    if (measured_s > 0.0) message.real(4, measured_s);
    MessageReader reader = of_proto(message.message());
    const PoseMessage pose = read_pose(reader, MessageKind::ApolloLocalization);
    EXPECT_EQ(pose.world_from_child.translation().z(), 0.0) << "a height that is not there";
    EXPECT_NEAR(pose.world_from_child.linear()(0, 0), 1.0 - 2.0 * 0.36, 1e-12) << "w follows from the others";
    return pose.header.stamp_ns;
  };
  EXPECT_EQ(stamp_of_estimate(unix_s, unix_s + 0.01), 1'600'000'000'250'000'000);
  EXPECT_EQ(stamp_of_estimate(gps_s, unix_s + 0.01), 1'600'000'000'250'000'000);
  EXPECT_EQ(stamp_of_estimate(unix_s, 0.0), 1'600'000'000'250'000'000);
  EXPECT_EQ(stamp_of_estimate(0.0, unix_s), 1'600'000'000'250'000'000);
  EXPECT_ERROR(stamp_of_estimate(1e12, unix_s), "no time of a drive");
}

TEST(apollo_messages, poses_that_are_none_are_refused) {
  const auto error_of_pose = [](const ApolloPoseContent& content) {
    const std::string bytes = apollo_gps_message(content);
    return formats::error_of([&] {
      MessageReader reader = of_proto(bytes);
      read_pose(reader, MessageKind::ApolloGps);
    });
  };
  const Eigen::Quaterniond unit = Eigen::Quaterniond::Identity();
  EXPECT_EQ(error_of_pose({kStart_ns, {1.0, 2.0, 3.0}, unit}), "");
  EXPECT_NE(error_of_pose({kStart_ns, {1.0, 2.0, 3.0}, Eigen::Quaterniond(0.0, 0.0, 0.0, 0.0)}), "");
  EXPECT_NE(error_of_pose({kStart_ns, {1.0, std::nan(""), 3.0}, unit}), "");
  EXPECT_NE(error_of_pose({kStart_ns, {1.0, 1e12, 3.0}, unit}), "");
  const std::string bytes = apollo_gps_message({kStart_ns, {1.0, 2.0, 3.0}, Eigen::Quaterniond(0.0, 0.0, 0.0, 0.0)});
  MessageReader reader = of_proto(bytes);
  EXPECT_FALSE(has_orientation(reader, MessageKind::ApolloGps));
  MessageReader ros(bytes, MessageEncoding::Ros1, "m");
  EXPECT_ERROR(read_pose(ros, MessageKind::ApolloGps), "neither of ROS 1 nor in CDR");
}

TEST(apollo_messages, fixes_have_their_status_errors_and_the_time_of_the_receiver) {
  motion::GnssFix fix{kStart_ns, degrees_to_radians(48.7), degrees_to_radians(9.1), 312.5, {}};
  fix.covariance_enu_m2 = Eigen::Vector3d(0.0004, 0.0009, 0.0016).asDiagonal();
  for (const auto& [type, status] :
       {std::pair{50U, 2}, {56U, 2}, {34U, 1}, {18U, 1}, {16U, 0}, {2U, 0}, {19U, 0}, {53U, 0}, {0U, -1}}) {
    const std::string bytes = apollo_fix_message(fix, type);
    MessageReader reader = of_proto(bytes);
    const FixMessage read = read_apollo_fix(reader);
    EXPECT_EQ(read.status, status) << type;
    EXPECT_EQ(read.header.stamp_ns, kStart_ns);
    EXPECT_NEAR(read.latitude_rad, fix.latitude_rad, 1e-15);
    EXPECT_NEAR(read.longitude_rad, fix.longitude_rad, 1e-15);
    EXPECT_EQ(read.height_m, 312.5);
    ASSERT_TRUE(read.covariance_enu_m2);
    EXPECT_LT((*read.covariance_enu_m2 - fix.covariance_enu_m2).norm(), 1e-9) << "east first";
  }
  // Height above the sea and what the geoid is above the ellipsoid; a solution that was not computed.
  const std::string sea = ProtoWriter()
                              .bytes(1, real_header(1.6e9))
                              .whole(3, 1)
                              .whole(4, 50)
                              .real(5, 48.0)
                              .real(6, 9.0)
                              .real(7, 300.0)
                              .narrow(8, 48.5f)
                              .message();
  MessageReader reader = of_proto(sea);
  const FixMessage read = read_apollo_fix(reader);
  EXPECT_EQ(read.height_m, 348.5);
  EXPECT_EQ(read.status, -1);
  EXPECT_FALSE(read.covariance_enu_m2);
}

/// A turn of so many points, and its message.
cloud::PointCloud apollo_turn(int points) {
  cloud::PointCloud cloud;
  for (int i = 0; i < points; ++i) {
    cloud.points.emplace_back(0.1f * static_cast<float>(i + 1), -1.5f, 0.123456f);
    cloud.intensity.push_back(static_cast<float>(i % 256) / 255.0f);
    cloud.time_from_stamp_s.push_back(1e-4f * static_cast<float>(i));
  }
  return cloud;
}

TEST(apollo_messages, points_are_those_that_were_written_with_their_times) {
  const cloud::PointCloud cloud = apollo_turn(900);
  const std::string bytes = apollo_cloud_message(cloud, kStart_ns, "/velodyne128");
  MessageReader whole = of_proto(bytes);
  const MessageHeader header = read_apollo_scan_header(whole);
  EXPECT_EQ(header.frame, "velodyne128");
  EXPECT_EQ(header.stamp_ns, kStart_ns + std::llround(1e9 * static_cast<double>(cloud.time_from_stamp_s.back())))
      << "of the last point, to the nanosecond";
  MessageReader reader = of_proto(bytes);
  const formats::ReadCloud read = read_cloud(reader, MessageKind::ApolloCloud, header.stamp_ns);
  ASSERT_EQ(read.cloud.points, cloud.points);
  double worst_s = 0.0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    EXPECT_EQ(read.cloud.intensity[i], std::round(255.0f * cloud.intensity[i]));
    const double at_s = static_cast<double>(read.cloud.time_from_stamp_s[i]) + seconds(header.stamp_ns - kStart_ns);
    worst_s = std::max(worst_s, std::abs(at_s - static_cast<double>(cloud.time_from_stamp_s[i])));
  }
  EXPECT_LT(worst_s, 1e-8);
  std::cout << "times of " << cloud.size() << " points are at most " << worst_s * 1e9 << " ns off\n";
}

TEST(apollo_messages, points_that_are_none_are_counted_and_those_without_times_have_none) {
  const auto point = [](float x, std::uint64_t time_ns) {
    ProtoWriter one;
    one.narrow(1, x).narrow(2, 1.0f).narrow(3, 2.0f).whole(4, 7);
    if (time_ns > 0) one.whole(5, time_ns);
    return one.message();
  };
  const auto read_points = [](const std::vector<std::string>& points) {
    ProtoWriter message;
    for (const std::string& one : points) message.bytes(4, one);
    message.bytes(99, "of another version").real(5, 1.6e9);
    MessageReader reader = of_proto(message.message());
    return read_cloud(reader, MessageKind::ApolloCloud, kStart_ns).cloud;
  };
  const cloud::PointCloud cloud = read_points({point(1.0f, 0), point(std::nanf(""), 0), "", point(3.0f, 0)});
  EXPECT_EQ(cloud.size(), 2U);
  EXPECT_EQ(cloud.dropped_points, 2U);
  EXPECT_TRUE(cloud.time_from_stamp_s.empty());
  const auto at = [](std::int64_t before_ns) { return static_cast<std::uint64_t>(kStart_ns - before_ns); };
  EXPECT_EQ(read_points({point(1.0f, at(90'000'000)), point(3.0f, at(0))}).time_from_stamp_s,
            (std::vector<float>{-0.09f, 0.0f}));
}

TEST(apollo_messages, points_that_count_as_gps_does_are_of_the_stamp_all_the_same) {
  constexpr std::int64_t kGpsBehind_ns = 315'964'782'000'000'000;  // 18 leap seconds
  const std::int64_t stamp_ns = 1'600'000'000'250'000'000;
  ProtoWriter message;
  message.bytes(1, real_header(1'600'000'000.3));
  for (const std::int64_t before_ns : {90'000'000, 45'000'000, 0})
    message.bytes(4, ProtoWriter()
                         .narrow(1, 1.0f)
                         .narrow(2, 2.0f)
                         .narrow(3, 3.0f)
                         .whole(5, static_cast<std::uint64_t>(stamp_ns - kGpsBehind_ns - before_ns))
                         .message());
  message.real(5, 1e-9 * static_cast<double>(stamp_ns - kGpsBehind_ns));
  MessageReader whole = of_proto(message.message()), reader = of_proto(message.message());
  EXPECT_NEAR(static_cast<double>(read_apollo_scan_header(whole).stamp_ns - stamp_ns), 0.0, 240.0);
  const formats::ReadCloud read = read_cloud(reader, MessageKind::ApolloCloud, stamp_ns);
  EXPECT_FALSE(read.points_have_another_clock);
  ASSERT_EQ(read.cloud.time_from_stamp_s.size(), 3U);
  EXPECT_NEAR(read.cloud.time_from_stamp_s[0], -0.09f, 1e-6f);
  EXPECT_NEAR(read.cloud.time_from_stamp_s[2], 0.0f, 1e-6f);
}

// The stamp is read of a few bytes at either end, whatever they hold.
TEST(apollo_messages, the_stamp_behind_the_points_is_found_without_them) {
  std::size_t found = 0, tried = 0;
  for (int points = 0; points < 400; points += points < 3 ? 1 : 3, ++tried) {
    const std::int64_t stamp_ns = kStart_ns + std::int64_t{points} * 7'654'321;
    const std::string bytes = apollo_cloud_message(apollo_turn(points), stamp_ns, "velodyne128"),
                      head = bytes.substr(0, 512),
                      end = bytes.substr(bytes.size() - std::min(bytes.size(), kApolloCloudEnd));
    MessageReader whole = of_proto(bytes), begin = of_proto(head), outlined = of_proto(head);
    const auto header = read_apollo_scan_header(begin, end);
    ASSERT_TRUE(header) << points;
    found += header->stamp_ns == read_apollo_scan_header(whole).stamp_ns;
    const CloudOutline outline = read_apollo_outline(outlined, end);
    EXPECT_EQ(outline.points, static_cast<std::uint64_t>(points));
    EXPECT_EQ(outline.timed, points > 0);
  }
  EXPECT_EQ(found, tried);
  // Of a message without such an end it is not.
  ProtoWriter without;
  without.bytes(1, real_header(1.6e9)).bytes(4, std::string(100, ')'));
  MessageReader begin = of_proto(without.message());
  EXPECT_FALSE(read_apollo_scan_header(begin, without.message().substr(40)));
  std::cout << found << " of " << tried << " stamps are found at the end\n";
}

TEST(apollo_messages, transforms_are_of_their_frames) {
  PoseMessage one{{0, "novatel"}, "velodyne128", RigidTransform::Identity()};
  one.world_from_child.translate(Eigen::Vector3d(0.1, 0.8, 1.2))
      .rotate(Eigen::AngleAxisd(1.5, Eigen::Vector3d::UnitZ()));
  PoseMessage other{{0, "localization"}, "novatel", RigidTransform::Identity()};
  const std::string bytes = apollo_transforms_message({one, other});
  MessageReader reader = of_proto(bytes);
  const std::vector<PoseMessage> read = read_transforms(reader);
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].header.frame, "novatel");
  EXPECT_EQ(read[0].child_frame, "velodyne128");
  EXPECT_LT((read[0].world_from_child.matrix() - one.world_from_child.matrix()).norm(), 1e-12);
  EXPECT_EQ(read[1].child_frame, "novatel");
}

}  // namespace
}  // namespace remount::bags
