// In which ways columns may be a position: by their names, or by moving as a vehicle does.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "model/guesses/sampled_table.h"
#include "model/guesses/time_guess.h"

namespace remount::guesses {

/// One way in which three columns may be a position.
struct PositionReading {
  std::array<std::size_t, 3> at{};  ///< latitude, longitude, height; or x, y, z; or east, north, up
  bool geodetic = false;
  bool on_axes = false;    ///< named as east and north
  bool exchanged = false;  ///< x counts north and y east though they are not called so, latitude is called longitude
  bool down = false;       ///< the third counts downwards
  formats::PlaceUnit unit = formats::PlaceUnit::Radians;  ///< of latitude and longitude
  std::array<std::optional<std::size_t>, 2> sides{};      ///< columns with N or S, with E or W
  std::array<bool, 2> negated{};                          ///< latitude, longitude: whose sign has got lost
  bool other_unit_fits = false;  ///< its whole numbers may as well count another share of a degree
  bool by_name = false, unit_by_name = false;
  bool above_sea = false;
  std::vector<Eigen::Vector3d> metres{};  ///< of the sampled rows, from the first; NaN where there is none
  double way_m = 0.0;
};

/// Metres and way, of what else the reading says.
void put_metres(const SampledTable& table, const TimeReading& time, PositionReading& reading);

/// Whether three columns side by side count metres from the middle of the earth, which no manifest can have.
bool has_geocentric_columns(const SampledTable& table);

/// The likeliest first: those that names say, else those that move as a vehicle does. Of x, y and z also as north, east
/// and up or down: which it is, the direction of travel tells beside an attitude, or not at all.
std::vector<PositionReading> position_readings(const SampledTable& table, const ColumnNames& names,
                                               const TimeReading& time);

}  // namespace remount::guesses
