#include "app/cli/summary.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "algorithms/messages/render.h"
#include "messages/command_line.h"
#include "messages/rig.h"
#include "model/formats/files/number_text.h"
#include "model/report/plot_chart.h"
#include "model/results/deciding_notes.h"
#include "model/results/display_units.h"
#include "model/results/mounting_frames.h"
#include "model/results/pair_words.h"
#include "model/results/result_words.h"

namespace remount::cli {
namespace {

/// Lines of the summary: messages, and rows of a table.
class Lines {
 public:
  explicit Lines(Language language) : language_(language) {}

  void add(const Message& message) { text_ += words(message) + "\n"; }
  void add_indented(const Message& message) { text_ += "  " + words(message) + "\n"; }
  void add_row(const std::string& cells, const Message& message) { text_ += cells + words(message) + "\n"; }
  /// No longer than is read at a glance; the result file has all.
  void add_first(const std::vector<Message>& messages, std::size_t most, const std::string& indent = {}) {
    for (std::size_t i = 0; i < std::min(messages.size(), most); ++i) text_ += indent + words(messages[i]) + "\n";
    if (messages.size() > most) add_indented(say::summary_more(messages.size() - most));
  }

  Language language() const { return language_; }
  const std::string& text() const { return text_; }

 private:
  std::string words(const Message& message) const { return render(message, language_); }

  Language language_;
  std::string text_;
};

void add_status(const calibration::CalibrationResult& result, Lines& lines) {
  const Message status = results::status_word(result.status);
  lines.add(result.message.empty() ? say::summary_status(status) : say::summary_status_message(status, result.message));
}

/// What the six numbers are. Positions of an antenna give a lever arm and no attitude: no pose of anything.
Message meaning(const calibration::CalibrationResult& result) {
  const calibration::Mounting& mounting = result.mounting;
  const std::string frame(to_string(mounting.reference)), name = results::name_of(mounting.frames());
  if (mounting.reference == calibration::BodyFrame::Antenna) return say::summary_lever_arm_turned(name);
  if (mounting.sensor == calibration::BodyFrame::Antenna) return say::summary_lever_arm(name, frame);
  return say::summary_pose(name, std::string(to_string(mounting.sensor)), frame);
}

Message sigma_of(calibration::Parameter parameter, const calibration::Estimate& estimate) {
  if (!estimate.sigma) return say::summary_not_observed();
  const double shown = results::on_screen(parameter, *estimate.sigma);
  const std::string text = (shown < 1e-6 ? formats::format_numbers("%.1e", shown)
                                         : formats::rounded_text(shown, results::justified_decimals(shown))) +
                           (calibration::is_angle(parameter) ? " deg" : " m");
  return estimate.measured ? say::summary_sigma_with_measured(text) : say::summary_sigma(text);
}

/// Decimal points stand below each other, whatever the digits behind them.
std::string align(double value, int decimals, const char* unit) {
  constexpr std::size_t kBefore = 7, kWidth = 19;
  std::string text = formats::rounded_text(value, decimals);
  const std::size_t point = std::min(text.find('.'), text.size());
  text.insert(0, kBefore - std::min(kBefore, point), ' ');
  text += std::string(" ") + unit;
  text.resize(std::max(text.size(), kWidth), ' ');
  return text;
}

void add_row(calibration::Parameter parameter, double value, const calibration::Estimate& estimate, Lines& lines) {
  constexpr int kUnknown = 4;  // what is not observed holds what was given
  const int decimals =
      estimate.sigma ? results::justified_decimals(results::on_screen(parameter, *estimate.sigma)) : kUnknown;
  lines.add_row(formats::format_numbers("  %-5s", std::string(to_string(parameter)).c_str()) +
                    align(value, decimals, calibration::is_angle(parameter) ? "deg" : "m"),
                sigma_of(parameter, estimate));
}

void add_parameters(const calibration::CalibrationResult& result, Lines& lines) {
  const calibration::PerParameter<double> values = results::six_on_screen(result.mounting.reference_from_sensor);
  lines.add(meaning(result));
  for (const calibration::Parameter parameter : calibration::kParameters)
    add_row(parameter, values[parameter], result.estimate(parameter), lines);
}

void add_relative(const results::RelativeRecord& two, Lines& lines) {
  const calibration::PerParameter<double> values = results::six_on_screen(two.lidar_a_from_lidar_b);
  lines.add(say::rig_relative_title(two.lidar_b, two.lidar_a));
  for (const calibration::Parameter parameter : calibration::kParameters) {
    calibration::Estimate estimate;
    estimate.sigma = two.sigma[parameter];
    add_row(parameter, values[parameter], estimate, lines);
  }
}

void add_sharpness(const std::vector<quality::NamedSharpness>& list, Lines& lines) {
  std::vector<Message> thickness;
  for (const quality::NamedSharpness& one : list) {
    const Length thick{one.sharpness.plane_thickness_m};
    if (!std::isfinite(thick.m)) continue;
    if (one.source == calibration::MountingSource::Result)
      thickness.push_back(say::summary_thick_under_result(thick, one.sharpness.mean_map_entropy));
    if (one.source == calibration::MountingSource::Nominal)
      thickness.push_back(say::summary_thick_under_nominal(thick, one.sharpness.mean_map_entropy));
  }
  if (!thickness.empty()) lines.add(say::summary_map_check(thickness));
}

void add_pairs(const results::ResultFile& file, Lines& lines) {
  const calibration::CalibrationResult& result = file.result;
  lines.add(say::summary_pairs(result.pairs_proposed, result.pairs_accepted, result.pairs_rejected));
  for (const Message& line : results::pair_lines(file)) lines.add_indented(line);
}

/// The offset of the clocks, of each session where there are several, and whether X is solved with it.
void add_time_offset(const calibration::CalibrationResult& result, Lines& lines) {
  const calibration::TimeOffset& clock = result.time_offset;
  const auto of = result.session_time_offset_s.size() > 1 ? say::summary_time_offset_mean : say::summary_time_offset;
  const Message offset = of(Duration{clock.offset_s}, Duration{clock.sigma_s}, results::clock_use_words(clock));
  lines.add(clock.applied ? say::summary_solved_with_offset(offset) : offset);
  const std::vector<double>&offsets_s = result.session_time_offset_s, &sigmas_s = result.session_time_offset_sigma_s;
  for (std::size_t s = 0; offsets_s.size() > 1 && s < offsets_s.size(); ++s)
    lines.add_indented(s < sigmas_s.size()
                           ? say::summary_session_offset_sigma(s + 1, Duration{offsets_s[s]}, Duration{sigmas_s[s]})
                           : say::summary_session_offset(s + 1, Duration{offsets_s[s]}));
}

void add_quantities(const std::vector<calibration::NamedQuantity>& list, Lines& lines) {
  constexpr std::size_t kMost = 8;
  std::vector<Message> quantities;
  for (const calibration::NamedQuantity& quantity : list)
    quantities.push_back(say::summary_quantity(quantity.name, report::quantity_text(quantity, lines.language())));
  if (quantities.empty()) return;
  lines.add(say::summary_also_determined());
  lines.add_first(quantities, kMost, "  ");
}

void add_advice(const calibration::CalibrationResult& result, Lines& lines) {
  constexpr std::size_t kMost = 6;
  std::vector<Message> advice;
  for (const Message& one : result.advice) advice.push_back(say::summary_advice(one));
  lines.add_first(advice, kMost);
}

/// What the program decided on its own; its warnings have been printed already.
void add_deciding_notes(const std::vector<drive::Finding>& findings, Lines& lines) {
  constexpr std::size_t kMost = 6;
  std::vector<Message> notes;
  for (const drive::Finding& finding : findings)
    if (results::is_deciding(finding)) notes.push_back(say::summary_note(finding.where.words(), finding.explanation));
  lines.add_first(notes, kMost);
}

}  // namespace

std::string summary(const results::ResultFile& file, Language language) {
  const calibration::CalibrationResult& result = file.result;
  const bool usable = calibration::is_usable(result);
  Lines lines(language);
  add_status(result, lines);
  if (usable) add_parameters(result, lines);
  // What to do comes before what it rests on.
  add_advice(result, lines);
  add_deciding_notes(file.findings, lines);
  if (usable && std::isfinite(result.time_offset.offset_s)) add_time_offset(result, lines);
  if (const Message scatter = results::disagreement_words(result); !scatter.empty()) lines.add(scatter);
  if (results::is_from_pairs(file)) add_pairs(file, lines);
  if (usable && results::is_from_pairs(file))
    lines.add(
        say::summary_error(Angle{result.rotation_rms_rad}, Length{result.translation_rms_m}, result.frobenius_sum));
  if (usable) add_sharpness(file.sharpness, lines);
  add_quantities(file.quantities, lines);
  return lines.text();
}

std::string relatives_summary(const results::VehicleFile& vehicle, const std::vector<Message>& heights,
                              Language language) {
  Lines lines(language);
  for (const results::RelativeRecord& two : vehicle.relatives) add_relative(two, lines);
  for (const Message& height : heights) lines.add(height);
  for (const drive::Finding& finding : vehicle.findings)
    if (finding.severity == drive::Severity::Note)
      lines.add(say::summary_note(finding.where.words(), finding.explanation));
  return lines.text();
}

}  // namespace remount::cli
