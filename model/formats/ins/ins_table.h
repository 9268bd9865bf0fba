// INS samples in a CSV whose columns, units and conventions are declared, as a session.yaml does.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/core/progress.h"
#include "model/drive/attitude_convention.h"
#include "model/drive/session.h"
#include "model/formats/files/declared_table.h"
#include "model/formats/ins/place_unit.h"
#include "model/formats/ins/samples_between_fixes.h"

namespace remount::formats {

/// Which part of a motion a table holds.
enum class TableHolds { Motion, Positions, Attitudes };

/// What the columns of an INS table mean.
struct InsTableLayout : TimeColumns {
  TableText text;
  TableHolds holds = TableHolds::Motion;  ///< columns of the other part mean nothing
  ColumnRef latitude, longitude, height;
  PlaceUnit position_unit = PlaceUnit::Radians;  ///< of latitude and longitude
  /// Columns with N or S, with E or W, beside numbers that have no sign.
  std::optional<ColumnRef> latitude_side, longitude_side;
  std::array<double, 2> place_signs{1.0, 1.0};  ///< of latitude and longitude; -1: the log counts south, west positive
  drive::AttitudeConvention attitude = drive::AttitudeConvention::EnuYaw;
  double attitude_unit_rad = 1.0;  ///< radians in one unit of the angles and their sigma
  std::array<ColumnRef, 3> yaw_pitch_roll;
  std::array<double, 3> yaw_pitch_roll_signs{1.0, 1.0, 1.0};  ///< -1: the log counts that angle the other way
  std::optional<drive::QuaternionConvention> quaternion;      ///< set: the four columns below instead of angles
  std::array<ColumnRef, 4> quaternion_xyzw;
  std::optional<std::array<ColumnRef, 3>> position_sigma_enu;  ///< m
  std::optional<std::array<ColumnRef, 3>>
      attitude_sigma_yaw_pitch_roll;  ///< unit of the angles (rad with a quaternion)
  std::optional<ColumnRef> quality;   ///< unknown, good, degraded or invalid
  /// Set: positions in a metric world, x, y, z or east, north, up, instead of latitude, longitude and height.
  std::optional<std::array<ColumnRef, 3>> metric_position;
  bool metric_down = false;  ///< the third of these counts downwards
};

/// Samples with strictly ascending stamps, of positions alone without attitudes. Lines that cannot be used become
/// findings. Throws Error where the file cannot be read, a column is missing, or no line is usable.
std::vector<motion::InsSample> read_ins_table(const std::filesystem::path& path, const InsTableLayout& layout,
                                              std::vector<drive::Finding>& findings);
/// The same of a text that was read already; `path` is for messages. Where it is cancelled, of the lines until then, or
/// an Error of which nothing is to be said.
std::vector<motion::InsSample> parse_ins_table(std::string_view text, const std::filesystem::path& path,
                                               const InsTableLayout& layout, std::vector<drive::Finding>& findings,
                                               const Progress& progress = Progress());

/// Attitudes with strictly ascending stamps, of a layout that holds these; likewise.
std::vector<StampedAttitude> parse_attitude_table(std::string_view text, const std::filesystem::path& path,
                                                  const InsTableLayout& layout, std::vector<drive::Finding>& findings);

/// Poses in a metric world, of a layout with `metric_position`; likewise.
std::vector<motion::StampedPose> parse_pose_table(std::string_view text, const std::filesystem::path& path,
                                                  const InsTableLayout& layout, std::vector<drive::Finding>& findings,
                                                  const Progress& progress = Progress());

std::string_view to_string(motion::InsQuality quality);

}  // namespace remount::formats
