#include "app/gui/features/methods_feature.h"

#include <QTabWidget>

#include "app/gui/features/method_controller.h"
#include "app/gui/shell/main_window.h"
#include "widgets/basics/file_dialogs.h"
#include "widgets/map/path_view.h"
#include "widgets/methods/method_view.h"
#include "widgets/result/comparison_view.h"

namespace remount::gui {
namespace {
struct KeptComparison : Feature::Kept {
  KeptResults results;
};
}  // namespace

MethodsFeature::MethodsFeature(MainWindow& window)
    : Feature(window),
      method_(new widgets::MethodView),
      paths_(new widgets::PathView),
      comparison_(new widgets::ComparisonView),
      pages_(new QTabWidget) {
  pages_->setDocumentMode(true);
  pages_->addTab(method_, tr("Figures and plots"));
  pages_->addTab(paths_, tr("In three dimensions"));
  pages_->addTab(comparison_, tr("Results compared"));
  dock_ = window.add_dock({.title = tr("Method"), .name = "methods", .content = pages_, .help_page = "methods"});
  window.menus().add(MenuPlace::CalibrateResult, tr("Figures of the &method, results compared"), tr("Ctrl+Shift+D"),
                     [this] { show_methods(); });
  control_ = new MethodController(workbench_, *method_, *paths_, *comparison_, &window);
  connect(comparison_, &widgets::ComparisonView::add_requested, this, &MethodsFeature::ask_for_results);
  connect(&workbench_.document(), &ProjectDocument::replaced, control_, &MethodController::clear_files);
}

void MethodsFeature::show_methods() {
  dock_->show();
  dock_->raise();
  pages_->setFocus();
}

void MethodsFeature::ask_for_results() {
  const QStringList paths = widgets::ask_for_files(&window_, tr("Results to compare"), widgets::FileKind::Results,
                                                   tr("Results (*.yaml *.yml *.json);;All files (*)"));
  if (!paths.isEmpty()) control_->add_files(paths);
}

std::unique_ptr<Feature::Kept> MethodsFeature::hand_over() {
  auto kept = std::make_unique<KeptComparison>();
  kept->results = control_->compared();
  return kept;
}

void MethodsFeature::take_over(Kept* kept) {
  if (auto* comparison = dynamic_cast<KeptComparison*>(kept)) control_->take_over(std::move(comparison->results));
}

}  // namespace remount::gui
