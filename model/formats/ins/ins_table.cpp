#include "model/formats/ins/ins_table.h"

#include <cmath>

#include "algorithms/core/index.h"
#include "algorithms/geometry/degree.h"
#include "messages/files.h"
#include "messages/ins_logs.h"
#include "messages/sessions.h"
#include "model/conventions/impossible_motion.h"
#include "model/drive/bad_items.h"
#include "model/drive/plausible_values.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/files/cut_line.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/text_file.h"
#include "model/formats/ins/angle_unit_check.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::string_view, 4> kQualityNames{"unknown", "good", "degraded", "invalid"};

/// What the parts of a row mean.
class RowParser {
 public:
  RowParser(const InsTableLayout& layout, DeclaredRows& rows) : layout_(layout), rows_(rows) {}

  /// Angles of the line that was parsed last, in the unit of the file, counted as the convention does; where the layout
  /// has angles.
  const drive::AttitudeAngles& logged_angles() const { return logged_; }

  motion::InsSample sample() {
    rows_.part();
    motion::InsSample sample;
    sample.stamp_ns = rows_.stamp_ns();
    if (layout_.holds != TableHolds::Attitudes) take_position(sample);
    if (layout_.holds != TableHolds::Positions) take_attitude(sample);
    if (layout_.quality) sample.quality = quality();
    return sample;
  }

  motion::StampedPose pose() {
    rows_.part();
    const std::int64_t stamp_ns = rows_.stamp_ns();
    Eigen::Vector3d position_m;
    for (int axis = 0; axis < 3; ++axis) position_m[axis] = known_m((*layout_.metric_position)[index_at(axis)]);
    if (layout_.metric_down) position_m.z() = -position_m.z();
    if (!(position_m.cwiseAbs().maxCoeff() < conventions::kFarthestPosition_m)) rows_.fail(say::log_place_impossible());
    const Eigen::Quaterniond world_from_ins = layout_.quaternion ? quaternion() : attitude();
    return {stamp_ns, make_rigid(world_from_ins.toRotationMatrix(), position_m)};
  }

 private:
  void take_position(motion::InsSample& sample) {
    const auto& [latitude_sign, longitude_sign] = layout_.place_signs;
    sample.latitude_rad = latitude_sign * place(layout_.latitude, layout_.latitude_side, {'N', 'S'});
    sample.longitude_rad = longitude_sign * place(layout_.longitude, layout_.longitude_side, {'E', 'W'});
    sample.height_m = known_m(layout_.height);
    if (!drive::plausible_geodetic(sample.latitude_rad, sample.longitude_rad, sample.height_m))
      rows_.fail(drive::plausible_geodetic(sample.longitude_rad, sample.latitude_rad, sample.height_m)
                     ? say::log_place_exchanged(Angle{kPi / 2.0})
                     : say::log_place_impossible());
    if (layout_.position_sigma_enu)
      for (int axis = 0; axis < 3; ++axis)
        sample.sigma.position_enu_m[axis] = sigma((*layout_.position_sigma_enu)[index_at(axis)], "m");
  }
  void take_attitude(motion::InsSample& sample) {
    sample.enu_from_ins = layout_.quaternion ? quaternion() : attitude();
    if (layout_.attitude_sigma_yaw_pitch_roll)
      sample.sigma.attitude_rad = attitude_sigma(*layout_.attitude_sigma_yaw_pitch_roll);
  }

  /// A number of metres that is none of those which stand for a missing one.
  double known_m(const ColumnRef& column) const {
    const double value = rows_.number(column, "m");
    if (drive::means_not_known(value)) fail_not_known(column);
    return value;
  }
  /// @param letters of the side on which angles are positive, and of the other
  double place(const ColumnRef& column, const std::optional<ColumnRef>& side, std::pair<char, char> letters) const {
    const LabelledNumber written = rows_.labelled(column, layout_.position_unit == PlaceUnit::Degrees ? "deg" : "");
    // Whole numbers are as large as those that elsewhere stand for a missing one; what is none lies far from the
    // others.
    if (layout_.position_unit != PlaceUnit::TenMillionths && drive::means_not_known(written.value))
      fail_not_known(column);
    const double angle_rad = place_rad(written.value, layout_.position_unit);
    if (std::isnan(angle_rad)) rows_.fail(say::ins_minutes(rows_.label(column), minutes_of_place(written.value)));
    if (!side) return written.side == '\0' ? angle_rad : on_side(angle_rad, written.side, column, letters);
    const std::string_view text = trim(rows_.field(*side));
    const char letter = text.size() == 1 ? static_cast<char>(text[0] & ~0x20) : '\0';
    if (written.side != '\0' && written.side != letter) rows_.fail_unit(column);
    return on_side(angle_rad, letter, *side, letters);
  }
  /// @param stated where the letter stands
  double on_side(double angle_rad, char letter, const ColumnRef& stated, std::pair<char, char> letters) const {
    if (letter != letters.first && letter != letters.second)
      rows_.fail(say::ins_side(rows_.label(stated), std::string(trim(rows_.field(stated)).substr(0, 40)),
                               std::string{letters.first}, std::string{letters.second}));
    return letter == letters.first ? angle_rad : -std::abs(angle_rad);
  }
  /// Which may stand behind the angles of an attitude.
  std::string_view attitude_label() const { return layout_.attitude_unit_rad == kDegree_rad ? "deg" : ""; }
  double angle(const ColumnRef& column) const {
    const double value = rows_.number(column, attitude_label());
    if (drive::angle_means_not_known(value)) fail_not_known(column);
    return value;
  }
  [[noreturn]] void fail_not_known(const ColumnRef& column) const {
    rows_.fail(say::log_not_known(rows_.label(column), std::string(rows_.field(column).substr(0, 40))));
  }
  /// An empty field, nan or a number that stands for a missing one: this line does not state it.
  double sigma(const ColumnRef& column, std::string_view unit) const {
    const auto written = parse_labelled_number(rows_.field(column));
    const bool stated = written && written->side == '\0' && (written->unit.empty() || written->unit == unit) &&
                        written->value > 0.0 && !drive::means_not_known(written->value) &&
                        layout_.text.no_value != written->value;
    return stated ? written->value : std::numeric_limits<double>::quiet_NaN();
  }

  Eigen::Quaterniond attitude() {
    const auto& columns = layout_.yaw_pitch_roll;
    const auto& [yaw_sign, pitch_sign, roll_sign] = layout_.yaw_pitch_roll_signs;
    logged_ = {yaw_sign * angle(columns[0]), pitch_sign * angle(columns[1]), roll_sign * angle(columns[2])};
    const double unit = layout_.attitude_unit_rad;
    return drive::enu_from_ins({logged_.yaw_rad * unit, logged_.pitch_rad * unit, logged_.roll_rad * unit},
                               layout_.attitude);
  }

  Eigen::Vector3d attitude_sigma(const std::array<ColumnRef, 3>& columns) const {
    const double unit = layout_.quaternion ? 1.0 : layout_.attitude_unit_rad;
    const auto sigma_rad = [&](std::size_t i) {
      return unit * sigma(columns[i], layout_.quaternion ? "" : attitude_label());
    };
    return drive::axis_sigma_rad({sigma_rad(0), sigma_rad(1), sigma_rad(2)},
                                 layout_.quaternion ? drive::AttitudeConvention::EnuYaw : layout_.attitude);
  }

  Eigen::Quaterniond quaternion() const {
    const auto& [x, y, z, w] = layout_.quaternion_xyzw;
    const Eigen::Quaterniond logged(rows_.number(w), rows_.number(x), rows_.number(y), rows_.number(z));
    if (std::abs(logged.norm() - 1.0) > 0.01) rows_.fail(say::ins_quaternion_length(logged.norm()));
    return drive::enu_from_ins(logged, *layout_.quaternion);
  }

  motion::InsQuality quality() const {
    const std::string_view text = rows_.field(*layout_.quality);
    for (std::size_t i = 0; i < kQualityNames.size(); ++i)
      if (kQualityNames[i] == text) return static_cast<motion::InsQuality>(i);
    rows_.fail(say::ins_quality(rows_.label(*layout_.quality), std::string(text.substr(0, 40))));
  }

  const InsTableLayout& layout_;
  DeclaredRows& rows_;
  drive::AttitudeAngles logged_;
};

void add_position_columns(const InsTableLayout& layout, std::vector<ColumnRef>& columns) {
  if (layout.metric_position) {
    columns.insert(columns.end(), layout.metric_position->begin(), layout.metric_position->end());
    return;
  }
  columns.insert(columns.end(), {layout.latitude, layout.longitude, layout.height});
  for (const auto* side : {&layout.latitude_side, &layout.longitude_side})
    if (*side) columns.push_back(**side);
  if (layout.position_sigma_enu)
    columns.insert(columns.end(), layout.position_sigma_enu->begin(), layout.position_sigma_enu->end());
}

void add_attitude_columns(const InsTableLayout& layout, std::vector<ColumnRef>& columns) {
  if (layout.quaternion)
    columns.insert(columns.end(), layout.quaternion_xyzw.begin(), layout.quaternion_xyzw.end());
  else
    columns.insert(columns.end(), layout.yaw_pitch_roll.begin(), layout.yaw_pitch_roll.end());
  if (const auto& sigma = layout.attitude_sigma_yaw_pitch_roll)
    columns.insert(columns.end(), sigma->begin(), sigma->end());
}

std::vector<ColumnRef> all_columns_of(const InsTableLayout& layout) {
  std::vector<ColumnRef> columns = columns_of(layout);
  if (layout.holds != TableHolds::Attitudes) add_position_columns(layout, columns);
  if (layout.quality) columns.push_back(*layout.quality);
  if (layout.holds != TableHolds::Positions) add_attitude_columns(layout, columns);
  return columns;
}

}  // namespace

std::string_view to_string(motion::InsQuality quality) { return kQualityNames[index_of(quality)]; }

std::vector<motion::InsSample> read_ins_table(const fs::path& path, const InsTableLayout& layout,
                                              std::vector<drive::Finding>& findings) {
  return parse_ins_table(read_text_file(path), path, layout, findings);
}

namespace {

/// Calls `take` with each row that may be used. Throws Error where there is none.
template <class Take>
void take_rows(std::string_view text, const fs::path& path, const InsTableLayout& layout,
               std::vector<drive::Finding>& findings, const Progress& progress, Take&& take) {
  text = without_cut_line(text, path.string(), findings);
  std::string memory;
  DeclaredRows rows(path, layout.text, layout, all_columns_of(layout), with_points(text, layout.text, memory));
  RowParser parser(layout, rows);
  drive::BadItems bad;
  std::size_t taken = 0;
  while (!progress.cancelled() && rows.next()) {
    try {
      take(parser);
      ++taken;
    } catch (const Error& error) {
      if (!rows.may_be_header()) bad.add(error);
    }
  }
  if (taken == 0) throw Error(ErrorCode::Format, path.string(), bad.after(say::ins_none_usable()));
  bad.report(findings, "bad-ins", path.string(), say::left_out_lines);
}

}  // namespace

std::vector<motion::InsSample> parse_ins_table(std::string_view text, const fs::path& path,
                                               const InsTableLayout& layout, std::vector<drive::Finding>& findings,
                                               const Progress& progress) {
  std::vector<motion::InsSample> samples;
  std::vector<drive::AttitudeAngles> logged;
  take_rows(text, path, layout, findings, progress, [&](RowParser& parser) {
    samples.push_back(parser.sample());
    logged.push_back(parser.logged_angles());
  });
  if (!layout.quaternion && layout.holds == TableHolds::Motion)
    check_angle_unit(samples, logged, layout.attitude_unit_rad, layout.attitude, path, findings);
  drive::keep_near(samples, path.string(), findings);
  drive::keep_ascending(samples, "ins", path.string(), findings);
  return samples;
}

std::vector<StampedAttitude> parse_attitude_table(std::string_view text, const fs::path& path,
                                                  const InsTableLayout& layout, std::vector<drive::Finding>& findings) {
  std::vector<motion::InsSample> samples;
  std::vector<drive::AttitudeAngles> logged;
  take_rows(text, path, layout, findings, Progress(), [&](RowParser& parser) {
    samples.push_back(parser.sample());
    logged.push_back(parser.logged_angles());
  });
  // Without positions only what radians cannot be tells of the unit.
  if (!layout.quaternion) check_angle_unit({}, logged, layout.attitude_unit_rad, layout.attitude, path, findings);
  drive::keep_ascending(samples, "ins", path.string(), findings);
  std::vector<StampedAttitude> attitudes;
  for (const motion::InsSample& sample : samples)
    attitudes.push_back({sample.stamp_ns, sample.enu_from_ins, sample.sigma.attitude_rad});
  return attitudes;
}

std::vector<motion::StampedPose> parse_pose_table(std::string_view text, const fs::path& path,
                                                  const InsTableLayout& layout, std::vector<drive::Finding>& findings,
                                                  const Progress& progress) {
  std::vector<motion::StampedPose> poses;
  take_rows(text, path, layout, findings, progress, [&](RowParser& parser) { poses.push_back(parser.pose()); });
  drive::keep_ascending(poses, "pose", path.string(), findings);
  return poses;
}

}  // namespace remount::formats
