#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <string_view>

#include "algorithms/messages/render.h"
#include "app/cli/verbs.h"
#include "model/display_units.h"
#include "model/report/comparison.h"

namespace remount {
namespace {

constexpr std::size_t kColumn = 22;

std::string padded(std::string_view text) {
  std::string cell(text);
  cell.resize(std::max(cell.size(), kColumn), ' ');
  return cell;
}

std::string value_of(const CalibrationResult& result, std::size_t i) {
  const auto sigma = result.sigma(i);
  if (!is_usable(result) || !sigma) return padded("not observed");
  char text[64];
  const double shown = on_screen(i, *sigma);
  const int decimals = justified_decimals(shown);
  std::snprintf(text, sizeof(text), "%.*f +- %.*f", decimals, six_on_screen(result.ins_from_lidar)[i], decimals, shown);
  return padded(text);
}

std::string table(const std::vector<NamedResult>& results) {
  std::string text = padded("");
  for (const NamedResult& result : results) text += padded(result.name);
  text += "\n";
  for (std::size_t i = 0; i < kParameterNames.size(); ++i) {
    text += padded(std::string(kParameterNames[i]) + (is_angle(i) ? " [deg]" : " [m]"));
    for (const NamedResult& result : results) text += value_of(result.file.result, i);
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
  console.print(table(results));
  bool agree = true;
  for (const ComparedResults& pair : compare_results(results)) {
    const bool compared = largest_difference(pair.difference).has_value();
    if (pair.contradict || !compared)
      console.complain("warning: " + english(pair.words));
    else
      console.print(english(pair.words));
    agree = agree && compared && !pair.contradict;
  }
  char limit[128];
  std::snprintf(
      limit, sizeof(limit),
      "(to contradict each other, they would have to differ by more than %.1f times the sigma of both together)",
      kDiffer_sigma);
  console.print(limit);
  return agree ? kSolved : kNoResult;
}

}  // namespace

void add_compare(CLI::App& app, Console& console, Run& run) {
  const auto results = std::make_shared<std::vector<std::string>>();
  CLI::App* verb =
      app.add_subcommand("compare",
                         "Set results of one vehicle side by side; ends with 3 where two differ by more than 3.5 "
                         "sigma of both together, or cannot be compared");
  verb->add_option("results", *results, "Result files (.yaml or .json)")
      ->type_name("RESULT")
      ->required()
      ->expected(2, 100);
  verb->callback([results, &console, &run] { run = [results, &console] { return compare(*results, console); }; });
}

}  // namespace remount
