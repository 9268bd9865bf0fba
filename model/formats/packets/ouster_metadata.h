// What Ouster's sensors say of themselves beside their packets: a JSON text that recorders keep.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/geometry/rigid_transform.h"
#include "model/formats/packets/frames.h"
#include "model/formats/packets/ouster_layout.h"

namespace remount::formats {

/// Of one sensor with its settings at that time.
struct OusterMetadata {
  std::filesystem::path file;
  std::string product;                              ///< "OS-1-128"; empty: it does not say
  std::optional<std::uint64_t> serial;              ///< what packets repeat
  std::optional<std::uint32_t> initialization;      ///< likewise
  std::optional<std::uint16_t> port;                ///< that points are sent to
  const OusterProfile* profile = nullptr;           ///< never null once it is read
  OusterLayout layout;                              ///< of its packets
  std::uint32_t columns_per_turn = 0;               ///< places of columns
  std::vector<double> elevations_rad;               ///< of each pixel of a column
  std::vector<double> azimuths_rad;                 ///< likewise, beside the encoder's: clockwise
  double beams_ahead_m = 0.0, beams_above_m = 0.0;  ///< where beams begin, from the middle of the turning head
  RigidTransform sensor_from_lidar =
      RigidTransform::Identity();  ///< the sensor's housing, and the turning head at encoder 0
  bool clock_follows = false;      ///< it is set to follow PTP, or pulses with the receiver's sentences
};

/// Nothing where the text is no metadata of an Ouster. Flat, as firmware up to 2 and its clients wrote it, or in
/// sections; what was added later may be missing. Throws Error(Format) with file and key where something else is, and
/// Error(Unsupported) for a sensor without a turning head or an unknown profile.
std::optional<OusterMetadata> parse_ouster_metadata(const std::string& bytes, const std::filesystem::path& file);

/// What a sensor's first packet tells of it.
struct OusterTraits {
  std::size_t packet_bytes = 0;
  std::uint64_t serial = 0;       ///< by a standard header; 0: none
  std::uint64_t fusa_serial = 0;  ///< by the header for functional safety
  std::uint32_t initialization = 0, fusa_initialization = 0;
};

/// The metadata of a sensor among the JSON files beside its packets: what fits the size of its packets and the serial
/// number in them, or, where one of the two has no number, has no other sensor's address in its name; of several, whose
/// name has the sensor's address, those of the same start of the sensor, of its port, and of the recording's name.
/// Throws Error(Unsupported) at `where` that says what to put where, and what a broken file throws where no other fits,
/// or where it is the one with the sensor's address and no other has the serial number of the packets.
OusterMetadata find_ouster_metadata(const BesidePackets& beside, const OusterTraits& traits, const std::string& where);

}  // namespace remount::formats
