// The 3-D view of one pair with its buttons.
#pragma once

#include <QWidget>
#include <memory>

#include "widgets/scene/pair_scene.h"

class QButtonGroup;
class QLabel;
class QStackedLayout;
class QTimer;
class QToolButton;
class QVTKOpenGLNativeWidget;

namespace remount {

class PairView : public QWidget {
  Q_OBJECT
 public:
  explicit PairView(QWidget* parent = nullptr);
  ~PairView() override;

  void show_message(const QString& text);  ///< instead of a scene: loading, nothing selected, why it failed
  void show_pair(const QString& caption, std::shared_ptr<const PairClouds> clouds, const PairTransforms& transforms);
  void show_transforms(const QString& caption, const PairTransforms& transforms);
  void show_alignment(PairAlignment alignment);
  /// Before and registered in turn: by hand, or twice a second.
  void flip();
  void set_blinking(bool on);
  bool blinking() const;
  void look(StandardView view);
  PairAlignment alignment() const { return alignment_; }
  bool has_gl() const { return canvas_ != nullptr; }
  QWidget* canvas() const;  ///< takes the keys; null without GL

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QWidget* make_buttons();
  QToolButton* add_button(const QString& text, const QString& help);
  void add_alignment_buttons();
  void add_view_buttons();
  void render();
  void update_caption();
  void restyle();

  PairScene scene_;
  QVTKOpenGLNativeWidget* canvas_ = nullptr;
  QLabel* message_;
  QLabel* caption_;
  QStackedLayout* stack_;
  QButtonGroup* alignments_;
  QWidget* buttons_ = nullptr;  // the row above the scene
  QToolButton* blink_ = nullptr;
  QTimer* timer_;
  QString pair_caption_, gl_reason_;
  PairAlignment alignment_ = PairAlignment::Registered;
  bool framed_ = false;
};

}  // namespace remount
