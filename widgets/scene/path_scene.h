// The 3-D scene of the ways that a method drew: lines and points in space. VTK inside, no Qt.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "widgets/scene/distance_scale.h"
#include "widgets/scene/scene_stage.h"

namespace remount::scene {

/// A way, or single points of one, in metres. What is not finite is left out and interrupts a line.
struct ScenePath {
  std::vector<Eigen::Vector3d> points_m;
  bool dots = false;
  SceneColor color{};
};

/// All calls on the thread that owns the render window.
class PathScene {
 public:
  PathScene();
  ~PathScene();
  PathScene(const PathScene&) = delete;
  PathScene& operator=(const PathScene&) = delete;

  SceneStage& stage();
  /// The view's origin is the first point: coordinates far from it would lose their digits in a picture.
  void show(const std::vector<ScenePath>& paths);
  void set_pixel_ratio(double device_pixels);

  struct Picked {
    std::size_t path = 0;
    Eigen::Vector3d point_m, point_in_view;  ///< as it was given; where it is drawn
  };
  /// The point nearest to the ray.
  std::optional<Picked> pick(const PickRay& ray) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace remount::scene
