#include "model/guesses/attitude_readings.h"

#include <algorithm>
#include <cmath>

#include "algorithms/core/index.h"
#include "algorithms/geometry/degree.h"
#include "algorithms/geometry/rotation.h"

namespace remount::guesses {
namespace {

using drive::AttitudeConvention;
using drive::QuaternionConvention;

class AttitudeReader {
 public:
  AttitudeReader(const SampledTable& table, const ColumnNames& names, const TimeReading& time,
                 const PositionReading& position)
      : table_(table), names_(names), time_(time), position_(position) {}

  std::vector<AttitudeReading> readings() {
    const auto roll = find(Quantity::Roll), pitch = find(Quantity::Pitch);
    for (const Quantity yaw : {Quantity::Heading, Quantity::Yaw})
      if (const auto found = find(yaw); found && roll && pitch)
        if (const auto unit = common_unit(names_, std::array{*found, *pitch, *roll}))
          add_angles({*found, *pitch, *roll}, *unit, true, yaw == Quantity::Heading);
    if (position_.exchanged && !position_.down && !position_.geodetic)
      return std::move(out_);  // a quaternion would go with a world that is mirrored
    const auto x = find(Quantity::Qx), y = find(Quantity::Qy), z = find(Quantity::Qz), w = find(Quantity::Qw);
    if (x && y && z && w) {
      add_quaternion({*x, *y, *z, *w}, true);
      // q0 to q3 begin with the scalar part, or end with it.
      if (table_.columns[*w].title.find('0') != std::string::npos) add_quaternion({*w, *x, *y, *z}, true);
    }
    if (out_.empty()) unnamed();
    return std::move(out_);
  }

 private:
  std::optional<std::size_t> find(Quantity quantity) const { return number_column(table_, names_, quantity); }
  bool is_free(std::size_t column) const {
    return table_.columns[column].numeric && !names_[column] && std::ranges::find(time_.at, column) == time_.at.end() &&
           std::ranges::find(position_.at, column) == position_.at.end();
  }

  /// x to the north, y to the east, z downwards, of columns whose names do not say so.
  bool counts_down_from_north() const { return position_.exchanged && position_.down && !position_.geodetic; }

  void add_quaternion(const std::array<std::size_t, 4>& xyzw, bool by_name) {
    for (const QuaternionConvention convention :
         {QuaternionConvention::EnuFromIns, QuaternionConvention::NedFromBody}) {
      if (counts_down_from_north() && convention == QuaternionConvention::EnuFromIns) continue;
      AttitudeReading reading;
      reading.quaternion = convention;
      reading.xyzw = xyzw;
      reading.by_name = reading.unit_by_name = by_name;
      reading.usual_for_name = convention == QuaternionConvention::EnuFromIns;
      out_.push_back(reading);
    }
  }

  /// Yaw from east or from north, either way round.
  void add_angles(const std::array<std::size_t, 3>& columns, const std::string& unit, bool by_name, bool heading) {
    double largest = 0.0;
    for (const std::size_t column : columns) largest = std::max(largest, largest_size(table_.columns[column].values));
    for (const double unit_rad : {kDegree_rad, 1.0}) {
      if ((unit == "deg" && unit_rad == 1.0) || (unit == "rad" && unit_rad != 1.0)) continue;
      if (unit_rad == 1.0 && largest > 2.0 * kPi + 0.01) continue;
      if (unit_rad != 1.0 && largest > 360.01) continue;
      for (const AttitudeConvention convention : {AttitudeConvention::Heading, AttitudeConvention::EnuYaw})
        for (const double yaw_sign : {1.0, -1.0}) {
          AttitudeReading reading;
          reading.yaw_pitch_roll = columns;
          reading.signs[0] = yaw_sign;
          reading.convention = convention;
          reading.unit_rad = unit_rad;
          reading.by_name = by_name;
          reading.unit_by_name = unit == "deg" || unit == "rad";
          reading.telling_name = by_name && heading;
          reading.usual_for_name = yaw_sign > 0.0 && (convention == AttitudeConvention::Heading) == heading;
          out_.push_back(reading);
        }
    }
  }

  /// Length one in nearly every row, and not always the same.
  bool is_quaternion(std::size_t first) const {
    constexpr double kOff = 0.005;
    std::size_t unit = 0, rows = 0, moves = 0;
    for (std::size_t row = 0; row < table_.columns[first].values.size(); ++row) {
      double squares = 0.0;
      bool moved = false;
      for (std::size_t i = first; i < first + 4; ++i) {
        const std::vector<double>& values = table_.columns[i].values;
        squares += values[row] * values[row];
        moved = moved || (row > 0 && values[row] != values[row - 1]);
      }
      ++rows, unit += std::abs(std::sqrt(squares) - 1.0) < kOff, moves += moved;
    }
    return 100 * unit >= 98 * rows && 2 * moves > rows;
  }

  void unnamed() {
    const std::size_t columns = table_.columns.size();
    for (std::size_t i = 0; i + 3 < columns; ++i) {
      if (!is_free(i) || !is_free(i + 1) || !is_free(i + 2) || !is_free(i + 3) || !is_quaternion(i)) continue;
      add_quaternion({i, i + 1, i + 2, i + 3}, false);
      add_quaternion({i + 1, i + 2, i + 3, i}, false);
    }
    if (!out_.empty()) return;
    constexpr std::array<std::array<std::size_t, 3>, 6> kOrders{
        {{2, 1, 0}, {0, 1, 2}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}}};  // of yaw, pitch, roll
    for (std::size_t i = 0; i + 2 < columns; ++i)
      if (is_free(i) && is_free(i + 1) && is_free(i + 2))
        for (const auto& order : kOrders)
          if (table_.columns[i + order[0]].varies)
            add_angles({i + order[0], i + order[1], i + order[2]}, "", false, true);
  }

  const SampledTable& table_;
  const ColumnNames& names_;
  const TimeReading& time_;
  const PositionReading& position_;
  std::vector<AttitudeReading> out_;
};

}  // namespace

std::vector<std::size_t> AttitudeReading::columns() const {
  if (quaternion) return {xyzw.begin(), xyzw.end()};
  return {yaw_pitch_roll.begin(), yaw_pitch_roll.end()};
}

std::string AttitudeReading::words() const {
  if (quaternion) return "convention: " + std::string(drive::to_string(*quaternion));
  std::string negated;
  std::size_t i = 0;
  for (const char* angle : {"yaw", "pitch", "roll"})
    if (signs[i++] < 0.0) negated += (negated.empty() ? "" : ", ") + std::string(angle);
  return "convention: " + std::string(drive::to_string(convention)) + ", unit: " + (unit_rad == 1.0 ? "rad" : "deg") +
         (negated.empty() ? "" : ", negated: [" + negated + "]");
}

std::vector<AttitudeReading> attitude_readings(const SampledTable& table, const ColumnNames& names,
                                               const TimeReading& time, const PositionReading& position) {
  return AttitudeReader(table, names, time, position).readings();
}

std::vector<motion::StampedPose> poses_of(const SampledTable& table, const TimeReading& time,
                                          const PositionReading& position, const AttitudeReading& attitude,
                                          const std::vector<std::size_t>& rows) {
  const auto value = [&](std::size_t column, std::size_t row) { return table.columns[column].values[row]; };
  std::vector<motion::StampedPose> poses;
  for (const std::size_t row : rows) {
    const Eigen::Vector3d& place = position.metres[row];
    if (!std::isfinite(time.times_s[row]) || !place.allFinite()) continue;
    Eigen::Quaterniond enu_from_ins;
    if (attitude.quaternion) {
      const auto& [x, y, z, w] = attitude.xyzw;
      const Eigen::Quaterniond logged(value(w, row), value(x, row), value(y, row), value(z, row));
      if (!(std::abs(logged.norm() - 1.0) < 0.1)) continue;
      enu_from_ins = drive::enu_from_ins(logged, *attitude.quaternion);
    } else {
      std::array<double, 3> angles{};
      for (std::size_t i = 0; i < 3; ++i)
        angles[i] = attitude.signs[i] * attitude.unit_rad * value(attitude.yaw_pitch_roll[i], row);
      if (!std::isfinite(angles[0] + angles[1] + angles[2])) continue;
      enu_from_ins = drive::enu_from_ins({angles[0], angles[1], angles[2]}, attitude.convention);
    }
    constexpr double kLongest_s = 4.1e9;
    if (time.times_s[row] - time.first_s > kLongest_s) continue;
    const auto stamp_ns = static_cast<std::int64_t>(1e9 * (time.times_s[row] - time.first_s));
    if (!poses.empty() && stamp_ns <= poses.back().stamp_ns) continue;
    poses.push_back({stamp_ns, make_rigid(enu_from_ins.toRotationMatrix(), place)});
  }
  return poses;
}

}  // namespace remount::guesses
