#include "model/formats/files/crc32.h"

#include <cstddef>

namespace remount::formats {
namespace {

constexpr std::size_t kStep = 8;  // bytes at a time: some GB/s, which the disk does not reach
/// Plain arrays: where nothing is inlined, as under the sanitizers, every element of a std::array is a call.
struct Tables {
  std::uint32_t of[kStep][256];
};

constexpr Tables make_tables() {
  Tables tables{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    std::uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) value = (value & 1) != 0 ? (value >> 1) ^ 0xEDB88320U : value >> 1;
    tables.of[0][i] = value;
  }
  for (std::size_t further = 1; further < kStep; ++further)
    for (std::size_t i = 0; i < 256; ++i) {
      const std::uint32_t before = tables.of[further - 1][i];
      tables.of[further][i] = (before >> 8) ^ tables.of[0][before & 0xFF];
    }
  return tables;
}

constexpr Tables kTables = make_tables();

}  // namespace

std::uint32_t plain_crc32(std::string_view bytes, std::uint32_t before) {
  std::uint32_t crc = before;
  const auto* at = reinterpret_cast<const unsigned char*>(bytes.data());
  std::size_t left = bytes.size();
  for (; left >= kStep; left -= kStep, at += kStep) {
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < 4; ++i) next ^= kTables.of[kStep - 1 - i][((crc >> (8 * i)) & 0xFF) ^ at[i]];
    for (std::size_t i = 4; i < kStep; ++i) next ^= kTables.of[kStep - 1 - i][at[i]];
    crc = next;
  }
  for (std::size_t i = 0; i < left; ++i) crc = (crc >> 8) ^ kTables.of[0][(crc ^ at[i]) & 0xFF];
  return crc;
}

std::uint32_t crc32(std::string_view bytes, std::uint32_t before) { return ~plain_crc32(bytes, ~before); }

}  // namespace remount::formats
