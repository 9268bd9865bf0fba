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

}  // namespace

std::optional<bool> settle_driver_axes(MessageKind kind, const std::string& where,
                                       std::vector<formats::StampedAttitude>& attitudes, drive::Session& session) {
  const std::optional<bool> told = conventions::are_east_north_up(session.ins);
  const bool enu = told.value_or(writes_enu_by_itself(kind));
  session.findings.push_back(drive::make_finding(told ? drive::Severity::Note : drive::Severity::Warning,
                                                 "attitude-convention", where,
                                                 told  ? enu ? say::bag_axes_told_enu() : say::bag_axes_told_ned()
                                                  : enu ? say::bag_axes_taken_enu()
                                                       : say::bag_axes_taken_ned()));
  if (!enu) return told;
  const auto turn = [](auto& item) {
    item.enu_from_ins = drive::enu_from_ins(item.enu_from_ins, drive::QuaternionConvention::NedFromBody);
  };
  std::ranges::for_each(session.ins, turn);
  std::ranges::for_each(attitudes, turn);
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
