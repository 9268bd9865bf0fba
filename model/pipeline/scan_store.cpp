#include "model/pipeline/scan_store.h"

#include <algorithm>
#include <cmath>

#include "algorithms/cloud/deskew.h"
#include "algorithms/core/error.h"
#include "algorithms/core/index.h"
#include "messages/pipeline.h"
#include "model/pipeline/scan_gathering.h"
#include "model/pipeline/scan_times.h"

namespace remount::pipeline {
namespace {

template <class Value>
void append_column(const std::vector<Value>& more, std::size_t points, std::vector<Value>& column) {
  if (column.size() == points && !more.empty())
    column.insert(column.end(), more.begin(), more.end());
  else
    column.clear();
}

void append(const cloud::PointCloud& more, cloud::PointCloud& cloud) {
  cloud.dropped_points += more.dropped_points;
  if (more.points.empty()) return;
  append_column(more.intensity, cloud.size(), cloud.intensity);
  append_column(more.ring, cloud.size(), cloud.ring);
  cloud.points.insert(cloud.points.end(), more.points.begin(), more.points.end());
}

}  // namespace

void ScanStore::compensate_motion(const RigidTransform& ins_from_lidar, const std::vector<bool>& session_uses_sweep,
                                  const std::vector<drive::SweepModel>& sweeps) {
  compensation_ = ins_from_lidar;
  sweeps_.assign(session_uses_sweep.size(), std::nullopt);
  for (motion::SessionIndex s; s < sweeps_.size(); ++s) {
    if (!session_uses_sweep[s]) continue;
    const drive::Session& session = motion_.session(s);
    if (s < sweeps.size())
      sweeps_[s] = sweeps[s];
    else if (session.scan_timing == drive::ScanTiming::SweepAzimuth)
      sweeps_[s] = session.sweep;
  }
}

void ScanStore::gather(const RigidTransform& ins_from_lidar, const std::vector<int>& session_frames) {
  gathered_through_ = ins_from_lidar;
  session_frames_ = session_frames;
}

motion::GatheredFrames ScanStore::frames_of(motion::SessionIndex session) const {
  if (session >= session_frames_.size() || session_frames_[session] < 2) return {};
  return {index_at(session_frames_[session])};
}

cloud::PointCloud ScanStore::load(const motion::Keyframe& keyframe, const Progress& progress) const {
  cloud::PointCloud cloud = load_frame(keyframe, keyframe.scan, progress);
  const motion::GatheredFrames frames = frames_of(keyframe.session);
  if (frames.count < 2) return cloud;
  for (const motion::ScanIndex scan : gathered_scans(*motion_.session(keyframe.session).scans, keyframe, frames)) {
    if (scan == keyframe.scan) continue;
    if (progress.cancelled()) break;
    try {
      append(load_frame(keyframe, scan, progress), cloud);
    } catch (const Error&) {
      continue;  // one of several; where a keyframe's own cannot be read that is told
    }
  }
  cloud.time_from_stamp_s.clear();
  return cloud;
}

cloud::PointCloud ScanStore::load_frame(const motion::Keyframe& keyframe, motion::ScanIndex scan,
                                        const Progress& progress) const {
  const drive::Session& session = motion_.session(keyframe.session);
  if (!session.scans) throw Error(ErrorCode::Contract, session.name, say::pipeline_no_scans());
  cloud::PointCloud cloud =
      (beam_errors_ && session.scans_as_recorded ? session.scans_as_recorded : session.scans)->load(scan);
  if (beam_errors_) cloud::mend_beams(*beam_errors_, cloud);
  const bool is_own = scan == keyframe.scan;
  if ((!compensation_ && is_own) || cloud.points.empty() || progress.cancelled()) return cloud;
  std::vector<float> times;
  if (compensation_) times = told_times(session, cloud, sweeps_[keyframe.session]);
  if (times.empty() && is_own) return cloud;
  if (times.empty()) times.assign(cloud.size(), 0.0f);  // as a whole
  const std::int64_t stamp_ns = is_own ? keyframe.stamp_ns : session.scans->stamp_ns(scan);
  const auto passage = motion_.passage(keyframe.session, stamp_ns);
  if (!passage) return is_own ? cloud : cloud::PointCloud{};
  const auto pose_at_keyframe =
      is_own ? std::optional(passage->pose()) : motion_.local_from_ins(keyframe.session, keyframe.stamp_ns);
  if (!pose_at_keyframe) return {};
  const RigidTransform ins_from_lidar = compensation_.value_or(gathered_through_);
  const RigidTransform lidar_at_keyframe_from_world = (*pose_at_keyframe * ins_from_lidar).inverse();
  // Beyond the ends of the trajectory the last known motion is held: part of a sweep at most.
  const auto motion = [&](double time_s) {
    auto pose = passage->at(time_s);
    for (double known_s = time_s; !pose && std::abs(known_s) > 1e-4; pose = passage->at(known_s)) known_s *= 0.9;
    return pose ? RigidTransform(lidar_at_keyframe_from_world * *pose * ins_from_lidar) : RigidTransform::Identity();
  };
  return cloud::deskew(cloud, times, motion);
}

std::shared_ptr<const registration::PreparedCloud> ScanStore::prepare(const motion::Keyframe& keyframe,
                                                                      const std::vector<LidarBox>& boxes,
                                                                      const Progress& progress) const {
  const cloud::PointCloud cloud = progress.cancelled() ? cloud::PointCloud{} : load(keyframe, progress);
  std::vector<bool> left_out;
  if (!boxes.empty() && !progress.cancelled()) {
    left_out.assign(cloud.size(), false);
    for (std::size_t i = 0; i < cloud.size(); ++i)
      for (const LidarBox& box : boxes)
        if ((cloud.points[i].array() >= box.minimum.array()).all() &&
            (cloud.points[i].array() <= box.maximum.array()).all())
          left_out[i] = true;
  }
  if (progress.cancelled()) return std::make_shared<const registration::PreparedCloud>(cloud::PointCloud{}, options_);
  return std::make_shared<const registration::PreparedCloud>(cloud, options_, left_out, progress);
}

std::shared_ptr<const registration::PreparedCloud> ScanStore::prepare(motion::KeyframeIndex key,
                                                                      const motion::Keyframe& keyframe,
                                                                      const std::vector<LidarBox>& boxes,
                                                                      const Progress& progress) {
  std::promise<std::shared_ptr<const registration::PreparedCloud>> promise;
  Future future;
  bool mine = false;
  {
    const std::scoped_lock lock(mutex_);
    const auto found = ready_.find(key);
    if (found != ready_.end()) {
      future = found->second;
      recently_used_.remove(key);
    } else {
      mine = true;
      future = ready_[key] = promise.get_future().share();
    }
    recently_used_.push_front(key);
  }
  if (!mine) {
    const auto scan = future.get();
    // Null: whoever prepared it was cancelled.
    return scan ? scan : prepare(keyframe, boxes, progress);
  }
  try {
    auto scan = prepare(keyframe, boxes, progress);
    const std::scoped_lock lock(mutex_);
    if (progress.cancelled()) {
      ready_.erase(key);
      recently_used_.remove(key);
      promise.set_value(nullptr);
      return scan;
    }
    promise.set_value(scan);
    bytes_[key] = scan->bytes();
    total_bytes_ += scan->bytes();
    forget_oldest(key);
    return scan;
  } catch (...) {
    promise.set_exception(std::current_exception());  // other pairs of this scan fail with the same reason
    throw;
  }
}

void ScanStore::forget_oldest(motion::KeyframeIndex keep) {
  while (total_bytes_ > bound_bytes_ && recently_used_.size() > 1) {
    // A scan still being prepared has no size yet and stays.
    auto oldest = std::find_if(recently_used_.rbegin(), recently_used_.rend(),
                               [&](motion::KeyframeIndex key) { return key != keep && bytes_.contains(key); });
    if (oldest == recently_used_.rend()) return;
    const motion::KeyframeIndex key = *oldest;
    total_bytes_ -= bytes_[key];
    bytes_.erase(key);
    ready_.erase(key);
    recently_used_.remove(key);
  }
}

}  // namespace remount::pipeline
