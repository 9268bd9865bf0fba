#include "model/conventions/plane_poses.h"

#include <Eigen/Geometry>
#include <cmath>

#include "messages/poses.h"
#include "model/conventions/assumed_tilt.h"
#include "model/drive/bad_items.h"

namespace remount::conventions {
namespace {

struct PlaneOfPoses {
  bool one_height = true, level = true;
  double extent_m = 0.0;  ///< of the way, from end to end of its box
};

PlaneOfPoses plane_of(const std::vector<motion::StampedPose>& poses) {
  // What measures a height or a tilt finds it different in every sample.
  constexpr double kSameHeight_m = 1e-6, kLevel = 1e-5;
  PlaneOfPoses out;
  Eigen::AlignedBox3d box;
  for (const motion::StampedPose& pose : poses) {
    const Eigen::Vector3d up = pose.pose.linear().col(2);
    out.level = out.level && std::hypot(up.x(), up.y()) < kLevel;
    box.extend(pose.pose.translation());
  }
  out.one_height = box.sizes().z() < kSameHeight_m;
  out.extent_m = box.diagonal().norm();
  return out;
}

}  // namespace

void settle_plane(drive::Session& session) {
  constexpr std::size_t kFewest = 3;
  constexpr double kLeastWay_m = 5.0;  // a yard is as level as that
  if (session.world_from_ins.size() < kFewest) return;
  const PlaneOfPoses plane = plane_of(session.world_from_ins);
  if (plane.extent_m < kLeastWay_m || !(plane.one_height || plane.level)) return;
  session.ins_tilt_sigma_rad = kAssumedTilt_rad;
  if (plane.one_height) session.unmeasured_height_sigma_m = kAssumedTilt_rad * plane.extent_m;
  const Length extent{plane.extent_m};
  session.findings.push_back(drive::make_finding(drive::Severity::Warning, kPosesInPlane, drive::path_or_name(session),
                                                 !plane.level        ? say::poses_of_one_height(extent)
                                                 : !plane.one_height ? say::poses_level(extent)
                                                                     : say::poses_level_of_one_height(extent)));
}

}  // namespace remount::conventions
