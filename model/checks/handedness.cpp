// Left-handed clouds: one axis of the points has the wrong sign. Seen in a mirror, the world turns the other way round
// than the INS does, while the ground stays below.
#include <algorithm>
#include <cmath>

#include "algorithms/cloud/objects.h"
#include "algorithms/core/error.h"
#include "algorithms/geometry/rotation.h"
#include "algorithms/motion/motion_track.h"
#include "algorithms/registration/registration.h"
#include "messages/checks.h"
#include "messages/places.h"
#include "model/checks/builtin.h"
#include "model/conventions/attitude_check.h"
#include "model/drive/session_frames.h"

namespace remount::checks {
namespace {

constexpr double kLeastScanTurn_rad = 6.0 * kPi / 180.0, kMostTurn_rad = 20.0 * kPi / 180.0;
constexpr double kFarthestPair_m = 8.0;
constexpr double kAlike = 0.4;  ///< how far the two turns may differ in size, as a share
constexpr std::size_t kMostPairs = 6, kEnoughUpright = 2, kEnoughMirrored = 3;

struct TurningPair {
  std::size_t scan_a = 0, scan_b = 0;
  double turn_rad = 0.0;  ///< of the INS from a to b, about the vertical, to the left positive
};

/// Pairs of scans between which the vehicle turns clearly and moves little; spread over the drive.
std::vector<TurningPair> turning_pairs(const CheckedSession& checked) {
  const drive::ScanSource& scans = *checked.session.scans;
  const motion::MotionTrack track(drive::metric_poses(checked.session));
  std::vector<std::optional<RigidTransform>> at(scans.size());
  for (std::size_t i = 0; i < scans.size(); ++i) at[i] = track.at(scans.stamp_ns(i));
  std::vector<TurningPair> pairs;
  for (std::size_t a = 0; a < scans.size(); ++a) {
    for (std::size_t b = a + 1; at[a] && b < std::min(a + 60, scans.size()); ++b) {
      if (!at[b]) continue;
      const double turn = (at[a]->linear() * so3_log(at[a]->linear().transpose() * at[b]->linear())).z();
      if ((at[b]->translation() - at[a]->translation()).norm() > kFarthestPair_m || std::abs(turn) > kMostTurn_rad)
        break;
      if (std::abs(turn) < kLeastScanTurn_rad) continue;
      pairs.push_back({a, b, turn});
      a = b;
      break;
    }
  }
  std::vector<TurningPair> spread;
  for (std::size_t i = 0; i < std::min(kMostPairs, pairs.size()); ++i)
    spread.push_back(pairs[i * pairs.size() / std::min(kMostPairs, pairs.size())]);
  return spread;
}

/// Turn of the LiDAR from a to b about the direction away from the ground; nothing where the scans do not tell.
std::optional<double> lidar_turn_rad(const CheckedSession& checked, const TurningPair& pair, const Progress& progress) {
  const registration::RegistrationOptions options;
  try {
    const cloud::PointCloud cloud_a = checked.session.scans->load(pair.scan_a);
    const cloud::PointCloud cloud_b = checked.session.scans->load(pair.scan_b);
    const cloud::GroundPlane ground = cloud::estimate_ground_plane(cloud_a, Eigen::Vector3f::Zero());
    if (!ground.found) return std::nullopt;
    const registration::PreparedCloud a(cloud_a, options, {}, progress), b(cloud_b, options, {}, progress);
    const registration::RegistrationResult aligned =
        registration::align_scans(b, a, RigidTransform::Identity(), options, progress);
    if (!aligned.quality.failure.empty()) return std::nullopt;
    return so3_log(aligned.target_from_source.linear()).dot(ground.up_in_lidar.cast<double>());
  } catch (const Error&) {
    return std::nullopt;  // said where scans are read
  }
}

bool attitude_is_to_blame(const CheckedSession& checked) {
  const std::vector<drive::Finding> findings = conventions::attitude_findings(checked.session, checked.poses);
  return std::any_of(findings.begin(), findings.end(),
                     [](const drive::Finding& finding) { return finding.severity != drive::Severity::Note; });
}

/// Turns of different instants say nothing of each other. The clocks were looked at before.
bool clocks_are_to_blame(const CheckedSession& checked, const std::vector<drive::Finding>& findings) {
  const auto is_clock = [](const drive::Finding& finding) {
    return finding.severity != drive::Severity::Note &&
           (finding.code.starts_with("clocks-") || finding.code.starts_with("clock-"));
  };
  return std::any_of(findings.begin(), findings.end(), is_clock) ||
         std::any_of(checked.session.findings.begin(), checked.session.findings.end(), is_clock);
}

void look_at_handedness(const CheckedSession& checked, std::vector<drive::Finding>& findings,
                        const Progress& progress) {
  if (!checked.session.scans || checked.session.scans->size() < 2 || checked.poses.size() < 2) return;
  if (clocks_are_to_blame(checked, findings)) return;
  std::size_t upright = 0, mirrored = 0;
  for (const TurningPair& pair : turning_pairs(checked)) {
    if (progress.cancelled()) return;
    const std::optional<double> turn = lidar_turn_rad(checked, pair, progress);
    if (!turn || std::abs(std::abs(*turn) - std::abs(pair.turn_rad)) > kAlike * std::abs(pair.turn_rad)) continue;
    (*turn > 0.0) == (pair.turn_rad > 0.0) ? ++upright : ++mirrored;
    if (upright >= kEnoughUpright) return;
  }
  if (mirrored < kEnoughMirrored || upright > 0 || attitude_is_to_blame(checked)) return;
  findings.push_back(
      {drive::Severity::Problem, "cloud-left-handed", say::place_scans(), say::cloud_left_handed(mirrored)});
}

}  // namespace

DataCheck handedness_check() {
  return {.kinds = {{"cloud-left-handed", say::cloud_left_handed_meaning, say::cloud_left_handed_remedy}},
          .look = look_at_handedness,
          .reads_scans = true};
}

}  // namespace remount::checks
