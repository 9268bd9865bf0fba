#include "app/gui/shell/menus.h"

namespace remount {

Menus::Menus(QMenuBar& bar) : QObject(&bar) {
  using Place = MenuPlace;
  QMenu* file = bar.addMenu(tr("&File"));
  plan(file, {{Place::FileNew, false}});
  open_ = file->addMenu(tr("&Open"));
  plan(open_, {{Place::OpenDrive, true}, {Place::OpenProject, false}});
  plan(file, {{Place::FileRecent, true}, {Place::FileSave, true}, {Place::FileResult, true}, {Place::FileQuit, false}});
  plan(bar.addMenu(tr("&Edit")), {{Place::EditUndo, true}, {Place::EditCopy, false}, {Place::EditOptions, false}});
  plan(bar.addMenu(tr("&Calibrate")), {{Place::CalibrateRun, true}, {Place::CalibrateResult, false}});
  plan(bar.addMenu(tr("&Review")),
       {{Place::ReviewDecide, true}, {Place::ReviewGo, true}, {Place::ReviewView, true}, {Place::ReviewKeys, false}});
  plan(bar.addMenu(tr("&View")), {{Place::ViewDirections, true},
                                  {Place::ViewTabs, true},
                                  {Place::ViewDocks, true},
                                  {Place::ViewLayout, true},
                                  {Place::ViewLanguage, false}});
  plan(bar.addMenu(tr("&Help")), {{Place::Help, false}});
}

void Menus::plan(QMenu* menu, std::initializer_list<Planned> sections) {
  for (const Planned& planned : sections) {
    auto* end = new QAction(menu);
    end->setSeparator(true);
    end->setVisible(planned.line);  // lines of empty sections are not drawn twice
    menu->addAction(end);
    sections_[planned.place] = {menu, end};
  }
}

void Menus::add(MenuPlace place, QAction* action) {
  const Section& section = sections_.at(place);
  section.menu->insertAction(section.end, action);
}

QAction* Menus::add(MenuPlace place, const QString& text, const QKeySequence& key, const std::function<void()>& act) {
  auto* action = new QAction(text, sections_.at(place).menu);
  action->setShortcut(key);
  connect(action, &QAction::triggered, this, [act] { act(); });
  add(place, action);
  return action;
}

QMenu* Menus::add_menu(MenuPlace place, const QString& text) {
  const Section& section = sections_.at(place);
  auto* menu = new QMenu(text, section.menu);
  section.menu->insertMenu(section.end, menu);
  return menu;
}

}  // namespace remount
