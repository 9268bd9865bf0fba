// How the streams of sessions serve the methods: the one place that refusals, `inspect` and the list of methods share.
#pragma once

#include <vector>

#include "algorithms/messages/message.h"
#include "model/drive/session.h"
#include "model/method_registry/calibration_method.h"

namespace remount::method_registry {

/// How the streams of a session serve a method.
struct MethodFit {
  const CalibrationMethod* method = nullptr;
  Message lack;  ///< empty where they serve
  Message limit, proviso;
  bool serves() const { return lack.empty(); }
};

/// In the order of the methods. Of the streams alone: whether they overlap and whether the vehicle moves is not asked.
std::vector<MethodFit> method_fits(const drive::Session& session);

/// "trajectory or vehicle-frame": the methods that take all the sessions as they are; empty where none does.
Message methods_that_take(const GivenSessions& sessions);

/// Throws Error(Unsupported) for the first session that lacks something; it names what does take all of them.
void require_served(const CalibrationMethod& method, const GivenSessions& sessions);

bool has_scans(
    const drive::Session& session);  ///< where there are none, poses of somebody's odometry are the LiDAR's motion
bool has_lidar(const drive::Session& session);  ///< scans, or poses
bool has_ins(const drive::Session& session);    ///< with attitude; two poses at least

}  // namespace remount::method_registry
