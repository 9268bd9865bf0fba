// Numbers that stand for a value which was not known: left out and counted in every source.
#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/messages/render.h"
#include "model/drive/plausible_values.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/ins/sensor_tables.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/findings.h"

namespace remount::formats {
namespace {

constexpr const char* kNotKnown[] = {"-2e10", "-20000000000", "2e10",    "-349065850.4", "-1145915590261.6",
                                     "1e300", "-9999",        "-99999.0"};

/// A session of 30 samples, of which `broken` replaces one field of every tenth.
drive::Session table_with(const TemporaryFolder& folder, std::size_t column, const std::string& broken) {
  std::string table = "t,lat,lon,h,yaw,pitch,roll,sx,sy,sz\n";
  for (int i = 0; i < 30; ++i) {
    std::vector<std::string> fields{std::to_string(1'700'000'000 + i),
                                    "51.0" + std::to_string(100 + i),
                                    "3.81",
                                    "50.0",
                                    std::to_string(i),
                                    "1.5",
                                    "-0.5",
                                    "0.02",
                                    "0.02",
                                    "0.03"};
    if (i % 10 == 5) fields[column] = broken;
    for (std::size_t k = 0; k < fields.size(); ++k) table += (k ? "," : "") + fields[k];
    table += "\n";
  }
  folder.write("ins.csv", table);
  std::string poses;
  for (int i = 0; i < 30; ++i) poses += std::to_string(1'700'000'000 + i) + " " + std::to_string(i) + " 0 0 0 0 0 1\n";
  folder.write("p.txt", poses);
  folder.write("session.yaml",
               "format: remount-session/1\nname: x\nlidar_poses: {file: p.txt, format: tum}\nins:\n  file: ins.csv\n"
               "  columns:\n    time: {name: t, unit: s, scale: unix}\n    latitude: {name: lat, unit: deg}\n"
               "    longitude: {name: lon, unit: deg}\n    height: {name: h, unit: m}\n"
               "    attitude: {convention: heading, unit: deg, yaw: yaw, pitch: pitch, roll: roll}\n"
               "    position_sigma_m: {east: sx, north: sy, up: sz}\n");
  return open(folder.path());
}

TEST(not_known, places_and_angles_of_a_table_are_left_out_and_counted) {
  const TemporaryFolder folder;
  for (const char* broken : kNotKnown)
    for (std::size_t column = 1; column <= 6; ++column) {
      const drive::Session session = table_with(folder, column, broken);
      EXPECT_EQ(session.ins.size(), 27U) << broken << " in column " << column;
      EXPECT_TRUE(contains(testing::said_of(session.findings, "bad-ins"), "3 lines cannot be used"))
          << broken << column;
    }
  EXPECT_TRUE(contains(testing::said_of(table_with(folder, 5, "-2e10").findings, "bad-ins"),
                       "pitch is '-2e10', which stands for a value that was not known"));
}

TEST(not_known, errors_are_not_stated) {
  const TemporaryFolder folder;
  for (const char* broken : {"-2e10", "2e10"}) {
    const drive::Session session = table_with(folder, 8, broken);
    ASSERT_EQ(session.ins.size(), 30U);
    EXPECT_TRUE(std::isnan(session.ins[5].sigma.position_enu_m.y()));
    EXPECT_NEAR(session.ins[4].sigma.position_enu_m.y(), 0.02, 1e-12);
  }
}

TEST(not_known, a_yaw_that_counts_on_is_known) {
  EXPECT_FALSE(drive::angle_means_not_known(36'000.5)) << "a hundred turns";
  EXPECT_FALSE(drive::angle_means_not_known(998.9));
  for (const double angle : {-2e10, -9999.0, 999.0, 32767.0, -32768.0, std::nan("")})
    EXPECT_TRUE(drive::angle_means_not_known(angle)) << angle;
}

TEST(not_known, rates_fixes_speeds_and_heights_are_left_out_and_counted) {
  const TemporaryFolder folder;
  std::string imu = "time_ns,gyro_x_radps,gyro_y_radps,gyro_z_radps,force_x_mps2,force_y_mps2,force_z_mps2\n",
              gnss = "time_ns,latitude_deg,longitude_deg,height_m,var_east_m2,var_north_m2,var_up_m2\n",
              wheels = "time_ns,rear_left_mps,rear_right_mps\n", barometer = "time_ns,height_m\n";
  for (int i = 0; i < 10; ++i) {
    const std::string time = std::to_string(1'700'000'000'000'000'000 + i * 100'000'000), bad = "-2e10";
    const bool broken = i == 4;
    imu += time + ",0.1," + (broken ? bad : "0.2") + ",0.3,0,0," + (i == 6 ? bad : "9.8") + "\n";
    gnss += time + ",51.0," + (broken ? bad : "3.8") + "," + (i == 6 ? "-9999" : "50") + ",0.01,0.01,0.04\n";
    wheels += time + ",1.0," + (broken ? bad : "1.0") + "\n";
    barometer += time + "," + (broken ? bad : "50") + "\n";
  }
  std::vector<drive::Finding> findings;
  const auto samples = read_imu_table(folder.write("imu.csv", imu), findings);
  EXPECT_EQ(samples.size(), 9U);
  EXPECT_EQ(std::count_if(samples.begin(), samples.end(),
                          [](const motion::ImuSample& sample) { return std::isnan(sample.specific_force_mps2.z()); }),
            1)
      << "a force that is not known leaves the rates";
  EXPECT_EQ(read_gnss_table(folder.write("gnss.csv", gnss), findings).size(), 8U);
  EXPECT_EQ(read_wheel_table(folder.write("wheels.csv", wheels), findings).size(), 9U);
  EXPECT_EQ(read_barometer_table(folder.write("barometer.csv", barometer), findings).size(), 9U);
  for (const char* code : {"bad-imu", "bad-gnss", "bad-wheels", "bad-barometer"})
    EXPECT_NE(testing::said_of(findings, code), "") << code;
}

TEST(not_known, angles_of_inspvax_are_left_out_and_its_errors_not_stated) {
  NovatelValues values;
  values.latitude_deg = 51.0;
  values.longitude_deg = 3.8;
  values.height_m = 50.0;
  values.pitch_std_deg = -2e10;
  values.latitude_std_m = 2e10;
  const motion::InsSample sample = ins_sample(values, "a.log:1");
  EXPECT_TRUE(std::isnan(sample.sigma.attitude_rad.x())) << "pitch is about x in right-forward-up";
  EXPECT_TRUE(std::isnan(sample.sigma.position_enu_m.y()));
  for (double NovatelValues::*const angle :
       {&NovatelValues::roll_deg, &NovatelValues::pitch_deg, &NovatelValues::azimuth_deg}) {
    NovatelValues broken = values;
    broken.*angle = -2e10;
    EXPECT_ERROR(ins_sample(broken, "a.log:1"), "stands for a value that was not known");
  }
}

// Receivers write latitude and longitude 0 where they have none.
TEST(not_known, fixes_far_from_all_others_are_left_out) {
  std::vector<motion::GnssFix> fixes(20);
  for (std::size_t i = 0; i < fixes.size(); ++i)
    fixes[i] = {static_cast<std::int64_t>(i), i == 7 ? 0.0 : 0.9, i == 7 ? 0.0 : 0.07, 50.0,
                Eigen::Matrix3d::Identity()};
  std::vector<drive::Finding> findings;
  drive::keep_near(fixes, "a", findings);
  EXPECT_EQ(fixes.size(), 19U);
  EXPECT_TRUE(contains(testing::said_of(findings, "gnss-far-away"), "1 fix lies more than 2 deg"));
}

TEST(not_known, of_one_stamp_the_better_counts_where_it_says_so) {
  const auto fix = [](double latitude, double sigma_m) {
    return motion::GnssFix{100, latitude, 0.1, 5.0, sigma_m * sigma_m * Eigen::Matrix3d::Identity()};
  };
  for (const bool better_first : {true, false}) {
    std::vector<motion::GnssFix> fixes{better_first ? fix(0.9, 0.02) : fix(0.91, 2.0),
                                       better_first ? fix(0.91, 2.0) : fix(0.9, 0.02)};
    std::vector<drive::Finding> findings;
    drive::keep_ascending(fixes, "gnss", "a", findings);
    ASSERT_EQ(fixes.size(), 1U);
    EXPECT_EQ(fixes[0].latitude_rad, 0.9);
    EXPECT_NE(testing::said_of(findings, "gnss-duplicate-stamps"), "");
    motion::InsSample good, poor;
    good.quality = motion::InsQuality::Good;
    poor.quality = motion::InsQuality::Degraded;
    std::vector<motion::InsSample> ins{better_first ? good : poor, better_first ? poor : good};
    drive::keep_ascending(ins, "ins", "a", findings);
    ASSERT_EQ(ins.size(), 1U);
    EXPECT_EQ(ins[0].quality, motion::InsQuality::Good);
  }
  // Rounded stamps: of ten moments the first has the stamp, though a later one is a little better.
  std::vector<motion::GnssFix> rounded{fix(0.90, 0.021), fix(0.91, 0.020), fix(0.92, 0.019)};
  std::vector<drive::Finding> findings;
  drive::keep_ascending(rounded, "gnss", "a", findings);
  EXPECT_EQ(rounded[0].latitude_rad, 0.90);
}

}  // namespace
}  // namespace remount::formats
