#include "model/formats/bags/growing_chunk.h"

#include <gtest/gtest.h>

#include "model/formats/files/crc32.h"
#include "tests/model/formats/bags/bag_fixtures.h"

namespace remount::bags {
namespace {

constexpr ChunkCompression kGrowingCompressions[] = {ChunkCompression::Bzip2, ChunkCompression::Lz4,
                                                     ChunkCompression::Zstd};

/// Half of it packs, half does not.
std::string chunk_bytes() {
  std::string bytes(3'000'000, 'a');
  std::uint32_t state = 1;
  for (std::size_t i = 0; i < bytes.size(); ++i)
    if (i / 1000 % 2 == 0) bytes[i] = static_cast<char>((state = state * 1664525U + 1013904223U) >> 24);
  return bytes;
}

/// A file that is one chunk, and nothing small about it.
std::unique_ptr<const ChunkStore> store_of(const fs::path& path, const std::string& packed,
                                           ChunkCompression compression, std::uint32_t checksum, std::uint64_t bytes) {
  std::ofstream(path, std::ios::binary) << packed;
  auto store = std::make_unique<ChunkStore>(path, path, 0);
  store->add({0, packed.size(), bytes, compression, false, checksum});
  return store;
}

TEST(growing_chunk, gives_the_same_bytes_wherever_it_is_read) {
  const formats::TemporaryFolder folder;
  const std::string bytes = chunk_bytes();
  for (const ChunkCompression compression : kGrowingCompressions) {
    const auto store =
        store_of(folder.path() / "a", pack_chunk(compression, bytes), compression, formats::crc32(bytes), bytes.size());
    const auto chunk = store->source(0);
    EXPECT_EQ(chunk->size(), bytes.size());
    for (const std::uint64_t at : {5u, 0u, 70'000u, 65'536u, 1'500'000u, 12u, 2'999'990u})
      EXPECT_EQ(chunk->read(at, 10), bytes.substr(at, 10)) << at;
    EXPECT_EQ(chunk->read(0, bytes.size()), bytes);
    EXPECT_ERROR(chunk->read(bytes.size() - 5, 6), "the chunk holds");
    store->check(0);
  }
}

TEST(growing_chunk, of_two_frames_is_both_of_them) {
  const formats::TemporaryFolder folder;
  const std::string bytes = chunk_bytes();
  const std::string packed = pack_chunk(ChunkCompression::Zstd, bytes) + pack_chunk(ChunkCompression::Zstd, bytes);
  const auto store = store_of(folder.path() / "a", packed, ChunkCompression::Zstd, 0, 2 * bytes.size());
  EXPECT_EQ(store->source(0)->read(0, 2 * bytes.size()), bytes + bytes);
}

TEST(growing_chunk, that_is_damaged_or_cut_is_refused_from_there_on_and_once) {
  const formats::TemporaryFolder folder;
  const std::string bytes = chunk_bytes();
  for (const ChunkCompression compression : kGrowingCompressions) {
    const std::string packed = pack_chunk(compression, bytes);
    std::string broken = packed;
    broken.replace(broken.size() * 3 / 4, 5000, 5000, '\xff');
    for (const std::string& bad : {broken, packed.substr(0, packed.size() * 3 / 4)}) {
      const auto store = store_of(folder.path() / "a", bad, compression, formats::crc32(bytes), bytes.size());
      EXPECT_EQ(store->source(0)->read(100, 10), bytes.substr(100, 10)) << "its beginning can be read";
      EXPECT_ERROR(store->check(0), "damaged");
      EXPECT_ERROR(store->source(0), "damaged");  // is not unpacked again
    }
    const auto wrong = store_of(folder.path() / "a", packed, compression, formats::crc32(bytes) + 1, bytes.size());
    EXPECT_EQ(wrong->source(0)->read(100, 10), bytes.substr(100, 10));
    EXPECT_ERROR(wrong->check(0), "checksum of the chunk");
    const auto lie = store_of(folder.path() / "a", packed, compression, 0, bytes.size() + 1);
    EXPECT_ERROR(lie->check(0), "damaged");
  }
}

}  // namespace
}  // namespace remount::bags
