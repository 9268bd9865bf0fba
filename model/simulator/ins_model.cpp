#include "model/simulator/ins_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithms/core/stamps.h"
#include "model/simulator/local_earth.h"
#include "model/simulator/random_stream.h"

namespace remount::simulator {

using Eigen::Vector3d;

namespace {
constexpr std::uint64_t kInsStream = 10, kDriftStream = 11, kTroubleStream = 12;

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

/// What the options say about stretches in which the INS is worse than usual.
class Trouble {
 public:
  explicit Trouble(const SimulationOptions& options)
      : options_(options),
        drift_mps_(options.ins_trouble.degraded_drift_mps *
                   RandomStream(static_cast<std::uint64_t>(options.seed), kTroubleStream).normal3()) {}

  bool any_degraded() const { return options_.ins_trouble.degraded_s > 0.0; }
  bool degraded(double time_s) const { return degraded_for_s(time_s) > 0.0; }
  Vector3d error_m(double time_s) const { return degraded_for_s(time_s) * drift_mps_; }
  double sigma_m(double time_s) const {
    return std::hypot(options_.ins_position_noise_m, degraded_for_s(time_s) * options_.ins_trouble.degraded_drift_mps);
  }
  bool silent(std::int64_t stamp_ns) const {
    const double since_s = seconds(stamp_ns - kDriveStart_ns) - options_.ins_trouble.gap_start_s;
    return since_s >= 0.0 && since_s < options_.ins_trouble.gap_s;
  }

 private:
  double degraded_for_s(double time_s) const {
    const double since_s = time_s - options_.ins_trouble.degraded_start_s;
    return since_s > 0.0 && since_s <= options_.ins_trouble.degraded_s ? since_s : 0.0;
  }

  const SimulationOptions& options_;
  Vector3d drift_mps_;
};
}  // namespace

std::vector<motion::InsSample> simulate_ins(const Scene& scene) {
  const SimulationOptions& options = scene.options();
  const LocalEarth earth(options);
  RandomStream random(static_cast<std::uint64_t>(options.seed), kInsStream);
  const double attitude_sigma_rad = degrees_to_radians(options.ins_attitude_noise_deg);
  const Vector3d bias_rad = degrees_to_radians(options.ins_attitude_bias_deg) * random.normal3();
  const auto count =
      static_cast<std::size_t>(std::floor((options.duration_s + 2.0 * kMargin_s) * options.ins_rate_hz + 1e-6)) + 1;
  std::vector<motion::InsSample> samples(count);
  const auto drift = simulate_drift(options, count);
  const Trouble trouble(options);
  for (std::size_t i = 0; i < count; ++i) {
    const double time_s = static_cast<double>(i) / options.ins_rate_hz - kMargin_s;
    const RigidTransform start_enu_from_ins = scene.enu_from_ins(time_s);
    const Vector3d position =
        start_enu_from_ins.translation() + drift[i].first + options.ins_position_noise_m * random.normal3();
    const EarthPlace place = earth.at(position + trouble.error_m(time_s));
    const Vector3d error_rad = bias_rad + drift[i].second + attitude_sigma_rad * random.normal3();
    motion::InsSample& sample = samples[i];
    sample.stamp_ns = kDriveStart_ns + std::llround(time_s * 1e9);
    sample.latitude_rad = place.latitude_rad;
    sample.longitude_rad = place.longitude_rad;
    sample.height_m = place.height_m;
    sample.enu_from_ins =
        Eigen::Quaterniond(place.start_enu_from_here_enu.transpose() * start_enu_from_ins.linear() * so3_exp(error_rad))
            .normalized();
    sample.quality = trouble.degraded(time_s) ? motion::InsQuality::Degraded : motion::InsQuality::Good;
    if (trouble.any_degraded()) sample.sigma.position_enu_m.setConstant(trouble.sigma_m(time_s));
  }
  std::erase_if(samples, [&](const motion::InsSample& sample) { return trouble.silent(sample.stamp_ns); });
  return samples;
}

}  // namespace remount::simulator
