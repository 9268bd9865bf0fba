#include "model/conventions/metric_poses.h"

#include "algorithms/geodesy/local_level.h"

namespace remount::conventions {

MetricPoses::MetricPoses(const drive::Session& session) : ins_(&session.ins), from_file_(&session.world_from_ins) {
  if (session.ins.empty()) return;
  const motion::InsSample& first = session.ins.front();
  const geodesy::LocalLevel level(first.latitude_rad, first.longitude_rad, first.height_m);
  poses_.reserve(session.ins.size());
  for (const motion::InsSample& sample : session.ins) {
    const RigidTransform pose = level.enu_from_ins(sample);
    poses_.push_back({pose.translation(), Eigen::Quaternion<double, Eigen::DontAlign>(pose.linear())});
  }
}

}  // namespace remount::conventions
