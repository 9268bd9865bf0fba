#include "model/pipeline/sharpness_stage.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "algorithms/core/parallel.h"
#include "algorithms/registration/voxel_grid.h"
#include "messages/pipeline.h"
#include "messages/places.h"
#include "messages/stages.h"

namespace remount::pipeline {
namespace {

constexpr std::size_t kStretches = 4, kScansOfStretch = 8, kCandidates = 5;
constexpr double kLongest_m = 40.0;  // farther apart, scans no longer see the same
constexpr float kVoxel_m = 0.15f;

struct Stretch {
  std::size_t first = 0;
  double turn_rad = 0.0;
};

// The stretches of consecutive keyframes of one session that turn most, without overlap, in the order of the drive.
std::vector<Stretch> turning_stretches(const StageContext& context, const std::vector<calibration::JointNode>& nodes) {
  const std::vector<motion::Keyframe>& keyframes = context.keyframes;
  std::vector<Stretch> all;
  for (std::size_t first = 0; first + kScansOfStretch <= keyframes.size(); ++first) {
    const std::size_t last = first + kScansOfStretch - 1;
    const bool one_session = keyframes[first].session == keyframes[last].session;
    if (!one_session || !context.motion.session(keyframes[first].session).scans) continue;
    if (keyframes[last].travelled_m - keyframes[first].travelled_m > kLongest_m) continue;
    Stretch stretch{first, 0.0};
    for (std::size_t k = first + 1; k <= last; ++k)
      stretch.turn_rad =
          std::max(stretch.turn_rad, rotation_angle_between_rad(nodes[first].local_from_ins, nodes[k].local_from_ins));
    all.push_back(stretch);
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Stretch& left, const Stretch& right) { return left.turn_rad > right.turn_rad; });
  std::vector<Stretch> chosen;
  for (const Stretch& stretch : all) {
    const bool free = std::none_of(chosen.begin(), chosen.end(), [&](const Stretch& other) {
      return stretch.first < other.first + kScansOfStretch && other.first < stretch.first + kScansOfStretch;
    });
    if (free && chosen.size() < kStretches) chosen.push_back(stretch);
  }
  return chosen;
}

quality::MapScans load_stretch(const StageContext& context, const ScanStore& scans,
                               const std::vector<calibration::JointNode>& nodes, std::size_t first,
                               const Progress& progress) {
  std::vector<std::vector<Eigen::Vector3f>> points(kScansOfStretch);
  parallel_for(kScansOfStretch, context.threads, [&](std::size_t i) {
    if (progress.cancelled()) return;
    try {
      points[i] = registration::voxel_centroids(scans.load(context.keyframes[first + i]).points, kVoxel_m, progress);
    } catch (const Error&) {
      // Reported where objects are found.
    }
  });
  quality::MapScans map;
  for (std::size_t i = 0; i < kScansOfStretch; ++i) {
    if (points[i].empty()) continue;
    map.points_in_lidar.push_back(std::move(points[i]));
    map.local_from_ins.push_back(nodes[first + i].local_from_ins);
  }
  return map;
}

}  // namespace

std::vector<quality::NamedSharpness> check_sharpness(const StageContext& context, const ScanStore& scans,
                                                     const calibration::CalibrationResult& result,
                                                     const std::optional<RigidTransform>& nominal_ins_from_lidar,
                                                     Progress& progress) {
  std::vector<quality::NamedSharpness> named{{calibration::MountingSource::Result, {}}};
  std::vector<RigidTransform> under{result.mounting.ins_from_lidar()};
  const auto add = [&](const calibration::MountingSource& source, const RigidTransform& ins_from_lidar) {
    named.push_back({source, {}});
    under.push_back(ins_from_lidar);
  };
  if (nominal_ins_from_lidar) add(calibration::MountingSource::Nominal, *nominal_ins_from_lidar);
  std::size_t listed = 0;
  for (const calibration::Candidate& candidate : result.candidates)
    if (candidate.in_range && listed < kCandidates) {
      add(candidate.source, candidate.ins_from_lidar);
      ++listed;
    }
  const std::vector<calibration::JointNode> nodes = context.motion.nodes(context.keyframes);
  std::vector<quality::MapScans> maps;
  for (const Stretch& stretch : turning_stretches(context, nodes)) {
    progress.report(say::stage_checking_the_map, maps.size(), kStretches);
    maps.push_back(load_stretch(context, scans, nodes, stretch.first, progress));
  }
  const std::vector<quality::MapSharpness> found =
      quality::compare_sharpness(maps, under, {}, context.threads, progress);
  if (found.front().points == 0) return {};  // nothing overlaps, or cancelled
  for (std::size_t i = 0; i < named.size(); ++i) named[i].sharpness = found[i];
  return named;
}

void take_sharpness(const StageContext& context, const ScanStore& scans,
                    const std::optional<RigidTransform>& nominal_ins_from_lidar, PipelineOutput& output,
                    Progress& progress) {
  if (!context.settings.run.map_check) {
    output.map_check = MapCheck::SwitchedOff;
    return;
  }
  output.sharpness = check_sharpness(context, scans, output.result, nominal_ins_from_lidar, progress);
  if (!output.sharpness.empty())
    output.map_check = MapCheck::Made;
  else
    output.map_check = progress.cancelled() ? MapCheck::NotReached : MapCheck::NoOverlap;
}

void forget_sharpness(PipelineOutput& output) {
  output.sharpness.clear();
  if (output.map_check == MapCheck::Made) output.map_check = MapCheck::Moved;
  std::erase_if(output.findings, [](const drive::Finding& finding) { return finding.code == kMapLessSharp; });
}

void report_sharpness(const std::vector<quality::NamedSharpness>& sharpness, std::vector<drive::Finding>& findings) {
  if (sharpness.size() < 2 || sharpness[1].source != calibration::MountingSource::Nominal) return;
  if (quality::compare(sharpness[0].sharpness, sharpness[1].sharpness) != quality::SharperUnder::Second) return;
  const double result_m = sharpness[0].sharpness.plane_thickness_m,
               nominal_m = sharpness[1].sharpness.plane_thickness_m;
  findings.push_back({drive::Severity::Warning, kMapLessSharp, say::place_map_check(),
                      say::pipeline_map_less_sharp(Length{result_m}, Length{nominal_m})});
}

}  // namespace remount::pipeline
