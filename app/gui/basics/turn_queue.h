// Work of the window's thread in pieces: one a turn of the event loop.
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <vector>

namespace remount::gui {

/// Between two pieces the window paints what the one before has changed, and answers the user.
class TurnQueue : public QObject {
 public:
  using Piece = std::function<void()>;
  explicit TurnQueue(QObject* parent = nullptr);
  /// Takes the place of what waits still: newer pieces show what is there now.
  void start(std::vector<Piece> pieces);
  /// All that waits, at once.
  void finish();
  bool idle() const { return waiting_.empty(); }

 private:
  void next();
  std::vector<Piece> waiting_;  // the next one last
  QTimer turn_;
};

}  // namespace remount::gui
