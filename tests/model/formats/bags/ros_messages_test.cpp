#include "model/formats/bags/ros_messages.h"

#include <gtest/gtest.h>

#include "algorithms/geometry/rotation.h"
#include "model/formats/bags/message_writer.h"
#include "model/formats/bags/static_frames.h"
#include "model/formats/ins/novatel_log.h"
#include "tests/model/formats/bags/bag_fixtures.h"

namespace remount::bags {
namespace {

constexpr MessageEncoding kBoth[] = {MessageEncoding::Ros1, MessageEncoding::Cdr};

void doubles(MessageWriter& writer, std::initializer_list<double> values) {
  for (const double value : values) writer.number(value);
}

MessageReader reader_of(const std::string& bytes, MessageEncoding encoding) { return {bytes, encoding, "a.bag: /t"}; }

TEST(ros_messages, imu_is_read_and_says_what_it_does_not_measure) {
  for (const MessageEncoding encoding : kBoth) {
    const motion::ImuSample sample{kStart_ns, {0.1, -0.2, 0.3}, {0.5, 0.25, 9.8}};
    const std::string inertial = imu_message(sample, "imu", encoding);
    MessageReader first = reader_of(inertial, encoding);
    const ImuMessage rates = read_imu(first);
    EXPECT_FALSE(rates.orientation);
    EXPECT_EQ(*rates.angular_rate_radps, sample.angular_rate_radps);
    EXPECT_EQ(*rates.acceleration_mps2, sample.specific_force_mps2);
    EXPECT_EQ(rates.header.frame, "imu");

    motion::InsSample ins;
    ins.stamp_ns = kStart_ns;
    ins.enu_from_ins = Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ());
    const std::string oriented = attitude_message(ins, 0.002, "ins", encoding);
    MessageReader second = reader_of(oriented, encoding);
    const ImuMessage attitude = read_imu(second);
    EXPECT_FALSE(attitude.angular_rate_radps);
    ASSERT_TRUE(attitude.orientation);
    EXPECT_LT(attitude.orientation->angularDistance(ins.enu_from_ins), 1e-12);
    EXPECT_NEAR(attitude.orientation_variance_rad2.x(), 4e-6, 1e-12);
    EXPECT_EQ(second.left(), 0u);
  }
}

TEST(ros_messages, fix_is_read) {
  motion::GnssFix fix{kStart_ns, degrees_to_radians(51.5), degrees_to_radians(-114.25), 1063.5, {}};
  fix.covariance_enu_m2 = Eigen::Vector3d(0.01, 0.04, 0.09).asDiagonal();
  for (const MessageEncoding encoding : kBoth) {
    const std::string bytes = fix_message(fix, 2, "antenna", encoding);
    MessageReader reader = reader_of(bytes, encoding);
    const FixMessage read = read_fix(reader);
    EXPECT_EQ(read.status, 2);
    EXPECT_NEAR(read.latitude_rad, fix.latitude_rad, 1e-15);
    EXPECT_NEAR(read.longitude_rad, fix.longitude_rad, 1e-15);
    EXPECT_EQ(read.height_m, 1063.5);
    EXPECT_EQ(*read.covariance_enu_m2, fix.covariance_enu_m2);
    EXPECT_EQ(reader.left(), 0u);
  }
}

TEST(ros_messages, poses_of_every_kind_are_read) {
  const double half = std::sin(0.25);
  for (const MessageEncoding encoding : kBoth)
    for (const MessageKind kind : {MessageKind::Odometry, MessageKind::PoseStamped,
                                   MessageKind::PoseWithCovarianceStamped, MessageKind::TransformStamped}) {
      MessageWriter writer(encoding);
      writer.header(kStart_ns, "map");
      const bool child = kind == MessageKind::Odometry || kind == MessageKind::TransformStamped;
      if (child) writer.string("base_link");
      doubles(writer, {1.0, 2.0, 3.0, 0.0, 0.0, half, std::cos(0.25)});
      MessageReader reader = reader_of(writer.bytes(), encoding);
      const PoseMessage pose = read_pose(reader, kind);
      EXPECT_EQ(pose.child_frame, child ? "base_link" : "");
      EXPECT_EQ(pose.world_from_child.translation(), Eigen::Vector3d(1, 2, 3));
      EXPECT_NEAR(so3_log(pose.world_from_child.linear()).z(), 0.5, 1e-12);
    }
}

TEST(ros_messages, quaternions_that_are_none_are_refused) {
  MessageWriter writer(MessageEncoding::Ros1);
  writer.header(kStart_ns, "map");
  doubles(writer, {1, 2, 3, 0, 0, 0, 0});
  const auto read = [&] {
    MessageReader reader = reader_of(writer.bytes(), MessageEncoding::Ros1);
    read_pose(reader, MessageKind::PoseStamped);
  };
  EXPECT_ERROR(read(), "quaternion");
}

/// From latitude to azimuth and the sigmas, as all three drivers have it.
void inspvax_values(MessageWriter& writer) {
  doubles(writer, {51.11637873403, -114.03825114994, 1063.6093});
  writer.number(-16.9f);
  doubles(writer, {0.1, 0.2, 0.3, 1.5, -2.5, 87.25});
  for (const float sigma : {0.8f, 0.9f, 1.2f, 0.01f, 0.02f, 0.03f, 0.5f, 0.6f, 0.7f}) writer.number(sigma);
}

void expect_inspvax(const MessageWriter& writer, MessageEncoding encoding, const std::string& type) {
  // What the same line of an ASCII log gives.
  const formats::TemporaryFolder folder;
  std::vector<drive::Finding> findings;
  const motion::InsSample logged =
      formats::read_novatel(folder.write("a.log", formats::inspvaxa(2183, 269353.56, 87.25)),
                            formats::NovatelFormat::Log, findings)
          .ins[0];
  MessageReader reader = reader_of(writer.bytes(), encoding);
  const motion::InsSample read = read_inspvax_message(reader, type).sample;
  EXPECT_EQ(read.stamp_ns, logged.stamp_ns) << type;
  EXPECT_NEAR(read.latitude_rad, logged.latitude_rad, 1e-15);
  EXPECT_NEAR(read.longitude_rad, logged.longitude_rad, 1e-15);
  EXPECT_NEAR(read.height_m, logged.height_m, 1e-5);
  EXPECT_LT(read.enu_from_ins.angularDistance(logged.enu_from_ins), 1e-12);
  EXPECT_LT((read.sigma.position_enu_m - logged.sigma.position_enu_m).norm(), 1e-6);
  EXPECT_LT((read.sigma.attitude_rad - logged.sigma.attitude_rad).norm(), 1e-6);
  EXPECT_EQ(read.quality, motion::InsQuality::Good) << type;
}

TEST(ros_messages, inspvax_of_the_span_driver_says_what_the_log_says) {
  MessageWriter writer(MessageEncoding::Ros1);
  writer.number<std::uint16_t>(1465).number<std::uint8_t>(0).number<std::uint8_t>(160);
  writer.number<std::uint16_t>(126).number<std::uint16_t>(0).number<std::uint8_t>(70).number<std::uint8_t>(180);
  writer.number<std::uint16_t>(2183).number<std::uint32_t>(269353560).number<std::uint32_t>(33554432);
  writer.number<std::uint16_t>(18205).number<std::uint16_t>(15990);
  writer.number<std::uint32_t>(3).number<std::uint32_t>(56);
  inspvax_values(writer);
  writer.number<std::uint32_t>(251920449).number<std::uint16_t>(0);
  EXPECT_EQ(writer.bytes().size(), 150u);  // as the receiver's log: header 24 (its sync bytes left out), body 126
  expect_inspvax(writer, MessageEncoding::Ros1, "novatel_msgs/INSPVAX");
}

TEST(ros_messages, inspvax_of_the_gps_driver_says_what_the_log_says) {
  for (const MessageEncoding encoding : kBoth) {
    MessageWriter writer(encoding);
    writer.header(kStart_ns, "gps").string("INSPVAXA").string("COM1").number<std::uint32_t>(0).number(73.5f);
    writer.string("FINESTEERING").number<std::uint32_t>(2183).number(269353.56).number<std::uint32_t>(0);
    for (int i = 0; i < 23; ++i) writer.number<std::uint8_t>(0);
    writer.number<std::uint32_t>(43562).string("INS_SOLUTION_GOOD").string("INS_PSRSP");
    inspvax_values(writer);
    expect_inspvax(writer, encoding, "novatel_gps_msgs/Inspvax");
    expect_inspvax(writer, encoding, "novatel_gps_msgs/Inspvax2");
  }
}

TEST(ros_messages, inspvax_of_the_oem7_driver_says_what_the_log_says) {
  for (const MessageEncoding encoding : kBoth) {
    MessageWriter writer(encoding);
    writer.header(kStart_ns, "gps").string("INSPVAX").number<std::uint16_t>(1465).number<std::uint8_t>(0);
    writer.number<std::uint32_t>(0).number<std::uint8_t>(180).number<std::uint16_t>(2183);
    writer.number<std::uint32_t>(269353560).number<std::uint32_t>(3).number<std::uint32_t>(56);
    inspvax_values(writer);
    expect_inspvax(writer, encoding, "novatel_oem7_msgs/INSPVAX");
  }
}

TEST(ros_messages, insstdev_says_what_the_log_says) {
  const formats::NovatelValues values = [] {
    formats::NovatelValues stated;
    stated.latitude_std_m = 0.8, stated.longitude_std_m = 0.9, stated.height_std_m = 1.2;
    stated.roll_std_deg = 0.5, stated.pitch_std_deg = 0.6, stated.azimuth_std_deg = 0.7;
    return stated;
  }();
  const motion::InsSigma expected = formats::ins_sigma(values);
  for (const MessageEncoding encoding : kBoth)
    for (const char* type : {"novatel_oem7_msgs/INSSTDEV", "novatel_gps_msgs/Insstdev", "novatel_gps_msgs/Insstdev2"}) {
      MessageWriter writer(encoding);
      writer.header(kStart_ns, "gps");
      if (std::string_view(type).starts_with("novatel_oem7")) {
        writer.string("INSSTDEV").number<std::uint16_t>(2051).number<std::uint8_t>(0).number<std::uint32_t>(0);
        writer.number<std::uint8_t>(180).number<std::uint16_t>(2183).number<std::uint32_t>(269353560);
      } else {
        writer.string("INSSTDEVA").string("COM1").number<std::uint32_t>(0).number(73.5f).string("FINESTEERING");
        writer.number<std::uint32_t>(2183).number(269353.56).number<std::uint32_t>(0);
        for (int i = 0; i < 23; ++i) writer.number<std::uint8_t>(0);
        writer.number<std::uint32_t>(43562);
      }
      for (const float sigma : {0.8f, 0.9f, 1.2f, 0.01f, 0.02f, 0.03f, 0.5f, 0.6f, 0.7f}) writer.number(sigma);
      MessageReader reader = reader_of(writer.bytes(), encoding);
      EXPECT_EQ(message_kind(type), MessageKind::Insstdev) << type;
      const formats::StampedSigma read = read_insstdev_message(reader, type);
      EXPECT_EQ(read.stamp_ns, 1'636'512'535'560'000'000) << type << ": 18 leap seconds";
      EXPECT_LT((read.sigma.position_enu_m - expected.position_enu_m).norm(), 1e-6) << type;
      EXPECT_LT((read.sigma.attitude_rad - expected.attitude_rad).norm(), 1e-8) << type;
    }
}

TEST(ros_messages, inspvas_of_the_oem6_driver_has_its_time_in_the_body) {
  for (const MessageEncoding encoding : kBoth) {
    MessageWriter writer(encoding);
    writer.header(kStart_ns, "gps").number<std::uint32_t>(2183).number(269353.56);
    doubles(writer, {51.11637873403, -114.03825114994, 1063.6093 - 16.9, 0.1, 0.2, 0.3, 1.5, -2.5, 90.0});
    writer.number<std::uint32_t>(3);
    MessageReader reader = reader_of(writer.bytes(), encoding);
    const motion::InsSample read = read_inspvax_message(reader, "novatel_oem6_msgs/INSPVAS").sample;
    EXPECT_EQ(message_kind("novatel_oem6_msgs/INSPVAS"), MessageKind::Inspva);
    EXPECT_EQ(read.stamp_ns, 1'636'512'535'560'000'000);
    EXPECT_NEAR(read.height_m, 1063.6093 - 16.9, 1e-9);
    EXPECT_NEAR((read.enu_from_ins * Eigen::Vector3d::UnitY()).x(), std::cos(degrees_to_radians(2.5)), 1e-12);
    EXPECT_EQ(read.quality, motion::InsQuality::Good);
  }
}

TEST(ros_messages, inspva_says_what_inspvax_says_without_errors) {
  const formats::TemporaryFolder folder;
  std::vector<drive::Finding> findings;
  const motion::InsSample logged =
      formats::read_novatel(folder.write("a.log", formats::inspvaxa(2183, 269353.56, 87.25)),
                            formats::NovatelFormat::Log, findings)
          .ins[0];
  for (const MessageEncoding encoding : kBoth)
    for (const bool oem7 : {true, false}) {
      MessageWriter writer(encoding);
      writer.header(kStart_ns, "gps").string(oem7 ? "INSPVA" : "INSPVAA");
      if (oem7) {
        writer.number<std::uint16_t>(507).number<std::uint8_t>(0).number<std::uint32_t>(0).number<std::uint8_t>(180);
        writer.number<std::uint16_t>(2183).number<std::uint32_t>(269353560);
      } else {
        writer.string("COM1").number<std::uint32_t>(0).number(73.5f).string("FINESTEERING");
        writer.number<std::uint32_t>(2183).number(269353.0).number<std::uint32_t>(0);
        for (int i = 0; i < 23; ++i) writer.number<std::uint8_t>(0);
        writer.number<std::uint32_t>(43562).number<std::uint32_t>(2183).number(269353.56);
      }
      doubles(writer, {51.11637873403, -114.03825114994, 1063.6093 - 16.9, 0.1, 0.2, 0.3, 1.5, -2.5, 87.25});
      oem7 ? writer.number<std::uint32_t>(3) : writer.string("SINGULARITY");
      MessageReader reader = reader_of(writer.bytes(), encoding);
      const InspvaxMessage message =
          read_inspvax_message(reader, oem7 ? "novatel_oem7_msgs/INSPVA" : "novatel_gps_msgs/Inspva");
      EXPECT_EQ(message.sample.stamp_ns, logged.stamp_ns) << oem7;
      EXPECT_NEAR(message.sample.height_m, logged.height_m, 1e-9);
      EXPECT_LT(message.sample.enu_from_ins.angularDistance(logged.enu_from_ins), 1e-12);
      EXPECT_TRUE(std::isnan(message.sample.sigma.position_enu_m.x()));
      EXPECT_EQ(message.sample.quality, motion::InsQuality::Good);
      EXPECT_EQ(message.misnamed, !oem7);
    }
}

TEST(ros_messages, rates_and_orientations_that_stand_for_none_are_none) {
  for (const double broken : {-2e10, std::nan("")}) {
    MessageWriter writer(MessageEncoding::Ros1);
    writer.header(kStart_ns, "imu");
    doubles(writer, {0.0, 0.0, 0.0, std::isnan(broken) ? broken : 0.0});
    for (int i = 0; i < 9; ++i) writer.number(0.0);
    doubles(writer, {0.1, broken, 0.3});
    for (int i = 0; i < 9; ++i) writer.number(0.0);
    doubles(writer, {0.1, 0.2, 9.8});
    for (int i = 0; i < 9; ++i) writer.number(0.0);
    MessageReader reader = reader_of(writer.bytes(), MessageEncoding::Ros1);
    const ImuMessage imu = read_imu(reader);
    EXPECT_FALSE(imu.orientation);
    EXPECT_FALSE(imu.angular_rate_radps);
    EXPECT_TRUE(imu.acceleration_mps2);
  }
}

TEST(static_frames, are_followed_up_and_down) {
  std::vector<PoseMessage> transforms;
  const auto add = [&](const std::string& parent, const std::string& child, const SixParameters& six) {
    PoseMessage message;
    message.header.frame = parent;
    message.child_frame = child;
    message.world_from_child = rigid_from_six(six);
    transforms.push_back(message);
  };
  const SixParameters imu{0.1, 0.2, 0.3, 0.4, 0.0, 0.1}, mast{1.0, 0.0, 2.0, -0.5, 0.1, 0.0},
      lidar{0, 0, 0.1, 0.2, 0, 0};
  add("base", "imu", imu);
  add("base", "mast", mast);
  add("mast", "lidar", lidar);
  add("lidar", "mast", lidar);  // a cycle ends
  const auto found = find_transform({transforms.begin(), transforms.end() - 1}, "imu", "lidar");
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->isApprox(rigid_from_six(imu).inverse() * rigid_from_six(mast) * rigid_from_six(lidar), 1e-12));
  EXPECT_FALSE(find_transform(transforms, "imu", "camera"));
}

}  // namespace
}  // namespace remount::bags
