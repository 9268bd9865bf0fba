// The 3-D scene of one pair: target grey, source coloured, shared objects as linked boxes. VTK inside, no Qt.
#pragma once

#include <memory>

#include "algorithms/geometry/rigid_transform.h"
#include "model/pipeline.h"

class vtkRenderWindow;

namespace remount {

/// Under which transform the source scan is shown.
enum class PairAlignment {
  Before,      ///< predicted from INS motion and the mounting that the calibration started from
  Registered,  ///< as the two scans were aligned
  CurrentX,    ///< predicted from INS motion and the present result
};

enum class StandardView { Fit, Top, Side, Front };

/// The three ways to bring scan a to scan b, and the axes in which the scene is shown.
struct PairTransforms {
  RigidTransform before_lidar_b_from_lidar_a = RigidTransform::Identity();
  RigidTransform registered_lidar_b_from_lidar_a = RigidTransform::Identity();
  RigidTransform current_lidar_b_from_lidar_a = RigidTransform::Identity();
  /// Brings lidar b to the axes of the vehicle, so that "top" is above the vehicle however the sensor is turned.
  RigidTransform view_from_lidar_b = RigidTransform::Identity();
};

/// Predictions X^-1 P X under the starting and the present mounting, and the registration of pair `pair`.
PairTransforms pair_transforms(const PipelineOutput& output, int pair);

/// Owns the renderer and its actors. All calls on the thread that owns the render window.
class PairScene {
 public:
  PairScene();
  ~PairScene();
  PairScene(const PairScene&) = delete;
  PairScene& operator=(const PairScene&) = delete;

  /// Adds the renderer and the mouse style. The window must have an interactor.
  void attach(vtkRenderWindow& window);
  void set_pair(const PairClouds& clouds, const PairTransforms& transforms);
  /// New transforms for the clouds that are shown (the result moved).
  void set_transforms(const PairTransforms& transforms);
  void clear();
  void show_alignment(PairAlignment alignment);
  void show_objects(bool visible);
  void set_dark(bool dark);
  void look(StandardView view);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace remount
