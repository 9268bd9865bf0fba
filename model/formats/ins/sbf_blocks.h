// Blocks of Septentrio's binary format (SBF) as they lie in a recording, among anything else.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "algorithms/motion/sensor_samples.h"
#include "model/formats/ins/novatel_values.h"

namespace remount::formats {

/// Numbers of blocks that are used.
enum class SbfId : std::uint16_t {
  PvtGeodetic = 4007,
  InsNavCart = 4225,
  InsNavGeod = 4226,
  PosCovGeodetic = 5906,
  AttEuler = 5938,
  AttCovEuler = 5939,
};

struct SbfBlock {
  std::uint16_t id = 0;
  unsigned revision = 0;
  std::string_view bytes;  ///< from "$@" on
  std::size_t at = 0;      ///< place in the recording
};

/// Of its bytes from the number on (CCITT, x^16 + x^12 + x^5 + 1, from 0).
std::uint16_t sbf_crc16(std::string_view bytes);

/// "INSNavGeod", or "block 1234" where this program has no name for it.
std::string sbf_name(std::uint16_t id);

/// Walks through the blocks with a right checksum. Takes time that grows with the bytes alone, whatever they are.
class SbfScanner {
 public:
  explicit SbfScanner(std::string_view recording) : recording_(recording) {}
  /// False at the end.
  bool next(SbfBlock& block);
  /// Blocks of numbers that are used whose checksum was another, or which were cut.
  std::size_t broken() const { return broken_; }

 private:
  bool block_at(std::size_t at, SbfBlock& block);

  std::string_view recording_;
  std::size_t next_ = 0, in_vain_ = 0, broken_ = 0;
};

/// What INSNavGeod says; messages of Septentrio's driver hold the same. NaN where it says nothing. Angles are those of
/// AttitudeConvention::Heading.
struct InsNavValues {
  int mode = 0, error = 0;
  double latitude_rad = 0.0, longitude_rad = 0.0, height_m = 0.0;  ///< above the ellipsoid
  Eigen::Vector3d position_sigma_enu_m = Eigen::Vector3d::Constant(NovatelValues::kNotStated);
  double heading_deg = NovatelValues::kNotStated, pitch_deg = NovatelValues::kNotStated,
         roll_deg = NovatelValues::kNotStated;
  double heading_sigma_deg = NovatelValues::kNotStated, pitch_sigma_deg = NovatelValues::kNotStated,
         roll_sigma_deg = NovatelValues::kNotStated;
};

/// Without its stamp: an error of the INS is invalid, of the IMU alone degraded. Throws Error(Format) at `where` where
/// there is no attitude, or something is not possible.
motion::InsSample ins_nav_sample(const InsNavValues& values, const std::string& where);

// What blocks say. All throw Error(Format) at `where` for what is too short or not possible.

/// GPS time as UTC.
std::int64_t sbf_stamp_ns(const SbfBlock& block, const std::string& where);
/// Of InsNavGeod and InsNavCart.
InsNavValues ins_nav_values(const SbfBlock& block, const std::string& where);
/// Whether the INS has no solution yet: an error, and no position.
bool is_without_solution(const InsNavValues& values);

struct SbfFix {
  bool solved = false;
  motion::GnssFix fix;  ///< variances are NaN where the block has no accuracy
  motion::InsQuality quality = motion::InsQuality::Unknown;
};
SbfFix sbf_fix(const SbfBlock& block, const std::string& where);  ///< of PvtGeodetic

struct SbfCovariance {
  std::int64_t stamp_ns = 0;
  Eigen::Matrix3d enu_m2 = Eigen::Matrix3d::Zero();
};
SbfCovariance sbf_covariance(const SbfBlock& block, const std::string& where);  ///< of PosCovGeodetic

struct SbfAttitude {
  std::int64_t stamp_ns = 0;
  double heading_deg = 0.0, pitch_deg = 0.0, roll_deg = 0.0;  ///< NaN for what antennas do not tell
  bool fixed = true;                                          ///< AttEuler: the ambiguities between the antennas are
};
SbfAttitude sbf_attitude(const SbfBlock& block, const std::string& where);  ///< of AttEuler; of AttCovEuler its sigma

}  // namespace remount::formats
