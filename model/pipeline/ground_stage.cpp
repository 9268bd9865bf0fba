#include "model/pipeline/ground_stage.h"

#include <algorithm>
#include <cmath>

#include "algorithms/cloud/ground_fit.h"
#include "algorithms/core/error.h"
#include "algorithms/core/median.h"
#include "algorithms/core/parallel.h"
#include "algorithms/geometry/shortest_rotation.h"
#include "messages/pipeline.h"
#include "messages/places.h"

namespace remount::pipeline {
namespace {

constexpr std::size_t kMostGroundScans = 60, kFewestScans = 5;
constexpr double kRadius_m = 12.0;  // sparse sensors see no ground nearer than some seven metres

// Sigma of a median from the scatter about it.
double sigma_of_median(const std::vector<double>& values, double middle) {
  std::vector<double> distances;
  for (const double value : values) distances.push_back(std::abs(value - middle));
  constexpr double kToSigma = 1.4826, kOfMedian = 1.2533;
  return kOfMedian * kToSigma * median_of(distances) / std::sqrt(static_cast<double>(values.size()));
}

std::vector<std::size_t> spread_keyframes(const StageContext& context) {
  std::vector<std::size_t> with_scans, chosen;
  for (std::size_t k = 0; k < context.keyframes.size(); ++k)
    if (context.motion.session(context.keyframes[k].session).scans) with_scans.push_back(k);
  const std::size_t count = std::min(kMostGroundScans, with_scans.size());
  for (std::size_t i = 0; i < count; ++i) chosen.push_back(with_scans[i * with_scans.size() / count]);
  return chosen;
}

}  // namespace

std::optional<calibration::ObservedGround> observe_ground(const StageContext& context, const ScanStore& scans,
                                                          Progress& progress) {
  const std::vector<std::size_t> keyframes = spread_keyframes(context);
  std::vector<std::optional<cloud::GroundFit>> fits(keyframes.size());
  // Across the vehicle, not against gravity: on a hill both lean.
  const Eigen::Vector3f up = (context.ins_from_lidar.linear().transpose() * Eigen::Vector3d::UnitZ()).cast<float>();
  parallel_for(keyframes.size(), context.threads, [&](std::size_t i) {
    if (progress.cancelled()) return;
    try {
      fits[i] = cloud::fit_ground(scans.load(context.keyframes[keyframes[i]]), up, context.settings.objects, kRadius_m);
    } catch (const Error&) {
      // Reported where objects are found.
    }
  });
  std::vector<double> heights, first, second;
  const Eigen::Matrix3d level = shortest_rotation(Eigen::Vector3d(up.cast<double>()), Eigen::Vector3d::UnitZ());
  for (const auto& fit : fits) {
    if (!fit) continue;
    const Eigen::Vector3d normal = level * fit->up_in_lidar;
    heights.push_back(fit->lidar_height_m);
    first.push_back(normal.x());
    second.push_back(normal.y());
  }
  if (heights.size() < kFewestScans || progress.cancelled()) return std::nullopt;
  // Below a vehicle the road is no plane to the millimetre (crown, ruts), and beams hit it at a shallow angle.
  constexpr double kLeastHeight_m = 0.005, kLeastTilt_rad = 1e-3;
  calibration::ObservedGround plane;
  const double x = median_of(first), y = median_of(second);
  plane.up_in_lidar = level.transpose() * Eigen::Vector3d(x, y, std::sqrt(std::max(0.0, 1.0 - x * x - y * y)));
  plane.lidar_height_m = median_of(heights);
  plane.height_sigma_m = std::hypot(kLeastHeight_m, sigma_of_median(heights, plane.lidar_height_m));
  plane.up_sigma_rad = std::hypot(kLeastTilt_rad, std::max(sigma_of_median(first, x), sigma_of_median(second, y)));
  return plane;
}

void report_unseen_ground(PipelineOutput& output) {
  const bool told = std::any_of(output.findings.begin(), output.findings.end(),
                                [](const drive::Finding& finding) { return finding.code == "ground-not-seen"; });
  if (!told)
    output.findings.push_back(
        {drive::Severity::Warning, "ground-not-seen", say::place_scans(), say::pipeline_ground_not_seen()});
}

}  // namespace remount::pipeline
