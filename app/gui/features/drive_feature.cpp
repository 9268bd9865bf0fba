#include "app/gui/features/drive_feature.h"

#include "app/gui/shell/main_window.h"
#include "widgets/sessions/drive_panel.h"

namespace remount::gui {

DriveFeature::DriveFeature(MainWindow& window) : Feature(window), drive_(new widgets::DrivePanel) {
  window.add_dock(
      {.title = tr("Drive"), .name = "drive", .content = drive_, .area = Qt::LeftDockWidgetArea, .help_page = "drive"});
  connect(drive_, &widgets::DrivePanel::pair_selected, &workbench_.selection(), &Selection::select);
  connect(&workbench_.selection(), &Selection::changed, drive_, &widgets::DrivePanel::show_selected);
  connect(&workbench_.overviews(), &DriveOverviews::changed, this,
          [this] { drive_->show_drives(workbench_.sessions().names(), workbench_.overviews().all()); });
}

std::vector<TurnQueue::Piece> DriveFeature::show_output_later() {
  return {[this] {
    drive_->show_output(workbench_.outcome().output());
    drive_->show_selected(workbench_.selection().pair());
  }};
}

}  // namespace remount::gui
