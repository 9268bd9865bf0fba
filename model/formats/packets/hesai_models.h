// Hesai's sensors, as their manuals describe them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "algorithms/messages/message.h"

namespace remount::formats {

/// A sensor that fires all its channels for each block of a packet, or for blocks of several returns at once.
struct HesaiModel {
  std::string_view name;
  std::size_t channels = 0;
  std::vector<double> elevations_deg = {};  ///< of each channel, nominal; none: those of each sensor differ too much
  std::vector<double> azimuths_deg = {};    ///< likewise, clockwise beside that of the block
  /// When each channel fires, from the time that its block's azimuth is of: one set, or one for each state
  /// (HesaiLayout::times_set), or of each two where `near_m` is given: beyond that range and up to it.
  std::vector<std::vector<double>> times_us = {};
  double near_m = 0.0;
  bool mirrored = false;       ///< angles are those of HesaiMirrors
  double block_step_us = 0.0;  ///< from firing to firing
  double stamp_step_us = 0.0;  ///< from the packet's stamp to the time of its last block, or of its first:
  bool stamp_of_first = false;
};

const HesaiModel& pandar40();
const HesaiModel& pandar64();
const HesaiModel& pandar_qt();
const HesaiModel& qt128();
const HesaiModel& pandar128();
const HesaiModel& ot128();
const HesaiModel& at128();
/// Null for other numbers of channels and blocks.
const HesaiModel* pandar_xt(std::size_t channels, std::size_t blocks);

/// How the bytes of a packet are laid out.
struct HesaiLayout {
  const HesaiModel* model = nullptr;
  std::size_t blocks = 0, channels = 0, returns = 1;
  std::size_t blocks_at = 0, block_bytes = 0;
  std::size_t azimuth_at = 0, units_at = 0;  ///< in a block
  std::size_t unit_bytes = 0;
  double unit_m = 0.004;
  double block_step_us = 0.0;
  std::size_t speed_at = 0, stamp_at = 0, date_at = 0;
  std::size_t states_at = 0;     ///< of blocks; 0: they have none
  std::size_t first_state = 0;   ///< of the packet's mode, among all states
  std::size_t loop_at = 0;       ///< which of two sets of channels fires in the first block; 0: they are one
  bool years_from_2000 = false;  ///< of the date; else from 1900, or seconds since 1970 where its first byte is 0

  std::size_t columns() const { return blocks / returns; }
  std::size_t block_at(std::size_t column, std::size_t which) const {
    return blocks_at + (column * returns + which) * block_bytes;
  }
  /// From the packet's stamp to the time that the azimuth of a column is of.
  double column_us(std::size_t column) const;
  /// The encoder's angle; beyond 360 where something else stands there.
  double azimuth_deg(std::string_view payload, std::size_t column) const;
  /// Whether the sensor turns counter-clockwise, as far as the columns of one packet tell.
  bool falls(std::string_view payload) const;
  /// Which set of firing times is that of a column, for far ranges; that for near ones is the next.
  std::size_t times_set(std::string_view payload, std::size_t column) const;
};

/// By what a packet says of itself; nothing where it is no packet of points of these sensors.
std::optional<HesaiLayout> hesai_layout(std::string_view payload);
/// "FT120" of a packet of points of a sensor of this make that is not decoded; empty for anything else.
std::string_view unread_hesai(std::string_view payload);
/// Why a packet of points that is one of these sensors' by mark, protocol and size is not decoded; empty where it is,
/// and for anything else.
Message unknown_hesai(std::string_view payload);

}  // namespace remount::formats
