#include "model/fleet/job_warnings.h"

#include <algorithm>

namespace remount::fleet {
namespace {

void count(const drive::Finding& finding, JobWarnings& warnings) {
  if (finding.severity == drive::Severity::Note) return;
  ++warnings.count;
  if (finding.severity == drive::Severity::Problem) warnings.problems.push_back(finding);
}

bool is_of_one(const drive::Finding& finding, const results::VehicleFile& vehicle) {
  return std::ranges::any_of(
      vehicle.lidars, [&](const results::LidarResult& lidar) { return finding.where == drive::Place(lidar.name); });
}

}  // namespace

JobWarnings warnings_in(const results::VehicleFile& vehicle) {
  JobWarnings warnings;
  for (const results::LidarResult& lidar : vehicle.lidars)
    for (const drive::Finding& finding : lidar.file.findings) count(finding, warnings);
  for (const drive::Finding& finding : vehicle.findings) count(finding, warnings);
  return warnings;
}

JobWarnings warnings_of(const results::VehicleFile& vehicle, const results::LidarResult& lidar) {
  JobWarnings warnings;
  for (const drive::Finding& finding : lidar.file.findings) count(finding, warnings);
  for (const drive::Finding& finding : vehicle.findings)
    if (finding.where == drive::Place(lidar.name) || !is_of_one(finding, vehicle)) count(finding, warnings);
  return warnings;
}

std::string name_of_problem(const drive::Finding& problem) {
  return english(problem.where) + " [" + problem.code + "]";
}

}  // namespace remount::fleet
