#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/cli/verbs.h"
#include "model/display_units.h"
#include "model/report/comparison.h"

namespace remount {
namespace {

constexpr int kColumn = 22;

std::string padded(std::string text) {
  if (text.size() < kColumn) text.append(kColumn - text.size(), ' ');
  return text;
}

std::string value_of(const CalibrationResult& result, std::size_t i) {
  const auto sigma = result.sigma(i);
  if (!is_usable(result) || !sigma) return padded("not observed");
  char text[64];
  std::snprintf(text, sizeof(text), "%.4f +- %.4f", six_on_screen(result.ins_from_lidar)[i], on_screen(i, *sigma));
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

std::vector<NamedResult> load_all(const std::vector<std::string>& paths) {
  std::vector<NamedResult> results;
  for (const std::string& path : paths)
    results.push_back({std::filesystem::path(path).stem().string(), load_result(path)});
  return results;
}

int compare(const std::vector<std::string>& paths, Console& console) {
  const std::vector<NamedResult> results = load_all(paths);
  console.print(table(results));
  bool contradict = false;
  for (const ComparedResults& pair : compare_results(results)) {
    if (pair.contradict)
      console.complain("warning: " + pair.words);
    else
      console.print(pair.words);
    contradict |= pair.contradict;
  }
  return contradict ? kNoResult : kSolved;
}

}  // namespace

void add_compare(CLI::App& app, Console& console, Run& run) {
  const auto results = std::make_shared<std::vector<std::string>>();
  CLI::App* verb = app.add_subcommand(
      "compare", "Set results of one vehicle side by side; ends with 3 where they differ by more than they claim");
  verb->add_option("results", *results, "Result files (.yaml or .json)")
      ->type_name("RESULT")
      ->required()
      ->expected(2, 100);
  verb->callback([results, &console, &run] { run = [results, &console] { return compare(*results, console); }; });
}

}  // namespace remount
