// Raw measurements of the IMU in NovAtel's logs.
#include "model/formats/ins/novatel_imu.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "model/formats/ins/novatel_log.h"
#include "tests/model/formats/ins/novatel_records.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

using namespace novatel;

class novatel_imu : public ::testing::Test {
 protected:
  std::vector<motion::ImuSample> read(const std::string& bytes) {
    findings_.clear();
    const auto path = folder_.write("a.gps", bytes);
    EXPECT_EQ(recognise_novatel(path), NovatelFormat::Log);
    NovatelLog log = read_novatel(path, NovatelFormat::Log, findings_);
    return log.imu;
  }
  std::string told() const { return testing::said_of(findings_, "ins-log-chosen"); }
  TemporaryFolder folder_;
  std::vector<drive::Finding> findings_;
};

constexpr double kStart_s = 491'674.0;

std::string solution() { return short_log(508, kStart_s, inspva_body(kStart_s, 90.0)); }

/// A tenth of a second at 125 Hz.
template <class Log>
std::string raw_imu_logs(Log&& log) {
  std::string bytes;
  for (int i = 0; i < 13; ++i) bytes += log(kStart_s + 0.008 * i);
  return bytes;
}

// The manual's own example, which stands: along z it feels gravity, and its turns are those of a bias.
TEST_F(novatel_imu, every_form_of_the_log_feels_gravity_upwards) {
  const std::string insconfig = with_crc('#', ascii_header("INSCONFIGA", kStart_s) + "EPSON_G320,6,50,20,LAND,0,0");
  const std::string insconfig_b = long_log(1945, kStart_s, Body().add<std::uint32_t>(41).add<std::uint32_t>(0));
  const std::pair<const char*, std::string> forms[] = {
      {"RAWIMUXA", raw_imu_logs([](double t) { return rawimu("RAWIMUXA", t); })},
      {"RAWIMUSXA", raw_imu_logs([](double t) { return rawimu("RAWIMUSXA", t); })},
      {"RAWIMUA", insconfig + raw_imu_logs([](double t) { return rawimu("RAWIMUA", t); })},
      {"RAWIMUSA", insconfig + raw_imu_logs([](double t) { return rawimu("RAWIMUSA", t); })},
      {"RAWIMUXB", raw_imu_logs([](double t) { return long_log(1461, t, rawimux_body(t)); })},
      {"RAWIMUSXB", raw_imu_logs([](double t) { return short_log(1462, t, rawimux_body(t)); })},
      {"RAWIMUB", insconfig_b + raw_imu_logs([](double t) { return long_log(268, t, rawimu_body(t)); })},
      {"RAWIMUSB", insconfig_b + raw_imu_logs([](double t) { return short_log(325, t, rawimu_body(t)); })}};
  for (const auto& [name, bytes] : forms) {
    const std::vector<motion::ImuSample> imu = read(solution() + bytes);
    ASSERT_EQ(imu.size(), 13U) << name << told();
    EXPECT_EQ(imu[12].stamp_ns - imu[0].stamp_ns, 96'000'000) << name;
    const Eigen::Vector3d &force = imu[5].specific_force_mps2, &rate = imu[5].angular_rate_radps;
    if (name == std::string("RAWIMUXA"))
      std::printf("force %.4f %.4f %.4f m/s2, rate %.4f %.4f %.4f deg/s\n", force.x(), force.y(), force.z(),
                  radians_to_degrees(rate.x()), radians_to_degrees(rate.y()), radians_to_degrees(rate.z()));
    EXPECT_NEAR(force.z(), 9.855, 0.001) << name;
    EXPECT_NEAR(force.x(), 0.0810, 0.0001) << name << ": the log's y, negated there, looks ahead";
    EXPECT_NEAR(force.y(), -0.1349, 0.0001) << name << ": the log's x is to the right";
    EXPECT_NEAR(radians_to_degrees(rate.z()), 0.0239, 0.0001) << name;
    EXPECT_NEAR(radians_to_degrees(rate.x()), -0.0509, 0.0001) << name;
    EXPECT_NEAR(radians_to_degrees(rate.y()), 0.1222, 0.0001) << name;
    EXPECT_TRUE(contains(told(), "(13 samples, type EPSON_G320)")) << name << told();
  }
}

const double kDegreesOfRadian = 180.0 / kPi;

// Counts of a second that stands upright and turns by a radian a second.
TEST_F(novatel_imu, counts_are_scaled_by_the_type_of_the_imu) {
  struct {
    int type;
    double hz, force_counts, turn_counts;
  } const types[] = {
      {8, 200.0, 9.81 * 16'384.0, 524'288.0},
      {11, 100.0, 9.81 / 0.3048 * 134'217'728.0, 8'589'934'592.0},
      {62, 200.0, 9.81 / 9.80665 * 1000.0 / 0.2 * 65'536.0 * 200.0, kDegreesOfRadian * 65'536.0 / 0.008 * 200.0},
      {12, 100.0, 9.81 / 0.3048 * 67'108'864.0, 8'589'934'592.0},
      {13, 200.0, 9.81 * 655'360.0, kDegreesOfRadian * 3600.0 * 2560.0},
      {33, 200.0, 9.81 * 655'360.0, 9'216'000.0},
      {26, 200.0, 9.81 * 5e7, 1e9},
      {31, 200.0, 9.81 / 200.0 * 2'147'483'648.0, kDegreesOfRadian / 720.0 * 2'147'483'648.0},
      {32, 125.0, 9.81 * 4'194'304.0, kDegreesOfRadian * 2'097'152.0},
      {69, 400.0, 9.81 * 536'870'912.0, 8'589'934'592.0}};
  for (const auto& [type, hz, force_counts, turn_counts] : types) {
    NovatelImuTypes named;
    named.add(type);
    std::vector<motion::ImuSample> samples(20);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      samples[i].stamp_ns = std::llround(static_cast<double>(i) / hz * 1e9);
      samples[i].specific_force_mps2.z() = force_counts / hz;
      samples[i].angular_rate_radps.x() = turn_counts / hz;
    }
    EXPECT_TRUE(scale_raw_imu(named, "RAWIMUSX", samples).empty()) << type;
    ASSERT_FALSE(samples.empty()) << type;
    EXPECT_NEAR(samples[7].specific_force_mps2.z(), 9.81, 1e-6) << type;
    EXPECT_NEAR(samples[7].angular_rate_radps.x(), 1.0, 1e-6) << type;
  }
}

TEST_F(novatel_imu, counts_that_mean_nothing_are_passed_over_with_the_reason) {
  const auto of_type = [](int type) {
    return raw_imu_logs([type](double t) { return short_log(1462, t, rawimux_body(t, type)); });
  };
  const std::pair<std::string, const char*> logs[] = {
      {raw_imu_logs([](double t) { return short_log(325, t, rawimu_body(t)); }), "of which type the IMU is"},
      {of_type(99), "with an IMU of type 99 is not known"},
      {of_type(41) + of_type(31), "names several types, of which each counts differently: EPSON_G320, ADIS16488"},
      {of_type(31), "as those of an IMU of type ADIS16488 they would be a force of 3834"},
      {short_log(1462, kStart_s, rawimux_body(kStart_s)), "too few"}};
  for (const auto& [bytes, why] : logs) {
    EXPECT_TRUE(read(solution() + bytes).empty()) << why;
    EXPECT_TRUE(contains(told(), why)) << told();
    EXPECT_TRUE(contains(told(), "Not used: RAWIMUS")) << told();
  }
}

TEST_F(novatel_imu, measurements_with_an_error_and_what_is_broken_are_left_out) {
  std::string bytes = solution() + raw_imu_logs([](double t) { return short_log(1462, t, rawimux_body(t)); });
  for (const int info : {1, 2})
    bytes += short_log(1462, kStart_s + 1.0, rawimux_body(kStart_s + 1.0, 41, kStandingCounts, info));
  bytes += short_log(1462, 7e5, rawimux_body(7e5)) + short_log(1462, 5.0, Body().add(1.0));
  bytes += with_crc('%', "RAWIMUSXA,2183,491674.014;zz,41,2183,491674.013699,ea59fe00,1,2,3,4,5,6");
  bytes += with_crc('%', "RAWIMUSXA,2183,491674.014;04,41,2183,491674.013699,ea59fe00,1,2,3,4,5,-9223372036854775808");
  bytes += with_crc('%', "RAWIMUSA,2183,491674.014;2183,491674.013699,ea59fe00,1,2,3");
  EXPECT_EQ(read(bytes).size(), 13U);
  EXPECT_TRUE(contains(testing::said_of(findings_, "bad-ins"), "5 logs cannot be used"))
      << testing::said_of(findings_, "bad-ins");
}

TEST_F(novatel_imu, a_log_of_an_imu_alone_says_what_it_is_and_what_is_missing) {
  const std::string forms[] = {raw_imu_logs([](double t) { return rawimu("RAWIMUSXA", t); }),
                               raw_imu_logs([](double t) { return short_log(1462, t, rawimux_body(t)); })};
  for (const std::string& bytes : forms) {
    const auto path = folder_.write("imu.log", bytes);
    EXPECT_ERROR(open(path),
                 "holds the raw measurements of an IMU, but no solution of an INS (INSPVAX, INSPVA, INSPVAS)");
    EXPECT_ERROR(open(path), "RAWIMUSX (13)");
  }
}

TEST_F(novatel_imu, a_log_of_an_imu_alone_does_not_hide_what_tells_the_motion) {
  const std::string imu = raw_imu_logs([](double t) { return rawimu("RAWIMUSXA", t); });
  const std::string fixes =
      "$GPZDA,221320.00,14,11,2023,00,00*60\r\n"
      "$GPGGA,221320.00,4846.8000,N,00910.8000,E,4,12,0.6,300.0,M,48.0,M,,*65\r\n";
  folder_.write("gnss/imu.log", imu);
  folder_.write("gnss/fixes.nmea", fixes);
  EXPECT_EQ(open(folder_.path() / "gnss").format, "gnss-log");

  folder_.write("span/a.log", imu);
  folder_.write("span/b.log", solution());
  const drive::Session session = open(folder_.path() / "span");
  EXPECT_EQ(session.format, "novatel");
  EXPECT_EQ(session.ins.size(), 1U);
  EXPECT_EQ(session.imu.size(), 13U);
  EXPECT_EQ(session.files.size(), 2U);
  EXPECT_EQ(find(session, "bad-ins"), nullptr);
}

TEST_F(novatel_imu, a_native_session_takes_the_imu_of_a_recording) {
  std::string poses, table = "time_ns,rear_left_mps,rear_right_mps\n";
  for (int i = 0; i < 40; ++i) {
    poses += std::to_string(1'636'734'856.0 + 0.1 * i) + " " + std::to_string(i) + " 0 0 0 0 0 1\n";
    table += std::to_string(1'636'734'856'000'000'000 + std::int64_t{100'000'000} * i) + ",1,1\n";
  }
  const std::string imu = raw_imu_logs([](double t) { return short_log(1462, t, rawimux_body(t)); });
  folder_.write("d/a.gps", imu);
  folder_.write("d/lidar.txt", poses);
  folder_.write("d/wheels.csv", table);
  folder_.write("d/session.yaml",
                "format: remount-session/1\nname: d\nlidar_poses: {file: lidar.txt, format: tum}\n"
                "imu: {file: a.gps}\nwheels: {file: wheels.csv}\n");
  const drive::Session session = open(folder_.path() / "d");
  ASSERT_EQ(session.imu.size(), 13U);
  EXPECT_NEAR(session.imu[3].specific_force_mps2.z(), 9.855, 0.001);
  folder_.write("d/a.gps", solution());
  EXPECT_ERROR(open(folder_.path() / "d"), "holds no raw measurements of an IMU (RAWIMU, RAWIMUX");
}

}  // namespace
}  // namespace remount::formats
