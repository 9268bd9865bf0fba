// Scans for the accumulated map of a session, and one of them alone.
#include <algorithm>
#include <atomic>

#include "algorithms/core/error.h"
#include "algorithms/core/parallel.h"
#include "messages/pipeline.h"
#include "messages/stages.h"
#include "model/pipeline/as_solved_scans.h"
#include "model/pipeline/solve_stage.h"

namespace remount::pipeline {
namespace {

struct Stop {
  motion::Keyframe keyframe;
  RigidTransform local_from_ins = RigidTransform::Identity();
};

std::vector<Stop> stops_of(const DriveMotion& motion, const std::vector<motion::Keyframe>& keyframes,
                           motion::SessionIndex session) {
  std::vector<Stop> stops;
  for (const motion::Keyframe& keyframe : keyframes) {
    if (keyframe.session != session) continue;
    if (const auto pose = motion.local_from_ins(session, keyframe.stamp_ns)) stops.push_back({keyframe, *pose});
  }
  return stops;
}

/// Evenly, in the order in which the sensor measured.
std::vector<Eigen::Vector3f> thin(const std::vector<Eigen::Vector3f>& points, std::size_t most) {
  if (points.size() <= most) return points;
  std::vector<Eigen::Vector3f> kept(most);
  for (std::size_t i = 0; i < most; ++i) kept[i] = points[i * points.size() / most];
  return kept;
}

}  // namespace

cloud::PointCloud load_keyframe_scan(const PipelineInput& input, const PipelineOutput& output,
                                     motion::KeyframeIndex index, const Progress& progress) {
  const motion::Keyframe& keyframe = output.keyframes.at(index);
  if (!input.sessions.at(keyframe.session)->scans) return {};
  if (progress.cancelled()) return {};
  const DriveMotion motion = motion_as_solved(input, output);
  ScanStore store(motion, input.settings.registration, 0);
  compensate_as_solved(input, output, store);
  cloud::PointCloud cloud = store.load(keyframe, progress);
  return progress.cancelled() ? cloud::PointCloud{} : cloud;
}

SessionScans load_map_scans(const PipelineInput& input, const PipelineOutput& output, motion::SessionIndex session,
                            std::size_t most_points, Progress& progress) {
  SessionScans out;
  if (!input.sessions.at(session)->scans) return out;
  const DriveMotion motion = motion_as_solved(input, output);
  ScanStore store(motion, input.settings.registration, 0);
  compensate_as_solved(input, output, store);
  const std::vector<Stop> stops = stops_of(motion, output.keyframes, session);
  if (stops.empty()) return out;
  const std::size_t share = std::max<std::size_t>(1, most_points / stops.size());
  std::vector<std::vector<Eigen::Vector3f>> points(stops.size());
  std::vector<std::size_t> recorded(stops.size(), 0);
  std::vector<Message> failures(stops.size());
  std::atomic<std::size_t> done{0};
  parallel_for(stops.size(), input.threads, [&](std::size_t i) {
    if (progress.cancelled()) return;
    try {
      const cloud::PointCloud cloud = store.load(stops[i].keyframe);
      recorded[i] = cloud.size();
      points[i] = thin(cloud.points, share);
    } catch (const Error& error) {
      failures[i] = error.message();
    }
    progress.report(say::stage_reading_scans_for_the_map, ++done, stops.size());
  });
  if (progress.cancelled()) return {};
  out.origin_m = stops.front().local_from_ins.translation();
  for (std::size_t i = 0; i < stops.size(); ++i) {
    out.points_recorded += recorded[i];
    if (!failures[i].empty() && out.unreadable++ == 0) out.first_failure = failures[i];
    if (points[i].empty()) continue;
    out.scans.points_in_lidar.push_back(std::move(points[i]));
    out.scans.local_from_ins.push_back(stops[i].local_from_ins);
    // Near the origin floats are fine enough; the axes stay level.
    out.scans.local_from_ins.back().translation() -= out.origin_m;
  }
  if (out.unreadable == stops.size()) throw Error(ErrorCode::Io, {}, say::pipeline_map_not_readable(out.first_failure));
  return out;
}

}  // namespace remount::pipeline
