#include "model/guesses/scan_clock.h"

#include <algorithm>
#include <string>
#include <utility>

#include "messages/guesses.h"
#include "model/formats/files/running_period.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/files/time_unit.h"
#include "model/guesses/clock_guess.h"
#include "model/guesses/scan_tables.h"
#include "model/guesses/table_guess.h"

namespace remount::guesses {
namespace {

/// One way in which numbers in names may be times.
struct NameClock {
  formats::NameTimes times;
  std::vector<std::int64_t> stamps_ns;
  std::size_t inside = 0;
  Message counts;  ///< what they count
};

struct NameOffset {
  std::int64_t added_ns = 0;
  Message counts;
};

/// What numbers may count from, beside a motion that has dates, or has none.
std::vector<NameOffset> offsets_of_names(const InsGuess& ins) {
  std::vector<NameOffset> offsets{
      {0, ins.week_open ? say::guess_names_count_the_week() : say::guess_names_count_as_ins()}};
  if (ins.week_open || ins.span.first_ns < formats::kFirstRecording_ns) return offsets;
  const std::int64_t middle_ns = ins.span.first_ns + (ins.span.last_ns - ins.span.first_ns) / 2;
  const std::int64_t week = formats::gps_ns_from_unix_ns(middle_ns) / formats::kGpsWeek_ns;
  offsets.push_back({formats::unix_ns_from_gps_ns(week * formats::kGpsWeek_ns), say::guess_names_count_week(week)});
  offsets.push_back({middle_ns - middle_ns % formats::kUtcDay_ns, say::guess_names_count_the_day()});
  return offsets;
}

/// The likeliest first. Steps are those of a LiDAR that turns: numbers that count something may be of any.
std::vector<NameClock> clocks_of_names(const CloudFolder& folder, const InsGuess& ins) {
  constexpr double kShortestStep_s = 0.015, kLongestStep_s = 2.5;
  std::vector<NameClock> clocks;
  for (const std::int64_t unit_ns : {1'000'000'000, 1'000'000, 1'000, 1})
    for (NameOffset& offset : offsets_of_names(ins)) {
      NameClock clock;
      clock.times = {unit_ns, formats::TimeScale::Unix, offset.added_ns};
      clock.counts = std::move(offset.counts);
      std::vector<drive::Finding> findings;
      clock.stamps_ns = ascending_stamps(
          formats::scans_from_names(folder.files, folder.directory, folder.format, clock.times, findings));
      const double step_s = median_step_s(clock.stamps_ns);
      if (clock.stamps_ns.size() != folder.files.size() || step_s < kShortestStep_s || step_s > kLongestStep_s)
        continue;
      InsGuess placed = ins;
      if (offset.added_ns == 0) place_in_week(placed, clock.stamps_ns);
      clock.inside = count_within(placed, clock.stamps_ns);
      if (10 * clock.inside >= 9 * clock.stamps_ns.size()) clocks.push_back(std::move(clock));
    }
  std::ranges::stable_sort(clocks, [](const NameClock& a, const NameClock& b) { return a.inside > b.inside; });
  return clocks;
}

/// Numbers far from zero do not come to lie within a short motion by chance; those that begin with it may.
bool far_from_zero(const std::vector<std::int64_t>& stamps_ns, std::int64_t added_ns) {
  constexpr double kTimes = 8.0;
  const auto first_ns = static_cast<double>(stamps_ns.front()), last_ns = static_cast<double>(stamps_ns.back());
  return first_ns - static_cast<double>(added_ns) > kTimes * (last_ns - first_ns);
}

}  // namespace

void take_clock_of_ins(const CloudFolder& folder, const InsGuess& ins, ScansGuess& scans) {
  const bool by_numbers = scans.by_numbers;
  if (scans.timed && !by_numbers) return;
  std::vector<NameClock> clocks = clocks_of_names(folder, ins);
  if (clocks.empty()) return;
  NameClock& best = clocks.front();
  const bool far = far_from_zero(best.stamps_ns, best.times.offset_ns);
  if (!far && names_count(folder)) return;
  const std::string unit(formats::time_unit_name(best.times.unit_ns));
  Guess guess{GuessKind::Stamps, {}, unit, far && clocks.size() == 1 ? Sureness::Checked : Sureness::Open, {}, {}};
  guess.evidence = {say::guess_stamps_in_names(unit), best.counts,
                    say::guess_names_within(best.inside, best.stamps_ns.size())};
  for (std::size_t i = 1; i < clocks.size(); ++i)
    guess.alternatives.push_back(say::guess_names_alternative(
        std::string(formats::time_unit_name(clocks[i].times.unit_ns)),
        Duration{1e-9 * static_cast<double>(clocks[i].times.offset_ns)}, std::move(clocks[i].counts)));
  if (!far) guess.alternatives.push_back(say::guess_names_may_begin_elsewhere());
  std::erase_if(scans.guesses, [](const Guess& one) { return one.kind == GuessKind::Stamps; });
  scans.guesses.push_back(std::move(guess));
  scans.in_names = best.times;
  scans.stamps_ns = std::move(best.stamps_ns);
  scans.timed = true;
}

}  // namespace remount::guesses
