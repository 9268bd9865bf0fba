// Numbers at places of bytes, in either byte order.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace remount::formats {

inline std::uint8_t byte_at(std::string_view bytes, std::size_t at) { return static_cast<std::uint8_t>(bytes[at]); }

/// The number at `at`, which the bytes hold: callers look at sizes first. @param big most significant byte first
template <class T>
T number_in(std::string_view bytes, std::size_t at, bool big) {
  T value = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    const auto byte = static_cast<T>(static_cast<unsigned char>(bytes[at + i]));
    value = static_cast<T>(value | static_cast<T>(byte << (8U * (big ? sizeof(T) - 1 - i : i))));
  }
  return value;
}

/// As networks have it: most significant byte first.
template <class T>
T network_number(std::string_view bytes, std::size_t at) {
  return number_in<T>(bytes, at, true);
}

/// As those have it that write their memory out: least significant byte first. Of floating point numbers as well.
template <class T>
T little_number(std::string_view bytes, std::size_t at) {
  static_assert(std::endian::native == std::endian::little, "swap bytes here");
  T value{};
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

}  // namespace remount::formats
