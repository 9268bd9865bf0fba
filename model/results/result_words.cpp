#include "model/results/result_words.h"

#include <algorithm>
#include <cmath>

#include "messages/results.h"

namespace remount::results {

bool knows_nothing(const calibration::CalibrationResult& result) {
  return result.status == calibration::Status::Degenerate && result.observed().empty();
}

bool has_mounting(const calibration::CalibrationResult& result) {
  return calibration::is_usable(result) || result.status == calibration::Status::Inconsistent;
}

bool is_aligned_together(const calibration::CalibrationResult& result) {
  return std::any_of(result.candidates.begin(), result.candidates.end(), [](const calibration::Candidate& candidate) {
    return candidate.source == calibration::MountingSource::JointClouds;
  });
}

Message disagreement_words(const calibration::CalibrationResult& result) {
  constexpr double kWorthSaying = 1.05;
  if (!calibration::is_usable(result) || !(result.session_disagreement >= kWorthSaying)) return {};
  return say::result_sessions_scatter(result.session_disagreement);
}

Message clock_use_words(const calibration::TimeOffset& clock) {
  return clock.applied    ? say::result_clock_applied()
         : clock.in_sigma ? say::result_clock_unknown_of_x()
                          : say::result_clock_not_applied();
}

std::vector<Message> clock_words(const calibration::CalibrationResult& result) {
  const calibration::TimeOffset& clock = result.time_offset;
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

Message status_word(calibration::Status status) {
  switch (status) {
    case calibration::Status::Ok:
      return say::status_ok();
    case calibration::Status::Degenerate:
      return say::status_degenerate();
    case calibration::Status::TooFewPairs:
      return say::status_too_few_pairs();
    case calibration::Status::TooLittleData:
      return say::status_too_little_data();
    case calibration::Status::NoUsableData:
      return say::status_no_usable_data();
    case calibration::Status::NotConverged:
      return say::status_not_converged();
    case calibration::Status::OutOfRange:
      return say::status_out_of_range();
    case calibration::Status::Inconsistent:
      return say::status_inconsistent();
    case calibration::Status::Cancelled:
      break;
  }
  return say::status_cancelled();
}

}  // namespace remount::results
