#include "model/result_words.h"

#include <algorithm>
#include <cmath>
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

std::string_view clock_use_words(const TimeOffset& clock) {
  return clock.applied ? "applied" : clock.in_sigma ? "an unknown of X, in its sigmas" : "not applied";
}

std::vector<std::string> clock_words(const CalibrationResult& result) {
  const TimeOffset& clock = result.time_offset;
  if (!std::isfinite(clock.offset_s)) return {};
  const auto line = [](const std::string& what, double offset_s, double sigma_s) {
    const double shown_ms = std::round(1e5 * offset_s) / 100.0 + 0.0;  // no "-0.00"
    char numbers[80];
    std::snprintf(numbers, sizeof numbers, ": %.2f ms (sigma %.2f ms)", shown_ms, 1e3 * sigma_s);
    return what + numbers;
  };
  const std::vector<double>&offsets_s = result.session_time_offset_s, &sigmas_s = result.session_time_offset_sigma_s;
  const bool several = offsets_s.size() > 1 && sigmas_s.size() == offsets_s.size();
  std::vector<std::string> lines{
      line(several ? "clock offset INS - LiDAR, mean of the sessions" : "clock offset INS - LiDAR", clock.offset_s,
           clock.sigma_s) +
      ", " + std::string(clock_use_words(clock))};
  for (std::size_t s = 0; several && s < offsets_s.size(); ++s)
    lines.push_back(line("clock offset of session " + std::to_string(s + 1), offsets_s[s], sigmas_s[s]));
  return lines;
}

}  // namespace remount
