#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>

#include "app/cli/columns.h"
#include "app/cli/verbs.h"
#include "messages/command_help.h"
#include "messages/command_line.h"
#include "messages/report.h"
#include "model/report/comparison.h"
#include "model/results/display_units.h"

namespace remount::cli {
namespace {

constexpr std::size_t kColumn = 22;

std::string value_of(const calibration::CalibrationResult& result, calibration::Parameter i, const Console& console) {
  const auto sigma = result.estimate(i).sigma;
  if (!calibration::is_usable(result) || !sigma) return padded(console.words(say::report_not_observed()), kColumn);
  char text[64];
  const double shown = results::on_screen(i, *sigma);
  const int decimals = results::justified_decimals(shown);
  std::snprintf(text, sizeof(text), "%.*f +- %.*f", decimals,
                results::six_on_screen(result.mounting.reference_from_sensor)[i], decimals, shown);
  return padded(text, kColumn);
}

std::string table(const std::vector<report::NamedResult>& results, const Console& console) {
  std::string text = padded("", kColumn);
  for (const report::NamedResult& result : results) text += padded(result.name, kColumn);
  text += "\n";
  for (const calibration::Parameter i : calibration::kParameters) {
    text += padded(std::string(to_string(i)) + (calibration::is_angle(i) ? " [deg]" : " [m]"), kColumn);
    for (const report::NamedResult& result : results) text += value_of(result.file.result, i, console);
    text += "\n";
  }
  return text;
}

/// By the names of their files, or by their paths where two files have the same name.
std::vector<report::NamedResult> load_all(const std::vector<std::string>& paths) {
  std::vector<report::NamedResult> results;
  std::set<std::string> stems;
  for (const std::string& path : paths) stems.insert(std::filesystem::path(path).stem().string());
  for (const std::string& path : paths)
    results.push_back({stems.size() == paths.size() ? std::filesystem::path(path).stem().string() : path,
                       results::load_result(path)});
  return results;
}

int compare(const std::vector<std::string>& paths, Console& console) {
  const std::vector<report::NamedResult> results = load_all(paths);
  console.print_text(table(results, console));
  bool agree = true, any = false;
  for (const report::ComparedResults& pair : report::compare_results(results)) {
    const bool compared = calibration::largest_difference(pair.difference).has_value();
    if (pair.contradict || !compared)
      console.warn(pair.words);
    else
      console.print(pair.words);
    agree = agree && compared && !pair.contradict;
    any = any || compared;
  }
  if (any) console.print(say::compare_limit(calibration::kDiffer_sigma));
  return agree ? kSolved : kNoResult;
}

}  // namespace

void add_compare(CLI::App& app, Console& console, Run& run) {
  const auto results = std::make_shared<std::vector<std::string>>();
  CLI::App* verb = app.add_subcommand("compare", console.words(say::help_compare()));
  verb->add_option("results", *results, console.words(say::help_results()))
      ->type_name("RESULT")
      ->required()
      ->expected(2, 100);
  verb->callback([results, &console, &run] { run = [results, &console] { return compare(*results, console); }; });
}

}  // namespace remount::cli
