// What the sigma of each parameter is made of.
#pragma once

#include <QWidget>
#include <vector>

#include "algorithms/calibration/calibration_result.h"

class QLabel;

namespace remount::widgets {

/// A bar for each parameter, as long as its variance, which is parted by where it comes from: variances add up, sigmas
/// do not.
class SigmaBars : public QWidget {
  Q_OBJECT
 public:
  explicit SigmaBars(QWidget* parent = nullptr);
  void show_result(const calibration::CalibrationResult* result);  ///< null: none that tells its parts
  /// Of the whole variance; 0 where the parameter is not observed.
  double share(std::size_t part, calibration::Parameter parameter) const;
  static QColor color_of(std::size_t part, const QPalette& palette);
  /// The part drawn at a position, and whose bar it is in; nothing beside the bars.
  struct Place {
    std::size_t part = 0;
    calibration::Parameter parameter = calibration::Parameter::X;
  };
  std::optional<Place> place_at(const QPoint& position) const;
  QString words_of(const Place& place) const;

  QSize minimumSizeHint() const override { return {220, 130}; }
  QSize sizeHint() const override { return {360, 170}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  QRectF bar_of(int row) const;
  std::optional<calibration::CalibrationResult> result_;
};

class SigmaBudgetView : public QWidget {
  Q_OBJECT
 public:
  explicit SigmaBudgetView(QWidget* parent = nullptr);
  /// Null before the first calibration.
  void show_result(const calibration::CalibrationResult* result);
  SigmaBars* bars() const { return bars_; }

 private:
  SigmaBars* bars_;
  QLabel *intro_, *legend_;
};

}  // namespace remount::widgets
