#include "app/cli/summary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "algorithms/messages/render.h"
#include "model/deciding_notes.h"
#include "model/display_units.h"
#include "model/pair_words.h"
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
  for (const Message& line : pair_lines(file)) text += "  " + english(line) + "\n";
  return text;
}

/// The offset of the clocks, of each session where there are several, and whether X is solved with it.
std::string time_offset(const CalibrationResult& result) {
  const TimeOffset& clock = result.time_offset;
  std::string text = format("time offset%s: t_ins = t_lidar %+.2f ms (1-sigma %.2f ms), %s\n",
                            result.session_time_offset_s.size() > 1 ? " (mean of the sessions)" : "",
                            1e3 * clock.offset_s, 1e3 * clock.sigma_s, std::string(clock_use_words(clock)).c_str());
  if (clock.applied) text.insert(text.size() - 1, ": X is solved with it (solve.apply_time_offset=no: without)");
  const std::vector<double>&offsets_s = result.session_time_offset_s, &sigmas_s = result.session_time_offset_sigma_s;
  for (std::size_t s = 0; offsets_s.size() > 1 && s < offsets_s.size(); ++s)
    text += format("  session %zu: %+.2f ms", s + 1, 1e3 * offsets_s[s]) +
            (s < sigmas_s.size() ? format(" (1-sigma %.2f ms)\n", 1e3 * sigmas_s[s]) : "\n");
  return text;
}

/// No longer than is read at a glance; the result file has all.
std::string first_of(const std::vector<std::string>& lines, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < std::min(lines.size(), most); ++i) text += lines[i] + "\n";
  return lines.size() <= most ? text : text + format("  and %zu more in the result file\n", lines.size() - most);
}

std::string quantities(const std::vector<NamedQuantity>& list) {
  constexpr std::size_t kMost = 8;
  const Phrases english = [](const char*, const char* text) { return std::string(text); };
  std::vector<std::string> lines;
  for (const NamedQuantity& quantity : list)
    lines.push_back("  " + quantity.name + ": " + quantity_text(quantity, english));
  return lines.empty() ? std::string() : "also determined:\n" + first_of(lines, kMost);
}

std::string advice(const CalibrationResult& result) {
  constexpr std::size_t kMost = 6;
  std::vector<std::string> lines;
  for (const Message& one : result.advice) lines.push_back("advice: " + english(one));
  return first_of(lines, kMost);
}

/// What the program decided on its own; its warnings have been printed already.
std::string deciding_notes(const std::vector<Finding>& findings) {
  constexpr std::size_t kMost = 6;
  std::vector<std::string> lines;
  for (const Finding& finding : findings)
    if (is_deciding(finding)) lines.push_back("note: " + finding.where + ": " + english(finding.explanation));
  return first_of(lines, kMost);
}

}  // namespace

std::string summary(const ResultFile& file) {
  const CalibrationResult& result = file.result;
  const bool usable = is_usable(result);
  std::string text = "status: " + std::string(to_string(result.status)) +
                     (result.message.empty() ? "" : " - " + english(result.message)) + "\n";
  if (usable) text += parameters(result);
  // What to do comes before what it rests on.
  text += advice(result) + deciding_notes(file.findings);
  if (usable && std::isfinite(result.time_offset.offset_s)) text += time_offset(result);
  if (const std::string words = disagreement_words(result); !words.empty()) text += words + "\n";
  if (is_from_pairs(file)) text += pairs(file);
  if (usable && is_from_pairs(file))
    text += format("error: rotation %.4f deg rms, translation %.4f m rms, Frobenius sum %.4f\n",
                   radians_to_degrees(result.rotation_rms_rad), result.translation_rms_m, result.frobenius_sum);
  if (usable) text += sharpness(file.sharpness);
  return text + quantities(file.quantities);
}

}  // namespace remount
