#include "model/pipeline/position_lag.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace remount {
namespace {

constexpr double kWell_s = 3e-3;  ///< 1-sigma: a centimetre or two of what is driven meanwhile

std::string lag_text(double lag_s, double sigma_s, bool applied) {
  char text[320];
  std::snprintf(text, sizeof text, "The positions of the INS are %.1f ms %s than its attitudes (sigma %.2f ms). %s",
                1e3 * std::abs(lag_s), lag_s > 0.0 ? "older" : "younger", 1e3 * sigma_s,
                applied ? "X is solved with that taken out."
                        : "X is off by the way that is driven meanwhile, which is in the sigmas: set "
                          "solve.apply_time_offset to auto or yes to take it out.");
  return text;
}

std::string open_text(double sigma_s) {
  char text[320];
  std::snprintf(text, sizeof text,
                "Positions and attitudes of the INS come in messages of different times, and the drive does not show "
                "how well they go together: that one is %.0f ms older than the other (1 sigma) is in the sigmas.",
                1e3 * sigma_s);
  return text;
}

}  // namespace

void state_position_lags(const DriveMotion& motion, bool applied, CalibrationResult& result) {
  bool any = false;
  for (int s = 0; s < motion.session_count(); ++s) any = any || motion.position_lag_s(s) != 0.0;
  result.position_lag_applied = applied && any;
  if (!any || result.session_position_lag_sigma_s.size() != static_cast<std::size_t>(motion.session_count())) return;
  result.session_position_lag_s.clear();
  for (int s = 0; s < motion.session_count(); ++s) result.session_position_lag_s.push_back(motion.position_lag_s(s));
}

void report_position_lag(const PipelineInput& input, const CalibrationResult& result, std::vector<Finding>& findings) {
  for (std::size_t s = 0; s < std::min(result.session_position_lag_s.size(), input.sessions.size()); ++s) {
    const double lag_s = result.session_position_lag_s[s], sigma_s = result.session_position_lag_sigma_s.at(s);
    const Session& session = *input.sessions[s];
    if (position_lag_stands_out(lag_s, sigma_s)) {
      findings.push_back(
          {Severity::Warning, kPositionLag, session.name, lag_text(lag_s, sigma_s, result.position_lag_applied)});
      continue;
    }
    const double before_s = session.ins_position_lag_sigma_s;
    if (!(before_s > 0.0) || !is_usable(result)) continue;
    const double left_s = 1.0 / std::hypot(1.0 / before_s, 1.0 / sigma_s);
    if (left_s > kWell_s) findings.push_back({Severity::Note, kPositionsApart, session.name, open_text(left_s)});
  }
}

}  // namespace remount
