#include "model/report/report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "algorithms/calibration/observability.h"
#include "algorithms/core/stamps.h"
#include "algorithms/messages/render.h"
#include "messages/report.h"
#include "model/checks/data_check.h"
#include "model/formats/files/base64.h"
#include "model/formats/files/number_text.h"
#include "model/formats/files/printable_text.h"
#include "model/formats/files/time_stamp.h"
#include "model/overview/session_report.h"
#include "model/report/plot_chart.h"
#include "model/results/display_units.h"
#include "model/results/mounting_frames.h"
#include "model/results/result_words.h"
#include "model/settings/settings_file.h"

namespace remount::report {
namespace {

std::string number(const char* pattern, double value, const char* instead = "–") {
  if (!std::isfinite(value)) return instead;
  const std::string text = formats::format_numbers(pattern, value);
  // No minus before nothing.
  const bool nothing = text.find_first_of("123456789") == std::string::npos;
  return nothing && text.starts_with('-') ? formats::format_numbers(pattern, 0.0) : text;
}

Message state_word(motion::PairState state) {
  return state == motion::PairState::Accepted   ? say::report_accepted()
         : state == motion::PairState::Rejected ? say::report_rejected()
                                                : say::report_proposed();
}

/// Writes the page part by part, each a function that fits on a screen.
class Page {
 public:
  Page(const Report& report, const ReportStyle& style)
      : report_(report), file_(report.file), result_(report.file.result), style_(style) {}

  std::string write_body();

 private:
  std::string words(const Message& message) const { return formats::escape_html(render(message, style_.language)); }
  std::string parameter(calibration::Parameter one) const { return words(calibration::parameter_word(one)); }
  void weak(const std::string& text) { html_ += "<p class=\"weak\">" + text + "</p>\n"; }
  void heading(const std::string& text) { html_ += "<h2>" + text + "</h2>\n"; }
  enum class Texts { First, FirstAndLast, All };  // which columns are words, set to the left
  /// Repeated on each page of paper.
  void header(const std::vector<std::string>& cells) {
    html_ += "<thead>";
    row(cells, "th");
    html_ += "</thead>\n";
  }
  void cell(const std::string& content, const std::string& tag, bool is_text) {
    const char* style = is_text ? " class=\"text\" align=\"left\">" : " align=\"right\">";
    html_.append("<").append(tag).append(style).append(content).append("</").append(tag).append(">");
  }
  void row(const std::vector<std::string>& cells, const char* tag = "td") {
    html_ += "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i)
      cell(cells[i], tag, texts_ == Texts::All || i == 0 || (texts_ == Texts::FirstAndLast && i + 1 == cells.size()));
    html_ += "</tr>\n";
  }
  void begin_table(Texts texts = Texts::First) {
    texts_ = texts;
    html_ += "<table border=\"1\" cellspacing=\"0\" cellpadding=\"3\">\n";
  }
  void end_table() { html_ += "</table>\n"; }
  void list(const std::vector<std::string>& items) {
    html_ += items.empty() ? "" : "<ul>";
    for (const std::string& item : items) html_ += "<li>" + item + "</li>";
    html_ += items.empty() ? "" : "</ul>\n";
  }
  void chart(const Drawing& drawing) {
    html_ += "<p>" + (style_.chart ? style_.chart(drawing) : to_svg(drawing)) + "</p>\n";
  }
  void write_verdict();
  void write_parameters();
  void write_transform();
  void write_method();
  void write_correlation();
  void write_observability();
  void write_sharpness();
  void write_pictures();
  void write_charts();
  void write_pairs();
  void write_findings();
  void write_data();
  void write_settings();

  const Report& report_;
  const results::ResultFile& file_;
  const calibration::CalibrationResult& result_;
  const ReportStyle& style_;
  Texts texts_ = Texts::First;  // of the table that is being written
  std::string html_;
};

void Page::write_verdict() {
  html_ += "<h1>" + words(say::report_title());
  if (!report_.lidar.empty()) html_ += ": " + formats::escape_html(report_.lidar);
  html_ += "</h1>\n<p class=\"weak\">";
  if (!report_.created.empty()) html_ += formats::escape_html(report_.created) + " · ";
  html_ += "Remount " + formats::escape_html(file_.version) + "</p>\n";
  html_ += "<p><b>" + words(say::report_status()) + ": " + words(results::status_word(result_.status)) + ".</b> " +
           words(result_.message) + "</p>\n";
  std::vector<std::string> advice;
  for (const Message& line : result_.advice) advice.push_back(words(line));
  list(advice);
}

void Page::write_parameters() {
  const calibration::Mounting& mounting = result_.mounting;
  const bool of_ins = mounting.reference == calibration::BodyFrame::Ins,
             of_antenna = mounting.sensor == calibration::BodyFrame::Antenna,
             from_antenna = mounting.reference == calibration::BodyFrame::Antenna;
  const std::string name = results::name_of(mounting.frames());
  heading(words(of_ins         ? say::report_lidar_in_ins()
                : of_antenna   ? say::report_antenna_in_frame(name)
                : from_antenna ? say::report_lidar_from_antenna(name)
                               : say::report_lidar_in_frame(name)));
  begin_table();
  header({"", words(say::report_value()), words(say::report_one_sigma()), words(say::report_by_resampling()),
          words(say::report_nominal()), words(say::report_new_minus_nominal())});
  const calibration::PerParameter<double> values = results::six_on_screen(mounting.reference_from_sensor);
  for (const calibration::Parameter i : calibration::kParameters) {
    const char* unit = calibration::is_angle(i) ? " °" : " m";
    const calibration::Estimate estimate = result_.estimate(i);
    std::string nominal = "–", change = "–";
    if (file_.nominal_ins_from_lidar) {
      const double given = results::six_on_screen(*file_.nominal_ins_from_lidar)[i];
      double moved = values[i] - given;
      if (calibration::is_angle(i)) moved = radians_to_degrees(wrap_angle_rad(degrees_to_radians(moved)));
      nominal = formats::rounded_text(given, 4) + unit;
      if (results::has_mounting(result_)) change = formats::signed_text(moved, 4) + unit;
    }
    row({parameter(i) + (estimate.measured ? " *" : ""),
         results::has_mounting(result_) ? formats::rounded_text(values[i], 4) + unit : "–",
         estimate.sigma ? "± " + formats::spread_text(results::on_screen(i, *estimate.sigma), 4) + unit
                        : words(say::report_not_observed()),
         estimate.bootstrap_sigma > 0.0
             ? "± " + formats::spread_text(results::on_screen(i, *estimate.bootstrap_sigma), 4) + unit
             : "–",
         nominal, change});
  }
  end_table();
  html_ += "<p class=\"weak\">" + words(of_ins                       ? say::report_convention_ins()
                                        : of_antenna || from_antenna ? say::report_convention_antenna()
                                                                     : say::report_convention_frame());
  if (calibration::is_any_measured(result_)) html_ += " " + words(say::report_with_measured());
  html_ += "</p>\n";
}

void Page::write_transform() {
  if (!results::has_mounting(result_)) return;
  begin_table();
  for (int r = 0; r < 4; ++r) {
    std::vector<std::string> cells;
    for (int c = 0; c < 4; ++c) cells.push_back(number("%.9f", result_.mounting.reference_from_sensor.matrix()(r, c)));
    row(cells);
  }
  end_table();
  const Eigen::Quaterniond q(result_.mounting.reference_from_sensor.linear());
  weak(words(say::report_quaternion(
      {number("%.9f", q.x()), number("%.9f", q.y()), number("%.9f", q.z()), number("%.9f", q.w())})));
}

void Page::write_method() {
  if (file_.method == calibration::kPairwise && file_.quantities.empty() && file_.plots.empty()) return;
  heading(words(say::report_method(file_.method)));
  if (!file_.quantities.empty()) {
    begin_table();
    for (const calibration::NamedQuantity& quantity : file_.quantities)
      row({words(quantity.name), formats::escape_html(quantity_text(quantity, style_.language))});
    end_table();
  }
  for (const calibration::Plot& plot : file_.plots) chart(plot_chart(plot, style_.language));
}

/// As the window has it: blue for negative, orange for positive, stronger with size.
std::string correlation_color(double value) {
  constexpr std::array<int, 3> kNegative{0x2b, 0x7b, 0xd6}, kPositive{0xe0, 0x7b, 0x1a};
  const double share = std::isfinite(value) ? 0.5 * std::min(1.0, std::abs(value)) : 0.0;
  const auto mixed = [&](std::size_t i) {
    return 255 - static_cast<int>(share * (255 - (value < 0.0 ? kNegative : kPositive)[i]));
  };
  return formats::format_numbers("#%02x%02x%02x", mixed(0), mixed(1), mixed(2));
}

void Page::write_correlation() {
  heading(words(say::report_correlation()));
  begin_table();
  std::vector<std::string> titles{""};
  for (const calibration::Parameter i : calibration::kParameters) titles.push_back(parameter(i));
  header(titles);
  for (const calibration::Parameter i : calibration::kParameters) {
    html_ += "<tr><th class=\"text\" align=\"left\">" + parameter(i) + "</th>";
    for (const calibration::Parameter k : calibration::kParameters) {
      const double value = correlation(result_, i, k);
      html_ += "<td align=\"right\" bgcolor=\"" + correlation_color(value) + "\">" + number("%.2f", value) + "</td>";
    }
    html_ += "</tr>\n";
  }
  end_table();
}

void Page::write_observability() {
  heading(words(say::report_what_drive_tells()));
  std::vector<std::string> lines;
  for (const calibration::ObservabilityDirection& direction : result_.directions)
    if (!direction.words.empty()) {
      // Two directions of the same parameters have the same words.
      const std::string line = (direction.observed ? "" : "<span class=\"warn\">▲</span> ") + words(direction.words);
      if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
    }
  std::vector<Message> blind = calibration::parameter_words(~result_.observed());
  lines.push_back(words(!blind.empty()                          ? say::report_parameters_not_observed(blind)
                        : calibration::is_any_measured(result_) ? say::report_all_known()
                                                                : say::report_all_observed()));
  if (const Message scatter = results::disagreement_words(result_); !scatter.empty()) lines.push_back(words(scatter));
  for (const auto& clock : results::clock_words(result_)) lines.push_back(words(clock));
  list(lines);
}

void Page::write_sharpness() {
  heading(words(say::report_map_check()));
  if (file_.sharpness.empty()) {
    weak(words(say::report_no_map_check()));
    return;
  }
  html_ += "<p>" + words(say::report_lower_is_sharper()) + "</p>\n";
  begin_table();
  header({words(say::report_under()), words(say::report_entropy()), words(say::report_thickness()),
          words(say::report_neighbourhoods())});
  for (const quality::NamedSharpness& entry : file_.sharpness)
    row({words(calibration::in_words(entry.source)), number("%.4f", entry.sharpness.mean_map_entropy),
         number("%.1f mm", 1e3 * entry.sharpness.plane_thickness_m), std::to_string(entry.sharpness.points)});
  end_table();
}

void Page::write_pictures() {
  html_ += "<h2 style=\"page-break-before:always\">" + words(say::report_worst_and_best_pairs()) + "</h2>\n";
  if (!report_.no_pictures.empty()) weak(words(report_.no_pictures));
  for (std::size_t i = 0; i < report_.pictures.size(); ++i) {
    const ReportPicture& picture = report_.pictures[i];
    // Two fill a page: on paper a picture and its caption stay together.
    html_ += i > 0 && i % 2 == 0 ? "<p style=\"page-break-before:always\">" : "<p>";
    html_ += formats::escape_html(picture.caption) + "<br>" +
             (style_.picture ? style_.picture(picture)
                             : "<img alt=\"" + formats::escape_html(picture.caption) +
                                   "\" src=\"data:image/png;base64," + formats::base64(picture.png) + "\">") +
             "</p>\n";
  }
}

void Page::write_charts() {
  if (results::is_from_pairs(file_)) {
    heading(words(say::report_residuals()));
    chart(residual_chart(file_.pairs, ChartedResidual::Translation, style_.language));
    chart(residual_chart(file_.pairs, ChartedResidual::Rotation, style_.language));
  }
  heading(words(say::report_drive()));
  if (report_.tracks.empty()) weak(words(say::report_sessions_not_opened()));
  for (const ReportTrack& track : report_.tracks) chart(track_chart(track, style_.language));
}

void Page::write_pairs() {
  heading(words(say::report_pairs()));
  html_ += "<p>" +
           words(say::report_counts(result_.pairs_proposed, result_.pairs_accepted, result_.pairs_rejected,
                                    Length{result_.translation_rms_m}, Angle{result_.rotation_rms_rad})) +
           "</p>\n";
  begin_table(Texts::FirstAndLast);
  header({words(say::report_pair()), words(say::report_session()), words(say::report_scan_a()),
          words(say::report_gap()), words(say::report_baseline()), words(say::report_turn()), words(say::report_rmse()),
          words(say::report_overlap()), words(say::report_screw_test()), words(say::report_residual()),
          words(say::report_state()), words(say::report_reason())});
  for (std::size_t i = 0; i < file_.pairs.size(); ++i) {
    const results::PairRecord& pair = file_.pairs[i];
    // Of poses there are no scans that could be aligned.
    const bool of_scans = pair.rmse_m > 0.0 || pair.overlap < 1.0;
    const auto if_scans = [of_scans](std::string text) { return of_scans ? std::move(text) : std::string("–"); };
    row({std::to_string(i), std::to_string(pair.session + 1),
         formats::escape_html(formats::utc_text(pair.stamp_a_ns).substr(11, 12)),
         number("%.1f s", seconds(pair.stamp_b_ns - pair.stamp_a_ns)), number("%.2f m", pair.baseline_m),
         number("%.1f °", radians_to_degrees(pair.rotation_rad)), if_scans(number("%.1f cm", 100.0 * pair.rmse_m)),
         if_scans(number("%.2f", pair.overlap)), number("%.1f σ", pair.screw_score),
         number("%.1f cm", 100.0 * pair.residual_translation_m) + " " +
             number("%.2f °", radians_to_degrees(pair.residual_rotation_rad)),
         words(state_word(pair.state)), words(pair.reason)});
  }
  end_table();
}

void Page::write_findings() {
  if (file_.findings.empty()) return;
  heading(words(say::report_warnings()));
  begin_table(Texts::All);
  header({words(say::report_code()), words(say::report_where()), words(say::report_what_was_found()),
          words(say::report_what_it_means())});
  for (const drive::Finding& finding : file_.findings) {
    const checks::FindingKind* kind = checks::finding_kind(finding.code);
    row({formats::escape_html(finding.code), words(finding.where.words()), words(finding.explanation),
         kind ? words(Message::sequence({kind->meaning(), kind->remedy()})) : "–"});
  }
  end_table();
}

void Page::write_data() {
  heading(words(say::report_data()));
  if (file_.inputs.empty()) {
    weak(words(say::report_hashes_not_known()));
    return;
  }
  begin_table(Texts::All);
  header({words(say::report_session()), words(say::report_file()), words(say::report_bytes()), "SHA-256"});
  for (const results::InputFile& input : file_.inputs)
    row({formats::escape_html(input.session), formats::escape_html(input.file), std::to_string(input.bytes),
         input.sha256.empty() ? "–" : input.sha256});
  end_table();
}

void Page::write_settings() {
  heading(words(say::report_settings()));
  const formats::DocumentNode now = settings::settings_document(file_.settings),
                              usual = settings::settings_document(settings::Settings{});
  std::vector<std::string> changed;
  for (std::size_t s = 0; s < now.items.size(); ++s)
    for (std::size_t i = 0; i < now.items[s].items.size(); ++i)
      if (now.items[s].items[i].text != usual.items[s].items[i].text)
        changed.push_back(formats::escape_html(now.keys[s] + "." + now.items[s].keys[i] + " = " +
                                               now.items[s].items[i].text + "   (" + usual.items[s].items[i].text +
                                               ")"));
  html_ += "<p>" + (changed.empty() ? words(say::report_settings_usual()) : words(say::report_settings_changed())) +
           "</p>\n";
  list(changed);
  html_ += "<pre>" + formats::escape_html(settings::settings_text(file_.settings, false)) + "</pre>\n";
}

std::string Page::write_body() {
  write_verdict();
  write_parameters();
  write_transform();
  write_method();
  write_observability();
  write_correlation();
  write_sharpness();
  write_charts();
  if (results::is_from_pairs(file_)) {
    write_pictures();
    write_pairs();
  }
  write_findings();
  write_data();
  write_settings();
  return std::move(html_);
}

}  // namespace

double correlation(const calibration::CalibrationResult& result, calibration::Parameter one,
                   calibration::Parameter other) {
  const auto a = result.estimate(one).sigma, b = result.estimate(other).sigma;
  if (!a || !b || !(*a > 0.0) || !(*b > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  return result.covariance(calibration::row_of(one), calibration::row_of(other)) / (*a * *b);
}

std::vector<motion::PairIndex> pairs_to_picture(const std::vector<results::PairRecord>& pairs, std::size_t worst,
                                                std::size_t best) {
  std::vector<motion::PairIndex> order;
  for (motion::PairIndex i; i < pairs.size(); ++i)
    if (pairs[i].state == motion::PairState::Accepted && std::isfinite(pairs[i].residual_translation_m))
      order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](motion::PairIndex a, motion::PairIndex b) {
    return pairs[a].residual_translation_m > pairs[b].residual_translation_m;
  });
  std::vector<motion::PairIndex> chosen(order.begin(), order.begin() + signed_of(std::min(worst, order.size())));
  for (std::size_t i = order.size(); i > worst && order.size() - i < best; --i) chosen.push_back(order[i - 1]);
  return chosen;
}

std::string report_body(const Report& report, const ReportStyle& style) { return Page(report, style).write_body(); }

}  // namespace remount::report
