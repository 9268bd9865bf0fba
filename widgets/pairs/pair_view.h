// The 3-D view of one pair with its buttons.
#pragma once

#include <array>
#include <utility>

#include "widgets/basics/scene_view.h"
#include "widgets/scene/pair_scene.h"

class QComboBox;
class QLabel;
class QSlider;
class QTimer;

namespace remount::widgets {

class DistanceLegend;
class ValueLegend;

/// Asks for distances_to_target under each transform; they take too long for the thread of the window.
struct DistanceRequest {
  int number = 0;
  scene::PairSceneDataPtr data;
  std::vector<RigidTransform> lidar_b_from_lidar_a;
};

class PairView : public SceneView {
  Q_OBJECT
 public:
  explicit PairView(QWidget* parent = nullptr);
  ~PairView() override;

  void show_message(const QString& text);
  void show_pair(const QString& caption, scene::PairSceneDataPtr scene_data, const scene::PairTransforms& transforms);
  void show_transforms(const QString& caption, const scene::PairTransforms& transforms);
  /// What the current X is: the result, or the candidate of this name.
  void name_current(const QString& candidate);
  void show_alignment(scene::PairAlignment alignment);
  scene::PairAlignment alignment() const;
  /// On the way from before (0) to the alignment that was chosen last (1).
  void show_share(double share);
  double share() const { return share_; }
  /// Before and after in turn: by hand, or twice a second.
  void flip();
  void set_blinking(bool on);
  bool blinking() const;
  /// Before on the left, after on the right, turned together.
  void set_side_by_side(bool on);
  void set_coloring(scene::PairColoring coloring);
  void show_ground(bool visible);
  bool shows_ground() const;
  void set_scale(double limit_m);
  double scale_m() const;
  /// The answer to a request; one that is no longer wanted is ignored.
  void show_distances(const DistanceRequest& request, std::vector<std::vector<float>> distances_m);
  const scene::PairScene& scene() const { return scene_; }

 signals:
  void distances_wanted(const widgets::DistanceRequest& request);
  void scale_changed(double limit_m);
  void ground_shown(bool visible);
  /// The user wants a section through this point, in the lidar frame of scan b, m.
  void section_wanted(const Eigen::Vector3d& point_in_lidar_b);

 protected:
  std::optional<Pick> pick(const scene::PickRay& ray) const override;
  QString axes_in_words() const override;
  void pixel_ratio_changed(double ratio) override;
  void palette_changed() override;
  void motion_changed(bool moving) override;
  void fill_menu(QMenu& menu, const std::optional<Pick>& picked) override;

 private:
  void make_buttons();
  void add_alignment_buttons(QHBoxLayout* row);
  void add_coloring(QHBoxLayout* row);
  void offer_current(bool known);
  scene::PairAlignment after() const;
  void apply();
  void color_by_distance();
  scene::PairColoring coloring() const;
  void show_legend();
  bool use_known_distances();
  void update_caption();

  scene::PairScene scene_;
  QLabel* caption_;
  DistanceLegend* legend_;
  ValueLegend* values_;
  std::array<QToolButton*, 3> alignments_{};
  QToolButton *blink_ = nullptr, *side_by_side_ = nullptr, *objects_ = nullptr, *ground_ = nullptr;
  QSlider* slider_ = nullptr;
  QComboBox* coloring_ = nullptr;
  QTimer* timer_;
  QString pair_caption_;
  scene::PairSceneDataPtr data_;
  RigidTransform view_from_lidar_b_ = RigidTransform::Identity();
  scene::PairAlignment chosen_ = scene::PairAlignment::Registered;  // what "after" is
  bool current_known_ = true;
  double share_ = 1.0;
  int request_ = 0;
  // Distances of this pair under the transforms seen last: blinking asks once.
  std::vector<std::pair<RigidTransform, std::vector<float>>> known_;
  bool framed_ = false;
};

}  // namespace remount::widgets
