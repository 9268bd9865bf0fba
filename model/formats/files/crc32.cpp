#include "model/formats/files/crc32.h"

#include <array>
#include <cstddef>

namespace remount::formats {
namespace {

constexpr std::size_t kStep = 8;  // bytes at a time: some GB/s, which the disk does not reach
using Tables = std::array<std::array<std::uint32_t, 256>, kStep>;

constexpr Tables make_tables() {
  Tables tables{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    std::uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) value = (value & 1) != 0 ? (value >> 1) ^ 0xEDB88320U : value >> 1;
    tables[0][i] = value;
  }
  for (std::size_t further = 1; further < kStep; ++further)
    for (std::size_t i = 0; i < 256; ++i) {
      const std::uint32_t before = tables[further - 1][i];
      tables[further][i] = (before >> 8) ^ tables[0][before & 0xFF];
    }
  return tables;
}

constexpr Tables kTables = make_tables();

}  // namespace

std::uint32_t plain_crc32(std::string_view bytes, std::uint32_t before) {
  std::uint32_t crc = before;
  const auto at = [&](std::size_t i) { return static_cast<std::uint8_t>(bytes[i]); };
  for (; bytes.size() >= kStep; bytes.remove_prefix(kStep)) {
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < 4; ++i) next ^= kTables[kStep - 1 - i][((crc >> (8 * i)) & 0xFF) ^ at(i)];
    for (std::size_t i = 4; i < kStep; ++i) next ^= kTables[kStep - 1 - i][at(i)];
    crc = next;
  }
  for (std::size_t i = 0; i < bytes.size(); ++i) crc = (crc >> 8) ^ kTables[0][(crc ^ at(i)) & 0xFF];
  return crc;
}

std::uint32_t crc32(std::string_view bytes, std::uint32_t before) { return ~plain_crc32(bytes, ~before); }

}  // namespace remount::formats
