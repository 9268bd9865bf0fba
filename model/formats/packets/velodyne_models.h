// Velodyne's sensors, as their manuals describe them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace remount::formats {

/// A laser of one of these sensors.
struct VelodyneLaser {
  double elevation_deg = 0.0;
  double azimuth_offset_deg = 0.0;  ///< added to the azimuth of the block, clockwise
  double height_mm = 0.0;           ///< of where its beam begins, above the sensor's centre
};

/// Sensors that send the packets of 12 blocks of 32 returns. All fire groups of lasers one after the other, and then
/// recharge; with that a column is complete.
struct VelodyneModel {
  std::string_view name;
  std::array<std::uint8_t, 2> product_ids;  ///< the last byte of its packets; a second one that manuals name
  std::span<const VelodyneLaser> lasers;    ///< in the order of their returns in a packet
  double unit_m = 0.002;                    ///< of ranges
  int lasers_at_once = 1;
  double step_us = 0.0;         ///< from group to group
  double column_us = 0.0;       ///< from column to column, recharging included
  int pause_after = 0;          ///< groups behind which one step is waited; 0: nowhere
  double stamp_after_us = 0.0;  ///< how long after the first firing the packet's stamp is
};

/// Null where there is none of that number.
const VelodyneModel* velodyne_model(std::uint8_t product_id);

}  // namespace remount::formats
