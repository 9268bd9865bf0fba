#include "model/formats/bags/bag_driver_axes.h"

#include <algorithm>
#include <utility>

#include "messages/bags.h"
#include "model/conventions/driver_axes.h"
#include "model/drive/attitude_convention.h"
#include "model/drive/bad_items.h"
#include "model/formats/bags/ins_messages.h"

namespace remount::bags {
namespace {

void settle_east_and_north(std::optional<bool> enu, double& east, double& north) {
  if (!enu)
    east = north = std::max(east, north);
  else if (*enu)
    std::swap(east, north);
}

Message words_of_axes(const std::optional<conventions::DriverAxes>& found, bool enu) {
  if (!found) return enu ? say::bag_axes_taken_enu() : say::bag_axes_taken_ned();
  if (found->turn_rad != 0.0) return say::bag_axes_turned(Angle{found->turn_rad});
  Message told = enu ? say::bag_axes_told_enu() : say::bag_axes_told_ned();
  if (found->goes_sideways())
    return Message::sequence({std::move(told), say::bag_axes_sideways(Angle{found->yaw_rad})});
  return found->may_be_turned ? Message::sequence({std::move(told), say::bag_axes_or_turned()}) : told;
}

bool is_certain(const std::optional<conventions::DriverAxes>& found) {
  return found && found->turn_rad == 0.0 && !found->goes_sideways() && !found->may_be_turned;
}

}  // namespace

std::optional<bool> settle_driver_axes(MessageKind kind, const std::string& where,
                                       std::vector<formats::StampedAttitude>& attitudes, drive::Session& session) {
  const auto found = conventions::find_driver_axes(session.ins, early_enu_turn_rad(kind));
  const bool enu = found ? found->enu : writes_enu_by_itself(kind);
  session.findings.push_back(drive::make_finding(is_certain(found) ? drive::Severity::Note : drive::Severity::Warning,
                                                 "attitude-convention", where, words_of_axes(found, enu)));
  const std::optional<bool> told = found ? std::optional(enu) : std::nullopt;
  if (!enu) return told;
  const Eigen::AngleAxisd turn(found ? found->turn_rad : 0.0, Eigen::Vector3d::UnitZ());
  const auto turn_item = [&](auto& item) {
    item.enu_from_ins = turn * drive::enu_from_ins(item.enu_from_ins, drive::QuaternionConvention::NedFromBody);
  };
  std::ranges::for_each(session.ins, turn_item);
  std::ranges::for_each(attitudes, turn_item);
  return told;
}

void settle_sbg_errors(std::optional<bool> enu, std::vector<motion::InsSample>& ins) {
  for (motion::InsSample& sample : ins)
    settle_east_and_north(enu, sample.sigma.position_enu_m.x(), sample.sigma.position_enu_m.y());
}

void settle_sbg_errors(std::optional<bool> enu, FixStream& fixes) {
  for (FixMessage& fix : fixes.messages)
    if (fix.covariance_enu_m2)
      settle_east_and_north(enu, (*fix.covariance_enu_m2)(0, 0), (*fix.covariance_enu_m2)(1, 1));
}

}  // namespace remount::bags
