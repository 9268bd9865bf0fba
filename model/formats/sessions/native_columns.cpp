#include "model/formats/sessions/native_columns.h"

#include <array>
#include <cmath>
#include <utility>

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

PlaceUnit place_unit(const DocumentView& node) {
  return choice<PlaceUnit>(node.at("unit"), {{"deg", PlaceUnit::Degrees},
                                             {"rad", PlaceUnit::Radians},
                                             {"ddmm", PlaceUnit::DegreesMinutes},
                                             {"1e-7deg", PlaceUnit::TenMillionths}});
}

ColumnRef named_column(const DocumentView& node) {
  const auto name = node.find("name");
  const auto index = node.find("index");
  if (name.has_value() == index.has_value()) node.fail(say::native_either("name", "index"));
  return name ? ColumnRef{name->string(), 0} : read_column(*index);
}

void read_position_columns(const DocumentView& columns, InsTableLayout& layout) {
  auto& [latitude_sign, longitude_sign] = layout.place_signs;
  const auto read = [&](const char* key, ColumnRef& column, std::optional<ColumnRef>& side, double& sign) {
    const DocumentView& node = columns.at(key);
    node.allow_only({"name", "index", "unit", "side", "negated"});
    column = named_column(node);
    if (const auto letters = node.find("side")) side = read_column(*letters);
    if (const auto negated = node.find("negated")) {
      if (side) negated->fail(say::native_negated_side());
      sign = negated->boolean() ? -1.0 : 1.0;
    }
    return place_unit(node);
  };
  layout.position_unit = read("latitude", layout.latitude, layout.latitude_side, latitude_sign);
  if (read("longitude", layout.longitude, layout.longitude_side, longitude_sign) != layout.position_unit)
    columns.fail(say::native_same_unit());
  const DocumentView& height = columns.at("height");
  if (height.is_map()) {
    height.allow_only({"name", "index", "unit"});
    choice<int>(height.at("unit"), {{"m", 0}});
  }
  layout.height = height.is_map() ? named_column(height) : read_column(height);
}

void read_attitude_columns(const DocumentView& columns, InsTableLayout& layout) {
  const DocumentView node = columns.at("attitude"), convention = node.at("convention");
  layout.quaternion = drive::quaternion_convention_from_string(convention.string());
  if (layout.quaternion) {
    node.allow_only({"convention", "x", "y", "z", "w"});
    std::size_t i = 0;
    for (const char* key : {"x", "y", "z", "w"}) layout.quaternion_xyzw[i++] = read_column(node.at(key));
    return;
  }
  const auto angles = drive::attitude_convention_from_string(convention.string());
  if (!angles) fail_choice(convention, {"enu-yaw", "heading", "novatel", "quaternion-enu", "quaternion-ned"});
  node.allow_only({"convention", "unit", "yaw", "pitch", "roll", "negated"});
  layout.attitude = *angles;
  layout.attitude_unit_rad = angle_unit(node);
  std::size_t i = 0;
  for (const char* key : {"yaw", "pitch", "roll"}) layout.yaw_pitch_roll[i++] = read_column(node.at(key));
  if (const auto negated = node.find("negated"))
    for (const DocumentView& angle : negated->items())
      layout.yaw_pitch_roll_signs[choice<std::size_t>(angle, {{"yaw", 0}, {"pitch", 1}, {"roll", 2}})] = -1.0;
}

void read_metric_position(const DocumentView& node, InsTableLayout& layout) {
  const bool own = node.has("x");
  layout.metric_down = !own && node.has("down");
  const std::array<const char*, 3> keys{own ? "x" : "east", own ? "y" : "north",
                                        own                  ? "z"
                                        : layout.metric_down ? "down"
                                                             : "up"};
  node.allow_only({keys.begin(), keys.end()});
  layout.metric_position.emplace();
  std::size_t i = 0;
  for (const char* key : keys) (*layout.metric_position)[i++] = read_column(node.at(key));
}

}  // namespace

ColumnRef read_column(const DocumentView& node) {
  const std::string text = node.string();
  const auto index = parse_integer(text);
  if (!index) return {text, 0};
  if (*index < 0 || *index > 10'000) node.fail(say::native_column_index());
  return {"", static_cast<std::size_t>(*index)};
}

TableText read_table_text(const DocumentView& beside) {
  TableText text;
  const auto node = beside.find("table");
  if (!node) return text;
  node->allow_only({"separator", "decimals", "skip_lines", "no_value"});
  if (const auto separator = node->find("separator"))
    text.separator =
        choice<char>(*separator, {{"comma", ','}, {"semicolon", ';'}, {"tab", '\t'}, {"blanks", ' '}, {"bar", '|'}});
  if (const auto decimals = node->find("decimals"))
    text.decimal_commas = choice<bool>(*decimals, {{"point", false}, {"comma", true}});
  if (text.decimal_commas && text.separator == ',') node->fail(say::native_decimal_commas());
  if (const auto skip = node->find("skip_lines")) {
    const auto count = parse_integer(skip->string());
    if (!count || *count < 0 || *count > 10'000) skip->fail(say::native_skip_lines());
    text.skip_lines = static_cast<std::size_t>(*count);
  }
  if (const auto none = node->find("no_value")) text.no_value = none->number();
  return text;
}

std::int64_t read_offset_ns(const DocumentView& node) {
  constexpr double kMost_s = 4e9;
  const auto offset = node.find("offset_s");
  if (!offset) return 0;
  const double offset_s = offset->number();
  if (!(std::abs(offset_s) < kMost_s)) offset->fail(say::native_offset(Duration{kMost_s}));
  return std::llround(offset_s * 1e9);
}

namespace {

/// Of a date in columns of its own; `time` has its unit.
void read_calendar(const DocumentView& node, TimeColumns& time) {
  constexpr std::array kParts{"month", "hour", "minute"};
  if (!node.has("year")) {
    for (const char* part : kParts)
      if (node.has(part)) node.fail(say::native_date_in_parts());
    return;
  }
  if (time.time_unit_ns != 1'000'000'000 || time.time_scale == TimeScale::GpsWeek || node.has("week"))
    node.at("year").fail(say::native_date_in_parts());
  time.calendar = {read_column(node.at("year")), read_column(node.at("month")), read_column(node.at("day")),
                   read_column(node.at("hour")), read_column(node.at("minute"))};
}

/// What stands beside whole seconds, in one of three units.
void read_rest(const DocumentView& node, TimeColumns& time) {
  for (const auto& [key, unit_ns] :
       {std::pair("nanoseconds", 1), {"microseconds", 1'000}, {"milliseconds", 1'000'000}}) {
    const auto rest = node.find(key);
    if (!rest) continue;
    if (time.time_unit_ns != 1'000'000'000 || time.nanoseconds) rest->fail(say::native_nanoseconds());
    time.nanoseconds = read_column(*rest);
    time.rest_unit_ns = unit_ns;
  }
}

}  // namespace

TimeColumns read_time_columns(const DocumentView& node) {
  node.allow_only({"name", "index", "unit", "scale", "week", "day", "order", "year", "month", "hour", "minute",
                   "nanoseconds", "microseconds", "milliseconds", "offset_s"});
  TimeColumns time;
  time.time = named_column(node);
  time.time_unit_ns = choice<std::int64_t>(
      node.at("unit"), {{"s", 1'000'000'000}, {"ms", 1'000'000}, {"us", 1'000}, {"ns", 1}, {"date", 0}});
  time.is_date = time.time_unit_ns == 0;
  time.time_scale = choice<TimeScale>(
      node.at("scale"), {{"unix", TimeScale::Unix}, {"gps", TimeScale::Gps}, {"gps-week", TimeScale::GpsWeek}});
  if (const auto week = node.find("week")) {
    if (time.time_scale != TimeScale::Gps || time.is_date) week->fail(say::native_week());
    time.gps_week = read_column(*week);
  }
  if (time.is_date && time.time_scale == TimeScale::GpsWeek) node.at("unit").fail(say::native_date());
  read_calendar(node, time);
  const auto day = node.find("day");
  if (day && !time.is_date && !time.calendar) day->fail(say::native_day());
  if (day && !time.calendar) time.day = read_column(*day);
  if (const auto order = node.find("order")) {
    if (!time.is_date) order->fail(say::native_order());
    time.date_order = choice<DateOrder>(*order, {{"year-first", DateOrder::YearFirst},
                                                 {"day-first", DateOrder::DayFirst},
                                                 {"month-first", DateOrder::MonthFirst}});
  }
  read_rest(node, time);
  time.offset_ns = read_offset_ns(node);
  return time;
}

InsTableLayout read_pose_layout(const DocumentView& columns) {
  columns.allow_only({"time", "position", "attitude"});
  InsTableLayout layout;
  static_cast<TimeColumns&>(layout) = read_time_columns(columns.at("time"));
  read_metric_position(columns.at("position"), layout);
  read_attitude_columns(columns, layout);
  return layout;
}

namespace {

void read_position_errors(const DocumentView& columns, InsTableLayout& layout) {
  if (const auto sigma = columns.find("position_sigma_m")) {
    sigma->allow_only({"east", "north", "up"});
    layout.position_sigma_enu = {read_column(sigma->at("east")), read_column(sigma->at("north")),
                                 read_column(sigma->at("up"))};
  }
  if (const auto quality = columns.find("quality")) layout.quality = read_column(*quality);
}

void read_attitude_errors(const DocumentView& columns, InsTableLayout& layout) {
  const auto sigma = columns.find("attitude_sigma");
  if (!sigma) return;
  sigma->allow_only({"yaw", "pitch", "roll"});
  layout.attitude_sigma_yaw_pitch_roll = {read_column(sigma->at("yaw")), read_column(sigma->at("pitch")),
                                          read_column(sigma->at("roll"))};
}

}  // namespace

InsTableLayout read_position_layout(const DocumentView& columns) {
  columns.allow_only({"time", "latitude", "longitude", "height", "position_sigma_m", "quality"});
  InsTableLayout layout;
  layout.holds = TableHolds::Positions;
  static_cast<TimeColumns&>(layout) = read_time_columns(columns.at("time"));
  read_position_columns(columns, layout);
  read_position_errors(columns, layout);
  return layout;
}

InsTableLayout read_attitude_layout(const DocumentView& columns) {
  columns.allow_only({"time", "attitude", "attitude_sigma"});
  InsTableLayout layout;
  layout.holds = TableHolds::Attitudes;
  static_cast<TimeColumns&>(layout) = read_time_columns(columns.at("time"));
  read_attitude_columns(columns, layout);
  read_attitude_errors(columns, layout);
  return layout;
}

InsTableLayout read_layout(const DocumentView& columns) {
  columns.allow_only(
      {"time", "latitude", "longitude", "height", "attitude", "position_sigma_m", "attitude_sigma", "quality"});
  InsTableLayout layout;
  static_cast<TimeColumns&>(layout) = read_time_columns(columns.at("time"));
  read_position_columns(columns, layout);
  read_attitude_columns(columns, layout);
  read_position_errors(columns, layout);
  read_attitude_errors(columns, layout);
  return layout;
}

}  // namespace remount::formats
