#include <filesystem>
#include <memory>

#include "algorithms/core/error.h"
#include "app/cli/verbs.h"
#include "messages/command_help.h"
#include "messages/command_line.h"
#include "model/formats/files/atomic_save.h"
#include "model/results/exporters/exporter.h"

namespace remount::cli {
namespace {

struct ExportArguments {
  std::string result, format, output;
  results::ExportNames names;
};

int export_result(const ExportArguments& arguments, Console& console) {
  const results::Exporter& format = results::exporter(arguments.format);
  const results::ResultFile result = results::load_result(arguments.result);
  if (!calibration::is_usable(result.result)) {
    console.complain(say::cli_nothing_exported(arguments.result, result.result.message));
    return kNoResult;
  }
  for (const Message& warning : results::export_warnings(result.result)) console.warn(warning);
  std::error_code none;
  if (!arguments.output.empty() && std::filesystem::equivalent(arguments.result, arguments.output, none))
    throw Error(ErrorCode::Contract, arguments.output, say::cli_export_replaces_result());
  if (!arguments.output.empty()) results::check_replaces_export(arguments.output, format);
  const std::string text = format.write(result, arguments.names);
  if (arguments.output.empty()) {
    console.deliver(text);
    return kSolved;
  }
  formats::save_atomically(arguments.output, text);
  console.print(say::cli_exported(arguments.output, format.direction()));
  return kSolved;
}

}  // namespace

void add_export(CLI::App& app, Console& console, Run& run) {
  const auto arguments = std::make_shared<ExportArguments>();
  CLI::App* verb = app.add_subcommand("export", console.words(say::help_export()));
  verb->add_option("result", arguments->result, console.words(say::help_result()))->type_name("RESULT")->required();
  std::vector<Message> formats;
  for (const auto& format : results::exporters())
    formats.push_back(say::help_export_format(std::string(format->id()), format->description(), format->direction()));
  verb->add_option("--to", arguments->format, console.words(say::help_export_formats(std::move(formats))))
      ->type_name("FORMAT")
      ->required();
  verb->add_option("-o,--output", arguments->output, console.words(say::help_output_or_standard()))->type_name("FILE");
  verb->add_option("--ins-frame", arguments->names.ins_frame, console.words(say::help_ins_frame()))->type_name("NAME");
  verb->add_option("--lidar-frame", arguments->names.lidar_frame, console.words(say::help_lidar_frame()))
      ->type_name("NAME");
  verb->callback(
      [arguments, &console, &run] { run = [arguments, &console] { return export_result(*arguments, console); }; });
}

}  // namespace remount::cli
