#include "model/settings/method_needs.h"

#include <algorithm>
#include <array>

#include "algorithms/core/error.h"
#include "algorithms/core/index.h"
#include "messages/drives.h"

namespace remount {
namespace {

Message lack_for_pairs(const Session& session) {
  return !has_lidar(session) ? say::lacks_lidar() : !has_ins(session) ? say::lacks_ins() : Message();
}

Message lack_for_trajectory(const Session& session) {
  if (!has_lidar(session)) return say::lacks_lidar();
  if (!has_ins(session) && session.gnss.size() < 2) return say::lacks_reference();
  return {};
}

Message limit_of_trajectory(const Session& session) { return has_ins(session) ? Message() : say::lever_arm_alone(); }

Message lack_for_vehicle_frame(const Session& session) {
  return has_antenna_only(session) ? Message() : lack_of_sensor_drive(session);
}

Message limit_of_vehicle_frame(const Session& session) {
  return has_antenna_only(session) ? say::antenna_place_alone() : Message();
}

Message lack_for_fusion(const Session& session) {
  if (!has_scans(session)) return say::lacks_scans_for_odometry();
  return has_ins(session) ? Message() : say::lacks_ins();
}

Message lack_for_slew(const Session& session) { return has_lidar(session) ? Message() : say::lacks_lidar(); }

using Sessions = std::vector<std::shared_ptr<const Session>>;

/// What one of several sessions lacks: an antenna alone has nothing to say beside a sensor.
Message lack_among(const Sessions& sessions, const Session& session, MethodChoice method) {
  const bool beside_sensor =
      method == MethodChoice::VehicleFrame && has_antenna_only(session) &&
      !std::all_of(sessions.begin(), sessions.end(), [](const auto& one) { return has_antenna_only(*one); });
  return beside_sensor ? lack_of_sensor_drive(session) : needs_of(method).lack(session);
}

bool takes_all(MethodChoice method, const Sessions& sessions) {
  return std::all_of(sessions.begin(), sessions.end(),
                     [&](const auto& session) { return lack_among(sessions, *session, method).empty(); });
}

constexpr MethodChoice method_at(std::size_t index) { return static_cast<MethodChoice>(index); }

}  // namespace

bool has_scans(const Session& session) { return session.scans && session.scans->size() > 0; }

bool has_lidar(const Session& session) { return has_scans(session) || !session.odometry_from_lidar.empty(); }

bool has_ins(const Session& session) { return session.ins.size() > 1 || session.world_from_ins.size() > 1; }

bool has_antenna_only(const Session& session) {
  return session.odometry_from_lidar.empty() && !session.scans && session.gnss.size() > 1 &&
         session.wheels.size() > 1 && session.imu.size() > 1;
}

Message lack_of_sensor_drive(const Session& session) {
  if (session.wheels.size() < 2) return say::lacks_wheels();
  if (!has_scans(session) && session.odometry_from_lidar.size() < 2) return say::lacks_sensor();
  // Turn rates from attitudes need three.
  if (session.imu.size() < 2 && std::max(session.ins.size(), session.world_from_ins.size()) < 3)
    return say::lacks_turn_rates();
  return {};
}

const MethodNeeds& needs_of(MethodChoice method) {
  static const std::array<MethodNeeds, kMethodIds.size()> needs{
      {{say::needs_of_pairwise(), lack_for_pairs},
       {say::needs_of_trajectory(), lack_for_trajectory, limit_of_trajectory},
       {say::needs_of_vehicle_frame(), lack_for_vehicle_frame, limit_of_vehicle_frame},
       {say::needs_of_fusion_odometry(), lack_for_fusion},
       {say::needs_of_slew(), lack_for_slew, nullptr, say::proviso_of_slew()}}};
  return needs.at(index_of(method));
}

std::vector<MethodFit> method_fits(const Session& session) {
  std::vector<MethodFit> fits;
  for (std::size_t i = 0; i < kMethodIds.size(); ++i) {
    const MethodNeeds& needs = needs_of(method_at(i));
    MethodFit fit{method_at(i), needs.lack(session), {}, needs.proviso};
    if (fit.serves() && needs.limit) fit.limit = needs.limit(session);
    fits.push_back(std::move(fit));
  }
  return fits;
}

Message methods_that_take(const std::vector<std::shared_ptr<const Session>>& sessions) {
  Message methods;
  for (std::size_t i = 0; i < kMethodIds.size(); ++i) {
    if (!needs_of(method_at(i)).proviso.empty() || !takes_all(method_at(i), sessions)) continue;
    Message method = Message::verbatim(std::string(kMethodIds[i]));
    methods = methods.empty() ? std::move(method) : say::either_method(std::move(methods), std::move(method));
  }
  return methods;
}

void require_served(MethodChoice method, const std::vector<std::shared_ptr<const Session>>& sessions) {
  for (const auto& session : sessions) {
    const Message lack = lack_among(sessions, *session, method);
    if (lack.empty()) continue;
    const Message others = methods_that_take(sessions);
    const bool slews = method != MethodChoice::Slew && takes_all(MethodChoice::Slew, sessions);
    // One half of a recording, given instead of the folder that has both, is what is seen most.
    throw Error(ErrorCode::Unsupported, path_or_name(*session),
                !others.empty() ? say::served_by_others(lack, others)
                : slews         ? say::served_with_rest_or_slew(lack)
                                : say::served_with_rest(lack));
  }
}

}  // namespace remount
