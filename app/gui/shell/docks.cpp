#include "app/gui/shell/docks.h"

#include <QApplication>
#include <QScrollArea>
#include <algorithm>
#include <initializer_list>

#include "widgets/basics/shrinking_area.h"

namespace remount::gui {
namespace {
constexpr std::initializer_list<Qt::DockWidgetArea> kAreas{Qt::LeftDockWidgetArea, Qt::RightDockWidgetArea,
                                                           Qt::BottomDockWidgetArea};
}  // namespace

Docks::Docks(QMainWindow& window) : QObject(&window), window_(window) {
  window_.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  window_.setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
  for (const auto area : {Qt::LeftDockWidgetArea, Qt::BottomDockWidgetArea})
    window_.setTabPosition(area, QTabWidget::North);
}

QDockWidget* Docks::add(const DockSpec& spec) {
  auto* dock = new QDockWidget(spec.title, &window_);
  dock->setObjectName(spec.name);
  // What scrolls by itself is not put into another that does: one bar would hide the other.
  const bool scrolls = qobject_cast<QScrollArea*>(spec.content) != nullptr;
  dock->setWidget(scrolls ? spec.content : new widgets::ShrinkingArea(spec.content));
  window_.addDockWidget(spec.area, dock);
  keep_focus_in_sight(*dock);
  place({dock, spec});
  placed_.push_back({dock, spec});
  return dock;
}

void Docks::place(const Placed& placed) {
  const std::vector<const Placed*> before = of(placed.spec.area);
  if (before.empty()) return;
  if (placed.spec.arrangement == DockSpec::Arrangement::Beside)
    return window_.splitDockWidget(before.back()->dock, placed.dock, Qt::Horizontal);
  if (placed.spec.arrangement == DockSpec::Arrangement::BehindLast) {
    const auto beside = std::find_if(before.rbegin(), before.rend(), [](const Placed* one) {
      return one->spec.arrangement == DockSpec::Arrangement::Beside;
    });
    QDockWidget* const front = (beside == before.rend() ? before.back() : *beside)->dock;
    window_.tabifyDockWidget(front, placed.dock);
    return front->raise();
  }
  // One after the other: all beside each other would widen the window. What stands beside has none behind it.
  const auto last = std::find_if(before.rbegin(), before.rend(), [](const Placed* one) {
    return one->spec.arrangement == DockSpec::Arrangement::Behind;
  });
  window_.tabifyDockWidget((*last)->dock, placed.dock);
}

void Docks::keep_focus_in_sight(QDockWidget& dock) {
  // A panel behind another keeps the focus otherwise: F1 and keys would be for what is not seen.
  connect(&dock, &QDockWidget::visibilityChanged, this, [this, &dock](bool seen) {
    if (!seen) return;  // the window may be going
    const QList<QDockWidget*> others = window_.tabifiedDockWidgets(&dock);
    const bool behind = std::any_of(others.begin(), others.end(), [](const QDockWidget* other) {
      return other->isAncestorOf(QApplication::focusWidget());
    });
    if (behind) dock.widget()->setFocus();
  });
}

std::vector<const Docks::Placed*> Docks::of(Qt::DockWidgetArea area) const {
  std::vector<const Placed*> there;
  for (const Placed& placed : placed_)
    if (placed.spec.area == area) there.push_back(&placed);
  return there;
}

std::vector<QDockWidget*> Docks::all() const {
  std::vector<QDockWidget*> docks;
  for (const auto area : kAreas)
    for (const Placed* placed : of(area)) docks.push_back(placed->dock);
  return docks;
}

bool Docks::is_for_review(const QDockWidget& dock) const {
  return std::any_of(placed_.begin(), placed_.end(),
                     [&](const Placed& placed) { return placed.dock == &dock && placed.spec.for_review; });
}

void Docks::arrange() {
  QList<QDockWidget*> high, beside, sides;
  QList<int> heights, widths, side_widths;
  for (const Placed& placed : placed_) {
    const bool at_side = placed.spec.area != Qt::BottomDockWidgetArea;
    if (placed.spec.height > 0) {
      high << placed.dock;
      heights << placed.spec.height;
    }
    if (placed.spec.width <= 0) continue;
    (at_side ? sides : beside) << placed.dock;
    (at_side ? side_widths : widths) << placed.spec.width;
  }
  for (const auto area : kAreas)
    if (const auto there = of(area); !there.empty()) there.front()->dock->raise();
  window_.resizeDocks(beside, widths, Qt::Horizontal);
  window_.resizeDocks(high, heights, Qt::Vertical);
  window_.resizeDocks(sides, side_widths, Qt::Horizontal);
}

}  // namespace remount::gui
