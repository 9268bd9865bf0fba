// What the simulated vehicle's IMU, GNSS receiver, wheels and barometer report.
#pragma once

#include <vector>

#include "algorithms/motion/sensor_samples.h"
#include "model/simulator/scene.h"

namespace remount::simulator {

/// Standard gravity, along the vertical of the place where the vehicle is. The turning of the Earth is left out: a
/// gyroscope at rest reads its bias.
inline constexpr double kSimulatedGravity_mps2 = 9.80665;

struct ImuErrors {
  Eigen::Vector3d gyro_bias_radps = Eigen::Vector3d::Zero();
  Eigen::Vector3d accelerometer_bias_mps2 = Eigen::Vector3d::Zero();
};

struct SimulatedImu {
  std::vector<motion::ImuSample> samples;
  std::vector<ImuErrors> errors;  ///< the biases within each sample
};

struct SimulatedGnss {
  std::vector<motion::GnssFix> fixes;
  std::vector<std::int64_t> outlier_stamps_ns;
};

// All from half a second before the drive to half a second after it; empty where the rate is 0. Noise of one sensor
// does not depend on the others.
SimulatedImu simulate_imu(const Scene& scene);
/// The stated covariance is that of the noise, and at least a square millimetre: no receiver claims to be exact.
SimulatedGnss simulate_gnss(const Scene& scene);
/// Speed of the vehicle's body over the rear wheels, along its x axis; an excavator has none.
std::vector<motion::WheelSample> simulate_wheels(const Scene& scene);
/// Height above the ellipsoid of where the INS is, with the errors of the options.
std::vector<motion::BarometerSample> simulate_barometer(const Scene& scene);

}  // namespace remount::simulator
