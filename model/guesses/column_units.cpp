#include "model/guesses/column_units.h"

#include <algorithm>

#include "model/formats/files/time_unit.h"
#include "model/guesses/column_names.h"

namespace remount::guesses {
namespace {

std::string stated_by(const SampledColumn& column) { return unit_stated(column.title, column.unit); }

void take_stated_time(const SampledColumn& column, TableChoices& choices) {
  constexpr std::int64_t kOneSecond_ns = 1'000'000'000;
  if (column.date || column.day || column.clock) {
    choices.time_unit_ns = 0;
    if (!column.orders.empty() && !std::ranges::count(column.orders, choices.date_order))
      choices.date_order = column.orders.front();
    return;
  }
  if (const auto unit_ns = formats::time_unit_named_ns(stated_by(column)))
    choices.time_unit_ns = *unit_ns;
  else if (choices.time_unit_ns == 0)
    choices.time_unit_ns = kOneSecond_ns;
}

/// Not "NED", which is a remark; "km/h" is one of a known unit.
bool states_unit(const std::string& stated) { return is_unit(stated.substr(0, stated.find('/'))); }

/// "rad"; empty where the role has none, or a date has.
std::string unit_read(const TableChoices& choices, ColumnRole role) {
  const auto angle = [](bool in_deg) { return std::string(in_deg ? "deg" : "rad"); };
  if (role == ColumnRole::Time) return std::string(formats::time_unit_name(choices.time_unit_ns));
  if (is_one_of(role, kGeodeticRoles)) return std::string(to_string(choices.position_unit));
  if (is_one_of(role, kSideRoles)) return "";
  if (is_one_of(role, kAngleRoles)) return angle(choices.attitude_in_deg);
  if (is_one_of(role, kAttitudeSigmaRoles)) return angle(choices.attitude_in_deg && !is_quaternion(choices.attitude));
  return is_one_of(role, kPositionRoles) || is_one_of(role, kPositionSigmaRoles) ? "m" : "";
}

}  // namespace

void take_stated_unit(const SampledTable& table, std::size_t column, TableChoices& choices) {
  const ColumnRole role = choices.roles.at(column);
  if (role == ColumnRole::Time) return take_stated_time(table.columns.at(column), choices);
  const std::string stated = stated_by(table.columns.at(column));
  const auto place_unit = formats::place_unit_named(stated);
  if (place_unit && is_one_of(role, kGeodeticRoles)) choices.position_unit = *place_unit;
  if (stated != "deg" && stated != "rad") return;
  if (is_one_of(role, kAngleRoles)) choices.attitude_in_deg = stated == "deg";
}

std::vector<OtherUnit> other_units(const SampledTable& table, const TableChoices& choices) {
  std::vector<OtherUnit> others;
  for (std::size_t i = 0; i < std::min(choices.roles.size(), table.columns.size()); ++i) {
    std::string stated = stated_by(table.columns[i]), read = unit_read(choices, choices.roles[i]);
    if (states_unit(stated) && !read.empty() && stated != read)
      others.push_back({i, choices.roles[i], std::move(stated), std::move(read)});
  }
  return others;
}

}  // namespace remount::guesses
