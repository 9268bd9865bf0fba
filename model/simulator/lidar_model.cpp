#include "model/simulator/lidar_model.h"

#include <cmath>
#include <cstdio>

#include "algorithms/core/error.h"
#include "algorithms/geometry/rotation.h"
#include "model/simulator/range_scatter.h"

namespace remount::simulator {

using Eigen::Vector3d;

namespace {

// Where a beam looks that is believed to look along `believed`.
Vector3d looks_at(const LidarTruth& truth, const Firing& firing, const Vector3d& believed) {
  const double error_rad = truth.elevation_error_rad(firing.channel);
  const Vector3d looks =
      error_rad == 0.0 ? believed : direction_at(firing.azimuth_rad, firing.elevation_rad + error_rad);
  return truth.pointing.zero() ? looks : (looks + truth.pointing.aside(believed)).normalized();
}

}  // namespace

SimulatedScanSource::SimulatedScanSource(std::shared_ptr<const Scene> scene, SimulationOptions lidar)
    : scene_(std::move(scene)),
      options_(std::move(lidar)),
      pattern_(make_scan_pattern(options_)),
      truth_(draw_lidar_truth(options_, pattern_->channels())) {
  if (truth_.pointing.zero()) return;
  std::vector<Vector3d> directions;
  for (const Firing& firing : pattern_->firings(0))
    directions.push_back(direction_at(firing.azimuth_rad, firing.elevation_rad));
  truth_.pointing.take_out_turn(directions);
}

std::int64_t SimulatedScanSource::stamp_ns(std::size_t scan) const {
  return kDriveStart_ns + std::llround((scan_time_s(options_, scan) - options_.lidar_clock_offset_s) * 1e9);
}

std::string SimulatedScanSource::name(std::size_t scan) const {
  char text[32];
  std::snprintf(text, sizeof(text), "%06zu", scan);
  return text;
}

cloud::PointCloud SimulatedScanSource::empty_cloud(std::size_t most) const {
  cloud::PointCloud cloud;
  cloud.points.reserve(most);
  cloud.intensity.reserve(most);
  if (lidar_model(options_.lidar.model).has_rings) cloud.ring.reserve(most);
  if (options_.motion_distortion && options_.per_point_time) cloud.time_from_stamp_s.reserve(most);
  return cloud;
}

cloud::PointCloud SimulatedScanSource::load(std::size_t scan) const {
  const SimulationOptions& options = options_;
  if (scan >= size())
    throw Error(ErrorCode::Contract, name(scan),
                Message::verbatim("the drive has only " + std::to_string(size()) + " scans"));
  const double period_s = 1.0 / options.scan_rate_hz, stamp_s = scan_time_s(options, scan);
  const double at_stamp = stamp_share(options);
  const bool has_rings = lidar_model(options.lidar.model).has_rings;
  const bool with_time = options.motion_distortion && options.per_point_time;
  const std::vector<Firing> firings = pattern_->firings(scan);
  cloud::PointCloud cloud = empty_cloud(firings.size());
  RangeScatter scatter(options, scan);
  Surroundings around(*scene_, options, stamp_s);
  double last_share = -1.0;
  for (const Firing& firing : firings) {
    const double since_stamp = firing.share - at_stamp;  // of a period
    if (options.motion_distortion && firing.share != last_share) around.move_to(stamp_s + since_stamp * period_s);
    last_share = firing.share;
    const Vector3d believed = direction_at(firing.azimuth_rad, firing.elevation_rad);
    const auto found = scatter.next(around, looks_at(truth_, firing, believed));
    if (!found) continue;
    const double measured_m =
        truth_.measured_range_m(firing.channel, found->range_m) + truth_.range_field_m.at(believed) + found->noise_m;
    cloud.points.push_back((measured_m * believed).cast<float>());
    cloud.intensity.push_back(found->reflectance / (1.0f + 0.02f * static_cast<float>(found->range_m)));
    if (has_rings) cloud.ring.push_back(firing.channel);
    if (with_time) cloud.time_from_stamp_s.push_back(static_cast<float>(since_stamp * period_s));
  }
  return cloud;
}

}  // namespace remount::simulator
