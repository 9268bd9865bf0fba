// A drive over time: where its streams have gaps, how good the INS was, and where the selected pair lies.
#pragma once

#include <QWidget>
#include <array>
#include <memory>
#include <optional>

#include "model/overview/drive_overview.h"

namespace remount::widgets {

/// A click asks for what was recorded at that time; Left and Right move the time.
class DriveTimeline : public QWidget {
  Q_OBJECT
 public:
  explicit DriveTimeline(QWidget* parent = nullptr);
  void show_drive(std::shared_ptr<const overview::DriveOverview> drive);
  /// The two scans of the selected pair, seconds since the start of the drive.
  void show_times(std::optional<std::pair<double, double>> times_s);
  double time_at(int x) const;
  int x_of(double time_s) const;
  /// What the curve shows: the position sigma where the log states it, the speed otherwise.
  bool shows_sigma() const;
  QString quality_legend() const;  ///< what the colours of the fix say, of those that occur; rich text

  QSize minimumSizeHint() const override { return {160, 165}; }
  QSize sizeHint() const override { return {300, 205}; }

 signals:
  void time_clicked(double time_s);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  static constexpr int kRows = 4;  // LiDAR, INS, quality, what its colours say
  std::array<QString, kRows> row_names() const;
  QRect plot_area() const;
  QRect curve_area() const;
  int row_height() const { return fontMetrics().height() + 2; }
  void paint_rows(class QPainter& painter) const;
  void paint_quality(class QPainter& painter, const QRect& row) const;
  void paint_quality_legend(class QPainter& painter, const QRect& row) const;
  void paint_curve(class QPainter& painter) const;
  double curve_value(const overview::InsStretch& stretch) const;
  QColor quality_color(motion::InsQuality quality) const;

  std::shared_ptr<const overview::DriveOverview> drive_;
  std::optional<std::pair<double, double>> times_s_;
};

}  // namespace remount::widgets
