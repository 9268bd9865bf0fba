// The binary output of an OxTS INS (NCOM).
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "model/formats/ins/ins_log.h"

namespace remount::formats {

inline constexpr std::size_t kNcomPacketBytes = 72;

/// What one packet of structure A says.
struct NcomPacket {
  int navigation = 0;   ///< 2 initialising, 3 locking, 4 locked; other states have no solution
  int millisecond = 0;  ///< into the minute
  double latitude_rad = 0.0, longitude_rad = 0.0, height_m = 0.0;
  double heading_rad = 0.0, pitch_rad = 0.0, roll_rad = 0.0;
  int channel = 0;  ///< of the eight bytes of status
  std::string_view channel_bytes;
};

/// The packet at a place; nothing where it does not begin with 0xE7, is cut or has a wrong checksum. `bytes` must
/// outlive it.
std::optional<NcomPacket> ncom_packet(std::string_view bytes, std::size_t at);

/// Whether the INS navigates, or is about to.
bool has_solution(const NcomPacket& packet);

/// GPS minutes since 6 January 1980 of channel 0; nothing in others, or where the packet is of the first or the last
/// second of a minute, for the status may be of another.
std::optional<std::int64_t> ncom_minutes(const NcomPacket& packet);

/// Errors of positions and attitudes, of the channels that were last seen.
class NcomErrors {
 public:
  /// Takes channel 3 (position) or 5 (attitude); others say nothing.
  void take(const NcomPacket& packet);
  const motion::InsSigma& sigma() const { return sigma_; }

 private:
  motion::InsSigma sigma_;
};

/// Without its stamp: heading, pitch and roll of the vehicle's axes, forward-right-down of north-east-down, which are
/// forward-left-up here. Throws Error(Format) at `where` for values that are not possible.
motion::InsSample ncom_sample(const NcomPacket& packet, const motion::InsSigma& sigma, const std::string& where);

/// From the first bytes: two packets one after the other. Never throws.
bool recognise_ncom(const std::filesystem::path& path);

/// Samples of all packets with a solution, among whatever else; stamps by GPS time of the minutes of channel 0 and the
/// milliseconds of each packet. Locked is good, locking degraded, initialising invalid. Throws Error as
/// InsLogKind::read says, and where no minute is told.
InsLog read_ncom(const std::filesystem::path& path, std::vector<drive::Finding>& findings);

}  // namespace remount::formats
