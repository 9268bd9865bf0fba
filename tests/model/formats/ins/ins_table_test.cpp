#include "model/formats/ins/ins_table.h"

#include <gtest/gtest.h>

#include "algorithms/geometry/rotation.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/findings.h"

namespace remount::formats {
namespace {

// A comma for the point of decimals parts a number: height and angles would be those of the columns before.
TEST(ins_table, rows_with_more_fields_than_names_are_broken) {
  InsTableLayout layout;
  layout.time.name = "t", layout.latitude.name = "lat", layout.longitude.name = "lon", layout.height.name = "h";
  layout.position_unit_rad = layout.attitude_unit_rad = degrees_to_radians(1.0);
  layout.yaw_pitch_roll = {ColumnRef{"yaw"}, ColumnRef{"pitch"}, ColumnRef{"roll"}};
  std::vector<drive::Finding> findings;
  const auto samples = parse_ins_table(
      "t,lat,lon,h,yaw,pitch,roll\n"
      "1.0,48.5,9.2,310,1,2,3\n1.1,48,5,9.2,310,1,2,3\n1.2,48.5,9.2,310,1,2,3,\n1.3,48.5,9.2,310,1,2,3\n",
      "ins.csv", layout, findings);
  ASSERT_EQ(samples.size(), 3U);
  for (const motion::InsSample& sample : samples) EXPECT_EQ(sample.height_m, 310.0);
  EXPECT_TRUE(contains(testing::said_of(findings, "bad-ins"), "ins.csv:3: has 8 fields, expected 7"))
      << testing::said_of(findings, "bad-ins");
}

}  // namespace
}  // namespace remount::formats
