#include "algorithms/odometry/fusion/feature_extraction.h"

#include <algorithm>
#include <cmath>

#include "algorithms/core/index.h"
#include "algorithms/geometry/rotation.h"
#include "algorithms/registration/voxel_grid.h"

namespace remount::odometry {
namespace {

using Beam = std::vector<Eigen::Vector3f>;
constexpr std::size_t kReach = 5;      // neighbours to either side
constexpr std::size_t kSectors = 6;    // line features are spread over the turn
constexpr std::size_t kPerSector = 4;  // of them in a sector of a beam
constexpr float kStraight = 0.02f;     // off the chord, as a share of half its length
constexpr float kCorner = 0.15f;
constexpr float kJump_m = 0.5f;      // in range: something farther begins
constexpr float kThin_m = 0.5f;      // a pole, at most
constexpr float kLeastSlant = 0.2f;  // sine of the angle between beam and surface

float cross_z(const Eigen::Vector3f& a, const Eigen::Vector3f& b) { return a.x() * b.y() - a.y() * b.x(); }

bool in_order_of_azimuth(const Beam& beam) {
  std::size_t left = 0, right = 0;
  for (std::size_t i = 1; i < beam.size(); ++i) ++(cross_z(beam[i - 1], beam[i]) > 0.0f ? left : right);
  return std::min(left, right) * 50 <= beam.size();
}

void sort_by_azimuth(Beam& beam) {
  std::vector<std::pair<float, std::size_t>> order(beam.size());
  for (std::size_t i = 0; i < beam.size(); ++i) order[i] = {std::atan2(beam[i].y(), beam[i].x()), i};
  std::sort(order.begin(), order.end());
  Beam sorted(beam.size());
  for (std::size_t i = 0; i < beam.size(); ++i) sorted[i] = beam[order[i].second];
  beam.swap(sorted);
}

// Beam by beam: the azimuth goes round once for each, in either direction, so it jumps across 0 once a beam.
std::vector<Beam> beams_by_wrap(const std::vector<Eigen::Vector3f>& points) {
  std::vector<Beam> beams(1);
  float previous = 0.0f;
  for (const Eigen::Vector3f& point : points) {
    float azimuth = std::atan2(point.y(), point.x());
    if (azimuth < 0.0f) azimuth += static_cast<float>(2.0 * kPi);
    // Noise may take the first points of a beam to and fro across 0.
    if (std::abs(azimuth - previous) > static_cast<float>(kPi) && beams.back().size() > 2 * kReach)
      beams.emplace_back();
    beams.back().push_back(point);
    previous = azimuth;
  }
  return beams;
}

std::vector<Beam> beams_by_elevation(const std::vector<Eigen::Vector3f>& points) {
  std::vector<Beam> beams(361);
  for (const Eigen::Vector3f& point : points) {
    const float elevation = std::atan2(point.z(), point.head<2>().norm());
    const auto row = std::lround((elevation + static_cast<float>(kPi / 2)) * static_cast<float>(360.0 / kPi));
    beams[index_at(std::clamp(row, 0L, 360L))].push_back(point);
  }
  std::erase_if(beams, [](const Beam& beam) { return beam.empty(); });
  return beams;
}

// One beam prepared: what of it is near enough, how far away, and where its points do not follow one another.
struct Profile {
  const Beam& points;
  std::vector<float> range_m;
  std::vector<bool> gap_after;  // beams without a return lie between this point and the next
};

Profile profile_of(const Beam& beam, float step_rad) {
  Profile profile{beam, {}, std::vector<bool>(beam.size(), true)};
  profile.range_m.reserve(beam.size());
  for (const Eigen::Vector3f& point : beam) profile.range_m.push_back(point.norm());
  const float widest = 3.5f * step_rad;
  for (std::size_t i = 0; i + 1 < beam.size(); ++i) {
    const float level2 = beam[i].head<2>().squaredNorm() * beam[i + 1].head<2>().squaredNorm();
    const float sine = cross_z(beam[i], beam[i + 1]);
    profile.gap_after[i] =
        sine * sine > widest * widest * level2 || beam[i].head<2>().dot(beam[i + 1].head<2>()) < 0.0f;
  }
  return profile;
}

bool is_unbroken(const Profile& profile, std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; ++i)
    if (profile.gap_after[i] || std::abs(profile.range_m[i + 1] - profile.range_m[i]) > kJump_m) return false;
  return true;
}

// Straightness of points [first, last]: largest distance from the chord, m.
float off_line_m(const Beam& beam, std::size_t first, std::size_t last) {
  const Eigen::Vector3f chord = beam[last] - beam[first];
  const float length2 = std::max(chord.squaredNorm(), 1e-12f);
  float worst2 = 0.0f;
  for (std::size_t i = first + 1; i < last; ++i) {
    const Eigen::Vector3f arm = beam[i] - beam[first];
    worst2 = std::max(worst2, (arm - arm.dot(chord) / length2 * chord).squaredNorm());
  }
  return std::sqrt(worst2);
}

float slant(const Beam& beam, std::size_t at, std::size_t along) {
  const Eigen::Vector3f chord = beam[along] - beam[at];
  return chord.cross(beam[at]).norm() / std::max(chord.norm() * beam[at].norm(), 1e-9f);
}

// A corner: both sides run straight, and meet at an angle.
float corner_sharpness(const Profile& profile, std::size_t i, float noise_m) {
  if (!is_unbroken(profile, i - kReach, i + kReach)) return 0.0f;
  const Beam& beam = profile.points;
  const float off = off_chord_m(beam, i);
  const float half = 0.5f * (beam[i + kReach] - beam[i - kReach]).norm();
  if (off < kCorner * half || off < 4.0f * noise_m) return 0.0f;
  const float bent = std::max(off_line_m(beam, i - kReach, i), off_line_m(beam, i, i + kReach));
  if (bent > 0.5f * off || slant(beam, i, i - kReach) < kLeastSlant || slant(beam, i, i + kReach) < kLeastSlant)
    return 0.0f;
  return off / std::max(half, 1e-6f);
}

// The near side of a jump: the surface on its own side runs straight and is not grazed.
float edge_sharpness(const Profile& profile, std::size_t i, float noise_m) {
  const Beam& beam = profile.points;
  const auto side = [&](bool before) {
    const std::size_t far = before ? i - 1 : i + 1, end = before ? i + kReach : i - kReach;
    const std::size_t first = std::min(i, end), last = std::max(i, end);
    if (profile.gap_after[std::min(i, far)] || profile.range_m[far] < profile.range_m[i] + kJump_m) return false;
    return is_unbroken(profile, first, last) && slant(beam, i, end) > 2.0f * kLeastSlant &&
           off_line_m(beam, first, last) < 3.0f * noise_m + kStraight * (beam[end] - beam[i]).norm();
  };
  return side(true) || side(false) ? 1.0f : 0.0f;
}

// A run of points with something farther on both sides, and narrow: its middle.
std::size_t thin_object_end(const Profile& profile, std::size_t first) {
  const Beam& beam = profile.points;
  if (profile.gap_after[first - 1] || profile.range_m[first - 1] < profile.range_m[first] + kJump_m) return 0;
  for (std::size_t last = first; last + 1 < beam.size(); ++last) {
    if (profile.gap_after[last] || (beam[last] - beam[first]).norm() > kThin_m) return 0;
    const float jump = profile.range_m[last + 1] - profile.range_m[last];
    if (jump > kJump_m) return last + 1;
    if (jump < -kJump_m) return 0;
  }
  return 0;
}

void add_thin_objects(const Profile& profile, std::vector<Eigen::Vector3f>& lines) {
  for (std::size_t i = 1; i + 1 < profile.points.size(); ++i) {
    const std::size_t end = thin_object_end(profile, i);
    if (end < i + 2) continue;  // a single return may be rain
    Eigen::Vector3f mean = Eigen::Vector3f::Zero();
    for (std::size_t k = i; k < end; ++k) mean += profile.points[k];
    lines.push_back(mean / static_cast<float>(end - i));
  }
}

void add_lines(const Profile& profile, float noise_m, std::vector<Eigen::Vector3f>& lines) {
  const std::size_t count = profile.points.size() - 2 * kReach;
  std::vector<std::pair<float, std::size_t>> sharp;
  for (std::size_t sector = 0; sector < kSectors; ++sector) {
    sharp.clear();
    const std::size_t begin = kReach + count * sector / kSectors, end = kReach + count * (sector + 1) / kSectors;
    for (std::size_t i = begin; i < end; ++i) {
      const float corner = corner_sharpness(profile, i, noise_m);
      const float sharpness = corner > 0.0f ? corner : edge_sharpness(profile, i, noise_m);
      if (sharpness > 0.0f) sharp.emplace_back(-sharpness, i);
    }
    std::sort(sharp.begin(), sharp.end());
    std::vector<std::size_t> taken;
    for (const auto& candidate : sharp) {
      const std::size_t i = candidate.second;
      const auto near = [i](std::size_t other) { return std::max(i, other) - std::min(i, other) <= kReach; };
      if (taken.size() == kPerSector) break;
      if (std::any_of(taken.begin(), taken.end(), near)) continue;
      taken.push_back(i);
      lines.push_back(profile.points[i]);
    }
  }
}

void add_planes(const Profile& profile, float noise_m, std::vector<Eigen::Vector3f>& planes) {
  const Beam& beam = profile.points;
  std::size_t gap_free_from = 0;
  for (std::size_t i = 0; i + 1 < beam.size(); ++i) {
    // i runs ahead; the candidate is kReach behind it, so that its window is known to be without gaps.
    if (i >= 2 * kReach && gap_free_from + 2 * kReach <= i) {
      const std::size_t at = i - kReach;
      const float half = 0.5f * (beam[at + kReach] - beam[at - kReach]).norm();
      if (off_chord_m(beam, at) < std::max(2.0f * noise_m, kStraight * half) && half < 3.0f) planes.push_back(beam[at]);
    }
    if (profile.gap_after[i]) gap_free_from = i + 1;
  }
}

cloud::PointCloud within_range(const cloud::PointCloud& cloud, const FusionOptions& options) {
  cloud::PointCloud kept;
  const bool rings = cloud.ring.size() == cloud.size();
  const auto least = static_cast<float>(options.min_range_m), most = static_cast<float>(options.max_range_m);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const float range2 = cloud.points[i].squaredNorm();
    if (!(range2 >= least * least && range2 <= most * most)) continue;
    kept.points.push_back(cloud.points[i]);
    if (rings) kept.ring.push_back(cloud.ring[i]);
  }
  return kept;
}

}  // namespace

std::vector<Beam> points_by_beam(const cloud::PointCloud& cloud_in_lidar) {
  std::vector<Beam> beams;
  if (cloud_in_lidar.ring.size() == cloud_in_lidar.size()) {
    for (std::size_t i = 0; i < cloud_in_lidar.size(); ++i) {
      if (cloud_in_lidar.ring[i] >= beams.size()) beams.resize(std::size_t{cloud_in_lidar.ring[i]} + 1);
      beams[cloud_in_lidar.ring[i]].push_back(cloud_in_lidar.points[i]);
    }
  } else {
    beams = beams_by_wrap(cloud_in_lidar.points);
    if (beams.size() < 4 || beams.size() > 300) beams = beams_by_elevation(cloud_in_lidar.points);
  }
  for (Beam& beam : beams)
    if (!in_order_of_azimuth(beam)) sort_by_azimuth(beam);
  return beams;
}

float off_chord_m(const Beam& beam, std::size_t index) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (std::size_t k = 1; k <= kReach; ++k) sum += beam[index - k] + beam[index + k];
  const Eigen::Vector3f off = sum / static_cast<float>(2 * kReach) - beam[index];
  const Eigen::Vector3f chord = beam[index + kReach] - beam[index - kReach];
  const float length2 = chord.squaredNorm();
  return length2 > 0.0f ? (off - off.dot(chord) / length2 * chord).norm() : off.norm();
}

ScanFeatures extract_features(const cloud::PointCloud& cloud_in_lidar, const FusionOptions& options) {
  const std::vector<Beam> beams = points_by_beam(within_range(cloud_in_lidar, options));
  std::size_t most = 1;
  for (const Beam& beam : beams) most = std::max(most, beam.size());
  const float step_rad = static_cast<float>(2.0 * kPi) / static_cast<float>(most);
  const auto noise_m = static_cast<float>(std::max(options.range_noise_m, 0.001));
  ScanFeatures features;
  for (const Beam& beam : beams) {
    if (beam.size() < 4 * kReach) continue;
    const Profile profile = profile_of(beam, step_rad);
    if (options.lines) {
      add_thin_objects(profile, features.lines);
      add_lines(profile, noise_m, features.lines);
    }
    if (options.planes) add_planes(profile, noise_m, features.planes);
  }
  features.lines = registration::voxel_centroids(features.lines, static_cast<float>(options.line_voxel_m));
  features.planes = registration::voxel_centroids(features.planes, static_cast<float>(options.plane_voxel_m));
  return features;
}

}  // namespace remount::odometry
