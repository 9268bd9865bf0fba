// What NovAtel's logs of an INS say, in their own units and conventions, and the samples that it makes.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/motion/ins_sample.h"
#include "model/drive/finding.h"

namespace remount::formats {

/// What one INSPVAX says. Other logs say part of it: INSPVA no errors, INSSTDEV nothing else. An error that is not
/// stated is NaN.
struct NovatelValues {
  motion::InsQuality quality = motion::InsQuality::Unknown;
  double latitude_deg = 0.0, longitude_deg = 0.0;
  double height_m = 0.0;      ///< INSPVAX, BESTPOS: above mean sea level; INSPVA: above the ellipsoid
  double undulation_m = 0.0;  ///< of the geoid above the ellipsoid; of INSPVA zero
  double roll_deg = 0.0, pitch_deg = 0.0, azimuth_deg = 0.0;
  double latitude_std_m = kNotStated, longitude_std_m = kNotStated, height_std_m = kNotStated;
  double roll_std_deg = kNotStated, pitch_std_deg = kNotStated, azimuth_std_deg = kNotStated;

  static constexpr double kNotStated = std::numeric_limits<double>::quiet_NaN();
};

/// Without its stamp. Throws Error(Format) at `where` for a position or an angle that is not possible.
motion::InsSample ins_sample(const NovatelValues& values, const std::string& where);
/// The errors alone.
motion::InsSigma ins_sigma(const NovatelValues& values);
/// Throws Error(Format) at `where` for a position that is not possible.
void check_position(const NovatelValues& values, const std::string& where);

/// Of the inertial solution status, by number or by name; of names that belong to the solution status of a position,
/// by their number: ROS' novatel_gps_driver took the wrong table until September 2026.
motion::InsQuality novatel_quality(std::string_view status);
bool is_of_wrong_table(std::string_view status);
/// Adds "ins-status-misnamed" where there are such.
void report_misnamed(std::size_t count, const std::string& where, std::vector<drive::Finding>& findings);

struct StampedSigma {
  std::int64_t stamp_ns = 0;
  motion::InsSigma sigma;
};
/// False before an INS has aligned: it then states zeros.
bool states_any(const motion::InsSigma& sigma);
/// How far away in time the errors may be that a sample has which states none: twice the usual step of INSPVAX and
/// INSSTDEV.
inline constexpr std::int64_t kNearErrors_ns = 2'000'000'000;
/// Errors of samples that state none (INSPVA), from the nearest of `errors` (INSPVAX, INSSTDEV) that is not more than
/// kNearErrors_ns away. Both ascending.
/// @return how many samples are left without
std::size_t give_errors(std::vector<motion::InsSample>& ins, const std::vector<StampedSigma>& errors);

}  // namespace remount::formats
