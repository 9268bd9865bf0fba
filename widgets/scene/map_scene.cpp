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

std::size_t count_points(const quality::MapScans& scans) {
  std::size_t count = 0;
  for (const auto& points : scans.points_in_lidar) count += points.size();
  return count;
}

void accumulate(const MapLayer& layer, const Progress& progress, std::vector<Eigen::Vector3f>& all) {
  const quality::MapScans& scans = *layer.scans;
  for (std::size_t i = 0; i < scans.points_in_lidar.size() && !progress.cancelled(); ++i) {
    const Eigen::Isometry3f map_from_lidar =
        (Eigen::Translation3d(layer.origin_m) * scans.local_from_ins[i] * layer.ins_from_lidar).cast<float>();
    for (const Eigen::Vector3f& point : scans.points_in_lidar[i]) all.push_back(map_from_lidar * point);
  }
}

/// The layers' points one after the other, and of each layer where it ends.
std::vector<Eigen::Vector3f> accumulate(const std::vector<MapLayer>& layers, const Progress& progress,
                                        std::vector<std::size_t>& ends) {
  std::size_t count = 0;
  for (const MapLayer& layer : layers) count += count_points(*layer.scans);
  std::vector<Eigen::Vector3f> all;
  all.reserve(count);
  for (const MapLayer& layer : layers) {
    accumulate(layer, progress, all);
    ends.push_back(all.size());
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

std::vector<SceneColor> colors_of_heights(const LevelCloud& cloud, const MapFacts& facts) {
  std::vector<SceneColor> colors(cloud.size());
  const double span_m = facts.high_m - facts.low_m;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    colors[i] = DistanceScale::at((static_cast<double>(cloud.points[i].z()) - facts.low_m) / span_m);
  return colors;
}

std::vector<SceneColor> colors_of_layers(const LevelCloud& cloud, const std::vector<MapLayer>& layers,
                                         const std::vector<std::size_t>& ends) {
  std::vector<SceneColor> colors(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    colors[i] =
        layers[static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), cloud.original[i]) - ends.begin())]
            .color;
  return colors;
}

MapSceneDataPtr prepare(const std::vector<MapLayer>& layers, bool by_height, const Progress& progress) {
  auto data = std::make_shared<MapSceneData>();
  std::vector<std::size_t> ends;
  LevelCloud cloud = order_by_levels(accumulate(layers, progress, ends), progress);
  if (progress.cancelled()) return nullptr;
  data->facts.points = cloud.size();
  data->facts.left_out = cloud.left_out;
  find_heights(cloud.points, data->facts);
  data->facts.by_height = by_height;
  data->framing = robust_framing(cloud.points, RigidTransform::Identity());
  data->colors = std::make_shared<const std::vector<SceneColor>>(by_height ? colors_of_heights(cloud, data->facts)
                                                                           : colors_of_layers(cloud, layers, ends));
  cloud.original = {};  // nobody asks further which scan a point of the map is from
  data->grid = PointGrid(cloud.points, progress);
  data->geometry = make_geometry(std::move(cloud));
  return progress.cancelled() ? nullptr : data;
}

}  // namespace

MapSceneDataPtr prepare_map_scene(const quality::MapScans& scans, const RigidTransform& ins_from_lidar,
                                  const Progress& progress) {
  return prepare({{&scans, ins_from_lidar}}, true, progress);
}

MapSceneDataPtr prepare_map_scene(const std::vector<MapLayer>& layers, const Progress& progress) {
  return prepare(layers, false, progress);
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
