#include "model/simulator/range_scatter.h"

#include <algorithm>
#include <cmath>

namespace remount::simulator {

using Eigen::Vector3d;

namespace {

// One stream for each scan; those below the first belong to the world and the other sensors.
constexpr std::uint64_t kNoiseStreams = 100, kEdgeStreams = std::uint64_t{1} << 32,
                        kRainStreams = std::uint64_t{2} << 32;

constexpr float kDropReflectance = 0.05f;
constexpr double kDropReach_m = 12.0;  ///< farther drops are too faint

/// One way, per metre, of light in rain: 1.076 R^0.67 dB/km (Carbonneau and Wisely 1998; ITU-R P.1814).
double extinction_per_m(double rate_mmph) { return 1.076 * std::pow(rate_mmph, 0.67) * std::log(10.0) / 10.0 / 1000.0; }

}  // namespace

Footprint look_at_footprint(const Surroundings& around, const Vector3d& direction_in_lidar, const RayHit& hit,
                            double divergence_rad) {
  constexpr double kSteepest = 5.67;  // tangent of 80 degrees: beyond it most light goes on
  // Two surfaces farther apart give two echoes, of which the sensor takes one; nearer ones are the roughness of one.
  constexpr double kResolved_m = 2.5, kSmooth_m = 0.2;
  const auto found = [&](double range_m) { return range_m < around.farthest_m(); };
  Footprint footprint{0.0, hit.distance_m, hit.distance_m};
  if (!found(hit.distance_m)) return footprint;
  const double half_rad = 0.5 * divergence_rad;
  const Vector3d across = direction_in_lidar.unitOrthogonal();
  double tangent2 = 0.0;
  for (const Vector3d& axis : {across, Vector3d(direction_in_lidar.cross(across))}) {
    const double a_m = around.cast((direction_in_lidar + half_rad * axis).normalized()).distance_m;
    const double b_m = around.cast((direction_in_lidar - half_rad * axis).normalized()).distance_m;
    const double step_m = std::min(std::abs(a_m - hit.distance_m), std::abs(b_m - hit.distance_m));
    tangent2 += std::pow(step_m / (half_rad * hit.distance_m), 2);
    if (!found(a_m) || !found(b_m) || std::abs(a_m + b_m - 2.0 * hit.distance_m) < kSmooth_m) continue;
    const auto [near_m, far_m] = std::minmax({a_m, hit.distance_m, b_m});
    if (far_m - near_m > std::max(kSmooth_m, footprint.far_m - footprint.near_m) && far_m - near_m < kResolved_m) {
      footprint.near_m = near_m;
      footprint.far_m = far_m;
    }
  }
  footprint.tan_incidence = std::min(std::sqrt(tangent2), kSteepest);
  return footprint;
}

double range_sigma_m(const SimulationOptions& options, double range_m, double reflectance, double tan_incidence) {
  // The divergence is the full angle at 1/e^2, which is four sigma of a Gaussian beam.
  constexpr double kSigmas = 4.0, kDark = 0.1, kDarkest = 0.02;
  const double smeared_m = range_m * 1e-3 * options.lidar_errors.divergence_mrad * tan_incidence / kSigmas;
  // Light from a surface goes with its reflectance, and its noise with the root of the light.
  const double dark_m = options.lidar_errors.dark_noise_m * std::sqrt(kDark / std::max(reflectance, kDarkest));
  const double more2 = smeared_m * smeared_m + dark_m * dark_m;
  return more2 > 0.0 ? std::sqrt(options.range_noise_m * options.range_noise_m + more2) : options.range_noise_m;
}

double rain_loss_share(double rate_mmph, double range_m) {
  return -std::expm1(-2.0 * extinction_per_m(rate_mmph) * range_m);
}

double rain_drop_share(double rate_mmph) {
  constexpr double kSeen = 0.3;  // of the drops that a beam meets
  return kSeen * rain_loss_share(rate_mmph, kDropReach_m);
}

RangeScatter::RangeScatter(const SimulationOptions& options, std::size_t scan)
    : options_(options),
      noise_(static_cast<std::uint64_t>(options.seed), kNoiseStreams + scan),
      edges_(static_cast<std::uint64_t>(options.seed), kEdgeStreams + scan),
      rain_(static_cast<std::uint64_t>(options.seed), kRainStreams + scan) {}

void RangeScatter::mix(const Footprint& footprint, RayHit& hit) {
  const bool mixed = edges_.uniform() < options_.lidar_errors.mixed_pixels;
  const double share = edges_.uniform();
  if (mixed && footprint.on_edge()) hit.distance_m = footprint.near_m + share * (footprint.far_m - footprint.near_m);
}

bool RangeScatter::rain_takes(RayHit& hit) {
  const double rate_mmph = options_.lidar_errors.rain_mmph;
  const bool lost = rain_.uniform() < rain_loss_share(rate_mmph, hit.distance_m);
  const bool drop = rain_.uniform() < rain_drop_share(rate_mmph);
  // Light comes back from a drop with the inverse square of its distance.
  const double nearest = 1.0 / kNearestRange_m, farthest = 1.0 / kDropReach_m;
  const double drop_m = 1.0 / (nearest - rain_.uniform() * (nearest - farthest));
  if (!drop || drop_m >= hit.distance_m) return lost;
  hit = {drop_m, kDropReflectance};
  return false;
}

std::optional<RangeScatter::Return> RangeScatter::next(const Surroundings& around, const Vector3d& direction_in_lidar) {
  RayHit hit = around.cast(direction_in_lidar);
  double tan_incidence = 0.0;
  if (const double divergence_mrad = options_.lidar_errors.divergence_mrad; divergence_mrad > 0.0) {
    const Footprint footprint = look_at_footprint(around, direction_in_lidar, hit, 1e-3 * divergence_mrad);
    tan_incidence = footprint.tan_incidence;
    mix(footprint, hit);
  }
  const double noise = noise_.normal();
  bool lost = noise_.uniform() < options_.dropout;
  if (options_.lidar_errors.rain_mmph > 0.0 && rain_takes(hit)) lost = true;
  if (lost || hit.distance_m >= around.farthest_m() || hit.distance_m < kNearestRange_m) return std::nullopt;
  const double sigma_m = range_sigma_m(options_, hit.distance_m, static_cast<double>(hit.albedo), tan_incidence);
  return Return{hit.distance_m, sigma_m * noise, hit.albedo};
}

}  // namespace remount::simulator
