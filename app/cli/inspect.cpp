#include <memory>

#include "algorithms/core/error.h"
#include "app/cli/arguments.h"
#include "app/cli/lidar_choice.h"
#include "app/cli/verbs.h"
#include "messages/command_help.h"
#include "messages/command_line.h"
#include "model/formats/session_readers.h"
#include "model/overview/session_report.h"

namespace remount::cli {
namespace {

struct InspectArguments {
  std::vector<std::string> paths;
  TopicArguments topics;
};

/// The LiDARs of a recording that has several, and which of them was looked at; empty where it has not.
Message lidars_of(const drive::Session& session, Progress& progress) {
  const std::vector<drive::LidarOffer> offers = rig::lidars_of_several(session, progress);
  if (offers.empty()) return {};
  const std::string indent = "  ";
  std::vector<Message> lines;
  for (const drive::LidarOffer& offer : offers) {
    const Message line =
        offer.scans ? say::cli_lidar_with_scans(indent, offer.name, *offer.scans) : say::cli_lidar(indent, offer.name);
    lines.push_back(offer.name == session.lidar_name ? say::cli_lidar_looked_at(line) : line);
  }
  return say::cli_lidars(std::move(lines));
}

int inspect(const InspectArguments& arguments, Console& console) {
  int code = kSolved;
  const drive::TopicChoice topics = arguments.topics.choice();
  for (const std::string& path : arguments.paths) {
    try {
      const drive::Session session = formats::open_session(path, topics, console.progress());
      const overview::SessionReport report = overview::report_session(session, console.progress());
      console.print_text(overview::describe(session, report, console.options().language));
      if (const Message lidars = lidars_of(session, console.progress()); !lidars.empty()) console.print(lidars);
      if (!report.usable && code == kSolved) code = kNoResult;
    } catch (const Error& error) {
      console.complain(error);
      if (code != kUnreadable) code = exit_code_of(error);
    }
    if (console.cancelled()) return kNoResult;
  }
  return code;
}

}  // namespace

void add_inspect(CLI::App& app, Console& console, Run& run) {
  const auto arguments = std::make_shared<InspectArguments>();
  CLI::App* verb = app.add_subcommand("inspect", console.words(say::help_inspect()));
  verb->add_option("paths", arguments->paths, console.words(say::help_sessions()))->type_name("PATH")->required();
  arguments->topics.add_to(*verb, console);
  std::string formats = console.words(say::help_inspect_formats());
  for (const auto& reader : formats::session_readers())
    formats += "\n  " + console.words(say::of_file(std::string(reader->id()), reader->description()));
  verb->footer(formats);
  verb->callback([arguments, &console, &run] { run = [arguments, &console] { return inspect(*arguments, console); }; });
}

}  // namespace remount::cli
