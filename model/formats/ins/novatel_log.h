// NovAtel's logs of an INS: recordings in ASCII and binary, and the CSV of INSPVAX exported from a bag.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/motion/sensor_samples.h"
#include "model/drive/finding.h"
#include "model/formats/ins/novatel_values.h"

namespace remount::formats {

enum class NovatelFormat {
  Log,     ///< ASCII, binary, or both among anything else
  BagCsv,  ///< rostopic's CSV of INSPVAX
};

/// From the first megabyte; nothing where it is neither. Never throws.
std::optional<NovatelFormat> recognise_novatel(const std::filesystem::path& path);

/// Whether all that the first megabyte of such a log holds are raw measurements of an IMU: no solution and no fixes.
/// Never throws.
bool holds_raw_imu_alone(const std::filesystem::path& path);

struct NovatelLog {
  std::filesystem::path path;
  std::string taken;                    ///< "INSPVA"; empty where the log has no solution of an INS
  std::vector<motion::InsSample> ins;   ///< stamps as logged: settle_novatel makes them ascending
  bool states_errors = false;           ///< what is taken does
  std::vector<StampedSigma> errors;     ///< of INSPVAX and INSSTDEV beside what is taken
  std::vector<std::string> error_logs;  ///< where these are from, for messages
  std::vector<motion::GnssFix> fixes;   ///< where there is no `ins`
  std::vector<motion::ImuSample> imu;   ///< ascending; empty where the scale of its counts is not known
  Message imu_told;                     ///< what was made of raw counts of the IMU, or why nothing was
  bool fixes_were_asked = false;        ///< whether there is a solution of an INS or not
  std::size_t without_solution = 0, without_fix = 0;
  std::vector<std::string> not_used;  ///< "RAWIMUSX (3000)"
  std::size_t stray_bytes = 0;        ///< of a binary recording: what belongs to none of its logs
  /// Bag CSV only: of 1, how many lines have a host time of their own. A spreadsheet rounds them all to one.
  double distinct_host_times = 1.0;
  std::vector<drive::Finding> findings;
};

/// INS samples with UTC stamps from GPS week and time of week. Attitude: AttitudeConvention::NovAtel, so the INS frame
/// is SPAN's body frame, x right, y forward, z up. Height is above the ellipsoid (INSPVA's own; MSL height plus
/// undulation of INSPVAX and BESTPOS). An ASCII log stands anywhere within its line: behind the prompt of a port or the
/// time of a terminal. Of INSPVAX, INSPVA, INSPVAS, IMURATEPVA and IMURATEPVAS the one with most samples serves. Where
/// there is none, the fixes of BESTPOS or BESTGNSSPOS do. Of RAWIMU and its kin the one with most is the IMU, in axes x
/// forward (the y of the IMU), y left, z up, where the log names one type of IMU and gravity is felt. In a CSV the
/// host's time column is not used; what it differs from GPS time is a finding ("host-clock"). Logs with a wrong CRC or
/// broken fields are left out and counted in findings. Throws Error where the file cannot be read or holds neither.
/// @param fixes_alone fixes are wanted and no solution, and not having them is an Error
NovatelLog read_novatel_log(const std::filesystem::path& path, NovatelFormat format, bool fixes_alone = false);

/// Gives samples that state no errors those of the logs beside them (give_errors), makes stamps ascending and moves the
/// findings, with one that says what of the log was taken and what was not ("ins-log-chosen").
/// @param more errors of other recordings of the drive
void settle_novatel(NovatelLog& log, const std::vector<StampedSigma>& more, std::vector<drive::Finding>& findings);

/// Both.
NovatelLog read_novatel(const std::filesystem::path& path, NovatelFormat format, std::vector<drive::Finding>& findings);

/// The receiver's fixes of a log, whether it has an INS or not: BESTGNSSPOS, or BESTPOS where there is none of these.
std::vector<motion::GnssFix> read_novatel_fixes(const std::filesystem::path& path,
                                                std::vector<drive::Finding>& findings);

/// The raw measurements of a log's IMU, whatever else it has. Throws Error where there are none that can be used.
std::vector<motion::ImuSample> read_novatel_imu(const std::filesystem::path& path,
                                                std::vector<drive::Finding>& findings);

}  // namespace remount::formats
