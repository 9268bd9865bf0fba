// The docks of a window and how they are arranged before the user arranges them.
#pragma once

#include <QDockWidget>
#include <QMainWindow>
#include <vector>

namespace remount::gui {

/// A panel that a feature puts into the window.
struct DockSpec {
  QString title;
  QString name;  ///< by which its place is remembered
  QWidget* content = nullptr;
  Qt::DockWidgetArea area = Qt::BottomDockWidgetArea;  ///< left, right or bottom
  QString help_page;                                   ///< its name in resources/help
  /// The first of an area is seen; others lie behind it, stand beside the one before, or lie behind that.
  enum class Arrangement { Behind, Beside, BehindLast } arrangement = Arrangement::Behind;
  int width = 0, height = 0;  ///< at first, px; 0: what is left
  bool for_review = false;    ///< seen while pairs are judged, when there is room for little else
};

class Docks : public QObject {
  Q_OBJECT
 public:
  explicit Docks(QMainWindow& window);
  QDockWidget* add(const DockSpec& spec);
  /// By area, in the order in which they came.
  std::vector<QDockWidget*> all() const;
  bool is_for_review(const QDockWidget& dock) const;
  void arrange();  ///< sizes and what is in front, as at first

 private:
  struct Placed {
    QDockWidget* dock;
    DockSpec spec;
  };
  void place(const Placed& placed);
  void keep_focus_in_sight(QDockWidget& dock);
  std::vector<const Placed*> of(Qt::DockWidgetArea area) const;

  QMainWindow& window_;
  std::vector<Placed> placed_;
};

}  // namespace remount::gui
