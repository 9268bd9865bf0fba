// A cloud on the screen, of which a beginning can be drawn alone.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <vector>

#include "algorithms/geometry/rigid_transform.h"
#include "widgets/scene/distance_scale.h"
#include "widgets/scene/level_cloud.h"

class vtkRenderer;

namespace remount::scene {

/// VTK's form of a LevelCloud, in pieces that follow each other. Made on any thread, immutable afterwards.
struct CloudGeometry {
  std::shared_ptr<const LevelCloud> cloud;  ///< holds the coordinates, which are not copied
  std::vector<vtkSmartPointer<vtkPolyData>> pieces;
  std::vector<std::size_t> piece_end;  ///< how many points the pieces have together with those before
  std::size_t size() const { return cloud ? cloud->size() : 0; }
};
std::shared_ptr<const CloudGeometry> make_geometry(LevelCloud cloud);

class CloudActor {
 public:
  explicit CloudActor(vtkRenderer& renderer);
  ~CloudActor();
  CloudActor(const CloudActor&) = delete;
  CloudActor& operator=(const CloudActor&) = delete;

  void set_geometry(std::shared_ptr<const CloudGeometry> geometry);
  const std::shared_ptr<const CloudGeometry>& geometry() const { return geometry_; }
  void place(const RigidTransform& view_from_cloud);
  void set_color(SceneColor color);
  /// One colour a point, in the order of the LevelCloud; null for the one colour.
  void set_colors(std::shared_ptr<const std::vector<SceneColor>> colors);
  void set_point_size(float pixels);

  /// Shows the pieces that begin with number `first` and hold, with those before them, at most `points`: at least one.
  /// Returns the number of points shown, those before `first` included.
  std::size_t show(std::size_t points, std::size_t first = 0);
  void show_all() { show(geometry_ ? geometry_->size() : 0); }
  std::size_t shown_pieces() const { return shown_pieces_; }

 private:
  struct Piece;
  void apply_colors(std::size_t piece);

  vtkRenderer& renderer_;
  std::shared_ptr<const CloudGeometry> geometry_;
  std::shared_ptr<const std::vector<SceneColor>> colors_;
  std::vector<std::unique_ptr<Piece>> pieces_;
  RigidTransform view_from_cloud_ = RigidTransform::Identity();
  SceneColor color_{128, 128, 128};
  float point_size_ = 3.0F;
  std::size_t shown_pieces_ = 0;
};

}  // namespace remount::scene
