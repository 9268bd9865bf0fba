#include "model/results/input_files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace remount::results {
namespace {

TEST(input_files, are_hashed_relative_to_their_session) {
  const auto folder = std::filesystem::temp_directory_path() / ("remount_hash_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder / "scans");
  std::ofstream(folder / "scans" / "a.bin") << "abc";
  auto session = std::make_shared<drive::Session>();
  session->name = "drive";
  session->path = folder;
  session->files = {folder / "scans" / "a.bin", folder / "gone.csv"};
  Progress progress;
  const auto inputs = hash_inputs({session}, 2, progress);
  ASSERT_EQ(inputs.size(), 2U);
  EXPECT_EQ(inputs[0].file, "scans/a.bin");
  EXPECT_EQ(inputs[0].bytes, 3U);
  EXPECT_EQ(inputs[0].sha256, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(inputs[1].sha256, "");
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace remount::results
