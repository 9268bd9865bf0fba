#include "model/formats/files/crc32.h"

#include <gtest/gtest.h>

namespace remount::formats {
namespace {

TEST(crc32, is_that_of_the_standards) {
  EXPECT_EQ(crc32("123456789"), 0xcbf43926U);  // the check value of every catalogue of checksums
  EXPECT_EQ(crc32(""), 0U);
  EXPECT_EQ(crc32(std::string(1000, 'x')), 0x3b41c9e6U);
}

TEST(crc32, of_pieces_is_that_of_the_whole) {
  const std::string text = "The quick brown fox jumps over the lazy dog";
  for (std::size_t i = 0; i <= text.size(); ++i) {
    EXPECT_EQ(crc32(text.substr(i), crc32(text.substr(0, i))), crc32(text)) << i;
    EXPECT_EQ(plain_crc32(text.substr(i), plain_crc32(text.substr(0, i))), plain_crc32(text)) << i;
  }
}

}  // namespace
}  // namespace remount::formats
