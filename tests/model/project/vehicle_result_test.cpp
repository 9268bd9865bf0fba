#include "model/project/vehicle_result.h"

#include <gtest/gtest.h>

#include "tests/support/full_records.h"

namespace remount::project {
namespace {

TEST(vehicle_result, names_what_the_calibration_knows_by_places) {
  const motion::LidarIndex front(0), rear(1), roof(2);
  std::vector<rig::LidarJob> jobs(3);
  rig::RigOutput output;
  for (const char* name : {"front", "rear", "roof"}) output.lidars.push_back({name, testing::full_output(), true});
  output.lidars[1].joined = false;
  calibration::RelativeMounting two;
  two.lidar_a = front, two.lidar_b = roof;
  two.lidar_a_from_lidar_b = rigid_from_six({1, 2, 3, 0.1, 0.2, 0.3});
  two.covariance = Vector6d(4e-6, 9e-6, 1e-6, 1e-8, 4e-8, 9e-8).asDiagonal();
  two.observed = {calibration::Parameter::X, calibration::Parameter::Roll};
  two.height_m = 3.5, two.height_sigma_m = 0.001;
  output.relatives = {two};
  output.agreements = {{roof, rear, Vector6d::Constant(0.5), Vector6d::Constant(0.25), 2.0}};
  output.groups = {{front, roof}, {rear}};
  output.findings = testing::full_findings();

  const results::VehicleFile file = make_vehicle_file(jobs, output, {{}, testing::full_result_file().inputs});
  EXPECT_EQ(results::lidar_names(file), (std::vector<std::string>{"front", "rear", "roof"}));
  EXPECT_TRUE(file.lidars[0].joined);
  EXPECT_FALSE(file.lidars[1].joined);
  EXPECT_EQ(file.lidars[0].file.pairs.size(), testing::full_output().pairs.size());
  EXPECT_TRUE(file.lidars[0].file.inputs.empty());
  EXPECT_EQ(file.lidars[1].file.inputs.size(), 2U);
  ASSERT_EQ(file.relatives.size(), 1U);
  EXPECT_EQ(file.relatives[0].lidar_b, "roof");
  EXPECT_DOUBLE_EQ(file.relatives[0].sigma[calibration::Parameter::X].value(), 2e-3);
  EXPECT_DOUBLE_EQ(file.relatives[0].sigma[calibration::Parameter::Roll].value(), 3e-4);
  EXPECT_FALSE(file.relatives[0].sigma[calibration::Parameter::Z]);
  EXPECT_EQ(file.relatives[0].height_m, 3.5);
  ASSERT_EQ(file.agreements.size(), 1U);
  EXPECT_EQ(file.agreements[0].lidar_a + file.agreements[0].lidar_b, "roofrear");
  EXPECT_EQ(file.groups, (std::vector<std::vector<std::string>>{{"front", "roof"}, {"rear"}}));
  EXPECT_EQ(file.findings.size(), 2U);
  EXPECT_FALSE(file.version.empty());
}

}  // namespace
}  // namespace remount::project
