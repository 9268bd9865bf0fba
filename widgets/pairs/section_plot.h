// What a slab through a pair holds, before and after, side by side.
#pragma once

#include <QWidget>
#include <vector>

#include "algorithms/quality/section.h"

namespace remount::widgets {

/// One way to bring scan a to scan b, and what the slab holds then.
struct ShownCut {
  QString title;
  quality::SectionCut cut;
};

/// Along the surface to the right, across it upwards and magnified, all pictures on one scale; at the right of each how
/// many points of each scan lie at each height. Of a pole both directions are level, and nothing is magnified.
class SectionPlot : public QWidget {
  Q_OBJECT
 public:
  explicit SectionPlot(QWidget* parent = nullptr);
  void show_cuts(const quality::Section& section, std::vector<ShownCut> cuts);
  void show_message(const QString& text);
  const std::vector<ShownCut>& cuts() const { return cuts_; }
  /// How far the pictures reach across the surface, m.
  double reach_m() const { return reach_m_; }
  QSize sizeHint() const override { return {520, 200}; }
  QSize minimumSizeHint() const override { return {240, 110}; }

 signals:
  /// The slab is to be elsewhere: m along its directions.
  void moved(const Eigen::Vector3d& by_m);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  struct Frame;
  std::vector<Frame> frames() const;
  void paint_points(QPainter& painter, const Frame& frame, const std::vector<Eigen::Vector2f>& points_m,
                    const QColor& color) const;
  void paint_histogram(QPainter& painter, const Frame& frame, const quality::SectionCut& cut) const;
  void paint_axes(QPainter& painter, const Frame& frame) const;
  void tell();

  quality::Section section_;
  std::vector<ShownCut> cuts_;
  QString message_;
  double reach_m_ = 0.1;
  double pressed_x_ = 0.0;
};

/// "18 mm together (a 9, b 8), a 3 mm behind b".
QString cut_in_words(const quality::SectionCut& cut, quality::SectionKind kind);

}  // namespace remount::widgets
