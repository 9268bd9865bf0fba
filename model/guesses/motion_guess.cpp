#include "model/guesses/motion_guess.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "algorithms/geometry/degree.h"
#include "algorithms/geometry/rotation.h"
#include "messages/guesses.h"
#include "model/guesses/error_columns.h"
#include "model/guesses/lost_sign.h"
#include "model/guesses/motion_hypotheses.h"

namespace remount::guesses {
namespace {

using drive::AttitudeConvention;

/// Other ways to count the same columns that the drive does not refute.
std::vector<const Hypothesis*> others_alike(const std::vector<Hypothesis>& all, const Hypothesis& best) {
  constexpr double kWithin_rad = 2.0 * kDegree_rad;
  std::vector<const Hypothesis*> alike;
  for (const Hypothesis& other : all) {
    if (other.position != best.position || !same_columns(other.attitude, best.attitude) ||
        other.attitude.words() == best.attitude.words())
      continue;
    const bool fits = other.fit.residual_rad < best.fit.residual_rad + kWithin_rad && is_set_square(other.fit);
    if (!moves(best) || fits) alike.push_back(&other);
  }
  return alike;
}

/// Whether readings differ by a constant angle alone, in which the direction of travel fits both alike.
bool turn_alike(const AttitudeReading& a, const AttitudeReading& b) {
  const auto clockwise = [](const AttitudeReading& one) {
    return (one.convention != AttitudeConvention::EnuYaw) == (one.signs[0] > 0.0);
  };
  return !a.quaternion && !b.quaternion && same_columns(a, b) && a.unit_rad == b.unit_rad &&
         clockwise(a) == clockwise(b);
}

/// The best that turns otherwise: what the drive has to refute.
const Hypothesis* best_rival(const std::vector<Hypothesis>& all, const Hypothesis& best) {
  const Hypothesis* rival = nullptr;
  for (const Hypothesis& other : all) {
    if (other.position != best.position || turn_alike(other.attitude, best.attitude)) continue;
    if (other.attitude.quaternion && same_columns(other.attitude, best.attitude) &&
        other.attitude.quaternion == best.attitude.quaternion)
      continue;
    if (!rival || other.score_rad < rival->score_rad) rival = &other;
  }
  return rival;
}

/// Whether two take x and y the one for the other.
bool is_mirrored(const PositionReading& a, const PositionReading& b) {
  return !a.geodetic && !b.geodetic && a.exchanged != b.exchanged && a.at[0] == b.at[1] && a.at[1] == b.at[0] &&
         a.at[2] == b.at[2];
}

/// The best that takes x and y the one for the other and fits alike, which no drive can tell; null where none does.
const Hypothesis* mirrored_alike(const std::vector<Hypothesis>& all, const Hypothesis& best) {
  constexpr double kWithin_rad = 2.0 * kDegree_rad, kStraightAhead_rad = 15.0 * kDegree_rad;
  const Hypothesis* mirrored = nullptr;
  for (const Hypothesis& other : all) {
    if (!is_mirrored(*other.position, *best.position) || !same_columns(other.attitude, best.attitude)) continue;
    const bool fits =
        other.fit.residual_rad < best.fit.residual_rad + kWithin_rad && size_of_offset(other.fit) < kStraightAhead_rad;
    if (fits && (!mirrored || other.score_rad < mirrored->score_rad)) mirrored = &other;
  }
  return mirrored;
}

std::string axes_words(const SampledTable& table, const PositionReading& position) {
  return "position: {east: " + table.label(position.at[0]) + ", north: " + table.label(position.at[1]) +
         (position.down ? ", down: " : ", up: ") + table.label(position.at[2]) + "}";
}

void put_attitude(const SampledTable& table, const AttitudeReading& attitude, formats::InsTableLayout& layout) {
  if (attitude.quaternion) {
    layout.quaternion = attitude.quaternion;
    for (std::size_t i = 0; i < 4; ++i) layout.quaternion_xyzw[i] = table.ref(attitude.xyzw[i]);
    return;
  }
  layout.attitude = attitude.convention;
  layout.attitude_unit_rad = attitude.unit_rad;
  layout.yaw_pitch_roll_signs = attitude.signs;
  for (std::size_t i = 0; i < 3; ++i) layout.yaw_pitch_roll[i] = table.ref(attitude.yaw_pitch_roll[i]);
}

void put_position(const SampledTable& table, const PositionReading& position, formats::InsTableLayout& layout) {
  const auto& [first, second, third] = position.at;
  if (position.geodetic) {
    layout.latitude = table.ref(first), layout.longitude = table.ref(second), layout.height = table.ref(third);
    layout.position_unit = position.unit;
    if (position.sides[0]) layout.latitude_side = table.ref(*position.sides[0]);
    if (position.sides[1]) layout.longitude_side = table.ref(*position.sides[1]);
    for (std::size_t i = 0; i < 2; ++i) layout.place_signs[i] = position.negated[i] ? -1.0 : 1.0;
    return;
  }
  layout.metric_position = {table.ref(first), table.ref(second), table.ref(third)};
  layout.metric_down = position.down;
}

void add_other(const SampledTable& table, const Hypothesis& other, std::string words, Guess& guess) {
  guess.alternatives.push_back(Message::verbatim(std::move(words)));
  formats::InsTableLayout& layout = guess.other_layouts.emplace_back();
  put_position(table, *other.position, layout);
  put_attitude(table, other.attitude, layout);
}

/// "pose.position.x" and "pose.orientation.w": messages of ROS, whose axes are agreed on.
bool is_of_ros(const SampledTable& table, const Hypothesis& best) {
  const auto has = [&](std::size_t column, std::string_view word) {
    return table.columns[column].title.find(word) != std::string::npos;
  };
  return best.attitude.quaternion && has(best.position->at[0], "position.") &&
         has(best.attitude.xyzw[0], "orientation.");
}

/// A compass heading decides: from north, clockwise. All else goes with x to the east as with x to the north.
void judge_axes(const SampledTable& table, const std::vector<Hypothesis>& all, const Hypothesis& best, Guess& guess) {
  const Hypothesis* mirrored = moves(best) ? mirrored_alike(all, best) : nullptr;
  const bool decided = best.attitude.telling_name && best.attitude.usual_for_name && !best.position->exchanged;
  if (!mirrored || decided || is_of_ros(table, best)) return;
  guess.sureness = Sureness::Open;
  guess.evidence.push_back(best.attitude.quaternion ? say::guess_down_not_told() : say::guess_axes_not_told());
  add_other(table, *mirrored,
            axes_words(table, *mirrored->position) + ", attitude: {" + mirrored->attitude.words() + "}", guess);
}

/// How an attitude counts, and of which columns where they are not those of the other.
std::string words_beside(const SampledTable& table, const AttitudeReading& one, const AttitudeReading& other) {
  if (same_columns(one, other)) return one.words();
  std::string words;
  for (const std::size_t column : one.columns()) words += (words.empty() ? "" : ", ") + table.label(column);
  return words + ": " + one.words();
}

void judge_by_travel(const SampledTable& table, const std::vector<Hypothesis>& all, const Hypothesis& best,
                     Guess& guess) {
  constexpr double kKeepsTo_rad = 10.0 * kDegree_rad, kClose_rad = 3.0 * kDegree_rad, kFarBetter = 3.0,
                   kStraightAhead_rad = 15.0 * kDegree_rad;
  const TravelFit& fit = best.fit;
  if (!moves(best)) {
    guess.evidence.push_back(say::guess_hardly_moves(fit.steps));
    guess.sureness = Sureness::Open;
    return;
  }
  guess.evidence.push_back(say::guess_heading_fits(Angle{fit.residual_rad}, fit.steps, Angle{fit.turned_rad}));
  const Hypothesis* rival = best_rival(all, best);
  const bool far_better = rival && rival->score_rad > kFarBetter * best.score_rad;
  const bool turns = fit.turned_rad > kLeastTurned_rad;
  if (fit.residual_rad > kKeepsTo_rad) {
    guess.evidence.push_back(say::guess_heading_against_travel());
    guess.sureness = Sureness::Open;
  } else if (turns && (far_better || !rival)) {
    if (rival)
      guess.evidence.push_back(
          say::guess_rival(words_beside(table, rival->attitude, best.attitude), Angle{rival->fit.residual_rad}));
    const bool close = fit.residual_rad < kClose_rad && size_of_offset(fit) < kStraightAhead_rad;
    guess.sureness = close ? Sureness::Checked : Sureness::Likely;
  } else {
    guess.evidence.push_back(say::guess_straight(Angle{fit.turned_rad}));
    const auto ahead = [&](const TravelFit& one) { return size_of_offset(one) < kStraightAhead_rad; };
    const bool others = std::ranges::any_of(others_alike(all, best), [&](const auto* one) { return ahead(one->fit); });
    const bool named = best.attitude.telling_name && best.attitude.usual_for_name;
    guess.sureness = !ahead(fit) || (others && !named) ? Sureness::Open : others ? Sureness::Named : Sureness::Likely;
  }
  if (size_of_offset(fit) >= kStraightAhead_rad)
    guess.evidence.push_back(say::guess_heading_offset(Angle{fit.offset_rad}));
}

/// Others with the same heading and pitch, whose roll is another column: no drive tells it.
void judge_roll_column(const std::vector<Hypothesis>& all, const SampledTable& table, const Hypothesis& best,
                       Guess& guess) {
  constexpr double kUpright = 0.95;
  const auto& [yaw, pitch, roll] = best.attitude.yaw_pitch_roll;
  for (const Hypothesis& other : all) {
    const auto& columns = other.attitude.yaw_pitch_roll;
    if (other.attitude.quaternion || other.position != best.position || columns[0] != yaw || columns[1] != pitch ||
        columns[2] == roll || other.attitude.words() != best.attitude.words() || other.fit.upright < kUpright)
      continue;
    if (guess.sureness != Sureness::Open) guess.evidence.push_back(say::guess_roll_column_not_told());
    guess.sureness = Sureness::Open;
    add_other(table, other, "roll: " + table.label(columns[2]) + ", " + other.attitude.words(), guess);
  }
}

void judge_tilt(const Hypothesis& best, Guess& guess) {
  if (!moves(best)) return;
  const bool angles = !best.attitude.quaternion;
  switch (best.fit.slope) {
    case SlopeFit::Agrees:
      guess.evidence.push_back(say::guess_pitch_fits(Angle{best.fit.slope_sigma_rad}));
      break;
    case SlopeFit::Opposite:
      guess.evidence.push_back(say::guess_pitch_opposite());
      break;
    case SlopeFit::Unrelated:
      guess.evidence.push_back(say::guess_pitch_unrelated());
      break;
    case SlopeFit::NotTold:
      if (angles) guess.evidence.push_back(say::guess_pitch_not_told());
  }
  if (angles) guess.evidence.push_back(say::guess_roll_not_told());
}

Guess attitude_guess(const SampledTable& table, const std::vector<Hypothesis>& all, const Hypothesis& best) {
  Guess guess{GuessKind::Attitude, {}, best.attitude.quaternion ? "" : best.attitude.unit_rad == 1.0 ? "rad" : "deg",
              Sureness::Open,      {}, {}};
  for (const std::size_t column : best.attitude.columns()) guess.columns.push_back(table.label(column));
  if (!best.attitude.by_name) guess.evidence.push_back(say::guess_by_behaviour());
  judge_by_travel(table, all, best, guess);
  judge_tilt(best, guess);
  // Of columns without names nothing tells roll, and of a pitch that does not follow the road nothing is checked.
  const bool angles = !best.attitude.quaternion;
  if (guess.sureness == Sureness::Checked && angles &&
      (!best.attitude.by_name || best.fit.slope == SlopeFit::Unrelated))
    guess.sureness = Sureness::Likely;
  if (angles && !best.attitude.by_name) judge_roll_column(all, table, best, guess);
  if (guess.sureness != Sureness::Checked)
    for (const Hypothesis* other : others_alike(all, best)) add_other(table, *other, other->attitude.words(), guess);
  judge_axes(table, all, best, guess);
  return guess;
}

/// The same with its third column counted the other way; null where it was not tried.
const Hypothesis* turned_over(const std::vector<Hypothesis>& all, const Hypothesis& best) {
  const auto found = std::ranges::find_if(all, [&](const Hypothesis& other) {
    return other.position->at == best.position->at && other.position->down != best.position->down &&
           same_columns(other.attitude, best.attitude) && other.attitude.convention == best.attitude.convention &&
           other.attitude.signs[0] == best.attitude.signs[0] && other.attitude.unit_rad == best.attitude.unit_rad;
  });
  return found == all.end() ? nullptr : &*found;
}

/// x to the north is unusual, and z may go with it upwards or downwards: rising roads tell as far as pitch counts as it
/// usually does.
void judge_exchanged(const SampledTable& table, const std::vector<Hypothesis>& all, const Hypothesis& best,
                     Guess& guess) {
  const PositionReading& position = *best.position;
  if (!position.exchanged) return;
  if (position.geodetic) {
    guess.evidence.push_back(say::guess_latitude_exchanged());
    guess.sureness = Sureness::Open;
    return;
  }
  guess.evidence.push_back(say::guess_x_is_north());
  guess.sureness = Sureness::Likely;
  const Hypothesis* other = turned_over(all, best);
  if (!other || (best.fit.slope == SlopeFit::Agrees && !position.down)) return;
  guess.sureness = Sureness::Open;
  add_other(table, *other, axes_words(table, *other->position) + ", attitude: {" + other->attitude.words() + "}",
            guess);
}

/// Degrees and minutes show in minutes that never reach 60, small parts of a degree in numbers that are whole.
void judge_place_unit(const SampledTable& table, const PositionReading& position, Guess& guess) {
  if (!position.geodetic || position.unit_by_name) return;
  double largest = 0.0, most_minutes = 0.0;
  for (const std::size_t column : {position.at[0], position.at[1]})
    for (const double value : table.columns[column].values) {
      if (!std::isfinite(value)) continue;
      largest = std::max(largest, std::abs(value));
      most_minutes = std::max(most_minutes, formats::minutes_of_place(value));
    }
  if (position.unit == formats::PlaceUnit::DegreesMinutes) {
    guess.evidence.push_back(say::guess_unit_is_minutes(largest, most_minutes));
    guess.sureness = Sureness::Likely;
  } else if (position.unit == formats::PlaceUnit::TenMillionths) {
    guess.evidence.push_back(say::guess_unit_is_small(largest));
    guess.sureness = position.other_unit_fits ? Sureness::Open : Sureness::Likely;
    if (position.other_unit_fits) guess.evidence.push_back(say::guess_unit_may_be_millionths());
  } else {
    guess.evidence.push_back(say::guess_unit_by_size(guess.unit));
  }
}

Guess position_guess(const SampledTable& table, const std::vector<Hypothesis>& all, const Hypothesis& best) {
  const PositionReading& position = *best.position;
  Guess guess{GuessKind::Position,
              {},
              position.geodetic ? std::string(to_string(position.unit)) : "m",
              position.by_name ? Sureness::Named : Sureness::Likely,
              {},
              {}};
  for (const std::size_t column : position.at) guess.columns.push_back(table.label(column));
  if (!position.by_name) guess.evidence.push_back(say::guess_position_by_movement());
  for (const std::optional<std::size_t>& side : position.sides)
    if (side) guess.columns.push_back(table.label(*side));
  judge_place_unit(table, position, guess);
  guess.evidence.push_back(say::guess_way(Length{position.way_m}));
  if (position.above_sea) guess.evidence.push_back(say::guess_above_sea());
  judge_exchanged(table, all, best, guess);
  return guess;
}

/// Which sign is right is told by a map, not by the drive.
void tell_lost_sign(const SampledTable& table, const Hypothesis& as_it_stands, const LostSign& lost,
                    ChosenMotion& chosen) {
  const Hypothesis& turned = lost.hypothesis();
  std::vector<std::string> columns;
  for (std::size_t i = 0; i < 2; ++i)
    if (turned.position->negated[i]) columns.push_back(table.label(turned.position->at[i]));
  chosen.position.sureness = Sureness::Open;
  chosen.position.evidence.push_back(lost.mirrored() ? say::guess_sign_lost(std::move(columns))
                                                     : say::guess_signs_lost(std::move(columns)));
  const Hypothesis& other = lost.mirrored() ? as_it_stands : turned;
  const std::string negated = lost.mirrored() ? "false" : "true";
  add_other(table, other, "negated: " + negated + ", attitude: {" + other.attitude.words() + "}", chosen.position);
  if (chosen.attitude.sureness == Sureness::Checked) chosen.attitude.sureness = Sureness::Likely;
}

/// Of columns that are called alike the first was taken.
void tell_named_alike(const SampledTable& table, const ColumnNames& names, std::span<const std::size_t> columns,
                      Guess& guess) {
  for (const std::size_t column : columns)
    if (const std::vector<std::string> others = others_called_alike(table, names, column); !others.empty())
      guess.evidence.push_back(say::guess_called_alike(others, table.label(column)));
}

}  // namespace

std::optional<ChosenMotion> choose_motion(const SampledTable& table, const ColumnNames& names, const TimeReading& time,
                                          const Progress& progress, std::vector<Message>& missing) {
  const std::vector<PositionReading> positions = position_readings(table, names, time);
  if (positions.empty()) {
    missing.push_back(has_geocentric_columns(table) ? say::guess_geocentric() : say::guess_no_position());
    return std::nullopt;
  }
  std::vector<Hypothesis> all = hypotheses_of(table, names, time, positions, progress);
  if (progress.cancelled()) return std::nullopt;
  if (all.empty()) {
    missing.push_back(say::guess_no_attitude());
    return std::nullopt;
  }
  const Hypothesis& best = *std::ranges::min_element(all, {}, &Hypothesis::score_rad);
  settle_pitches(table, time, best, all);
  // Numbers that nobody names are an attitude where they follow the direction of travel through turns.
  constexpr double kFollows_rad = 15.0 * kDegree_rad;
  if (!best.attitude.by_name) {
    const bool turns = moves(best) && best.fit.turned_rad > kLeastTurned_rad;
    if (!turns || best.fit.residual_rad > kFollows_rad) {
      missing.push_back(turns ? say::guess_no_attitude() : say::guess_unnamed_and_still());
      return std::nullopt;
    }
  }
  std::optional<LostSign> lost = find_lost_sign(table, names, time, best, progress);
  if (lost) settle_pitches(table, time, lost->hypothesis(), lost->all);
  const bool mirrored = lost && lost->mirrored();
  const std::vector<Hypothesis>& meant = mirrored ? lost->all : all;
  const Hypothesis& taken = mirrored ? lost->hypothesis() : best;
  ChosenMotion chosen;
  chosen.fit = taken.fit;
  chosen.exchanged = taken.position->exchanged;
  put_position(table, *taken.position, chosen.layout);
  put_attitude(table, taken.attitude, chosen.layout);
  chosen.position = position_guess(table, meant, taken);
  chosen.attitude = attitude_guess(table, meant, taken);
  if (lost) tell_lost_sign(table, best, *lost, chosen);
  tell_named_alike(table, names, taken.position->at, chosen.position);
  tell_named_alike(table, names, taken.attitude.columns(), chosen.attitude);
  put_errors(table, names, chosen);
  return chosen;
}

}  // namespace remount::guesses
