#include "algorithms/calibration/search_range.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "messages/parameters.h"

namespace remount::calibration {

namespace {

// As many digits as tell two values apart, which are `apart`: "5.00 m above 5.00 m" says nothing.
template <class Value>
Message distinct(Value value, double apart, const std::array<Message (*)(Value), 3>& with_digits) {
  return with_digits[apart >= 0.01 ? 0 : apart >= 1e-5 ? 1 : 2](value);
}

Message distinct_length(double value_m, double apart_m) {
  return distinct<Length>({value_m}, apart_m, {say::range_length, say::range_length_5, say::range_length_9});
}

Message distinct_angle(double value_rad, double apart_rad) {
  return distinct<Angle>({value_rad}, radians_to_degrees(apart_rad),
                         {say::range_angle, say::range_angle_5, say::range_angle_9});
}

}  // namespace

Message outside_range(const RigidTransform& ins_from_lidar, const SearchRange& range) {
  const SixParameters six = six_from_rigid(ins_from_lidar);
  std::vector<Message> problems;
  const auto check = [&](Message name, double value, double minimum, double maximum, auto in_words) {
    if (value >= minimum && value <= maximum) return;
    const bool below = value < minimum;
    const double limit = below ? minimum : maximum, apart = std::abs(value - limit);
    problems.push_back(
        (below ? say::range_below : say::range_above)(std::move(name), in_words(value, apart), in_words(limit, apart)));
  };
  // Beyond 180 deg an angle goes on at -180 deg: bounds that meet there leave no gap, though they were rounded.
  constexpr double kSeam_rad = 1e-5;
  const auto check_angle = [&](Message name, double value, double minimum, double maximum) {
    const bool full_turn = maximum - minimum >= 2.0 * kPi - kSeam_rad;
    if (!full_turn) check(std::move(name), value, minimum, maximum, distinct_angle);
  };
  check(say::parameter_x(), six.x_m, range.x_min_m, range.x_max_m, distinct_length);
  check(say::parameter_y(), six.y_m, range.y_min_m, range.y_max_m, distinct_length);
  check(say::parameter_z(), six.z_m, range.z_min_m, range.z_max_m, distinct_length);
  check_angle(say::parameter_yaw(), six.yaw_rad, range.yaw_min_rad, range.yaw_max_rad);
  check_angle(say::parameter_pitch(), six.pitch_rad, range.pitch_min_rad, range.pitch_max_rad);
  check_angle(say::parameter_roll(), six.roll_rad, range.roll_min_rad, range.roll_max_rad);
  return problems.empty() ? Message() : say::range_outside(std::move(problems));
}

}  // namespace remount::calibration
