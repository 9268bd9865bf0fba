// CRC-32 with the polynomial 0x04C11DB7, reflected: the checksum of MCAP, zlib and, without inversions, NovAtel.
#pragma once

#include <cstdint>
#include <string_view>

namespace remount::formats {

/// As zlib's. @param before what came out for the bytes before these; 0 at the beginning
std::uint32_t crc32(std::string_view bytes, std::uint32_t before = 0);

/// Without the usual inversions before and after: as NovAtel's logs have it.
std::uint32_t plain_crc32(std::string_view bytes, std::uint32_t before = 0);

}  // namespace remount::formats
