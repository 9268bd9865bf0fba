#include "model/drive/stamped_streams.h"

#include <gtest/gtest.h>

#include "algorithms/geometry/rotation.h"
#include "algorithms/messages/render.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::drive {
namespace {

std::vector<motion::InsSample> drive_at(double longitude_deg, int count = 20) {
  std::vector<motion::InsSample> ins(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    ins[static_cast<std::size_t>(i)].stamp_ns = 1'600'000'000'000'000'000 + i * 10'000'000LL;
    ins[static_cast<std::size_t>(i)].latitude_rad = degrees_to_radians(48.0 + 1e-6 * i);
    ins[static_cast<std::size_t>(i)].longitude_rad = wrap_angle_rad(degrees_to_radians(longitude_deg + 1e-4 * i));
  }
  return ins;
}

TEST(stamped_streams, samples_far_from_the_drive_are_left_out_and_counted) {
  std::vector<Finding> findings;
  for (const double longitude_deg : {9.0, 179.9995}) {
    findings.clear();
    std::vector<motion::InsSample> ins = drive_at(longitude_deg);
    keep_near(ins, "ins.csv", findings);
    EXPECT_EQ(ins.size(), 20U) << "also across the date line";
    EXPECT_TRUE(findings.empty());
    ins[0].longitude_rad = degrees_to_radians(250.857);
    ins[7].latitude_rad = 0.0;
    keep_near(ins, "ins.csv", findings);
    EXPECT_EQ(ins.size(), 18U);
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_EQ(findings[0].code, "ins-far-away");
    EXPECT_TRUE(formats::contains(english(findings[0].explanation), "2 samples")) << english(findings[0].explanation);
  }
}

TEST(stamped_streams, stamps_that_are_no_time_are_left_out_before_they_are_compared) {
  std::vector<Finding> findings;
  std::vector<motion::InsSample> ins = drive_at(9.0);
  ins[3].stamp_ns = std::numeric_limits<std::int64_t>::max();
  ins[4].stamp_ns = std::numeric_limits<std::int64_t>::min();
  keep_ascending(ins, "ins", "ins.csv", findings);
  EXPECT_EQ(ins.size(), 18U);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].code, "ins-impossible-stamps");
  for (motion::InsSample& sample : ins) sample.stamp_ns = std::numeric_limits<std::int64_t>::max();
  EXPECT_ERROR(keep_ascending(ins, "ins", "ins.csv", findings), "ins.csv: no entry has a possible time");
}

}  // namespace
}  // namespace remount::drive
