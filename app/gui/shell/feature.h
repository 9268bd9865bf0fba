// What plugs into a window.
#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <vector>

#include "app/gui/basics/turn_queue.h"

class QPalette;

namespace remount::gui {

class MainWindow;
class Workbench;

/// Something that a window can do: it makes its docks, views and actions in the window that it is given, says which
/// help page is about them, and connects its panels with the workbench. It knows no other feature but by
/// MainWindow::feature, and does without one that is not there. Panels and their models are children of the window and
/// outlive the feature: what they call of it is connected to it, so that nothing is called when it is gone.
class Feature : public QObject {
  Q_OBJECT
 public:
  explicit Feature(MainWindow& window);
  ~Feature() override;

  /// The output is another: what the user asks and decides by is right at once.
  virtual void show_output() {}
  /// Pictures and what lies behind, each in a turn of the event loop of its own, or all of it would stall the window.
  virtual std::vector<TurnQueue::Piece> show_output_later() { return {}; }
  virtual void show_state() {}                   ///< Workbench::state_changed, and with every other output
  virtual void show_palette(const QPalette&) {}  ///< at the start, and where the desktop has other colours
  /// False where the user has to answer more, or changed their mind; `again` is called where they chose to save.
  virtual bool may_close(const std::function<void()>& again);
  virtual void finish() {}  ///< the window closes for good

  /// What stays when another window takes the place of one, for the same feature of that.
  struct Kept {
    virtual ~Kept() = default;
  };
  virtual std::unique_ptr<Kept> hand_over() { return nullptr; }
  virtual void take_over(Kept*) {}

 protected:
  MainWindow& window_;
  Workbench& workbench_;
};

using MakeFeature = std::function<std::unique_ptr<Feature>(MainWindow&)>;

template <class Plugged>
MakeFeature plug() {
  return [](MainWindow& window) { return std::make_unique<Plugged>(window); };
}

}  // namespace remount::gui
