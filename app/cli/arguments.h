// Arguments that several verbs share: nominal, search range, settings, output.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/geometry/rigid_transform.h"
#include "app/cli/console.h"
#include "model/drive/topic_choice.h"
#include "model/results/exporters/exporter.h"
#include "model/results/vehicle_file.h"
#include "model/settings/settings.h"

namespace remount::cli {

/// The parts between separators; one, empty, of an empty text.
std::vector<std::string> split(const std::string& text, char separator);

/// "x,y,z,yaw,pitch,roll" in m and degrees. Throws Error(Contract).
RigidTransform parse_six(const std::string& text);

/// "FORMAT:FILE" of a format that can be exported; nothing for another text.
struct FormatFile {
  const results::Exporter& format;
  std::string file;
};
std::optional<FormatFile> file_of_format(const std::string& text);

/// Six numbers, "vehicle:" or "machine:" before them where they are in that frame and not in the INS's; a file in any
/// format that can be exported, or "FORMAT:FILE". What a file leaves open is added to `doubts`. Throws Error.
results::ReadMounting parse_nominal(const std::string& text, std::vector<Message>& doubts);

/// The same for what needs the LiDAR in the INS frame: throws Error(Contract) for another.
results::ReadMounting parse_ins_nominal(const std::string& text, std::vector<Message>& doubts);

/// Changes a search range: six "min:max" separated by commas (x,y,z in m, yaw,pitch,roll in degrees), or "yaw=-10:10",
/// several separated by commas. Throws Error(Contract).
void apply_range(calibration::SearchRange& range, const std::string& text);

/// The only measured value that is of the vehicle and not of a LiDAR.
inline constexpr std::string_view kMeasuredInsHeight = "ins-height";

/// Notes a measured value: "z=1.73,0.01" (m or degrees, with its sigma) or "ins-height=0.62,0.02".
/// Throws Error(Contract).
void apply_measured(calibration::MeasuredOptions& options, const std::string& text);

/// Topics of bags, for verbs that open sessions.
struct TopicArguments {
  std::vector<std::string> topics;

  void add_to(CLI::App& verb, const Console& console);
  /// Throws Error(Contract).
  drive::TopicChoice choice() const;
};

/// Options that calibrate and solve have in common.
struct SolveArguments {
  /// One, but for several LiDARs; empty: not given; "none": unknown even where the data declare one.
  std::vector<std::string> nominals;
  std::vector<std::string> ranges;
  std::vector<std::string> measured;
  std::string config;
  std::vector<std::string> assignments;
  std::string output;

  void add_to(CLI::App& verb, const Console& console);
  /// Defaults or `base`, then --config, --set and --range. Throws Error.
  settings::Settings settings(const settings::Settings& base = {}) const;
  /// The nominal of the command line; nothing where it is not given or "none". Warns of what its file leaves open.
  std::optional<results::ReadMounting> nominal_mounting(Console& console) const;
  /// Before a long run whose result could not be written after it. Throws Error(Contract) for a name that ends in
  /// nothing known or that another file has, Error(Io) where the file cannot be written.
  void check_output(void (*check_replaces)(const std::filesystem::path&) = results::check_replaces_result) const;
};

}  // namespace remount::cli
