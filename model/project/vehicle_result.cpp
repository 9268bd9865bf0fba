#include "model/project/vehicle_result.h"

#include <cmath>

#include "model/project/project.h"
#include "remount_version.h"

namespace remount::project {
namespace {

results::RelativeRecord record_of(const calibration::RelativeMounting& two, const std::vector<rig::LidarOutput>& of) {
  results::RelativeRecord record;
  record.lidar_a = of.at(two.lidar_a).name;
  record.lidar_b = of.at(two.lidar_b).name;
  record.lidar_a_from_lidar_b = two.lidar_a_from_lidar_b;
  for (const calibration::Parameter parameter : calibration::kParameters) {
    const Eigen::Index row = calibration::row_of(parameter);
    if (two.observed.contains(parameter)) record.sigma[parameter] = std::sqrt(two.covariance(row, row));
  }
  record.height_m = two.height_m;
  record.height_sigma_m = two.height_sigma_m;
  return record;
}

}  // namespace

results::VehicleFile make_vehicle_file(const std::vector<rig::LidarJob>& jobs, const rig::RigOutput& output,
                                       std::vector<std::vector<results::InputFile>> inputs) {
  inputs.resize(jobs.size());
  results::VehicleFile vehicle;
  for (std::size_t l = 0; l < output.lidars.size(); ++l) {
    const rig::LidarOutput& lidar = output.lidars[l];
    vehicle.lidars.push_back(
        {lidar.name, lidar.joined, make_result_file(jobs.at(l).input, lidar.output, std::move(inputs.at(l)))});
  }
  for (const calibration::RelativeMounting& two : output.relatives)
    vehicle.relatives.push_back(record_of(two, output.lidars));
  for (const calibration::RigAgreement& two : output.agreements)
    vehicle.agreements.push_back({output.lidars.at(two.lidar_a).name, output.lidars.at(two.lidar_b).name,
                                  two.difference, two.sigma, two.most_sigmas});
  for (const std::vector<motion::LidarIndex>& group : output.groups) {
    vehicle.groups.emplace_back();
    for (const motion::LidarIndex lidar : group) vehicle.groups.back().push_back(output.lidars.at(lidar).name);
  }
  vehicle.findings = output.findings;
  vehicle.version = kVersion;
  return vehicle;
}

std::vector<std::vector<results::InputFile>> hash_lidars(const std::vector<rig::LidarJob>& jobs, int threads,
                                                         Progress& progress) {
  std::vector<std::shared_ptr<const drive::Session>> sessions;
  for (const rig::LidarJob& job : jobs)
    sessions.insert(sessions.end(), job.input.sessions.begin(), job.input.sessions.end());
  const std::vector<results::InputFile> all = results::hash_inputs(sessions, threads, progress);
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

}  // namespace remount::project
