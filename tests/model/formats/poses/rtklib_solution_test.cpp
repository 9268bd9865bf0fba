#include "model/formats/poses/rtklib_solution.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/geodesy/local_level.h"
#include "algorithms/geometry/rotation.h"
#include "algorithms/messages/render.h"
#include "model/formats/files/time_stamp.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

const std::string kRtklibTop =
    "% program   : RTKLIB ver.2.4.3\n% ref pos   : 48.000000000 9.000000000 300.0000\n%\n"
    "% (lat/lon/height=WGS84/ellipsoidal,Q=1:fix,2:float,3:sbas,4:dgps,5:single,6:ppp,ns=# of satellites)\n";
const std::string kGeodeticNames =
    "%  GPST                  latitude(deg) longitude(deg)  height(m)   Q  ns   sdn(m)   sde(m)   sdu(m)  sdne(m)  "
    "sdeu(m)  sdun(m) age(s)  ratio\n";
const std::string kErrors = "  0.0200   0.0100   0.0400   0.0050  -0.0020   0.0010   0.00    9.9\n";

std::vector<motion::GnssFix> read_solution(const std::string& text, std::vector<drive::Finding>& findings) {
  return recognised_and_read("rover.pos", text, recognise_rtklib, read_rtklib, findings);
}

TEST(rtklib_solution, has_places_times_and_correlated_errors) {
  std::vector<drive::Finding> findings;
  const auto fixes = read_solution(
      kRtklibTop + kGeodeticNames + "2023/11/14 22:13:38.500   48.123456789    9.250000000   310.2500   1  12" +
          kErrors + "2288 252819.000   48.123456790    9.250000000   310.2500   2  12" + kErrors,
      findings);
  ASSERT_EQ(fixes.size(), 2U);
  EXPECT_TRUE(findings.empty());
  EXPECT_EQ(fixes[0].stamp_ns, 1'700'000'000'500'000'000) << "GPS time is 18 s ahead";
  EXPECT_EQ(fixes[1].stamp_ns, 1'700'000'001'000'000'000) << "by week and seconds";
  EXPECT_NEAR(radians_to_degrees(fixes[0].latitude_rad), 48.123456789, 1e-12);
  EXPECT_EQ(fixes[0].height_m, 310.25);
  Eigen::Matrix3d expected;  // east, north, up
  expected << 1e-4, 25e-6, -4e-6, 25e-6, 4e-4, 1e-6, -4e-6, 1e-6, 16e-4;
  EXPECT_LT((fixes[0].covariance_enu_m2 - expected).norm(), 1e-15) << fixes[0].covariance_enu_m2;
}

// RTKLIB makes week and seconds of the time in the scale of the head: UTC has no leap seconds in it then.
TEST(rtklib_solution, weeks_and_seconds_are_of_the_scale_of_the_head) {
  const std::pair<std::string, std::string> scales[] = {
      {"GPST", "2288 252818.500"}, {"UTC", "2288 252800.500"}, {"JST", "2288 285200.500"}};
  for (const auto& [scale, time] : scales) {
    std::vector<drive::Finding> findings;
    const auto fixes = read_solution(
        "%  " + scale + " latitude(deg) longitude(deg) height(m) Q ns\n" + time + " 48 9 310 1 12" + kErrors, findings);
    ASSERT_EQ(fixes.size(), 1U) << scale;
    EXPECT_EQ(fixes[0].stamp_ns, 1'700'000'000'500'000'000) << scale;
  }
}

// One place written in the four ways of RTKLIB, at UTC.
TEST(rtklib_solution, all_kinds_of_positions_mean_the_same) {
  std::vector<drive::Finding> findings;
  const std::string time = "2023/11/14 22:13:20.000 ", tail = " 1 12" + kErrors;
  const auto decimal = read_solution(
      "%  UTC latitude(deg) longitude(deg) height(m) Q ns\n" + time + "48.001000000 9.002000000 310.0000" + tail,
      findings);
  const auto sexagesimal = read_solution(
      "%  UTC latitude(d'\") longitude(d'\") height(m) Q ns\n" + time + "48 0 3.60000 9 0 7.20000 310.0000" + tail,
      findings);
  const geodesy::LocalLevel base(degrees_to_radians(48.0), degrees_to_radians(9.0), 300.0);
  const Eigen::Vector3d enu = base.position_enu_m(decimal.at(0));
  char text[200];
  std::snprintf(text, sizeof text, "%.4f,%.4f,%.4f", enu.x(), enu.y(), enu.z());
  const auto baseline = read_solution(
      kRtklibTop + "%  UTC,e-baseline(m),n-baseline(m),u-baseline(m),Q,ns\n" + time + "," + text + tail, findings);
  // Earth-centred by the usual formulas.
  const double a = 6378137.0, f = 1.0 / 298.257223563, e2 = f * (2.0 - f), latitude = decimal[0].latitude_rad,
               longitude = decimal[0].longitude_rad, n = a / std::sqrt(1.0 - e2 * std::pow(std::sin(latitude), 2));
  std::snprintf(text, sizeof text, "%.4f %.4f %.4f", (n + 310.0) * std::cos(latitude) * std::cos(longitude),
                (n + 310.0) * std::cos(latitude) * std::sin(longitude), (n * (1.0 - e2) + 310.0) * std::sin(latitude));
  const auto centred = read_solution(
      "%  UTC x-ecef(m) y-ecef(m) z-ecef(m) Q ns\n" + time + text + " 1 12 0.03 0.03 0.03 0 0 0 0 9\n", findings);
  for (const auto* fixes : {&sexagesimal, &baseline, &centred}) {
    ASSERT_EQ(fixes->size(), 1U);
    EXPECT_EQ(fixes->at(0).stamp_ns, 1'700'000'000'000'000'000);
    EXPECT_NEAR(fixes->at(0).latitude_rad, latitude, 3e-11);
    EXPECT_NEAR(fixes->at(0).longitude_rad, longitude, 3e-11);
    EXPECT_NEAR(fixes->at(0).height_m, 310.0, 2e-4);
  }
  EXPECT_LT((centred[0].covariance_enu_m2 - 9e-4 * Eigen::Matrix3d::Identity()).norm(), 1e-12) << "turned, and round";
  EXPECT_NEAR(baseline[0].covariance_enu_m2(0, 0), 4e-4, 1e-12) << "east comes first in baselines";
}

TEST(rtklib_solution, errors_follow_from_the_quality_where_none_are_stated) {
  std::vector<drive::Finding> findings;
  const auto fixes = read_solution(
      "%  GPST latitude(deg) longitude(deg) height(m) Q ns\n"
      "2288 1.0 48 9 310 1 9\n2288 2.0 48 9 310 5 9\n2288 3.0 48 9 310 0 9\n",
      findings);
  ASSERT_EQ(fixes.size(), 2U);
  EXPECT_NEAR(std::sqrt(fixes[0].covariance_enu_m2(0, 0)), 0.02, 1e-12);
  EXPECT_NEAR(std::sqrt(fixes[1].covariance_enu_m2(0, 0)), 3.0, 1e-12);
  testing::expect_told(findings, "gnss-sigma-assumed", "2 positions state no errors");
  testing::expect_told(findings, "no-fix", "1 line has no solution");
}

TEST(rtklib_solution, broken_lines_are_counted_and_what_is_missing_is_named) {
  const TemporaryFolder folder;
  std::vector<drive::Finding> findings;
  const auto fixes = read_solution(kRtklibTop + kGeodeticNames + "2288 1.0 48 9 310 1 9" + kErrors +
                                       "2288 2.0 48 9\n2288 3.0 95 9 310 1 9" + kErrors + "2288 x 48 9 310 1 9" +
                                       kErrors + "2288 4.0 48 9 310 fix 9" + kErrors,
                                   findings);
  EXPECT_EQ(fixes.size(), 1U);
  testing::expect_told(findings, "bad-gnss", "4 lines cannot be used");
  testing::expect_told(findings, "bad-gnss", "rover.pos:7: has 4 fields, expected 6");
  EXPECT_ERROR(read_rtklib(folder.write("a.pos", "%  UTC e-baseline(m) n-baseline(m) u-baseline(m) Q ns\n"), findings),
               "no line '% ref pos' says where the base is");
  EXPECT_ERROR(read_rtklib(folder.write("a.pos", kRtklibTop + kGeodeticNames), findings), "holds no usable position");
  EXPECT_ERROR(read_rtklib(folder.write("a.pos", "hello\n"), findings), "no line of column names of RTKLIB");
  for (const char* other : {"", "% a comment\n1 2 3\n", "% GPST and more words stand here\n", "GPST latitude(deg)\n"})
    EXPECT_FALSE(recognise_rtklib(folder.write("a.txt", other))) << other;
}

TEST(rtklib_solution, serves_methods_that_need_positions_and_says_what_others_lack) {
  const TemporaryFolder folder;
  std::string text = kRtklibTop + kGeodeticNames, poses;
  for (int i = 0; i < 30; ++i) {
    char line[200];
    std::snprintf(line, sizeof line, "2288 %.3f %.9f 9.0 310.0 1 12", 252818.0 + 0.2 * i, 48.0 + 1e-5 * i);
    text += line + kErrors;
    std::snprintf(line, sizeof line, "%.3f %d 0 0 0 0 0 1\n", 1.7e9 + 0.2 * i, i);
    poses += line;
  }
  folder.write("rover.pos", text);
  folder.write("lidar.txt", poses);
  const drive::Session session = open(folder.path());
  EXPECT_EQ(session.format, "gnss-log");
  EXPECT_EQ(session.gnss.size(), 30U);
  EXPECT_EQ(session.odometry_from_lidar.size(), 30U);
  EXPECT_TRUE(session.ins.empty());
}

}  // namespace
}  // namespace remount::formats
