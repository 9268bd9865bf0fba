#include "algorithms/quality/section.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "algorithms/core/median.h"
#include "algorithms/core/symmetric_eigen.h"

namespace remount::quality {
namespace {

constexpr double kApart_m = 3.0;
constexpr std::size_t kFewestInCell = 15, kEnough = 300;
constexpr double kThickest_m = 0.06;      // of the surface of one scan in a cell
constexpr double kSameNormal = 0.98;      // cosine of the angle between the normals of a cell and of its slab
constexpr double kNarrowest_m = 0.15;     // standard deviation of the points of a surface along it
constexpr double kMad = 1.4826;           // from the median of absolute deviations to a standard deviation
constexpr std::size_t kLookedAt = 60000;  // points of a scan, evenly in the order in which they were measured
constexpr double kFarthest_m = 80.0;      // beyond it points are too few to see a surface

/// Of a kind: the cells in which it is looked for, and the slab that is cut, along its directions.
struct Shape {
  Eigen::Vector3d cell_m, half_size_m;
};
Shape shape_of(SectionKind kind) {
  if (kind == SectionKind::Wall) return {{1.0, 1.0, 1.0}, {2.5, 0.4, 0.75}};
  if (kind == SectionKind::Ground) return {{1.5, 1.5, 1.0}, {2.5, 0.4, 1.0}};
  return {{0.8, 0.8, 3.0}, {0.6, 0.6, 1.5}};
}

/// Points of one scan in a cell: sums, from which their distribution follows.
struct Sums {
  std::size_t count = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();

  void add(const Eigen::Vector3d& point) {
    ++count;
    sum += point;
    squares += point * point.transpose();
  }
  Eigen::Vector3d mean() const { return sum / static_cast<double>(count); }
  Eigen::Matrix3d covariance() const { return squares / static_cast<double>(count) - mean() * mean().transpose(); }
};

struct Cell {
  Sums a, b;
};
using Cells = std::map<std::array<int, 3>, Cell>;

/// Level axes around `up`.
Eigen::Matrix3d level_from(const Eigen::Vector3d& up) {
  Eigen::Matrix3d axes;
  axes.row(2) = up.normalized().transpose();
  axes.row(0) = up.unitOrthogonal().transpose();
  axes.row(1) = axes.row(2).cross(axes.row(0));
  return axes;
}

void fill_cells(const std::vector<Eigen::Vector3f>& points, const RigidTransform& level_from_scan,
                const Eigen::Vector3d& cell_m, Sums Cell::*scan, Cells& cells) {
  const std::size_t step = std::max<std::size_t>(1, points.size() / kLookedAt);
  for (std::size_t i = 0; i < points.size(); i += step) {
    if (!points[i].allFinite()) continue;
    const Eigen::Vector3d point = level_from_scan * points[i].cast<double>();
    if (point.cwiseAbs().maxCoeff() > kFarthest_m) continue;
    const Eigen::Vector3i place = point.cwiseQuotient(cell_m).array().floor().matrix().cast<int>();
    (cells[{place.x(), place.y(), place.z()}].*scan).add(point);
  }
}

/// Directions of a section where this is the kind of surface that is looked for, and how thick it is.
struct Judged {
  Eigen::Vector3d along, normal;
  double thickness_m = 0.0;
};
std::optional<Judged> judge_surface(const Sums& sums, SectionKind kind) {
  const auto eigen = symmetric_eigen(sums.covariance());
  const Eigen::Vector3d spread_m = eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  if (kind == SectionKind::Pole) {
    const bool upright = std::abs(eigen.eigenvectors().col(2).z()) > 0.97 && spread_m[2] > 0.4;
    if (!upright || spread_m[1] > 0.12) return std::nullopt;
    return Judged{Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), spread_m[1]};
  }
  const Eigen::Vector3d normal = eigen.eigenvectors().col(0);
  // As wide as it is high, or what stands there is a post.
  const bool flat = spread_m[0] < kThickest_m && spread_m[1] > std::max(kNarrowest_m, 2.0 * spread_m[0]);
  const double rise = std::abs(normal.z());
  if (!flat || (kind == SectionKind::Wall ? rise > 0.2 : rise < 0.97)) return std::nullopt;
  const Eigen::Vector3d along = kind == SectionKind::Wall ? normal.cross(Eigen::Vector3d::UnitZ()).normalized()
                                                          : normal.cross(Eigen::Vector3d::UnitY()).normalized();
  return Judged{along, normal, spread_m[0]};
}

Section section_of(const Judged& judged, const Eigen::Vector3d& centre_in_level, SectionKind kind,
                   const Eigen::Matrix3d& level_from_lidar_b) {
  Section section;
  section.kind = kind;
  section.centre_in_lidar_b = level_from_lidar_b.transpose() * centre_in_level;
  // The normal looks to the sensor, so that "before" is the side from which the surface is seen.
  const double side = judged.normal.dot(centre_in_level) > 0.0 ? -1.0 : 1.0;
  Eigen::Matrix3d axes;
  axes.col(0) = judged.along;
  axes.col(1) = kind == SectionKind::Pole ? judged.normal : Eigen::Vector3d(side * judged.normal);
  axes.col(2) = axes.col(0).cross(axes.col(1));
  section.lidar_b_from_section = level_from_lidar_b.transpose() * axes;
  section.half_size_m = shape_of(kind).half_size_m;
  return section;
}

double robust_sigma_m(const std::vector<float>& values) {
  const float middle = median_of(values);
  std::vector<float> apart(values.size());
  std::transform(values.begin(), values.end(), apart.begin(), [&](float value) { return std::abs(value - middle); });
  return kMad * static_cast<double>(median_of(std::move(apart)));
}

std::vector<Eigen::Vector2f> cut(const std::vector<Eigen::Vector3f>& points, const RigidTransform& lidar_b_from_scan,
                                 const Section& section) {
  const Eigen::Matrix3f section_from_scan =
      (section.lidar_b_from_section.transpose() * lidar_b_from_scan.linear()).cast<float>();
  const Eigen::Vector3f offset =
      (section.lidar_b_from_section.transpose() * (lidar_b_from_scan.translation() - section.centre_in_lidar_b))
          .cast<float>();
  const Eigen::Vector3f half_m = section.half_size_m.cast<float>();
  std::vector<Eigen::Vector2f> within;
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3f placed = section_from_scan * point + offset;
    // Not "outside": what is not finite is not within.
    if ((placed.cwiseAbs().array() <= half_m.array()).all()) within.push_back(placed.head<2>());
  }
  return within;
}

std::vector<float> across(const std::vector<Eigen::Vector2f>& points_m, double most_m) {
  std::vector<float> values;
  for (const Eigen::Vector2f& point : points_m)
    if (std::abs(point.y()) <= static_cast<float>(most_m)) values.push_back(point.y());
  return values;
}

Eigen::Vector2d middle_of(const std::vector<Eigen::Vector2f>& points_m) {
  std::vector<float> x, y;
  for (const Eigen::Vector2f& point : points_m) x.push_back(point.x()), y.push_back(point.y());
  return {static_cast<double>(median_of(std::move(x))), static_cast<double>(median_of(std::move(y)))};
}

void measure_surface(SectionCut& cut) {
  std::vector<float> a = across(cut.scan_a_m, SectionCut::kSurface_m), b = across(cut.scan_b_m, SectionCut::kSurface_m);
  if (a.size() < SectionCut::kFewest || b.size() < SectionCut::kFewest) return;
  cut.measured = true;
  cut.thickness_a_m = robust_sigma_m(a);
  cut.thickness_b_m = robust_sigma_m(b);
  cut.offset_m = static_cast<double>(median_of(a) - median_of(b));
  a.insert(a.end(), b.begin(), b.end());
  cut.thickness_together_m = robust_sigma_m(a);
}

void measure_pole(SectionCut& cut) {
  if (cut.scan_a_m.size() < SectionCut::kFewest || cut.scan_b_m.size() < SectionCut::kFewest) return;
  cut.measured = true;
  const Eigen::Vector2d axis_a = middle_of(cut.scan_a_m), axis_b = middle_of(cut.scan_b_m);
  cut.offset_m = (axis_a - axis_b).norm();
  const auto spread_m = [](const std::vector<Eigen::Vector2f>& points_m, const Eigen::Vector2d& axis) {
    std::vector<float> radii;
    for (const Eigen::Vector2f& point : points_m) radii.push_back((point - axis.cast<float>()).norm());
    return static_cast<double>(median_of(std::move(radii)));
  };
  cut.thickness_a_m = spread_m(cut.scan_a_m, axis_a);
  cut.thickness_b_m = spread_m(cut.scan_b_m, axis_b);
  std::vector<Eigen::Vector2f> both = cut.scan_a_m;
  both.insert(both.end(), cut.scan_b_m.begin(), cut.scan_b_m.end());
  cut.thickness_together_m = spread_m(both, 0.5 * (axis_a + axis_b));
}

/// A cell is small: the normal of the surface is that of all points of scan b in the slab.
Section refined(const Section& section, const std::vector<Eigen::Vector3f>& points_in_lidar_b) {
  if (section.kind == SectionKind::Pole) return section;
  const Eigen::Matrix3d section_from_lidar_b = section.lidar_b_from_section.transpose();
  Eigen::Vector3d half_m = section.half_size_m;
  half_m.y() = 2.0 * kThickest_m;
  Sums near;
  for (const Eigen::Vector3f& point : points_in_lidar_b) {
    const Eigen::Vector3d placed = section_from_lidar_b * (point.cast<double>() - section.centre_in_lidar_b);
    if ((placed.cwiseAbs().array() <= half_m.array()).all()) near.add(placed);
  }
  if (near.count < kFewestInCell) return section;
  const auto eigen = symmetric_eigen(near.covariance());
  Eigen::Vector3d normal = eigen.eigenvectors().col(0);
  if (normal.y() < 0.0) normal = -normal;
  if (normal.y() < kSameNormal) return section;  // something else crosses the slab
  Eigen::Matrix3d axes;
  axes.col(1) = normal;
  axes.col(0) = (Eigen::Vector3d::UnitX() - normal.x() * normal).normalized();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  Section turned = section;
  // On the surface, in the middle of the slab.
  turned.centre_in_lidar_b +=
      section.lidar_b_from_section * Eigen::Vector3d(0.0, near.mean().dot(normal) / normal.y(), 0.0);
  turned.lidar_b_from_section = section.lidar_b_from_section * axes;
  return turned;
}

struct Ranked {
  double score = 0.0;
  Section section;
};

std::vector<Ranked> rank_cells(const Cells& cells, SectionKind kind, const Eigen::Matrix3d& level_from_lidar_b) {
  std::vector<Ranked> ranked;
  for (const auto& [place, cell] : cells) {
    const std::size_t seen = std::min(cell.a.count, cell.b.count);
    if (seen < kFewestInCell) continue;
    const auto judged = judge_surface(cell.b, kind);
    if (!judged || !judge_surface(cell.a, kind)) continue;
    const double points = static_cast<double>(std::min(seen, kEnough));
    ranked.push_back({std::sqrt(points) / (0.01 + judged->thickness_m),
                      section_of(*judged, cell.b.mean(), kind, level_from_lidar_b)});
  }
  // Equal scores in the order of their cells: the same for the same scans.
  std::stable_sort(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b) { return a.score > b.score; });
  return ranked;
}

}  // namespace

Section Section::moved(const Eigen::Vector3d& by_m) const {
  Section section = *this;
  section.centre_in_lidar_b += lidar_b_from_section * by_m;
  return section;
}

std::vector<Section> find_sections(const SectionScans& scans, SectionKind kind, const Eigen::Vector3d& up_in_lidar_b,
                                   std::size_t most, const Progress& progress) {
  const Eigen::Matrix3d level_from_lidar_b = level_from(up_in_lidar_b);
  RigidTransform level = RigidTransform::Identity();
  level.linear() = level_from_lidar_b;
  const Eigen::Vector3d cell_m = shape_of(kind).cell_m;
  Cells cells;
  fill_cells(scans.points_in_lidar_b, level, cell_m, &Cell::b, cells);
  if (progress.cancelled()) return {};
  fill_cells(scans.points_in_lidar_a, level * scans.lidar_b_from_lidar_a, cell_m, &Cell::a, cells);
  if (progress.cancelled()) return {};
  std::vector<Section> found;
  for (const Ranked& one : rank_cells(cells, kind, level_from_lidar_b)) {
    if (found.size() >= most) break;
    const bool is_apart = std::all_of(found.begin(), found.end(), [&](const Section& other) {
      return (other.centre_in_lidar_b - one.section.centre_in_lidar_b).norm() >= kApart_m;
    });
    if (is_apart) found.push_back(one.section);
  }
  for (Section& section : found) section = refined(section, scans.points_in_lidar_b);
  return found;
}

Section section_at(const SectionScans& scans, SectionKind kind, const Eigen::Vector3d& point_in_lidar_b,
                   const Eigen::Vector3d& up_in_lidar_b) {
  const Eigen::Matrix3d level_from_lidar_b = level_from(up_in_lidar_b);
  const Eigen::Vector3d half_m = 0.5 * shape_of(kind).cell_m, centre = level_from_lidar_b * point_in_lidar_b;
  Sums near;
  for (const Eigen::Vector3f& measured : scans.points_in_lidar_b) {
    const Eigen::Vector3d point = level_from_lidar_b * measured.cast<double>();
    if (((point - centre).cwiseAbs().array() <= half_m.array()).all()) near.add(point);
  }
  if (near.count >= kFewestInCell)
    if (const auto judged = judge_surface(near, kind))
      return refined(section_of(*judged, near.mean(), kind, level_from_lidar_b), scans.points_in_lidar_b);
  const bool is_ground = kind == SectionKind::Ground;
  return section_of({Eigen::Vector3d::UnitX(), is_ground ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY(), 0.0},
                    centre, kind, level_from_lidar_b);
}

SectionCut cut_section(const SectionScans& scans, const Section& section) {
  SectionCut out;
  out.scan_a_m = cut(scans.points_in_lidar_a, scans.lidar_b_from_lidar_a, section);
  out.scan_b_m = cut(scans.points_in_lidar_b, RigidTransform::Identity(), section);
  section.kind == SectionKind::Pole ? measure_pole(out) : measure_surface(out);
  return out;
}

}  // namespace remount::quality
