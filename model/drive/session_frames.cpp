#include "model/drive/session_frames.h"

#include <algorithm>

#include "algorithms/geodesy/local_level.h"

namespace remount::drive {

std::optional<InsAxes> common_axes(const std::vector<std::shared_ptr<const Session>>& sessions) {
  if (sessions.empty()) return std::nullopt;
  const auto told =
      std::find_if(sessions.begin(), sessions.end(), [](const auto& session) { return session->ins_axes_by_travel; });
  const auto& axes = (told == sessions.end() ? sessions.front() : *told)->ins_axes;
  const bool same = std::all_of(sessions.begin(), sessions.end(), [&](const auto& session) {
    return session->ins_axes == axes || (told != sessions.end() && !session->ins_axes_by_travel);
  });
  return same ? axes : std::nullopt;
}

RigidTransform forward_left_up_from(const std::optional<InsAxes>& axes) {
  RigidTransform turned = RigidTransform::Identity();
  if (axes == InsAxes::RightForwardUp) turned.linear() << 0, 1, 0, -1, 0, 0, 0, 0, 1;
  if (axes == InsAxes::BackwardRightUp) turned.linear() << -1, 0, 0, 0, -1, 0, 0, 0, 1;
  if (axes == InsAxes::LeftBackwardUp) turned.linear() << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  return turned;
}

std::vector<motion::StampedPose> metric_poses(const Session& session) {
  if (session.ins.empty()) return session.world_from_ins;
  const motion::InsSample& first = session.ins.front();
  const geodesy::LocalLevel level(first.latitude_rad, first.longitude_rad, first.height_m);
  std::vector<motion::StampedPose> poses;
  poses.reserve(session.ins.size());
  for (const motion::InsSample& sample : session.ins) poses.push_back({sample.stamp_ns, level.enu_from_ins(sample)});
  return poses;
}

RigidTransform vehicle_from_ins(const std::vector<std::shared_ptr<const Session>>& sessions) {
  return forward_left_up_from(common_axes(sessions));
}

}  // namespace remount::drive
