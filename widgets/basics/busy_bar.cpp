#include "widgets/basics/busy_bar.h"

#include <QStyleOptionProgressBar>
#include <QStylePainter>

namespace remount::widgets {
namespace {
constexpr int kStep_ms = 250, kSteps = 8, kChunkSteps = 2;
}  // namespace

BusyBar::BusyBar(QWidget* parent) : QProgressBar(parent) {
  step_.setInterval(kStep_ms);
  connect(&step_, &QTimer::timeout, this, [this] {
    if (is_busy()) update();
  });
}

void BusyBar::paintEvent(QPaintEvent* event) {
  if (!is_busy()) return QProgressBar::paintEvent(event);
  QStylePainter painter(this);
  QStyleOptionProgressBar option;
  initStyleOption(&option);
  option.maximum = kSteps;  // an empty range would start the style's own animation
  option.progress = 0;
  painter.drawControl(QStyle::CE_ProgressBar, option);
  const QRect room = style()->subElementRect(QStyle::SE_ProgressBarContents, &option, this).adjusted(1, 1, -1, -1);
  const int turn = 2 * (kSteps - kChunkSteps);  // there and back
  const int at = static_cast<int>(since_.elapsed() / kStep_ms) % turn;
  const int place = at < turn / 2 ? at : turn - at;
  const int step = room.width() / kSteps;
  painter.fillRect(QRect(room.left() + place * step, room.top(), kChunkSteps * step, room.height()),
                   palette().color(QPalette::Highlight));
}

void BusyBar::showEvent(QShowEvent* event) {
  since_.start();
  step_.start();
  QProgressBar::showEvent(event);
}

void BusyBar::hideEvent(QHideEvent* event) {
  step_.stop();
  QProgressBar::hideEvent(event);
}

}  // namespace remount::widgets
