#include "model/methods/calibrate.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

#include "algorithms/core/error.h"
#include "app/cli/arguments.h"
#include "app/cli/calibrate_vehicle.h"
#include "app/cli/choices.h"
#include "app/cli/finish.h"
#include "app/cli/lidar_choice.h"
#include "app/cli/named_measured.h"
#include "app/cli/sessions.h"
#include "app/cli/verbs.h"
#include "messages/command_help.h"
#include "messages/command_line.h"
#include "messages/rig.h"
#include "model/formats/files/atomic_save.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/number_text.h"
#include "model/method_registry/calibration_method.h"
#include "model/methods/trajectory/trajectory_method.h"
#include "model/project/holder_lock.h"
#include "model/project/project.h"
#include "model/results/mounting_frames.h"
#include "model/rig/rig_calibration.h"

namespace remount::cli {
namespace {

struct CalibrateArguments {
  std::vector<std::string> sessions;
  SolveArguments solve;
  TopicArguments topics;
  std::string project, save_project;
  std::string method;  ///< empty: as the settings say
  std::string lidars;  ///< empty: one, as the recording suggests it
  bool no_hashes = false;
  bool follow = false;
  double settled_s = 5.0;
};

/// One answer on the way, on a line: "12.0 s: x 0.912 +-0.020, y -0.250 +-0.021, yaw 1.71 +-0.05; not observed: z,
/// pitch".
Message line_of(const calibration::TrajectorySnapshot& snapshot) {
  const Duration time{snapshot.time_s};
  if (!snapshot.known) return say::cli_too_little_data(time);
  const calibration::PerParameter<double> values = calibration::parameters_of(snapshot.mounting.reference_from_sensor);
  const bool of_antenna = snapshot.mounting.reference == calibration::BodyFrame::Antenna;
  std::vector<std::string> seen, open;
  for (const calibration::Parameter parameter : calibration::kParameters) {
    const std::string name(to_string(parameter));
    const bool angle = calibration::is_angle(parameter);
    const std::optional<double>& sigma = snapshot.sigma[parameter];
    if (!sigma) {
      if (!of_antenna || !angle) open.push_back(name);
      continue;
    }
    const double unit = angle ? 180.0 / kPi : 1.0;
    seen.push_back(name + " " + formats::rounded_text(unit * values[parameter], 4) + " +-" +
                   formats::spread_text(unit * *sigma, 4) + (angle ? " deg" : " m"));
  }
  Message parts = open.empty()   ? say::cli_seen(seen)
                  : seen.empty() ? say::cli_not_observed(open)
                                 : say::cli_seen_but_for(seen, open);
  if (snapshot.converged) parts = say::cli_converged(parts);
  return of_antenna ? say::cli_so_far_antenna(time, parts) : say::cli_so_far(time, parts);
}

/// Follows a session that grows, and ends as `calibrate` does.
int follow(const CalibrateArguments& arguments, Console& console) {
  if (arguments.method != methods::kTrajectoryMethod.id)
    throw Error(ErrorCode::Contract, "--follow", say::cli_follow_method());
  if (arguments.sessions.size() != 1 || !arguments.project.empty() || !arguments.save_project.empty())
    throw Error(ErrorCode::Contract, "--follow", say::cli_follow_one_session());
  arguments.solve.check_output();
  pipeline::PipelineInput input;
  input.settings = arguments.solve.settings({});
  input.settings.run.method = method_registry::MethodChoice(methods::kTrajectoryMethod.id);
  input.threads = console.options().threads;
  if (const std::optional<results::ReadMounting> nominal = arguments.solve.nominal_mounting(console)) {
    std::vector<Message> doubts;
    input.nominal_ins_from_lidar = results::in_axes_of(*nominal, std::nullopt, doubts);
    input.nominal_frames = nominal->frames;
  }
  methods::check_nominal(input);
  methods::FollowOptions options;
  options.settled_s = arguments.settled_s;
  options.declared_nominal = arguments.solve.nominals.empty();
  options.topics = arguments.topics.choice();
  Progress finishing;  // Ctrl-C ends the following; its result is still worked out
  methods::FollowedSession followed = methods::follow_trajectory(
      arguments.sessions.front(), input, options,
      [&](const calibration::TrajectorySnapshot& snapshot) { console.print(line_of(snapshot)); }, console.progress(),
      finishing);
  input.sessions = {followed.session};
  input.nominal_ins_from_lidar = followed.nominal_ins_from_lidar;
  std::vector<results::InputFile> inputs;
  if (!arguments.no_hashes) inputs = results::hash_inputs(input.sessions, input.threads, finishing);
  console.report(followed.output.findings);
  return finish(project::make_result_file(input, followed.output, std::move(inputs)), arguments.solve.output, console);
}

/// Where the project goes, tried before the work begins. Held until it is saved: a window that has it open would save
/// over it, or over what is in the window. Nowhere for an empty path.
class ProjectFile {
 public:
  explicit ProjectFile(const std::string& path) : path_(path) {
    if (path.empty()) return;
    formats::check_replaces_its_like(path, "remount-project/");
    formats::check_can_save(path);
    const project::HolderLock::Attempt attempt = project::HolderLock::take(project::lock_path_of(path));
    if (attempt.holder) refuse(say::cli_project_open(project::holder_words(*attempt.holder)));
    lock_ = attempt.lock;
    if (lock_) beats_ = std::jthread([lock = lock_](const std::stop_token& stop) { show_life(*lock, stop); });
  }

  void save(const project::Project& project) const {
    if (const auto other = lock_ ? lock_->beat() : std::nullopt)
      refuse(say::cli_project_taken_over(project::holder_words(*other)));
    project::save_project(project, path_);
  }

 private:
  /// Where the kernel's lock does not reach, others see by the file's time that somebody works on it.
  static void show_life(const project::HolderLock& lock, const std::stop_token& stop) {
    std::mutex mutex;
    std::condition_variable_any stopped;
    std::unique_lock waiting(mutex);
    const auto never = [] { return false; };
    while (!stop.stop_requested()) {
      stopped.wait_for(waiting, stop, std::chrono::milliseconds(project::HolderLock::kBeat_ms), never);
      lock.beat();
    }
  }
  [[noreturn]] void refuse(const Message& why) const { throw Error(ErrorCode::Io, path_, why); }

  std::string path_;
  std::shared_ptr<const project::HolderLock> lock_;
  std::jthread beats_;
};

/// Where recordings have several LiDARs, that they could be calibrated together. Maps and the like are not counted:
/// "all" takes none.
void tell_of_others(const Sessions& sessions, Console& console) {
  std::size_t most = 0;
  for (const auto& session : sessions) {
    std::vector<drive::LidarOffer> offers = rig::lidars_of_several(*session, console.progress());
    std::erase_if(offers, [](const drive::LidarOffer& offer) { return offer.rare; });
    most = std::max(most, offers.size());
  }
  if (most > 1) console.print(say::cli_note(say::cli_rig_together_with(most)));
}

/// A LiDAR, and the recordings that have it with the topics that they are opened with.
struct OneLidar {
  std::string name;  ///< empty: as each recording suggests it
  std::vector<std::filesystem::path> recordings;
  std::vector<drive::TopicChoice> topics;
};

/// What the command line gives, for the LiDAR by its name where it has one.
std::optional<results::ReadMounting> nominal_of(const CalibrateArguments& arguments, const OneLidar& lidar,
                                                Console& console) {
  if (lidar.name.empty()) return arguments.solve.nominal_mounting(console);
  NamedNominals nominals = named_nominals(arguments.solve.nominals, {lidar.name}, console);
  const auto nominal = nominals.of.find(lidar.name);
  if (nominal == nominals.of.end()) return std::nullopt;
  return nominal->second.mounting;
}

/// What goes with one LiDAR only. Throws Error(Contract).
void check_several(const CalibrateArguments& arguments, const settings::Settings& settings, const std::string& lidar) {
  const std::array<std::pair<bool, const char*>, 2> of_one{
      {{!arguments.save_project.empty(), "--save-project"},
       {settings.run.method->id != calibration::kPairwise, "--method"}}};
  for (const auto& [given, option] : of_one)
    if (given) throw Error(ErrorCode::Contract, option, say::cli_rig_option_of_one());
  if (rig::measures_one_lidar(settings))
    throw Error(ErrorCode::Contract, "--measured", say::cli_rig_measured_of_which(lidar));
}

int calibrate_several(CalibrateArguments arguments, std::vector<ChosenLidar> lidars, Console& console) {
  VehicleJob job;
  std::vector<std::string> names;
  for (const ChosenLidar& lidar : lidars) names.push_back(lidar.name);
  job.measured = take_named_measured(arguments.solve.measured, names);
  job.settings = arguments.solve.settings({});
  if (!arguments.method.empty()) job.settings.run.method = method_registry::MethodChoice(arguments.method);
  check_several(arguments, job.settings, names.front());
  arguments.solve.check_output(results::check_replaces_vehicle);
  job.nominals = named_nominals(arguments.solve.nominals, names, console);
  job.recordings.assign(arguments.sessions.begin(), arguments.sessions.end());
  job.lidars = std::move(lidars);
  job.output = arguments.solve.output;
  job.hashes = !arguments.no_hashes;
  return calibrate_vehicle(job, console);
}

int calibrate_one(const CalibrateArguments& arguments, const OneLidar& lidar, Console& console) {
  project::Project project;
  if (!arguments.project.empty()) project = project::load_project(arguments.project);
  project.topics.resize(project.sessions.size());
  project.sessions.insert(project.sessions.end(), lidar.recordings.begin(), lidar.recordings.end());
  project.topics.insert(project.topics.end(), lidar.topics.begin(), lidar.topics.end());
  if (project.sessions.empty()) throw Error(ErrorCode::Contract, "calibrate", say::cli_no_session());
  arguments.solve.check_output();
  const ProjectFile project_file(arguments.save_project);

  pipeline::PipelineInput input;
  input.settings = arguments.solve.settings(project.settings);
  if (!arguments.method.empty()) input.settings.run.method = method_registry::MethodChoice(arguments.method);
  input.threads = console.options().threads;
  const std::optional<results::ReadMounting> nominal = nominal_of(arguments, lidar, console);
  input.sessions = open_sessions(project.sessions, project.topics, console);
  if (lidar.name.empty() && input.settings.run.method->id == calibration::kPairwise)
    tell_of_others(input.sessions, console);
  if (nominal) {
    input.nominal_ins_from_lidar = nominal_in_axes(*nominal, arguments.solve.nominals.back(), input.sessions, console);
    input.nominal_frames = nominal->frames;
  } else if (arguments.solve.nominals.empty()) {
    input.nominal_ins_from_lidar = project.nominal_ins_from_lidar;
    if (!input.nominal_ins_from_lidar)
      input.nominal_ins_from_lidar = results::declared_nominal(input.sessions, *input.settings.run.method);
  }

  input.verdicts = project.verdicts;
  input.tell_so_far = [&console](const Message& x) { console.print(x); };
  pipeline::PipelineOutput output = methods::calibrate(input, console.progress());
  project.solution_pending = project.confirmed = project.exported = false;
  std::vector<results::InputFile> inputs;
  if (!arguments.no_hashes) inputs = results::hash_inputs(input.sessions, input.threads, console.progress());
  console.report(output.findings);

  // First: where the project cannot be saved, a long run is not lost.
  const int code = finish(project::make_result_file(input, output, inputs), arguments.solve.output, console);
  if (!arguments.save_project.empty() && !keeps_old_file(output.result, arguments.save_project, console)) {
    project.settings = input.settings;
    // A project's nominal is of the LiDAR in the INS frame.
    project.nominal_ins_from_lidar =
        input.nominal_frames.reference == calibration::BodyFrame::Ins ? input.nominal_ins_from_lidar : std::nullopt;
    project.inputs = std::move(inputs);
    project.output = std::move(output);
    project.basis = project::basis_of(input);
    project_file.save(project);
  }
  return code;
}

int calibrate(const CalibrateArguments& arguments, Console& console) {
  OneLidar lidar;
  lidar.recordings.assign(arguments.sessions.begin(), arguments.sessions.end());
  lidar.topics.resize(lidar.recordings.size(), arguments.topics.choice());
  if (arguments.lidars.empty())
    return arguments.follow ? follow(arguments, console) : calibrate_one(arguments, lidar, console);
  if (arguments.follow) throw Error(ErrorCode::Contract, "--follow", say::cli_rig_option_of_one());
  if (!arguments.project.empty()) throw Error(ErrorCode::Contract, "--project", say::cli_project_of_one());
  if (arguments.sessions.empty()) throw Error(ErrorCode::Contract, "calibrate", say::cli_no_session());
  std::vector<ChosenLidar> chosen =
      choose_lidars(lidar.recordings, arguments.topics.choice(), arguments.lidars, console);
  if (chosen.size() > 1) return calibrate_several(arguments, std::move(chosen), console);
  OneLidar only{chosen.front().name, {}, {}};
  for (const ChosenLidar::Recording& recording : chosen.front().recordings) {
    only.recordings.push_back(lidar.recordings[recording.place]);
    only.topics.push_back(recording.topics);
  }
  CalibrateArguments of_one = arguments;
  give_measured_to_only(of_one.solve.measured, only.name);
  return calibrate_one(of_one, only, console);
}

}  // namespace

void add_calibrate(CLI::App& app, Console& console, Run& run) {
  const auto arguments = std::make_shared<CalibrateArguments>();
  CLI::App* verb = app.add_subcommand("calibrate", console.words(say::help_calibrate()));
  verb->add_option("sessions", arguments->sessions, console.words(say::help_sessions()))->type_name("SESSION");
  arguments->solve.add_to(*verb, console);
  arguments->topics.add_to(*verb, console);
  verb->add_option("--lidars", arguments->lidars, console.words(say::help_lidars()))->type_name("all|NAMES");
  std::vector<std::string> methods;
  std::vector<Message> needs;
  for (const method_registry::CalibrationMethod* method : method_registry::calibration_methods()) {
    methods.emplace_back(method->id);
    needs.push_back(say::help_method_needs(methods.back(), method->needs()));
  }
  verb->add_option("--method", arguments->method, console.words(say::help_method(in_one(std::move(needs)))))
      ->check(one_of(methods))
      ->type_name("NAME");
  verb->add_flag("--follow", arguments->follow, console.words(say::help_follow()));
  verb->add_option("--settled", arguments->settled_s, console.words(say::help_settled()))
      ->check(CLI::Range(0.1, 86400.0).description(""))
      ->capture_default_str()
      ->type_name("SECONDS");
  verb->add_option("--project", arguments->project, console.words(say::help_project()))->type_name("FILE");
  verb->add_option("--save-project", arguments->save_project, console.words(say::help_save_project()))
      ->type_name("FILE");
  verb->add_flag("--no-hashes", arguments->no_hashes, console.words(say::help_no_hashes()));
  verb->callback(
      [arguments, &console, &run] { run = [arguments, &console] { return calibrate(*arguments, console); }; });
}

}  // namespace remount::cli
