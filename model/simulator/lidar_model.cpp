#include "model/simulator/lidar_model.h"

#include <cmath>
#include <cstdio>

#include "algorithms/core/error.h"
#include "model/simulator/random_stream.h"

namespace remount::simulator {

using Eigen::Vector3d;

namespace {

constexpr double kNearest_m = 0.5;           ///< shorter ranges are not measured
constexpr std::uint64_t kFirstStream = 100;  ///< streams below belong to the world and the INS

/// The cars at one time, ready for rays.
std::vector<BoxCaster> moving_boxes(const Scene& scene, double time_s, const Vector3d& from) {
  std::vector<BoxCaster> casters;
  for (const Box& box : scene.traffic().boxes_at(time_s, from.head<2>(), scene.options().max_range_m))
    casters.emplace_back(box);
  return casters;
}

}  // namespace

std::vector<double> beam_elevations_rad(int beams) {
  double low_deg = -25.0, high_deg = 15.0;
  if (beams <= 16) {
    low_deg = -15.0;
    high_deg = 15.0;
  } else if (beams <= 32) {
    low_deg = -30.0;
    high_deg = 10.0;
  } else if (beams <= 64) {
    low_deg = -24.8;
    high_deg = 2.0;
  }
  std::vector<double> elevations_rad;
  for (int i = 0; i < beams; ++i)
    elevations_rad.push_back(degrees_to_radians(beams == 1 ? 0.0 : low_deg + (high_deg - low_deg) * i / (beams - 1)));
  return elevations_rad;
}

SimulatedScanSource::SimulatedScanSource(std::shared_ptr<const Scene> scene)
    : scene_(std::move(scene)), elevations_rad_(beam_elevations_rad(scene_->options().beams)) {}

std::int64_t SimulatedScanSource::stamp_ns(std::size_t scan) const {
  return kDriveStart_ns +
         std::llround((scan_time_s(scene_->options(), scan) - scene_->options().lidar_clock_offset_s) * 1e9);
}

std::string SimulatedScanSource::name(std::size_t scan) const {
  char text[32];
  std::snprintf(text, sizeof(text), "%06zu", scan);
  return text;
}

cloud::PointCloud SimulatedScanSource::load(std::size_t scan) const {
  const SimulationOptions& options = scene_->options();
  if (scan >= size())
    throw Error(ErrorCode::Contract, name(scan),
                Message::verbatim("the drive has only " + std::to_string(size()) + " scans"));
  const double period_s = 1.0 / options.scan_rate_hz, stamp_s = scan_time_s(options, scan);
  RandomStream random(static_cast<std::uint64_t>(options.seed), kFirstStream + scan);
  cloud::PointCloud cloud;
  const std::size_t most = elevations_rad_.size() * static_cast<std::size_t>(options.azimuth_steps);
  cloud.points.reserve(most);
  cloud.intensity.reserve(most);
  cloud.ring.reserve(most);
  const bool with_time = options.motion_distortion && options.per_point_time;
  if (with_time) cloud.time_from_stamp_s.reserve(most);

  RigidTransform road_from_lidar = scene_->road_from_ins(stamp_s) * options.ins_from_lidar;
  std::vector<BoxCaster> cars = moving_boxes(*scene_, stamp_s, road_from_lidar.translation());
  std::vector<TiltedBox> arm = scene_->arm(stamp_s);
  for (int step = 0; step < options.azimuth_steps; ++step) {
    const double turn = (step + 0.5) / options.azimuth_steps - 0.5;            // of a whole turn, since the stamp
    const double azimuth_rad = (options.clockwise ? -2.0 : 2.0) * kPi * turn;  // ahead at the stamp
    if (options.motion_distortion) {
      road_from_lidar = scene_->road_from_ins(stamp_s + turn * period_s) * options.ins_from_lidar;
      cars = moving_boxes(*scene_, stamp_s + turn * period_s, road_from_lidar.translation());
      arm = scene_->arm(stamp_s + turn * period_s);
    }
    for (std::size_t beam = 0; beam < elevations_rad_.size(); ++beam) {
      const double flat = std::cos(elevations_rad_[beam]);
      const Vector3d direction_in_lidar(flat * std::cos(azimuth_rad), flat * std::sin(azimuth_rad),
                                        std::sin(elevations_rad_[beam]));
      const Ray ray{road_from_lidar.translation(), road_from_lidar.linear() * direction_in_lidar};
      RayHit hit = scene_->world().cast(ray, options.max_range_m);
      if (!hit.found()) hit.distance_m = options.max_range_m;
      for (const BoxCaster& car : cars) car.cast(ray, 1.0 / ray.direction.z(), hit);
      for (const TiltedBox& box : arm) cast_tilted_box(box, ray, hit);
      // Drawn for every firing, so that one object more or less does not change the noise of all others.
      const double noise_m = options.range_noise_m * random.normal();
      const bool lost = random.uniform() < options.dropout;
      if (lost || hit.distance_m >= options.max_range_m || hit.distance_m < kNearest_m) continue;
      cloud.points.push_back(((hit.distance_m + noise_m) * direction_in_lidar).cast<float>());
      cloud.intensity.push_back(hit.albedo / (1.0f + 0.02f * static_cast<float>(hit.distance_m)));
      cloud.ring.push_back(static_cast<std::uint16_t>(beam));
      if (with_time) cloud.time_from_stamp_s.push_back(static_cast<float>(turn * period_s));
    }
  }
  return cloud;
}

}  // namespace remount::simulator
