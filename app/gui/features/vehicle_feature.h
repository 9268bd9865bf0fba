// The vehicle with all of its LiDARs.
#pragma once

#include "app/gui/shell/feature.h"
#include "widgets/vehicle/lidars_panel.h"

class QAction;
class QDockWidget;

namespace remount::widgets {
class MapView;
}  // namespace remount::widgets

namespace remount::gui {

class VehicleMapController;

class VehicleFeature : public Feature {
  Q_OBJECT
 public:
  explicit VehicleFeature(MainWindow& window);
  void show_state() override;

 private:
  void connect_panel();
  void show_vehicle();
  widgets::LidarEntry entry_of(motion::LidarIndex lidar) const;
  void show_picture();
  void show_cross_pair(widgets::CrossPairIndex pair);
  bool may_write() const;
  void save_results();
  void ask_for_report();
  void show_export();

  widgets::LidarsPanel* panel_;
  widgets::MapView* map_;
  VehicleMapController* maps_ = nullptr;
  QDockWidget* dock_;
  QAction *calibrate_ = nullptr, *solve_ = nullptr, *export_ = nullptr, *save_ = nullptr, *report_ = nullptr;
  const void* shown_common_ = nullptr;  // whose pairs and verdict are in the panel
  bool was_vehicle_ = false;
  int clouds_ = 0;  // the job that reads those of a pair across LiDARs
};

}  // namespace remount::gui
