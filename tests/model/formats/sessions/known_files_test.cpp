#include "model/formats/sessions/known_files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>

#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

std::string las_of(unsigned char point_format) {
  std::string bytes(400, '\0');
  bytes.replace(0, 4, "LASF");
  bytes[104] = static_cast<char>(point_format);
  return bytes;
}

TEST(known_files, are_named_and_the_way_to_a_session_is_told) {
  const TemporaryFolder folder;
  const std::string rest(200, '\x01');
  const std::tuple<const char*, std::string, const char*> files[] = {
      {"a.pcap", "\xd4\xc3\xb2\xa1", "capture of network packets"},
      {"b.pcapng", "\x0a\x0d\x0d\x0a" + rest, "capture of network packets"},
      {"a.ubx", "\xb5\x62\x01\x07" + rest, "u-blox's binary log"},
      {"a.gps", "\xaa\x44\x12\x1c" + rest, "NovAtel's binary log"},
      {"short.gps", "\xaa\x44\x13\x1c" + rest, "NovAtel's binary log"},
      {"best.log", "#BESTPOSA,COM1,0,1;SOL_COMPUTED*00000000\r\n", "without a whole INSPVAXA, INSPVAA or BESTPOSA"},
      {"a.sbf", std::string("$@\x01\x02\xa7\x0f\x60\x00", 8) + rest, "Septentrio's binary log"},
      {"a.000", "$GRP\x01" + rest, "raw log of an Applanix"},
      {"a.21o", "     3.03           OBSERVATION DATA    M                   RINEX VERSION / TYPE\n", "RINEX"},
      {"00.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 1 0 1 0 0 0 0 1 0\n", "12 numbers a line without times"},
      {"a.las", las_of(3), "a point cloud"},
      {"a.laz", las_of(0x83), "a point cloud"},
      {"a.e57", "ASTM-E57" + rest, "E57"},
      {"a.pcd", "# .PCD v0.7\nVERSION 0.7\n", "a point cloud"},
      {"a.ply", "ply\nformat ascii 1.0\n", "a point cloud"},
      {"zeros.bag", std::string(5000, '\0'), "that does not begin as one"},
      {"other.mcap", "nothing" + rest, "that does not begin as one"},
      {"broken.db3", "SQLite" + rest, "that does not begin as one"},
      {"broken.record", rest, "that does not begin as one"},
      {"people.sqlite", std::string("SQLite format 3\0", 16) + rest, "SQLite database"},
      {"a.zip", "PK\x03\x04" + rest, "an archive"},
      {"a.kml", "<?xml version=\"1.0\"?><kml xmlns=\"x\"></kml>", "KML"},
  };
  for (const auto& [name, bytes, said] : files) {
    const std::filesystem::path written = folder.write(name, bytes);
    const auto known = known_file(written);
    ASSERT_TRUE(known) << name;
    EXPECT_TRUE(contains(english(known->what()), said)) << name << ": " << known->what();
    EXPECT_TRUE(english(known->remedy()).ends_with('.')) << name;
    EXPECT_ERROR(open(written), said);
    EXPECT_ERROR(open(written), english(known->remedy()));
    // The same within a folder that has nothing else.
    const TemporaryFolder alone;
    alone.write(name, bytes);
    EXPECT_ERROR(open(alone.path()), said);
    EXPECT_ERROR(open(alone.path()), std::string("(") + name + ")");
  }
}

TEST(known_files, others_are_not) {
  const TemporaryFolder folder;
  for (const std::string& bytes : {std::string("hello, world\n"), std::string(1000, '\x7f'), std::string("$GP"),
                                   std::string("1 2 3\n"), std::string(2 * 136, '\0'), std::string("\xd3")})
    EXPECT_FALSE(known_file(folder.write("a.dat", bytes))) << bytes.substr(0, 10);
  EXPECT_FALSE(known_file(folder.path() / "missing"));
  EXPECT_ERROR(open(folder.write("a.dat", "hello\n")), "is no session that Remount knows. It looks for:");
}

TEST(known_files, half_a_session_beside_a_file_without_permission_is_none) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read everything";
  const TemporaryFolder folder;
  std::string poses;
  for (int i = 0; i < 20; ++i) poses += std::to_string(100 + i) + " " + std::to_string(i) + " 0 0 0 0 0 1\n";
  folder.write("p/lidar.txt", poses);
  folder.write("p/ins.txt", poses);
  std::filesystem::permissions(folder.path() / "p/ins.txt", std::filesystem::perms::none);
  Progress progress;
  EXPECT_ERROR(open_session(folder.path() / "p", progress), "ins.txt: ");
}

}  // namespace
}  // namespace remount::formats
