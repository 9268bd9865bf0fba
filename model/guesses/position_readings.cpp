#include "model/guesses/position_readings.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>

#include "algorithms/core/index.h"
#include "algorithms/geodesy/earth_radius.h"
#include "algorithms/geometry/degree.h"
#include "algorithms/geometry/rotation.h"
#include "model/guesses/fastest_speed.h"

namespace remount::guesses {
namespace {

using formats::PlaceUnit;

constexpr double kFastest_mps = 80.0;

const std::vector<double>& values_of(const SampledTable& table, std::size_t column) {
  return table.columns[column].values;
}

/// -1 where all letters are the second one.
double sign_of_side(const SampledTable& table, const std::optional<std::size_t>& side, char negative) {
  if (!side) return 1.0;
  const std::vector<std::string>& texts = table.columns[*side].texts;
  return texts.size() == 1 && texts.front() == std::string(1, negative) ? -1.0 : 1.0;
}

/// Metres from the first row, on a sphere: enough for directions.
std::vector<Eigen::Vector3d> metres_of(const SampledTable& table, const PositionReading& reading) {
  const auto& [first, second, third] = reading.at;
  const std::vector<double>&a = values_of(table, first), &b = values_of(table, second), &c = values_of(table, third);
  const double north = sign_of_side(table, reading.sides[0], 'S') * (reading.negated[0] ? -1.0 : 1.0),
               east = sign_of_side(table, reading.sides[1], 'W') * (reading.negated[1] ? -1.0 : 1.0);
  std::vector<Eigen::Vector3d> metres;
  std::optional<Eigen::Vector3d> origin;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double up = reading.down ? -c[i] : c[i];
    const Eigen::Vector3d raw = reading.geodetic ? Eigen::Vector3d(north * formats::place_rad(a[i], reading.unit),
                                                                   east * formats::place_rad(b[i], reading.unit), up)
                                                 : Eigen::Vector3d(a[i], b[i], up);
    if (!origin && raw.allFinite()) origin = raw;
    if (!origin) {
      metres.push_back(raw);
      continue;
    }
    const Eigen::Vector3d from_first = raw - *origin;
    if (!reading.geodetic) {
      metres.push_back(from_first);
      continue;
    }
    metres.emplace_back(from_first.y() * geodesy::kEarthRadius_m * std::cos(origin->x()),
                        from_first.x() * geodesy::kEarthRadius_m, from_first.z());
  }
  return metres;
}

/// How it would move.
struct Movement {
  double way_m = 0.0, fastest_mps = 0.0;  ///< the latter but for one stretch in a hundred
  double smoothness = 0.0;                ///< 1 where steps follow each other, 0 where they are noise
};

Movement movement_of(const std::vector<Eigen::Vector3d>& metres, const std::vector<double>& times_s) {
  Movement movement;
  const std::vector<std::size_t> fixes = distinct_fixes(metres, times_s);
  double squares = 0.0, differences = 0.0;
  Eigen::Vector3d before = Eigen::Vector3d::Zero();
  bool has_before = false;
  for (std::size_t i = 1; i < fixes.size(); ++i) {
    const double step_s = times_s[fixes[i]] - times_s[fixes[i - 1]];
    const Eigen::Vector3d step = metres[fixes[i]] - metres[fixes[i - 1]];
    if (!(step_s > 0.0) || !step.allFinite()) {
      has_before = false;
      continue;
    }
    const Eigen::Vector3d velocity = step / step_s;
    movement.way_m += step.head<2>().norm();
    if (has_before) squares += velocity.squaredNorm(), differences += (velocity - before).squaredNorm();
    before = velocity;
    has_before = true;
  }
  movement.fastest_mps = fastest_speed_mps(metres, times_s, fixes);
  movement.smoothness = squares > 0.0 ? 1.0 - std::min(1.0, differences / squares) : 0.0;
  return movement;
}

Movement finished(const SampledTable& table, const TimeReading& time, PositionReading& reading) {
  reading.metres = metres_of(table, reading);
  const Movement movement = movement_of(reading.metres, time.times_s);
  reading.way_m = movement.way_m;
  return movement;
}

/// As far from the middle of the earth as its surface is, and no height.
bool is_geocentric(const SampledTable& table, const std::array<std::size_t, 3>& at) {
  constexpr double kLeast_m = 6.33e6, kMost_m = 6.40e6, kNoHeight_m = 20'000.0;
  std::size_t on_surface = 0, rows = 0;
  for (std::size_t row = 0; row < values_of(table, at[0]).size(); ++row) {
    const Eigen::Vector3d place(values_of(table, at[0])[row], values_of(table, at[1])[row],
                                values_of(table, at[2])[row]);
    if (!place.allFinite()) continue;
    ++rows;
    const double distance_m = place.norm();
    on_surface += distance_m > kLeast_m && distance_m < kMost_m && std::abs(place.z()) > kNoHeight_m;
  }
  return rows > 0 && 10 * on_surface > 9 * rows;
}

class PositionReader {
 public:
  PositionReader(const SampledTable& table, const ColumnNames& names, const TimeReading& time)
      : table_(table), names_(names), time_(time) {}

  std::vector<PositionReading> readings() {
    by_names();
    if (out_.empty()) by_movement();
    return std::move(out_);
  }

 private:
  std::optional<std::size_t> find(Quantity quantity) const { return number_column(table_, names_, quantity); }
  std::optional<std::size_t> first_of(std::initializer_list<Quantity> quantities) const {
    for (const Quantity quantity : quantities)
      if (const auto found = find(quantity)) return found;
    return std::nullopt;
  }

  Movement finish(PositionReading& reading) const { return finished(table_, time_, reading); }

  /// Degrees beyond what radians may be, or where radians would be faster than any vehicle; beyond what degrees may be,
  /// one of the others.
  void settle_unit(PositionReading& reading, const std::string& unit) const {
    const auto stated = formats::place_unit_named(unit);
    reading.unit_by_name = stated.has_value();
    reading.unit = stated.value_or(PlaceUnit::Degrees);
    if (stated) return;
    const double latitude = largest_size(values_of(table_, reading.at[0])),
                 longitude = largest_size(values_of(table_, reading.at[1]));
    if (latitude > 90.0 || longitude > 360.0) return settle_rare_unit(reading, latitude, longitude);
    if (latitude > kPi / 2.0 + 1e-9 || longitude > kPi + 1e-9) return;
    reading.unit = PlaceUnit::Radians;
    if (finish(reading).fastest_mps > kFastest_mps) reading.unit = PlaceUnit::Degrees;
  }

  /// Where neither fits, degrees stay: the rows are refused with the reason then.
  void settle_rare_unit(PositionReading& reading, double latitude, double longitude) const {
    const auto fits = [&](PlaceUnit unit) {
      reading.unit = unit;
      const Movement movement = finish(reading);
      return std::ranges::all_of(reading.metres,
                                 [](const auto& place) { return !std::isnan(place.x() + place.y()); }) &&
             movement.fastest_mps < kFastest_mps;
    };
    const auto whole = [&](std::size_t column) { return table_.columns[column].whole; };
    if (latitude < 9000.0 && longitude < 18'000.0 && fits(PlaceUnit::DegreesMinutes)) return;
    constexpr double kLeast = 1e5, kMillionths = 1e6;
    const bool integers = whole(reading.at[0]) && whole(reading.at[1]) && std::max(latitude, longitude) > kLeast;
    if (integers && latitude < 9e8 && longitude < 1.8e9 && fits(PlaceUnit::TenMillionths)) {
      reading.other_unit_fits = latitude < 90.0 * kMillionths && longitude < 180.0 * kMillionths;
      return;
    }
    reading.unit = PlaceUnit::Degrees;
  }

  /// The column of which all texts are one of two letters, if it is the only one.
  std::optional<std::size_t> letters_of(std::string_view letters) const {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      const std::vector<std::string>& texts = table_.columns[i].texts;
      const auto is_letter = [&](const std::string& text) {
        return text.size() == 1 && letters.find(text.front()) != std::string_view::npos;
      };
      if (table_.columns[i].numeric || texts.empty() || !std::ranges::all_of(texts, is_letter)) continue;
      if (found) return std::nullopt;
      found = i;
    }
    return found;
  }

  void by_names() {
    const auto latitude = find(Quantity::Latitude), longitude = find(Quantity::Longitude);
    const auto height = first_of({Quantity::Height, Quantity::SeaHeight, Quantity::Up, Quantity::Z});
    if (latitude && longitude && height) {
      PositionReading reading{.at = {*latitude, *longitude, *height}, .geodetic = true, .by_name = true};
      reading.above_sea = names_[*height]->quantity == Quantity::SeaHeight;
      const auto unit = common_unit(names_, std::array{*latitude, *longitude});
      if (!unit) return;
      reading.sides = {letters_of("NS"), letters_of("EW")};
      settle_unit(reading, *unit);
      finish(reading);
      out_.push_back(std::move(reading));
      const bool sides = out_.front().sides[0] || out_.front().sides[1];
      if (!sides && formats::place_rad(largest_size(values_of(table_, *longitude)), out_.front().unit) <= kPi / 2.0)
        add_exchanged(out_.front(), false);
      return;
    }
    const auto east = find(Quantity::East), north = find(Quantity::North), down = find(Quantity::Down);
    const auto up = first_of({Quantity::Up, Quantity::Height, Quantity::SeaHeight, Quantity::Z});
    if (east && north && (up || down)) {
      PositionReading reading{.at = {*east, *north, up ? *up : *down}, .on_axes = true, .down = !up, .by_name = true};
      finish(reading);
      out_.push_back(std::move(reading));
      return;
    }
    const auto x = find(Quantity::X), y = find(Quantity::Y);
    const auto z = first_of({Quantity::Z, Quantity::Height, Quantity::SeaHeight, Quantity::Up});
    if (!x || !y || !z || is_geocentric(table_, {*x, *y, *z})) return;
    PositionReading reading{.at = {*x, *y, *z}, .by_name = true};
    finish(reading);
    out_.push_back(std::move(reading));
    add_exchanged(out_.front(), false);
    if (names_[*z]->quantity == Quantity::Z) add_exchanged(out_.front(), true);
  }

  void add_exchanged(PositionReading reading, bool down) {
    std::swap(reading.at[0], reading.at[1]);
    reading.exchanged = true;
    reading.down = down;
    finish(reading);
    out_.push_back(std::move(reading));
  }

  bool is_free(std::size_t column) const {
    const SampledColumn& one = table_.columns[column];
    return one.numeric && !names_[column] && std::ranges::find(time_.at, column) == time_.at.end();
  }

  /// Three columns side by side that would move as vehicles do: the smoother the better, and on the earth before
  /// elsewhere.
  void by_movement() {
    constexpr double kLeastWay_m = 5.0, kLeastSmoothness = 0.5, kLargestHeight_m = 9'000.0;
    constexpr std::size_t kMostReadings = 8;
    std::vector<std::pair<double, PositionReading>> found;
    for (std::size_t i = 0; i + 2 < table_.columns.size(); ++i) {
      if (!is_free(i) || !is_free(i + 1) || !is_free(i + 2)) continue;
      const double first = largest_size(values_of(table_, i)), second = largest_size(values_of(table_, i + 1));
      const auto add = [&](PositionReading reading, double weight) {
        const Movement movement = finish(reading);
        if (movement.way_m < kLeastWay_m || movement.fastest_mps > kFastest_mps ||
            movement.smoothness < kLeastSmoothness)
          return;
        reading.metres = {};  // of the likeliest alone: there may be hundreds
        found.emplace_back(weight + movement.smoothness, std::move(reading));
      };
      const bool height = largest_size(values_of(table_, i + 2)) < kLargestHeight_m;
      for (const bool exchanged : {false, true})
        for (const PlaceUnit unit : {PlaceUnit::Degrees, PlaceUnit::Radians}) {
          const double latitude = formats::place_rad(exchanged ? second : first, unit),
                       longitude = formats::place_rad(exchanged ? first : second, unit);
          if (!height || latitude > kPi / 2.0 || longitude > kPi || latitude < 1e-3) continue;
          add({.at = {exchanged ? i + 1 : i, exchanged ? i : i + 1, i + 2}, .geodetic = true, .unit = unit},
              exchanged ? 0.9 : 1.0);
        }
      if (!is_geocentric(table_, {i, i + 1, i + 2})) add({.at = {i, i + 1, i + 2}}, 0.5);
    }
    std::ranges::stable_sort(found, [](const auto& a, const auto& b) { return a.first > b.first; });
    if (found.size() > kMostReadings) found.erase(found.begin() + kMostReadings, found.end());
    for (auto& [weight, reading] : found) {
      finish(reading);
      out_.push_back(reading);
      if (reading.geodetic) continue;
      add_exchanged(reading, false);
      add_exchanged(std::move(reading), true);
    }
  }

  const SampledTable& table_;
  const ColumnNames& names_;
  const TimeReading& time_;
  std::vector<PositionReading> out_;
};

}  // namespace

void put_metres(const SampledTable& table, const TimeReading& time, PositionReading& reading) {
  finished(table, time, reading);
}

bool has_geocentric_columns(const SampledTable& table) {
  for (std::size_t i = 0; i + 2 < table.columns.size(); ++i)
    if (table.columns[i].numeric && table.columns[i + 1].numeric && table.columns[i + 2].numeric &&
        is_geocentric(table, {i, i + 1, i + 2}))
      return true;
  return false;
}

std::vector<PositionReading> position_readings(const SampledTable& table, const ColumnNames& names,
                                               const TimeReading& time) {
  return PositionReader(table, names, time).readings();
}

}  // namespace remount::guesses
