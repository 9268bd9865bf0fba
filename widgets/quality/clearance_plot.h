// A scan around the vehicle from above, under the mounting before and the new one, with what is free on each side.
#pragma once

#include <QPixmap>
#include <QWidget>
#include <memory>
#include <vector>

#include "algorithms/quality/clearance.h"

namespace remount::widgets {

/// A scan in the axes of the vehicle (x forward, y left, z up, origin at the INS).
struct VehicleScan {
  std::vector<Eigen::Vector3f> before, after;  ///< m, under the mounting before and the new one
};

/// What of a scan counts for a vehicle: the points within its heights from above, and what is free around it.
struct MeasuredScan {
  quality::VehicleBox box;
  std::vector<Eigen::Vector2f> before_m, after_m;  ///< x forward, y left
  quality::Clearances free_before, free_after;
};
using MeasuredScanPtr = std::shared_ptr<const MeasuredScan>;

/// Grows with the points of the scan; made on any thread.
MeasuredScan measure_scan(const VehicleScan& scan, const quality::VehicleBox& box);

/// Colours of what is seen under either mounting; apart for the colour-blind, too.
QColor before_color(const QPalette& palette);
QColor after_color(const QPalette& palette);

/// Forward is right, left is up. The wheel and the keys + and - zoom, Home shows what is near again.
class ClearancePlot : public QWidget {
  Q_OBJECT
 public:
  explicit ClearancePlot(QWidget* parent = nullptr);
  void show_scan(const QString& name, MeasuredScanPtr scan);
  void name_before(const QString& words);              ///< the mounting that the result is compared with: "nominal"
  void show_message(const QString& text);              ///< instead of a scan
  const QString& name() const { return name_; }        ///< of the scan; empty where there is none
  const QString& message() const { return message_; }  ///< what stands in its place, or over it
  double pixels_per_m() const;
  QPointF to_screen(double x_m, double y_m) const;

  QSize minimumSizeHint() const override { return {240, 160}; }
  QSize sizeHint() const override { return {420, 280}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QRectF area() const;
  const MeasuredScan& shown() const;  ///< an empty one where there is none
  void zoom(double factor);
  void draw_points();
  void paint_grid(QPainter& painter) const;
  void paint_legend(QPainter& painter) const;
  void paint_vehicle(QPainter& painter) const;
  void paint_clearances(QPainter& painter, const quality::Clearances& found, const QColor& color,
                        double shift_px) const;

  MeasuredScanPtr scan_;
  QString name_, message_, before_name_;
  double zoom_ = 1.0;
  QPixmap points_;  // drawn once: a scan has a hundred thousand
};

}  // namespace remount::widgets
