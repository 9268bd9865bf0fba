// Packets of NCOM for tests and samples.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>

namespace remount::formats {

/// One packet; status channel 0 with the minutes, unless another is set.
struct NcomRecord {
  int status = 4;
  int millisecond = 30'000;
  double latitude_rad = 0.9, longitude_rad = 0.16, height_m = 310.0;
  double heading_rad = 0.0, pitch_rad = 0.0, roll_rad = 0.0;
  int channel = 0;
  std::int32_t minutes = 23'067'253;       ///< since 6 January 1980: 2023-11-14 22:13 by GPS
  std::uint16_t errors[3] = {10, 20, 30};  ///< of channels 3 and 5
  std::uint8_t age = 0;                    ///< of these errors

  std::string bytes() const {
    std::string packet(72, '\0');
    const auto put = [&](std::size_t at, auto value) { std::memcpy(packet.data() + at, &value, sizeof value); };
    const auto angle = [&](std::size_t at, double rad) {
      const auto units = static_cast<std::int32_t>(std::lround(rad * 1e6));
      std::memcpy(packet.data() + at, &units, 3);  // least significant byte first
    };
    packet[0] = '\xe7';
    put(1, static_cast<std::uint16_t>(millisecond));
    packet[21] = static_cast<char>(status);
    put(23, latitude_rad), put(31, longitude_rad), put(39, static_cast<float>(height_m));
    angle(52, heading_rad), angle(55, pitch_rad), angle(58, roll_rad);
    packet[62] = static_cast<char>(channel);
    if (channel == 0) put(63, minutes);
    if (channel == 3 || channel == 5) {
      for (std::size_t i = 0; i < 3; ++i) put(63 + 2 * i, errors[i]);
      packet[69] = static_cast<char>(age);
    }
    for (const std::size_t end : {22U, 61U, 71U}) {  // sums of all bytes before them but the first
      unsigned sum = 0;
      for (std::size_t i = 1; i < end; ++i) sum += static_cast<unsigned char>(packet[i]);
      packet[end] = static_cast<char>(sum & 0xffU);
    }
    return packet;
  }
};

}  // namespace remount::formats
