// Every pair as a point: how far it is off over the circumstances in which it was taken.
#pragma once

#include <QPixmap>
#include <QPolygonF>
#include <QWidget>
#include <memory>
#include <optional>
#include <set>

#include "widgets/charts/plot_frame.h"
#include "widgets/residuals/residual_values.h"

namespace remount::widgets {

/// What the plot holds, for the words beside it.
struct ResidualSummary {
  int drawn = 0;                       ///< points of the states that are shown
  int unknown = 0;                     ///< pairs of these states of which one of the two values is not known
  int outside = 0;                     ///< of those drawn, beyond the part that is seen
  int accepted = 0;                    ///< all of them that have a value, whatever is seen
  double mean = 0.0, deviation = 0.0;  ///< of the accepted, in the unit of the vertical axis
};

/// A click selects the pair, a line drawn around points with the left button marks them (with Shift beside those that
/// are marked), the wheel zooms about the cursor (over an axis along it alone), the right or middle button pans. A
/// double click shows the usual part again, and all of it where that is seen already. The arrow keys select the
/// neighbour, Space marks the pair that is selected, Escape takes the marks away.
class ResidualPlot : public QWidget {
  Q_OBJECT
 public:
  explicit ResidualPlot(QWidget* parent = nullptr);
  /// Marks stay where it holds as many pairs as before.
  void show_output(std::shared_ptr<const pipeline::PipelineOutput> output);
  void show_session_names(const QStringList& names);
  void show_selected(std::optional<motion::PairIndex> pair);
  void set_axes(ResidualMeasure measure, PairCircumstance circumstance);
  void show_state_of_pairs(motion::PairState state, bool shown);
  ResidualMeasure measure() const { return measure_; }
  PairCircumstance circumstance() const { return circumstance_; }

  /// Where a pair is drawn; nothing where it is not, or outside the part that is seen.
  std::optional<QPointF> place_of(motion::PairIndex pair) const;
  /// The nearest of those drawn, within reach.
  std::optional<motion::PairIndex> pair_at(const QPointF& position) const;
  /// Those drawn inside a line that closes itself, ascending.
  std::vector<motion::PairIndex> pairs_within(const QPolygonF& line) const;
  std::vector<motion::PairIndex> marked() const { return {marked_.begin(), marked_.end()}; }
  void mark(const std::vector<motion::PairIndex>& pairs);
  /// Of the marked those that are not rejected yet, ascending.
  std::vector<motion::PairIndex> marked_and_kept() const;
  const PlotFrame& frame() const { return frame_; }
  void show_usual();  ///< what all pairs but a few wild ones lie in
  void show_all();
  ResidualSummary summary() const;
  /// "pair 12: 3.1 cm at 4.2 s, accepted".
  QString words_of(motion::PairIndex pair) const;

  QSize minimumSizeHint() const override { return {200, 110}; }
  QSize sizeHint() const override { return {480, 220}; }

 signals:
  void pair_clicked(motion::PairIndex pair);
  void contents_changed();  ///< of what `summary` tells, or which pairs are marked

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  enum class Hand { Free, Pressed, Lasso, Pan };
  std::size_t count() const { return up_.size(); }
  bool is_drawn(std::size_t pair) const;
  std::optional<QPointF> point_of(std::size_t pair) const;
  void find_values();
  void place_area();
  AxisSpan whole_across() const;
  AxisSpan whole_up(bool all) const;
  void view(const AxisSpan& across, const AxisSpan& up);
  void zoom(const QPointF& about, double factor);
  void change();
  void close_lasso(bool beside);
  void hover(std::optional<motion::PairIndex> pair);
  void step_selection(int step);
  QString number_on(double value, PairCircumstance circumstance) const;
  QString tick_text(double across) const;

  QRectF histogram_area() const;
  void paint_picture();
  void paint_axes(class QPainter& painter) const;
  void paint_points(class QPainter& painter) const;
  void paint_beyond(class QPainter& painter) const;
  void paint_histogram(class QPainter& painter) const;
  void paint_above(class QPainter& painter) const;
  void paint_empty(class QPainter& painter) const;

  std::shared_ptr<const pipeline::PipelineOutput> output_;
  QStringList session_names_;
  ResidualMeasure measure_ = ResidualMeasure::Translation;
  PairCircumstance circumstance_ = PairCircumstance::Time;
  std::vector<double> across_, up_;        // of each pair, on the axes
  std::vector<motion::PairState> states_;  // pairs are too large to be gone through for each picture
  std::array<bool, 3> shown_{true, true, true};
  int drawn_ = 0;  // those shown of which both values are known
  PlotFrame frame_;
  AxisSpan whole_across_, usual_up_, whole_up_;
  std::set<motion::PairIndex> marked_;
  std::optional<motion::PairIndex> selected_, hovered_;
  Hand hand_ = Hand::Free;
  QPointF pressed_, last_;
  QPolygonF lasso_;
  QPixmap picture_;  // axes, points and histogram; null: to be painted
};

}  // namespace remount::widgets
