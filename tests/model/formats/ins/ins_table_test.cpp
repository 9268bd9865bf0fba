#include "model/formats/ins/ins_table.h"

#include <gtest/gtest.h>

#include "algorithms/geometry/rotation.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/findings.h"

namespace remount::formats {
namespace {

/// In degrees and metres, columns by their names.
InsTableLayout named_layout() {
  InsTableLayout layout;
  layout.time.name = "t", layout.latitude.name = "lat", layout.longitude.name = "lon", layout.height.name = "h";
  layout.position_unit = PlaceUnit::Degrees;
  layout.attitude_unit_rad = degrees_to_radians(1.0);
  layout.yaw_pitch_roll = {ColumnRef{"yaw"}, ColumnRef{"pitch"}, ColumnRef{"roll"}};
  return layout;
}

InsTableLayout numbered_layout() {
  InsTableLayout layout = named_layout();
  std::size_t index = 0;
  for (ColumnRef* column : {&layout.time, &layout.latitude, &layout.longitude, &layout.height,
                            &layout.yaw_pitch_roll[0], &layout.yaw_pitch_roll[1], &layout.yaw_pitch_roll[2]})
    *column = {"", index++};
  return layout;
}

constexpr const char* kTableNames = "t,lat,lon,h,yaw,pitch,roll\n";

// A comma for the point of decimals parts a number: height and angles would be those of the columns before.
TEST(ins_table, rows_with_more_fields_than_most_are_broken) {
  const std::string rows =
      "1.0,48.5,9.2,310,1,2,3\n1.1,48,5,9.2,310,1,2,3\n1.2,48.5,9.2,310,1,2,3,\n1.3,48.5,9.2,310,1,2,3\n";
  for (const bool named : {true, false}) {
    std::vector<drive::Finding> findings;
    const auto samples = parse_ins_table((named ? kTableNames : "") + rows, "ins.csv",
                                         named ? named_layout() : numbered_layout(), findings);
    ASSERT_EQ(samples.size(), 3U) << named;
    for (const motion::InsSample& sample : samples) EXPECT_EQ(sample.height_m, 310.0);
    testing::expect_told(findings, "bad-ins",
                         named ? "ins.csv:3: has 8 fields, expected 7" : "ins.csv:2: has 8 fields, expected 7");
  }
}

TEST(ins_table, all_rows_may_have_a_last_column_without_a_name) {
  std::vector<drive::Finding> findings;
  const auto samples = parse_ins_table(std::string(kTableNames) +
                                           "1.0,48.5,9.2,310,1,2,3,fixed\n1.1,48.5,9.2,310,1,2,3,fixed\n"
                                           "1.2,48,5,9.2,310,1,2,3,fixed\n1.3,48.5,9.2,310,1,2,3,fixed\n",
                                       "ins.csv", named_layout(), findings);
  ASSERT_EQ(samples.size(), 3U);
  for (const motion::InsSample& sample : samples) EXPECT_EQ(sample.height_m, 310.0);
  testing::expect_told(findings, "bad-ins", "ins.csv:4: has 9 fields, expected 8");
}

// All numbers fall apart then, in all rows.
TEST(ins_table, commas_for_the_points_of_decimals_are_no_columns) {
  std::vector<drive::Finding> findings;
  std::string rows = kTableNames;
  for (int i = 0; i < 5; ++i) rows += "1," + std::to_string(i) + ",48,5,9,2,310,0,1,0,2,0,3,0\n";
  EXPECT_ERROR(parse_ins_table(rows, "ins.csv", named_layout(), findings), "has 14 fields, expected 7");
}

}  // namespace
}  // namespace remount::formats
