#include "model/formats/ins/novatel_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "algorithms/core/error.h"
#include "messages/ins_logs.h"
#include "model/drive/attitude_convention.h"
#include "model/drive/bad_items.h"
#include "model/drive/plausible_values.h"

namespace remount::formats {

namespace {

/// The number of a name that is none of an INS but stands in the table of solution statuses of positions.
std::optional<std::size_t> number_in_wrong_table(std::string_view status) {
  constexpr std::array<std::string_view, 10> kPositionStatuses{
      "SOL_COMPUTED", "INSUFFICIENT_OBS", "NO_CONVERGENCE", "SINGULARITY", "COV_TRACE",
      "TEST_DIST",    "COLD_START",       "V_H_LIMIT",      "VARIANCE",    "RESIDUALS"};
  const auto found = std::find(kPositionStatuses.begin(), kPositionStatuses.end(), status);
  if (found == kPositionStatuses.end()) return std::nullopt;
  return static_cast<std::size_t>(found - kPositionStatuses.begin());
}

}  // namespace

bool is_of_wrong_table(std::string_view status) { return number_in_wrong_table(status).has_value(); }

void report_misnamed(std::size_t count, const std::string& where, std::vector<drive::Finding>& findings) {
  if (count == 0) return;
  findings.push_back(
      drive::make_finding(drive::Severity::Warning, "ins-status-misnamed", where, say::inspvax_misnamed(count)));
}

bool states_any(const motion::InsSigma& sigma) {
  return !sigma.position_enu_m.isZero(0.0) || !sigma.attitude_rad.isZero(0.0);
}

std::size_t give_errors(std::vector<motion::InsSample>& ins, const std::vector<StampedSigma>& errors) {
  std::size_t next = 0, without = 0;
  for (motion::InsSample& sample : ins) {
    const auto apart = [&](std::size_t i) { return std::abs(errors[i].stamp_ns - sample.stamp_ns); };
    while (next + 1 < errors.size() && apart(next + 1) <= apart(next)) ++next;
    if (next < errors.size() && apart(next) <= kNearErrors_ns)
      sample.sigma = errors[next].sigma;
    else
      ++without;
  }
  return without;
}

void check_position(const NovatelValues& values, const std::string& where) {
  const double latitude_rad = degrees_to_radians(values.latitude_deg),
               longitude_rad = degrees_to_radians(values.longitude_deg),
               height_m = values.height_m + values.undulation_m;
  if (!drive::plausible_geodetic(latitude_rad, longitude_rad, height_m))
    throw Error(ErrorCode::Format, where,
                drive::plausible_geodetic(longitude_rad, latitude_rad, height_m)
                    ? say::log_place_exchanged(Angle{kPi / 2.0})
                    : say::log_place_impossible());
}

motion::InsSigma ins_sigma(const NovatelValues& values) {
  const auto stated = [](double sigma) { return drive::means_not_known(sigma) || sigma < 0.0 ? std::nan("") : sigma; };
  motion::InsSigma sigma;
  sigma.position_enu_m = {stated(values.longitude_std_m), stated(values.latitude_std_m), stated(values.height_std_m)};
  sigma.attitude_rad = drive::axis_sigma_rad(
      {degrees_to_radians(stated(values.azimuth_std_deg)), degrees_to_radians(stated(values.pitch_std_deg)),
       degrees_to_radians(stated(values.roll_std_deg))},
      drive::AttitudeConvention::NovAtel);
  return sigma;
}

motion::InsSample ins_sample(const NovatelValues& values, const std::string& where) {
  check_position(values, where);
  for (const double angle_deg : {values.roll_deg, values.pitch_deg, values.azimuth_deg})
    if (!(std::abs(angle_deg) <= 360.0))
      throw Error(ErrorCode::Format, where,
                  drive::angle_means_not_known(angle_deg) ? say::inspvax_angles_not_known() : say::inspvax_no_angles());
  motion::InsSample sample;
  sample.latitude_rad = degrees_to_radians(values.latitude_deg);
  sample.longitude_rad = degrees_to_radians(values.longitude_deg);
  sample.height_m = values.height_m + values.undulation_m;
  sample.enu_from_ins = drive::enu_from_ins({degrees_to_radians(values.azimuth_deg),
                                             degrees_to_radians(values.pitch_deg), degrees_to_radians(values.roll_deg)},
                                            drive::AttitudeConvention::NovAtel);
  sample.sigma = ins_sigma(values);
  sample.quality = values.quality;
  return sample;
}

motion::InsQuality novatel_quality(std::string_view status) {
  if (const auto number = number_in_wrong_table(status)) return novatel_quality(std::to_string(*number));
  // Numbers in bags and their CSVs, names in ASCII logs (OEM6/OEM7 manuals, "Inertial Solution Status").
  if (status == "3" || status == "INS_SOLUTION_GOOD") return motion::InsQuality::Good;
  if (status == "2" || status == "INS_HIGH_VARIANCE" || status == "6" || status == "INS_SOLUTION_FREE" ||
      status == "7" || status == "INS_ALIGNMENT_COMPLETE")
    return motion::InsQuality::Degraded;
  return motion::InsQuality::Invalid;
}

}  // namespace remount::formats
