// Folders with many files are listed once.
#include "model/formats/files/listed_files.h"

#include <gtest/gtest.h>

#include "model/formats/files/numbered_file.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

TEST(listed_files, a_folder_is_listed_once_for_all_of_its_files) {
  const TemporaryFolder folder;
  for (const std::size_t i : {0, 1, 3}) folder.write("scans/" + numbered_file({}, i, 6, ".bin").string(), "a");
  std::filesystem::create_directories(folder.path() / "scans/000002.bin");
  ListedFiles listed;
  std::string there;
  for (std::size_t i = 0; i < 1000; ++i)
    if (listed.has(numbered_file(folder.path() / "scans", i, 6, ".bin"))) there += std::to_string(i) + " ";
  EXPECT_EQ(there, "0 1 3 ") << "a folder is no file";
  EXPECT_EQ(listed.count_in(folder.path() / "scans"), 3U);
  EXPECT_FALSE(listed.has(folder.path() / "nowhere/000000.bin"));
  EXPECT_FALSE(listed.has(folder.path() / "nowhere/000001.bin"));
  EXPECT_EQ(listed.listings(), 2U);
}

TEST(listed_files, numbers_have_zeros_in_front_and_are_never_cut) {
  EXPECT_EQ(numbered_file("a", 7, 6, ".bin").string(), "a/000007.bin");
  EXPECT_EQ(numbered_file("a", 1234567, 6, ".bin").string(), "a/1234567.bin");
  EXPECT_EQ(numbered_file("", 7, 10, ".txt").string(), "0000000007.txt");
}

}  // namespace
}  // namespace remount::formats
