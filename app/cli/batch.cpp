#include <algorithm>
#include <filesystem>
#include <memory>
#include <thread>

#include "algorithms/core/error.h"
#include "app/cli/batch_job.h"
#include "app/cli/batch_run.h"
#include "app/cli/verbs.h"
#include "messages/command_help.h"
#include "messages/command_line.h"
#include "model/fleet/fleet_table.h"
#include "model/formats/files/atomic_save.h"
#include "model/formats/files/current_time.h"
#include "model/formats/files/output_file.h"
#include "model/overview/session_report.h"

namespace remount::cli {
namespace {

struct BatchArguments {
  std::string fleet, csv, html;
  std::size_t job = 0;      ///< from 1; 0: all
  std::size_t at_once = 0;  ///< 0: one per core
  bool table = false, count = false;
};

/// Tables are made to be replaced; a recording that was named by a slip of the hand is not.
void write_table(const fleet::Fleet& fleet, const std::vector<fleet::FleetRow>& rows, const BatchArguments& arguments,
                 Console& console) {
  formats::make_directories(fleet.results);
  const std::filesystem::path csv =
      arguments.csv.empty() ? fleet.results / "fleet.csv" : std::filesystem::path(arguments.csv);
  const std::filesystem::path html =
      arguments.html.empty() ? fleet.results / "fleet.html" : std::filesystem::path(arguments.html);
  formats::check_replaces_its_like(csv, fleet::kFleetCsvMark);
  formats::check_replaces_its_like(html, "<!DOCTYPE html>");
  formats::save_atomically(csv, fleet::fleet_csv(fleet, rows));
  formats::save_atomically(html, fleet::fleet_html(fleet, rows, formats::now_in_utc(), console.options().language));
  console.print(say::batch_table(csv.string(), html.string()));
}

/// Prints and writes the table. Says aloud which mountings have drifted; true where any has.
bool collect(const fleet::Fleet& fleet, const BatchArguments& arguments, Console& console,
             const std::vector<fleet::FleetRow>& rows) {
  console.print_text(fleet::fleet_text(fleet, rows, console.options().language));
  write_table(fleet, rows, arguments, console);
  const std::vector<fleet::FleetAlarm> alarms = fleet::fleet_alarms(fleet, rows);
  for (const fleet::FleetAlarm& alarm : alarms) console.complain(say::batch_alarm(alarm.title, alarm.words));
  return !alarms.empty();
}

int show_table(const fleet::Fleet& fleet, const BatchArguments& arguments, Console& console) {
  const std::vector<fleet::FleetRow> rows =
      fleet::fleet_rows(fleet, [&](const fleet::FleetJob& job, const results::VehicleFile& stored) {
        return why_out_of_date(fleet, job, stored, console);
      });
  if (console.cancelled()) return kNoResult;
  // An alarm must not be lost in a vehicle whose recording is missing.
  if (collect(fleet, arguments, console, rows)) return kNoResult;
  if (std::any_of(rows.begin(), rows.end(),
                  [](const fleet::FleetRow& row) { return row.state == fleet::JobState::Failed; }))
    return kUnreadable;
  const bool all_solved = std::all_of(rows.begin(), rows.end(), [](const fleet::FleetRow& row) {
    return row.state == fleet::JobState::Done && calibration::is_usable(*row.result);
  });
  return all_solved ? kSolved : kNoResult;
}

int run_all(const fleet::Fleet& fleet, const BatchArguments& arguments, Console& console) {
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t at_once = std::min(arguments.at_once > 0 ? arguments.at_once : cores, fleet.jobs.size());
  const int threads = console.options().threads > 0 ? console.options().threads
                                                    : static_cast<int>(std::max<std::size_t>(1, cores / at_once));
  formats::make_directories(fleet.results);
  const BatchEnd end = run_jobs(fleet, at_once, threads, console);
  if (end.cancelled) {
    console.complain(say::batch_stopped());
    return kNoResult;
  }
  // Each job has looked at its own files just now.
  if (collect(fleet, arguments, console, fleet::fleet_rows(fleet))) return kNoResult;
  if (end.unreadable > 0) return kUnreadable;
  return end.no_result > 0 ? kNoResult : kSolved;
}

int batch(const BatchArguments& arguments, Console& console) {
  const fleet::Fleet fleet = fleet::load_fleet(arguments.fleet);
  if (arguments.count) {
    console.print_text(std::to_string(fleet.jobs.size()));
    return kSolved;
  }
  if (arguments.job > fleet.jobs.size())
    throw Error(ErrorCode::Contract, "--job " + std::to_string(arguments.job),
                say::cli_no_such_job(fleet.jobs.size(), arguments.fleet));
  if (arguments.job > 0) return run_job(fleet, fleet.jobs[arguments.job - 1], console);
  return arguments.table ? show_table(fleet, arguments, console) : run_all(fleet, arguments, console);
}

}  // namespace

void add_batch(CLI::App& app, Console& console, Run& run) {
  const auto arguments = std::make_shared<BatchArguments>();
  CLI::App* verb = app.add_subcommand("batch", console.words(say::help_batch()));
  verb->add_option("fleet", arguments->fleet, console.words(say::help_fleet()))->type_name("FLEET")->required();
  CLI::Option* jobs = verb->add_option("--jobs", arguments->at_once, console.words(say::help_jobs()))
                          ->check(CLI::Range(0, 1024).description(""))
                          ->type_name("N");
  CLI::Option* job = verb->add_option("--job", arguments->job, console.words(say::help_job()))
                         ->check(CLI::Range(1, 100000).description(""))
                         ->type_name("K");
  CLI::Option* table = verb->add_flag("--table", arguments->table, console.words(say::help_table()));
  CLI::Option* count = verb->add_flag("--count", arguments->count, console.words(say::help_count()));
  verb->add_option("--csv", arguments->csv, console.words(say::help_csv()))->type_name("FILE")->excludes(job);
  verb->add_option("--html", arguments->html, console.words(say::help_html()))->type_name("FILE")->excludes(job);
  job->excludes(jobs)->excludes(table)->excludes(count);
  table->excludes(jobs)->excludes(count);
  count->excludes(jobs);
  verb->footer(console.words(say::help_batch_exit_codes()));
  verb->callback([arguments, &console, &run] { run = [arguments, &console] { return batch(*arguments, console); }; });
}

}  // namespace remount::cli
