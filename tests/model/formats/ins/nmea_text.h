// Sentences of NMEA 0183 for tests; their checksums are not those of the reader's code.
#pragma once

#include <cstdio>
#include <string>

namespace remount::formats {

/// `body` without '$' and checksum.
inline std::string nmea_line(const std::string& body) {
  unsigned sum = 0;
  for (const char c : body) sum ^= static_cast<unsigned char>(c);
  char end[8];
  std::snprintf(end, sizeof end, "*%02X\r\n", sum);
  return "$" + body + end;
}

}  // namespace remount::formats
