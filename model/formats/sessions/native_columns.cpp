#include "model/formats/sessions/native_columns.h"

#include "algorithms/geometry/rotation.h"
#include "messages/sessions.h"
#include "model/drive/attitude_convention.h"
#include "model/formats/files/number_text.h"
#include "model/formats/sessions/native_choice.h"

namespace remount::formats {
namespace {

double angle_unit(const DocumentView& node) {
  return choice<double>(node.at("unit"), {{"deg", kPi / 180.0}, {"rad", 1.0}});
}

/// A number is an index from 0, any other text a name.
ColumnRef column(const DocumentView& node) {
  const std::string text = node.string();
  const auto index = parse_integer(text);
  if (!index) return {text, 0};
  if (*index < 0 || *index > 10'000) node.fail(say::native_column_index());
  return {"", static_cast<std::size_t>(*index)};
}

ColumnRef named_column(const DocumentView& node) {
  const auto name = node.find("name");
  const auto index = node.find("index");
  if (name.has_value() == index.has_value()) node.fail(say::native_either("name", "index"));
  return name ? ColumnRef{name->string(), 0} : column(*index);
}

void read_time_column(const DocumentView& node, InsTableLayout& layout) {
  node.allow_only({"name", "index", "unit", "scale", "week"});
  layout.time = named_column(node);
  layout.time_unit_ns =
      choice<std::int64_t>(node.at("unit"), {{"s", 1'000'000'000}, {"ms", 1'000'000}, {"us", 1'000}, {"ns", 1}});
  layout.time_scale = choice<TimeScale>(node.at("scale"), {{"unix", TimeScale::Unix}, {"gps", TimeScale::Gps}});
  if (const auto week = node.find("week")) {
    if (layout.time_scale != TimeScale::Gps) week->fail(say::native_week());
    layout.gps_week = column(*week);
  }
}

void read_position_columns(const DocumentView& columns, InsTableLayout& layout) {
  double units[2] = {0.0, 0.0};
  int i = 0;
  for (const char* key : {"latitude", "longitude"}) {
    const DocumentView& node = columns.at(key);
    node.allow_only({"name", "index", "unit"});
    units[i] = angle_unit(node);
    (i++ == 0 ? layout.latitude : layout.longitude) = named_column(node);
  }
  if (units[0] != units[1]) columns.fail(say::native_same_unit());
  layout.position_unit_rad = units[0];
  const DocumentView& height = columns.at("height");
  if (height.is_map()) {
    height.allow_only({"name", "index", "unit"});
    choice<int>(height.at("unit"), {{"m", 0}});
  }
  layout.height = height.is_map() ? named_column(height) : column(height);
}

void read_attitude_columns(const DocumentView& columns, InsTableLayout& layout) {
  const DocumentView node = columns.at("attitude"), convention = node.at("convention");
  layout.quaternion = drive::quaternion_convention_from_string(convention.string());
  if (layout.quaternion) {
    node.allow_only({"convention", "x", "y", "z", "w"});
    std::size_t i = 0;
    for (const char* key : {"x", "y", "z", "w"}) layout.quaternion_xyzw[i++] = column(node.at(key));
    return;
  }
  const auto angles = drive::attitude_convention_from_string(convention.string());
  if (!angles) fail_choice(convention, {"enu-yaw", "heading", "novatel", "quaternion-enu", "quaternion-ned"});
  node.allow_only({"convention", "unit", "yaw", "pitch", "roll"});
  layout.attitude = *angles;
  layout.attitude_unit_rad = angle_unit(node);
  std::size_t i = 0;
  for (const char* key : {"yaw", "pitch", "roll"}) layout.yaw_pitch_roll[i++] = column(node.at(key));
}

}  // namespace

InsTableLayout read_layout(const DocumentView& columns) {
  columns.allow_only(
      {"time", "latitude", "longitude", "height", "attitude", "position_sigma_m", "attitude_sigma", "quality"});
  InsTableLayout layout;
  read_time_column(columns.at("time"), layout);
  read_position_columns(columns, layout);
  read_attitude_columns(columns, layout);
  if (const auto sigma = columns.find("position_sigma_m")) {
    sigma->allow_only({"east", "north", "up"});
    layout.position_sigma_enu = {column(sigma->at("east")), column(sigma->at("north")), column(sigma->at("up"))};
  }
  if (const auto sigma = columns.find("attitude_sigma")) {
    sigma->allow_only({"yaw", "pitch", "roll"});
    layout.attitude_sigma_yaw_pitch_roll = {column(sigma->at("yaw")), column(sigma->at("pitch")),
                                            column(sigma->at("roll"))};
  }
  if (const auto quality = columns.find("quality")) layout.quality = column(*quality);
  return layout;
}

}  // namespace remount::formats
