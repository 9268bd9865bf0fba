#include "model/io/angle_unit_check.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>

#include "algorithms/core/error.h"
#include "algorithms/geometry/earth_radius.h"
#include "algorithms/geometry/rotation.h"

namespace remount {
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

std::vector<Step> steps_of(const std::vector<InsSample>& samples) {
  std::vector<Step> steps;
  std::size_t from = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const InsSample &a = samples[from], &b = samples[i];
    const double north_m = (b.latitude_rad - a.latitude_rad) * kEarthRadius_m;
    const double east_m = wrap_angle_rad(b.longitude_rad - a.longitude_rad) * kEarthRadius_m * std::cos(a.latitude_rad);
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

Agreement agreement(const std::vector<Step>& steps, const std::vector<AttitudeAngles>& logged, double unit_rad,
                    AttitudeConvention convention) {
  std::complex<double> sum = 0.0;
  for (const Step& step : steps) {
    const AttitudeAngles& angles = logged[step.sample];
    const Eigen::Quaterniond enu_from_ins = remount::enu_from_ins(
        {angles.yaw_rad * unit_rad, angles.pitch_rad * unit_rad, angles.roll_rad * unit_rad}, convention);
    const Eigen::Vector3d forward =
        enu_from_ins *
        (axes_of(convention) == InsAxes::RightForwardUp ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitX());
    // Twice the angle, so that reverse driving counts as driving.
    sum += std::polar(1.0, 2.0 * (step.course_rad - std::atan2(forward.y(), forward.x())));
  }
  sum /= static_cast<double>(steps.size());
  return {std::abs(sum), 0.5 * std::arg(sum)};
}

std::string text_of(const char* pattern, auto... values) {
  char text[400];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

/// Roll and pitch of a vehicle that radians cannot be; empty where they can.
std::string beyond_radians(const std::vector<AttitudeAngles>& logged) {
  std::size_t beyond = 0;
  double largest = 0.0;
  for (const AttitudeAngles& angles : logged) {
    const double tilt = std::max(std::abs(angles.pitch_rad), std::abs(angles.roll_rad));
    beyond += tilt > kPi + 0.01;
    largest = std::max(largest, tilt);
  }
  // A few are glitches of the log.
  if (beyond * 100 <= logged.size()) return {};
  return text_of("roll or pitch reaches %.4g, more than radians allow (3.14)", largest);
}

}  // namespace

void check_angle_unit(const std::vector<InsSample>& samples, const std::vector<AttitudeAngles>& logged, double unit_rad,
                      AttitudeConvention convention, const std::filesystem::path& path,
                      std::vector<Finding>& findings) {
  const bool radians = unit_rad == 1.0;
  const char *declared_name = radians ? "rad" : "deg", *other_name = radians ? "deg" : "rad";
  const std::string advice = std::string("Declare attitude: {unit: ") + other_name + "} in session.yaml";
  const std::string beyond = radians ? beyond_radians(logged) : "";
  if (!beyond.empty())
    throw Error(ErrorCode::Format, path.string(), "the angles are declared in radians, but " + beyond + ". " + advice);

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
  const std::string against = std::string("the angles are declared as unit: ") + declared_name +
                              ", but the heading then goes against the direction of travel; it follows it ";
  if ((declared.concentration < 0.8 && other.concentration > 0.95) || far_better(other))
    throw Error(ErrorCode::Format, path.string(), against + "as " + other_name + ". " + advice);
  for (const double times : {kPi / 180.0, 180.0 / kPi, kPi / 180.0 * kPi / 180.0, 180.0 / kPi * 180.0 / kPi})
    if (far_better(agreement(steps, logged, unit_rad * times, convention)))
      throw Error(ErrorCode::Format, path.string(),
                  against + text_of("where they are %.4g times %s: they were converted once too often. Write them in "
                                    "the unit that is declared",
                                    std::max(times, 1.0 / times), times > 1.0 ? "larger" : "smaller"));
  // On a straight road both are constant, but only one of them is small, and radians stay within a turn.
  const double declared_deg = radians_to_degrees(declared.offset_rad), other_deg = radians_to_degrees(other.offset_rad);
  const bool beyond_a_turn = std::any_of(logged.begin(), logged.end(), [](const AttitudeAngles& angles) {
    return std::abs(angles.yaw_rad) > 2.0 * kPi + 0.01;
  });
  if (beyond_a_turn == radians && other.concentration > 0.95 && std::abs(other_deg) < 10.0 &&
      std::abs(declared_deg) > 20.0)
    findings.push_back({Severity::Problem, "angle-unit", path.string(),
                        text_of("As unit: %s, the heading is %.0f degrees off the direction of travel; as %s, %.0f. ",
                                declared_name, declared_deg, other_name, other_deg) +
                            advice + ", unless the INS is mounted like that."});
}

}  // namespace remount
