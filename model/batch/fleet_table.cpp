#include "model/batch/fleet_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "algorithms/messages/render.h"
#include "model/display_units.h"
#include "model/io/document.h"
#include "model/printable_text.h"
#include "model/report/drawing.h"

namespace remount {
namespace {

constexpr const char* kCss =
    "body{font-family:'Noto Sans',sans-serif;color:#222;margin:24px}h1{font-size:22px}"
    "table{border-collapse:collapse;font-size:12px}td,th{padding:2px 8px;border:1px solid #d5d8dd;text-align:right}"
    "th{background:#f0f2f5}td.text,th.text{text-align:left}.weak{color:#777}tr.drift{background:#ffe3d6}"
    "tr.failed{background:#f3e6e6}li.drift{color:#9a2a00}";

std::string format(const char* pattern, auto... values) {
  char text[200];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

const char* unit_of(std::size_t i) { return is_angle(i) ? "deg" : "m"; }

bool usable(const FleetRow& row) { return row.result && is_usable(*row.result); }

std::string status_of(const FleetRow& row) { return row.result ? std::string(to_string(row.result->status)) : ""; }

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string text_line(const Fleet& fleet, const FleetRow& row) {
  const FleetJob& job = fleet.jobs[row.job];
  std::string line = format("%zu  ", row.job + 1) + title_of(fleet, job) + ": ";
  line += row.state == JobState::Done ? status_of(row) : std::string(to_string(row.state));
  if (!row.message.empty()) line += ", " + first_line(english(row.message));
  if (!usable(row)) return line + "\n";
  const std::array<double, 6> values = six_on_screen(row.result->ins_from_lidar);
  line += "\n    ";
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto sigma = row.result->sigma(i);
    line += std::string(i > 0 ? ", " : "") + std::string(kParameterNames[i]) + " ";
    line += sigma ? format("%.4f +-%.4f %s", values[i], on_screen(i, *sigma), unit_of(i)) : "not observed";
  }
  if (!row.last.words.empty()) line += "\n    " + english(row.last.words);
  if (row.has_reference_of_its_own && !row.reference.words.empty())
    line += "\n    By the reference: " + english(row.reference.words);
  if (const std::string drift = row.drift(); !drift.empty()) line += "\n    DRIFT: " + drift;
  return line + "\n";
}

std::string csv_cell(const std::string& cell) {
  const std::string text = printable(cell);
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string csv_number(double value) { return std::isfinite(value) ? shortest(value) : ""; }

/// One line; what holds commas or quotes is quoted.
std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) line += ',';
    line += csv_cell(cells[i]);
  }
  return line + "\n";
}

/// With what, by how much, and whether that is drift; empty where nothing was compared.
void add_change(const FleetChange& change, std::vector<std::string>& cells) {
  cells.push_back(change.since);
  for (std::size_t i = 0; i < kParameterNames.size(); ++i) {
    cells.push_back(csv_number(on_screen(i, change.change.difference[i])));
    cells.push_back(csv_number(on_screen(i, change.change.sigma[i])));
  }
  const bool compared = std::any_of(change.change.difference.begin(), change.change.difference.end(),
                                    [](double value) { return std::isfinite(value); });
  cells.push_back(!change.drift.empty() ? "yes" : compared ? "no" : "");
  cells.push_back(change.drift);
}

std::string csv_columns(const std::string& prefix) {
  std::string columns;
  for (std::size_t i = 0; i < kParameterNames.size(); ++i) {
    const std::string name = prefix + std::string(kParameterNames[i]);
    columns += "," + name + "_" + unit_of(i) + "," + name + "_sigma_" + unit_of(i);
  }
  return columns;
}

std::string csv_line(const Fleet& fleet, const FleetRow& row) {
  const FleetJob& job = fleet.jobs[row.job];
  std::vector<std::string> cells{fleet.vehicles[job.vehicle].name, std::to_string(row.job + 1), job.name,
                                 std::string(to_string(row.state)), status_of(row)};
  const std::array<double, 6> values =
      usable(row) ? six_on_screen(row.result->ins_from_lidar) : std::array<double, 6>{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto sigma = usable(row) ? row.result->sigma(i) : std::nullopt;
    // What is not observed has no value either: a number without a sigma would be taken for one.
    cells.push_back(sigma ? csv_number(values[i]) : "");
    cells.push_back(sigma ? csv_number(on_screen(i, *sigma)) : "");
  }
  add_change(row.last, cells);
  cells.push_back(english(row.message));
  cells.push_back(row.result ? job.result.string() : "");  // a file that is there and belongs to the job
  add_change(row.reference, cells);
  return csv_line(cells);
}

std::string cell(const std::string& text, bool is_text = false) {
  return (is_text ? "<td class=\"text\">" : "<td>") + html_escaped(text) + "</td>";
}

std::string html_change(const FleetChange& change, std::size_t i, const char* what) {
  const double by = change.change.difference[i];
  if (!std::isfinite(by)) return {};
  return format("<br><span class=\"weak\">%s%+.4f ± %.4f (%.1f σ)</span>", what, on_screen(i, by),
                on_screen(i, change.change.sigma[i]), std::abs(by) / change.change.sigma[i]);
}

std::string html_row(const Fleet& fleet, const FleetRow& row) {
  const FleetJob& job = fleet.jobs[row.job];
  const bool failed = row.state == JobState::Failed || (row.result && !is_usable(*row.result));
  std::string html = !row.drift().empty() ? "<tr class=\"drift\">" : failed ? "<tr class=\"failed\">" : "<tr>";
  html += cell(std::to_string(row.job + 1)) + cell(fleet.vehicles[job.vehicle].name, true) + cell(job.name, true) +
          cell(row.state == JobState::Done ? status_of(row) : std::string(to_string(row.state)), true);
  for (std::size_t i = 0; i < kParameterNames.size(); ++i) {
    const auto sigma = usable(row) ? row.result->sigma(i) : std::nullopt;
    html += "<td>";
    if (sigma)
      html += format("%.4f ± %.4f", six_on_screen(row.result->ins_from_lidar)[i], on_screen(i, *sigma));
    else if (usable(row))
      html += "<span class=\"weak\">not observed</span>";
    html += html_change(row.last, i, "");
    if (row.has_reference_of_its_own) html += html_change(row.reference, i, "ref. ");
    html += "</td>";
  }
  return html + cell(row.last.since, true) + cell(row.reference.since, true) + cell(english(row.message), true) +
         "</tr>\n";
}

}  // namespace

std::string fleet_counts(const std::vector<FleetRow>& rows) {
  const auto count = [&](auto&& is) { return static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), is)); };
  const std::size_t solved = count([](const FleetRow& row) { return row.state == JobState::Done && usable(row); });
  const std::size_t unusable = count([](const FleetRow& row) { return row.state == JobState::Done && !usable(row); });
  std::string text =
      std::to_string(rows.size()) + (rows.size() == 1 ? " job: " : " jobs: ") + std::to_string(solved) + " solved";
  if (unusable > 0) text += ", " + std::to_string(unusable) + " without a usable result";
  for (const JobState state : {JobState::Failed, JobState::Waiting, JobState::OutOfDate})
    if (const std::size_t those = count([&](const FleetRow& row) { return row.state == state; }); those > 0)
      text += ", " + std::to_string(those) + " " + std::string(to_string(state));
  const std::size_t drifting = count([](const FleetRow& row) { return !row.drift().empty(); });
  return text + (drifting > 0 ? "; drift in " + std::to_string(drifting) : "; no drift");
}

std::string fleet_text(const Fleet& fleet, const std::vector<FleetRow>& rows) {
  std::string text;
  for (const FleetRow& row : rows) text += text_line(fleet, row);
  return text + fleet_counts(rows) + "\n";
}

std::string fleet_csv(const Fleet& fleet, const std::vector<FleetRow>& rows) {
  std::string csv(kFleetCsvMark);
  csv.pop_back();
  csv += csv_columns("") + ",compared_with" + csv_columns("change_") +
         ",drift,drift_in_words,message,result,reference" + csv_columns("since_reference_") +
         ",reference_drift,reference_drift_in_words\n";
  for (const FleetRow& row : rows) csv += csv_line(fleet, row);
  return csv;
}

std::string fleet_html(const Fleet& fleet, const std::vector<FleetRow>& rows, const std::string& created) {
  const std::string title = "Calibrations of " + fleet.path.filename().string();
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + html_escaped(title) +
                     "</title><style>" + kCss + "</style></head><body>\n<h1>" + html_escaped(title) +
                     "</h1>\n<p class=\"weak\">" + html_escaped(created) + "</p>\n<p><b>" +
                     html_escaped(fleet_counts(rows)) + ".</b></p>\n<ul>";
  for (const FleetRow& row : rows)
    if (const std::string drift = row.drift(); !drift.empty())
      html += "<li class=\"drift\">" + html_escaped(title_of(fleet, fleet.jobs[row.job]) + ": " + drift) + "</li>";
  html +=
      "</ul>\n<p class=\"weak\">ins_from_lidar ± 1 sigma; below it the change since the vehicle's calibration "
      "before, and since its reference where that is another one, each ± the sigma of both. Drift: a change of more "
      "than " +
      format("%g times the sigma of both together, and of more than %g m or %g deg", fleet.drift.sigmas,
             fleet.drift.translation_m, fleet.drift.rotation_deg) +
      ".</p>\n<table>\n<tr><th>job</th><th class=\"text\">vehicle</th><th class=\"text\">sessions</th>"
      "<th class=\"text\">status</th>";
  for (std::size_t i = 0; i < kParameterNames.size(); ++i)
    html += "<th>" + std::string(kParameterNames[i]) + " [" + unit_of(i) + "]</th>";
  html +=
      "<th class=\"text\">compared with</th><th class=\"text\">reference</th><th class=\"text\">message</th></tr>\n";
  for (const FleetRow& row : rows) html += html_row(fleet, row);
  return html + "</table></body></html>\n";
}

}  // namespace remount
