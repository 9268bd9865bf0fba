// What was opened lately, newest first; remembered for the application, not for tests' windows.
#pragma once

#include <QStringList>

namespace remount::gui {

class RecentPaths {
 public:
  static constexpr qsizetype kMost = 10;
  RecentPaths();
  void add(const QString& path);
  void clear();
  const QStringList& paths() const { return paths_; }
  QStringList labels() const;  ///< as short as tells them apart: the name, and its folder

 private:
  void keep() const;
  QStringList paths_;
};

}  // namespace remount::gui
