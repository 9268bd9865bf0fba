#include "app/gui/features/residuals_feature.h"

#include "app/gui/shell/main_window.h"
#include "widgets/residuals/residuals_panel.h"

namespace remount::gui {

ResidualsFeature::ResidualsFeature(MainWindow& window) : Feature(window), residuals_(new widgets::ResidualsPanel) {
  QDockWidget* dock = window.add_dock({.title = tr("Residuals"),
                                       .name = "residuals",
                                       .content = residuals_,
                                       .help_page = "residuals",
                                       .arrangement = DockSpec::Arrangement::BehindLast,
                                       .for_review = true});
  window.menus().add(MenuPlace::ReviewView, tr("Residuals p&lot"), {}, [this, dock] {
    dock->show();
    dock->raise();
    residuals_->plot()->setFocus();
  });
  Selection& selection = workbench_.selection();
  connect(residuals_->plot(), &widgets::ResidualPlot::pair_clicked, &selection, &Selection::select);
  connect(&selection, &Selection::changed, residuals_->plot(), &widgets::ResidualPlot::show_selected);
  connect(residuals_, &widgets::ResidualsPanel::reject_requested, this, &ResidualsFeature::reject);
}

std::vector<TurnQueue::Piece> ResidualsFeature::show_output_later() {
  return {[this] {
    residuals_->plot()->show_session_names(workbench_.sessions().names());
    residuals_->plot()->show_output(workbench_.outcome().output());
    residuals_->plot()->show_selected(workbench_.selection().pair());
  }};
}

void ResidualsFeature::reject(const std::vector<motion::PairIndex>& pairs, const QString& reason) {
  workbench_.decisions().decide(pairs, motion::PairState::Rejected, Message::verbatim(reason.toStdString()));
}

}  // namespace remount::gui
