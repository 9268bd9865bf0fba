// What one pass through a large capture found, kept as bytes so that it is not passed again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "model/formats/packets/packet_index.h"

namespace remount::formats {

/// A file as it was: another of these, and it is another file.
struct FileState {
  std::filesystem::path path;
  std::uint64_t bytes = 0;
  std::int64_t changed_ns = 0;
  friend bool operator==(const FileState&, const FileState&) = default;
};
/// Throws Error(Io) where there is none.
FileState state_of(const std::filesystem::path& path);

/// How a sensor was known.
struct KeptSensor {
  std::string model;              ///< empty: it was refused, or none was recognised
  std::vector<FileState> beside;  ///< files that tell of it
  friend bool operator==(const KeptSensor&, const KeptSensor&) = default;
};

struct KeptIndex {
  FileState capture;
  CaptureCounts counts;
  PassedPackets passed;  ///< without decoders
  std::map<DatagramRoute, KeptSensor> sensors;
};

/// Of routes whose sensors were recognised or refused, as they are now.
std::map<DatagramRoute, KeptSensor> known_sensors(const PassedPackets& passed);

/// @param passed with its decoders
std::string kept_index_bytes(const FileState& capture, const CaptureCounts& counts, const PassedPackets& passed);

/// Throws Error(Format) at `where` for what is no such index, one of another version of the program, or damaged. All
/// places in it are within the capture, whose size it says.
KeptIndex read_kept_index(std::string_view bytes, const std::string& where);

/// What stands behind the head and its checksum, for tests: as kept_index_bytes and read_kept_index.
std::string pack_index(const FileState& capture, const CaptureCounts& counts, const PassedPackets& passed,
                       const std::map<DatagramRoute, KeptSensor>& sensors);
KeptIndex unpack_index(std::string_view body, const std::string& where);

}  // namespace remount::formats
