// The end of every verb that solves: file, summary, exit code.
#pragma once

#include <string>

#include "app/cli/console.h"
#include "model/results/result_file.h"

namespace remount::cli {

/// Writes the result where `output` is not empty, prints the summary, and returns 0 where it is usable, otherwise 3
/// with reason and advice on stderr. A result without a usable X is written all the same: its status says why.
int finish(const results::ResultFile& file, const std::string& output, Console& console);

/// Whether a cancelled run must leave `path` alone, because something was there before: says so.
bool keeps_old_file(bool cancelled, const std::string& path, Console& console);
bool keeps_old_file(const calibration::CalibrationResult& result, const std::string& path, Console& console);

}  // namespace remount::cli
