// One bar per pair: how far each is from the result; and a line above which pairs are rejected.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <set>

#include "model/pipeline/pipeline.h"
#include "widgets/basics/rows.h"
#include "widgets/charts/plot_frame.h"
#include "widgets/pairs/pair_measure.h"

namespace remount::widgets {

/// Draws itself; a click or the arrow keys ask for a pair. Where bars would be narrower than two pixels, each shows the
/// largest of several pairs. The line is dragged by its handle on the right, or moved with Up and Down; what lies above
/// it is rejected when it is released, or with Return. It stays there; released higher, it gives back what it rejected.
/// The wheel zooms about the cursor, over the axis at the left along that; the right or middle button pans, and a
/// double click shows all again.
class ErrorBarChart : public QWidget {
  Q_OBJECT
 public:
  explicit ErrorBarChart(QWidget* parent = nullptr);
  void show_output(std::shared_ptr<const pipeline::PipelineOutput> output);
  /// The pairs drawn, from left to right: those of the table, in its order.
  void show_pairs(const std::vector<motion::PairIndex>& pairs);
  void show_selected(std::optional<motion::PairIndex> pair);
  void set_measure(PairMeasure measure);
  PairMeasure measure() const { return measure_; }
  /// The pair drawn at a position of the widget; nothing where there is none.
  std::optional<motion::PairIndex> pair_at(const QPoint& position) const;
  /// In the unit of the axis; nothing where the pair was never aligned.
  std::optional<double> value_of(motion::PairIndex pair) const;
  double top_of_axis() const { return top_; }
  /// Which places among those shown are seen, from 0 to their count.
  const AxisSpan& seen() const { return seen_; }
  static constexpr int kLeastBar_px = 2;
  /// "pair 12: 3.1 cm, accepted".
  QString words_of(motion::PairIndex pair) const;

  /// Nothing: at rest, above all.
  std::optional<double> threshold() const { return threshold_; }
  bool in_hand() const { return dragging_; }  ///< the line is being dragged
  void set_threshold(std::optional<double> threshold);
  /// Pairs shown that are not rejected and lie above the line; what it would reject.
  std::vector<motion::PairIndex> above_threshold() const;
  QPoint handle() const;  ///< where the line is taken
  static constexpr int kHandleWidth = 14;

  QSize minimumSizeHint() const override { return {220, 90}; }
  QSize sizeHint() const override { return {420, 180}; }

 signals:
  void pair_clicked(motion::PairIndex pair);
  /// `rejected` of `of` pairs that are shown and not rejected lie above the line; -1, -1 at rest.
  void threshold_moved(int rejected, int of);
  void reject_requested(const std::vector<motion::PairIndex>& pairs, double threshold);
  /// Pairs that the line rejected before it was pulled back.
  void take_back_requested(const std::vector<motion::PairIndex>& pairs);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  QRect plot_area() const;
  int count() const { return qt_count(pairs_.size()); }
  int place_of(std::optional<motion::PairIndex> pair) const;  // among those shown; -1 where it is not
  const motion::Pair& pair(motion::PairIndex index) const { return output_->pairs[index]; }
  void find_values();
  bool is_rejected(motion::PairIndex pair) const;
  void find_top();
  double value_at(int y) const;
  int y_of(double value) const;
  bool at_line(const QPoint& position) const;
  int kept_count() const;
  void apply_line();
  /// What is drawn at one place: the pair with the largest value; below 0: it has none.
  struct Bar {
    double value = -1.0;
    int place = -1, column = 0;
  };
  std::vector<Bar> bars() const;
  QRectF span_of(const Bar& bar) const;
  AxisSpan whole() const { return {0.0, std::max(1.0, static_cast<double>(count()))}; }
  double bar_width() const;  // px, of a pair
  double x_of(double place) const;
  void look_at(double first);
  void zoom(double about_px, double factor);
  void stretch(double factor);
  void show_whole();
  void hover(std::optional<motion::PairIndex> pair);
  void step_selection(int step);
  void step_threshold(double share);
  void paint_axis(class QPainter& painter, const QRect& area) const;
  void paint_bars(class QPainter& painter, const QRect& area) const;
  void paint_selection(class QPainter& painter, const QRect& area) const;
  void paint_threshold(class QPainter& painter, const QRect& area) const;

  std::shared_ptr<const pipeline::PipelineOutput> output_;
  std::vector<motion::PairIndex> pairs_;
  std::vector<std::optional<double>> values_;  // of each pair of the output, under the measure
  std::vector<bool> rejected_;                 // each pair of the output; pairs are too large to be gone through
  PairMeasure measure_ = PairMeasure::ResidualTranslation;
  double top_ = 1.0, stretch_ = 1.0;  // stretch: of the axis, against the usual
  AxisSpan seen_;
  std::optional<motion::PairIndex> selected_, hovered_;
  std::set<motion::PairIndex> by_line_;  // what the line rejected, and would give back
  std::optional<QPoint> panned_from_;
  std::optional<double> threshold_, threshold_before_drag_;
  bool dragging_ = false;
};

}  // namespace remount::widgets

Q_DECLARE_METATYPE(std::vector<remount::motion::PairIndex>)
