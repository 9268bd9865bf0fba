#include "model/simulator/sensor_models.h"

#include <algorithm>
#include <cmath>

#include "model/simulator/body_motion.h"
#include "model/simulator/local_earth.h"
#include "model/simulator/random_stream.h"

namespace remount::simulator {

using Eigen::Vector3d;

namespace {

constexpr std::uint64_t kImuNoise = 20, kImuBias = 21, kGnssNoise = 22, kGnssOutliers = 23, kWheelNoise = 24,
                        kBarometerNoise = 25, kBarometerDrift = 26, kLastingSlip = 27;

RandomStream stream(const SimulationOptions& options, std::uint64_t number) {
  return {static_cast<std::uint64_t>(options.seed), number};
}

std::int64_t stamp_ns(double time_s) { return kDriveStart_ns + std::llround(time_s * 1e9); }

/// Times of a sensor's samples, s since the start of the drive.
std::vector<double> sample_times_s(const SimulationOptions& options, double rate_hz) {
  std::vector<double> times;
  if (rate_hz <= 0.0) return times;
  const auto count = static_cast<std::size_t>(std::floor((options.duration_s + 2.0 * kMargin_s) * rate_hz + 1e-6)) + 1;
  for (std::size_t i = 0; i < count; ++i) times.push_back(static_cast<double>(i) / rate_hz - kMargin_s);
  return times;
}

/// Biases that walk from where they start.
std::vector<ImuErrors> imu_biases(const SimulationOptions& options, std::size_t count) {
  RandomStream random = stream(options, kImuBias);
  const SimulatedImuOptions& imu = options.imu;
  std::vector<ImuErrors> biases(count);
  const double root_step = count > 0 ? std::sqrt(1.0 / imu.rate_hz) : 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3d gyro = random.normal3(), accelerometer = random.normal3();
    biases[i] =
        i == 0
            ? ImuErrors{degrees_to_radians(imu.gyro_bias_dps) * gyro, imu.accelerometer_bias_mps2 * accelerometer}
            : ImuErrors{
                  biases[i - 1].gyro_bias_radps + degrees_to_radians(imu.gyro_bias_walk_dps) * root_step * gyro,
                  biases[i - 1].accelerometer_bias_mps2 + imu.accelerometer_bias_walk_mps2 * root_step * accelerometer};
  }
  return biases;
}

/// Slip of one wheel that dies away and comes anew: a Gauss-Markov process of the first order.
class LastingSlip {
 public:
  explicit LastingSlip(const SimulatedWheelOptions& wheels)
      : sigma_(wheels.lasting_slip), kept_(std::exp(-1.0 / (wheels.rate_hz * wheels.lasting_slip_s))) {}

  /// Of the next sample; the first is drawn from the whole spread.
  double next(double normal) {
    slip_ = started_ ? kept_ * slip_ + std::sqrt(1.0 - kept_ * kept_) * sigma_ * normal : sigma_ * normal;
    started_ = true;
    return slip_;
  }

 private:
  double sigma_, kept_, slip_ = 0.0;
  bool started_ = false;
};

/// An error of `size_m` to twice that, in any direction.
Vector3d outlier_m(RandomStream& random, double size_m) {
  const Vector3d direction = random.normal3().normalized();
  return size_m * random.uniform(1.0, 2.0) * direction;
}

}  // namespace

SimulatedImu simulate_imu(const Scene& scene) {
  const SimulationOptions& options = scene.options();
  const std::vector<double> times = sample_times_s(options, options.imu.rate_hz);
  const RigidTransform vehicle_from_imu = scene.vehicle_from_ins() * options.imu.ins_from_imu;
  const LocalEarth earth(options);
  RandomStream random = stream(options, kImuNoise);
  SimulatedImu imu{{}, imu_biases(options, times.size())};
  for (std::size_t i = 0; i < times.size(); ++i) {
    const BodyMotion motion = body_motion(scene, vehicle_from_imu, times[i]);
    const EarthPlace place = earth.at(scene.enu_from_road() * motion.road_from_body.translation());
    const Vector3d up_in_road = scene.enu_from_road().linear().transpose() * place.start_enu_from_here_enu.col(2);
    const Vector3d force_in_road = motion.acceleration_in_road_mps2 + kSimulatedGravity_mps2 * up_in_road;
    const Vector3d gyro_noise = random.normal3(), accelerometer_noise = random.normal3();
    imu.samples.push_back({stamp_ns(times[i]),
                           motion.rate_in_body_radps + imu.errors[i].gyro_bias_radps +
                               degrees_to_radians(options.imu.gyro_noise_dps) * gyro_noise,
                           motion.road_from_body.linear().transpose() * force_in_road +
                               imu.errors[i].accelerometer_bias_mps2 +
                               options.imu.accelerometer_noise_mps2 * accelerometer_noise});
  }
  return imu;
}

SimulatedGnss simulate_gnss(const Scene& scene) {
  const SimulationOptions& options = scene.options();
  const SimulatedGnssOptions& gnss = options.gnss;
  const LocalEarth earth(options);
  RandomStream random = stream(options, kGnssNoise), outliers = stream(options, kGnssOutliers);
  constexpr double kLeastSigma_m = 1e-3;
  const Vector3d sigma_m(gnss.noise_m, gnss.noise_m, gnss.vertical_noise_m);
  const Vector3d stated_m = sigma_m.cwiseMax(kLeastSigma_m);
  SimulatedGnss receiver;
  for (const double time_s : sample_times_s(options, gnss.rate_hz)) {
    // Drawn for every fix, so that an outage or an outlier does not change the noise of all that follow.
    const Vector3d noise_m = sigma_m.cwiseProduct(random.normal3());
    const bool outlier = outliers.uniform() < gnss.outlier_share;
    const Vector3d gross_m = outlier_m(outliers, gnss.outlier_m);
    const double since_outage_s = time_s - gnss.outage_start_s;
    if (since_outage_s >= 0.0 && since_outage_s < gnss.outage_s) continue;
    const Vector3d antenna_in_enu = scene.enu_from_ins(time_s) * gnss.antenna_in_ins_m;
    const EarthPlace exact = earth.at(antenna_in_enu);
    const Vector3d error_m = noise_m + (outlier ? gross_m : Vector3d::Zero());
    const EarthPlace place = earth.at(antenna_in_enu + exact.start_enu_from_here_enu * error_m);
    receiver.fixes.push_back({stamp_ns(time_s), place.latitude_rad, place.longitude_rad, place.height_m,
                              Eigen::Matrix3d(stated_m.cwiseAbs2().asDiagonal())});
    if (outlier) receiver.outlier_stamps_ns.push_back(stamp_ns(time_s));
  }
  return receiver;
}

std::vector<motion::WheelSample> simulate_wheels(const Scene& scene) {
  const SimulationOptions& options = scene.options();
  const SimulatedWheelOptions& wheels = options.wheels;
  RandomStream random = stream(options, kWheelNoise), lasting = stream(options, kLastingSlip);
  LastingSlip left_slip(wheels), right_slip(wheels);
  std::vector<motion::WheelSample> samples;
  if (options.scenario == ScenarioKind::SlewYard) return samples;
  for (const double time_s : sample_times_s(options, wheels.rate_hz)) {
    const BodyMotion motion = body_motion(scene, RigidTransform::Identity(), time_s);
    const Vector3d velocity_in_vehicle = motion.road_from_body.linear().transpose() * motion.velocity_in_road_mps;
    const double turning_mps = 0.5 * kTrack_m * motion.rate_in_body_radps.z();
    const auto measured = [&](double true_mps, double scale, LastingSlip& lasting_slip) {
      const double slip = wheels.slip * random.normal() + lasting_slip.next(lasting.normal());
      const double noise_mps = wheels.noise_mps * random.normal();
      return true_mps * scale * (1.0 + slip) + noise_mps;
    };
    const double left_mps = measured(velocity_in_vehicle.x() - turning_mps, wheels.left_scale, left_slip);
    const double right_mps = measured(velocity_in_vehicle.x() + turning_mps, wheels.right_scale, right_slip);
    samples.push_back({stamp_ns(time_s), left_mps, right_mps});
  }
  return samples;
}

std::vector<motion::BarometerSample> simulate_barometer(const Scene& scene) {
  const SimulationOptions& options = scene.options();
  const SimulatedBarometerOptions& barometer = options.barometer;
  const LocalEarth earth(options);
  RandomStream noise = stream(options, kBarometerNoise), drift = stream(options, kBarometerDrift);
  std::vector<motion::BarometerSample> samples;
  double error_m = barometer.offset_m;
  for (const double time_s : sample_times_s(options, barometer.rate_hz)) {
    if (!samples.empty()) error_m += barometer.drift_m / std::sqrt(barometer.rate_hz) * drift.normal();
    const double height_m = earth.at(scene.enu_from_ins(time_s).translation()).height_m;
    samples.push_back({stamp_ns(time_s), height_m + error_m + barometer.noise_m * noise.normal()});
  }
  return samples;
}

}  // namespace remount::simulator
