// The search range of one parameter, drawn: what is searched, where the nominal and the result lie in it.
#pragma once

#include <QWidget>
#include <optional>

namespace remount::widgets {

/// Values in the unit of the screen. The ends are dragged with the mouse; with keys, the boxes above are used.
class RangeBar : public QWidget {
  Q_OBJECT
 public:
  /// @param low, high the axis, at least: it widens where the range is wider
  RangeBar(double low, double high, QWidget* parent = nullptr);
  void show_range(double from, double to);
  void show_nominal(std::optional<double> value);
  void show_result(std::optional<double> value);
  double x_of(double value) const;
  double value_at(double x) const;

  QSize minimumSizeHint() const override { return {80, 16}; }
  QSize sizeHint() const override { return {200, 16}; }

 signals:
  void from_dragged(double value);
  void to_dragged(double value);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  enum class End { None, From, To };
  End end_at(double x) const;
  void paint_mark(class QPainter& painter, double value, const QColor& color, bool above) const;
  double least_, most_;  // of the axis at rest
  double low_, high_;    // of the axis now
  double from_ = 0.0, to_ = 0.0;
  std::optional<double> nominal_, result_;
  End dragged_ = End::None;
};

}  // namespace remount::widgets
