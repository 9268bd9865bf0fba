#include "algorithms/calibration/slew/slew_turn.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <unordered_map>

#include "algorithms/core/error.h"
#include "algorithms/registration/registration.h"
#include "messages/calibration.h"
#include "messages/stages.h"

namespace remount::calibration {
namespace {

// A pose at a stamp where an earlier pass has one.
std::optional<RigidTransform> pose_at(const std::vector<motion::StampedPose>& poses, std::int64_t stamp_ns) {
  const auto found =
      std::lower_bound(poses.begin(), poses.end(), stamp_ns,
                       [](const motion::StampedPose& pose, std::int64_t stamp) { return pose.stamp_ns < stamp; });
  if (found == poses.end() || found->stamp_ns != stamp_ns) return std::nullopt;
  return found->pose;
}

struct Direction {
  std::vector<std::pair<float, int>> ranges;  // range, scan
};

// A third of a degree: several points of a scan share a bin, neighbouring beams hardly do.
std::int64_t bin_of(const Eigen::Vector3f& point) {
  constexpr double kBin_rad = 0.0058;
  const double azimuth = std::atan2(point.y(), point.x());
  const double elevation = std::atan2(point.z(), std::hypot(point.x(), point.y()));
  return static_cast<std::int64_t>(std::floor(azimuth / kBin_rad)) * 100'000 +
         static_cast<std::int64_t>(std::floor(elevation / kBin_rad));
}

// The far range of a direction: what at least a quarter of the scans that see anything there lie beyond or at.
float background_m(const Direction& direction) {
  std::unordered_map<int, float> farthest;
  for (const auto& [range, scan] : direction.ranges) {
    auto& far = farthest[scan];
    far = std::max(far, range);
  }
  constexpr std::size_t kFewestScans = 3;
  if (farthest.size() < kFewestScans) return 0.0f;
  std::vector<float> ranges;
  for (const auto& [scan, range] : farthest) ranges.push_back(range);
  const auto quarter = ranges.begin() + static_cast<std::ptrdiff_t>(ranges.size() * 3 / 4);
  std::nth_element(ranges.begin(), quarter, ranges.end());
  return *quarter;
}

}  // namespace

TurnTrajectory turn_trajectory(const std::vector<std::int64_t>& stamps_ns, const LoadScan& load,
                               const registration::RegistrationOptions& options,
                               const std::vector<motion::StampedPose>& start, Progress& progress) {
  TurnTrajectory turn;
  std::shared_ptr<const registration::PreparedCloud> first, before;
  RigidTransform first_from_before = RigidTransform::Identity(), step = RigidTransform::Identity();
  const auto fits = [](const registration::RegistrationResult& result) {
    return result.quality.converged && result.quality.failure.empty();
  };
  for (std::size_t i = 0; i < stamps_ns.size() && !progress.cancelled(); ++i) {
    progress.report(say::stage_aligning_the_turn, i, stamps_ns.size());
    std::shared_ptr<const registration::PreparedCloud> scan;
    try {
      scan = std::make_shared<const registration::PreparedCloud>(load(i), options, std::vector<bool>{}, progress);
    } catch (const Error& error) {
      if (turn.failed++ == 0) turn.first_failure = error.message();
      continue;
    }
    if (progress.cancelled()) break;
    if (!first) {
      first = before = scan;
      turn.first_from_lidar.push_back({stamps_ns[i], RigidTransform::Identity()});
      turn.scans.push_back(i);
      continue;
    }
    RigidTransform guess = first_from_before * step;
    const std::optional<RigidTransform> known = pose_at(start, stamps_ns[i]);
    if (known) {
      guess = *known;
    } else {
      const registration::RegistrationResult link = registration::align_scans(*scan, *before, step, options, progress);
      if (fits(link)) guess = first_from_before * link.target_from_source;
    }
    const registration::RegistrationResult whole = registration::align_scans(*scan, *first, guess, options, progress);
    // Far from where the scan before leads it is another minimum, not the turn.
    constexpr double kMost_m = 0.5;
    const bool near = (whole.target_from_source.translation() - guess.translation()).norm() < kMost_m &&
                      rotation_angle_between_rad(whole.target_from_source, guess) < degrees_to_radians(5.0);
    if (!fits(whole) || !near) {
      if (turn.failed++ == 0)
        turn.first_failure = whole.quality.failure.empty() ? say::slew_scan_far() : whole.quality.failure;
      // The next one may fit again: it starts from here, by the scan before alone.
      step = first_from_before.inverse() * guess;
    } else {
      step = first_from_before.inverse() * whole.target_from_source;
      guess = whole.target_from_source;
      turn.first_from_lidar.push_back({stamps_ns[i], guess});
      turn.scans.push_back(i);
    }
    first_from_before = guess;
    before = scan;
  }
  return turn;
}

std::vector<Eigen::Vector3d> moving_points(const std::vector<cloud::PointCloud>& scans_in_lidar, double within_m) {
  std::unordered_map<std::int64_t, Direction> directions;
  for (std::size_t s = 0; s < scans_in_lidar.size(); ++s)
    for (const Eigen::Vector3f& point : scans_in_lidar[s].points)
      directions[bin_of(point)].ranges.push_back({point.norm(), static_cast<int>(s)});
  std::unordered_map<std::int64_t, float> background;
  for (const auto& [bin, direction] : directions) background[bin] = background_m(direction);
  std::vector<Eigen::Vector3d> moving;
  for (const cloud::PointCloud& scan : scans_in_lidar)
    for (const Eigen::Vector3f& point : scan.points) {
      const float range_m = point.norm(), far_m = background[bin_of(point)];
      // Ground seen at a flat angle spreads within a bin, the more the farther away.
      const float margin_m = std::max(0.4f, 0.06f * far_m);
      if (range_m <= within_m && far_m > 0.0f && range_m < far_m - margin_m) moving.push_back(point.cast<double>());
    }
  return moving;
}

}  // namespace remount::calibration
