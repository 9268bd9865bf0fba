#include "app/cli/batch_job.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <optional>
#include <thread>

#include "algorithms/core/error.h"
#include "app/cli/arguments.h"
#include "app/cli/finish.h"
#include "app/cli/sessions.h"
#include "messages/command_line.h"
#include "messages/general.h"
#include "model/fleet/failed_job.h"
#include "model/fleet/job_state.h"
#include "model/formats/files/atomic_save.h"
#include "model/formats/files/file_lock.h"
#include "model/formats/files/input_file.h"
#include "model/methods/calibrate.h"
#include "model/project/project.h"

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
    input.nominal_ins_from_lidar = declared_nominal(input.sessions, *input.settings.run.method);
  }
  return input;
}

int cancelled(const fleet::FleetJob& job, Console& console) {
  console.complain(say::batch_cancelled(job.name));
  return kNoResult;
}

void forget_failure(const fleet::FleetJob& job) {
  std::error_code none;
  std::filesystem::remove(job.failure, none);
}

int calibrate_job(const fleet::FleetJob& job, const pipeline::PipelineInput& input, std::int64_t started_ns,
                  Console& console) {
  formats::check_can_save(job.result);
  std::vector<results::InputFile> inputs = results::hash_inputs(input.sessions, input.threads, console.progress());
  if (console.cancelled()) return cancelled(job, console);
  const pipeline::PipelineOutput output = methods::calibrate(input, console.progress());
  if (output.result.status == calibration::Status::Cancelled) return cancelled(job, console);
  // Otherwise the hashes might be of other bytes than the result.
  if (const std::string file = fleet::file_written_since(input.sessions, started_ns); !file.empty())
    throw Error(ErrorCode::Io, file, say::batch_written_meanwhile());
  console.report(output.findings);
  const int code = finish(project::make_result_file(input, output, std::move(inputs)), job.result.string(), console);
  forget_failure(job);
  return code;
}

int stored_answer(const fleet::FleetJob& job, Console& console) {
  forget_failure(job);  // of a run before this result
  const calibration::CalibrationResult result = results::load_result(job.result).result;
  console.print(say::batch_done_already(job.name, std::string(to_string(result.status)), job.result.string()));
  return calibration::is_usable(result) ? kSolved : kNoResult;
}

/// The nominal that the fleet asks for, in the axes of a result; where it leaves it to the sessions, theirs is the one
/// that the result has, as long as their files are the same.
std::optional<RigidTransform> asked_nominal(const fleet::FleetVehicle& vehicle, const results::ResultFile& stored) {
  if (vehicle.nominal.empty()) return stored.nominal_ins_from_lidar;
  if (vehicle.nominal == "none") return std::nullopt;
  std::vector<Message> doubts;  // were told when the job ran
  return results::in_axes_of(parse_nominal(vehicle.nominal, doubts), stored.ins_axes, doubts);
}

}  // namespace

Message why_out_of_date(const fleet::Fleet& fleet, const fleet::FleetJob& job, const results::ResultFile& stored,
                        Console& console) {
  const fleet::FleetVehicle& vehicle = fleet.vehicles.at(job.vehicle);
  try {
    Message other = fleet::why_other_job(stored, vehicle.settings, asked_nominal(vehicle, stored), vehicle.topics);
    if (!other.empty()) return other;
    // The fleet's file may have had a nominal then, or topics that are left to be suggested now.
    const bool left_open = (vehicle.nominal.empty() && stored.nominal_ins_from_lidar) ||
                           std::any_of(stored.topics.begin(), stored.topics.end(),
                                       [](const results::UsedTopics& used) { return !used.asked.empty(); });
    const bool other_wish = left_open && fleet::written_since_result(fleet.path, job);
    if (!other_wish && !fleet::may_have_changed(job, stored)) return {};
    return fleet::why_not_done(job, input_of(vehicle, job, console), console.progress());
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
    const pipeline::PipelineInput input = input_of(fleet.vehicles.at(job.vehicle), job, console);
    const Message reason = fleet::why_not_done(job, input, console.progress());
    if (console.cancelled()) return cancelled(job, console);
    if (reason.empty()) return stored_answer(job, console);
    console.print(say::of_file(fleet::title_of(fleet, job), reason));
    return calibrate_job(job, input, lock->taken_ns(), console);
  } catch (const Error& error) {
    fleet::note_failure(fleet, job, error.message());
    throw;
  } catch (const std::bad_alloc&) {
    fleet::note_failure(fleet, job, say::cli_no_memory());
    throw;
  }
}

}  // namespace remount::cli
