// INSPVAX of a bag as CSV, which rostopic exports.
#pragma once

#include <filesystem>
#include <string_view>

#include "model/formats/ins/novatel_log.h"

namespace remount::formats {

/// Whether a text begins with the names of its columns.
bool is_inspvax_csv(std::string_view head);

/// Throws Error(Format) where no line is usable.
NovatelLog read_inspvax_csv(const std::filesystem::path& path);

}  // namespace remount::formats
