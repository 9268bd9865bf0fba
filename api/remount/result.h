// What a calibration found, and how sure it is.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "remount/matrices.h"
#include "remount/session.h"
#include "remount/text.h"

namespace remount::results {
struct ResultFile;
}  // namespace remount::results

namespace remount::api {

enum class Status {
  Ok,             ///< every parameter is observed
  Degenerate,     ///< solved, but some parameters are not observed
  TooFewPairs,    ///< not enough accepted pairs for any answer
  TooLittleData,  ///< of a method that rests on something else than pairs
  NoUsableData,   ///< nothing of what was recorded could be used
  NotConverged,   ///< no solution was found
  OutOfRange,     ///< no candidate lies within the search range
  Inconsistent,   ///< what the result would rest on contradicts itself
  Cancelled,
};
std::string_view to_string(Status status);  ///< "ok", "too_few_pairs": as in files

/// In the order of rows of a covariance.
enum class Parameter { X, Y, Z, Yaw, Pitch, Roll };
inline constexpr std::array<Parameter, 6> kParameters{Parameter::X,   Parameter::Y,     Parameter::Z,
                                                      Parameter::Yaw, Parameter::Pitch, Parameter::Roll};
std::string_view to_string(Parameter parameter);  ///< "x", "yaw"

/// What is not observed has no sigma, and says why; its value is then what was given, nothing to rely on.
struct Estimate {
  double value = 0.0;           ///< m, rad; yaw, pitch and roll with R = Rz(yaw) Ry(pitch) Rx(roll)
  std::optional<double> sigma;  ///< 1-sigma
  bool observed = false;
  bool measured = false;  ///< held near a value that was measured by hand
  Text why_not_observed;
};

enum class PairState { Proposed, Accepted, Rejected };
std::string_view to_string(PairState state);  ///< "accepted": as in files

/// P and Q of the motion equation P X = X Q, and how far they miss it under the result.
struct PairMotion {
  Matrix4 ins_b_from_ins_a = Matrix4::Identity();
  Matrix4 lidar_b_from_lidar_a = Matrix4::Identity();
  Vector6 residual = Vector6::Zero();  ///< translation (m), rotation vector (rad), in the axes of LiDAR b
};

/// Two scans that see the same.
struct Pair {
  std::size_t session = 0;
  std::int64_t stamp_a_ns = 0, stamp_b_ns = 0;
  PairState state = PairState::Proposed;
  Text reason;                ///< why it was rejected
  double rotation_rad = 0.0;  ///< of the INS between the two
  double baseline_m = 0.0;
  double rmse_m = 0.0;                  ///< of the registration
  double overlap = 0.0;                 ///< share of points with a neighbour
  double residual_rotation_rad = 0.0;   ///< of P X = X Q
  double residual_translation_m = 0.0;  ///< likewise
  double weight = 0.0;                  ///< in the solution, 0..1
  std::optional<PairMotion> motion;     ///< nothing where the result was read from a file
};

struct TimeOffset {
  double offset_s = 0.0;  ///< t_ins = t_lidar + offset; NaN where not estimated
  double sigma_s = 0.0;
  bool applied = false;
};

/// Immutable; copies are of the same result.
class Result {
 public:
  struct Inside;
  explicit Result(std::shared_ptr<const Inside> inside);

  /// A file that was saved by save(), the window or the command line. Throws Error(Io), Error(Format).
  static Result load(const std::filesystem::path& path);
  /// JSON where the name ends in ".json", YAML otherwise. Replaces what is there, atomically. Throws Error(Io).
  void save(const std::filesystem::path& path) const;

  Status status() const;
  Text message() const;              ///< what happened, and why
  std::vector<Text> advice() const;  ///< what to drive or to add
  bool usable() const;               ///< whether there is an X of which something is observed
  std::string method() const;        ///< "pairwise"

  /// X. Throws Error(Contract) where the method finds the LiDAR in another frame: reference_from_sensor().
  Matrix4 ins_from_lidar() const;
  Matrix4 reference_from_sensor() const;
  std::string reference_frame() const, sensor_frame() const;  ///< "ins", "vehicle", "machine", "antenna"; "lidar"
  /// Of x, y, z, yaw, pitch, roll, m and rad; NaN in rows and columns of what is not observed.
  Matrix6 covariance() const;
  Estimate estimate(Parameter parameter) const;

  std::vector<Pair> pairs() const;
  std::vector<Keyframe> keyframes() const;                     ///< empty where the result was read from a file
  double rotation_rms_rad() const, translation_rms_m() const;  ///< of the accepted pairs
  TimeOffset time_offset() const;
  std::vector<Finding> findings() const;
  Settings settings() const;

  const results::ResultFile& file() const;  ///< for Remount itself

 private:
  std::shared_ptr<const Inside> inside_;
};

}  // namespace remount::api
