// Measures the obstacles of a scan for a dialog, away from the window's thread.
#pragma once

#include <QObject>

#include "app/gui/workbench/workbench.h"

namespace remount::widgets {
class ObstacleDialog;
}  // namespace remount::widgets

namespace remount::gui {

/// Lives as long as its dialog. One check at a time, and always of the options that were typed last.
class ObstacleController : public QObject {
  Q_OBJECT
 public:
  /// Scan b of `clouds` is checked, under the mounting before and under the result.
  ObstacleController(JobRunner& jobs, widgets::ObstacleDialog& dialog, CloudsPtr clouds,
                     const RigidTransform& before_vehicle_from_lidar, const RigidTransform& result_vehicle_from_lidar);

 private:
  void check();
  void done();

  JobRunner& jobs_;
  widgets::ObstacleDialog& dialog_;
  CloudsPtr clouds_;
  RigidTransform before_vehicle_from_lidar_, result_vehicle_from_lidar_;
  bool running_ = false, edited_ = false;  // edited while a check was running
};

}  // namespace remount::gui
