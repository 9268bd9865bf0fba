#include "model/simulator/ins_model.h"

#include <GeographicLib/LocalCartesian.hpp>
#include <algorithm>
#include <cmath>
#include <utility>

#include "model/simulator/random_stream.h"

namespace remount {

using Eigen::Vector3d;

namespace {
constexpr double kMargin_s = 0.5;
constexpr std::uint64_t kInsStream = 10, kDriftStream = 11;

// Errors that walk randomly from sample to sample; zero where the drive starts.
std::vector<std::pair<Vector3d, Vector3d>> simulate_drift(const SimulationOptions& options, std::size_t count) {
  RandomStream random(static_cast<std::uint64_t>(options.seed), kDriftStream);
  const double position_step_m = options.ins_position_drift_m / std::sqrt(options.ins_rate_hz);
  const double attitude_step_rad = degrees_to_radians(options.ins_attitude_drift_deg) / std::sqrt(options.ins_rate_hz);
  std::vector<std::pair<Vector3d, Vector3d>> drift(count, {Vector3d::Zero(), Vector3d::Zero()});
  for (std::size_t i = 1; i < count; ++i)
    drift[i] = {drift[i - 1].first + position_step_m * random.normal3(),
                drift[i - 1].second + attitude_step_rad * random.normal3()};
  const auto start = drift[std::min(count - 1, static_cast<std::size_t>(kMargin_s * options.ins_rate_hz))];
  for (auto& [position_m, attitude_rad] : drift) {
    position_m -= start.first;
    attitude_rad -= start.second;
  }
  return drift;
}
}  // namespace

std::vector<InsSample> simulate_ins(const Scene& scene) {
  const SimulationOptions& options = scene.options();
  const GeographicLib::LocalCartesian start(options.latitude_deg, options.longitude_deg, options.height_m);
  RandomStream random(static_cast<std::uint64_t>(options.seed), kInsStream);
  const double attitude_sigma_rad = degrees_to_radians(options.ins_attitude_noise_deg);
  const Vector3d bias_rad = degrees_to_radians(options.ins_attitude_bias_deg) * random.normal3();
  const auto count =
      static_cast<std::size_t>(std::floor((options.duration_s + 2.0 * kMargin_s) * options.ins_rate_hz + 1e-6)) + 1;
  std::vector<InsSample> samples(count);
  const auto drift = simulate_drift(options, count);
  std::vector<double> rotation(9);
  for (std::size_t i = 0; i < count; ++i) {
    const double time_s = static_cast<double>(i) / options.ins_rate_hz - kMargin_s;
    const RigidTransform start_enu_from_ins = scene.enu_from_ins(time_s);
    const Vector3d position =
        start_enu_from_ins.translation() + drift[i].first + options.ins_position_noise_m * random.normal3();
    double latitude_deg = 0.0, longitude_deg = 0.0, height_m = 0.0;
    start.Reverse(position.x(), position.y(), position.z(), latitude_deg, longitude_deg, height_m, rotation);
    // Row-major; takes east, north, up here to those of the start.
    const Eigen::Matrix3d start_enu_from_here =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rotation.data());
    const Vector3d error_rad = bias_rad + drift[i].second + attitude_sigma_rad * random.normal3();
    InsSample& sample = samples[i];
    sample.stamp_ns = kDriveStart_ns + std::llround(time_s * 1e9);
    sample.latitude_rad = degrees_to_radians(latitude_deg);
    sample.longitude_rad = degrees_to_radians(longitude_deg);
    sample.height_m = height_m;
    sample.enu_from_ins =
        Eigen::Quaterniond(start_enu_from_here.transpose() * start_enu_from_ins.linear() * so3_exp(error_rad))
            .normalized();
    sample.quality = InsQuality::Good;
  }
  return samples;
}

}  // namespace remount
