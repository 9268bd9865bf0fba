#include "model/guesses/clock_guess.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "messages/guesses.h"
#include "model/formats/files/running_period.h"
#include "model/formats/files/time_stamp.h"

namespace remount::guesses {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;

/// From the first sample to the last, gaps included.
std::size_t count_within_span(const InsGuess& ins, const std::vector<std::int64_t>& stamps_ns) {
  return static_cast<std::size_t>(std::ranges::count_if(
      stamps_ns, [&](std::int64_t stamp_ns) { return stamp_ns >= ins.span.first_ns && stamp_ns <= ins.span.last_ns; }));
}

Duration longest_gap(const InsGuess& ins) {
  double longest_ns = 0.0;  // stamps may be further apart than an integer holds
  for (std::size_t i = 1; i < ins.stretches.size(); ++i)
    longest_ns = std::max(
        longest_ns, static_cast<double>(ins.stretches[i].first_ns) - static_cast<double>(ins.stretches[i - 1].last_ns));
  return Duration{1e-9 * longest_ns};
}

std::int64_t leap_seconds_ns(const conventions::TimeSpan& ins) {
  return kSecond_ns * formats::leap_seconds_at_gps_s(formats::gps_ns_from_unix_ns(ins.first_ns) / kSecond_ns);
}

/// Whether as many scans lie within where they are moved by the usual difference, either way.
bool covers_leap_seconds(const InsGuess& ins, const std::vector<std::int64_t>& stamps_ns, std::size_t inside) {
  constexpr std::int64_t kToday_ns = std::int64_t{1'483'228'800} * kSecond_ns;  // since 2017
  const bool dated = ins.span.first_ns > formats::kFirstRecording_ns;
  if (!dated && !ins.week_open) return false;
  const std::int64_t leap_ns = leap_seconds_ns(dated ? ins.span : conventions::TimeSpan{kToday_ns, kToday_ns});
  return count_within(ins, stamps_ns, leap_ns) >= inside && count_within(ins, stamps_ns, -leap_ns) >= inside;
}

struct KnownOffset {
  std::int64_t added_ns = 0;  ///< to the times of the INS, as `offset_s` of a manifest is
  Message cause;
};

void add_both_ways(std::int64_t size_ns, const Message& cause, std::vector<KnownOffset>& offsets) {
  for (const std::int64_t sign : {1, -1}) offsets.push_back({sign * size_ns, cause});
}

/// The differences between UTC, GPS and TAI.
std::vector<KnownOffset> offsets_of_scales(const conventions::TimeSpan& ins) {
  constexpr std::int64_t kTaiBeforeGps_ns = 19 * kSecond_ns;
  const std::int64_t leap_ns = leap_seconds_ns(ins);
  std::vector<KnownOffset> offsets;
  add_both_ways(leap_ns, say::guess_offset_leap(), offsets);
  add_both_ways(kTaiBeforeGps_ns, say::guess_offset_tai(), offsets);
  add_both_ways(kTaiBeforeGps_ns + leap_ns, say::guess_offset_tai(), offsets);
  return offsets;
}

/// Nanoseconds of the day of a time whose seconds are written as hhmmss; nothing where they are no clock.
std::optional<std::int64_t> digits_of_day_ns(std::int64_t written_ns) {
  const std::int64_t whole = written_ns / kSecond_ns, hour = whole / 10'000, minute = whole / 100 % 100,
                     second = whole % 100;
  if (written_ns < 0 || hour > 23 || minute > 59 || second > 59) return std::nullopt;
  return ((hour * 60 + minute) * 60 + second) * kSecond_ns + written_ns % kSecond_ns;
}

/// What a clock that shows no date is likely to count, beside scans that have one; empty where nothing is known.
Message clock_without_date(const conventions::TimeSpan& scans, const conventions::TimeSpan& ins) {
  constexpr std::int64_t kNearZero_ns = 10 * kSecond_ns, kTogether_ns = 60 * kSecond_ns;
  const bool scans_alone = scans.first_ns > formats::kFirstRecording_ns && ins.last_ns < formats::kFirstRecording_ns;
  const auto first_ns = digits_of_day_ns(ins.first_ns), last_ns = digits_of_day_ns(ins.last_ns);
  if (scans_alone && first_ns && last_ns && ins.first_ns > kNearZero_ns) {
    const std::int64_t of_day_ns = scans.first_ns % formats::kUtcDay_ns;
    if (of_day_ns > *first_ns - kTogether_ns && of_day_ns < *last_ns + kTogether_ns) return say::guess_clock_digits();
  }
  const bool near_zero = ins.first_ns >= 0 && ins.first_ns < kNearZero_ns;
  if (scans_alone && near_zero) return say::guess_clock_from_start();
  return conventions::power_on_of(scans.first_ns, ins.first_ns);
}

/// The usual differences, from the likeliest on.
std::vector<KnownOffset> known_offsets(const conventions::TimeSpan& scans, const conventions::TimeSpan& ins) {
  const std::int64_t leap_ns = leap_seconds_ns(ins);
  std::vector<KnownOffset> offsets = offsets_of_scales(ins);
  const auto both_ways = [&](std::int64_t size_ns, const Message& cause) { add_both_ways(size_ns, cause, offsets); };
  both_ways(formats::kGpsEpoch_ns - leap_ns, say::guess_offset_epoch());
  both_ways(formats::kGpsEpoch_ns, say::guess_offset_epoch());
  both_ways(formats::kGpsWeeksOfTurn * formats::kGpsWeek_ns, say::guess_offset_rollover());
  if (scans.first_ns > formats::kFirstRecording_ns && ins.first_ns >= 0 && ins.last_ns < 2 * formats::kUtcDay_ns)
    offsets.push_back({scans.first_ns - scans.first_ns % formats::kUtcDay_ns, say::guess_offset_of_day()});
  for (std::int64_t half_hours = 1; half_hours <= 28; ++half_hours)
    both_ways(half_hours * 1800 * kSecond_ns, say::guess_offset_zone());
  for (std::int64_t half_hours = 1; half_hours <= 28; ++half_hours)
    for (const std::int64_t sign : {1, -1})
      both_ways(half_hours * 1800 * kSecond_ns + sign * leap_ns, say::guess_offset_zone_and_leap());
  return offsets;
}

void advise(const KnownOffset& offset, std::size_t inside, std::size_t scans, Guess& guess) {
  guess.added_ns = offset.added_ns;
  guess.alternatives.push_back(
      say::guess_clock_together(inside, scans, Duration{1e-9 * static_cast<double>(offset.added_ns)}, offset.cause));
}

/// The difference of two time scales by which both ends are apart.
void tell_nearest_of_scales(const conventions::TimeSpan& scans, const InsGuess& ins,
                            const std::vector<std::int64_t>& stamps_ns, Guess& guess) {
  const double apart_ns = 0.5 * (static_cast<double>(scans.first_ns - ins.span.first_ns) +
                                 static_cast<double>(scans.last_ns - ins.span.last_ns));
  const std::vector<KnownOffset> offsets = offsets_of_scales(ins.span);
  const KnownOffset& nearest = *std::ranges::min_element(offsets, {}, [&](const KnownOffset& offset) {
    return std::abs(static_cast<double>(offset.added_ns) - apart_ns);
  });
  advise(nearest, count_within(ins, stamps_ns, nearest.added_ns), stamps_ns.size(), guess);
}

/// Of the usual differences those that bring the most together.
void tell_known_offset(const conventions::TimeSpan& scans, const InsGuess& ins,
                       const std::vector<std::int64_t>& stamps_ns, Guess& guess) {
  std::vector<KnownOffset> fit;
  std::size_t inside = 0;
  for (KnownOffset& offset : known_offsets(scans, ins.span)) {
    const std::size_t so_many = count_within(ins, stamps_ns, offset.added_ns);
    if (10 * so_many < 9 * stamps_ns.size() || so_many < inside) continue;
    if (so_many > inside) fit.clear();
    inside = so_many;
    fit.push_back(std::move(offset));
  }
  if (fit.empty()) return;
  if (fit.size() == 1) {
    advise(fit.front(), inside, stamps_ns.size(), guess);
    return;
  }
  const auto added = [](const KnownOffset& offset) { return Duration{1e-9 * static_cast<double>(offset.added_ns)}; };
  const auto [least, most] = std::ranges::minmax_element(fit, {}, &KnownOffset::added_ns);
  std::vector<Message> causes;
  for (const KnownOffset& offset : fit)
    if (std::ranges::find(causes, offset.cause.code(), &Message::code) == causes.end()) causes.push_back(offset.cause);
  guess.alternatives.push_back(say::guess_clock_together_by_several(inside, stamps_ns.size(), fit.size(), added(*least),
                                                                    added(*most), std::move(causes)));
}

}  // namespace

std::size_t count_within(const InsGuess& ins, const std::vector<std::int64_t>& stamps_ns, std::int64_t added_ns) {
  return static_cast<std::size_t>(std::ranges::count_if(stamps_ns, [&](std::int64_t stamp_ns) {
    const std::int64_t of_ins_ns = stamp_ns - added_ns;
    const auto behind = std::ranges::upper_bound(ins.stretches, of_ins_ns, {}, &conventions::TimeSpan::first_ns);
    return behind != ins.stretches.begin() && of_ins_ns <= std::prev(behind)->last_ns;
  }));
}

std::optional<Guess> guess_clock(const InsGuess& ins, const std::vector<ScansGuess>& lidars) {
  std::vector<std::int64_t> stamps_ns;
  for (const ScansGuess& lidar : lidars)
    stamps_ns.insert(stamps_ns.end(), lidar.stamps_ns.begin(), lidar.stamps_ns.end());
  if (stamps_ns.empty()) return std::nullopt;
  Guess guess{GuessKind::Clock, {}, "", Sureness::Checked, {}, {}};
  if (ins.week_open) guess.evidence.push_back(say::guess_clock_week());
  const auto [first, last] = std::ranges::minmax_element(stamps_ns);
  const conventions::TimeSpan scans{*first, *last};
  const std::size_t inside = count_within(ins, stamps_ns), in_gaps = count_within_span(ins, stamps_ns) - inside;
  guess.evidence.push_back(say::guess_clock_within(inside, stamps_ns.size()));
  if (in_gaps > 0) guess.evidence.push_back(say::guess_clock_in_gaps(in_gaps, longest_gap(ins)));
  if (inside + in_gaps == 0) guess.evidence.push_back(conventions::time_spans_apart(scans, ins.span));
  if (Message cause = clock_without_date(scans, ins.span); inside + in_gaps == 0 && !cause.empty())
    guess.evidence.push_back(std::move(cause));
  if (10 * (inside + in_gaps) < 9 * stamps_ns.size()) {
    guess.sureness = Sureness::Open;
    tell_known_offset(scans, ins, stamps_ns, guess);
  } else if (Message shifted = conventions::shifted_by_leap_seconds(scans, ins.span); !shifted.empty()) {
    guess.sureness = Sureness::Likely;
    guess.evidence.push_back(std::move(shifted));
    tell_nearest_of_scales(scans, ins, stamps_ns, guess);
  } else if (covers_leap_seconds(ins, stamps_ns, inside)) {
    guess.sureness = Sureness::Named;
    guess.evidence.push_back(say::guess_clock_not_to_seconds());
  } else if (10 * in_gaps > stamps_ns.size()) {
    guess.sureness = Sureness::Likely;
  }
  return guess;
}

}  // namespace remount::guesses
