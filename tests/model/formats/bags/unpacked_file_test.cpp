#include "model/formats/bags/unpacked_file.h"

#include <gtest/gtest.h>

#include "model/formats/bags/chunk_codec.h"
#include "tests/model/formats/bags/bag_fixtures.h"
#include "tests/support/temporary_files_in.h"

namespace remount::bags {
namespace {

// Pieces are of 4 MiB: a file that fills the last one to its end is not cut.
TEST(unpacked_file, of_any_length_is_whole) {
  const formats::TemporaryFolder folder;
  Progress progress;
  constexpr std::size_t kPiece = std::size_t{4} << 20;
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, kPiece - 1, kPiece, kPiece + 1, 2 * kPiece}) {
    std::string bytes(size, 'x');
    for (std::size_t i = 0; i < size; i += 4096) bytes[i] = static_cast<char>(i >> 12);
    const auto packed = folder.write("a.db3.zstd", pack_chunk(ChunkCompression::Zstd, bytes));
    const UnpackedFile unpacked(packed, progress);
    EXPECT_TRUE(formats::bytes_of(unpacked.path()) == bytes) << size;
  }
}

TEST(unpacked_file, of_two_frames_is_both_of_them) {
  const formats::TemporaryFolder folder;
  Progress progress;
  const std::string one(std::size_t{4} << 20, 'a'), other = "the end";
  const auto packed =
      folder.write("a.db3.zstd", pack_chunk(ChunkCompression::Zstd, one) + pack_chunk(ChunkCompression::Zstd, other));
  EXPECT_TRUE(formats::bytes_of(UnpackedFile(packed, progress).path()) == one + other);
}

TEST(unpacked_file, left_by_a_process_that_was_killed_is_removed_by_the_next) {
  const formats::TemporaryFolder folder;
  Progress progress;
  const auto packed = folder.write("a.db3.zstd", pack_chunk(ChunkCompression::Zstd, "some bytes"));
  const std::filesystem::path there = folder.path() / "temporary";
  std::filesystem::create_directory(there);
  const testing::TemporaryFilesIn unpacked_in(there);
  const auto left = folder.write("temporary/remount-bag-abcdef", "of a killed process"),
             other = folder.write("temporary/somebody-elses", "bytes");
  const UnpackedFile living(packed, progress);
  EXPECT_FALSE(std::filesystem::exists(left));
  EXPECT_TRUE(std::filesystem::exists(other));
  const UnpackedFile second(packed, progress);
  EXPECT_EQ(formats::bytes_of(living.path()), "some bytes") << "the first is still in use";
}

TEST(unpacked_file, without_a_folder_for_it_says_which_to_set) {
  const formats::TemporaryFolder folder;
  Progress progress;
  const auto packed = folder.write("a.db3.zstd", pack_chunk(ChunkCompression::Zstd, "some bytes"));
  const testing::TemporaryFilesIn none(folder.path() / "none");
  EXPECT_ERROR(UnpackedFile(packed, progress), "set TMPDIR");
  for (const char* name : {"a.db3.zstd", "a.mcap.zst", "a.bag"}) {
    SCOPED_TRACE(name);
    const auto any = folder.write(name, pack_chunk(ChunkCompression::Zstd, "some bytes"));
    EXPECT_ERROR(UnpackedFile(any, progress), "or unpack it with 'zstd -d'");
    const auto database = folder.write(std::string("plain/") + name, "SQLite format 3");
    EXPECT_ERROR(UnpackedFile({database, database}, progress), "or copy the bag to a folder that can be written");
  }
}

}  // namespace
}  // namespace remount::bags
