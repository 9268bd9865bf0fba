// A drive from above: trajectory, keyframes, and pairs in the colour of their state.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "model/overview/drive_overview.h"
#include "model/pipeline/pipeline.h"

namespace remount::widgets {

/// A click selects the nearest pair; the wheel zooms, dragging pans, Home shows all.
class DriveMap : public QWidget {
  Q_OBJECT
 public:
  explicit DriveMap(QWidget* parent = nullptr);
  void set_hint(const QString& hint);  ///< where there is no drive
  /// @param session index of the drive in `output`
  void show_drive(std::shared_ptr<const overview::DriveOverview> drive, motion::SessionIndex session);
  void show_output(std::shared_ptr<const pipeline::PipelineOutput> output);
  void show_selected(std::optional<motion::PairIndex> pair);
  void fit();
  /// Where a pair is drawn, in the widget; nothing where it is of another drive or its scans have no place.
  std::optional<QPointF> place_of(motion::PairIndex pair) const;
  std::optional<motion::PairIndex> pair_at(const QPointF& position) const;  ///< nothing where none is near
  double pixels_per_m() const { return pixels_per_m_; }

  QSize minimumSizeHint() const override { return {160, 140}; }
  QSize sizeHint() const override { return {300, 300}; }

 signals:
  void pair_clicked(motion::PairIndex pair);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  struct Link {
    motion::PairIndex pair;
    Eigen::Vector2d a_m, b_m;
    double bulge = 0.0;  // how far the arc stands off its chord, in pixels
  };
  void collect_links();
  QPointF on_screen(const Eigen::Vector2d& place_m) const;
  QPointF middle(const Link& link) const;
  void zoom(double factor, const QPointF& about);
  void pan(const QPointF& pixels);
  void paint_track(class QPainter& painter) const;
  void paint_links(class QPainter& painter) const;
  void paint_link(class QPainter& painter, const Link& link) const;
  void paint_frame(class QPainter& painter) const;

  QString hint_;
  std::shared_ptr<const overview::DriveOverview> drive_;
  std::shared_ptr<const pipeline::PipelineOutput> output_;
  motion::SessionIndex session_;
  std::optional<motion::PairIndex> selected_;
  std::vector<Link> links_;
  Eigen::Vector2d centre_m_ = Eigen::Vector2d::Zero();
  double pixels_per_m_ = 1.0;
  bool fitted_ = true;  // follows the widget's size until the user zooms or pans
  std::optional<QPointF> pressed_, dragged_from_;
};

}  // namespace remount::widgets
