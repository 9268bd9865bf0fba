#include "model/formats/files/text_file.h"

#include <gtest/gtest.h>

#include "model/formats/documents/parse_document.h"
#include "model/formats/ins/nmea_log.h"
#include "model/formats/ins/novatel_log.h"
#include "model/formats/poses/gpx_track.h"
#include "model/formats/poses/pose_file.h"
#include "model/formats/sessions/gnss_log_reader.h"
#include "tests/model/formats/ins/nmea_text.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

/// Of Latin letters alone, and what is given as code units.
std::string utf16_of(std::string_view latin, bool little_endian, bool mark) {
  std::string bytes;
  const auto add = [&](unsigned unit) {
    const char high = static_cast<char>(unit >> 8U), low = static_cast<char>(unit & 0xFFU);
    bytes += little_endian ? low : high;
    bytes += little_endian ? high : low;
  };
  if (mark) add(0xFEFF);
  for (const char c : latin) add(static_cast<unsigned char>(c));
  return bytes;
}

/// Every way in which programs write a text.
std::vector<std::string> encodings_of(const std::string& text) {
  return {text,
          "\xEF\xBB\xBF" + text,
          utf16_of(text, true, true),
          utf16_of(text, false, true),
          utf16_of(text, true, false),
          utf16_of(text, false, false)};
}

TEST(text_file, is_the_same_in_every_encoding) {
  for (const std::string& bytes : encodings_of("time,lat\r\n1,2\n")) EXPECT_EQ(utf8_text(bytes), "time,lat\r\n1,2\n");
  EXPECT_EQ(utf8_text(std::string("\xFF\xFE\xAC\x20\x3D\xD8\x97\xDE", 8)), "\xE2\x82\xAC\xF0\x9F\x9A\x97")
      << "a euro and a car";
  EXPECT_EQ(utf8_text(std::string("\xFF\xFE\x3D\xD8", 4)), "\xEF\xBF\xBD") << "half a pair";
  EXPECT_EQ(utf8_text(std::string("\xFF\xFE"
                                  "a\0b",
                                  5)),
            "a\xEF\xBF\xBD")
      << "half a character";
  EXPECT_EQ(utf8_text(std::string("\0\x01\0\x02", 4)), std::string("\0\x01\0\x02", 4)) << "no text";
  EXPECT_EQ(utf8_text(""), "");
}

std::string gpx_of(const std::string& prefix) {
  std::string text = "<?xml version=\"1.0\"?>\n<" + prefix + "gpx version=\"1.1\"" +
                     (prefix.empty() ? "" : " xmlns:" + prefix.substr(0, prefix.size() - 1) + "=\"x\"") + ">\n<" +
                     prefix + "trk><" + prefix + "trkseg>\n";
  for (int i = 0; i < 5; ++i)
    text += "<" + prefix + "trkpt lat=\"48.5\" lon=\"9.25000" + std::to_string(i) + "\"><" + prefix + "ele>31" +
            std::to_string(i) + "</" + prefix + "ele><" + prefix + "time>2026-11-22T10:00:0" + std::to_string(i) +
            "Z</" + prefix + "time><extensions><other:time>never</other:time></extensions></" + prefix + "trkpt>\n";
  return text + "</" + prefix + "trkseg></" + prefix + "trk></" + prefix + "gpx>\n";
}

TEST(text_file, of_a_track_has_its_points_whatever_the_prefix_and_the_encoding) {
  const TemporaryFolder folder;
  for (const char* prefix : {"", "ns2:", "gpx_1.1-a:"})
    for (const std::string& bytes : encodings_of(gpx_of(prefix))) {
      const auto path = folder.write("drive.gpx", bytes);
      EXPECT_TRUE(recognise_gpx(path)) << prefix;
      std::vector<drive::Finding> findings;
      const std::vector<motion::GnssFix> fixes = read_gpx(path, findings);
      ASSERT_EQ(fixes.size(), 5U) << prefix;
      EXPECT_DOUBLE_EQ(fixes[3].height_m, 313.0);
      EXPECT_EQ(fixes[4].stamp_ns - fixes[0].stamp_ns, 4'000'000'000);
    }
  EXPECT_FALSE(recognise_gpx(folder.write("a.xml", "<?xml version=\"1.0\"?><gpxtool/>")));
}

TEST(text_file, of_a_track_gives_the_better_fix_of_a_time_in_either_order) {
  const TemporaryFolder folder;
  const std::string worse = "<trkpt lat=\"48.6\" lon=\"9\"><time>2026-11-22T10:00:00Z</time><fix>2d</fix></trkpt>\n",
                    better = "<trkpt lat=\"48.5\" lon=\"9\"><time>2026-11-22T10:00:00Z</time><fix>dgps</fix></trkpt>\n",
                    none = "<trkpt lat=\"48.7\" lon=\"9\"><time>2026-11-22T10:00:01Z</time><fix>none</fix></trkpt>\n";
  for (const std::string& points : {worse + better, better + worse}) {
    std::vector<drive::Finding> findings;
    const std::vector<motion::GnssFix> fixes =
        read_gpx(folder.write("a.gpx", "<gpx>" + points + none + "</gpx>"), findings);
    ASSERT_EQ(fixes.size(), 1U);
    EXPECT_NEAR(radians_to_degrees(fixes[0].latitude_rad), 48.5, 1e-9);
  }
}

TEST(text_file, of_logs_poses_tables_and_manifests_is_read_in_every_encoding) {
  const TemporaryFolder folder;
  std::string nmea = nmea_line("GPRMC,120000.00,A,,,,,,,211126,,,A"), poses;
  for (int i = 0; i < 20; ++i) {
    char line[120];
    std::snprintf(line, sizeof line, "GNGGA,1200%05.2f,4846.1,N,00911.5,E,4,12,0.8,250.0,M,48.0,M,,", 0.1 * i);
    nmea += nmea_line(line);
    std::snprintf(line, sizeof line, "%d.5 %d 0 0 0 0 0 1\n", 1700000000 + i, i);
    poses += line;
  }
  const std::string log = inspvaxa(2183, 1.0, 90.0) + inspvaxa(2183, 1.1, 91.0);
  const std::string table = "time_ns,gyro_x_radps,gyro_y_radps,gyro_z_radps\n1,0,0,0\n2,0,0,0\n";
  const std::string manifest =
      "format: remount-session/1\nname: d\nlidar_poses: {file: p.txt, format: tum}\nimu: {file: i.csv}\n";
  for (std::size_t i = 0; i < encodings_of("").size(); ++i) {
    std::vector<drive::Finding> findings;
    EXPECT_EQ(read_nmea(folder.write("a.nmea", encodings_of(nmea)[i]), findings).fixes.size(), 20U) << i;
    EXPECT_TRUE(recognise_nmea(folder.path() / "a.nmea")) << i;
    const auto inspvax = folder.write("a.log", encodings_of(log)[i]);
    EXPECT_EQ(recognise_novatel(inspvax), NovatelFormat::Log) << i;
    EXPECT_EQ(read_novatel(inspvax, NovatelFormat::Log, findings).ins.size(), 2U) << i;
    const auto pose_file = folder.write("s/p.txt", encodings_of(poses)[i]);
    ASSERT_TRUE(recognise_pose_file(pose_file)) << i;
    folder.write("s/i.csv", encodings_of(table)[i]);
    folder.write("s/session.yaml", encodings_of(manifest)[i]);
    const drive::Session session = open(folder.path() / "s");
    EXPECT_EQ(session.format, "native") << i;
    EXPECT_EQ(session.odometry_from_lidar.size(), 20U) << i;
    EXPECT_EQ(session.imu.size(), 2U) << i;
  }
}

}  // namespace
}  // namespace remount::formats
