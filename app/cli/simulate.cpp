#include <memory>

#include "app/cli/arguments.h"
#include "app/cli/choices.h"
#include "app/cli/mount_argument.h"
#include "app/cli/option_adder.h"
#include "app/cli/verbs.h"
#include "messages/command_help.h"
#include "messages/command_line.h"
#include "model/simulator/simulator.h"

namespace remount::cli {
namespace {

struct SimulateArguments {
  simulator::SimulationOptions options;
  std::string folder, format = "native", mounting, imu_mounting;
  std::vector<std::string> mounts;  ///< of a vehicle with several LiDARs
  bool sense_given = false;         ///< of the LiDAR's turn
};

int simulate(const SimulateArguments& arguments, Console& console) {
  simulator::SimulationOptions options = arguments.options;
  if (!arguments.mounting.empty()) options.ins_from_lidar = parse_six(arguments.mounting);
  if (!arguments.imu_mounting.empty()) options.imu.ins_from_imu = parse_six(arguments.imu_mounting);
  if (arguments.format == "kitti-raw" && !arguments.sense_given) options.clockwise = false;
  const int threads = console.options().threads;
  if (arguments.mounts.empty()) {
    simulator::write_drive(simulator::simulate_drive(options), arguments.folder, arguments.format, threads,
                           console.progress());
  } else {
    std::vector<simulator::LidarMount> mounts;
    for (const std::string& mount : arguments.mounts) mounts.push_back(parse_mount(mount, options));
    simulator::write_vehicle(simulator::simulate_vehicle(options, mounts), arguments.folder, arguments.format, threads,
                             console.progress());
  }
  if (console.cancelled()) {
    console.complain(say::cli_drive_not_complete(arguments.folder));
    return kNoResult;
  }
  console.print(say::cli_drive_simulated(arguments.folder));
  return kSolved;
}

}  // namespace

void add_simulate(CLI::App& app, Console& console, Run& run) {
  const auto arguments = std::make_shared<SimulateArguments>();
  CLI::App* verb = app.add_subcommand("simulate", console.words(say::help_simulate()));
  simulator::SimulationOptions::visit(arguments->options, OptionAdder{*verb, console.options().language});
  verb->add_option("out", arguments->folder, console.words(say::help_folder_to_write()))->type_name("OUT")->required();
  verb->add_option("--format", arguments->format, console.words(say::help_format_of_simulation()))
      ->check(one_of(simulator::drive_formats()))
      ->capture_default_str();
  verb->add_option("--ins-from-lidar", arguments->mounting, console.words(say::help_true_mounting()))->type_name("SIX");
  verb->add_option("--mount", arguments->mounts, console.words(say::help_mount()))
      ->type_name("NAME=KEY:VALUE,...")
      ->allow_extra_args(false);
  verb->add_option("--ins-from-imu", arguments->imu_mounting, console.words(say::help_true_mounting_of_imu()))
      ->type_name("SIX");
  verb->callback([arguments, verb, &console, &run] {
    arguments->sense_given = verb->get_option("--clockwise")->count() > 0;
    run = [arguments, &console] { return simulate(*arguments, console); };
  });
}

}  // namespace remount::cli
