// One bar per pair: how far each is from the result.
#pragma once

#include <QWidget>
#include <memory>

#include "model/pipeline.h"

namespace remount {

enum class PairMeasure { ResidualTranslation, ResidualRotation, Rmse, Screw };

/// Draws itself; a click or the arrow keys ask for a pair. Where there are more pairs than pixels, each column shows
/// its largest.
class ErrorBarChart : public QWidget {
  Q_OBJECT
 public:
  explicit ErrorBarChart(QWidget* parent = nullptr);
  void show_output(std::shared_ptr<const PipelineOutput> output);
  void show_selected(int pair);
  void set_measure(PairMeasure measure);
  /// The pair drawn at a position of the widget; -1 where there is none.
  int pair_at(const QPoint& position) const;
  double value_of(int pair) const;  ///< in the unit of the axis

  QSize minimumSizeHint() const override { return {220, 90}; }
  QSize sizeHint() const override { return {420, 180}; }

 signals:
  void pair_clicked(int pair);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  QRect plot_area() const;
  int pair_count() const;
  double top_of_axis() const;
  QString unit_text() const;
  void paint_axis(class QPainter& painter, const QRect& area, double top) const;
  void paint_bars(class QPainter& painter, const QRect& area, double top) const;

  std::shared_ptr<const PipelineOutput> output_;
  PairMeasure measure_ = PairMeasure::ResidualTranslation;
  int selected_ = -1;
};

}  // namespace remount
