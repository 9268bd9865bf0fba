// Which column of a file of poses is what: by the names of its header, or in the usual order.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace remount::formats {

struct PoseColumns {
  std::size_t time = 0;
  std::optional<std::size_t> nanoseconds;  ///< beside whole seconds in `time`
  std::int64_t time_unit_ns = 0;           ///< of `time`; 0: the header does not say
  std::array<std::size_t, 3> position{1, 2, 3};
  std::array<std::size_t, 4> quaternion_xyzw{4, 5, 6, 7};
  std::size_t last() const;
};

/// `t x y z qx qy qz qw`, behind a leading number of the line where `numbered`.
PoseColumns usual_pose_columns(bool numbered);

/// Of a line of names, apart by commas or blanks, with or without a leading '#': TUM's and EuRoC's own, names of ROS
/// messages, and what people make of them (`timestamp [ns]`, `p_RS_R_x [m]`, `q_RS_w []`, `tx`, `qw`,
/// `field.pose.pose.position.x`). Nothing where it does not name time, position and quaternion.
std::optional<PoseColumns> named_pose_columns(std::string_view line);

/// Of any script, but for the e of "1e-5": false of a line of numbers, which names nothing.
bool holds_letters(std::string_view line);

/// Nanoseconds in one unit of stamps that nobody names, from the stamps at the begin of a file. Times since 1970 say it
/// by their size where their steps are not too long for it; of others seconds are taken where their steps may be, and
/// another unit where it is the only one that may. Nothing where none or several may.
std::optional<std::int64_t> unit_of_stamps_ns(const std::vector<double>& stamps);

/// Lines that are long enough: eight numbers of one digit. Others, however many, are to take no memory.
std::size_t possible_poses(std::string_view text);

}  // namespace remount::formats
