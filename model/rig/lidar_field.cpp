#include "model/rig/lidar_field.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "algorithms/core/index.h"

namespace remount::rig {

LidarField::LidarField(const std::vector<std::shared_ptr<const drive::Session>>& sessions, const Progress& progress) {
  constexpr std::size_t kScans = 8, kPointsOfScan = 50;
  for (const auto& session : sessions) {
    if (!session->scans) continue;
    const std::size_t size = session->scans->size(), count = std::min(kScans, size);
    for (std::size_t i = 0; i < count && !progress.cancelled(); ++i) {
      try {
        const std::vector<Eigen::Vector3f> points = session->scans->load((2 * i + 1) * size / (2 * count)).points;
        field_.add(points);
        const std::size_t kept = std::min(kPointsOfScan, points.size());
        for (std::size_t k = 0; k < kept; ++k) points_in_lidar_.push_back(points[k * points.size() / kept]);
      } catch (const Error&) {
        continue;  // named where it is used
      }
    }
    if (!empty()) break;  // one drive shows it
  }
  std::vector<float> ranges_m;
  for (const Eigen::Vector3f& point : points_in_lidar_) ranges_m.push_back(point.norm());
  if (ranges_m.empty()) return;
  const auto ninth = ranges_m.begin() + signed_of(ranges_m.size() * 9 / 10);
  std::nth_element(ranges_m.begin(), ninth, ranges_m.end());
  farthest_m_ = *ninth;
}

double LidarField::share_in(const LidarField& other, const RigidTransform& other_from_this) const {
  if (empty() || other.empty()) return 0.0;
  const Eigen::Isometry3f motion = other_from_this.cast<float>();
  const auto common = std::ranges::count_if(points_in_lidar_, [&](const Eigen::Vector3f& point) {
    const Eigen::Vector3f there = motion * point;
    return there.norm() <= other.farthest_m_ && other.field_.has_near(there);
  });
  return static_cast<double>(common) / static_cast<double>(points_in_lidar_.size());
}

}  // namespace remount::rig
