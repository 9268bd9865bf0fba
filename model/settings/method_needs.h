// What each calibration method needs of a session: the one place that refusals, `inspect` and the list of methods
// share.
#pragma once

#include <memory>
#include <vector>

#include "algorithms/messages/message.h"
#include "model/drive/session.h"
#include "model/settings/settings.h"

namespace remount {

struct MethodNeeds {
  Message words;  ///< the streams, for people: "scans or LiDAR poses, and an INS with attitude"
  /// What a session lacks, in words that follow its name: "has no wheel speeds". Empty where its streams serve.
  Message (*lack)(const Session& session) = nullptr;
  /// What of the mounting the streams of a session that serves leave out: "the antenna's lever arm alone". May be null.
  Message (*limit)(const Session& session) = nullptr;
  Message proviso = {};  ///< what the streams do not show: "if it is a recording of an excavator"
};

const MethodNeeds& needs_of(MethodChoice method);

/// How the streams of a session serve a method.
struct MethodFit {
  MethodChoice method = MethodChoice::Pairwise;
  Message lack;  ///< empty where they serve
  Message limit, proviso;
  bool serves() const { return lack.empty(); }
};

/// In the order of MethodChoice. Of the streams alone: whether they overlap and whether the vehicle moves is not asked.
std::vector<MethodFit> method_fits(const Session& session);

/// "trajectory or vehicle-frame": the methods that take all the sessions as they are; empty where none does.
Message methods_that_take(const std::vector<std::shared_ptr<const Session>>& sessions);

/// Throws Error(Unsupported) for the first session that lacks something; it names what does take all of them.
void require_served(MethodChoice method, const std::vector<std::shared_ptr<const Session>>& sessions);

bool has_scans(const Session& session);  ///< where there are none, poses of somebody's odometry are the LiDAR's motion
bool has_lidar(const Session& session);  ///< scans, or poses
bool has_ins(const Session& session);    ///< with attitude; two poses at least

/// Whether the vehicle-frame method falls back to the antenna: no poses of a sensor, but positions, wheels and rates.
bool has_antenna_only(const Session& session);
/// What the vehicle-frame method lacks of a session whose sensor is to be calibrated; empty for nothing.
Message lack_of_sensor_drive(const Session& session);

}  // namespace remount
