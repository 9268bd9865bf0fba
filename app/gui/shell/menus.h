// The menus of a window, and where in them features put their actions.
#pragma once

#include <QMenuBar>
#include <functional>
#include <map>

namespace remount::gui {

/// Places in the order of the menus. What several features put in one place stands there in their order.
enum class MenuPlace {
  FileNew,
  OpenDrive,  ///< the menu behind every button that opens
  OpenProject,
  FileRecent,
  FileSave,
  FileResult,
  FileQuit,
  EditUndo,
  EditCopy,
  EditOptions,
  CalibrateRun,
  CalibrateResult,
  ReviewDecide,
  ReviewGo,
  ReviewView,
  ReviewKeys,
  ViewDirections,
  ViewTabs,
  ViewDocks,
  ViewLayout,
  ViewLanguage,
  Help,
};

class Menus : public QObject {
  Q_OBJECT
 public:
  explicit Menus(QMenuBar& bar);
  QAction* add(MenuPlace place, const QString& text, const QKeySequence& key, const std::function<void()>& act);
  void add(MenuPlace place, QAction* action);
  QMenu* add_menu(MenuPlace place, const QString& text);
  QMenu& open_menu() const { return *open_; }  ///< folder, files, project

 private:
  struct Section {
    QMenu* menu = nullptr;
    QAction* end = nullptr;  ///< its line, or what is not seen in the place of one
  };
  /// The next sections of a menu; those after which `line` says so end with a line.
  struct Planned {
    MenuPlace place;
    bool line;
  };
  void plan(QMenu* menu, std::initializer_list<Planned> sections);

  std::map<MenuPlace, Section> sections_;
  QMenu* open_ = nullptr;
};

}  // namespace remount::gui
