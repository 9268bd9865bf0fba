// Whether the calibration is good: sessions against each other, the map, distances to obstacles.
#pragma once

#include <QTabWidget>

namespace remount {

class HoldOutView;
class SharpnessView;

class QualityView : public QTabWidget {
  Q_OBJECT
 public:
  explicit QualityView(QWidget* parent = nullptr);
  SharpnessView* sharpness() const { return sharpness_; }
  HoldOutView* hold_out() const { return hold_out_; }

 signals:
  void looked_at();  ///< a page came to be seen: what it shows may be out of date

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  SharpnessView* sharpness_;
  HoldOutView* hold_out_;
};

}  // namespace remount
