#include "model/guesses/table_choices.h"

#include <utility>

#include "algorithms/geometry/rotation.h"
#include "messages/table_import.h"
#include "model/guesses/column_units.h"
#include "model/guesses/named_columns.h"
#include "model/guesses/position_readings.h"

namespace remount::guesses {
namespace {

using formats::ColumnRef;
using formats::InsTableLayout;
using formats::TimeScale;

constexpr std::int64_t kWholeSecond_ns = 1'000'000'000;

template <std::size_t N>
void ignore(TableChoices& choices, const std::array<ColumnRole, N>& roles) {
  for (ColumnRole& role : choices.roles)
    if (is_one_of(role, roles)) role = ColumnRole::Ignored;
}

/// The place of the third coordinate is one, whichever way it counts, and so is that of the rest of a second.
bool share_place(ColumnRole a, ColumnRole b) {
  const auto third = [](ColumnRole role) { return role == ColumnRole::Height || role == ColumnRole::Down; };
  return a == b || (third(a) && third(b)) || (is_one_of(a, kRestRoles) && is_one_of(b, kRestRoles));
}

constexpr std::array<std::int64_t, 3> kRestUnits_ns{1, 1'000, 1'000'000};  // of kRestRoles

AttitudeStyle style_of(const InsTableLayout& layout) {
  if (layout.quaternion)
    return layout.quaternion == drive::QuaternionConvention::EnuFromIns ? AttitudeStyle::QuaternionEnu
                                                                        : AttitudeStyle::QuaternionNed;
  switch (layout.attitude) {
    case drive::AttitudeConvention::EnuYaw:
      return AttitudeStyle::EnuYaw;
    case drive::AttitudeConvention::NovAtel:
      return AttitudeStyle::NovAtel;
    default:
      return AttitudeStyle::Heading;
  }
}

/// Puts roles to the columns that a layout names.
class RolePutter {
 public:
  RolePutter(const SampledTable& table, TableChoices& choices) : table_(table), choices_(choices) {
    choices_.roles.resize(table.columns.size(), ColumnRole::Ignored);
  }
  void put(const ColumnRef& ref, ColumnRole role) {
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      const bool meant = ref.name.empty() ? i == ref.index : table_.columns[i].title == ref.name;
      if (meant) choices_.roles[i] = role;
    }
  }
  template <std::size_t N>
  void put_all(const std::array<ColumnRef, N>& refs, const std::array<ColumnRole, N>& roles) {
    for (std::size_t i = 0; i < N; ++i) put(refs[i], roles[i]);
  }

 private:
  const SampledTable& table_;
  TableChoices& choices_;
};

/// Makes a layout, and says what it lacks.
class LayoutMaker {
 public:
  LayoutMaker(const SampledTable& table, const TableChoices& choices) : table_(table), choices_(choices) {}

  std::optional<InsTableLayout> make(std::vector<Message>& lacks) {
    layout_.text = table_.text;
    put_time();
    put_position();
    put_attitude();
    put_errors();
    if (!lacking_.empty()) lacks.push_back(say::import_lacks(lacking_));
    lacks.insert(lacks.end(), contradictions_.begin(), contradictions_.end());
    return lacking_.empty() && contradictions_.empty() ? std::optional(layout_) : std::nullopt;
  }

 private:
  ColumnRef ref(ColumnRole role) {
    if (const auto column = choices_.column(role)) return table_.ref(*column);
    lacking_.push_back(words(role));
    return {};
  }
  std::optional<ColumnRef> if_any(ColumnRole role) const {
    const auto column = choices_.column(role);
    return column ? std::optional(table_.ref(*column)) : std::nullopt;
  }
  template <std::size_t N>
  std::array<ColumnRef, N> refs(const std::array<ColumnRole, N>& roles) {
    std::array<ColumnRef, N> all;
    for (std::size_t i = 0; i < N; ++i) all[i] = ref(roles[i]);
    return all;
  }
  template <std::size_t N>
  std::optional<std::array<ColumnRef, N>> all_if_any(const std::array<ColumnRole, N>& roles) {
    if (std::ranges::none_of(roles, [&](ColumnRole role) { return choices_.has(role); })) return std::nullopt;
    return refs(roles);
  }

  void put_time() {
    layout_.time = ref(ColumnRole::Time);
    layout_.is_date = choices_.time_unit_ns == 0;
    if (layout_.is_date)
      layout_.date_order = choices_.date_order;
    else
      layout_.time_unit_ns = choices_.time_unit_ns;
    layout_.time_scale = choices_.time_scale;
    layout_.offset_ns = choices_.offset_ns;
    layout_.gps_week = if_any(ColumnRole::Week);
    for (std::size_t i = 0; i < kRestRoles.size(); ++i)
      if (const auto rest = if_any(kRestRoles[i])) layout_.nanoseconds = rest, layout_.rest_unit_ns = kRestUnits_ns[i];
    const bool in_parts = std::ranges::any_of(kCalendarRoles, [&](ColumnRole role) { return choices_.has(role); });
    if (in_parts) put_calendar();
    layout_.day = in_parts ? std::nullopt : if_any(ColumnRole::Day);
    if (layout_.gps_week && (choices_.time_scale != TimeScale::Gps || layout_.is_date))
      contradictions_.push_back(say::import_week_needs_gps());
    if (layout_.day && !layout_.is_date) contradictions_.push_back(say::import_day_needs_date());
    if (layout_.nanoseconds && choices_.time_unit_ns != kWholeSecond_ns)
      contradictions_.push_back(say::import_nanoseconds_need_seconds());
    if (layout_.is_date && choices_.time_scale == TimeScale::GpsWeek)
      contradictions_.push_back(say::import_date_is_of_no_week());
  }

  void put_calendar() {
    layout_.calendar = {ref(ColumnRole::Year), ref(ColumnRole::Month), ref(ColumnRole::Day), ref(ColumnRole::Hour),
                        ref(ColumnRole::Minute)};
    if (choices_.time_unit_ns != kWholeSecond_ns || choices_.time_scale == TimeScale::GpsWeek || layout_.gps_week)
      contradictions_.push_back(say::import_date_parts_need_seconds());
  }

  void put_position() {
    if (!choices_.metric()) {
      layout_.latitude = ref(ColumnRole::Latitude);
      layout_.longitude = ref(ColumnRole::Longitude);
      layout_.height = ref(ColumnRole::Height);
      layout_.position_unit = choices_.position_unit;
      for (std::size_t i = 0; i < 2; ++i) layout_.place_signs[i] = choices_.place_negated[i] ? -1.0 : 1.0;
      layout_.latitude_side = if_any(ColumnRole::LatitudeSide);
      layout_.longitude_side = if_any(ColumnRole::LongitudeSide);
      return;
    }
    layout_.metric_down = choices_.has(ColumnRole::Down);
    const ColumnRole third = layout_.metric_down ? ColumnRole::Down : ColumnRole::Height;
    layout_.metric_position = refs(std::array{ColumnRole::East, ColumnRole::North, third});
  }

  void put_attitude() {
    if (is_quaternion(choices_.attitude)) {
      layout_.quaternion = choices_.attitude == AttitudeStyle::QuaternionEnu ? drive::QuaternionConvention::EnuFromIns
                                                                             : drive::QuaternionConvention::NedFromBody;
      layout_.quaternion_xyzw = refs(kQuaternionRoles);
      return;
    }
    layout_.attitude = choices_.attitude == AttitudeStyle::EnuYaw    ? drive::AttitudeConvention::EnuYaw
                       : choices_.attitude == AttitudeStyle::NovAtel ? drive::AttitudeConvention::NovAtel
                                                                     : drive::AttitudeConvention::Heading;
    layout_.attitude_unit_rad = choices_.attitude_in_deg ? kDegree_rad : 1.0;
    layout_.yaw_pitch_roll = refs(kAngleRoles);
    for (std::size_t i = 0; i < 3; ++i) layout_.yaw_pitch_roll_signs[i] = choices_.negated[i] ? -1.0 : 1.0;
  }

  /// Poses have no room for them.
  void put_errors() {
    if (choices_.metric()) return;
    layout_.position_sigma_enu = all_if_any(kPositionSigmaRoles);
    layout_.attitude_sigma_yaw_pitch_roll = all_if_any(kAttitudeSigmaRoles);
    layout_.quality = if_any(ColumnRole::Quality);
  }

  const SampledTable& table_;
  const TableChoices& choices_;
  InsTableLayout layout_;
  std::vector<Message> lacking_, contradictions_;
};

std::optional<ColumnRole> role_of(Quantity quantity) {
  static constexpr std::pair<Quantity, ColumnRole> kRoles[] = {
      {Quantity::Latitude, ColumnRole::Latitude},
      {Quantity::Longitude, ColumnRole::Longitude},
      {Quantity::Height, ColumnRole::Height},
      {Quantity::SeaHeight, ColumnRole::Height},
      {Quantity::East, ColumnRole::East},
      {Quantity::North, ColumnRole::North},
      {Quantity::Up, ColumnRole::Height},
      {Quantity::Down, ColumnRole::Down},
      {Quantity::X, ColumnRole::East},
      {Quantity::Y, ColumnRole::North},
      {Quantity::Z, ColumnRole::Height},
      {Quantity::Roll, ColumnRole::Roll},
      {Quantity::Pitch, ColumnRole::Pitch},
      {Quantity::Heading, ColumnRole::Yaw},
      {Quantity::Yaw, ColumnRole::Yaw},
      {Quantity::Qx, ColumnRole::Qx},
      {Quantity::Qy, ColumnRole::Qy},
      {Quantity::Qz, ColumnRole::Qz},
      {Quantity::Qw, ColumnRole::Qw},
      {Quantity::SigmaEast, ColumnRole::SigmaEast},
      {Quantity::SigmaNorth, ColumnRole::SigmaNorth},
      {Quantity::SigmaUp, ColumnRole::SigmaUp},
  };
  const auto* found = std::ranges::find(kRoles, quantity, &std::pair<Quantity, ColumnRole>::first);
  return found == std::end(kRoles) ? std::nullopt : std::optional(found->second);
}

}  // namespace

Message words(ColumnRole role) {
  static constexpr std::array<Message (*)(), kColumnRoleCount> kWords{
      say::import_role_ignored,
      say::import_role_time,
      say::import_role_day,
      say::import_role_week,
      say::import_role_nanoseconds,
      say::import_role_microseconds,
      say::import_role_milliseconds,
      say::import_role_year,
      say::import_role_month,
      say::import_role_hour,
      say::import_role_minute,
      say::import_role_latitude,
      say::import_role_longitude,
      say::import_role_latitude_side,
      say::import_role_longitude_side,
      say::import_role_east,
      say::import_role_north,
      say::import_role_height,
      say::import_role_down,
      say::import_role_yaw,
      say::import_role_pitch,
      say::import_role_roll,
      say::import_role_qx,
      say::import_role_qy,
      say::import_role_qz,
      say::import_role_qw,
      say::import_role_sigma_east,
      say::import_role_sigma_north,
      say::import_role_sigma_up,
      say::import_role_sigma_yaw,
      say::import_role_sigma_pitch,
      say::import_role_sigma_roll,
      say::import_role_quality,
  };
  return kWords[static_cast<std::size_t>(role)]();
}

bool is_quaternion(AttitudeStyle style) {
  return style == AttitudeStyle::QuaternionEnu || style == AttitudeStyle::QuaternionNed;
}

std::optional<std::size_t> TableChoices::column(ColumnRole role) const {
  const auto found = std::ranges::find(roles, role);
  return found == roles.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - roles.begin()));
}

bool TableChoices::metric() const { return has(ColumnRole::East) || has(ColumnRole::North) || has(ColumnRole::Down); }

bool same_time(const TableChoices& a, const TableChoices& b) {
  const bool same_order = a.time_unit_ns != 0 || a.date_order == b.date_order;
  return same_columns(a, b, kTimeRoles) && a.time_unit_ns == b.time_unit_ns && same_order &&
         a.time_scale == b.time_scale && a.offset_ns == b.offset_ns;
}

bool same_position(const TableChoices& a, const TableChoices& b) {
  return same_columns(a, b, kPositionRoles) &&
         (a.metric() || (a.position_unit == b.position_unit && a.place_negated == b.place_negated));
}

bool same_attitude(const TableChoices& a, const TableChoices& b) {
  return same_columns(a, b, kAttitudeRoles) && a.attitude == b.attitude &&
         (is_quaternion(a.attitude) || (a.attitude_in_deg == b.attitude_in_deg && a.negated == b.negated));
}

void give_role(const SampledTable& table, TableChoices& choices, std::size_t column, ColumnRole role) {
  const ColumnRole before = choices.roles.at(column);
  if (role != ColumnRole::Ignored)
    for (ColumnRole& other : choices.roles)
      if (share_place(other, role)) other = before;
  choices.roles[column] = role;
  if (is_one_of(role, kGeodeticRoles) || is_one_of(role, kSideRoles)) {
    ignore(choices, kMetricRoles);
    choices.place_negated = {};  // the sign of another column says nothing of this one
  }
  if (is_one_of(role, kMetricRoles)) {
    ignore(choices, kGeodeticRoles);
    ignore(choices, kSideRoles);
  }
  if (is_one_of(role, kAngleRoles)) {
    ignore(choices, kQuaternionRoles);
    if (is_quaternion(choices.attitude)) choices.attitude = AttitudeStyle::Heading;
  }
  if (is_one_of(role, kQuaternionRoles)) {
    ignore(choices, kAngleRoles);
    if (!is_quaternion(choices.attitude)) choices.attitude = AttitudeStyle::QuaternionEnu;
  }
  take_stated_unit(table, column, choices);
  // What goes with one unit or clock alone brings it along.
  if (role == ColumnRole::Day && !choices.has(ColumnRole::Year)) choices.time_unit_ns = 0;
  if (is_one_of(role, kRestRoles) || is_one_of(role, kCalendarRoles)) choices.time_unit_ns = kWholeSecond_ns;
  if (role == ColumnRole::Week) {
    choices.time_scale = TimeScale::Gps;
    if (choices.time_unit_ns == 0) choices.time_unit_ns = kWholeSecond_ns;
  }
}

void take_time(const SampledTable& table, const formats::TimeColumns& time, TableChoices& choices) {
  RolePutter putter(table, choices);
  ignore(choices, kTimeRoles);
  putter.put(time.time, ColumnRole::Time);
  if (time.day) putter.put(*time.day, ColumnRole::Day);
  if (time.gps_week) putter.put(*time.gps_week, ColumnRole::Week);
  for (std::size_t i = 0; i < kRestRoles.size(); ++i)
    if (time.nanoseconds && time.rest_unit_ns == kRestUnits_ns[i]) putter.put(*time.nanoseconds, kRestRoles[i]);
  if (time.calendar)
    putter.put_all(std::array{time.calendar->year, time.calendar->month, time.calendar->day, time.calendar->hour,
                              time.calendar->minute},
                   {ColumnRole::Year, ColumnRole::Month, ColumnRole::Day, ColumnRole::Hour, ColumnRole::Minute});
  choices.time_unit_ns = time.is_date ? 0 : time.time_unit_ns;
  choices.date_order = time.date_order;
  choices.time_scale = time.time_scale;
  choices.offset_ns = time.offset_ns;
}

void take_motion(const SampledTable& table, const InsTableLayout& layout, TableChoices& choices) {
  RolePutter putter(table, choices);
  ignore(choices, kPositionRoles);
  ignore(choices, kAttitudeRoles);
  if (layout.metric_position) {
    putter.put_all(*layout.metric_position,
                   {ColumnRole::East, ColumnRole::North, layout.metric_down ? ColumnRole::Down : ColumnRole::Height});
  } else {
    putter.put_all(std::array{layout.latitude, layout.longitude, layout.height},
                   {ColumnRole::Latitude, ColumnRole::Longitude, ColumnRole::Height});
    if (layout.latitude_side) putter.put(*layout.latitude_side, ColumnRole::LatitudeSide);
    if (layout.longitude_side) putter.put(*layout.longitude_side, ColumnRole::LongitudeSide);
    choices.position_unit = layout.position_unit;
    for (std::size_t i = 0; i < 2; ++i) choices.place_negated[i] = layout.place_signs[i] < 0.0;
  }
  choices.attitude = style_of(layout);
  if (layout.quaternion) {
    putter.put_all(layout.quaternion_xyzw, kQuaternionRoles);
    return;
  }
  putter.put_all(layout.yaw_pitch_roll, kAngleRoles);
  choices.attitude_in_deg = layout.attitude_unit_rad != 1.0;
  for (std::size_t i = 0; i < 3; ++i) choices.negated[i] = layout.yaw_pitch_roll_signs[i] < 0.0;
}

TableChoices choices_of(const SampledTable& table, const InsTableLayout& layout) {
  TableChoices choices;
  take_time(table, layout, choices);
  take_motion(table, layout, choices);
  RolePutter putter(table, choices);
  if (layout.position_sigma_enu) putter.put_all(*layout.position_sigma_enu, kPositionSigmaRoles);
  if (layout.attitude_sigma_yaw_pitch_roll) putter.put_all(*layout.attitude_sigma_yaw_pitch_roll, kAttitudeSigmaRoles);
  if (layout.quality) putter.put(*layout.quality, ColumnRole::Quality);
  return choices;
}

TableChoices choices_by_names(const SampledTable& table, const std::optional<TimeReading>& time) {
  TableChoices choices;
  choices.roles.assign(table.columns.size(), ColumnRole::Ignored);
  const ColumnNames names = names_of(table);
  const bool geodetic = column_called(names, Quantity::Latitude) && column_called(names, Quantity::Longitude);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto role = names[i] && unit_is_read(*names[i]) ? role_of(names[i]->quantity) : std::nullopt;
    if (!role || (geodetic && is_one_of(*role, kMetricRoles))) continue;
    const auto taken = [&](ColumnRole other) { return share_place(other, *role); };
    if (std::ranges::none_of(choices.roles, taken)) choices.roles[i] = *role;
  }
  double largest = 0.0;
  for (const ColumnRole role : kAngleRoles)
    if (const auto column = choices.column(role))
      largest = std::max(largest, largest_size(table.columns[*column].values));
  choices.attitude_in_deg = largest > 2.0 * kPi + 0.01;
  for (std::size_t i = 0; i < choices.roles.size(); ++i) take_stated_unit(table, i, choices);
  const auto yaw = choices.column(ColumnRole::Yaw);
  if (yaw && names[*yaw]->quantity == Quantity::Yaw) choices.attitude = AttitudeStyle::EnuYaw;
  if (!yaw && choices.has(ColumnRole::Qx)) choices.attitude = AttitudeStyle::QuaternionEnu;
  if (time) take_time(table, time->columns, choices);
  return choices;
}

std::optional<InsTableLayout> layout_of(const SampledTable& table, const TableChoices& choices,
                                        std::vector<Message>& lacks) {
  return LayoutMaker(table, choices).make(lacks);
}

}  // namespace remount::guesses
