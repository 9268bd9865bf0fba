#include "model/formats/ins/angle_unit_check.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <string>

#include "algorithms/core/error.h"
#include "algorithms/geodesy/earth_radius.h"
#include "algorithms/geometry/rotation.h"
#include "messages/poses.h"

namespace remount::formats {
namespace {

constexpr double kStep_m = 2.0;        ///< apart enough that noise of positions does not turn the direction
constexpr double kFollows = 0.98;      ///< concentration of a heading that is right
constexpr double kFarBetter = 0.1;     ///< of what is left of the disagreement
constexpr std::size_t kFewSteps = 10;  ///< below this many nothing is said of the direction of travel

/// A stretch of travel: its direction, from east counter-clockwise, and the sample in its middle.
struct Step {
  double course_rad = 0.0;
  std::size_t sample = 0;
};

std::vector<Step> steps_of(const std::vector<motion::InsSample>& samples) {
  std::vector<Step> steps;
  std::size_t from = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const motion::InsSample &a = samples[from], &b = samples[i];
    const double north_m = (b.latitude_rad - a.latitude_rad) * geodesy::kEarthRadius_m;
    const double east_m =
        wrap_angle_rad(b.longitude_rad - a.longitude_rad) * geodesy::kEarthRadius_m * std::cos(a.latitude_rad);
    const double length_m = std::hypot(north_m, east_m);
    if (length_m < kStep_m) continue;
    // Longer ones are gaps or jumps.
    if (length_m < 5.0 * kStep_m) steps.push_back({std::atan2(north_m, east_m), (from + i) / 2});
    from = i;
  }
  return steps;
}

/// How well the heading follows the travel: 1 where the angle between them is constant, about 0 where it is anything.
struct Agreement {
  double concentration = 0.0;
  double offset_rad = 0.0;  ///< the constant, in (-pi/2, pi/2]: forwards and in reverse are not told apart
};

Agreement agreement(const std::vector<Step>& steps, const std::vector<drive::AttitudeAngles>& logged, double unit_rad,
                    drive::AttitudeConvention convention) {
  std::complex<double> sum = 0.0;
  for (const Step& step : steps) {
    const drive::AttitudeAngles& angles = logged[step.sample];
    const Eigen::Quaterniond enu_from_ins = drive::enu_from_ins(
        {angles.yaw_rad * unit_rad, angles.pitch_rad * unit_rad, angles.roll_rad * unit_rad}, convention);
    const Eigen::Vector3d forward =
        enu_from_ins * (drive::axes_of(convention) == drive::InsAxes::RightForwardUp ? Eigen::Vector3d::UnitY()
                                                                                     : Eigen::Vector3d::UnitX());
    // Twice the angle, so that reverse driving counts as driving.
    sum += std::polar(1.0, 2.0 * (step.course_rad - std::atan2(forward.y(), forward.x())));
  }
  sum /= static_cast<double>(steps.size());
  return {std::abs(sum), 0.5 * std::arg(sum)};
}

/// The largest roll or pitch of a vehicle, where radians cannot be as large.
std::optional<double> beyond_radians(const std::vector<drive::AttitudeAngles>& logged) {
  std::size_t beyond = 0;
  double largest = 0.0;
  for (const drive::AttitudeAngles& angles : logged) {
    const double tilt = std::max(std::abs(angles.pitch_rad), std::abs(angles.roll_rad));
    beyond += tilt > kPi + 0.01;
    largest = std::max(largest, tilt);
  }
  // A few are glitches of the log.
  if (beyond * 100 <= logged.size()) return std::nullopt;
  return largest;
}

}  // namespace

void check_angle_unit(const std::vector<motion::InsSample>& samples, const std::vector<drive::AttitudeAngles>& logged,
                      double unit_rad, drive::AttitudeConvention convention, const std::filesystem::path& path,
                      std::vector<drive::Finding>& findings) {
  const bool radians = unit_rad == 1.0;
  const std::string declared_name = radians ? "rad" : "deg", other_name = radians ? "deg" : "rad";
  const std::optional<double> beyond = radians ? beyond_radians(logged) : std::nullopt;
  if (beyond) throw Error(ErrorCode::Format, path.string(), say::angles_beyond_radians(*beyond));

  const std::vector<Step> steps = steps_of(samples);
  if (steps.size() < kFewSteps) return;
  const Agreement declared = agreement(steps, logged, unit_rad, convention);
  const Agreement other = agreement(steps, logged, radians ? kPi / 180.0 : 1.0, convention);
  // What is left of the heading in too small a unit follows a straight road: it must do better than none at all.
  const double none = agreement(steps, logged, 0.0, convention).concentration;
  const auto far_better = [&](const Agreement& one) {
    const double apart = 1.0 - one.concentration;
    return declared.concentration < kFollows && apart < kFarBetter * (1.0 - declared.concentration) &&
           apart < kFarBetter * (1.0 - none);
  };
  if ((declared.concentration < 0.8 && other.concentration > 0.95) || far_better(other))
    throw Error(ErrorCode::Format, path.string(), say::angles_of_other_unit(declared_name, other_name));
  for (const double times : {kPi / 180.0, 180.0 / kPi, kPi / 180.0 * kPi / 180.0, 180.0 / kPi * 180.0 / kPi})
    if (far_better(agreement(steps, logged, unit_rad * times, convention)))
      throw Error(ErrorCode::Format, path.string(),
                  times > 1.0 ? say::angles_too_small(declared_name, times)
                              : say::angles_too_large(declared_name, 1.0 / times));
  // On a straight road both are constant, but only one of them is small, and radians stay within a turn.
  constexpr double kSmall_rad = 10.0 * kPi / 180.0, kLarge_rad = 20.0 * kPi / 180.0;
  const bool beyond_a_turn = std::any_of(logged.begin(), logged.end(), [](const drive::AttitudeAngles& angles) {
    return std::abs(angles.yaw_rad) > 2.0 * kPi + 0.01;
  });
  if (beyond_a_turn == radians && other.concentration > 0.95 && std::abs(other.offset_rad) < kSmall_rad &&
      std::abs(declared.offset_rad) > kLarge_rad)
    findings.push_back({drive::Severity::Problem, "angle-unit", path.string(),
                        say::angles_likely_of_other_unit(declared_name, Angle{declared.offset_rad}, other_name,
                                                         Angle{other.offset_rad})});
}

}  // namespace remount::formats
