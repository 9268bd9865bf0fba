// How Ouster's sensors lay out their packets of points.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace remount::formats {

/// Where one return stands in the bytes of a pixel.
struct OusterReturn {
  std::uint8_t range_at = 0;
  std::uint8_t range_bits = 19;
  std::uint8_t unit_mm = 1;
  std::uint8_t reflectivity_at = 0;
};

/// An entry of the sensors' setting `udp_profile_lidar`.
struct OusterProfile {
  std::string_view name;
  std::uint8_t pixel_bytes = 0;
  std::uint8_t returns = 1;
  OusterReturn first, second;
  bool legacy() const { return name == "LEGACY"; }
};

std::span<const OusterProfile> ouster_profiles();
/// Null where there is none of that name.
const OusterProfile* ouster_profile(std::string_view name);

/// What stands ahead of the columns, which the settings choose apart from the profile.
enum class OusterHeader { None, Standard, Fusa };

/// A packet: a header, columns of pixels, a footer.
struct OusterLayout {
  OusterHeader header = OusterHeader::Standard;
  std::size_t columns = 16, pixels = 0, pixel_bytes = 0;

  std::size_t header_bytes() const { return header == OusterHeader::None ? 0 : 32; }
  std::size_t column_header_bytes() const { return header == OusterHeader::None ? 16 : 12; }
  std::size_t column_bytes() const {
    return column_header_bytes() + pixels * pixel_bytes + (header == OusterHeader::None ? 4 : 0);
  }
  std::size_t packet_bytes() const { return 2 * header_bytes() + columns * column_bytes(); }
  std::size_t column_at(std::size_t column) const { return header_bytes() + column * column_bytes(); }
  std::size_t pixel_at(std::size_t column, std::size_t pixel) const {
    return column_at(column) + column_header_bytes() + pixel * pixel_bytes;
  }

  // Of a payload of packet_bytes().
  /// Whether it says of itself that it holds points; those without a header do not say.
  bool of_points(std::string_view payload) const;
  std::uint32_t frame(std::string_view payload) const;
  std::uint64_t serial(std::string_view payload) const;          ///< 0: it does not say
  std::uint32_t initialization(std::string_view payload) const;  ///< changes when the sensor starts anew; 0: likewise
  std::uint64_t column_time_ns(std::string_view payload, std::size_t column) const;
  std::uint16_t column_place(std::string_view payload, std::size_t column) const;
  bool column_valid(std::string_view payload, std::size_t column) const;
};

}  // namespace remount::formats
