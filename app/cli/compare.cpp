#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>

#include "algorithms/core/error.h"
#include "app/cli/columns.h"
#include "app/cli/verbs.h"
#include "messages/command_help.h"
#include "messages/command_line.h"
#include "messages/report.h"
#include "messages/rig.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/number_text.h"
#include "model/report/vehicle_comparison.h"
#include "model/results/display_units.h"

namespace remount::cli {
namespace {

constexpr std::size_t kColumn = 22;

std::string value_of(const calibration::CalibrationResult& result, calibration::Parameter i, const Console& console) {
  const auto sigma = result.estimate(i).sigma;
  if (!calibration::is_usable(result) || !sigma) return padded(console.words(say::report_not_observed()), kColumn);
  const double shown = results::on_screen(i, *sigma);
  const int decimals = results::justified_decimals(shown);
  return padded(formats::rounded_text(results::six_on_screen(result.mounting.reference_from_sensor)[i], decimals) +
                    " +- " + formats::spread_text(shown, decimals),
                kColumn);
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

struct CompareArguments {
  std::vector<std::string> results;
  std::string lidar;
};

/// By the names of their files, or by their paths where two files have the same name.
std::vector<std::string> names_of(const std::vector<std::string>& paths) {
  std::vector<std::string> names;
  for (const std::string& path : paths) names.push_back(std::filesystem::path(path).stem().string());
  return std::set<std::string>(names.begin(), names.end()).size() == paths.size() ? names : paths;
}

/// The named one of several, or one whose topic has the name as a part. Throws Error(Contract).
results::LidarResult load_lidar(const std::string& path, const std::string& name) {
  return results::lidar_of(results::load_vehicle(path), name, path);
}

/// @param lidars names of those that are one of several, or else nothing
std::vector<report::NamedResult> load_all(const CompareArguments& arguments, std::vector<std::string>& lidars) {
  const std::vector<std::string> names = names_of(arguments.results);
  std::vector<report::NamedResult> results;
  lidars.resize(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string& path = arguments.results[i];
    if (arguments.lidar.empty() || !results::is_vehicle_file(path)) {
      results.push_back({names[i], results::load_result(path)});
      continue;
    }
    const results::LidarResult lidar = load_lidar(path, arguments.lidar);
    results.push_back({names[i], lidar.file});
    lidars[i] = lidar.name;
  }
  return results;
}

int compare_one(const CompareArguments& arguments, Console& console) {
  std::vector<std::string> lidars;
  std::vector<report::NamedResult> results = load_all(arguments, lidars);
  console.print_text(table(results, console));
  for (std::size_t i = 0; i < results.size(); ++i)
    if (!lidars[i].empty()) results[i].name += " " + lidars[i];
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

/// "+0.0123 (1.4)": with as many digits as its sigma justifies.
std::string difference_text(const calibration::ResultDifference& two, calibration::Parameter i,
                            const Console& console) {
  const double apart = results::on_screen(i, two.difference[i]), sigma = results::on_screen(i, two.sigma[i]);
  if (!std::isfinite(apart)) return console.words(say::report_not_observed());
  return formats::signed_text(apart, results::justified_decimals(sigma)) +
         formats::format_numbers(" (%.1f)", std::abs(apart) / sigma);
}

/// A row a LiDAR.
std::string table(const report::ComparedVehicles& two, const Console& console) {
  constexpr std::size_t kValue = 18;
  std::size_t name_columns = 16;
  for (const report::ComparedLidar& lidar : two.lidars)
    name_columns = std::max(name_columns, columns_of(lidar.name) + 1);
  std::string text = padded("", name_columns);
  for (const calibration::Parameter i : calibration::kParameters)
    text += padded(std::string(to_string(i)) + (calibration::is_angle(i) ? " [deg]" : " [m]"), kValue);
  text += "\n";
  for (const report::ComparedLidar& lidar : two.lidars) {
    text += padded(lidar.name + " ", name_columns);
    for (const calibration::Parameter i : calibration::kParameters)
      text += padded(difference_text(lidar.results.difference, i, console) + " ", kValue);
    text += "\n";
  }
  return text;
}

/// What the second has changed of the first. False where they contradict each other, or cannot be compared.
bool compare_two(const report::NamedVehicle& before, const report::NamedVehicle& after, Console& console) {
  const report::ComparedVehicles two = report::compare_vehicles(after, before);
  for (const Message& note : two.notes) console.print(say::cli_note(note));
  if (!two.lidars.empty()) {
    console.print(say::compared_two_vehicles(after.name, before.name));
    console.print_text(table(two, console));
  }
  for (const report::ComparedLidar& lidar : two.lidars)
    if (!lidar.compared || (lidar.results.contradict && !two.moved_with_ins(lidar)))
      console.warn(lidar.results.words);
    else
      console.print(lidar.results.words);
  for (const Message& words : two.words) console.warn(words);
  return two.agree();
}

int compare_vehicle_files(const std::vector<std::string>& paths, Console& console) {
  const std::vector<std::string> names = names_of(paths);
  std::vector<report::NamedVehicle> vehicles;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (!results::is_vehicle_file(paths[i]))
      throw Error(ErrorCode::Contract, paths[i], say::cli_compared_vehicle_with_one());
    vehicles.push_back({names[i], results::load_vehicle(paths[i])});
  }
  bool agree = true;
  for (std::size_t a = 0; a < vehicles.size(); ++a)
    for (std::size_t b = a + 1; b < vehicles.size(); ++b)
      if (!compare_two(vehicles[a], vehicles[b], console)) agree = false;
  console.print(say::compare_limit(calibration::kDiffer_sigma));
  return agree ? kSolved : kNoResult;
}

int compare(const CompareArguments& arguments, Console& console) {
  // A file that is missing would be called the result of one.
  for (const std::string& path : arguments.results) (void)formats::read_file_head(path, 1);
  const bool any_vehicle =
      std::ranges::any_of(arguments.results, [](const std::string& path) { return results::is_vehicle_file(path); });
  if (!any_vehicle && !arguments.lidar.empty()) throw Error(ErrorCode::Contract, "--lidar", say::export_of_vehicle());
  return any_vehicle && arguments.lidar.empty() ? compare_vehicle_files(arguments.results, console)
                                                : compare_one(arguments, console);
}

}  // namespace

void add_compare(CLI::App& app, Console& console, Run& run) {
  const auto arguments = std::make_shared<CompareArguments>();
  CLI::App* verb = app.add_subcommand("compare", console.words(say::help_compare()));
  verb->add_option("results", arguments->results, console.words(say::help_results()))
      ->type_name("RESULT")
      ->required()
      ->expected(-2);
  verb->add_option("--lidar", arguments->lidar, console.words(say::help_compare_lidar()))->type_name("NAME");
  verb->callback([arguments, &console, &run] { run = [arguments, &console] { return compare(*arguments, console); }; });
}

}  // namespace remount::cli
