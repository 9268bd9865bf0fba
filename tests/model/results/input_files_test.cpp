#include "model/results/input_files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
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

// The LiDARs of a recording are sessions of their own, with the same log of the INS.
TEST(input_files, that_several_sessions_have_are_in_the_list_of_each) {
  const auto folder = std::filesystem::temp_directory_path() / ("remount_shared_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder / "front");
  std::ofstream(folder / "ins.csv") << "abc";
  std::ofstream(folder / "front" / "a.bin") << "abc";
  auto front = std::make_shared<drive::Session>();
  front->name = "drive";
  front->path = folder;
  front->files = {folder / "ins.csv", folder / "front" / "a.bin"};
  auto rear = std::make_shared<drive::Session>(*front);
  rear->name = "rear";
  rear->files = {folder / "ins.csv"};
  std::size_t most = 0;
  Progress progress(std::stop_token(), [&](const ProgressUpdate& update) { most = std::max(most, update.total); });
  const auto inputs = hash_inputs({front, rear}, 1, progress);
  ASSERT_EQ(inputs.size(), 3U);
  EXPECT_EQ(inputs[2].session, "rear");
  EXPECT_EQ(inputs[2].file, "ins.csv");
  EXPECT_EQ(inputs[2].sha256, inputs[0].sha256);
  EXPECT_EQ(inputs[2].bytes, 3U);
  EXPECT_EQ(inputs[1].file, "front/a.bin");
  EXPECT_EQ(most, 2U) << "each is read once";
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace remount::results
