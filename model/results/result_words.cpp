#include "model/results/result_words.h"

#include <algorithm>
#include <cmath>

#include "messages/results.h"

namespace remount {

bool knows_nothing(const CalibrationResult& result) {
  return result.status == Status::Degenerate && result.observed().empty();
}

bool has_mounting(const CalibrationResult& result) {
  return is_usable(result) || result.status == Status::Inconsistent;
}

bool is_aligned_together(const CalibrationResult& result) {
  return std::any_of(result.candidates.begin(), result.candidates.end(),
                     [](const Candidate& candidate) { return candidate.source == MountingSource::JointClouds; });
}

Message disagreement_words(const CalibrationResult& result) {
  constexpr double kWorthSaying = 1.05;
  if (!is_usable(result) || !(result.session_disagreement >= kWorthSaying)) return {};
  return say::result_sessions_scatter(result.session_disagreement);
}

Message clock_use_words(const TimeOffset& clock) {
  return clock.applied    ? say::result_clock_applied()
         : clock.in_sigma ? say::result_clock_unknown_of_x()
                          : say::result_clock_not_applied();
}

std::vector<Message> clock_words(const CalibrationResult& result) {
  const TimeOffset& clock = result.time_offset;
  if (!std::isfinite(clock.offset_s)) return {};
  const std::vector<double>&offsets_s = result.session_time_offset_s, &sigmas_s = result.session_time_offset_sigma_s;
  const bool several = offsets_s.size() > 1 && sigmas_s.size() == offsets_s.size();
  const Duration offset{clock.offset_s}, sigma{clock.sigma_s};
  std::vector<Message> lines{several ? say::result_clock_of_sessions(offset, sigma, clock_use_words(clock))
                                     : say::result_clock(offset, sigma, clock_use_words(clock))};
  for (std::size_t s = 0; several && s < offsets_s.size(); ++s)
    lines.push_back(say::result_clock_of_session(s + 1, Duration{offsets_s[s]}, Duration{sigmas_s[s]}));
  return lines;
}

Message status_word(Status status) {
  switch (status) {
    case Status::Ok:
      return say::status_ok();
    case Status::Degenerate:
      return say::status_degenerate();
    case Status::TooFewPairs:
      return say::status_too_few_pairs();
    case Status::TooLittleData:
      return say::status_too_little_data();
    case Status::NoUsableData:
      return say::status_no_usable_data();
    case Status::NotConverged:
      return say::status_not_converged();
    case Status::OutOfRange:
      return say::status_out_of_range();
    case Status::Inconsistent:
      return say::status_inconsistent();
    case Status::Cancelled:
      break;
  }
  return say::status_cancelled();
}

}  // namespace remount
