#include "model/report/report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "algorithms/calibration/observability.h"
#include "algorithms/messages/render.h"
#include "model/checks/data_check.h"
#include "model/display_units.h"
#include "model/io/base64.h"
#include "model/report/plot_chart.h"
#include "model/result_words.h"
#include "model/session_report.h"
#include "model/settings_file.h"

namespace remount {
namespace {

constexpr const char* kCss =
    "body{font-family:'Noto Sans','Noto Sans CJK SC',sans-serif;color:#222;"
    "max-width:860px;margin:24px auto;padding:0 16px}h1{font-size:22px}img,svg{max-width:100%;height:auto}"
    "h2{font-size:16px;margin-top:26px;border-bottom:1px solid #ccc}table{border-collapse:collapse;font-size:12px}"
    "td,th{padding:2px 8px;border:1px solid #d5d8dd;text-align:right}th{background:#f0f2f5}td{white-space:nowrap}"
    "td.text,th.text{text-align:left}td.text{white-space:normal;overflow-wrap:anywhere}"
    ".weak{color:#777}.warn{color:#9a4a00}pre{font-size:11px;background:#f6f7f9;padding:8px}";

std::string number(const char* pattern, double value, const char* instead = "–") {
  if (!std::isfinite(value)) return instead;
  char text[64];
  std::snprintf(text, sizeof(text), pattern, value);
  return text;
}

/// Writes the page part by part, each a function that fits on a screen.
class Page {
 public:
  Page(const Report& report, const ReportStyle& style)
      : report_(report), file_(report.file), result_(report.file.result), style_(style) {}

  std::string write();

 private:
  std::string phrase(const char* context, const char* english) const {
    return html_escaped(style_.phrase ? style_.phrase(context, english) : english);
  }
  std::string sentence(const Message& text) const {
    return html_escaped(style_.sentence ? style_.sentence(text) : english(text));
  }
  std::string parameter(std::size_t i) const { return sentence(std::string(kParameterNames[i])); }
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
  Phrases words() const {
    return [this](const char* context, const char* english) {
      return style_.phrase ? style_.phrase(context, english) : std::string(english);
    };
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
  const ResultFile& file_;
  const CalibrationResult& result_;
  const ReportStyle& style_;
  Texts texts_ = Texts::First;  // of the table that is being written
  std::string html_;
};

void Page::write_verdict() {
  html_ += "<h1>" + phrase("report", "Calibration of a LiDAR: report") + "</h1>\n<p class=\"weak\">";
  if (!report_.created.empty()) html_ += html_escaped(report_.created) + " · ";
  html_ += "Remount " + html_escaped(file_.version) + "</p>\n";
  html_ += "<p><b>" + phrase("report", "Status") + ": " + sentence(std::string(to_string(result_.status))) + ".</b> " +
           sentence(result_.message) + "</p>\n";
  std::vector<std::string> advice;
  for (const Message& line : result_.advice) advice.push_back(sentence(line));
  list(advice);
}

void Page::write_parameters() {
  const bool of_ins = result_.reference_frame == "ins", of_antenna = result_.calibrated == "antenna";
  const std::string name = html_escaped(result_.reference_frame + "_from_" + result_.calibrated);
  heading(of_ins ? phrase("report", "LiDAR in the INS frame (ins_from_lidar)")
                 : (of_antenna                             ? phrase("report", "Antenna in the reference frame")
                    : result_.reference_frame == "antenna" ? phrase("report", "LiDAR from the antenna, in its own axes")
                                                           : phrase("report", "LiDAR in the reference frame")) +
                       ": " + name);
  begin_table();
  header({"", phrase("report", "value"), phrase("report", "1 sigma"), phrase("report", "by resampling"),
          phrase("report", "nominal"), phrase("report", "new − nominal")});
  const std::array<double, 6> values = six_on_screen(result_.ins_from_lidar);
  for (std::size_t i = 0; i < 6; ++i) {
    const char* unit = is_angle(i) ? " °" : " m";
    const auto sigma = result_.sigma(i);
    std::string nominal = "–", change = "–";
    if (file_.nominal_ins_from_lidar) {
      const double given = six_on_screen(*file_.nominal_ins_from_lidar)[i];
      double moved = values[i] - given;
      if (is_angle(i)) moved = radians_to_degrees(wrap_angle_rad(degrees_to_radians(moved)));
      nominal = number("%.4f", given) + unit;
      if (has_mounting(result_)) change = number("%+.4f", moved) + unit;
    }
    row({parameter(i) + (result_.measured[i] ? " *" : ""),
         has_mounting(result_) ? number("%.4f", values[i]) + unit : "–",
         sigma ? "± " + number("%.4f", on_screen(i, *sigma)) + unit : phrase("report", "not observed"),
         sigma && result_.bootstrap_sigma[i] > 0.0
             ? "± " + number("%.4f", on_screen(i, result_.bootstrap_sigma[i])) + unit
             : "–",
         nominal, change});
  }
  end_table();
  html_ +=
      "<p class=\"weak\">" +
      (of_ins ? phrase("report", "R = Rz(yaw) Ry(pitch) Rx(roll); point_in_ins = ins_from_lidar * point_in_lidar.")
       : of_antenna || result_.reference_frame == "antenna"
           ? phrase("report", "Positions of an antenna give its lever arm, m, and no attitude.")
           : phrase("report", "R = Rz(yaw) Ry(pitch) Rx(roll); X takes points of the LiDAR to the reference frame."));
  if (is_any_measured(result_)) html_ += " " + phrase("report", "* with a value measured by hand.");
  html_ += "</p>\n";
}

void Page::write_transform() {
  if (!has_mounting(result_)) return;
  begin_table();
  for (int r = 0; r < 4; ++r) {
    std::vector<std::string> cells;
    for (int c = 0; c < 4; ++c) cells.push_back(number("%.9f", result_.ins_from_lidar.matrix()(r, c)));
    row(cells);
  }
  end_table();
  const Eigen::Quaterniond q(result_.ins_from_lidar.linear());
  html_ += "<p class=\"weak\">" + phrase("report", "quaternion x, y, z, w") + ": " + number("%.9f", q.x()) + ", " +
           number("%.9f", q.y()) + ", " + number("%.9f", q.z()) + ", " + number("%.9f", q.w()) + "</p>\n";
}

void Page::write_method() {
  if (file_.method == kPairwise && file_.quantities.empty() && file_.plots.empty()) return;
  heading(phrase("report", "Method") + ": " + html_escaped(file_.method));
  if (!file_.quantities.empty()) {
    begin_table();
    for (const NamedQuantity& quantity : file_.quantities)
      row({sentence(quantity.name), html_escaped(quantity_text(quantity, words()))});
    end_table();
  }
  for (const Plot& plot : file_.plots) chart(plot_chart(plot, words()));
}

/// As the window has it: blue for negative, orange for positive, stronger with size.
std::string correlation_color(double value) {
  constexpr std::array<int, 3> kNegative{0x2b, 0x7b, 0xd6}, kPositive{0xe0, 0x7b, 0x1a};
  const double share = std::isfinite(value) ? 0.5 * std::min(1.0, std::abs(value)) : 0.0;
  const auto mixed = [&](std::size_t i) {
    return 255 - static_cast<int>(share * (255 - (value < 0.0 ? kNegative : kPositive)[i]));
  };
  char color[16];
  std::snprintf(color, sizeof(color), "#%02x%02x%02x", mixed(0), mixed(1), mixed(2));
  return color;
}

void Page::write_correlation() {
  heading(phrase("report", "Correlation of the parameters"));
  begin_table();
  std::vector<std::string> titles{""};
  for (std::size_t i = 0; i < 6; ++i) titles.push_back(parameter(i));
  header(titles);
  for (std::size_t i = 0; i < 6; ++i) {
    html_ += "<tr><th class=\"text\" align=\"left\">" + parameter(i) + "</th>";
    for (std::size_t k = 0; k < 6; ++k) {
      const double value = correlation(result_, i, k);
      html_ += "<td align=\"right\" bgcolor=\"" + correlation_color(value) + "\">" + number("%.2f", value) + "</td>";
    }
    html_ += "</tr>\n";
  }
  end_table();
}

void Page::write_observability() {
  heading(phrase("report", "What the drive can tell"));
  std::vector<std::string> lines;
  for (const ObservabilityDirection& direction : result_.directions)
    if (!direction.words.empty()) {
      // Two directions of the same parameters have the same words.
      const std::string line = (direction.observed ? "" : "<span class=\"warn\">▲</span> ") + sentence(direction.words);
      if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
    }
  std::string blind;
  for (std::size_t i = 0; i < 6; ++i)
    if (!result_.observed[i]) blind += (blind.empty() ? "" : ", ") + parameter(i);
  lines.push_back(!blind.empty()             ? phrase("report", "Not observed") + ": " + blind
                  : is_any_measured(result_) ? phrase("report", "All six parameters are known, with what was measured.")
                                             : phrase("report", "All six parameters are observed."));
  if (const Message words = disagreement_words(result_); !words.empty()) lines.push_back(sentence(words));
  for (const Message& words : clock_words(result_)) lines.push_back(sentence(words));
  list(lines);
}

void Page::write_sharpness() {
  heading(phrase("report", "Check by the accumulated map"));
  if (file_.sharpness.empty()) {
    html_ += "<p class=\"weak\">" + phrase("report", "No map check was made.") + "</p>\n";
    return;
  }
  html_ += "<p>" + phrase("report", "Lower is sharper. This check does not use the residual.") + "</p>\n";
  begin_table();
  header({phrase("report", "under"), phrase("report", "mean map entropy"), phrase("report", "thickness of planes"),
          phrase("report", "neighbourhoods")});
  for (const NamedSharpness& entry : file_.sharpness)
    row({sentence(entry.source), number("%.4f", entry.sharpness.mean_map_entropy),
         number("%.1f mm", 1e3 * entry.sharpness.plane_thickness_m), std::to_string(entry.sharpness.points)});
  end_table();
}

void Page::write_pictures() {
  html_ += "<h2 style=\"page-break-before:always\">" + phrase("report", "Worst and best pairs") + "</h2>\n";
  if (!report_.no_pictures.empty()) html_ += "<p class=\"weak\">" + html_escaped(report_.no_pictures) + "</p>\n";
  for (std::size_t i = 0; i < report_.pictures.size(); ++i) {
    const ReportPicture& picture = report_.pictures[i];
    // Two fill a page: on paper a picture and its caption stay together.
    html_ += i > 0 && i % 2 == 0 ? "<p style=\"page-break-before:always\">" : "<p>";
    html_ += html_escaped(picture.caption) + "<br>" +
             (style_.picture ? style_.picture(picture)
                             : "<img alt=\"" + html_escaped(picture.caption) + "\" src=\"data:image/png;base64," +
                                   base64(picture.png) + "\">") +
             "</p>\n";
  }
}

void Page::write_charts() {
  if (is_from_pairs(file_)) {
    heading(phrase("report", "Residuals of the pairs"));
    chart(residual_chart(file_.pairs, ChartedResidual::Translation, words()));
    chart(residual_chart(file_.pairs, ChartedResidual::Rotation, words()));
  }
  heading(phrase("report", "Drive"));
  if (report_.tracks.empty())
    html_ += "<p class=\"weak\">" + phrase("report", "The sessions were not opened for this report.") + "</p>\n";
  for (const ReportTrack& track : report_.tracks) chart(track_chart(track, words()));
}

void Page::write_pairs() {
  heading(phrase("report", "Pairs"));
  html_ += "<p>" + phrase("report", "proposed") + ": " + std::to_string(result_.pairs_proposed) + ", " +
           phrase("report", "accepted") + ": " + std::to_string(result_.pairs_accepted) + ", " +
           phrase("report", "rejected") + ": " + std::to_string(result_.pairs_rejected) + "; " +
           phrase("report", "rms of residuals") + ": " + number("%.2f cm", 100.0 * result_.translation_rms_m) + ", " +
           number("%.3f °", radians_to_degrees(result_.rotation_rms_rad)) + "</p>\n";
  begin_table(Texts::FirstAndLast);
  header({phrase("report", "pair"), phrase("report", "session"), phrase("report", "scan a (UTC)"),
          phrase("report", "gap"), phrase("report", "baseline"), phrase("report", "turn"), phrase("report", "RMSE"),
          phrase("report", "overlap"), phrase("report", "screw test"), phrase("report", "residual"),
          phrase("report", "state"), phrase("report", "reason")});
  for (std::size_t i = 0; i < file_.pairs.size(); ++i) {
    const PairRecord& pair = file_.pairs[i];
    row({std::to_string(i), std::to_string(pair.session + 1), html_escaped(utc_text(pair.stamp_a_ns).substr(11, 12)),
         number("%.1f s", 1e-9 * static_cast<double>(pair.stamp_b_ns - pair.stamp_a_ns)),
         number("%.2f m", pair.baseline_m), number("%.1f °", radians_to_degrees(pair.rotation_rad)),
         number("%.1f cm", 100.0 * pair.rmse_m), number("%.2f", pair.overlap), number("%.1f σ", pair.screw_score),
         number("%.1f cm", 100.0 * pair.residual_translation_m) + " " +
             number("%.2f °", radians_to_degrees(pair.residual_rotation_rad)),
         phrase("report", std::string(to_string(pair.state)).c_str()), sentence(pair.reason)});
  }
  end_table();
}

void Page::write_findings() {
  if (file_.findings.empty()) return;
  heading(phrase("report", "Warnings"));
  begin_table(Texts::All);
  header({phrase("report", "code"), phrase("report", "where"), phrase("report", "what was found"),
          phrase("report", "what it means, and what to do")});
  for (const Finding& finding : file_.findings) {
    const FindingKind* kind = finding_kind(finding.code);
    row({html_escaped(finding.code), html_escaped(finding.where), sentence(finding.explanation),
         kind ? sentence(kind->meaning()) + " " + sentence(kind->remedy()) : "–"});
  }
  end_table();
}

void Page::write_data() {
  heading(phrase("report", "Data"));
  if (file_.inputs.empty()) {
    html_ += "<p class=\"weak\">" + phrase("report", "The files' hashes are not known.") + "</p>\n";
    return;
  }
  begin_table(Texts::All);
  header({phrase("report", "session"), phrase("report", "file"), phrase("report", "bytes"), "SHA-256"});
  for (const InputFile& input : file_.inputs)
    row({html_escaped(input.session), html_escaped(input.file), std::to_string(input.bytes),
         input.sha256.empty() ? "–" : input.sha256});
  end_table();
}

void Page::write_settings() {
  heading(phrase("report", "Settings"));
  const DocumentNode now = settings_document(file_.settings), usual = settings_document(Settings{});
  std::vector<std::string> changed;
  for (std::size_t s = 0; s < now.items.size(); ++s)
    for (std::size_t i = 0; i < now.items[s].items.size(); ++i)
      if (now.items[s].items[i].text != usual.items[s].items[i].text)
        changed.push_back(html_escaped(now.keys[s] + "." + now.items[s].keys[i] + " = " + now.items[s].items[i].text +
                                       "   (" + usual.items[s].items[i].text + ")"));
  html_ += "<p>" +
           (changed.empty() ? phrase("report", "All settings have their defaults.")
                            : phrase("report", "Changed from the defaults (in brackets):")) +
           "</p>\n";
  list(changed);
  html_ += "<pre>" + html_escaped(settings_text(file_.settings, false)) + "</pre>\n";
}

std::string Page::write() {
  html_ = "<!DOCTYPE html>\n<html lang=\"" + html_escaped(style_.language) +
          "\"><head><meta charset=\"utf-8\"><title>" + phrase("report", "Calibration of a LiDAR: report") +
          "</title><style>" + kCss + "</style></head>\n<body>\n";
  write_verdict();
  write_parameters();
  write_transform();
  write_method();
  write_observability();
  write_correlation();
  write_sharpness();
  write_charts();
  if (is_from_pairs(file_)) {
    write_pictures();
    write_pairs();
  }
  write_findings();
  write_data();
  write_settings();
  return html_ + "</body></html>\n";
}

}  // namespace

double correlation(const CalibrationResult& result, std::size_t i, std::size_t k) {
  const auto a = result.sigma(i), b = result.sigma(k);
  if (!a || !b || !(*a > 0.0) || !(*b > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  return result.covariance(static_cast<int>(i), static_cast<int>(k)) / (*a * *b);
}

std::vector<std::size_t> pairs_to_picture(const std::vector<PairRecord>& pairs, std::size_t worst, std::size_t best) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (pairs[i].state == PairState::Accepted && std::isfinite(pairs[i].residual_translation_m)) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return pairs[a].residual_translation_m > pairs[b].residual_translation_m;
  });
  std::vector<std::size_t> chosen(order.begin(),
                                  order.begin() + static_cast<std::ptrdiff_t>(std::min(worst, order.size())));
  for (std::size_t i = order.size(); i > worst && order.size() - i < best; --i) chosen.push_back(order[i - 1]);
  return chosen;
}

std::string report_html(const Report& report, const ReportStyle& style) { return Page(report, style).write(); }

}  // namespace remount
