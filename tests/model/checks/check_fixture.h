// A drive with nothing wrong about it, and what a check says of it once something is.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "algorithms/messages/render.h"
#include "model/checks/data_check.h"
#include "tests/support/findings.h"

namespace remount::checks {

/// Ten seconds at 50 Hz, northwards at 5 m/s, turning by `turn_deg` and tilting by `tilt_deg` on the way.
inline drive::Session good_drive(double turn_deg = 90.0, double tilt_deg = 3.0) {
  drive::Session session;
  session.name = "drive";
  for (int i = 0; i < 500; ++i) {
    motion::InsSample sample;
    const double share = i / 499.0;
    sample.stamp_ns = std::int64_t{1'600'000'000'000'000'000} + i * std::int64_t{20'000'000};
    sample.latitude_rad = 0.85 + 0.1 * i / 6.37e6;
    sample.longitude_rad = 0.15;
    sample.enu_from_ins = Eigen::Quaterniond(rotation_from_yaw_pitch_roll(
        {degrees_to_radians(turn_deg) * share, degrees_to_radians(tilt_deg) * std::sin(6.0 * share), 0.0}));
    sample.quality = motion::InsQuality::Good;
    sample.sigma.position_enu_m.setConstant(0.01);
    session.ins.push_back(sample);
  }
  for (int i = 0; i < 90; ++i)
    session.odometry_from_lidar.push_back(
        {session.ins[static_cast<std::size_t>(5 * i + 2)].stamp_ns, RigidTransform::Identity()});
  return session;
}

inline std::vector<drive::Finding> found_by(const DataCheck& check, const drive::Session& session) {
  std::vector<drive::Finding> findings;
  check.look({session, conventions::MetricPoses(session)}, findings, Progress());
  return findings;
}

/// The same, and printed.
inline std::vector<drive::Finding> printed(std::vector<drive::Finding> findings) {
  for (const drive::Finding& finding : findings)
    std::printf("[%s] %s\n", finding.code.c_str(), english(finding.explanation).c_str());
  return findings;
}

}  // namespace remount::checks
