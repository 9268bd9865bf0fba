#include "app/cli/calibrate_vehicle.h"

#include <algorithm>
#include <utility>

#include "algorithms/core/error.h"
#include "app/cli/arguments.h"
#include "app/cli/finish.h"
#include "app/cli/sessions.h"
#include "app/cli/summary.h"
#include "messages/command_line.h"
#include "messages/rig.h"
#include "model/project/vehicle_result.h"
#include "model/results/mounting_frames.h"
#include "model/rig/rig_findings.h"

namespace remount::cli {
namespace {

rig::LidarJob open_lidar(const ChosenLidar& lidar, const VehicleJob& vehicle, Console& console) {
  rig::LidarJob job;
  job.name = lidar.name;
  job.input.settings = vehicle.settings;
  job.input.threads = console.options().threads;
  if (const auto measured = vehicle.measured.find(lidar.name); measured != vehicle.measured.end())
    for (const std::string& text : measured->second) apply_measured(job.input.settings.measured, text);
  std::vector<std::filesystem::path> paths;
  std::vector<drive::TopicChoice> topics;
  for (const ChosenLidar::Recording& recording : lidar.recordings) {
    paths.push_back(vehicle.recordings[recording.place]);
    topics.push_back(recording.topics);
    job.recordings.emplace_back(recording.place);
  }
  job.input.sessions = open_sessions(paths, topics, console);
  if (const auto nominal = vehicle.nominals.of.find(lidar.name); nominal != vehicle.nominals.of.end()) {
    job.input.nominal_ins_from_lidar =
        nominal_in_axes(nominal->second.mounting, nominal->second.text, job.input.sessions, console);
    job.input.nominal_frames = nominal->second.mounting.frames;
  } else if (!vehicle.nominals.ignore_declared) {
    job.input.nominal_ins_from_lidar = results::declared_nominal(job.input.sessions, *job.input.settings.run.method);
  }
  job.input.tell_so_far = [&console, name = lidar.name](const Message& x) {
    console.print(say::rig_lidar_so_far(name, x));
  };
  return job;
}

void print(const results::VehicleFile& vehicle, const std::vector<Message>& heights, Console& console) {
  const Language language = console.options().language;
  for (const results::LidarResult& lidar : vehicle.lidars) {
    console.print(say::rig_lidar_heading(lidar.name));
    console.report(lidar.file.findings);
    console.print_text(summary(lidar.file, language));
  }
  if (vehicle.lidars.size() > 1) console.print(say::rig_relative_heading());
  console.report(vehicle.findings);
  console.print_text(relatives_summary(vehicle, heights, language));
}

}  // namespace

std::vector<rig::LidarJob> open_lidars(const VehicleJob& job, Console& console) {
  std::vector<rig::LidarJob> lidars;
  for (const ChosenLidar& lidar : job.lidars) lidars.push_back(open_lidar(lidar, job, console));
  return lidars;
}

bool was_cancelled(const rig::RigOutput& output, const Console& console) {
  return (output.lidars.size() > 1 && console.cancelled() && !output.solved) ||
         std::ranges::any_of(output.lidars, [](const rig::LidarOutput& lidar) {
           return lidar.output.result.status == calibration::Status::Cancelled;
         });
}

int finish_vehicle(const std::vector<rig::LidarJob>& lidars, const rig::RigOutput& output,
                   std::vector<std::vector<results::InputFile>> inputs, const std::string& path, Console& console) {
  const results::VehicleFile vehicle = project::make_vehicle_file(lidars, output, std::move(inputs));
  print(vehicle, rig::words_of_heights(output), console);
  std::vector<std::string> without;
  for (const results::LidarResult& lidar : vehicle.lidars)
    if (!calibration::is_usable(lidar.file.result)) without.push_back(lidar.name);
  const bool cancelled = was_cancelled(output, console), kept = keeps_old_file(cancelled, path, console);
  if (!path.empty() && !kept) results::save_vehicle(vehicle, path);
  if (!kept) console.print(path.empty() ? say::cli_result_not_written() : say::cli_result_written(path));
  if (without.empty() && !cancelled) return kSolved;
  console.complain(without.empty() ? say::cli_rig_cancelled() : say::rig_not_usable(std::move(without)));
  return kNoResult;
}

int calibrate_vehicle(const VehicleJob& job, Console& console) {
  const std::vector<rig::LidarJob> lidars = open_lidars(job, console);
  const rig::RigOutput output = rig::calibrate_rig(lidars, console.progress());
  std::vector<std::vector<results::InputFile>> inputs;
  if (job.hashes) inputs = project::hash_lidars(lidars, console.options().threads, console.progress());
  return finish_vehicle(lidars, output, std::move(inputs), job.output, console);
}

}  // namespace remount::cli
