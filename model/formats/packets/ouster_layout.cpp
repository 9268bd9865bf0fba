#include "model/formats/packets/ouster_layout.h"

#include <algorithm>

#include "model/formats/files/number_bytes.h"

namespace remount::formats {

namespace {

constexpr OusterReturn kRange20{0, 20, 1, 4}, kRange19{0, 19, 1, 4}, kPacked19{0, 19, 1, 3}, kSecond19{4, 19, 1, 7},
    kRange15{0, 15, 8, 2}, kSecond15{4, 15, 8, 6};

constexpr OusterProfile kOusterProfiles[] = {
    {"LEGACY", 12, 1, kRange20, {}},
    {"RNG19_RFL8_SIG16_NIR16", 12, 1, kRange19, {}},
    {"RNG19_RFL8_SIG16_NIR16_DUAL", 16, 2, kPacked19, kSecond19},
    {"RNG15_RFL8_NIR8", 4, 1, kRange15, {}},
    {"RNG15_RFL8_WIN8", 4, 1, kRange15, {}},
    {"RNG15_RFL8_NIR8_DUAL", 8, 2, kRange15, kSecond15},
    {"FUSA_RNG15_RFL8_NIR8_DUAL", 8, 2, kRange15, kSecond15},
    {"RNG15_RFL8_NIR8_ZONE16", 8, 1, kRange15, {}},
    {"RNG19_RFL8_SIG16_NIR16_ZONE16", 12, 1, kRange19, {}},
    {"RNG19_RFL8_SIG16_ZONE16_DUAL", 16, 2, kPacked19, kSecond19},
    {"RNG19_RFL8_SIG16_NIR16_RGB16", 16, 1, kPacked19, {}},
    {"RNG19_RFL8_SIG16_NIR16_RGB16_DUAL", 20, 2, kPacked19, kSecond19},
    {"FIVE_WORD_PIXEL", 20, 2, kPacked19, kSecond19},
};

/// A number of a few bytes, least significant first.
std::uint64_t few_bytes(std::string_view payload, std::size_t at, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < count; ++i)
    value |= static_cast<std::uint64_t>(static_cast<unsigned char>(payload[at + i])) << (8 * i);
  return value;
}

}  // namespace

std::span<const OusterProfile> ouster_profiles() { return kOusterProfiles; }

const OusterProfile* ouster_profile(std::string_view name) {
  const auto found = std::ranges::find(kOusterProfiles, name, &OusterProfile::name);
  return found == std::end(kOusterProfiles) ? nullptr : found;
}

bool OusterLayout::of_points(std::string_view payload) const {
  constexpr std::uint64_t kPoints = 1;  // 2 are those of the IMU
  return header == OusterHeader::None || few_bytes(payload, 0, header == OusterHeader::Fusa ? 1 : 2) == kPoints;
}

std::uint32_t OusterLayout::frame(std::string_view payload) const {
  switch (header) {
    case OusterHeader::None:
      return little_number<std::uint16_t>(payload, 10);  // in every column
    case OusterHeader::Standard:
      return little_number<std::uint16_t>(payload, 2);
    case OusterHeader::Fusa:
      return little_number<std::uint32_t>(payload, 4);
  }
  return 0;
}

std::uint64_t OusterLayout::serial(std::string_view payload) const {
  constexpr std::size_t kSerialBytes = 5;
  if (header == OusterHeader::None) return 0;
  return few_bytes(payload, header == OusterHeader::Fusa ? 11 : 7, kSerialBytes);
}

std::uint32_t OusterLayout::initialization(std::string_view payload) const {
  constexpr std::size_t kInitializationBytes = 3;
  if (header == OusterHeader::None) return 0;
  return static_cast<std::uint32_t>(few_bytes(payload, header == OusterHeader::Fusa ? 1 : 4, kInitializationBytes));
}

std::uint64_t OusterLayout::column_time_ns(std::string_view payload, std::size_t column) const {
  return little_number<std::uint64_t>(payload, column_at(column));
}

std::uint16_t OusterLayout::column_place(std::string_view payload, std::size_t column) const {
  return little_number<std::uint16_t>(payload, column_at(column) + 8);
}

bool OusterLayout::column_valid(std::string_view payload, std::size_t column) const {
  const std::size_t at = header == OusterHeader::None ? column_at(column) + column_bytes() - 4 : column_at(column) + 10;
  return (few_bytes(payload, at, 1) & 1U) != 0;
}

}  // namespace remount::formats
