// What the bodies of NovAtel's logs say, in ASCII and binary alike.
#pragma once

#include <optional>
#include <vector>

#include "algorithms/motion/sensor_samples.h"
#include "model/formats/ins/novatel_frames.h"
#include "model/formats/ins/novatel_values.h"

namespace remount::formats {

struct NovatelSolution {
  motion::InsSample sample;  ///< AttitudeConvention::NovAtel; stamped with GPS time as UTC
  bool misnamed = false;     ///< its status is named after the wrong table (is_of_wrong_table)
};

struct NovatelRawImu {
  motion::ImuSample sample;  ///< in counts of one step, of axes x forward, y left, z up; stamped with GPS time as UTC
  int type = 0;              ///< of the IMU; 0 where the log does not say
};

/// Reads frames without a problem. Every function throws Error(Format) at `where` for what cannot be used.
class NovatelBodies {
 public:
  /// Of NovatelUse::Inspvax and Inspva; of the latter the time is the body's, which counts nanoseconds. Nothing where
  /// the INS has no solution and says so: it writes the centre of the earth then.
  std::optional<NovatelSolution> solution(const NovatelFrame& frame, const std::string& where);
  /// Of NovatelUse::Insstdev.
  StampedSigma errors(const NovatelFrame& frame, const std::string& where);
  /// Of NovatelUse::Bestpos; nothing where the receiver had no position.
  std::optional<motion::GnssFix> fix(const NovatelFrame& frame, const std::string& where);
  /// Of NovatelUse::RawImu; nothing where the IMU had an error, or the counts are encrypted. Forward is the y of the
  /// IMU.
  std::optional<NovatelRawImu> raw_imu(const NovatelFrame& frame, const std::string& where);

 private:
  std::string word(const NovatelFrame& frame, std::size_t field, std::size_t byte) const;
  std::int64_t header_stamp_ns(const NovatelFrame& frame, const std::string& where);
  std::int64_t body_stamp_ns(const NovatelFrame& frame, const std::string& where, std::size_t field = 0);

  std::vector<std::string_view> fields_;  // of an ASCII body; one memory for all
};

}  // namespace remount::formats
