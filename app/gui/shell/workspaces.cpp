#include "app/gui/shell/workspaces.h"

#include <QSettings>

#include "algorithms/core/index.h"
#include "widgets/basics/remembering.h"

namespace remount::gui {
namespace {
constexpr int kLayoutVersion = 4;  // up with every dock that is new
constexpr double kReviewHeight = 0.20;
const QString kState = QStringLiteral("window/state"), kReviewState = QStringLiteral("window/review-state"),
              kNow = QStringLiteral("window/workspace");
}  // namespace

Workspaces::Workspaces(QMainWindow& window, Docks& docks) : QObject(&window), window_(window), docks_(docks) {}

void Workspaces::go_to(Workspace workspace) {
  if (workspace == kept_.now) return;
  kept_.states[index_of(kept_.now)] = window_.saveState(kLayoutVersion);
  kept_.now = workspace;
  const QByteArray& state = kept_.states[index_of(kept_.now)];
  if (!state.isEmpty())
    window_.restoreState(state, kLayoutVersion);
  else if (kept_.now == Workspace::Review)
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
  kept_.states = {};
  if (kept_.now == Workspace::Review) return arrange_review();
  window_.restoreState(first_, kLayoutVersion);
  for (QDockWidget* dock : docks_.all()) dock->show();
  docks_.arrange();
}

void Workspaces::restore() {
  first_ = window_.saveState(kLayoutVersion);
  if (!widgets::remembers()) return;
  const QSettings settings;
  kept_.states = {settings.value(kState).toByteArray(), settings.value(kReviewState).toByteArray()};
  window_.restoreState(kept_.states[index_of(Workspace::All)], kLayoutVersion);
  if (settings.value(kNow).toString() == QLatin1String("review")) go_to(Workspace::Review);
}

WorkspaceStates Workspaces::hand_over() {
  kept_.states[index_of(kept_.now)] = window_.saveState(kLayoutVersion);
  return kept_;
}

void Workspaces::take_over(const WorkspaceStates& states) {
  kept_ = states;
  window_.restoreState(kept_.states[index_of(kept_.now)], kLayoutVersion);
}

void Workspaces::remember() {
  (void)hand_over();
  QSettings settings;
  settings.setValue(kState, kept_.states[index_of(Workspace::All)]);
  settings.setValue(kReviewState, kept_.states[index_of(Workspace::Review)]);
  settings.setValue(kNow, kept_.now == Workspace::Review ? "review" : "all");
}

}  // namespace remount::gui
