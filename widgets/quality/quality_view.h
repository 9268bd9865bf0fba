// Whether the calibration is good: distances to obstacles, the map, sessions against each other, parts of the sigmas.
#pragma once

#include <QTabWidget>

class QCheckBox;

namespace remount::widgets {

class ClearanceView;
class HoldOutView;
class SharpnessView;
class SigmaBudgetView;

class QualityView : public QTabWidget {
  Q_OBJECT
 public:
  explicit QualityView(QWidget* parent = nullptr);
  ClearanceView* obstacles() const { return obstacles_; }
  SharpnessView* sharpness() const { return sharpness_; }
  HoldOutView* hold_out() const { return hold_out_; }
  SigmaBudgetView* sigmas() const { return sigmas_; }
  /// Whether the user said that the result is good, and whether there is one of which that can be said.
  void show_confirmed(bool confirmed, bool possible);
  /// Behind other docks of its tabs it is visible to Qt, and nobody sees it.
  void set_on_top(bool on_top);
  bool seen() const { return on_top_ && isVisible(); }

 signals:
  void looked_at();           ///< a page came to be seen: what it shows may be out of date
  void confirmed(bool good);  ///< by the user

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  ClearanceView* obstacles_;
  SharpnessView* sharpness_;
  HoldOutView* hold_out_;
  SigmaBudgetView* sigmas_;
  QCheckBox* confirm_;
  bool on_top_ = true;
};

}  // namespace remount::widgets
