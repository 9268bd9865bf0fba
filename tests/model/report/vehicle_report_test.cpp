#include "model/report/vehicle_report.h"

#include <gtest/gtest.h>

#include "tests/support/full_records.h"

namespace remount::report {
namespace {

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(vehicle_report, has_each_lidar_and_where_they_sit_against_each_other) {
  Report of_each;
  of_each.created = "2026-11-22 05:00:00 UTC";
  for (const Language language : {Language::English, Language::Chinese}) {
    ReportStyle style;
    style.language = language;
    const std::string page = vehicle_report_html(testing::full_vehicle_file(), of_each, style);
    EXPECT_EQ(count_of(page, "<!DOCTYPE html>"), 1U);
    EXPECT_EQ(count_of(page, "</html>"), 1U);
    EXPECT_EQ(count_of(page, "<h1>"), 3U) << "the vehicle and two LiDARs";
    EXPECT_EQ(count_of(page, of_each.created), 2U);
    EXPECT_NE(page.find("0.1250 ± 0.0020 m"), std::string::npos) << page.substr(0, 3000);
    EXPECT_NE(page.find("-2.0000 ± 0.0020 m"), std::string::npos) << page.substr(0, 3000);
  }
}

TEST(vehicle_report, escapes_what_others_named) {
  results::VehicleFile vehicle = testing::full_vehicle_file();
  vehicle.lidars[0].name = vehicle.relatives[0].lidar_a = "<b>front";
  const std::string page = vehicle_report_html(vehicle, {}, {});
  EXPECT_EQ(page.find("<b>front"), std::string::npos);
  EXPECT_GE(count_of(page, "&lt;b&gt;front"), 3U);
}

}  // namespace
}  // namespace remount::report
