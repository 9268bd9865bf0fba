#include "algorithms/calibration/calibration_result.h"

#include <algorithm>
#include <cmath>

#include "messages/parameters.h"

namespace remount {
namespace {
constexpr std::array<std::string_view, 7> kStatusNames{"ok",           "degenerate",   "too_few_pairs", "not_converged",
                                                       "out_of_range", "inconsistent", "cancelled"};
}

std::string_view to_string(Status status) { return kStatusNames.at(static_cast<std::size_t>(status)); }

std::optional<Status> status_from_string(std::string_view text) {
  for (std::size_t i = 0; i < kStatusNames.size(); ++i)
    if (kStatusNames[i] == text) return static_cast<Status>(i);
  return std::nullopt;
}

Message parameter_word(std::size_t i) {
  constexpr std::array<Message (*)(), 6> kWords{say::parameter_x,   say::parameter_y,     say::parameter_z,
                                                say::parameter_yaw, say::parameter_pitch, say::parameter_roll};
  return kWords.at(i)();
}

std::vector<Message> parameter_words(const std::array<bool, 6>& which, bool value, std::size_t count) {
  std::vector<Message> words;
  for (std::size_t i = 0; i < count; ++i)
    if (which[i] == value) words.push_back(parameter_word(i));
  return words;
}

std::string parameter_names(const std::array<bool, 6>& which, bool value, std::size_t count) {
  std::string names;
  for (std::size_t i = 0; i < count; ++i)
    if (which[i] == value) names += (names.empty() ? "" : ", ") + std::string(kParameterNames[i]);
  return names;
}

bool is_usable(const CalibrationResult& result) {
  const bool solved = result.status == Status::Ok || result.status == Status::Degenerate;
  return solved && std::find(result.observed.begin(), result.observed.end(), true) != result.observed.end();
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

}  // namespace remount
