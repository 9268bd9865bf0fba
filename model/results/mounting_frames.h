// Between which frames the mounting of a method is.
#pragma once

#include <optional>
#include <string>

#include "algorithms/calibration/mounting.h"
#include "algorithms/messages/message.h"
#include "model/method_registry/calibration_method.h"

namespace remount::results {

/// "vehicle_from_antenna".
std::string name_of(const calibration::MountingFrames& frames);

/// What a session declares, for a method that does not start from it: a sentence; empty where it does.
Message unused_declaration(const method_registry::CalibrationMethod& method,
                           const method_registry::GivenSessions& sessions);

/// Why a mounting in these frames cannot be where a method starts from, as the end of a sentence about it; empty where
/// it can.
Message frame_problem(const calibration::MountingFrames& nominal, const method_registry::CalibrationMethod& method,
                      const method_registry::GivenSessions& sessions);

/// Whether a method starts from what places the LiDAR in the INS frame, as sessions do that declare their mounting.
bool starts_from_ins(const method_registry::CalibrationMethod& method);

/// What the sessions declare themselves, where they do and the method starts from the LiDAR in the INS frame. Throws
/// Error(Contract) where they contradict each other: that is for the user to decide.
std::optional<RigidTransform> declared_nominal(const method_registry::GivenSessions& sessions,
                                               const method_registry::CalibrationMethod& method);

/// Why a mounting in these frames cannot stand where one of the LiDAR in the INS frame is asked for, as the end of a
/// sentence about it; empty where it can.
Message not_in_ins_frame(const calibration::MountingFrames& frames);

}  // namespace remount::results
