#include "model/formats/poses/gpx_track.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>

#include "algorithms/geometry/rotation.h"
#include "algorithms/messages/render.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/findings.h"

namespace remount::formats {
namespace {

// Blanks behind each of very many names were looked through again and again, for minutes.
TEST(gpx_track, a_long_tag_is_refused_in_time) {
  constexpr double kLongest_s = 10.0;
  std::string tag = "<gpx><trkpt";
  for (int i = 0; i < 300'000; ++i) tag += " lat";
  tag += std::string(1'000'000, ' ') + "></trkpt></gpx>";
  const TemporaryFolder folder;
  std::vector<drive::Finding> findings;
  const auto file = folder.write("long.gpx", tag);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_ERROR(read_gpx(file, findings), "holds no track point with a time");
  const double taken_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::printf("  refused in %.3f s\n", taken_s);
  EXPECT_LT(taken_s, kLongest_s);
}

TEST(gpx_track, holds_fixes_with_an_assumed_error) {
  const TemporaryFolder folder;
  std::vector<drive::Finding> findings;
  const std::string head = "<?xml version=\"1.0\"?>\n<gpx version=\"1.1\">\n<trk><trkseg>\n";
  const std::string text =
      head +
      "<trkpt lat=\"48.5\" lon='-9.25'><ele>310.5</ele><time>2026-11-22T10:00:00.5Z</time></trkpt>\n"
      "<trkpt lat=\"48.6\" lon=\"-9.25\"><time>2026-11-22T11:00:01+01:00</time></trkpt>\n"
      "<trkpt lat=\"north\" lon=\"1\"><time>2026-11-22T10:00:02Z</time></trkpt>\n</trkseg></trk></gpx>\n";
  const auto path = folder.write("drive.gpx", text);
  EXPECT_TRUE(recognise_gpx(path));
  const std::vector<motion::GnssFix> fixes = read_gpx(path, findings);
  ASSERT_EQ(fixes.size(), 2U);
  EXPECT_NEAR(radians_to_degrees(fixes[0].latitude_rad), 48.5, 1e-12);
  EXPECT_NEAR(radians_to_degrees(fixes[0].longitude_rad), -9.25, 1e-12);
  EXPECT_DOUBLE_EQ(fixes[0].height_m, 310.5);
  EXPECT_EQ(fixes[1].stamp_ns - fixes[0].stamp_ns, 500'000'000) << "an hour east of Greenwich";
  for (const char* code : {"bad-gpx", "height-missing", "gnss-sigma-assumed"})
    EXPECT_TRUE(testing::has_code(findings, code)) << code;
  EXPECT_TRUE(contains(english(findings[0].explanation), "drive.gpx:6")) << english(findings[0].explanation);
  EXPECT_ERROR(read_gpx(folder.write("none.gpx", head), findings), "holds no track point with a time");
  EXPECT_ERROR(read_gpx(folder.write("cut.gpx", head + "<trkpt lat=\"1\""), findings), "does not end");
}

}  // namespace
}  // namespace remount::formats
