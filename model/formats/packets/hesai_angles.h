// Angles that Hesai measured of one sensor: a table beside its packets.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "model/formats/packets/packet_decoder.h"

namespace remount::formats {

/// Degrees of each channel, in their order.
struct HesaiAngles {
  std::filesystem::path file;
  std::vector<double> elevations_deg, azimuths_deg;
  bool same_as(const HesaiAngles& other) const {
    return elevations_deg == other.elevations_deg && azimuths_deg == other.azimuths_deg;
  }
};

/// "Laser id,Elevation,Azimuth" (or Channel) and a line for each channel, as the sensor gives it; what stands around
/// it (a first line "EEFF,…", a checksum) is passed over. Nothing for a text that is none. Throws Error(Format) with
/// file and line for a number that is none or out of range, and where channels do not follow each other.
std::optional<HesaiAngles> parse_hesai_angles(const std::string& bytes, const std::filesystem::path& file);

/// The table with so many channels among those beside packets: whose name is or has the sensor's address, that of the
/// recording's name, or the only one; none whose name has the address of another sensor. Throws Error(Unsupported) at
/// `where` where several say different things, and what a broken one throws where no other fits as well.
std::optional<HesaiAngles> find_hesai_angles(const BesidePackets& beside, std::size_t channels,
                                             const std::string& where);

/// The same of an AT128, whose beams three mirrors turn, each through a part of the encoder's turn.
struct HesaiMirrors {
  std::filesystem::path file;
  std::vector<double> begins_deg, ends_deg;          ///< of each mirror's part
  std::vector<double> elevations_deg, azimuths_deg;  ///< of each channel
  /// Added to both, 0.01 degrees times `adjust_unit`: of each channel at every second degree of the encoder.
  std::vector<std::int8_t> azimuth_adjusts, elevation_adjusts;
  double adjust_unit = 1.0;

  /// The mirror whose part it is; nothing beside all.
  std::optional<std::size_t> mirror_at(double encoder_deg) const;
  /// Clockwise from y, and above the horizon.
  std::array<double, 2> angles_deg(std::size_t mirror, std::size_t channel, double encoder_deg) const;
  bool same_as(const HesaiMirrors& other) const {
    return begins_deg == other.begins_deg && ends_deg == other.ends_deg && adjust_unit == other.adjust_unit &&
           elevations_deg == other.elevations_deg && azimuths_deg == other.azimuths_deg &&
           azimuth_adjusts == other.azimuth_adjusts && elevation_adjusts == other.elevation_adjusts;
  }
};

/// A file of version 1.5, as the sensor gives it. Nothing for bytes that are none. Throws Error(Unsupported) for
/// another version, Error(Format) where its size is not that of its numbers of channels and mirrors.
std::optional<HesaiMirrors> parse_hesai_mirrors(const std::string& bytes, const std::filesystem::path& file);

/// Likewise of 128 channels.
std::optional<HesaiMirrors> find_hesai_mirrors(const BesidePackets& beside, const std::string& where);

}  // namespace remount::formats
