#include "algorithms/registration/coarse_alignment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "algorithms/cloud/level_frame.h"
#include "algorithms/cloud/objects.h"
#include "algorithms/core/index.h"
#include "algorithms/geometry/rotation.h"

namespace remount::registration {
namespace {

constexpr float kCell_m = 0.5f;
constexpr float kRange_m = 45.0f;      // farther away a step of yaw misses the cell
constexpr double kMeeting_m = 1000.0;  // farther apart no two scans share a place, and cells could not be counted
constexpr double kYawStep_rad = 0.02;
constexpr std::array<float, 4> kLayersFrom_m{0.4f, 1.5f, 3.0f, 6.0f};  // cars; people and fences; signs; facades
constexpr float kUpright = 0.6f;                                       // most cosine of a normal with up
constexpr std::size_t kMostCells = 2500;                               // of the source: more change nothing
constexpr int kFullHit = 4;

// Rotates and lifts a scan so that its ground is z = 0.
struct Level {
  RigidTransform level_from_lidar = RigidTransform::Identity();
  bool ground = false;
};

Level level_of(const PreparedCloud& scan, const Eigen::Vector3f& hint) {
  cloud::PointCloud cloud;
  cloud.points = scan.copy_points();
  const cloud::GroundPlane plane = cloud::estimate_ground_plane(cloud, hint);
  return {make_rigid(cloud::level_from_lidar(plane.up_in_lidar).cast<double>(), {0.0, 0.0, plane.sensor_height_m}),
          plane.found};
}

struct UprightPoint {
  float x, y;
  std::size_t layer;
};

std::vector<UprightPoint> upright_points(const PreparedCloud& scan, const RigidTransform& level_from_lidar) {
  const Eigen::Isometry3f level = level_from_lidar.cast<float>();
  std::vector<UprightPoint> out;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const Eigen::Vector3f p = level * scan.point(i);
    if (p.z() < kLayersFrom_m[0] || p.head<2>().squaredNorm() > kRange_m * kRange_m) continue;
    if (std::abs((level.linear() * scan.normal(i)).z()) > kUpright) continue;
    std::size_t layer = kLayersFrom_m.size() - 1;
    while (p.z() < kLayersFrom_m[layer]) --layer;
    out.push_back({p.x(), p.y(), layer});
  }
  return out;
}

// Where structure stands in the target, by layer; beside it a hit counts less.
class Field {
 public:
  Field(const std::vector<UprightPoint>& points, int margin_cells)
      : half_(static_cast<int>(std::ceil(kRange_m / kCell_m)) + margin_cells + 2),
        side_(2 * half_ + 1),
        cells_(kLayersFrom_m.size() * cell_count(side_, side_), 0) {
    for (const UprightPoint& p : points)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          std::uint8_t& cell = cells_[at(p.layer, cell_of(p.x) + dx, cell_of(p.y) + dy)];
          cell = std::max(cell, static_cast<std::uint8_t>(kFullHit >> (std::abs(dx) + std::abs(dy))));
        }
  }
  static int cell_of(float v_m) { return static_cast<int>(std::floor(v_m / kCell_m)); }
  bool holds(int x, int y, int margin) const { return std::abs(x) + margin <= half_ && std::abs(y) + margin <= half_; }
  const std::uint8_t* row(std::size_t layer, int x, int y) const { return cells_.data() + at(layer, x, y); }

 private:
  std::size_t at(std::size_t layer, int x, int y) const {
    return layer * cell_count(side_, side_) + cell_at(y + half_, x + half_, side_);
  }
  int half_, side_;
  std::vector<std::uint8_t> cells_;
};

// One point a cell and layer, and not too many.
std::vector<UprightPoint> thin(const std::vector<UprightPoint>& points) {
  std::vector<UprightPoint> kept;
  std::vector<std::uint64_t> keys;
  for (const UprightPoint& p : points)
    keys.push_back((p.layer << 40) | (static_cast<std::uint64_t>(Field::cell_of(p.y) + 1024) << 20) |
                   static_cast<std::uint64_t>(Field::cell_of(p.x) + 1024));
  std::vector<std::size_t> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  for (std::size_t k = 0; k < order.size(); ++k)
    if (k == 0 || keys[order[k]] != keys[order[k - 1]]) kept.push_back(points[order[k]]);
  const std::size_t every = 1 + kept.size() / kMostCells;
  for (std::size_t i = 0; i * every < kept.size(); ++i) kept[i] = kept[i * every];
  kept.resize((kept.size() + every - 1) / every);
  return kept;
}

// Scores of every shift by whole cells at one yaw, row by row.
class Correlation {
 public:
  explicit Correlation(int reach_cells)
      : reach_(reach_cells), width_(2 * reach_cells + 1), sums_(cell_count(width_, width_)) {}

  void compute(const Field& field, const std::vector<UprightPoint>& source, double yaw_rad,
               const Eigen::Vector2d& centre_m) {
    std::fill(sums_.begin(), sums_.end(), std::uint16_t{0});
    const auto c = static_cast<float>(std::cos(yaw_rad)), s = static_cast<float>(std::sin(yaw_rad));
    const auto x0 = static_cast<float>(centre_m.x()), y0 = static_cast<float>(centre_m.y());
    for (const UprightPoint& p : source) {
      const int x = Field::cell_of(c * p.x - s * p.y + x0), y = Field::cell_of(s * p.x + c * p.y + y0);
      if (!field.holds(x, y, reach_)) continue;
      std::uint16_t* out = sums_.data();
      for (int dy = -reach_; dy <= reach_; ++dy, out += width_) {
        const std::uint8_t* in = field.row(p.layer, x - reach_, y + dy);
        for (int k = 0; k < width_; ++k) out[k] = static_cast<std::uint16_t>(out[k] + in[k]);
      }
    }
  }
  int reach() const { return reach_; }
  int score(int dx, int dy) const {
    if (std::max(std::abs(dx), std::abs(dy)) > reach_) return -1;
    return sums_[cell_at(dy + reach_, dx + reach_, width_)];
  }

 private:
  int reach_, width_;
  std::vector<std::uint16_t> sums_;
};

struct Cell {
  int score = 0;
  double yaw_rad = 0.0;
  int dx = 0, dy = 0;
};

// Peaks among the shifts at one yaw.
void add_peaks(const Correlation& sums, double yaw_rad, int radius_cells, std::vector<Cell>& peaks) {
  for (int dy = -sums.reach(); dy <= sums.reach(); ++dy)
    for (int dx = -sums.reach(); dx <= sums.reach(); ++dx) {
      if (dx * dx + dy * dy > radius_cells * radius_cells) continue;
      const int score = sums.score(dx, dy);
      // Of equal neighbours the first counts.
      const bool peak = score > sums.score(dx - 1, dy) && score >= sums.score(dx + 1, dy) &&
                        score > sums.score(dx, dy - 1) && score >= sums.score(dx, dy + 1);
      if (peak && score > 0) peaks.push_back({score, yaw_rad, dx, dy});
    }
}

// The best that are not next to a better one.
std::vector<Cell> apart(std::vector<Cell> peaks, std::size_t most) {
  constexpr double kApart_m = 1.2, kApart_rad = 0.09;
  std::stable_sort(peaks.begin(), peaks.end(), [](const Cell& a, const Cell& b) { return a.score > b.score; });
  std::vector<Cell> kept;
  for (const Cell& peak : peaks) {
    const bool beside = std::any_of(kept.begin(), kept.end(), [&](const Cell& other) {
      const double distance_m = kCell_m * std::hypot(peak.dx - other.dx, peak.dy - other.dy);
      return std::hypot(distance_m / kApart_m, wrap_angle_rad(peak.yaw_rad - other.yaw_rad) / kApart_rad) < 1.0;
    });
    if (!beside) kept.push_back(peak);
    if (kept.size() == most) break;
  }
  return kept;
}

}  // namespace

std::vector<CoarseMode> coarse_modes(const PreparedCloud& source, const PreparedCloud& target,
                                     const RigidTransform& start, const RegistrationOptions& options, std::size_t most,
                                     const Progress& progress) {
  if (!(start.translation().norm() < kMeeting_m)) return {};
  const Level target_level = level_of(target, Eigen::Vector3f::Zero());
  if (progress.cancelled()) return {};
  Level source_level = level_of(source, Eigen::Vector3f::Zero());
  if (progress.cancelled()) return {};
  // Where the two grounds contradict the start by more than is searched, one of them is a wall.
  const Eigen::Vector3d up_in_target = target_level.level_from_lidar.linear().row(2),
                        up_of_source = start.linear() * source_level.level_from_lidar.linear().row(2).transpose();
  const double reach_rad = degrees_to_radians(options.search_reach_deg);
  const bool level = target_level.ground && source_level.ground &&
                     std::acos(std::clamp(up_in_target.dot(up_of_source), -1.0, 1.0)) < reach_rad;
  if (!level) source_level.level_from_lidar = target_level.level_from_lidar * start;
  if (!level) source_level.level_from_lidar.translation().head<2>().setZero();

  const Eigen::Matrix3d turn =
      target_level.level_from_lidar.linear() * start.linear() * source_level.level_from_lidar.linear().transpose();
  const double start_yaw_rad = std::atan2(turn(1, 0) - turn(0, 1), turn(0, 0) + turn(1, 1));
  const Eigen::Vector2d centre_m = (target_level.level_from_lidar.linear() * start.translation()).head<2>();

  const int reach_cells = static_cast<int>(std::ceil(options.search_reach_m / kCell_m));
  const Field field(upright_points(target, target_level.level_from_lidar), reach_cells);
  const std::vector<UprightPoint> cells = thin(upright_points(source, source_level.level_from_lidar));
  Correlation sums(reach_cells);
  std::vector<Cell> peaks;
  const int yaw_steps = static_cast<int>(std::ceil(reach_rad / kYawStep_rad));
  for (int k = -yaw_steps; k <= yaw_steps; ++k) {
    if (progress.cancelled()) return {};
    sums.compute(field, cells, start_yaw_rad + k * kYawStep_rad, centre_m);
    add_peaks(sums, start_yaw_rad + k * kYawStep_rad, reach_cells, peaks);
  }
  std::vector<CoarseMode> modes;
  for (const Cell& cell : apart(std::move(peaks), most)) {
    const Eigen::Vector3d shift(centre_m.x() + static_cast<double>(kCell_m) * cell.dx,
                                centre_m.y() + static_cast<double>(kCell_m) * cell.dy, 0.0);
    const RigidTransform level_from_level = make_rigid(so3_exp(Eigen::Vector3d(0.0, 0.0, cell.yaw_rad)), shift);
    modes.push_back({target_level.level_from_lidar.inverse() * level_from_level * source_level.level_from_lidar,
                     static_cast<double>(cell.score) / (kFullHit * static_cast<double>(cells.size()))});
  }
  return modes;
}

}  // namespace remount::registration
