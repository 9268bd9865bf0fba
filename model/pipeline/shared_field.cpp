#include "model/pipeline/shared_field.h"

#include <algorithm>
#include <cmath>

#include "algorithms/core/error.h"
#include "algorithms/core/index.h"

namespace remount::pipeline {
namespace {

constexpr double kAllAround = 0.9;         // of a turn
constexpr std::size_t kPointsOfScan = 40;  // of ten scans: tells a share to three hundredths

}  // namespace

SharedField::SharedField(const DriveMotion& motion, const Progress& progress) : sessions_(motion.session_count()) {
  constexpr std::size_t kScans = 10;
  for (motion::SessionIndex s; s < motion.session_count(); ++s) {
    const auto& scans = motion.session(s).scans;
    if (!scans || scans->size() == 0) continue;
    Seen seen;
    const std::size_t count = std::min(kScans, scans->size());
    for (std::size_t i = 0; i < count && !progress.cancelled(); ++i) {
      try {
        const std::vector<Eigen::Vector3f> points = scans->load((2 * i + 1) * scans->size() / (2 * count)).points;
        seen.field.add(points);
        if (seen.field.turn_shown() >= kAllAround) break;
        const std::size_t kept = std::min(kPointsOfScan, points.size());
        for (std::size_t k = 0; k < kept; ++k) seen.points_in_lidar.push_back(points[k * points.size() / kept]);
      } catch (const Error&) {
        continue;  // named where it is used
      }
    }
    any_all_around_ = any_all_around_ || seen.field.turn_shown() >= kAllAround;
    if (seen.field.turn_shown() < kAllAround && !seen.points_in_lidar.empty() && !progress.cancelled())
      sessions_[s] = std::move(seen);
  }
}

bool SharedField::any_narrow() const {
  return std::ranges::any_of(sessions_, [](const std::optional<Seen>& seen) { return seen.has_value(); });
}

cloud::BeamNodes SharedField::beam_nodes() const {
  cloud::Directions seen;
  for (const std::optional<Seen>& session : sessions_)
    if (session) seen.add(session->field);
  if (any_all_around_ || seen.empty() || seen.turn_shown() >= kAllAround) return cloud::BeamNodes::all_around();
  const cloud::FieldBox box = seen.box();
  return cloud::BeamNodes::over(box.azimuth_from_rad, box.azimuth_to_rad, box.elevation_from_rad, box.elevation_to_rad);
}

int SharedField::objects_needed(motion::SessionIndex session, int all_around) const {
  constexpr double kWide = 1.0 / 3.0;  // of a turn: shows what is asked of all
  if (session >= sessions_.size() || !sessions_[session]) return all_around;
  const double part = std::min(1.0, sessions_[session]->field.turn_shown() / kWide);
  return std::min(all_around, std::max(1, static_cast<int>(std::lround(part * all_around))));
}

double SharedField::share(motion::SessionIndex session, const RigidTransform& lidar_b_from_lidar_a) const {
  if (session >= sessions_.size() || !sessions_[session]) return 1.0;
  const Seen& seen = *sessions_[session];
  const Eigen::Isometry3f motion = lidar_b_from_lidar_a.cast<float>();
  const auto common = std::ranges::count_if(seen.points_in_lidar, [&](const Eigen::Vector3f& point_in_a) {
    return seen.field.has_near(Eigen::Vector3f(motion * point_in_a));
  });
  return static_cast<double>(common) / static_cast<double>(seen.points_in_lidar.size());
}

}  // namespace remount::pipeline
