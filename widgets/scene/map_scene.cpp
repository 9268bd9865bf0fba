#include "widgets/scene/map_scene.h"

#include <algorithm>

#include "widgets/scene/cloud_actor.h"
#include "widgets/scene/frame_budget.h"
#include "widgets/scene/point_grid.h"

namespace remount::scene {

struct MapSceneData {
  std::shared_ptr<const CloudGeometry> geometry;
  std::shared_ptr<const std::vector<SceneColor>> colors;
  PointGrid grid;
  Framing framing;
  MapFacts facts;
};

namespace {

constexpr double kLongestFrame_s = 1.0;  // of a picture that cannot be drawn piece by piece
constexpr std::size_t kHeightSamples = 50000;

std::vector<Eigen::Vector3f> accumulate(const quality::MapScans& scans, const RigidTransform& ins_from_lidar,
                                        const Progress& progress) {
  std::size_t count = 0;
  for (const auto& points : scans.points_in_lidar) count += points.size();
  std::vector<Eigen::Vector3f> all;
  all.reserve(count);
  for (std::size_t i = 0; i < scans.points_in_lidar.size() && !progress.cancelled(); ++i) {
    const Eigen::Isometry3f local_from_lidar = (scans.local_from_ins[i] * ins_from_lidar).cast<float>();
    for (const Eigen::Vector3f& point : scans.points_in_lidar[i]) all.push_back(local_from_lidar * point);
  }
  return all;
}

/// Heights that leave out stray points.
void find_heights(const std::vector<Eigen::Vector3f>& points, MapFacts& facts) {
  if (points.empty()) return;
  std::vector<float> heights;
  for (std::size_t i = 0; i < points.size(); i += std::max<std::size_t>(1, points.size() / kHeightSamples))
    heights.push_back(points[i].z());
  std::sort(heights.begin(), heights.end());
  const auto at = [&](double share) {
    return static_cast<double>(heights[static_cast<std::size_t>(share * static_cast<double>(heights.size() - 1))]);
  };
  facts.low_m = at(0.01);
  facts.high_m = std::max(at(0.98), facts.low_m + 0.1);
}

}  // namespace

MapSceneDataPtr prepare_map_scene(const quality::MapScans& scans, const RigidTransform& ins_from_lidar,
                                  const Progress& progress) {
  auto data = std::make_shared<MapSceneData>();
  LevelCloud cloud = order_by_levels(accumulate(scans, ins_from_lidar, progress), progress);
  if (progress.cancelled()) return nullptr;
  cloud.original = {};  // nobody asks which scan a point of the map is from
  data->facts.points = cloud.size();
  data->facts.left_out = cloud.left_out;
  find_heights(cloud.points, data->facts);
  data->framing = robust_framing(cloud.points, RigidTransform::Identity());
  auto colors = std::make_shared<std::vector<SceneColor>>(cloud.size());
  const double low_m = data->facts.low_m, span_m = data->facts.high_m - low_m;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    (*colors)[i] = DistanceScale::at((static_cast<double>(cloud.points[i].z()) - low_m) / span_m);
  data->colors = std::move(colors);
  data->grid = PointGrid(cloud.points, progress);
  data->geometry = make_geometry(std::move(cloud));
  return progress.cancelled() ? nullptr : data;
}

MapFacts facts_of(const MapSceneData& data) { return data.facts; }

struct MapScene::Parts {
  SceneStage stage;
  CloudActor cloud{stage.pane(0)};
  MapSceneDataPtr data;
  FrameBudget budget;
  double pixel_ratio = 1.0;
  std::size_t shown = 0, drawn_now = 0;  // in the picture; of these by the last frame
  bool moving = false, piecewise = false;

  std::size_t size() const { return data ? data->geometry->size() : 0; }
};

MapScene::MapScene() : parts_(std::make_unique<Parts>()) {
  parts_->stage.on_frame([&p = *parts_](double seconds) {
    p.budget.took(p.drawn_now, seconds);
    if (p.moving) p.shown = p.drawn_now = p.cloud.show(p.budget.points());
  });
}

MapScene::~MapScene() { parts_->stage.on_frame({}); }

SceneStage& MapScene::stage() { return parts_->stage; }

void MapScene::set_map(MapSceneDataPtr data) {
  Parts& p = *parts_;
  p.data = std::move(data);
  p.cloud.set_geometry(p.data ? p.data->geometry : nullptr);
  if (p.data) p.cloud.set_colors(p.data->colors);
  if (p.data) p.stage.frame(p.data->framing);
  begin();
}

void MapScene::clear() { set_map(nullptr); }

void MapScene::set_pixel_ratio(double device_pixels) {
  parts_->pixel_ratio = device_pixels;
  parts_->cloud.set_point_size(static_cast<float>((parts_->stage.eye_dome() ? 3.0 : 2.0) * device_pixels));
}

void MapScene::begin() {
  Parts& p = *parts_;
  p.stage.keep_picture(false);
  p.piecewise = !p.stage.eye_dome();  // shading needs the depth of all points at once
  p.shown = p.drawn_now = p.cloud.show(p.budget.points());
}

void MapScene::set_moving(bool moving) {
  parts_->moving = moving;
  begin();
}

bool MapScene::moving() const { return parts_->moving; }

bool MapScene::refine() {
  Parts& p = *parts_;
  if (p.moving || p.shown >= p.size()) return false;
  if (p.piecewise) {
    // The next pieces, over the picture and the depth that are there.
    p.stage.keep_picture(true);
    const std::size_t before = p.shown;
    p.shown = p.cloud.show(before + 2 * p.budget.points(), p.cloud.shown_pieces());
    p.drawn_now = p.shown - before;
    return true;
  }
  const std::size_t next = std::min(p.size(), 4 * p.shown);
  if (p.budget.seconds_for(next) > kLongestFrame_s) return false;
  const std::size_t before = p.shown;
  p.shown = p.drawn_now = p.cloud.show(next);
  return p.shown > before;
}

std::size_t MapScene::points_shown() const { return parts_->shown; }

std::size_t MapScene::moving_budget() const { return parts_->budget.points(); }

std::optional<Eigen::Vector3d> MapScene::pick(const PickRay& ray) const {
  const Parts& p = *parts_;
  if (!p.data) return std::nullopt;
  const std::vector<Eigen::Vector3f>& points = p.data->geometry->cloud->points;
  const auto picked = p.data->grid.nearest_to_ray(points, ray);
  if (!picked) return std::nullopt;
  return points[picked->index].cast<double>();
}

}  // namespace remount::scene
