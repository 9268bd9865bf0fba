#include "app/cli/batch_job.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <new>
#include <optional>
#include <thread>

#include "algorithms/core/error.h"
#include "app/cli/arguments.h"
#include "app/cli/calibrate_vehicle.h"
#include "app/cli/finish.h"
#include "app/cli/sessions.h"
#include "messages/command_line.h"
#include "messages/fleet.h"
#include "messages/general.h"
#include "model/fleet/failed_job.h"
#include "model/fleet/job_state.h"
#include "model/formats/files/atomic_save.h"
#include "model/formats/files/file_lock.h"
#include "model/formats/files/input_file.h"
#include "model/methods/calibrate.h"
#include "model/project/project.h"
#include "model/project/vehicle_result.h"
#include "model/results/lidar_names.h"
#include "model/results/mounting_frames.h"

namespace remount::cli {
namespace {

/// Nothing where cancelled while waiting.
std::optional<formats::FileLock> wait_for_lock(const fleet::FleetJob& job, Console& console) {
  bool told = false;
  while (!console.cancelled()) {
    if (std::optional<formats::FileLock> lock = formats::FileLock::take(job.lock, formats::this_process())) return lock;
    if (!told) console.print(say::batch_waiting(formats::lock_holder(job.lock)));
    told = true;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return std::nullopt;
}

/// Temporary files of a process that was killed while it saved; nobody else saves here while the lock is held.
void sweep_leftovers(const fleet::FleetJob& job) {
  for (const std::filesystem::path& saved : {job.result, job.failure}) {
    const std::string begin = saved.filename().string() + ".";
    for (const std::filesystem::path& file : formats::files_in(saved.parent_path())) {
      const std::string name = file.filename().string();
      std::error_code none;
      if (name.starts_with(begin) && name.size() == begin.size() + 6) std::filesystem::remove(file, none);
    }
  }
}

pipeline::PipelineInput input_of(const fleet::FleetVehicle& vehicle, const fleet::FleetJob& job, Console& console) {
  pipeline::PipelineInput input;
  input.settings = vehicle.settings;
  input.threads = console.options().threads;
  SolveArguments arguments;
  if (!vehicle.nominal.empty()) arguments.nominals = {vehicle.nominal};
  const std::optional<results::ReadMounting> nominal = arguments.nominal_mounting(console);
  input.sessions = open_sessions(job.sessions, std::vector(job.sessions.size(), vehicle.topics), console);
  if (nominal) {
    input.nominal_ins_from_lidar = nominal_in_axes(*nominal, vehicle.nominal, input.sessions, console);
    input.nominal_frames = nominal->frames;
  } else if (vehicle.nominal.empty()) {
    input.nominal_ins_from_lidar = results::declared_nominal(input.sessions, *input.settings.run.method);
  }
  return input;
}

/// As `--nominal` takes those of these LiDARs. Throws Error.
std::vector<std::string> nominal_texts(const fleet::FleetVehicle& vehicle, const std::vector<std::string>& lidars) {
  std::vector<std::string> texts;
  if (!vehicle.nominal.empty() && vehicle.nominal != "none" && !formats::is_file(vehicle.nominal))
    throw Error(ErrorCode::Io, vehicle.nominal, say::fleet_nominal_by_names());
  if (!vehicle.nominal.empty()) texts.push_back(vehicle.nominal);
  for (const auto& [lidar, nominal] : vehicle.nominal_of_lidars)
    if (!results::lidar_meant_by(lidar, lidars).empty()) texts.push_back(lidar + "=" + nominal);
  return texts;
}

std::vector<rig::LidarJob> open_job(const fleet::FleetVehicle& vehicle, const fleet::FleetJob& job, Console& console) {
  if (job.lidars.empty()) return {{"", input_of(vehicle, job, console), {}}};
  VehicleJob several;
  several.recordings = job.sessions;
  several.settings = vehicle.settings;
  several.lidars = choose_lidars(job.sessions, vehicle.topics, job.lidars, console);
  if (several.lidars.size() > 1 && rig::measures_one_lidar(vehicle.settings))
    throw Error(ErrorCode::Contract, "settings.measured", say::fleet_measured_of_one(several.lidars.size()));
  std::vector<std::string> names;
  for (const ChosenLidar& lidar : several.lidars) names.push_back(lidar.name);
  several.nominals = named_nominals(nominal_texts(vehicle, names), names, console);
  for (const auto& [lidar, nominal] : vehicle.nominal_of_lidars)
    if (results::lidar_meant_by(lidar, names).empty()) console.warn(say::fleet_nominal_not_used(lidar));
  return open_lidars(several, console);
}

int cancelled(const fleet::FleetJob& job, Console& console) {
  console.complain(say::batch_cancelled(job.name));
  return kNoResult;
}

void forget_failure(const fleet::FleetJob& job) {
  std::error_code none;
  std::filesystem::remove(job.failure, none);
}

rig::RigOutput calibrate_lidars(const fleet::FleetJob& job, const std::vector<rig::LidarJob>& lidars,
                                Console& console) {
  if (!job.lidars.empty()) return rig::calibrate_rig(lidars, console.progress());
  rig::RigOutput output;
  output.lidars.push_back({"", methods::calibrate(lidars.front().input, console.progress())});
  return output;
}

int calibrate_job(const fleet::FleetJob& job, const std::vector<rig::LidarJob>& lidars, std::int64_t started_ns,
                  Console& console) {
  formats::check_can_save(job.result);
  std::vector<std::vector<results::InputFile>> inputs =
      project::hash_lidars(lidars, console.options().threads, console.progress());
  if (console.cancelled()) return cancelled(job, console);
  const rig::RigOutput output = calibrate_lidars(job, lidars, console);
  if (was_cancelled(output, console)) return cancelled(job, console);
  // Otherwise the hashes might be of other bytes than the result.
  if (const std::string file = fleet::file_written_since(lidars, started_ns); !file.empty())
    throw Error(ErrorCode::Io, file, say::batch_written_meanwhile());
  int code = kSolved;
  if (job.lidars.empty()) {
    const pipeline::PipelineOutput& only = output.lidars.front().output;
    console.report(only.findings);
    code = finish(project::make_result_file(lidars.front().input, only, std::move(inputs.front())), job.result.string(),
                  console);
  } else {
    code = finish_vehicle(lidars, output, std::move(inputs), job.result.string(), console);
  }
  forget_failure(job);
  return code;
}

/// "ok"; of several LiDARs "front ok, rear too_few_pairs".
std::string statuses_of(const results::VehicleFile& vehicle) {
  std::string text;
  for (const results::LidarResult& lidar : vehicle.lidars)
    text += (text.empty() ? "" : ", ") + lidar.name + (lidar.name.empty() ? "" : " ") +
            std::string(to_string(lidar.file.result.status));
  return text;
}

int stored_answer(const fleet::FleetJob& job, Console& console) {
  forget_failure(job);  // of a run before this result
  const results::VehicleFile vehicle = results::load_any_result(job.result);
  console.print(say::batch_done_already(job.name, statuses_of(vehicle), job.result.string()));
  return std::ranges::all_of(vehicle.lidars,
                             [](const auto& lidar) { return calibration::is_usable(lidar.file.result); })
             ? kSolved
             : kNoResult;
}

/// Beside that of a LiDAR by whose name it was chosen.
bool asked_for_topics(const results::LidarResult& lidar) {
  return std::ranges::any_of(lidar.file.topics, [&](const results::UsedTopics& used) {
    return std::ranges::any_of(used.asked,
                               [&](const auto& asked) { return lidar.name.empty() || asked.first != "lidar"; });
  });
}

/// The nominals that the fleet asks for of the LiDARs of a result. Those that it leaves to the sessions are the ones
/// that the result has, as long as their files are the same.
class AskedNominals {
 public:
  AskedNominals(const fleet::FleetVehicle& vehicle, const fleet::FleetJob& job, const results::VehicleFile& stored)
      : ignore_declared_(vehicle.nominal == "none") {
    const std::vector<std::string> names = results::lidar_names(stored);
    const bool only_one = names.front().empty();
    if (only_one != job.lidars.empty()) return;  // the result is another one in any case
    // What is doubtful about files was told when the job ran.
    if (!only_one)
      given_ = named_nominals(nominal_texts(vehicle, names), names).of;
    else if (!vehicle.nominal.empty() && !ignore_declared_)
      given_[""] = {parse_nominal(vehicle.nominal, untold_), vehicle.nominal};
  }

  std::optional<RigidTransform> of(const results::LidarResult& lidar) {
    const auto given = given_.find(lidar.name);
    if (given != given_.end()) return results::in_axes_of(given->second.mounting, lidar.file.ins_axes, untold_);
    return ignore_declared_ ? std::nullopt : lidar.file.nominal_ins_from_lidar;
  }
  /// Whether one was left to the sessions, and is there.
  bool left_open(const results::LidarResult& lidar) const {
    return !given_.contains(lidar.name) && !ignore_declared_ && lidar.file.nominal_ins_from_lidar;
  }

 private:
  std::map<std::string, NamedNominals::Nominal> given_;
  bool ignore_declared_;
  std::vector<Message> untold_;
};

}  // namespace

Message why_out_of_date(const fleet::Fleet& fleet, const fleet::FleetJob& job, const results::VehicleFile& stored,
                        Console& console) {
  const fleet::FleetVehicle& vehicle = fleet.vehicles.at(job.vehicle);
  try {
    AskedNominals nominals(vehicle, job, stored);
    Message other = fleet::why_other_job(job, vehicle, stored,
                                         [&](const results::LidarResult& lidar) { return nominals.of(lidar); });
    if (!other.empty()) return other;
    // The fleet's file may have had a nominal then, or topics that are left to be suggested now.
    const bool left_open = std::ranges::any_of(stored.lidars, [&](const results::LidarResult& lidar) {
      return nominals.left_open(lidar) || asked_for_topics(lidar);
    });
    const bool other_wish = left_open && fleet::written_since_result(fleet.path, job);
    if (!other_wish && !fleet::may_have_changed(job, stored)) return {};
    return fleet::why_not_done(job, open_job(vehicle, job, console), console.progress());
  } catch (const Error& error) {
    return error.message();
  }
}

int run_job(const fleet::Fleet& fleet, const fleet::FleetJob& job, Console& console) {
  fleet::make_job_folder(job);
  const std::optional<formats::FileLock> lock = wait_for_lock(job, console);
  if (!lock) return cancelled(job, console);
  sweep_leftovers(job);
  try {
    const std::vector<rig::LidarJob> lidars = open_job(fleet.vehicles.at(job.vehicle), job, console);
    const Message reason = fleet::why_not_done(job, lidars, console.progress());
    if (console.cancelled()) return cancelled(job, console);
    if (reason.empty()) return stored_answer(job, console);
    console.print(say::of_file(fleet::title_of(fleet, job), reason));
    return calibrate_job(job, lidars, lock->taken_ns(), console);
  } catch (const Error& error) {
    fleet::note_failure(fleet, job, error.message());
    throw;
  } catch (const std::bad_alloc&) {
    fleet::note_failure(fleet, job, say::cli_no_memory());
    throw;
  }
}

}  // namespace remount::cli
