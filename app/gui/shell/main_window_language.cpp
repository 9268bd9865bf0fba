// The language menu, and what a window hands to the one that takes its place.
#include <QActionGroup>
#include <QMenu>
#include <QTableView>

#include "app/gui/basics/language.h"
#include "app/gui/document/project_keeper.h"
#include "app/gui/features/method_controller.h"
#include "app/gui/shell/main_window.h"
#include "widgets/pairs/pairs_panel.h"
#include "widgets/shell/log_panel.h"

namespace remount {

void MainWindow::add_language_menu(QMenu& menu) {
  // Found also by those who cannot read the language that is set.
  QMenu* list = menu.addMenu(QStringLiteral("&Language / 语言"));
  auto* group = new QActionGroup(list);
  for (const SpokenLanguage& language : languages()) {
    QAction* action = list->addAction(language.name);
    action->setCheckable(true);
    action->setChecked(language.code == spoken_language());
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, code = language.code] { emit language_requested(code); });
  }
}

WindowHandover::WindowHandover(QByteArray geometry_, QByteArray state_, QString log_,
                               std::unique_ptr<Autosave> autosave_, std::unique_ptr<KeptResults> compared_)
    : geometry(std::move(geometry_)),
      state(std::move(state_)),
      log(std::move(log_)),
      autosave(std::move(autosave_)),
      compared(std::move(compared_)) {}
WindowHandover::WindowHandover(WindowHandover&&) noexcept = default;
WindowHandover::~WindowHandover() = default;

WindowHandover MainWindow::hand_over() {
  return {saveGeometry(), saveState(), log_->toPlainText(), keeper_->take_autosave(),
          std::make_unique<KeptResults>(method_control_->compared())};
}

void MainWindow::take_over(WindowHandover handover) {
  restoreGeometry(handover.geometry);
  restoreState(handover.state);
  log_->setPlainText(handover.log);
  keeper_->put_autosave(std::move(handover.autosave));
  method_control_->take_over(std::move(*handover.compared));
  if (workbench_.outcome().output()) pairs_->table()->setFocus();  // else the first step takes it
}

}  // namespace remount
