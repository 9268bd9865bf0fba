#include "model/guesses/clock_guess.h"

#include <algorithm>
#include <cmath>

#include "messages/guesses.h"
#include "model/formats/files/running_period.h"
#include "model/formats/files/time_stamp.h"

namespace remount::guesses {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;

/// @param added_ns to the times of the span
std::size_t count_within(const conventions::TimeSpan& span, const std::vector<std::int64_t>& stamps_ns,
                         std::int64_t added_ns = 0) {
  return static_cast<std::size_t>(std::ranges::count_if(stamps_ns, [&](std::int64_t stamp_ns) {
    return stamp_ns >= span.first_ns + added_ns && stamp_ns <= span.last_ns + added_ns;
  }));
}

std::int64_t leap_seconds_ns(const conventions::TimeSpan& ins) {
  return kSecond_ns * formats::leap_seconds_at_gps_s(formats::gps_ns_from_unix_ns(ins.first_ns) / kSecond_ns);
}

/// Whether as many scans lie within where they are moved by the usual difference, either way.
bool covers_leap_seconds(const InsGuess& ins, const std::vector<std::int64_t>& stamps_ns, std::size_t inside) {
  const std::int64_t leap_ns = leap_seconds_ns(ins.span);
  return count_within(ins.span, stamps_ns, leap_ns) >= inside && count_within(ins.span, stamps_ns, -leap_ns) >= inside;
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

/// The usual differences, from the likeliest on.
std::vector<KnownOffset> known_offsets(const conventions::TimeSpan& ins) {
  const std::int64_t leap_ns = leap_seconds_ns(ins);
  std::vector<KnownOffset> offsets = offsets_of_scales(ins);
  const auto both_ways = [&](std::int64_t size_ns, const Message& cause) { add_both_ways(size_ns, cause, offsets); };
  both_ways(formats::kGpsEpoch_ns - leap_ns, say::guess_offset_epoch());
  both_ways(formats::kGpsEpoch_ns, say::guess_offset_epoch());
  both_ways(1024 * formats::kGpsWeek_ns, say::guess_offset_rollover());
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
void tell_nearest_of_scales(const conventions::TimeSpan& scans, const conventions::TimeSpan& ins,
                            const std::vector<std::int64_t>& stamps_ns, Guess& guess) {
  const double apart_ns =
      0.5 * (static_cast<double>(scans.first_ns - ins.first_ns) + static_cast<double>(scans.last_ns - ins.last_ns));
  const std::vector<KnownOffset> offsets = offsets_of_scales(ins);
  const KnownOffset& nearest = *std::ranges::min_element(offsets, {}, [&](const KnownOffset& offset) {
    return std::abs(static_cast<double>(offset.added_ns) - apart_ns);
  });
  advise(nearest, count_within(ins, stamps_ns, nearest.added_ns), stamps_ns.size(), guess);
}

/// Of the usual differences those that bring the most together.
void tell_known_offset(const InsGuess& ins, const std::vector<std::int64_t>& stamps_ns, Guess& guess) {
  std::vector<KnownOffset> fit;
  std::size_t inside = 0;
  for (KnownOffset& offset : known_offsets(ins.span)) {
    const std::size_t so_many = count_within(ins.span, stamps_ns, offset.added_ns);
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

std::optional<Guess> guess_clock(const InsGuess& ins, const std::vector<ScansGuess>& lidars) {
  std::vector<std::int64_t> stamps_ns;
  for (const ScansGuess& lidar : lidars)
    stamps_ns.insert(stamps_ns.end(), lidar.stamps_ns.begin(), lidar.stamps_ns.end());
  if (stamps_ns.empty()) return std::nullopt;
  Guess guess{GuessKind::Clock, {}, "", Sureness::Checked, {}, {}};
  if (ins.week_open) guess.evidence.push_back(say::guess_clock_week());
  const auto [first, last] = std::ranges::minmax_element(stamps_ns);
  const conventions::TimeSpan scans{*first, *last};
  const std::size_t inside = count_within(ins.span, stamps_ns);
  guess.evidence.push_back(say::guess_clock_within(inside, stamps_ns.size()));
  if (inside == 0) guess.evidence.push_back(conventions::time_spans_apart(scans, ins.span));
  if (Message cause = conventions::power_on_of(scans.first_ns, ins.span.first_ns); inside == 0 && !cause.empty())
    guess.evidence.push_back(std::move(cause));
  if (10 * inside < 9 * stamps_ns.size()) {
    guess.sureness = Sureness::Open;
    tell_known_offset(ins, stamps_ns, guess);
  } else if (Message shifted = conventions::shifted_by_leap_seconds(scans, ins.span); !shifted.empty()) {
    guess.sureness = Sureness::Likely;
    guess.evidence.push_back(std::move(shifted));
    tell_nearest_of_scales(scans, ins.span, stamps_ns, guess);
  } else if (covers_leap_seconds(ins, stamps_ns, inside)) {
    guess.sureness = Sureness::Named;
    guess.evidence.push_back(say::guess_clock_not_to_seconds());
  }
  return guess;
}

}  // namespace remount::guesses
