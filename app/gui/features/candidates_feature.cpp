#include "app/gui/features/candidates_feature.h"

#include "app/gui/features/map_feature.h"
#include "app/gui/features/pair_view_feature.h"
#include "app/gui/shell/main_window.h"
#include "widgets/result/candidate_table_model.h"
#include "widgets/result/candidates_panel.h"

namespace remount::gui {

CandidatesFeature::CandidatesFeature(MainWindow& window)
    : Feature(window),
      model_(new widgets::CandidateTableModel(&window)),
      candidates_(new widgets::CandidatesPanel(*model_)) {
  QDockWidget* dock = window.add_dock(
      {.title = tr("Candidates"), .name = "candidates", .content = candidates_, .help_page = "candidates"});
  window.on_step(widgets::Step::Solve, [dock] { dock->raise(); });
  connect(candidates_, &widgets::CandidatesPanel::candidate_selected, this, &CandidatesFeature::look_at);
  const Setup& setup = workbench_.setup();
  connect(&setup, &Setup::settings_changed, this, [this, &setup] { candidates_->show_range(setup.settings().range); });
  connect(&setup, &Setup::nominal_changed, this,
          [this, &setup] { candidates_->show_nominal(setup.nominal_ins_from_lidar()); });
}

void CandidatesFeature::look_at(calibration::CandidateIndex candidate) {
  auto* const pair_view = window_.feature<PairViewFeature>();
  auto* const map = window_.feature<MapFeature>();
  std::optional<calibration::CandidateIndex> shown = candidate;
  if (pair_view) shown = pair_view->show_candidate(candidate);
  if (map) map->show_candidate(shown);
}

std::vector<TurnQueue::Piece> CandidatesFeature::show_output_later() {
  return {[this] {
    const OutputPtr output = workbench_.outcome().output();
    model_->show_output(output);
    candidates_->show_output(output);
  }};
}

void CandidatesFeature::show_palette(const QPalette& palette) { model_->set_palette(palette); }

}  // namespace remount::gui
