#include "algorithms/calibration/vehicle_frame_refusal.h"

#include <cmath>
#include <cstdio>

namespace remount {
namespace {

// "2.50 times as long as".
std::string times_as_long(double ratio) {
  char text[64];
  std::snprintf(text, sizeof text, "%.2f times as long as", ratio);
  return text;
}

// Poses that are said to be in metres and are not: no tyre is wrong by so much. Empty where they may be.
std::string other_scale(double metres_per_unit, const VehicleFrameOptions& options) {
  constexpr double kBeyondTyres = 1.15;
  const double limit = options.estimate_wheel_scale ? kBeyondTyres * kBeyondTyres : kBeyondTyres;
  if (options.scale != ScaleMode::Known || std::abs(std::log(metres_per_unit)) < std::log(limit)) return {};
  return metres_per_unit > 1.0 ? "The way of the wheels is " + times_as_long(metres_per_unit) +
                                     " that by the sensor's poses: one of the two is not in metres."
                               : "The way by the sensor's poses is " + times_as_long(1.0 / metres_per_unit) +
                                     " that of the wheels: one of the two is not in metres.";
}

void refuse_scale(const std::string& why, CalibrationResult& calibration) {
  claim_nothing("the sensor's poses and the wheels are of different scales", calibration);
  calibration.status = Status::Inconsistent;
  calibration.message = why;
  calibration.advice = {
      "Look at the units of the wheel speeds and of the sensor's poses. Where the poses have no scale, as those of one "
      "camera, let it be estimated (vehicle_frame.scale)."};
}

// Rates that are degrees where radians are expected, or the other way around: no gyro is wrong by half of that factor.
bool degrees_and_radians_are_mixed_up(double turns_per_turn) {
  return std::abs(std::abs(std::log(turns_per_turn)) - std::log(radians_to_degrees(1.0))) < std::log(2.0);
}

void refuse_rates(double turns_per_turn, CalibrationResult& calibration) {
  char text[200];
  std::snprintf(text, sizeof text,
                "The IMU turns %.3g times as far as the sensor by its poses: its rates mix up degrees and radians.",
                turns_per_turn);
  claim_nothing("the rates of the IMU are of another unit", calibration);
  calibration.status = Status::Inconsistent;
  calibration.message = text;
  calibration.advice = {"Declare the unit of the angular rate as the log of the IMU has it."};
}

}  // namespace

bool refused_for_units(const VehicleFrameStart& start, const VehicleFrameOptions& options,
                       CalibrationResult& calibration) {
  // First: what wheels and rates make of a way is wrong too where the rates are.
  if (degrees_and_radians_are_mixed_up(start.turns_per_turn)) {
    refuse_rates(start.turns_per_turn, calibration);
    return true;
  }
  const std::string why = other_scale(start.metres_per_unit, options);
  if (!why.empty()) refuse_scale(why, calibration);
  return !why.empty();
}

}  // namespace remount
