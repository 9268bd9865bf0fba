#include "app/gui/basics/turn_queue.h"

#include <algorithm>

namespace remount::gui {

TurnQueue::TurnQueue(QObject* parent) : QObject(parent) {
  turn_.setSingleShot(true);
  turn_.setInterval(0);
  connect(&turn_, &QTimer::timeout, this, &TurnQueue::next);
}

void TurnQueue::start(std::vector<Piece> pieces) {
  waiting_ = std::move(pieces);
  std::reverse(waiting_.begin(), waiting_.end());
  if (!waiting_.empty()) turn_.start();
}

void TurnQueue::next() {
  if (waiting_.empty()) return;
  const Piece piece = std::move(waiting_.back());
  waiting_.pop_back();
  piece();  // may start others
  if (!waiting_.empty()) turn_.start();
}

void TurnQueue::finish() {
  while (!waiting_.empty()) next();
}

}  // namespace remount::gui
