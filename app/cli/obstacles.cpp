#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

#include "algorithms/core/error.h"
#include "app/cli/arguments.h"
#include "app/cli/columns.h"
#include "app/cli/lidar_choice.h"
#include "app/cli/named_nominals.h"
#include "app/cli/option_adder.h"
#include "app/cli/verbs.h"
#include "messages/command_help.h"
#include "messages/command_line.h"
#include "messages/rig.h"
#include "model/pipeline/mended_scans.h"
#include "model/report/obstacle_report.h"
#include "model/results/beam_file.h"
#include "model/results/exporters/exporter.h"
#include "model/results/result_file.h"

namespace remount::cli {
namespace {

struct ObstacleArguments {
  std::string session, result, nominal, lidar;
  std::int64_t scan = 0;
  quality::ObstacleOptions options;
  TopicArguments topics;
};

std::string metres(double distance_m) {
  if (!std::isfinite(distance_m)) return "         -";
  char text[32];
  std::snprintf(text, sizeof(text), "%9.3f m", distance_m);
  return text;
}

/// Where the nearest point of an object is from the outline.
Message side_of(int object, const quality::ObstacleComparison& comparison, const quality::ObstacleOptions& options) {
  for (const quality::ObstacleCheck* check : {&comparison.calibrated, &comparison.nominal})
    for (const quality::Obstacle& obstacle : check->obstacles) {
      if (obstacle.object != object) continue;
      const Eigen::Vector3d& point = obstacle.nearest_point_in_vehicle;
      if (point.x() > options.outline_x_max_m) return say::obstacles_ahead();
      if (point.x() < options.outline_x_min_m) return say::obstacles_behind();
      if (point.y() > options.outline_y_max_m) return say::obstacles_left();
      return point.y() < options.outline_y_min_m ? say::obstacles_right() : say::obstacles_within();
    }
  return {};
}

/// The nearest decide: they come first. What is no obstacle under the calibrated mounting comes last.
std::vector<quality::ObstacleDifference> nearest_first(std::vector<quality::ObstacleDifference> rows) {
  const auto rank = [](const quality::ObstacleDifference& row) {
    return std::isfinite(row.calibrated_distance_m) ? row.calibrated_distance_m : 1e9;
  };
  std::ranges::stable_sort(rows, {}, rank);
  return rows;
}

/// Without a nominal there is nothing to compare with: one column.
std::string table(const quality::ObstacleComparison& comparison, const quality::ObstacleOptions& options,
                  bool with_nominal, const Console& console) {
  const auto title = [&](const Message& message, std::size_t columns) {
    return padded(console.words(message), columns);
  };
  std::string text = title(say::obstacles_object(), 8) + title(say::obstacles_shape(), 14) +
                     title(say::obstacles_side(), 10) + (with_nominal ? title(say::obstacles_nominal(), 14) : "") +
                     console.words(say::obstacles_calibrated()) + "\n";
  bool any_none = false;
  for (const quality::ObstacleDifference& row : nearest_first(comparison.rows)) {
    char line[32];
    std::snprintf(line, sizeof(line), "%6d  ", row.object);
    text += line + title(cloud::shape_word(row.shape), 14) + title(side_of(row.object, comparison, options), 7) +
            (with_nominal ? padded(metres(row.nominal_distance_m), 14) : std::string()) +
            metres(row.calibrated_distance_m) + "\n";
    any_none = any_none || !std::isfinite(row.calibrated_distance_m) ||
               (with_nominal && !std::isfinite(row.nominal_distance_m));
  }
  if (any_none) text += console.words(say::obstacles_none_explained()) + "\n";
  const auto decision = [&](const Message& of, const quality::ObstacleCheck& check) {
    const bool stop = check.decision == quality::ObstacleDecision::Stop;
    return title(of, 10) + ": " +
           console.words(say::obstacles_decision(metres(check.nearest_m), Length{options.stop_distance_m},
                                                 stop ? say::obstacles_stop() : say::obstacles_clear())) +
           "\n";
  };
  if (with_nominal) text += decision(say::obstacles_nominal(), comparison.nominal);
  text += decision(say::obstacles_calibrated(), comparison.calibrated);
  if (!with_nominal) text += console.words(say::obstacles_no_nominal()) + "\n";
  return text + (comparison.decision_differs() ? console.words(say::obstacles_decisions_differ()) + "\n" : "");
}

/// What --nominal gives, for the LiDAR by its name where it has one. Throws Error.
results::ReadMounting given_nominal(const ObstacleArguments& arguments, const std::string& lidar,
                                    std::vector<Message>& doubts) {
  if (lidar.empty()) return parse_ins_nominal(arguments.nominal, doubts);
  NamedNominals nominals = named_nominals({arguments.nominal}, {lidar});
  doubts.insert(doubts.end(), nominals.doubts.begin(), nominals.doubts.end());
  const auto nominal = nominals.of.find(lidar);
  if (nominal == nominals.of.end()) return parse_ins_nominal(arguments.nominal, doubts);
  if (const Message problem = results::not_in_ins_frame(nominal->second.mounting.frames); !problem.empty())
    throw Error(ErrorCode::Contract, arguments.nominal, problem);
  return nominal->second.mounting;
}

int obstacles(const ObstacleArguments& arguments, Console& console) {
  if (arguments.scan < 0)
    throw Error(ErrorCode::Contract, "--scan " + std::to_string(arguments.scan), say::cli_scans_from_zero());
  const std::optional<results::LidarResult> named = result_of_lidar(arguments.result, arguments.lidar);
  const results::ResultFile result = named ? named->file : results::load_result(arguments.result);
  if (!calibration::is_usable(result.result)) {
    console.complain(say::cli_holds_no_result(arguments.result, std::string(to_string(result.result.status))));
    return kNoResult;
  }
  if (const Message problem = results::not_in_ins_frame(result.result.mounting.frames()); !problem.empty())
    throw Error(ErrorCode::Contract, arguments.result, Message::sequence({problem, say::cli_outline_about_ins()}));
  for (const Message& warning : results::export_warnings(result.result)) console.warn(warning);
  const auto session =
      pipeline::mended_session(std::make_shared<const drive::Session>(open_with_lidar(
                                   arguments.session, arguments.topics.choice(), arguments.lidar, console)),
                               results::beams_of_scans(result));
  std::vector<Message> doubts;
  const auto in_session = [&](const results::ReadMounting& mounting) {
    return results::in_axes_of(mounting, session->ins_axes, doubts);
  };
  const RigidTransform calibrated = in_session({result.result.mounting.ins_from_lidar(), result.ins_axes, {}});
  std::optional<RigidTransform> nominal = session->nominal_ins_from_lidar;
  if (!arguments.nominal.empty())
    nominal = in_session(given_nominal(arguments, named ? named->name : "", doubts));
  else if (result.nominal_ins_from_lidar)
    nominal = in_session({*result.nominal_ins_from_lidar, result.ins_axes, {}});
  for (const Message& doubt : doubts) console.warn(doubt);
  const quality::ObstacleComparison comparison =
      report::compare_obstacles_of_scan(session, static_cast<std::size_t>(arguments.scan), nominal.value_or(calibrated),
                                        calibrated, result.settings, arguments.options);
  console.print_text(table(comparison, arguments.options, nominal.has_value(), console));
  return kSolved;
}

}  // namespace

void add_obstacles(CLI::App& app, Console& console, Run& run) {
  const auto arguments = std::make_shared<ObstacleArguments>();
  CLI::App* verb = app.add_subcommand("obstacles", console.words(say::help_obstacles()));
  verb->add_option("session", arguments->session, console.words(say::help_session_folder()))
      ->type_name("SESSION")
      ->required();
  verb->add_option("--scan", arguments->scan, console.words(say::help_scan()))->type_name("N")->required();
  verb->add_option("--result", arguments->result, console.words(say::help_result_of_obstacles()))
      ->type_name("RESULT")
      ->required();
  verb->add_option("--lidar", arguments->lidar, console.words(say::help_obstacles_lidar()))->type_name("NAME");
  verb->add_option("--nominal", arguments->nominal, console.words(say::help_nominal_of_obstacles()))
      ->type_name("SIX|FILE");
  arguments->topics.add_to(*verb, console);
  quality::ObstacleOptions::visit(arguments->options, OptionAdder{*verb, console.options().language});
  verb->callback(
      [arguments, &console, &run] { run = [arguments, &console] { return obstacles(*arguments, console); }; });
}

}  // namespace remount::cli
