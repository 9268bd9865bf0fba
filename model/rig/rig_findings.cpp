#include "model/rig/rig_findings.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "messages/rig.h"
#include "model/results/vehicle_file.h"

namespace remount::rig {
namespace {

// Two answers that differ by more than this contradict each other.
constexpr double kContradict = 4.0;

void add(drive::Severity severity, std::string_view code, const drive::Place& where, Message text, RigOutput& output) {
  output.findings.push_back({severity, std::string(code), where, std::move(text)});
}

void report_left_out(RigOutput& output) {
  for (const LidarOutput& lidar : output.lidars)
    if (!lidar.joined && !calibration::is_usable(lidar.output.result))
      add(drive::Severity::Warning, results::kLidarLeftOut, lidar.name, say::rig_left_out(lidar.output.result.message),
          output);
  for (const LidarOutput& lidar : output.lidars)
    if (lidar.drives_differ)
      add(drive::Severity::Problem, results::kLidarLeftOut, lidar.name,
          say::rig_moved_between_drives(*lidar.drives_differ), output);
  if (output.all_drives_differ)
    add(drive::Severity::Problem, "vehicle-drives-contradict", say::rig_all_lidars(),
        say::rig_all_moved_between_drives(), output);
  const auto usable = std::ranges::count_if(output.lidars, [](const LidarOutput& lidar) {
    return calibration::is_usable(lidar.output.result) && !lidar.drives_differ;
  });
  if (!output.solved && usable > 1)
    add(drive::Severity::Warning, results::kLidarsNotJoined, say::rig_all_lidars(), say::rig_not_solved(), output);
}

void report_single(RigOutput& output) {
  if (output.groups.size() < 2) return;
  for (const std::vector<motion::LidarIndex>& group : output.groups)
    if (group.size() == 1)
      add(drive::Severity::Note, "lidar-not-seen-by-others", output.lidars[group.front()].name,
          say::rig_shares_nothing(), output);
}

// The LiDAR that most contradictions have in common is named.
void report_contradictions(RigOutput& output) {
  std::map<motion::LidarIndex, int> counts;
  for (const calibration::RigAgreement& two : output.agreements)
    if (two.most_sigmas > kContradict) ++counts[two.lidar_a], ++counts[two.lidar_b];
  std::vector<drive::Finding> found;
  for (const calibration::RigAgreement& two : output.agreements) {
    if (!(two.most_sigmas > kContradict)) continue;
    const bool of_a = counts[two.lidar_a] > counts[two.lidar_b], of_b = counts[two.lidar_b] > counts[two.lidar_a];
    const std::string &a = output.lidars[two.lidar_a].name, &b = output.lidars[two.lidar_b].name;
    const Length apart{two.difference.head<3>().norm()};
    const Angle turned{two.difference.tail<3>().norm()};
    found.push_back({drive::Severity::Problem, std::string(results::kLidarsContradict), of_b ? b : a,
                     of_a || of_b ? say::rig_contradicts(of_b ? a : b, apart, turned, two.most_sigmas)
                                  : say::rig_contradict_each_other(b, apart, turned, two.most_sigmas)});
  }
  output.findings.insert(output.findings.end(), found.begin(), found.end());
}

bool height_known(const LidarOutput& lidar) { return lidar.output.result.estimate(calibration::Parameter::Z).observed; }

}  // namespace

std::vector<Message> words_of_heights(const RigOutput& output) {
  constexpr double kKnown_m = 0.3;  // as what counts as observed by default
  std::vector<Message> words;
  for (const std::vector<motion::LidarIndex>& group : output.groups) {
    if (group.size() < 2 ||
        std::ranges::any_of(group, [&](motion::LidarIndex l) { return height_known(output.lidars[l]); }))
      continue;
    std::vector<std::string> names;
    for (const motion::LidarIndex lidar : group) names.push_back(output.lidars[lidar].name);
    words.push_back(say::rig_common_height_unknown(names));
    for (const calibration::RelativeMounting& two : output.relatives)
      if (two.height_sigma_m < kKnown_m && std::ranges::find(group, two.lidar_a) != group.end() &&
          std::ranges::find(group, two.lidar_b) != group.end())
        words.push_back(say::rig_relative_height(output.lidars[two.lidar_b].name, output.lidars[two.lidar_a].name,
                                                 Length{two.height_m}, Length{two.height_sigma_m}));
  }
  return words;
}

void report_rig(RigOutput& output) {
  report_left_out(output);
  if (!output.solved) return;
  report_single(output);
  report_contradictions(output);
}

}  // namespace remount::rig
