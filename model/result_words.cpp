#include "model/result_words.h"

#include <algorithm>
#include <cstdio>

namespace remount {

bool knows_nothing(const CalibrationResult& result) {
  return result.status == Status::Degenerate &&
         std::none_of(result.observed.begin(), result.observed.end(), [](bool observed) { return observed; });
}

bool has_mounting(const CalibrationResult& result) {
  return is_usable(result) || result.status == Status::Inconsistent;
}

bool is_aligned_together(const CalibrationResult& result) {
  return std::any_of(result.candidates.begin(), result.candidates.end(),
                     [](const Candidate& candidate) { return candidate.source == "joint clouds"; });
}

std::string disagreement_words(const CalibrationResult& result) {
  constexpr double kWorthSaying = 1.05;
  if (!is_usable(result) || !(result.session_disagreement >= kWorthSaying)) return {};
  char text[120];
  std::snprintf(text, sizeof text,
                "The sessions scatter %.1f times as much as their errors explain; the sigmas include it.",
                result.session_disagreement);
  return text;
}

}  // namespace remount
