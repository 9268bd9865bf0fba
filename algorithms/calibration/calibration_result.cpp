#include "algorithms/calibration/calibration_result.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithms/core/index.h"
#include "messages/parameters.h"

namespace remount::calibration {
namespace {
constexpr std::array<std::string_view, 9> kStatusNames{
    "ok",           "degenerate",   "too_few_pairs", "too_little_data", "no_usable_data", "not_converged",
    "out_of_range", "inconsistent", "cancelled"};
}

std::string_view to_string(Status status) { return kStatusNames.at(index_of(status)); }

std::optional<Status> status_from_string(std::string_view text) {
  for (std::size_t i = 0; i < kStatusNames.size(); ++i)
    if (kStatusNames[i] == text) return static_cast<Status>(i);
  return std::nullopt;
}

void CalibrationResult::conclude(Status what, Message why) {
  status = what;
  message = std::move(why);
}

Estimate CalibrationResult::estimate(Parameter parameter) const {
  const Knowledge& about = known[parameter];
  Estimate out{parameters_of(mounting.reference_from_sensor)[parameter], {}, {}, about.observed, about.measured, {}};
  if (about.observed) {
    const double variance = covariance(row_of(parameter), row_of(parameter));
    if (std::isfinite(variance)) out.sigma = std::sqrt(variance);
    out.bootstrap_sigma = about.bootstrap_sigma;
    return out;
  }
  out.why_not_observed = !about.why_not_observed.empty() ? about.why_not_observed
                         : !message.empty()              ? message
                                                         : say::unknown_not_solved();
  return out;
}

ParameterSet CalibrationResult::observed() const {
  ParameterSet out;
  for (const Parameter parameter : kParameters)
    if (known[parameter].observed) out.insert(parameter);
  return out;
}

ParameterSet CalibrationResult::measured() const {
  ParameterSet out;
  for (const Parameter parameter : kParameters)
    if (known[parameter].measured) out.insert(parameter);
  return out;
}

void CalibrationResult::set_observed(ParameterSet parameters, const Message& why_not) {
  for (const Parameter parameter : kParameters) {
    if (!parameters.contains(parameter)) {
      withdraw(parameter, why_not);
      continue;
    }
    known[parameter].observed = true;
    known[parameter].why_not_observed = {};
  }
}

void CalibrationResult::withdraw(Parameter parameter, Message why) {
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  known[parameter].observed = false;
  known[parameter].bootstrap_sigma.reset();
  known[parameter].why_not_observed = std::move(why);
  covariance.row(row_of(parameter)).setConstant(kNothing);
  covariance.col(row_of(parameter)).setConstant(kNothing);
}

void CalibrationResult::set_measured(ParameterSet parameters) {
  for (const Parameter parameter : kParameters) known[parameter].measured = parameters.contains(parameter);
}

bool sigma_parts_add_up(const CalibrationResult& result) {
  constexpr double kTolerance = 1e-3;  // of the variance
  if (result.sigma_parts.empty()) return false;
  for (const Parameter parameter : kParameters) {
    if (!result.known[parameter].observed) continue;
    double sum = 0.0;
    for (const SigmaPart& part : result.sigma_parts) sum += part.sigma[parameter] * part.sigma[parameter];
    const double variance = result.covariance(row_of(parameter), row_of(parameter));
    if (!(std::abs(sum - variance) <= kTolerance * variance)) return false;
  }
  return true;
}

bool is_usable(const CalibrationResult& result) { return is_solved(result.status) && !result.observed().empty(); }

TimeOffset mean_time_offset(const std::vector<double>& offsets_s, const std::vector<double>& sigmas_s) {
  const bool weighted = sigmas_s.size() == offsets_s.size();
  double weights = 0.0, sum_s = 0.0;
  for (std::size_t s = 0; s < offsets_s.size(); ++s) {
    const double weight = weighted ? 1.0 / (sigmas_s[s] * sigmas_s[s]) : 1.0;
    weights += weight;
    sum_s += weight * offsets_s[s];
  }
  TimeOffset mean;
  if (!(weights > 0.0)) return mean;
  mean.offset_s = sum_s / weights;
  if (weighted) mean.sigma_s = 1.0 / std::sqrt(weights);
  return mean;
}

bool stands_out(double value, double sigma, double least) {
  constexpr double kSigmas = 4.0;
  return std::isfinite(value) && std::isfinite(sigma) && std::abs(value) >= std::max(kSigmas * sigma, least);
}

bool position_lag_stands_out(double lag_s, double sigma_s) {
  constexpr double kLeast_s = 1e-3;  // a centimetre at 36 km/h
  return stands_out(lag_s, sigma_s, kLeast_s);
}

bool position_lag_differs(const CalibrationResult& result) {
  const std::size_t told = std::min(result.session_position_lag_s.size(), result.session_position_lag_sigma_s.size());
  for (std::size_t s = 0; s < told; ++s)
    if (position_lag_stands_out(result.session_position_lag_s[s], result.session_position_lag_sigma_s[s])) return true;
  return false;
}

}  // namespace remount::calibration
