#include "widgets/pairs/pair_thumbnail.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "algorithms/core/median.h"
#include "algorithms/quality/surface_distance.h"
#include "widgets/basics/swatch.h"
#include "widgets/scene/pair_colors.h"
#include "widgets/scene/pair_scene_parts.h"
#include "widgets/scene/signed_scale.h"

namespace remount::widgets {
namespace {

// Of the beginnings of clouds that are ordered by levels: each shows the whole.
constexpr std::size_t kPointsOfB = 9000, kPointsOfA = 6000;
constexpr int kSectionShare = 4;  // of the height, the lowest
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::vector<Eigen::Vector3f> beginning_of(const scene::CloudGeometry& geometry, std::size_t most) {
  const std::vector<Eigen::Vector3f>& points = geometry.cloud->points;
  return {points.begin(), points.begin() + static_cast<std::ptrdiff_t>(std::min(points.size(), most))};
}

/// Draws dots of a picture, where they are within it.
class Dots {
 public:
  Dots(QImage& picture, const QRect& area) : picture_(picture), area_(area) {}
  void add(double x_px, double y_px, QRgb color) {
    const QPoint at(static_cast<int>(std::lround(x_px)), static_cast<int>(std::lround(y_px)));
    if (area_.contains(at)) picture_.setPixel(at, color);
  }

 private:
  QImage& picture_;
  QRect area_;
};

struct FromAbove {
  QRect area;
  double px_per_m = 1.0;

  void draw(QImage& picture, const std::vector<Eigen::Vector3f>& points, const RigidTransform& vehicle_from_scan,
            const std::function<QRgb(std::size_t)>& color) const {
    Dots dots(picture, area);
    const Eigen::Matrix3f turn = vehicle_from_scan.linear().cast<float>();
    const Eigen::Vector3f offset = vehicle_from_scan.translation().cast<float>();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3f place = turn * points[i] + offset;
      dots.add(area.center().x() + static_cast<double>(place.x()) * px_per_m,
               area.center().y() - static_cast<double>(place.y()) * px_per_m, color(i));
    }
  }
};

void draw_cut(QImage& picture, const QRect& area, const quality::Section& section, const quality::SectionCut& cut,
              double limit_m, QRgb color_a, QRgb color_b) {
  Dots dots(picture, area);
  const double along = 0.5 * area.width() / section.half_size_m.x(), across = 0.5 * area.height() / (2.0 * limit_m);
  for (const auto& [points, color] : {std::pair(&cut.scan_b_m, color_b), std::pair(&cut.scan_a_m, color_a)})
    for (const Eigen::Vector2f& point : *points)
      dots.add(area.center().x() + static_cast<double>(point.x()) * along,
               area.center().y() - static_cast<double>(point.y()) * across, color);
}

}  // namespace

PairThumbnail paint_thumbnail(const scene::PairSceneData& data, const scene::PairTransforms& transforms,
                              scene::PairAlignment alignment, const RigidTransform& vehicle_from_ins,
                              const ThumbnailStyle& style, const Progress& progress) {
  const RigidTransform& b_from_a = transforms.of(alignment);
  const std::vector<Eigen::Vector3f> a = beginning_of(data.cloud_a(), kPointsOfA),
                                     b = beginning_of(data.cloud_b(), kPointsOfB);
  const auto surfaces = data.scan_b->surfaces(progress);
  if (progress.cancelled()) return {};
  const std::vector<float> signed_m = surfaces->signed_of(a, b_from_a, progress);
  if (progress.cancelled()) return {};
  const scene::ScanColors colors = scene::scan_colors(style.dark);
  const auto rgb = [](const scene::SceneColor& color) { return qRgb(color[0], color[1], color[2]); };

  PairThumbnail thumbnail{QImage(style.size, QImage::Format_RGB32), kNone, kNone};
  thumbnail.picture.fill(style.dark ? QColor(28, 30, 33) : QColor(248, 249, 250));
  const int strip = style.size.height() / kSectionShare;
  const FromAbove above{QRect(0, 0, style.size.width(), style.size.height() - strip - 1),
                        0.5 * style.size.width() / style.reach_m};
  const RigidTransform vehicle_from_b = vehicle_from_ins * transforms.view_from_lidar_b;
  above.draw(thumbnail.picture, b, vehicle_from_b, [&](std::size_t) { return rgb(colors.target); });
  const scene::SignedScale scale(style.limit_m);
  above.draw(thumbnail.picture, a, vehicle_from_b * b_from_a,
             [&](std::size_t i) { return rgb(scale.color(signed_m[i])); });
  thumbnail.median_m = static_cast<double>(quality::median_distance_m(signed_m));

  const quality::SectionScans scans{data.scan_a->cloud().points, data.scan_b->cloud().points, b_from_a};
  const std::vector<quality::Section> walls = quality::find_sections(
      {scans.points_in_lidar_a, scans.points_in_lidar_b, transforms.registered_lidar_b_from_lidar_a},
      quality::SectionKind::Wall, data.scan_b->scan()->up_in_lidar.cast<double>(), 1, progress);
  if (progress.cancelled()) return {};
  if (!walls.empty()) {
    const quality::SectionCut cut = quality::cut_section(scans, walls.front());
    draw_cut(thumbnail.picture, QRect(0, style.size.height() - strip, style.size.width(), strip), walls.front(), cut,
             style.limit_m, rgb(colors.orange), rgb(colors.target));
    if (cut.measured) thumbnail.thickness_m = cut.thickness_together_m;
  }
  return thumbnail;
}

double thumbnail_limit_m(const std::vector<motion::Pair>& pairs) {
  std::vector<double> rmse_m;
  for (const motion::Pair& pair : pairs)
    if (pair.registration.attempted && pair.registration.rmse_m > 0.0) rmse_m.push_back(pair.registration.rmse_m);
  const double wanted_m = rmse_m.empty() ? 0.1 : 3.0 * median_of(std::move(rmse_m));
  for (const double limit_m : {0.02, 0.05, 0.1, 0.2, 0.5})
    if (wanted_m <= limit_m) return limit_m;
  return 1.0;
}

}  // namespace remount::widgets
