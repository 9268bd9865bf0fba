#include "model/pipeline/scan_store.h"

#include <algorithm>
#include <cmath>

#include "algorithms/cloud/deskew.h"
#include "algorithms/core/error.h"
#include "messages/pipeline.h"
#include "model/pipeline/scan_times.h"

namespace remount::pipeline {

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

cloud::PointCloud ScanStore::load(const motion::Keyframe& keyframe, const Progress& progress) const {
  const drive::Session& session = motion_.session(keyframe.session);
  if (!session.scans) throw Error(ErrorCode::Contract, session.name, say::pipeline_no_scans());
  cloud::PointCloud cloud = session.scans->load(keyframe.scan);
  cloud::mend_beams(beam_errors_, cloud);
  if (!compensation_ || cloud.points.empty() || progress.cancelled()) return cloud;
  const std::vector<float> times = told_times(session, cloud, sweeps_[keyframe.session]);
  if (times.empty()) return cloud;
  const auto passage = motion_.passage(keyframe.session, keyframe.stamp_ns);
  if (!passage) return cloud;
  const RigidTransform lidar_at_stamp_from_world = (passage->pose() * *compensation_).inverse();
  // Beyond the ends of the trajectory the last known motion is held: part of a sweep at most.
  const auto motion = [&](double time_s) {
    auto pose = passage->at(time_s);
    for (double known_s = time_s; !pose && std::abs(known_s) > 1e-4; pose = passage->at(known_s)) known_s *= 0.9;
    return pose ? RigidTransform(lidar_at_stamp_from_world * *pose * *compensation_) : RigidTransform::Identity();
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
