#include <algorithm>

#include "messages/drives.h"
#include "messages/methods.h"
#include "model/method_registry/method_needs.h"
#include "model/methods/vehicle_frame/vehicle_frame_method.h"

namespace remount::methods {
namespace {

Message lack_of_sensor_drive(const drive::Session& session) {
  if (session.wheels.size() < 2) return say::lacks_wheels();
  if (!method_registry::has_scans(session) && session.odometry_from_lidar.size() < 2) return say::lacks_sensor();
  // Turn rates from attitudes need three.
  if (session.imu.size() < 2 && std::max(session.ins.size(), session.world_from_ins.size()) < 3)
    return say::lacks_turn_rates();
  return {};
}

// An antenna alone has nothing to say beside a sensor.
Message lack_for_vehicle_frame(const drive::Session& session, const method_registry::GivenSessions& given) {
  const bool antenna = has_antenna_only(session) && std::all_of(given.begin(), given.end(), [](const auto& other) {
                         return has_antenna_only(*other);
                       });
  return antenna ? Message() : lack_of_sensor_drive(session);
}

Message limit_of_vehicle_frame(const drive::Session& session) {
  return has_antenna_only(session) ? say::antenna_place_alone() : Message();
}

calibration::MountingFrames frames_of_vehicle_frame(const method_registry::GivenSessions& given) {
  const bool antenna = !given.empty() && has_antenna_only(*given.front());
  return {calibration::BodyFrame::Vehicle, antenna ? calibration::BodyFrame::Antenna : calibration::BodyFrame::Lidar};
}

}  // namespace

bool has_antenna_only(const drive::Session& session) {
  return session.odometry_from_lidar.empty() && !session.scans && session.gnss.size() > 1 &&
         session.wheels.size() > 1 && session.imu.size() > 1;
}

constinit const method_registry::CalibrationMethod kVehicleFrameMethod{
    .id = "vehicle-frame",
    .title = say::method_title_vehicle_frame,
    .needs = say::needs_of_vehicle_frame,
    .lack = lack_for_vehicle_frame,
    .limit = limit_of_vehicle_frame,
    .frames = frames_of_vehicle_frame,
    .settings_section = "vehicle_frame",
    .run = method_registry::solver(run_vehicle_frame)};

}  // namespace remount::methods
