#include "app/cli/summary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

#include "model/display_units.h"
#include "model/report/plot_chart.h"
#include "model/result_words.h"

namespace remount {
namespace {

std::string format(const char* pattern, auto... values) {
  char text[256];
  std::snprintf(text, sizeof(text), pattern, values...);
  return text;
}

std::string sigma_text(double sigma) {
  return format(sigma < 1e-6 ? "1-sigma %.1e" : sigma < 1e-3 ? "1-sigma %.6f" : "1-sigma %.4f", sigma);
}

/// What the six numbers are. Positions of an antenna give a lever arm and no attitude: no pose of anything.
std::string meaning(const CalibrationResult& result) {
  const std::string& frame = result.reference_frame;
  if (frame == "antenna")
    return "place of the lidar from the antenna, in axes of the lidar: the lever arm turned round";
  if (result.calibrated == "antenna") return "place of the antenna in the " + frame + " frame: its lever arm";
  return "pose of the " + result.calibrated + " in the " + frame + " frame";
}

std::string parameters(const CalibrationResult& result) {
  const std::array<double, 6> values = six_on_screen(result.ins_from_lidar);
  std::string text = result.reference_frame + "_from_" + result.calibrated + " (" + meaning(result) + ")\n";
  for (std::size_t i = 0; i < 6; ++i) {
    const bool angle = is_angle(i);
    const char* unit = angle ? "deg" : "m  ";
    text += format("  %-5s  %10.4f %s  ", std::string(kParameterNames[i]).c_str(), values[i], unit);
    const auto sigma = result.sigma(i);
    if (!sigma)
      text += "not observed: do not rely on this value\n";
    else
      text += sigma_text(on_screen(i, *sigma)) + (angle ? " deg" : " m") +
              (result.measured[i] ? ", with the measured value\n" : "\n");
  }
  return text;
}

/// Reasons differ in their numbers; counted together they tell more: "overlap 0.21 is below 0.30" and so on.
std::string without_numbers(const std::string& reason) {
  std::string kind;
  for (std::size_t i = 0; i < reason.size(); ++i) {
    const bool digit = reason[i] >= '0' && reason[i] <= '9';
    const bool within =
        digit || ((reason[i] == '.' || reason[i] == '-') && i + 1 < reason.size() && reason[i + 1] >= '0' &&
                  reason[i + 1] <= '9' && (kind.empty() || kind.back() == '#' || kind.back() == ' '));
    if (!within)
      kind += reason[i];
    else if (kind.empty() || kind.back() != '#')
      kind += '#';
  }
  return kind;
}

using CountedReasons = std::map<std::string, std::pair<int, std::string>>;  // how many of a kind, and the first

void count_reason(const std::string& reason, CountedReasons& reasons) {
  auto& [count, example] = reasons[without_numbers(reason)];
  if (count++ == 0) example = reason;
}

/// The reason of one stands for those of all that differ from it in numbers only.
std::string reason_line(const char* state, int count, const std::string& reason) {
  return format(count > 1 ? "  %5d %s, one of them: " : "  %5d %s: ", count, state) + reason + "\n";
}

std::string sharpness(const std::vector<NamedSharpness>& list) {
  std::string text;
  for (const NamedSharpness& one : list)
    if ((one.source == "result" || one.source == "nominal") && std::isfinite(one.sharpness.plane_thickness_m))
      text += format("%s %.1f mm thick under the %s (entropy %.3f)", text.empty() ? "" : ",",
                     1e3 * one.sharpness.plane_thickness_m, one.source.c_str(), one.sharpness.mean_map_entropy);
  return text.empty() ? text : "map check: surfaces are" + text + "\n";
}

std::string pairs(const ResultFile& file) {
  const CalibrationResult& result = file.result;
  std::string text = format("pairs: %d proposed, %d accepted, %d rejected\n", result.pairs_proposed,
                            result.pairs_accepted, result.pairs_rejected);
  CountedReasons reasons;
  CountedReasons open_directions;  // of accepted pairs
  for (const PairRecord& pair : file.pairs) {
    if (pair.state == PairState::Accepted && pair.decided_by == DecidedBy::Program && !pair.reason.empty())
      count_reason(pair.reason, open_directions);
    if (pair.state == PairState::Rejected) count_reason(pair.reason, reasons);
  }
  std::vector<std::pair<int, std::string>> sorted;
  for (const auto& [kind, counted] : reasons) sorted.push_back({-counted.first, counted.second});
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < std::min<std::size_t>(sorted.size(), 8); ++i)
    text += reason_line("rejected", -sorted[i].first, sorted[i].second);
  for (const auto& [kind, counted] : open_directions) text += reason_line("accepted", counted.first, counted.second);
  return text;
}

std::string quantities(const std::vector<NamedQuantity>& list) {
  const Phrases english = [](const char*, const char* text) { return std::string(text); };
  std::string text;
  for (const NamedQuantity& quantity : list)
    text += "  " + quantity.name + ": " + quantity_text(quantity, english) + "\n";
  return text.empty() ? text : "also determined:\n" + text;
}

}  // namespace

std::string summary(const ResultFile& file) {
  const CalibrationResult& result = file.result;
  std::string text = "status: " + std::string(to_string(result.status)) +
                     (result.message.empty() ? "" : " - " + result.message) + "\n";
  if (is_usable(result)) {
    text += parameters(result);
    if (is_from_pairs(file))
      text += format("error: rotation %.4f deg rms, translation %.4f m rms, Frobenius sum %.4f\n",
                     radians_to_degrees(result.rotation_rms_rad), result.translation_rms_m, result.frobenius_sum);
  }
  if (const std::string words = disagreement_words(result); !words.empty()) text += words + "\n";
  if (is_usable(result)) text += sharpness(file.sharpness);
  text += quantities(file.quantities);
  if (is_from_pairs(file)) text += pairs(file);
  if (is_usable(result) && std::isfinite(result.time_offset.offset_s))
    text += format("time offset: t_ins = t_lidar %+.4f s (1-sigma %.4f s), %s\n", result.time_offset.offset_s,
                   result.time_offset.sigma_s, result.time_offset.applied ? "applied" : "not applied");
  for (const std::string& advice : result.advice) text += "advice: " + advice + "\n";
  return text;
}

}  // namespace remount
