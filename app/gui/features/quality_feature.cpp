#include "app/gui/features/quality_feature.h"

#include "app/gui/features/map_feature.h"
#include "app/gui/features/quality_controller.h"
#include "app/gui/shell/main_window.h"
#include "widgets/map/map_view.h"
#include "widgets/quality/quality_view.h"
#include "widgets/result/sigma_budget_view.h"

namespace remount::gui {

QualityFeature::QualityFeature(MainWindow& window) : Feature(window), quality_(new widgets::QualityView) {
  dock_ = window.add_dock({.title = tr("Quality"), .name = "quality", .content = quality_, .help_page = "quality"});
  window.menus().add(MenuPlace::CalibrateResult, tr("Check &quality"), tr("Ctrl+Shift+B"), [this] { show_quality(); });
  window.on_step(widgets::Step::Check, [this] { show_quality(); });
  checks_ = new QualityController(workbench_, *quality_, &window);
  quality_->set_on_top(false);
  connect(dock_, &QDockWidget::visibilityChanged, quality_, &widgets::QualityView::set_on_top);
  connect(quality_, &widgets::QualityView::confirmed, &workbench_.outcome(), &Outcome::confirm);
  connect(checks_, &QualityController::map_requested, this, [this](widgets::MapX x) {
    if (auto* map = window_.feature<MapFeature>()) map->show_map(x);
  });
}

std::vector<TurnQueue::Piece> QualityFeature::show_output_later() {
  return {[this] { checks_->refresh(); },
          [this] {
            const OutputPtr output = workbench_.outcome().output();
            quality_->sigmas()->show_result(output ? &output->result : nullptr);
          }};
}

void QualityFeature::show_state() {
  const OutputPtr output = workbench_.outcome().output();
  const Activity& activity = workbench_.activity();
  const bool settled = !activity.opening() && !activity.calibrating() && !activity.solving();
  quality_->show_confirmed(workbench_.outcome().confirmed(), output && calibration::is_usable(output->result) &&
                                                                 settled && !workbench_.map_checks().checking() &&
                                                                 !workbench_.calibrations().out_of_date());
}

void QualityFeature::show_quality() {
  dock_->show();
  dock_->raise();
  quality_->setFocus();
}

}  // namespace remount::gui
