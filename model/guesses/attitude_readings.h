// In which ways columns may be an attitude, and what of it a drive tells.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/motion/ins_sample.h"
#include "model/drive/attitude_convention.h"
#include "model/guesses/position_readings.h"

namespace remount::guesses {

struct AttitudeReading {
  std::optional<drive::QuaternionConvention> quaternion;
  std::array<std::size_t, 4> xyzw{};
  std::array<std::size_t, 3> yaw_pitch_roll{};
  std::array<double, 3> signs{1.0, 1.0, 1.0};
  drive::AttitudeConvention convention = drive::AttitudeConvention::EnuYaw;
  double unit_rad = 1.0;
  bool by_name = false, unit_by_name = false, usual_for_name = false;
  bool telling_name = false;  ///< a heading is one of a compass; "yaw" may be either

  std::vector<std::size_t> columns() const;
  /// As a manifest has it: "heading, unit: deg, negated: [pitch]".
  std::string words() const;
};

/// All that may be, for columns that no name explains as well. @param position whose columns are none
std::vector<AttitudeReading> attitude_readings(const SampledTable& table, const ColumnNames& names,
                                               const TimeReading& time, const PositionReading& position);

/// Of those rows that have everything. @param rows of the sampled ones, going up
std::vector<motion::StampedPose> poses_of(const SampledTable& table, const TimeReading& time,
                                          const PositionReading& position, const AttitudeReading& attitude,
                                          const std::vector<std::size_t>& rows);

}  // namespace remount::guesses
