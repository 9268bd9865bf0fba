#include "model/report/report.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <tuple>

#include "algorithms/core/error.h"
#include "app/cli/arguments.h"
#include "app/cli/lidar_choice.h"
#include "app/cli/verbs.h"
#include "messages/command_help.h"
#include "messages/command_line.h"
#include "messages/report.h"
#include "messages/rig.h"
#include "model/formats/files/atomic_save.h"
#include "model/formats/files/current_time.h"
#include "model/overview/session_report.h"
#include "model/report/vehicle_report.h"

namespace remount::cli {
namespace {

struct ReportArguments {
  std::string result, output, lidar;
  std::vector<std::string> sessions;
  TopicArguments topics;
};

/// Tracks of another drive would pass for those that the result was made of.
class MadeOf {
 public:
  explicit MadeOf(const results::ResultFile& result) {
    for (const results::InputFile& file : result.inputs)
      if (!file.session.empty()) files_.emplace(file.session, file.file, file.bytes);
  }
  /// False where the result is of motions, or was made without a list.
  bool known() const { return !files_.empty(); }
  void require(const std::shared_ptr<const drive::Session>& session) const {
    for (const results::InputFile& file : results::list_inputs({session}))
      if (!files_.contains({file.session, file.file, file.bytes}))
        throw Error(ErrorCode::Contract, drive::path_or_name(*session),
                    say::cli_not_made_of(file.session, file.file, Bytes{file.bytes}));
  }

 private:
  std::set<std::tuple<std::string, std::string, std::uint64_t>> files_;
};

/// Reads what is reported of one LiDAR into `report`; all of a vehicle is returned. Throws Error.
std::optional<results::VehicleFile> load_reported(const ReportArguments& arguments, report::Report& report) {
  const bool several = results::is_vehicle_file(arguments.result);
  report.lidar = arguments.lidar;
  if (!several) {
    report.file = results::load_result(arguments.result);
    if (!arguments.lidar.empty()) throw Error(ErrorCode::Contract, "--lidar", say::export_of_vehicle());
    return {};
  }
  results::VehicleFile vehicle = results::load_vehicle(arguments.result);
  if (!arguments.lidar.empty()) {
    const results::LidarResult& lidar = results::lidar_of(vehicle, arguments.lidar, arguments.result);
    report.lidar = lidar.name;
    report.file = lidar.file;
    return {};
  }
  if (!arguments.sessions.empty())
    throw Error(ErrorCode::Contract, arguments.sessions.front(), say::cli_report_sessions_of_lidar());
  return vehicle;
}

int write_report(const ReportArguments& arguments, Console& console) {
  const std::string ending = std::filesystem::path(arguments.output).extension().string();
  if (ending != ".html" && ending != ".htm")
    throw Error(ErrorCode::Contract, arguments.output, say::cli_report_is_a_page());
  report::Report report;
  const std::optional<results::VehicleFile> vehicle = load_reported(arguments, report);
  std::error_code none;
  if (std::filesystem::equivalent(arguments.result, arguments.output, none))
    throw Error(ErrorCode::Contract, arguments.output, say::cli_report_replaces_result());
  formats::check_replaces_its_like(arguments.output, "<!DOCTYPE html>");
  const MadeOf made_of(report.file);
  if (!made_of.known() && !arguments.sessions.empty()) console.warn(say::cli_inputs_not_known());
  for (const std::string& path : arguments.sessions) {
    const auto session = std::make_shared<const drive::Session>(
        open_with_lidar(path, arguments.topics.choice(), arguments.lidar, console));
    if (made_of.known()) made_of.require(session);
    report.tracks.push_back(report::track_of(*session));
  }
  report.created = formats::now_in_utc();
  report.no_pictures = say::report_pictures_by_window();
  report::ReportStyle style;
  style.language = console.options().language;
  formats::save_atomically(arguments.output, vehicle ? report::vehicle_report_html(*vehicle, report, style)
                                                     : report::report_html(report, style));
  console.print(say::cli_report_written(arguments.output, arguments.result));
  return kSolved;
}

}  // namespace

void add_report(CLI::App& app, Console& console, Run& run) {
  const auto arguments = std::make_shared<ReportArguments>();
  CLI::App* verb = app.add_subcommand("report", console.words(say::help_report()));
  verb->add_option("result", arguments->result, console.words(say::help_result()))->type_name("RESULT")->required();
  verb->add_option("sessions", arguments->sessions, console.words(say::help_report_sessions()))->type_name("SESSION");
  verb->add_option("--lidar", arguments->lidar, console.words(say::help_report_lidar()))->type_name("NAME");
  arguments->topics.add_to(*verb, console);
  verb->add_option("-o,--output", arguments->output, console.words(say::help_report_page()))
      ->type_name("FILE")
      ->required();
  verb->callback(
      [arguments, &console, &run] { run = [arguments, &console] { return write_report(*arguments, console); }; });
}

}  // namespace remount::cli
