// Scans without those errors of the LiDAR's beams that are known before a calibration.
#pragma once

#include <memory>

#include "algorithms/cloud/beam_errors.h"
#include "model/drive/session.h"

namespace remount::pipeline {

/// The session with scans that are mended as they are read; as it is where nothing is known or it has no scans.
std::shared_ptr<const drive::Session> mended_session(const std::shared_ptr<const drive::Session>& session,
                                                     const cloud::BeamEstimate& known);

}  // namespace remount::pipeline
