#include "app/cli/calibrate_vehicle.h"

#include <algorithm>
#include <utility>

#include "algorithms/core/error.h"
#include "app/cli/finish.h"
#include "app/cli/sessions.h"
#include "app/cli/summary.h"
#include "messages/command_line.h"
#include "messages/rig.h"
#include "model/project/vehicle_result.h"
#include "model/rig/rig_findings.h"

namespace remount::cli {
namespace {

rig::LidarJob open_lidar(const ChosenLidar& lidar, const VehicleJob& vehicle, Console& console) {
  rig::LidarJob job;
  job.name = lidar.name;
  job.input.settings = vehicle.settings;
  job.input.threads = console.options().threads;
  std::vector<std::filesystem::path> paths;
  std::vector<drive::TopicChoice> topics;
  for (const ChosenLidar::Recording& recording : lidar.recordings) {
    paths.push_back(vehicle.recordings[recording.place]);
    topics.push_back(recording.topics);
    job.recordings.emplace_back(recording.place);
  }
  job.input.sessions = open_sessions(paths, topics, console);
  if (const auto nominal = vehicle.nominals.of.find(lidar.name); nominal != vehicle.nominals.of.end())
    job.input.nominal_ins_from_lidar =
        nominal_in_axes(nominal->second.mounting, nominal->second.text, job.input.sessions, console);
  else if (!vehicle.nominals.ignore_declared)
    job.input.nominal_ins_from_lidar = declared_nominal(job.input.sessions, *job.input.settings.run.method);
  job.input.tell_so_far = [&console, name = lidar.name](const Message& x) {
    console.print(say::rig_lidar_so_far(name, x));
  };
  return job;
}

/// Of each LiDAR. Streams that LiDARs share are in the list of each.
std::vector<std::vector<results::InputFile>> hash_all(const std::vector<rig::LidarJob>& jobs, Console& console) {
  Sessions sessions;
  for (const rig::LidarJob& job : jobs)
    sessions.insert(sessions.end(), job.input.sessions.begin(), job.input.sessions.end());
  const std::vector<results::InputFile> all =
      results::hash_inputs(sessions, console.options().threads, console.progress());
  std::vector<std::vector<results::InputFile>> of_lidars;
  auto next = all.begin();
  for (const rig::LidarJob& job : jobs) {
    std::ptrdiff_t files = 0;
    for (const auto& session : job.input.sessions) files += signed_of(session->files.size());
    of_lidars.emplace_back(next, next + files);
    next += files;
  }
  return of_lidars;
}

void print(const results::VehicleFile& vehicle, const std::vector<Message>& heights, Console& console) {
  const Language language = console.options().language;
  for (const results::LidarResult& lidar : vehicle.lidars) {
    console.print(say::rig_lidar_heading(lidar.name));
    console.report(lidar.file.findings);
    console.print_text(summary(lidar.file, language));
  }
  console.print(say::rig_relative_heading());
  console.report(vehicle.findings);
  console.print_text(relatives_summary(vehicle, heights, language));
}

/// @param cancelled before the LiDARs were solved together, which each of them may have a usable result without
int finish(const results::VehicleFile& vehicle, bool cancelled, const std::string& output, Console& console) {
  std::vector<std::string> without;
  for (const results::LidarResult& lidar : vehicle.lidars) {
    cancelled = cancelled || lidar.file.result.status == calibration::Status::Cancelled;
    if (!calibration::is_usable(lidar.file.result)) without.push_back(lidar.name);
  }
  const bool kept = keeps_old_file(cancelled, output, console);
  if (!output.empty() && !kept) results::save_vehicle(vehicle, output);
  if (!kept) console.print(output.empty() ? say::cli_result_not_written() : say::cli_result_written(output));
  if (without.empty() && !cancelled) return kSolved;
  console.complain(without.empty() ? say::cli_rig_cancelled() : say::rig_not_usable(std::move(without)));
  return kNoResult;
}

}  // namespace

int calibrate_vehicle(const VehicleJob& job, Console& console) {
  std::vector<rig::LidarJob> jobs;
  for (const ChosenLidar& lidar : job.lidars) jobs.push_back(open_lidar(lidar, job, console));
  const rig::RigOutput output = rig::calibrate_rig(jobs, console.progress());
  std::vector<std::vector<results::InputFile>> inputs;
  if (job.hashes) inputs = hash_all(jobs, console);
  const results::VehicleFile vehicle = project::make_vehicle_file(jobs, output, std::move(inputs));
  print(vehicle, rig::words_of_heights(output), console);
  return finish(vehicle, console.cancelled() && !output.solved, job.output, console);
}

}  // namespace remount::cli
