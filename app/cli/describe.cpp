#include <algorithm>
#include <filesystem>
#include <memory>
#include <vector>

#include "algorithms/core/error.h"
#include "app/cli/verbs.h"
#include "messages/command_help.h"
#include "messages/command_line.h"
#include "messages/guesses.h"
#include "model/formats/documents/document.h"
#include "model/formats/files/atomic_save.h"
#include "model/formats/files/input_file.h"
#include "model/formats/sessions/native_session_reader.h"
#include "model/guesses/description.h"
#include "model/guesses/manifest.h"

namespace remount::cli {
namespace {

namespace fs = std::filesystem;

struct DescribeArguments {
  std::vector<std::string> paths;
  std::string output;
  bool force = false;
};

/// Where a manifest lies that is only printed: paths in it are relative to what was described.
fs::path folder_described(const std::string& path) {
  return formats::is_folder(path) ? fs::path(path) : fs::absolute(path).parent_path();
}

/// That what was written opens, as far as it says what a session needs.
void open_again(const fs::path& manifest, Console& console) {
  const drive::Session session = formats::NativeSessionReader().open(manifest, console.progress());
  console.report(session.findings);
}

void tell(const guesses::Description& description, Console& console) {
  for (const Message& missing : description.missing) console.warn(missing);
  constexpr std::size_t kMostTold = 10;
  const bool lacks_data = !description.ins || description.lidars.empty();
  for (std::size_t i = 0; lacks_data && i < std::min(description.not_used.size(), kMostTold); ++i)
    console.warn(say::guess_manifest_not_used(description.not_used[i].path.string(), description.not_used[i].why));
  if (description.open()) console.warn(say::cli_describe_open());
}

int describe(const DescribeArguments& arguments, Console& console) {
  const std::vector<fs::path> paths(arguments.paths.begin(), arguments.paths.end());
  // Before the work, which may take a while.
  if (!arguments.output.empty() && !arguments.force && formats::is_file(arguments.output))
    throw Error(ErrorCode::Contract, arguments.output, say::cli_describe_exists());
  const guesses::Description description = guesses::describe_data(
      paths, console.progress(), arguments.force ? guesses::KnownFormats::PassedOver : guesses::KnownFormats::Told);
  if (console.cancelled()) return kNoResult;
  if (description.known) {
    const std::string path = description.known->path.string();
    console.print(description.known->format == "native" ? say::cli_describe_manifest(path)
                                                        : say::cli_describe_known(path, description.known->what));
    return kSolved;
  }
  tell(description, console);
  if (!description.ins && description.lidars.empty()) return kNoResult;
  const fs::path folder =
      arguments.output.empty() ? folder_described(arguments.paths.front()) : fs::path(arguments.output).parent_path();
  const std::string text = formats::to_yaml(guesses::manifest_of(description, folder, console.options().language));
  if (arguments.output.empty()) {
    console.deliver(text);
  } else {
    formats::save_atomically(arguments.output, text);
    console.print(say::cli_describe_written(arguments.output));
    if (description.complete()) open_again(arguments.output, console);
  }
  return description.complete() ? kSolved : kNoResult;
}

}  // namespace

void add_describe(CLI::App& app, Console& console, Run& run) {
  const auto arguments = std::make_shared<DescribeArguments>();
  CLI::App* verb = app.add_subcommand("describe", console.words(say::help_describe()));
  verb->add_option("paths", arguments->paths, console.words(say::help_describe_paths()))->type_name("PATH")->required();
  verb->add_option("-o,--output", arguments->output, console.words(say::help_describe_output()))->type_name("FILE");
  verb->add_flag("--force", arguments->force, console.words(say::help_describe_force()));
  verb->footer(console.words(say::help_describe_exit_codes()));
  verb->callback(
      [arguments, &console, &run] { run = [arguments, &console] { return describe(*arguments, console); }; });
}

}  // namespace remount::cli
