#include <memory>
#include <type_traits>

#include "algorithms/core/error.h"
#include "app/cli/arguments.h"
#include "app/cli/verbs.h"
#include "model/io/document.h"
#include "model/simulator/simulator.h"

namespace remount {
namespace {

struct SimulateArguments {
  SimulationOptions options;
  std::string folder, format = "native", mounting;
};

/// One command line option for each member of the simulator's options: "duration_s" becomes --duration-s.
struct OptionAdder {
  CLI::App& verb;
  std::string scenarios{};

  static std::string flag(const OptionInfo& info) {
    std::string name = "--" + std::string(info.name);
    for (char& c : name)
      if (c == '_') c = '-';
    return name;
  }
  static std::string help(const OptionInfo& info) {
    return std::string(info.help) + (info.unit.empty() ? "" : " [" + std::string(info.unit) + "]");
  }

  template <class T>
  void operator()(const OptionInfo& info, T& value) {
    CLI::Option* option = verb.add_option(flag(info), value, help(info))->capture_default_str();
    if constexpr (std::is_same_v<T, bool>)
      option->type_name("true|false");
    else if constexpr (std::is_arithmetic_v<T>)
      option->check(CLI::Range(static_cast<T>(info.minimum), static_cast<T>(info.maximum)))
          ->type_name(shortest(info.minimum) + " to " + shortest(info.maximum));
  }

  /// The scenario is the verb's first argument.
  template <class T>
  void choice(const OptionInfo& info, T& value, const std::vector<std::string_view>& names) {
    const std::vector<std::string> known(names.begin(), names.end());
    std::string list;
    for (const std::string& name : known) list += (list.empty() ? "" : ", ") + name;
    verb.add_option_function<std::string>(
            std::string(info.name),
            [&value, known](const std::string& name) {
              value = static_cast<T>(std::find(known.begin(), known.end(), name) - known.begin());
            },
            help(info) + " " + list)
        ->check(CLI::IsMember(known))
        ->required()
        ->type_name("SCENARIO");
  }
};

int simulate(SimulateArguments arguments, Console& console) {
  if (!arguments.mounting.empty()) arguments.options.ins_from_lidar = parse_six(arguments.mounting);
  const SimulatedDrive drive = simulate_drive(arguments.options);
  write_drive(drive, arguments.folder, arguments.format, console.options().threads, console.progress());
  if (console.cancelled()) {
    console.complain(arguments.folder + ": cancelled, the drive is not complete");
    return kNoResult;
  }
  console.print("simulated drive: " + arguments.folder + " (truth in truth.yaml)");
  return kSolved;
}

}  // namespace

void add_simulate(CLI::App& app, Console& console, Run& run) {
  const auto arguments = std::make_shared<SimulateArguments>();
  CLI::App* verb =
      app.add_subcommand("simulate", "Write a drive with known truth: a ray-cast world, a LiDAR and an INS");
  SimulationOptions::visit(arguments->options, OptionAdder{*verb});
  verb->add_option("out", arguments->folder, "Folder to write; must not exist, or be empty")
      ->type_name("OUT")
      ->required();
  verb->add_option("--format", arguments->format, "Format of the session")
      ->check(CLI::IsMember({"native", "kitti-raw"}))
      ->capture_default_str();
  verb->add_option("--ins-from-lidar", arguments->mounting, "True mounting x,y,z,yaw,pitch,roll (m, degrees)")
      ->type_name("SIX");
  verb->callback(
      [arguments, &console, &run] { run = [arguments, &console] { return simulate(*arguments, console); }; });
}

}  // namespace remount
