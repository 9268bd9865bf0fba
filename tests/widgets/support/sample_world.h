// A small street and a finished calibration of it, made in memory for tests of the window.
#pragma once

#include <atomic>
#include <memory>

#include "app/gui/jobs/engine.h"

namespace remount::testing {

inline const SixParameters kTruth{0.9, -0.25, 0.75, 0.03, -0.02, 0.015};

/// Ground, two facades, poles and boxes, seen from `x_m` along the street, in the lidar frame.
cloud::PointCloud street_cloud(const RigidTransform& world_from_lidar, int seed);

drive::Session sample_session(const std::string& name);

/// Pairs of neighbouring keyframes of a gently turning drive; every seventh is rejected by the program, the last two
/// are proposed. z is not observed.
pipeline::PipelineOutput sample_output(const pipeline::PipelineInput& input, int pairs);

/// What two or more drives say that agree but for yaw; the second does not observe z.
pipeline::HoldOut sample_hold_out(int sessions, double yaw_sigmas = 1.5);

/// Opens paths that contain "drive", runs in `stages` reports of 5 ms, solves so that x moves by 1 mm with every
/// pair that is not accepted. Where `hold_at` names a stage, a run waits there until it is cancelled, or another or no
/// stage is named.
gui::Engine sample_engine(int stages = 10, std::shared_ptr<const std::atomic<int>> hold_at = nullptr);

}  // namespace remount::testing
