// The verbs of the command line. Each adds its subcommand and, when that is chosen, sets `run`, which returns an exit
// code. Adding one: a file in this folder, a line here and one in main.cpp.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "app/cli/console.h"

namespace remount::cli {

using Run = std::function<int()>;

void add_inspect(CLI::App& app, Console& console, Run& run);
void add_describe(CLI::App& app, Console& console, Run& run);
void add_calibrate(CLI::App& app, Console& console, Run& run);
void add_solve(CLI::App& app, Console& console, Run& run);
void add_export(CLI::App& app, Console& console, Run& run);
void add_beams(CLI::App& app, Console& console, Run& run);
void add_compare(CLI::App& app, Console& console, Run& run);
void add_report(CLI::App& app, Console& console, Run& run);
void add_obstacles(CLI::App& app, Console& console, Run& run);
void add_odometry(CLI::App& app, Console& console, Run& run);
void add_simulate(CLI::App& app, Console& console, Run& run);
void add_batch(CLI::App& app, Console& console, Run& run);
void add_settings(CLI::App& app, Console& console, Run& run);
void add_doctor(CLI::App& app, Console& console, Run& run);

}  // namespace remount::cli
