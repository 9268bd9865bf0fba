#include "app/gui/shell/workspaces.h"

#include <QSettings>

#include "algorithms/core/index.h"
#include "app/gui/basics/remembering.h"

namespace remount::gui {
namespace {
constexpr int kLayoutVersion = 4;  // up with every dock that is new
constexpr double kReviewHeight = 0.20;
const QString kState = QStringLiteral("window/state"), kReviewState = QStringLiteral("window/review-state"),
              kNow = QStringLiteral("window/workspace");
}  // namespace

Workspaces::Workspaces(QMainWindow& window, Docks& docks) : QObject(&window), window_(window), docks_(docks) {}

void Workspaces::go_to(Workspace workspace) {
  if (workspace == now_) return;
  states_[index_of(now_)] = window_.saveState(kLayoutVersion);
  now_ = workspace;
  const QByteArray& state = states_[index_of(now_)];
  if (!state.isEmpty())
    window_.restoreState(state, kLayoutVersion);
  else if (now_ == Workspace::Review)
    arrange_review();
  else
    reset();
}

void Workspaces::arrange_review() {
  QList<QDockWidget*> beside;
  QList<int> widths;
  for (QDockWidget* dock : docks_.all()) {
    dock->setVisible(docks_.is_for_review(*dock));
    if (!docks_.is_for_review(*dock)) continue;
    beside << dock;
    widths << window_.width() / 2;
  }
  if (beside.empty()) return;
  beside.front()->raise();
  window_.resizeDocks(beside, widths, Qt::Horizontal);
  window_.resizeDocks({beside.front()}, {static_cast<int>(kReviewHeight * window_.height())}, Qt::Vertical);
}

void Workspaces::reset() {
  states_ = {};
  if (now_ == Workspace::Review) return arrange_review();
  window_.restoreState(first_, kLayoutVersion);
  for (QDockWidget* dock : docks_.all()) dock->show();
  docks_.arrange();
}

void Workspaces::restore() {
  first_ = window_.saveState(kLayoutVersion);
  if (!remembers()) return;
  const QSettings settings;
  states_ = {settings.value(kState).toByteArray(), settings.value(kReviewState).toByteArray()};
  window_.restoreState(states_[index_of(Workspace::All)], kLayoutVersion);
  if (settings.value(kNow).toString() == QLatin1String("review")) go_to(Workspace::Review);
}

void Workspaces::remember() {
  states_[index_of(now_)] = window_.saveState(kLayoutVersion);
  QSettings settings;
  settings.setValue(kState, states_[index_of(Workspace::All)]);
  settings.setValue(kReviewState, states_[index_of(Workspace::Review)]);
  settings.setValue(kNow, now_ == Workspace::Review ? "review" : "all");
}

}  // namespace remount::gui
