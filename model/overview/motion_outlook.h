// What a drive will be able to tell about X, judged from the motion of the INS alone: before any scan is registered.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "algorithms/core/progress.h"
#include "algorithms/messages/message.h"
#include "model/drive/session.h"
#include "model/settings/settings.h"

namespace remount::overview {

struct MotionOutlook {
  bool judged = false;                     ///< false: the INS does not cover the lidar's times
  calibration::ParameterSet determinable;  ///< as far as can be foreseen
  /// Those of which the calibration may find otherwise: scans that align better or worse than is supposed decide.
  calibration::ParameterSet open;
  /// The session has no nominal mounting, and its motion does not tell yaw: without a nominal nothing can be told.
  bool needs_nominal = false;
  std::vector<Message> advice;  ///< what to drive for the rest, one sentence each
};

/// Takes keyframes and pairs as the calibration will, supposes that each pair is registered to a few centimetres, and
/// asks which parameters would then be observed, and which would not by somewhat larger errors, or would by smaller
/// ones. An outlook, no promise: registration may fail where there is little to see. Reads no scan. Not judged where
/// `progress` is cancelled.
MotionOutlook motion_outlook(const drive::Session& session, const settings::Settings& settings = {},
                             const Progress& progress = {});

}  // namespace remount::overview
