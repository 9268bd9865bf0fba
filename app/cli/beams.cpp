#include <algorithm>
#include <filesystem>
#include <memory>

#include "algorithms/core/error.h"
#include "app/cli/lidar_choice.h"
#include "app/cli/verbs.h"
#include "messages/command_help.h"
#include "messages/command_line.h"
#include "messages/rig.h"
#include "model/formats/files/atomic_save.h"
#include "model/formats/files/input_file.h"
#include "model/results/beam_file.h"
#include "model/results/velodyne_mending.h"

namespace remount::cli {
namespace {

struct BeamsArguments {
  std::string corrections, factory, output, lidar;
};

constexpr std::uint64_t kMostFactoryBytes = std::uint64_t{4} << 20U;

formats::VelodyneCalibration load_factory(const std::string& path) {
  return formats::read_velodyne_calibration(formats::read_regular_file(path, kMostFactoryBytes), path);
}

// A slip of the hand must cost neither the factory's file nor anything else.
void check_output(const BeamsArguments& arguments) {
  std::error_code none;
  if (std::filesystem::equivalent(arguments.factory, arguments.output, none))
    throw Error(ErrorCode::Contract, arguments.output, say::cli_beams_replace_factory());
  if (!formats::is_file(arguments.output)) return;
  try {
    (void)load_factory(arguments.output);
  } catch (const Error&) {
    throw Error(ErrorCode::Contract, arguments.output, say::cli_beams_replace_other());
  }
}

/// Of the named LiDAR where the file has several. Throws Error.
cloud::BeamEstimate load_corrections(const BeamsArguments& arguments) {
  const std::string& path = arguments.corrections;
  const std::optional<results::LidarResult> named = result_of_lidar(path, arguments.lidar);
  return named ? results::told_beams(named->file, ErrorCode::Format, path) : results::load_beams(path);
}

int mend_factory(const BeamsArguments& arguments, Console& console) {
  const cloud::BeamEstimate beams = load_corrections(arguments);
  if (beams.nodes.by_azimuth()) throw Error(ErrorCode::Contract, arguments.corrections, say::cli_beams_of_one_way());
  const formats::VelodyneCalibration factory = load_factory(arguments.factory);
  check_output(arguments);
  formats::save_atomically(arguments.output, results::with_beams_mended(factory, beams.beam_errors()));
  console.print(say::cli_beams_written(arguments.output, factory.lasers.size()));
  if (results::tells_scale(beams))
    console.warn(say::cli_beams_scale_left_out(Share{beams.range_scale()}, Share{beams.range_scale_sigma()}));
  return kSolved;
}

}  // namespace

void add_beams(CLI::App& app, Console& console, Run& run) {
  const auto arguments = std::make_shared<BeamsArguments>();
  CLI::App* verb = app.add_subcommand("beams", console.words(say::help_beams()));
  verb->add_option("corrections", arguments->corrections, console.words(say::help_beams_corrections()))
      ->type_name("RESULT")
      ->required();
  verb->add_option("--lidar", arguments->lidar, console.words(say::help_beams_lidar()))->type_name("NAME");
  verb->add_option("--into", arguments->factory, console.words(say::help_beams_into()))
      ->type_name("FACTORY")
      ->required();
  verb->add_option("-o,--output", arguments->output, console.words(say::help_beams_output()))
      ->type_name("FILE")
      ->required();
  verb->callback(
      [arguments, &console, &run] { run = [arguments, &console] { return mend_factory(*arguments, console); }; });
}

}  // namespace remount::cli
