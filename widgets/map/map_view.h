// The accumulated map of a session under the nominal, a candidate or the result.
#pragma once

#include <QStringList>
#include <array>

#include "algorithms/messages/message.h"
#include "algorithms/motion/pair.h"
#include "widgets/basics/scene_view.h"
#include "widgets/scene/map_scene.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTimer;

namespace remount::widgets {

/// Under which mounting the map is made.
enum class MapX { Nominal, Candidate, Result };

class MapView : public SceneView {
  Q_OBJECT
 public:
  explicit MapView(QWidget* parent = nullptr);
  ~MapView() override;

  /// What can be chosen. `candidate` names the one that is selected, empty for none; `nominal` says what it is.
  void show_choices(const QStringList& sessions, const QString& nominal, const QString& candidate);
  MapX chosen_x() const { return x_; }
  motion::SessionIndex chosen_session() const;
  void choose(MapX x);

  void show_progress(const Message& stage, qulonglong done, qulonglong total);
  void show_map(const QString& caption, scene::MapSceneDataPtr data);
  void show_message(const QString& text);
  void allow_choice();  ///< of the mounting, also while there is nothing to see
  void offer_again();   ///< a button that asks for the map
  const scene::MapScene& scene() const { return scene_; }
  /// Whether everything is drawn that will be drawn while nothing moves.
  bool rests() const;

 signals:
  void map_wanted();  ///< the choice changed, or the page came to be seen
  void cancel_clicked();

 protected:
  std::optional<Pick> pick(const scene::PickRay& ray) const override;
  QString axes_in_words() const override;
  void pixel_ratio_changed(double ratio) override;
  void motion_changed(bool moving) override;
  void size_changed() override { begin(); }
  void view_changed() override { begin(); }
  void showEvent(QShowEvent* event) override;

 private:
  void make_buttons();
  void begin();
  void draw_more();
  void update_caption();

  scene::MapScene scene_;
  QLabel *caption_, *drawn_;
  QWidget *legend_, *work_;
  QLabel *low_, *high_;
  QWidget* heights_;  // the bar between them
  QProgressBar* progress_;
  QPushButton* again_;
  QComboBox* session_ = nullptr;
  std::array<QToolButton*, 3> xs_{};
  QTimer* finer_;
  MapX x_ = MapX::Result;
  scene::MapSceneDataPtr data_;
  bool framed_ = false;
};

}  // namespace remount::widgets
