#include "model/methods/vehicle_frame/wheel_direction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "algorithms/calibration/vehicle_frame/vehicle_frame_start.h"
#include "algorithms/core/stamps.h"
#include "algorithms/motion/motion_track.h"
#include "messages/methods.h"

namespace remount::methods {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// What two sources say of the same motion, about zero: 1 where they agree, -1 where one is the other backwards.
struct Likeness {
  double both = 0.0, first2 = 0.0, second2 = 0.0, first_sum = 0.0, second_sum = 0.0, count = 0.0;
  void add(double first, double second) {
    first_sum += first;
    second_sum += second;
    count += 1.0;
    both += first * second;
    first2 += first * first;
    second2 += second * second;
  }
  /// About the means, which a bias moves.
  Likeness varying() const {
    Likeness out = *this;
    out.both -= first_sum * second_sum / count;
    out.first2 -= first_sum * first_sum / count;
    out.second2 -= second_sum * second_sum / count;
    return out;
  }
  double value() const { return first2 > 0.0 && second2 > 0.0 ? both / std::sqrt(first2 * second2) : 0.0; }
};

constexpr std::int64_t kStretch_ns = 500'000'000;

/// Ways along x of the vehicle: by the wheels, and by the places of the INS. Nothing where these do not move.
Likeness ways_by_ins(const calibration::VehicleDrive& drive) {
  constexpr double kLeastWay_m = 20.0;
  const motion::MotionTrack track(drive.reference_from_vehicle);
  Likeness likeness;
  double way_m = 0.0;
  for (std::int64_t from = drive.sensed.begin_ns(); from + kStretch_ns <= drive.sensed.end_ns(); from += kStretch_ns) {
    const auto steps = drive.sensed.steps(from, from + kStretch_ns);
    const auto before = track.at(from), after = track.at(from + kStretch_ns);
    if (!steps || !before || !after) continue;
    double travel_m = 0.0;
    for (const motion::MotionStep& step : *steps) travel_m += step.travel_m;
    const Vector3d moved_m = before->linear().transpose() * (after->translation() - before->translation());
    likeness.add(travel_m, moved_m.x());
    way_m += moved_m.norm();
  }
  return way_m < kLeastWay_m ? Likeness{} : likeness;
}

/// What the IMU feels in the vehicle's axes.
struct Forces {
  Likeness to_the_left;  ///< speed times rate of turn, and the force; nothing where turns are slight
  double up_g = std::numeric_limits<double>::quiet_NaN();  ///< mean, by 9.81 m/s^2
};

Forces forces_of(const calibration::VehicleDrive& drive, const Matrix3d& vehicle_from_imu,
                 const Vector3d& gyro_bias_radps) {
  constexpr double kLeast_mps2 = 0.2;  // in rms
  constexpr std::size_t kFewest = 20;
  constexpr double kMostOff = 0.4;
  const std::vector<motion::ImuSample>& imu = drive.sensed.imu();
  Likeness likeness;
  Vector3d mean_force = Vector3d::Zero();
  std::size_t count = 0, at = 0;
  for (std::int64_t from = drive.sensed.begin_ns(); from + kStretch_ns <= drive.sensed.end_ns(); from += kStretch_ns) {
    const auto steps = drive.sensed.steps(from, from + kStretch_ns);
    Vector3d force = Vector3d::Zero();
    std::size_t samples = 0;
    for (; at < imu.size() && imu[at].stamp_ns < from + kStretch_ns; ++at)
      if (imu[at].stamp_ns >= from && imu[at].specific_force_mps2.allFinite())
        force += imu[at].specific_force_mps2, ++samples;
    if (!steps || samples == 0) continue;
    force = vehicle_from_imu * force / static_cast<double>(samples);
    double travel_m = 0.0, turn_rad = 0.0;
    for (const motion::MotionStep& step : *steps) {
      travel_m += step.travel_m;
      turn_rad += (vehicle_from_imu * (step.turn_in_imu_rad - gyro_bias_radps * step.duration_s)).z();
    }
    const double stretch_s = seconds(kStretch_ns);
    likeness.add(travel_m * turn_rad / (stretch_s * stretch_s), force.y());
    mean_force += force;
    ++count;
  }
  if (count < kFewest) return {};
  constexpr double kGravity_mps2 = 9.81;
  Forces forces{{}, mean_force.z() / static_cast<double>(count) / kGravity_mps2};
  likeness = likeness.varying();
  if (likeness.first2 < kLeast_mps2 * kLeast_mps2 * static_cast<double>(count)) return forces;
  // Some logs state the acceleration of a body that rests as downwards, and some in units of g.
  likeness.both /= forces.up_g;
  likeness.second2 /= forces.up_g * forces.up_g;
  // A road that is banked for its bends takes from the force, or outweighs it where the vehicle is slow, and by chance
  // only makes just the opposite of it.
  const double force_per_expected = likeness.both / likeness.first2;
  if (std::abs(std::abs(force_per_expected) - 1.0) <= kMostOff) forces.to_the_left = likeness;
  return forces;
}

// Which side of the IMU is the left of the vehicle. What is stated of it stands: wheels that turn backwards turn a
// mounting that was found around with the sensor. Only which way is up is better known from the turns.
std::optional<Matrix3d> known_mounting(const calibration::VehicleFrameOptions& options,
                                       const calibration::VehicleFrameResult& result) {
  constexpr double kKnown_deg = 20.0;
  if (options.imu_mounting_sigma_deg > kKnown_deg) return std::nullopt;
  const Matrix3d stated = calibration::stated_imu_mounting(options);
  const bool same_way_up = result.vehicle_from_imu.row(2).dot(stated.row(2)) > 0.0;
  return same_way_up ? stated : result.vehicle_from_imu;
}

void refuse_wheels(Message message, Message advice, calibration::CalibrationResult& calibration) {
  calibration::claim_nothing(say::unknown_wheels_contradict(), calibration);
  calibration.conclude(calibration::Status::Inconsistent, std::move(message));
  calibration.advice.insert(calibration.advice.begin(), std::move(advice));
}

}  // namespace

void refuse_backward_wheels(const std::vector<calibration::VehicleDrive>& drives,
                            const calibration::VehicleFrameOptions& options, calibration::VehicleFrameResult& result) {
  if (!calibration::is_usable(result.calibration) && result.calibration.status != calibration::Status::NotConverged)
    return;
  constexpr double kBackwards = -0.7;
  for (const calibration::VehicleDrive& drive : drives) {
    const Likeness ways = ways_by_ins(drive);
    if (ways.value() < kBackwards) {
      refuse_wheels(say::vehicle_wheels_turn_backwards(), say::vehicle_check_sign_and_ins(), result.calibration);
      return;
    }
    // Where places tell the direction, forces add nothing.
    if (ways.first2 > 0.0) continue;
    const std::optional<Matrix3d> mounting = known_mounting(options, result);
    const Forces forces = forces_of(drive, mounting.value_or(result.vehicle_from_imu), result.gyro_bias_radps);
    if (forces.to_the_left.value() >= kBackwards) continue;
    // Wheels that turn backwards turn a mounting that was found half around with them, and it is pressed aside as it
    // should be: what is left is a vehicle that was found upside down.
    if (!mounting || forces.up_g < 0.0)
      refuse_wheels(say::vehicle_imu_upside_down(), say::vehicle_state_imu_mounting(), result.calibration);
    else
      refuse_wheels(say::vehicle_imu_pressed_aside(), say::vehicle_check_sign_and_imu(), result.calibration);
    return;
  }
}

}  // namespace remount::methods
