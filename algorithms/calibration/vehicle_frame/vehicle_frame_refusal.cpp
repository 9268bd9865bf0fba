#include "algorithms/calibration/vehicle_frame/vehicle_frame_refusal.h"

#include <cmath>
#include <utility>

#include "messages/calibration.h"
#include "messages/parameters.h"

namespace remount::calibration {
namespace {

// Poses that are said to be in metres and are not: no tyre is wrong by so much. Empty where they may be.
Message other_scale(double metres_per_unit, const VehicleFrameOptions& options) {
  constexpr double kBeyondTyres = 1.15;
  const double limit = options.estimate_wheel_scale ? kBeyondTyres * kBeyondTyres : kBeyondTyres;
  if (options.scale != ScaleMode::Known || std::abs(std::log(metres_per_unit)) < std::log(limit)) return {};
  return metres_per_unit > 1.0 ? say::vehicle_frame_wheels_longer(metres_per_unit)
                               : say::vehicle_frame_poses_longer(1.0 / metres_per_unit);
}

void refuse_scale(Message why, CalibrationResult& calibration) {
  claim_nothing(say::unknown_scales_differ(), calibration);
  calibration.conclude(Status::Inconsistent, std::move(why));
  calibration.advice = {say::vehicle_frame_look_at_units()};
}

// Rates that are degrees where radians are expected, or the other way around: no gyro is wrong by half of that factor.
bool degrees_and_radians_are_mixed_up(double turns_per_turn) {
  return std::abs(std::abs(std::log(turns_per_turn)) - std::log(radians_to_degrees(1.0))) < std::log(2.0);
}

void refuse_rates(double turns_per_turn, CalibrationResult& calibration) {
  claim_nothing(say::unknown_rates_of_another_unit(), calibration);
  calibration.conclude(Status::Inconsistent, say::vehicle_frame_degrees_and_radians(turns_per_turn));
  calibration.advice = {say::vehicle_frame_declare_rate_unit()};
}

}  // namespace

bool refused_for_units(const VehicleFrameStart& start, const VehicleFrameOptions& options,
                       CalibrationResult& calibration) {
  // First: what wheels and rates make of a way is wrong too where the rates are.
  if (degrees_and_radians_are_mixed_up(start.turns_per_turn)) {
    refuse_rates(start.turns_per_turn, calibration);
    return true;
  }
  Message why = other_scale(start.metres_per_unit, options);
  if (why.empty()) return false;
  refuse_scale(std::move(why), calibration);
  return true;
}

}  // namespace remount::calibration
