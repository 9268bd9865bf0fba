#include "model/fleet/fleet_table.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "algorithms/messages/render.h"
#include "messages/fleet.h"
#include "model/formats/documents/document.h"
#include "model/formats/files/number_text.h"
#include "model/formats/files/printable_text.h"
#include "model/report/drawing.h"
#include "model/results/display_units.h"
#include "model/results/result_words.h"

namespace remount::fleet {
namespace {

constexpr const char* kCss =
    "body{font-family:'Noto Sans',sans-serif;color:#222;margin:24px}h1{font-size:22px}"
    "table{border-collapse:collapse;font-size:12px}td,th{padding:2px 8px;border:1px solid #d5d8dd;text-align:right}"
    "th{background:#f0f2f5}td.text,th.text{text-align:left}.weak{color:#777}tr.drift{background:#ffe3d6}"
    "tr.failed{background:#f3e6e6}tr.problem{background:#fff3cf}li.drift{color:#9a2a00}";

const char* unit_of(calibration::Parameter parameter) { return calibration::is_angle(parameter) ? "deg" : "m"; }

bool usable(const FleetRow& row) { return row.result && calibration::is_usable(*row.result); }

std::string status_of(const FleetRow& row) { return row.result ? std::string(to_string(row.result->status)) : ""; }

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// How it went, or how far it is.
Message state_of(const FleetRow& row) {
  return row.state == JobState::Done ? results::status_word(row.result->status) : state_word(row.state);
}

Message value_of(const FleetRow& row, calibration::Parameter i) {
  const auto sigma = row.result->estimate(i).sigma;
  if (!sigma) return say::fleet_value_not_observed(calibration::parameter_word(i));
  const double value = results::six_on_screen(row.result->mounting.reference_from_sensor)[i];
  return calibration::is_angle(i) ? say::fleet_value_of_angle(calibration::parameter_word(i), value, Angle{*sigma})
                                  : say::fleet_value_of_length(calibration::parameter_word(i), value, Length{*sigma});
}

Message words_of_problem(const drive::Finding& problem) {
  return say::fleet_problem(problem.where.words(), problem.explanation, problem.code);
}

/// The problems that the row's message does not tell already.
std::vector<Message> untold_problems(const FleetRow& row) {
  std::vector<Message> problems;
  for (const drive::Finding& problem : row.warnings.problems)
    if (problem.explanation != row.message) problems.push_back(words_of_problem(problem));
  return problems;
}

/// The lines below the first one of a row.
std::vector<Message> lines_below(const FleetRow& row) {
  std::vector<Message> values;
  for (const calibration::Parameter i : calibration::kParameters) values.push_back(value_of(row, i));
  std::vector<Message> lines{say::fleet_values(std::move(values)), row.last.words};
  if (row.has_reference_of_its_own && !row.reference.words.empty())
    lines.push_back(say::fleet_by_reference(row.reference.words));
  if (Message drift = row.drift(); !drift.empty()) lines.push_back(say::fleet_alarm(std::move(drift)));
  for (Message& problem : untold_problems(row)) lines.push_back(std::move(problem));
  return lines;
}

std::string text_line(const Fleet& fleet, const FleetRow& row, Language language) {
  Message line = say::fleet_line(row.job + 1, title_of(fleet, row), state_of(row));
  if (const std::string message = first_line(render(row.message, language)); !message.empty())
    line = say::fleet_line_says(std::move(line), Message::verbatim(message));
  if (row.warnings.count > 0) line = say::fleet_line_says(std::move(line), say::fleet_warnings(row.warnings.count));
  std::string text = render(line, language) + "\n";
  if (!usable(row)) return text;
  for (const Message& below : lines_below(row))
    if (!below.empty()) text += "    " + render(below, language) + "\n";
  return text;
}

std::string csv_cell(const std::string& cell) {
  const std::string text = formats::printable(cell);
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string csv_number(double value) { return std::isfinite(value) ? formats::shortest(value) : ""; }

/// One line; what holds commas or quotes is quoted.
std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) line += ',';
    line += csv_cell(cells[i]);
  }
  return line + "\n";
}

std::string yes_or_no(bool yes) { return yes ? "yes" : "no"; }

/// With what, by how much, and whether that is drift; empty where nothing was compared.
void add_change(const FleetChange& change, std::vector<std::string>& cells) {
  cells.push_back(change.since);
  for (const calibration::Parameter i : calibration::kParameters) {
    cells.push_back(csv_number(results::on_screen(i, change.change.difference[i])));
    cells.push_back(csv_number(results::on_screen(i, change.change.sigma[i])));
  }
  const bool compared =
      std::any_of(calibration::kParameters.begin(), calibration::kParameters.end(),
                  [&](calibration::Parameter parameter) { return std::isfinite(change.change.difference[parameter]); });
  cells.push_back(!change.drift.empty() ? "yes" : compared ? "no" : "");
  cells.push_back(english(change.drift));
}

std::string csv_columns(const std::string& prefix) {
  std::string columns;
  for (const calibration::Parameter i : calibration::kParameters) {
    const std::string name = prefix + std::string(to_string(i));
    columns += "," + name + "_" + unit_of(i) + "," + name + "_sigma_" + unit_of(i);
  }
  return columns;
}

std::string csv_line(const Fleet& fleet, const FleetRow& row) {
  const FleetJob& job = fleet.jobs[row.job];
  std::vector<std::string> cells{fleet.vehicles[job.vehicle].name, std::to_string(row.job + 1), job.name,
                                 std::string(to_string(row.state)), status_of(row)};
  const calibration::PerParameter<double> values =
      usable(row) ? results::six_on_screen(row.result->mounting.reference_from_sensor)
                  : calibration::PerParameter<double>{};
  for (const calibration::Parameter i : calibration::kParameters) {
    const auto sigma = usable(row) ? row.result->estimate(i).sigma : std::nullopt;
    // What is not observed has no value either: a number without a sigma would be taken for one.
    cells.push_back(sigma ? csv_number(values[i]) : "");
    cells.push_back(sigma ? csv_number(results::on_screen(i, *sigma)) : "");
  }
  add_change(row.last, cells);
  cells.push_back(english(row.message));
  cells.push_back(row.result ? job.result.string() : "");  // a file that is there and belongs to the job
  add_change(row.reference, cells);
  cells.push_back(row.lidar);
  cells.push_back(row.joined ? yes_or_no(*row.joined) : "");
  for (const FleetChange* change : {&row.last, &row.reference})
    cells.push_back(row.lidar.empty() || change->since.empty() ? "" : yes_or_no(!change->together.empty()));
  cells.push_back(row.result ? std::to_string(row.warnings.count) : "");
  std::string problems;
  for (const drive::Finding& problem : row.warnings.problems)
    problems += (problems.empty() ? "" : "; ") + english(words_of_problem(problem));
  cells.push_back(problems);
  return csv_line(cells);
}

std::string cell(const std::string& text, bool is_text = false) {
  return (is_text ? "<td class=\"text\">" : "<td>") + formats::escape_html(text) + "</td>";
}

std::string head(const Message& words, Language language, bool is_text = false) {
  return (is_text ? "<th class=\"text\">" : "<th>") + formats::escape_html(render(words, language)) + "</th>";
}

/// "+0.0240 ± 0.0014 (17.0 σ)"; empty where nothing was compared.
std::string change_text(const FleetChange& change, calibration::Parameter i) {
  const double by = change.change.difference[i];
  if (!std::isfinite(by)) return {};
  const double sigma = change.change.sigma[i];
  return formats::signed_text(results::on_screen(i, by), 4) + " ± " +
         formats::spread_text(results::on_screen(i, sigma), 4) +
         formats::format_numbers(" (%.1f σ)", std::abs(by) / sigma);
}

std::string weak_line(const std::string& text) {
  return text.empty() ? std::string() : "<br><span class=\"weak\">" + formats::escape_html(text) + "</span>";
}

std::string html_value(const FleetRow& row, calibration::Parameter i, Language language) {
  const auto sigma = usable(row) ? row.result->estimate(i).sigma : std::nullopt;
  std::string html = "<td>";
  if (sigma)
    html += formats::rounded_text(results::six_on_screen(row.result->mounting.reference_from_sensor)[i], 4) + " ± " +
            formats::spread_text(results::on_screen(i, *sigma), 4);
  else if (usable(row))
    html +=
        "<span class=\"weak\">" + formats::escape_html(render(say::fleet_cell_not_observed(), language)) + "</span>";
  html += weak_line(change_text(row.last, i));
  if (const std::string change = change_text(row.reference, i); row.has_reference_of_its_own && !change.empty())
    html += weak_line(render(say::fleet_cell_reference(change), language));
  return html + "</td>";
}

/// Fleets of vehicles with one LiDAR need no column for it.
bool names_lidars(const std::vector<FleetRow>& rows) {
  return std::ranges::any_of(rows, [](const FleetRow& row) { return !row.lidar.empty(); });
}

/// The row's message, and below it what the result warns of.
std::string html_message(const FleetRow& row, Language language) {
  std::string html = formats::escape_html(render(row.message, language));
  if (row.warnings.count == 0) return html;
  html +=
      (html.empty() ? "" : "<br>") + formats::escape_html(render(say::fleet_warnings(row.warnings.count), language));
  for (const Message& problem : untold_problems(row)) html += "<br>" + formats::escape_html(render(problem, language));
  return html;
}

std::string html_row(const Fleet& fleet, const FleetRow& row, bool with_lidar, Language language) {
  const FleetJob& job = fleet.jobs[row.job];
  const bool failed = row.state == JobState::Failed || (row.result && !calibration::is_usable(*row.result));
  std::string html = !row.drift().empty()             ? "<tr class=\"drift\">"
                     : failed                         ? "<tr class=\"failed\">"
                     : !row.warnings.problems.empty() ? "<tr class=\"problem\">"
                                                      : "<tr>";
  html += cell(std::to_string(row.job + 1)) + cell(fleet.vehicles[job.vehicle].name, true) + cell(job.name, true) +
          (with_lidar ? cell(row.lidar, true) : "") + cell(render(state_of(row), language), true);
  for (const calibration::Parameter i : calibration::kParameters) html += html_value(row, i, language);
  return html + cell(row.last.since, true) + cell(row.reference.since, true) + "<td class=\"text\">" +
         html_message(row, language) + "</td></tr>\n";
}

std::string html_heads(bool with_lidar, Language language) {
  std::string html = "<tr>" + head(say::fleet_head_job(), language);
  std::vector<Message (*)()> texts{say::fleet_head_vehicle, say::fleet_head_sessions, say::fleet_head_status};
  if (with_lidar) texts.insert(texts.end() - 1, say::fleet_head_lidar);
  for (Message (*words)() : texts) html += head(words(), language, true);
  for (const calibration::Parameter i : calibration::kParameters)
    html += head(say::fleet_head_parameter(calibration::parameter_word(i), unit_of(i)), language);
  for (Message (*words)() : {say::fleet_head_compared, say::fleet_head_reference, say::fleet_head_message})
    html += head(words(), language, true);
  return html + "</tr>\n";
}

}  // namespace

Message fleet_counts(const std::vector<FleetRow>& rows) {
  using Job = std::span<const FleetRow>;
  const std::vector<Job> jobs = rows_of_jobs(rows);
  const auto count = [&](auto&& is) { return static_cast<std::size_t>(std::ranges::count_if(jobs, is)); };
  const auto is_in = [](const Job& job, JobState state) { return job.front().state == state; };
  const auto is_usable = [](const Job& job) { return std::ranges::all_of(job, usable); };
  const std::size_t unusable = count([&](const Job& job) { return is_in(job, JobState::Done) && !is_usable(job); });
  std::vector<Message> counts{
      say::fleet_count_solved(count([&](const Job& job) { return is_in(job, JobState::Done) && is_usable(job); }))};
  if (unusable > 0) counts.push_back(say::fleet_count_not_usable(unusable));
  for (const JobState state : {JobState::Failed, JobState::Waiting, JobState::OutOfDate})
    if (const std::size_t those = count([&](const Job& job) { return is_in(job, state); }); those > 0)
      counts.push_back(say::fleet_count_of_state(those, state_word(state)));
  const std::size_t with_problems = count([](const Job& job) {
    return std::ranges::any_of(job, [](const FleetRow& row) { return !row.warnings.problems.empty(); });
  });
  if (with_problems > 0) counts.push_back(say::fleet_count_with_problems(with_problems));
  const std::size_t drifting = count([](const Job& job) {
    return std::ranges::any_of(job, [](const FleetRow& row) { return !row.drift().empty(); });
  });
  return say::fleet_counts(jobs.size(), std::move(counts),
                           drifting > 0 ? say::fleet_drift_in(drifting) : say::fleet_no_drift());
}

std::string fleet_text(const Fleet& fleet, const std::vector<FleetRow>& rows, Language language) {
  std::string text;
  for (const std::span<const FleetRow> job : rows_of_jobs(rows)) {
    for (const FleetRow& row : job) text += text_line(fleet, row, language);
    for (const Message& words : together_of(job)) text += "    " + render(words, language) + "\n";
  }
  return text + render(fleet_counts(rows), language) + "\n";
}

std::string fleet_csv(const Fleet& fleet, const std::vector<FleetRow>& rows) {
  std::string csv(kFleetCsvMark);
  csv.pop_back();
  csv += csv_columns("") + ",compared_with" + csv_columns("change_") +
         ",drift,drift_in_words,message,result,reference" + csv_columns("since_reference_") +
         ",reference_drift,reference_drift_in_words,lidar,joined,ins_moved,reference_ins_moved,warnings,problems\n";
  for (const FleetRow& row : rows) csv += csv_line(fleet, row);
  return csv;
}

std::string fleet_html(const Fleet& fleet, const std::vector<FleetRow>& rows, const std::string& created,
                       Language language) {
  const auto in_html = [language](const Message& message) { return formats::escape_html(render(message, language)); };
  const std::string title = in_html(say::fleet_title(fleet.path.filename().string()));
  const bool with_lidar = names_lidars(rows);
  const std::string tag = language == Language::Chinese ? "zh-CN" : "en";
  std::string html = "<!DOCTYPE html>\n<html lang=\"" + tag + "\"><head><meta charset=\"utf-8\"><title>" + title +
                     "</title><style>" + kCss + "</style></head><body>\n<h1>" + title + "</h1>\n<p class=\"weak\">" +
                     formats::escape_html(created) + "</p>\n<p><b>" +
                     in_html(say::fleet_counts_sentence(fleet_counts(rows))) + "</b></p>\n<ul>";
  for (FleetAlarm& alarm : fleet_alarms(fleet, rows))
    html += "<li class=\"drift\">" + in_html(say::fleet_alarm_of_job(alarm.title, std::move(alarm.words))) + "</li>";
  html += "</ul>\n<p class=\"weak\">" +
          in_html(say::fleet_legend(fleet.drift.sigmas, Length{fleet.drift.translation_m},
                                    Angle{degrees_to_radians(fleet.drift.rotation_deg)})) +
          "</p>\n<table>\n" + html_heads(with_lidar, language);
  for (const FleetRow& row : rows) html += html_row(fleet, row, with_lidar, language);
  return html + "</table></body></html>\n";
}

}  // namespace remount::fleet
