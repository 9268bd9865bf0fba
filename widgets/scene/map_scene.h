// The 3-D scene of a session's accumulated map: all its scans under one X, coloured by height. VTK inside, no Qt.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "algorithms/core/progress.h"
#include "algorithms/quality/map_sharpness.h"
#include "widgets/scene/distance_scale.h"
#include "widgets/scene/scene_stage.h"

namespace remount::scene {

struct MapSceneData;  // VTK inside
using MapSceneDataPtr = std::shared_ptr<const MapSceneData>;

/// Made on any thread. Null where cancelled.
MapSceneDataPtr prepare_map_scene(const quality::MapScans& scans, const RigidTransform& ins_from_lidar,
                                  const Progress& progress);

/// What one LiDAR adds to a map of several.
struct MapLayer {
  const quality::MapScans* scans = nullptr;
  RigidTransform ins_from_lidar = RigidTransform::Identity();
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();  ///< of its local axes, in those of the map
  SceneColor color{};
};

/// Every LiDAR in its own colour: a wall that two of them see twice is a mounting that is wrong.
MapSceneDataPtr prepare_map_scene(const std::vector<MapLayer>& layers, const Progress& progress);

struct MapFacts {
  std::size_t points = 0, left_out = 0;  ///< drawn in the end; bad coordinates
  double low_m = 0.0, high_m = 0.0;      ///< heights between which colours run
  bool by_height = true;                 ///< false: each LiDAR has its own colour
};
MapFacts facts_of(const MapSceneData& data);

/// Draws a beginning of the cloud while the camera moves and the rest, piece by piece, once it rests: frames stay short
/// however large the map is. All calls on the thread that owns the render window.
class MapScene {
 public:
  MapScene();
  ~MapScene();
  MapScene(const MapScene&) = delete;
  MapScene& operator=(const MapScene&) = delete;

  SceneStage& stage();
  void set_map(MapSceneDataPtr data);
  void clear();
  void set_pixel_ratio(double device_pixels);
  /// The next frame begins anew with as many points as one frame has time for.
  void begin();
  void set_moving(bool moving);
  bool moving() const;
  /// Makes ready the next frame with more points; false where all are drawn, or all that there is time for.
  bool refine();
  /// How many points the picture shows after the frames drawn so far.
  std::size_t points_shown() const;
  /// The most that a frame may draw while the camera moves.
  std::size_t moving_budget() const;
  std::optional<Eigen::Vector3d> pick(const PickRay& ray) const;  ///< in the map's axes, m

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace remount::scene
