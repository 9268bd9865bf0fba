#include "model/pipeline/position_lag.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "messages/pipeline.h"

namespace remount::pipeline {
namespace {

constexpr double kWell_s = 3e-3;  ///< 1-sigma: a centimetre or two of what is driven meanwhile

Message lag_text(double lag_s, double sigma_s, const Message& what_of_it) {
  const Duration lag{std::abs(lag_s)}, sigma{sigma_s};
  Message found = lag_s > 0.0 ? say::positions_older(lag, sigma) : say::positions_younger(lag, sigma);
  return Message::sequence({std::move(found), what_of_it});
}

}  // namespace

void state_position_lags(const DriveMotion& motion, bool applied, calibration::CalibrationResult& result) {
  bool any = false;
  for (motion::SessionIndex s; s < motion.session_count(); ++s) any = any || motion.position_lag_s(s) != 0.0;
  result.position_lag_applied = applied && any;
  if (!any) return;
  // Lags never stand without their errors, be those unknown.
  result.session_position_lag_sigma_s.resize(motion.session_count(), std::numeric_limits<double>::quiet_NaN());
  result.session_position_lag_s.clear();
  for (motion::SessionIndex s; s < motion.session_count(); ++s)
    result.session_position_lag_s.push_back(motion.position_lag_s(s));
}

void report_position_lag(const PipelineInput& input, const calibration::CalibrationResult& result,
                         std::vector<drive::Finding>& findings) {
  const std::size_t told = std::min(result.session_position_lag_s.size(), result.session_position_lag_sigma_s.size());
  const bool may_apply = input.settings.solve.apply_time_offset != calibration::ClockOffsetUse::No;
  const Message what_of_it = result.position_lag_applied ? say::positions_lag_taken_out()
                             : may_apply                 ? say::positions_lag_does_not_settle()
                                                         : say::positions_lag_left_in();
  for (std::size_t s = 0; s < std::min(told, input.sessions.size()); ++s) {
    const double lag_s = result.session_position_lag_s[s], sigma_s = result.session_position_lag_sigma_s[s];
    const drive::Session& session = *input.sessions[s];
    const bool taken_out = result.position_lag_applied && lag_s != 0.0;
    if (taken_out || calibration::position_lag_stands_out(lag_s, sigma_s)) {
      findings.push_back({drive::Severity::Warning, kPositionLag, session.name, lag_text(lag_s, sigma_s, what_of_it)});
      continue;
    }
    const double before_s = session.ins_position_lag_sigma_s;
    if (!(before_s > 0.0) || !calibration::is_usable(result)) continue;
    const double left_s = 1.0 / std::hypot(1.0 / before_s, 1.0 / sigma_s);
    if (left_s > kWell_s)
      findings.push_back(
          {drive::Severity::Note, kPositionsApart, session.name, say::positions_apart(Duration{left_s})});
  }
}

}  // namespace remount::pipeline
