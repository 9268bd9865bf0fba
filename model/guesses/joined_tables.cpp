#include "model/guesses/joined_tables.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithms/core/error.h"
#include "algorithms/core/median.h"
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
      : positions_(positions) {
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
      const bool letters = &table == &positions_ && !table.columns[i].numeric;
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

  const SampledTable& positions_;
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
  const TimeReading &of_places = place_time->reading, &of_turns = turn_time->reading;
  if (of_places.week_open() != of_turns.week_open() || of_places.last_s < of_turns.first_s ||
      of_turns.last_s < of_places.first_s) {
    missing.push_back(say::guess_tables_apart(positions.file.filename().string(), attitudes.file.filename().string()));
    return std::nullopt;
  }
  const JoinedTable joined(positions.table, of_places, attitudes.table, of_turns);
  auto motion = choose_motion(joined.table(), names_of(joined.table()), joined.time(), progress, missing);
  if (!motion) return std::nullopt;
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
