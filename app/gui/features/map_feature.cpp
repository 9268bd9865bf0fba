#include "app/gui/features/map_feature.h"

#include "app/gui/features/map_controller.h"
#include "app/gui/shell/main_window.h"

namespace remount::gui {

MapFeature::MapFeature(MainWindow& window) : Feature(window), view_(new widgets::MapView(&window)) {
  view_->setObjectName(QStringLiteral("map"));
  window.add_view({view_, tr("Map"), "map", "show-map", tr("The accumulated &map"), tr("Ctrl+M")});
  maps_ = new MapController(workbench_, *view_, &window);
}

std::vector<TurnQueue::Piece> MapFeature::show_output_later() {
  return {[this] { maps_->refresh(); }};
}

void MapFeature::show_candidate(std::optional<calibration::CandidateIndex> candidate) {
  maps_->show_candidate(candidate);
}

void MapFeature::show_map(widgets::MapX x) {
  view_->choose(x);
  window_.show_view(*view_);
}

}  // namespace remount::gui
