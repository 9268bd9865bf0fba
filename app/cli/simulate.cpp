#include <memory>

#include "app/cli/arguments.h"
#include "app/cli/option_adder.h"
#include "app/cli/verbs.h"
#include "messages/command_line.h"
#include "model/simulator/simulator.h"

namespace remount {
namespace {

struct SimulateArguments {
  SimulationOptions options;
  std::string folder, format = "native", mounting, imu_mounting;
  bool sense_given = false;  ///< of the LiDAR's turn
};

int simulate(const SimulateArguments& arguments, Console& console) {
  SimulationOptions options = arguments.options;
  if (!arguments.mounting.empty()) options.ins_from_lidar = parse_six(arguments.mounting);
  if (!arguments.imu_mounting.empty()) options.imu.ins_from_imu = parse_six(arguments.imu_mounting);
  if (arguments.format == "kitti-raw" && !arguments.sense_given) options.clockwise = false;
  const SimulatedDrive drive = simulate_drive(options);
  write_drive(drive, arguments.folder, arguments.format, console.options().threads, console.progress());
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
  CLI::App* verb = app.add_subcommand(
      "simulate", "Write a drive with known truth: a ray-cast world, LiDAR, INS, IMU, GNSS, wheels and barometer");
  SimulationOptions::visit(arguments->options, OptionAdder{*verb, console.options().language});
  verb->add_option("out", arguments->folder, "Folder to write; must not exist, or be empty")
      ->type_name("OUT")
      ->required();
  verb->add_option("--format", arguments->format,
                   "Format of the session; the LiDAR of kitti-raw turns counter-clockwise unless --clockwise is given")
      ->check(CLI::IsMember(drive_formats()))
      ->capture_default_str();
  verb->add_option("--ins-from-lidar", arguments->mounting, "True mounting x,y,z,yaw,pitch,roll (m, degrees)")
      ->type_name("SIX");
  verb->add_option("--ins-from-imu", arguments->imu_mounting, "True mounting of the IMU x,y,z,yaw,pitch,roll")
      ->type_name("SIX");
  verb->callback([arguments, verb, &console, &run] {
    arguments->sense_given = verb->get_option("--clockwise")->count() > 0;
    run = [arguments, &console] { return simulate(*arguments, console); };
  });
}

}  // namespace remount
