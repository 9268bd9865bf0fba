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

namespace remount {
namespace {

constexpr std::size_t kColumn = 22;

std::string value_of(const CalibrationResult& result, Parameter i, const Console& console) {
  const auto sigma = result.estimate(i).sigma;
  if (!is_usable(result) || !sigma) return padded(console.words(say::report_not_observed()), kColumn);
  char text[64];
  const double shown = on_screen(i, *sigma);
  const int decimals = justified_decimals(shown);
  std::snprintf(text, sizeof(text), "%.*f +- %.*f", decimals, six_on_screen(result.mounting.reference_from_sensor)[i],
                decimals, shown);
  return padded(text, kColumn);
}

std::string table(const std::vector<NamedResult>& results, const Console& console) {
  std::string text = padded("", kColumn);
  for (const NamedResult& result : results) text += padded(result.name, kColumn);
  text += "\n";
  for (const Parameter i : kParameters) {
    text += padded(std::string(to_string(i)) + (is_angle(i) ? " [deg]" : " [m]"), kColumn);
    for (const NamedResult& result : results) text += value_of(result.file.result, i, console);
    text += "\n";
  }
  return text;
}

/// By the names of their files, or by their paths where two files have the same name.
std::vector<NamedResult> load_all(const std::vector<std::string>& paths) {
  std::vector<NamedResult> results;
  std::set<std::string> stems;
  for (const std::string& path : paths) stems.insert(std::filesystem::path(path).stem().string());
  for (const std::string& path : paths)
    results.push_back(
        {stems.size() == paths.size() ? std::filesystem::path(path).stem().string() : path, load_result(path)});
  return results;
}

int compare(const std::vector<std::string>& paths, Console& console) {
  const std::vector<NamedResult> results = load_all(paths);
  console.print_text(table(results, console));
  bool agree = true;
  for (const ComparedResults& pair : compare_results(results)) {
    const bool compared = largest_difference(pair.difference).has_value();
    if (pair.contradict || !compared)
      console.warn(pair.words);
    else
      console.print(pair.words);
    agree = agree && compared && !pair.contradict;
  }
  console.print(say::compare_limit(kDiffer_sigma));
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

}  // namespace remount
