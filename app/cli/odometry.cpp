#include <memory>

#include "algorithms/core/error.h"
#include "app/cli/arguments.h"
#include "app/cli/verbs.h"
#include "messages/command_help.h"
#include "messages/command_line.h"
#include "messages/general.h"
#include "model/drive/session_frames.h"
#include "model/formats/files/atomic_save.h"
#include "model/formats/session_readers.h"
#include "model/methods/fusion_odometry/fusion_run.h"
#include "model/pipeline/mended_scans.h"
#include "model/results/beam_file.h"
#include "model/settings/settings_file.h"
#include "model/sweeps/settled_sweeps.h"

namespace remount::cli {
namespace {

struct OdometryArguments {
  std::string session, nominal, config, output;
  std::vector<std::string> assignments;
  TopicArguments topics;
};

std::optional<RigidTransform> nominal_of(const OdometryArguments& arguments, const drive::Session& session,
                                         Console& console) {
  if (arguments.nominal == "none") return std::nullopt;
  if (arguments.nominal.empty()) return session.nominal_ins_from_lidar;
  std::vector<Message> doubts;
  const RigidTransform nominal =
      results::in_axes_of(parse_ins_nominal(arguments.nominal, doubts), session.ins_axes, doubts);
  for (const Message& doubt : doubts) console.warn(say::of_file(arguments.nominal, doubt));
  return nominal;
}

Message summary(const methods::FusionRun& run) {
  double driven_m = 0.0;
  const std::vector<odometry::FusedScan>& scans = run.odometry.scans;
  for (std::size_t i = 1; i < scans.size(); ++i)
    driven_m +=
        (scans[i].odometry_from_vehicle.translation() - scans[i - 1].odometry_from_vehicle.translation()).norm();
  return say::cli_poses(scans.size(), Length{driven_m});
}

int odometry(const OdometryArguments& arguments, Console& console) {
  settings::Settings settings =
      arguments.config.empty() ? settings::Settings{} : settings::load_settings(arguments.config);
  for (const std::string& assignment : arguments.assignments) settings::apply_setting(settings, assignment);
  settings::require_valid(settings);
  formats::check_replaces_its_like(arguments.output, "# t x y z qx qy qz qw");
  formats::check_can_save(arguments.output);
  pipeline::PipelineInput input;
  input.sessions = {std::make_shared<const drive::Session>(
      formats::open_session(arguments.session, arguments.topics.choice(), console.progress()))};
  input.sessions = {
      pipeline::mended_session(input.sessions.front(), results::known_beams(settings.beams, input.sessions))};
  input.settings = settings;
  input.threads = console.options().threads;
  const std::shared_ptr<const drive::Session> swept =
      sweeps::settle_sweeps(input, console.progress()).input.sessions.front();
  const drive::Session& session = *swept;
  const methods::FusionRun run = methods::run_fusion_odometry(session, nominal_of(arguments, session, console),
                                                              settings, console.options().threads, console.progress());
  console.report(session.findings);
  console.report(run.findings);
  if (run.odometry.cancelled) {
    console.complain(say::cli_poses_cancelled(summary(run)));
    return kNoResult;
  }
  formats::save_atomically(arguments.output, methods::odometry_text(run.odometry_from_lidar));
  console.print(say::cli_poses_written(arguments.output, summary(run)));
  return kSolved;
}

}  // namespace

void add_odometry(CLI::App& app, Console& console, Run& run) {
  const auto arguments = std::make_shared<OdometryArguments>();
  CLI::App* verb = app.add_subcommand("odometry", console.words(say::help_odometry()));
  verb->add_option("session", arguments->session, console.words(say::help_session()))->type_name("SESSION")->required();
  verb->add_option("-o,--output", arguments->output, console.words(say::help_poses_to_write()))
      ->type_name("FILE")
      ->required();
  verb->add_option("--nominal", arguments->nominal, console.words(say::help_nominal_of_odometry()))
      ->type_name("SIX|FILE");
  arguments->topics.add_to(*verb, console);
  verb->add_option("--config", arguments->config, console.words(say::help_config_of_odometry()))->type_name("FILE");
  verb->add_option("--set", arguments->assignments, console.words(say::help_set_of_odometry()))->type_name("S.N=V");
  verb->callback(
      [arguments, &console, &run] { run = [arguments, &console] { return odometry(*arguments, console); }; });
}

}  // namespace remount::cli
