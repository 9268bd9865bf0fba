// RoboSense's sensors that turn, as their manuals and their driver describe them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace remount::formats {

/// How the packets of a sensor are laid out: blocks of returns of one azimuth behind a head.
struct MsopLayout {
  std::size_t bytes = 1248, head = 42, time_at = 20;
  std::size_t blocks = 12, returns = 32;  ///< and returns of each
  std::uint32_t block_mark = 0xffee;      ///< what blocks begin with
  std::size_t mark_bytes = 2;
  std::size_t described = 32;  ///< lasers for which the sensor's description has room

  std::size_t block_bytes() const { return 4 + 3 * returns; }
};

/// Of 16 lasers a block has two rounds, or both returns of one.
struct RobosenseModel {
  std::string_view name;
  MsopLayout layout = {};
  std::size_t lasers = 32;
  double unit_m = 0.005;              ///< of ranges
  double round_us = 0.0;              ///< from one round of all lasers to the next
  std::span<const double> firing_us;  ///< of each laser in its round, in the order of their returns
  double lens_x_m = 0.0;              ///< how far from the axis the beams begin
  double lens_z_m = 0.0;              ///< and how far above the sensor's origin
  bool spelt_date = false;            ///< years to microseconds, instead of seconds since 1970
  bool counted_nanoseconds = false;   ///< early firmware did, later firmware counts microseconds
  double angle_unit_deg = 0.01;       ///< in the packets in which the sensor describes itself
  std::span<const double> nominal_deg =
      {};  ///< elevations of the data sheet; empty where they are too far from true ones
};

/// By a packet of points; null where its sensor is not known.
/// @param payload that begins as one, with a whole head of 42 bytes
const RobosenseModel* robosense_model(std::string_view payload);
/// Of an RS-Ruby or RS-Ruby Plus; null for packets of others.
const RobosenseModel* robosense_ruby(std::string_view payload);
/// The same sensor with half the lasers, where only its description tells; null where there is none.
const RobosenseModel* robosense_with_16_lasers(const RobosenseModel& model);

/// Where a laser looks: up, and clockwise from where the azimuth says.
struct RobosenseLaser {
  double elevation_deg = 0.0, azimuth_offset_deg = 0.0;
  bool operator==(const RobosenseLaser&) const = default;
};

/// What a sensor says of itself (port 7788).
struct RobosenseDescription {
  std::vector<RobosenseLaser> lasers;  ///< empty where it has not been calibrated
  bool two_returns = false;
  bool backwards = false;  ///< of a Bpearl that hangs upside down
  bool same_directions(const RobosenseDescription& other) const {
    return lasers == other.lasers && backwards == other.backwards;
  }
};

/// Whether these are bytes of such a description.
bool is_robosense_description(std::string_view payload);
/// @param payload for which the above is true
RobosenseDescription read_robosense_description(const RobosenseModel& model, std::string_view payload);
/// What of it stays as long as the sensor is neither exchanged nor set otherwise. @param payload likewise
std::string lasting_robosense_description(std::string_view payload);
/// Whether only the first 16 lasers are described.
bool describes_16_lasers(std::string_view payload);

}  // namespace remount::formats
