#include "model/results/exporters/vehicle_export.h"

#include <gtest/gtest.h>

#include "algorithms/core/error.h"
#include "tests/support/full_records.h"

namespace remount::results {
namespace {

TEST(vehicle_export, one_file_holds_all_where_the_format_can) {
  std::vector<LeftOut> left_out;
  const auto files = export_vehicle(testing::full_vehicle_file(), exporter("urdf"), {}, left_out);
  ASSERT_EQ(files.size(), 1u);
  EXPECT_NE(files[0].text.find("front"), std::string::npos);
  EXPECT_NE(files[0].text.find("rear"), std::string::npos);
}

TEST(vehicle_export, other_formats_have_a_file_for_each_called_after_it) {
  ExportNames names;
  names.lidar_frames["rear"] = "tail";
  std::vector<LeftOut> left_out;
  const auto files = export_vehicle(testing::full_vehicle_file(), exporter("kitti"), names, left_out);
  ASSERT_EQ(files.size(), 2u);
  EXPECT_NE(files[0].name.find("front"), std::string::npos) << files[0].name;
  EXPECT_NE(files[1].name.find("tail"), std::string::npos) << files[1].name;
  EXPECT_NE(files[0].text, files[1].text);
}

TEST(vehicle_export, a_lidar_that_a_format_has_no_place_for_is_left_out_and_named) {
  VehicleFile vehicle = testing::full_vehicle_file();
  ASSERT_FALSE(vehicle.lidars[0].file.result.beams.empty());
  for (LidarResult& lidar : vehicle.lidars) lidar.file.result.status = calibration::Status::Ok;
  vehicle.lidars[1].file.result.beams = {};
  std::vector<LeftOut> left_out;
  const auto files = export_vehicle(vehicle, exporter("beams"), {}, left_out);
  ASSERT_EQ(files.size(), 1u);
  EXPECT_NE(files[0].name.find("front"), std::string::npos) << files[0].name;
  ASSERT_EQ(left_out.size(), 1u);
  EXPECT_EQ(left_out[0].lidar, "rear");
  vehicle.lidars[0].file.result.beams = {};
  EXPECT_THROW((void)export_vehicle(vehicle, exporter("beams"), {}, left_out = {}), Error);
}

TEST(vehicle_export, two_that_would_be_one_file_are_refused) {
  ExportNames names;
  names.lidar_frames["rear"] = "Front";  // the same on systems that know no capital letters in names
  std::vector<LeftOut> left_out;
  EXPECT_THROW((void)export_vehicle(testing::full_vehicle_file(), exporter("kitti"), names, left_out), Error);
}

TEST(vehicle_export, only_files_that_name_frames_can_be_in_that_of_a_lidar) {
  EXPECT_NO_THROW(require_frames(exporter("urdf"), "here"));
  try {
    require_frames(exporter("kitti"), "here");
    FAIL() << "KITTI names no frames";
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "here");
    EXPECT_NE(std::string(error.what()).find("urdf"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace remount::results
