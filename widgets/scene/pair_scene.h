// The 3-D scene of one pair: target grey, source coloured, shared objects as linked boxes. VTK inside, no Qt.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "widgets/scene/pair_scene_data.h"
#include "widgets/scene/scene_stage.h"

namespace remount::scene {

/// Of scan a alone, or of both scans.
enum class PairColoring {
  Orange,
  Blue,
  Distance,        ///< of scan a to the surfaces of scan b
  SignedDistance,  ///< the same, with the side
  Height,          ///< of both, as all below
  Intensity,
  Ring,
  Time,
};
/// Needs distances_to_target.
constexpr bool is_by_distance(PairColoring coloring) {
  return coloring == PairColoring::Distance || coloring == PairColoring::SignedDistance;
}

/// A point that was clicked on.
struct PairPick {
  bool in_scan_a = false;                                    ///< false: in scan b
  Eigen::Vector3d point_in_lidar = Eigen::Vector3d::Zero();  ///< of its own scan, m
  Eigen::Vector3d point_in_view = Eigen::Vector3d::Zero();   ///< vehicle axes at scan b, m
  float distance_m = 0.0F;  ///< to the surfaces of the other scan as it is shown; NaN: nothing near
};

/// Owns what is in the two pictures. All calls on the thread that owns the render window.
class PairScene {
 public:
  PairScene();
  ~PairScene();
  PairScene(const PairScene&) = delete;
  PairScene& operator=(const PairScene&) = delete;

  SceneStage& stage();
  void set_pair(PairSceneDataPtr data, const PairTransforms& transforms);
  /// New transforms for the clouds that are shown (the result moved, or another candidate).
  void set_transforms(const PairTransforms& transforms);
  void clear();
  /// Side by side, the left picture shows scan a as before; the other, or the only one, at `share` of the way from
  /// before (0) to `after` (1).
  void show(PairAlignment after, double share, bool side_by_side);
  /// The transform under which a picture shows scan a.
  RigidTransform lidar_b_from_lidar_a(int pane) const;
  void show_objects(bool visible);
  /// Whether there are boxes to show: of objects that stand still, or of those that move.
  bool has_objects(bool moving) const;
  void set_dark(bool dark);
  void set_pixel_ratio(double device_pixels);  ///< of the display: points are as large on every one
  void set_coloring(PairColoring coloring);
  /// Between which values the colours of both scans run; nothing where the scans do not have what they are to be
  /// coloured by, or one colour or a distance is shown.
  std::optional<std::pair<double, double>> value_range() const;
  void show_ground(bool visible);
  void set_scale(double limit_m);
  /// Distances of distances_to_target for each picture; empty: not known yet.
  void set_distances(int pane, std::vector<float> distances_m);
  /// A thinner cloud while the camera moves, where the whole is too slow.
  void set_moving(bool moving);
  std::optional<PairPick> pick(const PickRay& ray) const;
  std::size_t points_shown() const;
  std::size_t points_in_all() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace remount::scene
