#include "model/guesses/table_guess.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "messages/guesses.h"
#include "model/conventions/week_of_log.h"
#include "model/drive/bad_items.h"
#include "model/formats/files/text_file.h"
#include "model/guesses/motion_guess.h"
#include "model/guesses/unread_times.h"

namespace remount::guesses {
namespace {

/// Everything that the manifest will say is read as its reader reads it.
bool read_as_declared(const FoundTable& found, InsGuess& ins, std::vector<drive::Finding>& findings,
                      std::vector<Message>& missing) {
  try {
    const std::string text = formats::read_text_file(found.file);
    if (ins.layout.metric_position)
      put_times_of(formats::parse_pose_table(text, found.file, ins.layout, findings), ins);
    else
      put_times_of(formats::parse_ins_table(text, found.file, ins.layout, findings), ins);
  } catch (const Error& error) {
    missing.push_back(say::guess_refused(drive::message_of(error)));
    return false;
  }
  return true;
}

}  // namespace

Guess rows_guess(const SampledTable& table, const TimeReading& time, std::size_t samples, const Message& left_out) {
  const double span_s = time.last_s - time.first_s;
  const double rate_hz = span_s > 0.0 ? static_cast<double>(samples - 1) / span_s : 0.0;
  const bool few = 2 * samples < table.rows;
  Guess guess{GuessKind::Rows, {}, "", few ? Sureness::Likely : Sureness::Checked, {}, {}};
  guess.evidence.push_back(say::guess_rows(samples, table.rows, Frequency{rate_hz}, Duration{span_s}));
  if (samples < table.rows && !left_out.empty()) guess.evidence.push_back(left_out);
  if (table.text.no_value)
    guess.evidence.push_back(say::guess_no_value_number(*table.text.no_value, table.no_value_in));
  if (table.text.decimal_commas) guess.evidence.push_back(say::guess_decimal_commas());
  return guess;
}

std::optional<InsGuess> guess_ins_of(const FoundTable& found, const std::vector<std::int64_t>& stamps_ns,
                                     const Progress& progress, std::vector<Message>& missing) {
  const ColumnNames names = names_of(found.table);
  const auto lack = [&](Message what) {
    missing.push_back(std::move(what));
    for (Message& unread : unread_units(found.table, names)) missing.push_back(std::move(unread));
  };
  auto time = choose_time(found.table, names, stamps_ns);
  // What counts the rows goes for a time only where no column is called one.
  const bool counter = time && !time->reading.by_name && time->reading.counts;
  if (!time || (counter && has_unread_time(found.table, names))) {
    for (Message& why : why_no_time(found.table, names)) lack(std::move(why));
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
  std::vector<drive::Finding> findings;
  if (!read_as_declared(found, ins, findings, missing)) return std::nullopt;
  const Message left_out = findings.empty() ? Message() : findings.front().explanation;
  ins.guesses = {rows_guess(found.table, time->reading, ins.samples, left_out), std::move(time->guess),
                 std::move(motion->position), std::move(motion->attitude)};
  for (Guess& guess : motion->others) ins.guesses.push_back(std::move(guess));
  return ins;
}

void place_in_week(InsGuess& ins, const std::vector<std::int64_t>& stamps_ns) {
  if (!ins.week_open || stamps_ns.empty()) return;
  const auto [first, last] = std::ranges::minmax_element(stamps_ns);
  const conventions::TimeSpan scans{*first, *last}, span = ins.span;
  const auto placed = [&](const conventions::TimeSpan& one) {
    return conventions::TimeSpan{conventions::placed_in_week_ns(one.first_ns, span, scans),
                                 conventions::placed_in_week_ns(one.last_ns, span, scans)};
  };
  ins.span = placed(span);
  for (conventions::TimeSpan& stretch : ins.stretches) stretch = placed(stretch);
}

}  // namespace remount::guesses
