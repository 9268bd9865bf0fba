#include "app/gui/shell/menus.h"

namespace remount::gui {

Menus::Menus(QMenuBar& bar) : QObject(&bar) {
  QMenu* file = bar.addMenu(tr("&File"));
  plan(file, {{MenuPlace::FileNew, false}});
  open_ = file->addMenu(tr("&Open"));
  plan(open_, {{MenuPlace::OpenDrive, true}, {MenuPlace::OpenProject, false}});
  plan(file, {{MenuPlace::FileRecent, true},
              {MenuPlace::FileSave, true},
              {MenuPlace::FileResult, true},
              {MenuPlace::FileQuit, false}});
  plan(bar.addMenu(tr("&Edit")),
       {{MenuPlace::EditUndo, true}, {MenuPlace::EditCopy, false}, {MenuPlace::EditOptions, false}});
  plan(bar.addMenu(tr("&Calibrate")), {{MenuPlace::CalibrateRun, true}, {MenuPlace::CalibrateResult, false}});
  plan(bar.addMenu(tr("&Review")), {{MenuPlace::ReviewDecide, true},
                                    {MenuPlace::ReviewGo, true},
                                    {MenuPlace::ReviewView, true},
                                    {MenuPlace::ReviewKeys, false}});
  plan(bar.addMenu(tr("&View")), {{MenuPlace::ViewDirections, true},
                                  {MenuPlace::ViewTabs, true},
                                  {MenuPlace::ViewDocks, true},
                                  {MenuPlace::ViewLayout, true},
                                  {MenuPlace::ViewLanguage, false}});
  plan(bar.addMenu(tr("&Help")), {{MenuPlace::Help, false}});
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

}  // namespace remount::gui
