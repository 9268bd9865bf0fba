// Which parts of a path a report of a fault shows.
#include "app/cli/shown_path.h"

#include <gtest/gtest.h>

namespace remount::cli {
namespace {

TEST(shown_path, is_whole_in_the_home_and_in_folders_of_the_system) {
  EXPECT_EQ(shown_path("/home/alice/.cache/remount", "/home/alice", {}), "~/.cache/remount");
  EXPECT_EQ(shown_path("/home/alice", "/home/alice", {}), "~");
  EXPECT_EQ(shown_path("/home/alice/", "/home/alice/", {}), "~");
  for (const char* path : {"/usr/bin/remount-cli", "/opt/remount/bin/remount-cli", "/tmp", "/tmp/x", "/var/tmp", "/"})
    EXPECT_EQ(shown_path(path, "/home/alice", {}), path);
}

TEST(shown_path, is_the_first_part_elsewhere) {
  EXPECT_EQ(shown_path("/data/vehicle-17-alice/cache", "/home/alice", {}), "/data/…");
  EXPECT_EQ(shown_path("/data", "/home/alice", {}), "/data");
  EXPECT_EQ(shown_path("/home/bob/build/bin/remount-cli", "/home/alice", {}), "/home/…");
  EXPECT_EQ(shown_path("/usr/../data/vehicle-17", "/home/alice", {}), "/data/…");
  EXPECT_EQ(shown_path("/usrlocal/vehicle-17", "/home/alice", {}), "/usrlocal/…");
  EXPECT_EQ(shown_path("/srv/kept-elsewhere", "/srv/kept", {}), "/srv/…") << "its name only begins as the home's";
}

TEST(shown_path, hides_names_wherever_they_stand) {
  EXPECT_EQ(shown_path("/tmp/alice/x/pc-3", "/home/alice", {"alice", "pc-3"}), "/tmp/…/x/…");
  EXPECT_EQ(shown_path("/home/alice/alice/x", "/home/alice", {"alice"}), "~/…/x");
  EXPECT_EQ(shown_path("/alice/x", "/root", {"alice"}), "/…");
  EXPECT_EQ(shown_path("/var/home/bob/x", "/home/alice", {}), "/var/home/…/x");
}

TEST(shown_path, without_a_home_or_a_path_is_nothing_special) {
  EXPECT_EQ(shown_path("", "/home/alice", {}), "");
  EXPECT_EQ(shown_path("/tmp/x", "", {}), "/tmp/x");
  EXPECT_EQ(shown_path("/data/x", "/", {}), "/data/…") << "the root is nobody's home";
}

TEST(shown_path, a_host_is_called_by_its_first_name_too) {
  EXPECT_EQ(names_of_host("pc-3.example.org"), (std::set<std::string>{"pc-3", "pc-3.example.org"}));
  EXPECT_EQ(names_of_host("pc-3"), std::set<std::string>{"pc-3"});
  EXPECT_TRUE(names_of_host("").empty());
}

}  // namespace
}  // namespace remount::cli
