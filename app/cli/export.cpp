#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>

#include "algorithms/core/error.h"
#include "app/cli/choices.h"
#include "app/cli/verbs.h"
#include "messages/command_help.h"
#include "messages/command_line.h"
#include "messages/rig.h"
#include "model/formats/files/atomic_save.h"
#include "model/formats/files/input_file.h"
#include "model/results/exporters/several_exporter.h"
#include "model/results/exporters/vehicle_export.h"
#include "model/results/lidar_names.h"

namespace remount::cli {
namespace {

struct ExportArguments {
  std::string result, format, output, ins_frame, lidar, relative_to;
  std::vector<std::string> lidar_frames;
};

/// Frames as they were named: FRAME of one LiDAR. Throws Error(Contract).
results::ExportNames names_of_one(const ExportArguments& arguments) {
  if (arguments.lidar_frames.size() > 1)
    throw Error(ErrorCode::Contract, arguments.lidar_frames.back(), say::cli_given_twice("--lidar-frame"));
  return {arguments.ins_frame, arguments.lidar_frames.empty() ? "" : arguments.lidar_frames.front()};
}

/// NAME=FRAME of each of several, or FRAME of the one that is exported alone. Throws Error(Contract).
results::ExportNames names_of_several(const ExportArguments& arguments, const results::VehicleFile& vehicle) {
  results::ExportNames names{arguments.ins_frame, ""};
  names.relative_to = arguments.relative_to;
  for (const std::string& text : arguments.lidar_frames) {
    const std::size_t equals = text.find('=');
    // Of one that is exported alone it is clear whose frame is named.
    const bool of_the_only = equals == std::string::npos && !arguments.lidar.empty();
    const std::string lidar =
        results::lidar_meant_by(of_the_only ? arguments.lidar : text.substr(0, equals), lidar_names(vehicle));
    const std::string frame = of_the_only ? text : equals == std::string::npos ? "" : text.substr(equals + 1);
    if (frame.empty() || lidar.empty())
      throw Error(ErrorCode::Contract, "--lidar-frame " + text, say::export_names_of_several(lidar_names(vehicle)));
    if (!names.lidar_frames.emplace(lidar, frame).second)
      throw Error(ErrorCode::Contract, "--lidar-frame " + text, say::cli_given_twice(lidar));
  }
  return names;
}

void check_replaces(const ExportArguments& arguments, const std::filesystem::path& output,
                    const results::Exporter& format) {
  std::error_code none;
  if (std::filesystem::equivalent(arguments.result, output, none))
    throw Error(ErrorCode::Contract, output.string(), say::cli_export_replaces_result());
  results::check_replaces_export(output, format);
}

int deliver(const std::string& text, const Message& direction, const ExportArguments& arguments, Console& console) {
  if (arguments.output.empty()) {
    console.deliver(text);
    return kSolved;
  }
  formats::save_atomically(arguments.output, text);
  console.print(say::cli_exported(arguments.output, direction));
  return kSolved;
}

int export_one(const results::ResultFile& result, const results::ExportNames& names, const ExportArguments& arguments,
               Console& console) {
  const results::Exporter& format = results::exporter(arguments.format);
  if (!calibration::is_usable(result.result)) {
    console.complain(say::cli_nothing_exported(arguments.result, result.result.message));
    return kNoResult;
  }
  for (const Message& warning : results::export_warnings(result.result)) console.warn(warning);
  if (!arguments.output.empty()) check_replaces(arguments, arguments.output, format);
  return deliver(format.write(result, names), format.direction(), arguments, console);
}

/// Takes out LiDARs without a usable result, and says so. False where there were some.
bool keep_usable(results::VehicleFile& vehicle, Console& console) {
  const std::size_t all = vehicle.lidars.size();
  results::keep_lidars(vehicle, [&](const results::LidarResult& lidar) {
    if (calibration::is_usable(lidar.file.result)) return true;
    console.complain(say::export_lidar_left_out(lidar.name, lidar.file.result.message));
    return false;
  });
  return vehicle.lidars.size() == all;
}

int export_into_folder(const results::VehicleFile& vehicle, const results::ExportNames& names,
                       const ExportArguments& arguments, Console& console) {
  const results::Exporter& format = results::exporter(arguments.format);
  const std::filesystem::path folder = arguments.output;
  if (folder.empty() || std::filesystem::is_regular_file(folder))
    throw Error(ErrorCode::Contract, arguments.output, say::cli_export_folder_expected(arguments.format));
  std::vector<results::LeftOut> left_out;
  const std::vector<results::ExportedFile> exported = results::export_vehicle(vehicle, format, names, left_out);
  for (const results::LeftOut& lidar : left_out)
    console.complain(say::export_lidar_unfit(lidar.lidar, arguments.format, lidar.why));
  std::vector<formats::BytesToSave> files;
  for (const results::ExportedFile& file : exported) {
    files.push_back({folder / file.name, file.text});
    check_replaces(arguments, files.back().path, format);
  }
  formats::make_directories(folder);
  formats::save_together(files);
  for (const formats::BytesToSave& file : files)
    console.print(say::cli_exported(file.path.string(), format.direction()));
  return left_out.empty() ? kSolved : kNoResult;
}

int export_several(results::VehicleFile vehicle, const ExportArguments& arguments, Console& console) {
  const results::Exporter& format = results::exporter(arguments.format);
  results::ExportNames names = names_of_several(arguments, vehicle);
  Message direction = format.direction();
  if (!names.relative_to.empty()) {
    results::require_frames(format, "--relative-to");
    names.relative_to = results::lidar_of(vehicle, names.relative_to, arguments.result).name;
  }
  const int code = keep_usable(vehicle, console) ? kSolved : kNoResult;
  if (vehicle.lidars.empty()) return code;
  if (!names.relative_to.empty()) {
    if (!results::find_lidar(vehicle, names.relative_to) || vehicle.lidars.size() < 2) {
      console.complain(say::of_file(arguments.result, say::export_relative_not_usable(names.relative_to)));
      return kNoResult;
    }
    vehicle = results::relative_to(vehicle, names.relative_to, arguments.result);
    direction = say::export_direction_relative(names.relative_to);
  }
  for (const results::LidarResult& lidar : vehicle.lidars)
    for (const Message& warning : results::export_warnings(lidar.file.result))
      console.warn(say::export_warning_of_lidar(lidar.name, warning));
  if (!format.holds_several()) return std::max(code, export_into_folder(vehicle, names, arguments, console));
  if (!arguments.output.empty()) check_replaces(arguments, arguments.output, format);
  return std::max(code, deliver(format.write_all(vehicle, names), direction, arguments, console));
}

int export_result(const ExportArguments& arguments, Console& console) {
  (void)results::exporter(arguments.format);
  if (!results::is_vehicle_file(arguments.result)) {
    // First, or a file that is missing would be called the result of one.
    const results::ResultFile one = results::load_result(arguments.result);
    for (const auto& [option, text] : {std::pair("--lidar", arguments.lidar), {"--relative-to", arguments.relative_to}})
      if (!text.empty()) throw Error(ErrorCode::Contract, option, say::export_of_vehicle());
    return export_one(one, names_of_one(arguments), arguments, console);
  }
  const results::VehicleFile vehicle = results::load_vehicle(arguments.result);
  if (arguments.lidar.empty()) return export_several(vehicle, arguments, console);
  const results::LidarResult& lidar = results::lidar_of(vehicle, arguments.lidar, arguments.result);
  results::VehicleFile only;
  only.lidars = {lidar};
  const results::ExportNames names = names_of_several(arguments, vehicle);
  return export_one(lidar.file, {names.ins_frame, results::frame_names(only, names, "", "").lidars.front()}, arguments,
                    console);
}

}  // namespace

void add_export(CLI::App& app, Console& console, Run& run) {
  const auto arguments = std::make_shared<ExportArguments>();
  CLI::App* verb = app.add_subcommand("export", console.words(say::help_export()));
  verb->add_option("result", arguments->result, console.words(say::help_result()))->type_name("RESULT")->required();
  std::vector<Message> formats;
  std::vector<std::string> ids;
  for (const auto& format : results::exporters()) {
    ids.emplace_back(format->id());
    formats.push_back(say::help_export_format(std::string(format->id()), format->description(), format->direction()));
  }
  verb->add_option("--to", arguments->format, console.words(say::help_export_formats(std::move(formats))))
      ->check(completed_by(ids))
      ->type_name("FORMAT")
      ->required();
  verb->add_option("-o,--output", arguments->output, console.words(say::help_export_output()))
      ->type_name("FILE|FOLDER");
  CLI::Option* ins_frame = verb->add_option("--ins-frame", arguments->ins_frame, console.words(say::help_ins_frame()));
  ins_frame->type_name("NAME");
  verb->add_option("--lidar-frame", arguments->lidar_frames, console.words(say::help_lidar_frame()))
      ->type_name("NAME|LIDAR=NAME")
      ->allow_extra_args(false);
  CLI::Option* one = verb->add_option("--lidar", arguments->lidar, console.words(say::help_export_lidar()));
  one->type_name("NAME");
  verb->add_option("--relative-to", arguments->relative_to, console.words(say::help_export_relative()))
      ->type_name("NAME")
      ->excludes(one)
      ->excludes(ins_frame);
  verb->callback(
      [arguments, &console, &run] { run = [arguments, &console] { return export_result(*arguments, console); }; });
}

}  // namespace remount::cli
