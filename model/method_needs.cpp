#include "model/method_needs.h"

#include <algorithm>
#include <array>

#include "algorithms/core/error.h"

namespace remount {
namespace {

constexpr const char* kNoLidar = "holds neither scans nor LiDAR poses";
constexpr const char* kNoIns = "holds no motion of an INS with attitude";

std::string lack_for_pairs(const Session& session) {
  return !has_lidar(session) ? kNoLidar : !has_ins(session) ? kNoIns : "";
}

std::string lack_for_trajectory(const Session& session) {
  if (!has_lidar(session)) return kNoLidar;
  if (!has_ins(session) && session.gnss.size() < 2)
    return "holds neither an INS nor GNSS fixes to align the trajectory of the LiDAR with";
  return {};
}

std::string_view limit_of_trajectory(const Session& session) {
  return has_ins(session) ? std::string_view() : "the antenna's lever arm alone";
}

std::string lack_for_vehicle_frame(const Session& session) {
  return has_antenna_only(session) ? std::string() : lack_of_sensor_drive(session);
}

std::string_view limit_of_vehicle_frame(const Session& session) {
  return has_antenna_only(session) ? "the antenna's place alone" : std::string_view();
}

std::string lack_for_fusion(const Session& session) {
  return !has_scans(session) ? "has no scans; the multi-sensor odometry needs them" : !has_ins(session) ? kNoIns : "";
}

std::string lack_for_slew(const Session& session) { return has_lidar(session) ? "" : kNoLidar; }

using Sessions = std::vector<std::shared_ptr<const Session>>;

/// What one of several sessions lacks: an antenna alone has nothing to say beside a sensor.
std::string lack_among(const Sessions& sessions, const Session& session, MethodChoice method) {
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

std::string lack_of_sensor_drive(const Session& session) {
  if (session.wheels.size() < 2) return "has no wheel speeds, by which the vehicle's frame is found";
  if (!has_scans(session) && session.odometry_from_lidar.size() < 2) return "has neither scans nor poses of the sensor";
  // Turn rates from attitudes need three.
  if (session.imu.size() < 2 && std::max(session.ins.size(), session.world_from_ins.size()) < 3)
    return "has neither an IMU nor an INS: nothing tells how it turns";
  return {};
}

const MethodNeeds& needs_of(MethodChoice method) {
  static const std::array<MethodNeeds, kMethodIds.size()> needs{
      {{"scans or LiDAR poses, and an INS with attitude", lack_for_pairs},
       {"scans or LiDAR poses, and an INS or GNSS fixes", lack_for_trajectory, limit_of_trajectory},
       {"wheel speeds, an IMU or INS, and scans or poses of the sensor", lack_for_vehicle_frame,
        limit_of_vehicle_frame},
       {"scans, and an INS with attitude", lack_for_fusion},
       {"three recordings of a LiDAR: ground, swept arm, full turn", lack_for_slew, nullptr,
        "if it is a recording of an excavator"}}};
  return needs.at(static_cast<std::size_t>(method));
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

std::string methods_that_take(const std::vector<std::shared_ptr<const Session>>& sessions) {
  std::string names;
  for (std::size_t i = 0; i < kMethodIds.size(); ++i)
    if (needs_of(method_at(i)).proviso.empty() && takes_all(method_at(i), sessions))
      names += (names.empty() ? "--method " : " or ") + std::string(kMethodIds[i]);
  return names;
}

void require_served(MethodChoice method, const std::vector<std::shared_ptr<const Session>>& sessions) {
  for (const auto& session : sessions) {
    const std::string lack = lack_among(sessions, *session, method);
    if (lack.empty()) continue;
    const std::string others = methods_that_take(sessions);
    // One half of a recording, given instead of the folder that has both, is what is seen most.
    const std::string instead =
        !others.empty() ? "; it can be calibrated with " + others
        : method != MethodChoice::Slew && takes_all(MethodChoice::Slew, sessions)
            ? "; name a folder or a session.yaml that has it, too, or choose --method slew for an excavator"
            : "; name a folder or a session.yaml that has it, too";
    throw Error(ErrorCode::Unsupported, path_or_name(*session), lack + instead);
  }
}

}  // namespace remount
