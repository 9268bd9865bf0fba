// Messages of makers' own drivers, each with a known attitude.
#include "model/formats/bags/ins_messages.h"

#include <gtest/gtest.h>

#include <list>

#include "algorithms/messages/render.h"
#include "model/formats/files/time_stamp.h"
#include "tests/model/formats/bags/bag_maker.h"
#include "tests/model/formats/bags/maker_messages.h"
#include "tests/model/formats/ins/nmea_text.h"

namespace remount::bags {

using drive::Session;

namespace {

constexpr MessageEncoding kBothEncodings[] = {MessageEncoding::Ros1, MessageEncoding::Cdr};

/// A reader of bytes that are kept for as long as the test runs.
MessageReader reading(const std::string& bytes, MessageEncoding encoding) {
  static std::list<std::string> kept;
  return {kept.emplace_back(bytes), encoding, "here"};
}

motion::InsSample known_sample() {
  motion::InsSample sample;
  sample.stamp_ns = 1'700'000'000'250'000'000;
  sample.latitude_rad = degrees_to_radians(-33.5), sample.longitude_rad = degrees_to_radians(151.25);
  sample.height_m = 310.0;
  // Ahead 30 degrees east of north, nose 5 degrees up, right side 2 degrees down.
  sample.enu_from_ins = drive::enu_from_ins(
      {degrees_to_radians(30.0), degrees_to_radians(5.0), degrees_to_radians(2.0)}, drive::AttitudeConvention::Heading);
  return sample;
}

Eigen::Quaterniond other_convention(const Eigen::Quaterniond& q) {
  return drive::enu_from_ins(q, drive::QuaternionConvention::NedFromBody);
}

TEST(ins_messages, sbg_attitudes_in_both_conventions_and_positions_with_their_undulation) {
  const motion::InsSample sample = known_sample();
  for (const MessageEncoding encoding : kBothEncodings) {
    for (const bool enu : {false, true}) {
      MessageReader reader = reading(sbg_euler(sample, enu, encoding), encoding);
      const ImuMessage imu = read_attitude(reader, MessageKind::SbgEuler);
      ASSERT_TRUE(imu.orientation);
      const Eigen::Quaterniond read = enu ? other_convention(*imu.orientation) : *imu.orientation;
      EXPECT_LT(read.angularDistance(sample.enu_from_ins), 1e-7) << enu;
      EXPECT_LT((imu.orientation_variance_rad2.cwiseSqrt() - Eigen::Vector3d(0.001, 0.002, 0.003)).norm(), 1e-12);
      // The same as a quaternion, which is what the angles make of it.
      const Eigen::Quaterniond logged = enu ? sample.enu_from_ins : other_convention(sample.enu_from_ins);
      MessageWriter writer(encoding);
      writer.header(sample.stamp_ns, "imu_link").number<std::uint32_t>(7);
      put(writer, {logged.x(), logged.y(), logged.z(), logged.w(), 0.001, 0.002, 0.003});
      put_sbg_status(writer);
      MessageReader quaternion = reading(writer.bytes(), encoding);
      EXPECT_LT(read_attitude(quaternion, MessageKind::SbgQuat).orientation->angularDistance(*imu.orientation), 1e-7);
    }
    MessageReader nav = reading(sbg_nav(sample, encoding), encoding);
    const FixMessage fix = read_any_fix(nav, MessageKind::SbgNav);
    EXPECT_EQ(fix.status, 0);
    EXPECT_NEAR(fix.latitude_rad, sample.latitude_rad, 1e-14);
    EXPECT_NEAR(fix.height_m, 310.0, 1e-9);
    EXPECT_LT((fix.covariance_enu_m2->diagonal().cwiseSqrt() - Eigen::Vector3d(0.02, 0.01, 0.03)).norm(), 1e-12)
        << "east, north, up";
    MessageReader not_valid = reading(sbg_nav(sample, encoding, false), encoding);
    EXPECT_EQ(read_any_fix(not_valid, MessageKind::SbgNav).status, -1);
    MessageReader lost = reading(sbg_euler(sample, false, encoding, false), encoding);
    EXPECT_FALSE(read_attitude(lost, MessageKind::SbgEuler).orientation);
  }
}

TEST(ins_messages, septentrios_solution_in_both_conventions) {
  const motion::InsSample sample = known_sample();
  formats::NcomErrors none;
  for (const MessageEncoding encoding : kBothEncodings)
    for (const bool enu : {false, true}) {
      MessageReader reader = reading(ins_nav_geod(sample, enu, encoding), encoding);
      const motion::InsSample read = read_solution(reader, MessageKind::InsNavGeod, none)->sample;
      const Eigen::Quaterniond q = enu ? other_convention(read.enu_from_ins) : read.enu_from_ins;
      EXPECT_LT(q.angularDistance(sample.enu_from_ins), 1e-6) << enu;
      EXPECT_EQ(read.stamp_ns, sample.stamp_ns) << "GPS time, 18 s ahead";
      EXPECT_EQ(read.latitude_rad, sample.latitude_rad);
      EXPECT_EQ(read.height_m, 310.0) << "above the ellipsoid, without the undulation";
      EXPECT_LT((read.sigma.position_enu_m - Eigen::Vector3d(0.02, 0.01, 0.03)).norm(), 1e-8);
      EXPECT_LT((read.sigma.attitude_rad - degrees_to_radians(0.1) * Eigen::Vector3d(1, 2, 3)).norm(), 1e-8);
      EXPECT_EQ(read.quality, motion::InsQuality::Good);
    }
}

TEST(ins_messages, applanix_solution_and_its_errors) {
  const motion::InsSample sample = known_sample();
  formats::NcomErrors none;
  for (const MessageEncoding encoding : kBothEncodings) {
    for (const auto& [alignment, quality] : {std::pair{4, motion::InsQuality::Good},
                                             {3, motion::InsQuality::Degraded},
                                             {1, motion::InsQuality::Invalid}}) {
      MessageReader reader = reading(gsof49(sample, alignment, encoding), encoding);
      const motion::InsSample read = read_solution(reader, MessageKind::Gsof49, none)->sample;
      EXPECT_LT(read.enu_from_ins.angularDistance(sample.enu_from_ins), 1e-7);
      EXPECT_EQ(read.stamp_ns, sample.stamp_ns);
      EXPECT_NEAR(read.latitude_rad, sample.latitude_rad, 1e-14);
      EXPECT_EQ(read.height_m, 310.0);
      EXPECT_EQ(read.quality, quality);
    }
    MessageReader reader = reading(gsof50(sample.stamp_ns, encoding), encoding);
    const formats::StampedSigma errors = read_gsof50(reader);
    EXPECT_EQ(errors.stamp_ns, sample.stamp_ns);
    EXPECT_LT((errors.sigma.position_enu_m - Eigen::Vector3d(0.02, 0.01, 0.03)).norm(), 1e-8);
    EXPECT_LT((errors.sigma.attitude_rad - degrees_to_radians(0.1) * Eigen::Vector3d(1, 2, 3)).norm(), 1e-8);
  }
}

TEST(ins_messages, oxts_packets_have_the_minute_of_their_header) {
  // Second 38 of minute 23067253 of GPS; messages come late, and may be stamped by their arrival in the next minute.
  constexpr std::int64_t kMinute_ns = 1'699'999'962'000'000'000;
  for (const MessageEncoding encoding : kBothEncodings) {
    formats::NcomErrors errors;
    const auto read = [&](const formats::NcomRecord& record, std::int64_t stamp_ns) {
      const std::string bytes = oxts_ncom(record, stamp_ns, encoding);
      MessageReader reader = reading(bytes, encoding);
      return read_solution(reader, MessageKind::OxtsNcom, errors);
    };
    EXPECT_FALSE(read({.status = 1, .channel = 3}, kMinute_ns)) << "no solution yet, but its errors count";
    const auto late =
        read({.millisecond = 59'990, .heading_rad = kPi / 2.0, .channel = 7}, kMinute_ns + 60'100'000'000);
    ASSERT_TRUE(late);
    EXPECT_EQ(late->sample.stamp_ns, kMinute_ns + 59'990'000'000);
    EXPECT_LT((late->sample.enu_from_ins * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitX()).norm(), 1e-6);
    EXPECT_LT((late->sample.sigma.position_enu_m - Eigen::Vector3d(0.02, 0.01, 0.03)).norm(), 1e-12);
    EXPECT_EQ(late->sample.quality, motion::InsQuality::Good);
    formats::NcomRecord broken;
    std::string bytes = oxts_ncom(broken, kMinute_ns, encoding);
    bytes[bytes.size() - 10] = static_cast<char>(bytes[bytes.size() - 10] + 1);
    MessageReader reader = reading(bytes, encoding);
    EXPECT_ERROR(read_solution(reader, MessageKind::OxtsNcom, errors), "is no packet of NCOM");
  }
}

TEST(ins_messages, gps_fixes_and_autoware_orientations) {
  const motion::InsSample sample = known_sample();
  for (const MessageEncoding encoding : kBothEncodings) {
    for (const auto& [status, meaning] : {std::pair{-1, -1}, {0, 0}, {18, 1}, {19, 2}, {33, 1}}) {
      MessageWriter writer(encoding);
      writer.header(sample.stamp_ns, "gps").header(sample.stamp_ns, "gps");
      writer.number<std::uint16_t>(2).number<std::uint32_t>(2).number<std::int32_t>(5).number<std::int32_t>(6);
      writer.number<std::uint16_t>(0);
      for (int i = 0; i < 4; ++i) writer.number<std::uint32_t>(0);
      writer.number(static_cast<std::int16_t>(status));
      for (int i = 0; i < 3; ++i) writer.number<std::uint16_t>(1);
      put(writer, {radians_to_degrees(sample.latitude_rad), radians_to_degrees(sample.longitude_rad), sample.height_m});
      for (int i = 0; i < 7 + 5 + 10; ++i) writer.number(0.0);
      put(writer, {4e-4, 0, 0, 0, 1e-4, 0, 0, 0, 9e-4});
      writer.number<std::uint8_t>(2);
      MessageReader reader = reading(writer.bytes(), encoding);
      const FixMessage fix = read_any_fix(reader, MessageKind::GpsFix);
      EXPECT_EQ(fix.status, meaning) << status;
      EXPECT_NEAR(fix.longitude_rad, sample.longitude_rad, 1e-14);
      EXPECT_EQ(fix.height_m, 310.0);
      EXPECT_EQ((*fix.covariance_enu_m2)(0, 0), 4e-4);
      EXPECT_EQ(reader.left(), 0U) << "the whole message";
    }
    MessageWriter writer(encoding);
    writer.header(sample.stamp_ns, "gnss_ins");
    const Eigen::Quaterniond& q = sample.enu_from_ins;
    put(writer, {q.x(), q.y(), q.z(), q.w()});
    put_floats(writer, {0.001, 0.002, 0.003});
    MessageReader reader = reading(writer.bytes(), encoding);
    const ImuMessage imu = read_attitude(reader, MessageKind::GnssInsOrientation);
    EXPECT_LT(imu.orientation->angularDistance(q), 1e-7);
    EXPECT_LT((imu.orientation_variance_rad2.cwiseSqrt() - Eigen::Vector3d(0.001, 0.002, 0.003)).norm(), 1e-8);
    EXPECT_EQ(reader.left(), 0U);
  }
}

// ---- Whole bags

class ins_message_bags : public ::testing::Test {
 protected:
  Session open_bag_of(const std::function<void(BagMaker&, const motion::InsSample&)>& add) const {
    const fs::path path = folder_.path() / "drive.bag";
    fs::remove(path);
    BagMaker bag(path);
    bag.add_scans("/points", 200, 30);
    for (int i = 0; i < 400; ++i) add(bag, BagMaker::on_circle(i));
    bag.finish();
    Progress progress;
    return formats::open_session(path, progress);
  }
  static void expect_circle(const Session& session, const std::string& what) {
    ASSERT_GE(session.ins.size(), 390U) << what;
    double turned_rad = 0.0;
    for (const motion::InsSample& read : session.ins) {
      const auto i = static_cast<int>((read.stamp_ns - kStart_ns) / (kStep_ns / 2));
      turned_rad = std::max(turned_rad, read.enu_from_ins.angularDistance(BagMaker::on_circle(i).enu_from_ins));
    }
    std::printf("%s: attitudes off by %.2g rad\n", what.c_str(), turned_rad);
    EXPECT_LT(turned_rad, 1e-5) << what;
    EXPECT_EQ(session.ins_axes, drive::InsAxes::ForwardLeftUp) << what;
  }
  formats::TemporaryFolder folder_;
};

TEST_F(ins_message_bags, the_direction_of_travel_tells_which_convention_a_driver_was_set_to) {
  for (const bool enu : {false, true}) {
    const Session sbg = open_bag_of([&](BagMaker& bag, const motion::InsSample& sample) {
      bag.add(sample.stamp_ns + 10'000'000, "/sbg/ekf_nav", "sbg_driver/SbgEkfNav", sbg_nav(sample, kRos1));
      bag.add(sample.stamp_ns + 10'000'000, "/sbg/ekf_euler", "sbg_driver/SbgEkfEuler", sbg_euler(sample, enu, kRos1));
    });
    expect_circle(sbg, enu ? "SBG, ENU" : "SBG, NED");
    // 0.01 m stand first: of the east where the driver writes ENU.
    const Eigen::Vector3d sigma_m = enu ? Eigen::Vector3d(0.01, 0.02, 0.03) : Eigen::Vector3d(0.02, 0.01, 0.03);
    EXPECT_LT((sbg.ins[10].sigma.position_enu_m - sigma_m).norm(), 1e-12) << enu;
    ASSERT_FALSE(sbg.gnss.empty());
    EXPECT_LT((sbg.gnss[10].covariance_enu_m2.diagonal().cwiseSqrt() - sigma_m).norm(), 1e-12) << enu;
    const std::string said = testing::said_of(sbg.findings, "attitude-convention");
    EXPECT_TRUE(formats::contains(said, enu ? "these are of east-north-up" : "these are of north-east-down")) << said;
    const Session septentrio = open_bag_of([&](BagMaker& bag, const motion::InsSample& sample) {
      bag.add(sample.stamp_ns + 10'000'000, "/insnavgeod", "septentrio_gnss_driver/INSNavGeod",
              ins_nav_geod(sample, enu, kRos1));
    });
    expect_circle(septentrio, enu ? "Septentrio, ENU" : "Septentrio, NED");
  }
}

// SBG wrote NED's quaternion with y and z of the other sign, Septentrio a heading of pi / 2 - degrees.
TEST_F(ins_message_bags, early_drivers_are_known_by_a_vehicle_that_goes_ahead) {
  const Session sbg = open_bag_of([](BagMaker& bag, const motion::InsSample& sample) {
    const Eigen::Quaterniond ned = other_convention(sample.enu_from_ins);
    MessageWriter writer(kRos1);
    writer.header(sample.stamp_ns, "imu_link").number<std::uint32_t>(7);
    put(writer, {ned.x(), -ned.y(), -ned.z(), ned.w(), 0.001, 0.002, 0.003});
    put_sbg_status(writer);
    bag.add(sample.stamp_ns + 10'000'000, "/sbg/ekf_nav", "sbg_driver/SbgEkfNav", sbg_nav(sample, kRos1));
    bag.add(sample.stamp_ns + 10'000'000, "/sbg/ekf_quat", "sbg_driver/SbgEkfQuat", writer.bytes());
  });
  expect_circle(sbg, "SBG, early");
  EXPECT_LT((sbg.ins[10].sigma.position_enu_m - Eigen::Vector3d(0.01, 0.02, 0.03)).norm(), 1e-12) << "east first";
  const Session septentrio = open_bag_of([](BagMaker& bag, const motion::InsSample& sample) {
    motion::InsSample early = sample;
    const double turn_rad = degrees_to_radians(0.5 * kPi - 90.0);
    early.enu_from_ins = Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitZ()) * sample.enu_from_ins;
    bag.add(sample.stamp_ns + 10'000'000, "/insnavgeod", "septentrio_gnss_driver/INSNavGeod",
            ins_nav_geod(early, true, kRos1));
  });
  expect_circle(septentrio, "Septentrio, early");
  for (const Session* session : {&sbg, &septentrio}) {
    const auto told = std::ranges::find(session->findings, "attitude-convention", &drive::Finding::code);
    ASSERT_NE(told, session->findings.end());
    EXPECT_EQ(told->severity, drive::Severity::Warning);
    EXPECT_TRUE(formats::contains(english(told->explanation), "as early versions of the driver write it"))
        << english(told->explanation);
  }
}

TEST_F(ins_message_bags, a_vehicle_that_goes_to_a_side_of_its_ins_is_a_warning) {
  const Session session = open_bag_of([](BagMaker& bag, const motion::InsSample& sample) {
    motion::InsSample turned = sample;
    turned.enu_from_ins = sample.enu_from_ins * Eigen::AngleAxisd(0.5 * kPi, Eigen::Vector3d::UnitZ());
    bag.add(sample.stamp_ns + 10'000'000, "/sbg/ekf_nav", "sbg_driver/SbgEkfNav", sbg_nav(sample, kRos1));
    bag.add(sample.stamp_ns + 10'000'000, "/sbg/ekf_euler", "sbg_driver/SbgEkfEuler", sbg_euler(turned, true, kRos1));
  });
  const auto told = std::ranges::find(session.findings, "attitude-convention", &drive::Finding::code);
  ASSERT_NE(told, session.findings.end());
  EXPECT_EQ(told->severity, drive::Severity::Warning);
  EXPECT_TRUE(formats::contains(english(told->explanation), "The vehicle goes at -90")) << english(told->explanation);
}

TEST_F(ins_message_bags, on_a_road_to_the_north_it_is_said_what_may_be_wrong) {
  const Session session = open_bag_of([](BagMaker& bag, const motion::InsSample& sample) {
    constexpr double kSpeed_mps = 10.0, kEarth_m = 6.378e6;
    motion::InsSample north = BagMaker::on_circle(0);
    const double time_s = 1e-9 * static_cast<double>(sample.stamp_ns - north.stamp_ns);
    north.stamp_ns = sample.stamp_ns;
    north.latitude_rad += kSpeed_mps * time_s / kEarth_m;
    north.enu_from_ins = Eigen::AngleAxisd(0.5 * kPi, Eigen::Vector3d::UnitZ());
    const Eigen::Quaterniond ned = other_convention(north.enu_from_ins);
    MessageWriter writer(kRos1);
    writer.header(sample.stamp_ns, "imu_link").number<std::uint32_t>(7);
    put(writer, {ned.x(), ned.y(), ned.z(), ned.w(), 0.001, 0.002, 0.003});
    put_sbg_status(writer);
    bag.add(sample.stamp_ns + 10'000'000, "/sbg/ekf_nav", "sbg_driver/SbgEkfNav", sbg_nav(north, kRos1));
    bag.add(sample.stamp_ns + 10'000'000, "/sbg/ekf_quat", "sbg_driver/SbgEkfQuat", writer.bytes());
  });
  testing::expect_told(
      session.findings, "attitude-convention",
      "these attitudes look like those that early versions of the driver write for east-north-up, with "
      "the opposite pitch: if they are of such a version, yaw and pitch of X are wrong");
}

TEST_F(ins_message_bags, where_the_travel_does_not_tell_both_errors_of_sbg_are_the_larger) {
  const Session session = open_bag_of([](BagMaker& bag, const motion::InsSample& sample) {
    motion::InsSample standing = BagMaker::on_circle(0);
    standing.stamp_ns = sample.stamp_ns;
    bag.add(sample.stamp_ns + 10'000'000, "/sbg/ekf_nav", "sbg_driver/SbgEkfNav", sbg_nav(standing, kRos1));
    bag.add(sample.stamp_ns + 10'000'000, "/sbg/ekf_euler", "sbg_driver/SbgEkfEuler",
            sbg_euler(standing, false, kRos1));
  });
  ASSERT_FALSE(session.ins.empty());
  ASSERT_FALSE(session.gnss.empty());
  const Eigen::Vector3d sigma_m(0.02, 0.02, 0.03);
  EXPECT_LT((session.ins.back().sigma.position_enu_m - sigma_m).norm(), 1e-12);
  EXPECT_LT((session.gnss.back().covariance_enu_m2.diagonal().cwiseSqrt() - sigma_m).norm(), 1e-12);
}

TEST_F(ins_message_bags, applanix_says_where_no_errors_stand_beside_it) {
  const Session session = open_bag_of([](BagMaker& bag, const motion::InsSample& sample) {
    bag.add(sample.stamp_ns + 10'000'000, "/lvx/ins_solution_49", "applanix_msgs/NavigationSolutionGsof49",
            gsof49(sample, 4, kRos1));
  });
  expect_circle(session, "Applanix without errors");
  const std::string said = testing::said_of(session.findings, "ins-log-chosen");
  EXPECT_TRUE(formats::contains(said, "The INS is taken from GSOF 49")) << said;
  EXPECT_TRUE(formats::contains(said, "It states no errors, and no GSOF 50")) << said;
}

TEST_F(ins_message_bags, applanix_and_oxts_serve_with_their_errors) {
  const Session applanix = open_bag_of([](BagMaker& bag, const motion::InsSample& sample) {
    bag.add(sample.stamp_ns + 10'000'000, "/lvx/ins_solution_49", "applanix_msgs/NavigationSolutionGsof49",
            gsof49(sample, 4, kRos1));
    if (sample.stamp_ns % 1'000'000'000 == 0)
      bag.add(sample.stamp_ns + 10'000'000, "/lvx/ins_solution_rms_50", "applanix_msgs/NavigationPerformanceGsof50",
              gsof50(sample.stamp_ns, kRos1));
  });
  expect_circle(applanix, "Applanix");
  EXPECT_NEAR(applanix.ins[10].sigma.position_enu_m.x(), 0.02, 1e-8) << "of GSOF 50";
  EXPECT_EQ(testing::said_of(applanix.findings, "ins-log-chosen"), "");
  const Session oxts = open_bag_of([](BagMaker& bag, const motion::InsSample& sample) {
    const drive::AttitudeAngles angles = drive::angles_from(sample.enu_from_ins, drive::AttitudeConvention::Heading);
    const std::int64_t gps_ms = formats::gps_ns_from_unix_ns(sample.stamp_ns) / 1'000'000;
    const formats::NcomRecord record{.millisecond = static_cast<int>(gps_ms % 60'000),
                                     .latitude_rad = sample.latitude_rad,
                                     .longitude_rad = sample.longitude_rad,
                                     .height_m = sample.height_m,
                                     .heading_rad = angles.yaw_rad,
                                     .channel = static_cast<int>(gps_ms / 50 % 7)};
    bag.add(sample.stamp_ns + 10'000'000, "/ncom", "oxts_msgs/Ncom", oxts_ncom(record, sample.stamp_ns, kRos1));
  });
  expect_circle(oxts, "OxTS");
  EXPECT_NEAR(oxts.ins[10].sigma.position_enu_m.x(), 0.02, 1e-12);
}

TEST_F(ins_message_bags, sentences_of_nmea_are_read_as_their_log) {
  const auto sentence = [](BagMaker& bag, std::int64_t stamp_ns, const std::string& line) {
    MessageWriter writer(kRos1);
    writer.header(stamp_ns + 4'000'000, "gps").string(line);
    bag.add(stamp_ns + 10'000'000, "/nmea_sentence", "nmea_msgs/Sentence", writer.bytes());
  };
  const Session session = open_bag_of([&](BagMaker& bag, const motion::InsSample& sample) {
    const std::string date = formats::format_date_ns(sample.stamp_ns),
                      time = date.substr(11, 2) + date.substr(14, 2) + date.substr(17, 6);
    const auto minutes = [](double angle_rad, int digits) {
      const double deg = radians_to_degrees(angle_rad);
      char text[40];
      std::snprintf(text, sizeof text, "%0*d%012.9f", digits, static_cast<int>(deg), 60.0 * (deg - std::floor(deg)));
      return std::string(text);
    };
    const drive::AttitudeAngles angles = drive::angles_from(sample.enu_from_ins, drive::AttitudeConvention::Heading);
    sentence(bag, sample.stamp_ns, formats::nmea_line("GNZDA," + time + ",13,09,2020,00,00"));
    sentence(bag, sample.stamp_ns,
             formats::nmea_line("GNGGA," + time + "," + minutes(sample.latitude_rad, 2) + ",N," +
                                minutes(sample.longitude_rad, 3) + ",E,4,12,0.8,60.0,M,40.0,M,,"));
    sentence(bag, sample.stamp_ns,
             formats::nmea_line("PASHR," + time + "," + std::to_string(radians_to_degrees(angles.yaw_rad)) +
                                ",T,0.0,0.0,0.00,0.1,0.1,0.1,2"));
  });
  expect_circle(session, "NMEA");
  EXPECT_EQ(session.gnss.size(), session.ins.size()) << "positions are those of the same sentences";
  EXPECT_NEAR(session.ins[10].height_m, 100.0, 1e-9);
}

TEST_F(ins_message_bags, autoware_orientations_go_with_fixes) {
  const Session session = open_bag_of([](BagMaker& bag, const motion::InsSample& sample) {
    MessageWriter writer(kRos1);
    writer.header(sample.stamp_ns, "gnss_ins");
    const Eigen::Quaterniond& q = sample.enu_from_ins;
    put(writer, {q.x(), q.y(), q.z(), q.w()});
    put_floats(writer, {0.001, 0.002, 0.003});
    bag.add(sample.stamp_ns + 10'000'000, "/gnss/orientation", "autoware_sensing_msgs/GnssInsOrientationStamped",
            writer.bytes());
    motion::GnssFix fix{sample.stamp_ns, sample.latitude_rad, sample.longitude_rad, sample.height_m, {}};
    fix.covariance_enu_m2 = 0.0004 * Eigen::Matrix3d::Identity();
    bag.add(sample.stamp_ns + 10'000'000, "/gnss/fix", "sensor_msgs/NavSatFix", fix_message(fix, 2, "gnss", kRos1));
  });
  expect_circle(session, "Autoware");
  EXPECT_NEAR(session.ins[10].sigma.attitude_rad.z(), 0.003, 1e-8);
}

}  // namespace
}  // namespace remount::bags
