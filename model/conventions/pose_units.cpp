#include "model/conventions/pose_units.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "algorithms/core/error.h"
#include "algorithms/core/median.h"
#include "algorithms/core/stamps.h"
#include "algorithms/geodesy/earth_radius.h"
#include "algorithms/geometry/rotation.h"
#include "messages/checks.h"
#include "model/drive/session.h"

namespace remount::conventions {
namespace {

constexpr double kSlowestDrive_mps = 0.3, kFastestDrive_mps = 100.0;  // of a drive in degrees or radians

/// How poses move from second to second, as their numbers say.
struct Pace {
  double speed = 0.0;       ///< median over the seconds that move, horizontally
  double way = 0.0;         ///< sum of them
  double climbed = 0.0;     ///< sum of what z changes by
  double turned_rad = 0.0;  ///< sum about any axis
};

Pace pace_of(const std::vector<motion::StampedPose>& poses) {
  constexpr std::int64_t kSecond_ns = 1'000'000'000;
  Pace pace;
  std::vector<double> speeds;
  std::size_t from = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    if (poses[i].stamp_ns - poses[from].stamp_ns < kSecond_ns) continue;
    const double time_s = seconds(poses[i].stamp_ns - poses[from].stamp_ns);
    const Eigen::Vector3d step = poses[i].pose.translation() - poses[from].pose.translation();
    const double way = step.head<2>().norm();
    if (way > 0.0) speeds.push_back(way / time_s);
    pace.way += way;
    pace.climbed += std::abs(step.z());
    pace.turned_rad += rotation_angle_between_rad(poses[from].pose, poses[i].pose);
    from = i;
  }
  if (!speeds.empty()) pace.speed = median_of(std::move(speeds));
  return pace;
}

bool all_within(const std::vector<motion::StampedPose>& poses, double first, double second) {
  return std::all_of(poses.begin(), poses.end(), [&](const motion::StampedPose& pose) {
    const Eigen::Vector3d at = pose.pose.translation();
    return std::abs(at.x()) <= first && std::abs(at.y()) <= second;
  });
}

/// What else says that the vehicle went somewhere while its numbers hardly change.
bool has_moved(const Pace& pace, const drive::Session& session) {
  constexpr double kTurned_rad = 0.35, kMuchMore = 5.0, kLidarWay_m = 5.0;
  if (pace.turned_rad > kTurned_rad || pace.climbed > kMuchMore * pace.way) return true;
  return pace_of(session.odometry_from_lidar).way > kLidarWay_m;
}

/// @param radians in one unit of the numbers
bool are_angles(const drive::Session& session, const Pace& pace, double radians) {
  constexpr double kWay_m = 5.0;
  const double metres = geodesy::kEarthRadius_m * radians, quarter = 0.5 * kPi / radians, half = kPi / radians;
  const auto& poses = session.world_from_ins;
  if (!all_within(poses, quarter, half) && !all_within(poses, half, quarter)) return false;
  // As metres, the whole drive would fit on a table; as angles it is one.
  constexpr double kTable_m = 0.5;
  return pace.way < kTable_m && pace.way * metres > kWay_m && pace.speed * metres > kSlowestDrive_mps &&
         pace.speed * metres < kFastestDrive_mps && has_moved(pace, session);
}

/// From the middle of the earth to its surface, and not the numbers of UTM, whose heights are small.
bool are_earth_centred(const std::vector<motion::StampedPose>& poses) {
  constexpr double kLeast_m = 6.33e6, kMost_m = 6.42e6, kHighest_m = 1e4;
  return std::all_of(poses.begin(), poses.end(), [](const motion::StampedPose& pose) {
    const Eigen::Vector3d at = pose.pose.translation();
    const bool on_grid = std::abs(at.z()) < kHighest_m && at.x() > 1e5 && at.x() < 9e5 && at.y() > 0.0;
    return at.norm() > kLeast_m && at.norm() < kMost_m && !on_grid;
  });
}

}  // namespace

void refuse_foreign_units(const drive::Session& session) {
  const std::vector<motion::StampedPose>& poses = session.world_from_ins;
  if (poses.size() < 2) return;
  const std::string where = drive::path_or_name(session);
  if (are_earth_centred(poses)) throw Error(ErrorCode::Format, where, say::poses_earth_centred());
  const Pace pace = pace_of(poses);
  if (are_angles(session, pace, kPi / 180.0)) throw Error(ErrorCode::Format, where, say::poses_in_degrees());
  if (are_angles(session, pace, 1.0)) throw Error(ErrorCode::Format, where, say::poses_in_radians());
}

}  // namespace remount::conventions
