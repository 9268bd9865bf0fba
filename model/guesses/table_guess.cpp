#include "model/guesses/table_guess.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "messages/guesses.h"
#include "model/conventions/week_of_log.h"
#include "model/drive/bad_items.h"
#include "model/formats/files/text_file.h"
#include "model/guesses/motion_guess.h"

namespace remount::guesses {
namespace {

Guess rows_guess(const SampledTable& table, const TimeReading& time, std::size_t samples) {
  const double rate_hz = rows_per_second(table, time);
  Guess guess{GuessKind::Rows, {}, "", Sureness::Checked, {}, {}};
  guess.evidence.push_back(
      say::guess_rows(samples, table.rows, Frequency{rate_hz}, Duration{time.last_s - time.first_s}));
  if (table.text.decimal_commas) guess.evidence.push_back(say::guess_decimal_commas());
  return guess;
}

/// Everything that the manifest will say is read as its reader reads it.
bool read_as_declared(const FoundTable& found, InsGuess& ins, std::vector<Message>& missing) {
  std::vector<drive::Finding> findings;
  try {
    const std::string text = formats::read_text_file(found.file);
    const auto take = [&](const auto& items) {
      ins.samples = items.size();
      ins.span = {items.front().stamp_ns, items.back().stamp_ns};
    };
    if (ins.layout.metric_position)
      take(formats::parse_pose_table(text, found.file, ins.layout, findings));
    else
      take(formats::parse_ins_table(text, found.file, ins.layout, findings));
  } catch (const Error& error) {
    missing.push_back(say::guess_refused(drive::message_of(error)));
    return false;
  }
  return true;
}

}  // namespace

std::optional<InsGuess> guess_ins_of(const FoundTable& found, const std::vector<std::int64_t>& stamps_ns,
                                     const Progress& progress, std::vector<Message>& missing) {
  const ColumnNames names = names_of(found.table);
  const auto lack = [&](Message what) {
    missing.push_back(std::move(what));
    for (Message& unread : unread_units(found.table, names)) missing.push_back(std::move(unread));
  };
  auto time = choose_time(found.table, names, stamps_ns);
  if (!time) {
    lack(say::guess_no_time());
    return std::nullopt;
  }
  std::vector<Message> lacks;
  auto motion = choose_motion(found.table, names, time->reading, progress, lacks);
  for (Message& what : lacks) lack(std::move(what));
  if (!motion) return std::nullopt;
  InsGuess ins{.file = found.file, .layout = std::move(motion->layout)};
  ins.week_open = time->reading.week_open();
  static_cast<formats::TimeColumns&>(ins.layout) = time->reading.columns;
  ins.layout.text = found.table.text;
  if (!read_as_declared(found, ins, missing)) return std::nullopt;
  ins.guesses = {rows_guess(found.table, time->reading, ins.samples), std::move(time->guess),
                 std::move(motion->position), std::move(motion->attitude)};
  for (Guess& guess : motion->others) ins.guesses.push_back(std::move(guess));
  return ins;
}

void place_in_week(InsGuess& ins, const std::vector<std::int64_t>& stamps_ns) {
  if (!ins.week_open || stamps_ns.empty()) return;
  const auto [first, last] = std::ranges::minmax_element(stamps_ns);
  const conventions::TimeSpan scans{*first, *last}, span = ins.span;
  ins.span = {conventions::placed_in_week_ns(span.first_ns, span, scans),
              conventions::placed_in_week_ns(span.last_ns, span, scans)};
}

}  // namespace remount::guesses
