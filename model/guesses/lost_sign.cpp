#include "model/guesses/lost_sign.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "algorithms/geometry/degree.h"

namespace remount::guesses {
namespace {

constexpr double kLooksAhead_rad = 15.0 * kDegree_rad;

bool looks_ahead(const Hypothesis& one) { return size_of_offset(one.fit) < kLooksAhead_rad; }

/// A compass heading, as it is called or as angles without a name are taken.
bool is_of_compass(const AttitudeReading& attitude) { return attitude.telling_name || !attitude.by_name; }

/// Counted as its name says, and with the nose ahead. A yaw may be one of a compass or count from the east.
bool is_as_called(const Hypothesis& one) {
  if (one.attitude.quaternion) return looks_ahead(one);
  const bool named = !is_of_compass(one.attitude) || one.attitude.convention == drive::AttitudeConvention::Heading;
  return named && one.attitude.signs[0] > 0.0 && looks_ahead(one);
}

bool slope_agrees(const Hypothesis& one) {
  return one.fit.slope == SlopeFit::Agrees && (one.attitude.quaternion || one.attitude.signs[1] > 0.0);
}

/// Whichever way its pitch counts.
bool follows_road(const Hypothesis& one) {
  return one.fit.slope == SlopeFit::Agrees || one.fit.slope == SlopeFit::Opposite;
}

bool is_better(const Hypothesis& turned, const Hypothesis& best) {
  constexpr double kKeepsTo_rad = 5.0 * kDegree_rad, kWorse_rad = 1.0 * kDegree_rad;
  if (!is_as_called(turned) || turned.fit.residual_rad > kKeepsTo_rad ||
      turned.fit.residual_rad > best.fit.residual_rad + kWorse_rad)
    return false;
  const auto& [latitude, longitude] = turned.position->negated;
  // An INS across its vehicle whose quaternion counts otherwise goes as well; the road, where it rises, tells them
  // apart.
  if (turned.attitude.quaternion)
    return latitude != longitude && (slope_agrees(turned) || turned.fit.slope == SlopeFit::NotTold);
  // Both signs turn the way round and mirror nothing: the road alone tells such from an INS that looks backwards.
  if (latitude && longitude) return slope_agrees(turned) && !slope_agrees(best);
  // A yaw goes as well with an INS that sits across the vehicle, whose pitch is not that of the road.
  if (!is_of_compass(turned.attitude)) return follows_road(turned) && !follows_road(best);
  return slope_agrees(turned) || !slope_agrees(best);
}

/// The likeliest of the same columns that is better; nothing where none is.
std::optional<std::size_t> best_of(const std::vector<Hypothesis>& turned, const Hypothesis& best) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < turned.size(); ++i)
    if (same_columns(turned[i].attitude, best.attitude) && is_better(turned[i], best) &&
        (!found || turned[i].score_rad < turned[*found].score_rad))
      found = i;
  return found;
}

/// As the columns are called, with signs turned; nothing where letters tell them, or where both are and one is negative
/// already.
std::optional<PositionReading> with_turned(const SampledTable& table, const PositionReading& position,
                                           const TimeReading& time, const std::array<bool, 2>& negated) {
  PositionReading turned = position;
  if (turned.exchanged) std::swap(turned.at[0], turned.at[1]);
  turned.exchanged = false;
  turned.negated = negated;
  for (std::size_t i = 0; i < 2; ++i) {
    if (negated[i] && turned.sides[i]) return std::nullopt;
    const auto is_negative = [](double value) { return value < 0.0; };
    if (negated[0] && negated[1] && std::ranges::any_of(table.columns[turned.at[i]].values, is_negative))
      return std::nullopt;
  }
  put_metres(table, time, turned);
  return turned;
}

}  // namespace

std::optional<LostSign> find_lost_sign(const SampledTable& table, const ColumnNames& names, const TimeReading& time,
                                       const Hypothesis& best, const Progress& progress) {
  constexpr double kKeepsTo_rad = 10.0 * kDegree_rad;
  if (!best.position->geodetic || !moves(best) || best.fit.turned_rad < kLeastTurned_rad) return std::nullopt;
  if (is_as_called(best) && best.fit.residual_rad < kKeepsTo_rad) return std::nullopt;
  constexpr std::array<std::array<bool, 2>, 3> kTurned{{{false, true}, {true, false}, {true, true}}};
  std::optional<LostSign> found;
  for (const std::array<bool, 2>& negated : kTurned) {
    const auto position = with_turned(table, *best.position, time, negated);
    if (!position) continue;
    LostSign one{{*position}, {}, 0};
    one.all = hypotheses_of(table, names, time, one.position, progress);
    const auto better = best_of(one.all, best);
    if (!better || (found && found->hypothesis().score_rad < one.all[*better].score_rad)) continue;
    one.best = *better;
    found = std::move(one);
  }
  return found;
}

}  // namespace remount::guesses
