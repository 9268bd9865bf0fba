#include "model/guesses/joined_tables.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithms/core/error.h"
#include "algorithms/core/median.h"
#include "algorithms/geometry/degree.h"
#include "algorithms/geometry/rotation.h"
#include "messages/guesses.h"
#include "model/drive/bad_items.h"
#include "model/formats/files/text_file.h"
#include "model/formats/ins/two_tables.h"
#include "model/guesses/motion_guess.h"
#include "model/guesses/table_guess.h"

namespace remount::guesses {
namespace {

/// What is taken of the positions; of the other table everything of its attitudes.
bool is_of_position(Quantity quantity) {
  constexpr Quantity kAll[] = {Quantity::Latitude, Quantity::Longitude, Quantity::Height,    Quantity::SeaHeight,
                               Quantity::Up,       Quantity::Z,         Quantity::SigmaEast, Quantity::SigmaNorth,
                               Quantity::SigmaUp,  Quantity::Quality};
  return std::ranges::find(kAll, quantity) != std::end(kAll);
}
bool is_of_attitude(Quantity quantity) {
  constexpr Quantity kAll[] = {Quantity::Roll,      Quantity::Pitch,      Quantity::Heading,     Quantity::Yaw,
                               Quantity::Qx,        Quantity::Qy,         Quantity::Qz,          Quantity::Qw,
                               Quantity::SigmaRoll, Quantity::SigmaPitch, Quantity::SigmaHeading};
  return std::ranges::find(kAll, quantity) != std::end(kAll);
}

/// Rows of one table beside those of another, by their times.
class NearestRows {
 public:
  explicit NearestRows(const TimeReading& time) {
    for (std::size_t row = 0; row < time.times_s.size(); ++row)
      if (std::isfinite(time.times_s[row]) && (rows_.empty() || time.times_s[row] > rows_.back().first))
        rows_.emplace_back(time.times_s[row], row);
    std::vector<double> steps_s;
    for (std::size_t i = 1; i < rows_.size(); ++i) steps_s.push_back(rows_[i].first - rows_[i - 1].first);
    if (!steps_s.empty()) period_s_ = median_of(std::move(steps_s));
  }

  double period_s() const { return period_s_; }

  std::optional<std::size_t> nearest(double time_s) const {
    if (!std::isfinite(time_s) || rows_.empty()) return std::nullopt;
    auto after = std::ranges::lower_bound(rows_, time_s, {}, &std::pair<double, std::size_t>::first);
    if (after == rows_.end()) --after;
    if (after != rows_.begin() && time_s - (after - 1)->first < std::abs(after->first - time_s)) --after;
    return std::abs(after->first - time_s) <= period_s_ ? std::optional(after->second) : std::nullopt;
  }

 private:
  std::vector<std::pair<double, std::size_t>> rows_;
  double period_s_ = 0.0;
};

/// One table of both: rows are those of the one that has fewer, and the nearest of the other.
class JoinedTable {
 public:
  JoinedTable(const SampledTable& positions, const TimeReading& position_time, const SampledTable& attitudes,
              const TimeReading& attitude_time)
      : positions_(&positions) {
    const NearestRows places(position_time), turns(attitude_time);
    const bool by_places = places.period_s() >= turns.period_s();
    time_ = by_places ? position_time : attitude_time;
    time_.at = {};
    joined_.path = positions.path;
    joined_.rows = by_places ? positions.rows : attitudes.rows;
    add(positions, is_of_position, by_places ? nullptr : &places);
    add(attitudes, is_of_attitude, by_places ? &turns : nullptr);
  }

  const SampledTable& table() const { return joined_; }
  const TimeReading& time() const { return time_; }

  /// As the table has it that the column comes from.
  formats::ColumnRef ref(const formats::ColumnRef& joined) const {
    const auto& [of, column] = origins_[joined.index];
    return of->ref(column);
  }

 private:
  void add(const SampledTable& table, bool (*is_taken)(Quantity), const NearestRows* nearest) {
    const ColumnNames names = names_of(table);
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const bool letters = &table == positions_ && !table.columns[i].numeric;
      if (!letters && !(names[i] && is_taken(names[i]->quantity))) continue;
      SampledColumn column = table.columns[i];
      column.index = joined_.columns.size();
      if (nearest != nullptr) column.values = values_beside(table.columns[i].values, *nearest);
      joined_.columns.push_back(std::move(column));
      origins_.emplace_back(&table, i);
    }
  }

  std::vector<double> values_beside(const std::vector<double>& values, const NearestRows& nearest) const {
    std::vector<double> beside;
    for (const double time_s : time_.times_s) {
      const auto row = nearest.nearest(time_s);
      beside.push_back(row ? values[*row] : std::nan(""));
    }
    return beside;
  }

  const SampledTable* positions_;
  SampledTable joined_;
  TimeReading time_;
  std::vector<std::pair<const SampledTable*, std::size_t>> origins_;
};

template <std::size_t N>
void put_refs(const JoinedTable& joined, std::array<formats::ColumnRef, N>& refs) {
  for (formats::ColumnRef& ref : refs) ref = joined.ref(ref);
}
void put_ref(const JoinedTable& joined, std::optional<formats::ColumnRef>& ref) {
  if (ref) ref = joined.ref(*ref);
}

/// The layouts of both, with the columns of each as it has them.
void part_layouts(const JoinedTable& joined, const formats::InsTableLayout& both, InsGuess& ins) {
  formats::InsTableLayout places = both, turns = both;
  places.holds = formats::TableHolds::Positions;
  places.attitude_sigma_yaw_pitch_roll.reset();
  for (formats::ColumnRef* ref : {&places.latitude, &places.longitude, &places.height}) *ref = joined.ref(*ref);
  put_ref(joined, places.latitude_side);
  put_ref(joined, places.longitude_side);
  put_ref(joined, places.quality);
  if (places.position_sigma_enu) put_refs(joined, *places.position_sigma_enu);
  turns.holds = formats::TableHolds::Attitudes;
  turns.position_sigma_enu.reset();
  turns.quality.reset();
  if (turns.quaternion)
    put_refs(joined, turns.quaternion_xyzw);
  else
    put_refs(joined, turns.yaw_pitch_roll);
  if (turns.attitude_sigma_yaw_pitch_roll) put_refs(joined, *turns.attitude_sigma_yaw_pitch_roll);
  ins.layout = std::move(places);
  ins.attitude->layout = std::move(turns);
}

/// Everything that the manifest will say is read as its reader reads it.
bool read_both_as_declared(InsGuess& ins, std::vector<Guess>& rows, const FoundTable& positions,
                           const FoundTable& attitudes, const std::array<const TimeReading*, 2>& times,
                           std::vector<Message>& missing) {
  try {
    std::vector<drive::Finding> of_places, of_turns, of_both;
    auto places = formats::parse_ins_table(formats::read_text_file(ins.file), ins.file, ins.layout, of_places);
    const auto turns = formats::parse_attitude_table(formats::read_text_file(ins.attitude->file), ins.attitude->file,
                                                     ins.attitude->layout, of_turns);
    const auto said = [](const std::vector<drive::Finding>& findings) {
      return findings.empty() ? Message() : findings.front().explanation;
    };
    rows.push_back(rows_guess(positions.table, *times[0], places.size(), said(of_places)));
    rows.push_back(rows_guess(attitudes.table, *times[1], turns.size(), said(of_turns)));
    put_times_of(formats::join_tables(std::move(places), turns, ins.attitude->file.string(), of_both).ins, ins);
    rows.back().evidence.push_back(say::guess_joined(ins.samples));
    if (!of_both.empty()) rows.back().evidence.push_back(of_both.front().explanation);
  } catch (const Error& error) {
    missing.push_back(say::guess_refused(drive::message_of(error)));
    return false;
  }
  return true;
}

// ---- Tables of two clocks

TimeReading later_by(TimeReading time, double added_s) {
  for (double& time_s : time.times_s) time_s += added_s;
  time.first_s += added_s, time.last_s += added_s;
  time.columns.offset_ns += static_cast<std::int64_t>(std::llround(1e9 * added_s));
  return time;
}

/// What must be added to the times of attitudes that do not follow the travel as they stand.
class ClockSearch {
 public:
  ClockSearch(const FoundTable& positions, const TimeReading& of_places, const FoundTable& attitudes,
              const TimeReading& of_turns, const Progress& progress)
      : positions_(positions), of_places_(of_places), attitudes_(attitudes), of_turns_(of_turns), progress_(progress) {}

  /// Nothing where they follow it, and where no time makes them. Looks as far as clocks of receivers differ. Where a
  /// drive repeats itself several times do: of these that with most of both tables beside each other.
  std::optional<double> added_s(const ChosenMotion& as_it_stands) const {
    constexpr double kFollows_rad = 2.0 * kDegree_rad, kAlike_rad = 0.5 * kDegree_rad, kFarBetter = 3.0,
                     kFarthest_s = 40.0, kStep_s = 0.5, kFinest_s = 0.02;
    if (!as_it_stands.exchanged && as_it_stands.fit.residual_rad < kFollows_rad) return std::nullopt;
    std::vector<Shift> shifts;
    for (double added_s = -kFarthest_s; added_s <= kFarthest_s; added_s += kStep_s) shifts.push_back(shift_by(added_s));
    const double closest_rad = std::ranges::min_element(shifts, {}, &Shift::score_rad)->score_rad + kAlike_rad;
    std::erase_if(shifts, [&](const Shift& one) { return one.score_rad > closest_rad; });
    Shift best = *std::ranges::max_element(shifts, {}, &Shift::steps);
    for (double step_s = kStep_s / 5.0; step_s >= kFinest_s; step_s /= 5.0) {
      const double middle_s = best.added_s;
      for (double added_s = middle_s - 5.0 * step_s; added_s <= middle_s + 5.0 * step_s; added_s += step_s)
        if (const Shift one = shift_by(added_s); one.score_rad < best.score_rad) best = one;
    }
    const bool far_better = kFarBetter * best.score_rad < score_of(as_it_stands);
    return best.score_rad < kFollows_rad && far_better ? std::optional(best.added_s) : std::nullopt;
  }

 private:
  struct Shift {
    double added_s = 0.0, score_rad = kPi;
    std::size_t steps = 0;  ///< of the travel
  };

  static double score_of(const ChosenMotion& motion) {
    constexpr double kNone_rad = kPi, kOfOffset = 0.1;
    const bool told = !motion.exchanged && motion.fit.steps >= kFewestTravelSteps;
    return told ? motion.fit.residual_rad + kOfOffset * std::abs(motion.fit.offset_rad) : kNone_rad;
  }
  Shift shift_by(double added_s) const {
    std::vector<Message> missing;
    const JoinedTable joined(positions_.table, of_places_, attitudes_.table, later_by(of_turns_, added_s));
    const auto motion = choose_motion(joined.table(), names_of(joined.table()), joined.time(), progress_, missing);
    return motion ? Shift{added_s, score_of(*motion), motion->fit.steps} : Shift{added_s};
  }

  const FoundTable& positions_;
  const TimeReading& of_places_;
  const FoundTable& attitudes_;
  const TimeReading& of_turns_;
  const Progress& progress_;
};

}  // namespace

std::optional<InsGuess> guess_ins_of_two(const FoundTable& positions, const FoundTable& attitudes,
                                         const std::vector<std::int64_t>& stamps_ns, const Progress& progress,
                                         std::vector<Message>& missing) {
  auto place_time = choose_time(positions.table, names_of(positions.table), stamps_ns);
  auto turn_time = choose_time(attitudes.table, names_of(attitudes.table), stamps_ns);
  if (!place_time || !turn_time) {
    missing.push_back(say::guess_no_time());
    return std::nullopt;
  }
  const TimeReading& of_places = place_time->reading;
  TimeReading& of_turns = turn_time->reading;
  if (of_places.week_open() != of_turns.week_open() || of_places.last_s < of_turns.first_s ||
      of_turns.last_s < of_places.first_s) {
    missing.push_back(say::guess_tables_apart(positions.file.filename().string(), attitudes.file.filename().string()));
    return std::nullopt;
  }
  JoinedTable joined(positions.table, of_places, attitudes.table, of_turns);
  auto motion = choose_motion(joined.table(), names_of(joined.table()), joined.time(), progress, missing);
  if (!motion) return std::nullopt;
  if (const auto added_s = ClockSearch(positions, of_places, attitudes, of_turns, progress).added_s(*motion)) {
    of_turns = later_by(of_turns, *added_s);
    turn_time->guess.evidence.push_back(say::guess_two_clocks(Duration{*added_s}));
    turn_time->guess.sureness = Sureness::Open;
    joined = JoinedTable(positions.table, of_places, attitudes.table, of_turns);
    motion = choose_motion(joined.table(), names_of(joined.table()), joined.time(), progress, missing);
    if (!motion) return std::nullopt;
  }
  InsGuess ins{.file = positions.file};
  ins.attitude.emplace();
  ins.attitude->file = attitudes.file;
  part_layouts(joined, motion->layout, ins);
  static_cast<formats::TimeColumns&>(ins.layout) = of_places.columns;
  static_cast<formats::TimeColumns&>(ins.attitude->layout) = of_turns.columns;
  ins.layout.text = positions.table.text;
  ins.attitude->layout.text = attitudes.table.text;
  ins.week_open = of_places.week_open();
  std::vector<Guess> rows;
  if (!read_both_as_declared(ins, rows, positions, attitudes, {&of_places, &of_turns}, missing)) return std::nullopt;
  ins.guesses = {std::move(rows[0]), std::move(place_time->guess), std::move(motion->position)};
  ins.attitude->guesses = {std::move(rows[1]), std::move(turn_time->guess), std::move(motion->attitude)};
  for (Guess& guess : motion->others)
    (guess.kind == GuessKind::AttitudeSigma ? ins.attitude->guesses : ins.guesses).push_back(std::move(guess));
  return ins;
}

}  // namespace remount::guesses
