#include "tests/widgets/support/turn_profile.h"

#include <time.h>

#include <QElapsedTimer>
#include <QEvent>
#include <QMetaEnum>
#include <QThread>

namespace remount::testing {

double thread_cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

bool ProfiledApplication::notify(QObject* receiver, QEvent* event) {
  if (!profiling_ || QThread::currentThread() != thread()) return QApplication::notify(receiver, event);
  // Named before it is delivered: neither may be there afterwards.
  const char* type = QMetaEnum::fromType<QEvent::Type>().valueToKey(event->type());
  const QString what = QStringLiteral("%1 to %2 %3")
                           .arg(QLatin1String(type ? type : "?"), QLatin1String(receiver->metaObject()->className()),
                                receiver->objectName());
  const std::size_t place = taken_.size();
  taken_.push_back({what, depth_++, 0.0, 0.0});
  QElapsedTimer wall;
  wall.start();
  const double cpu = thread_cpu_ms();
  const bool done = QApplication::notify(receiver, event);
  --depth_;
  if (place < taken_.size()) {
    taken_[place].cpu_ms = thread_cpu_ms() - cpu;
    taken_[place].wall_ms = 1e-6 * static_cast<double>(wall.nsecsElapsed());
  }
  return done;
}

void ProfiledApplication::start_profile() {
  taken_.clear();
  profiling_ = true;
}

QStringList ProfiledApplication::take_profile(double least_ms) {
  QStringList lines;
  for (const Taken& taken : taken_)
    if (taken.cpu_ms >= least_ms)
      lines << QStringLiteral("%1%2 ms (%3 ms) %4")
                   .arg(QString(2 * taken.depth, ' '))
                   .arg(taken.cpu_ms, 0, 'f', 1)
                   .arg(taken.wall_ms, 0, 'f', 1)
                   .arg(taken.what);
  taken_.clear();
  return lines;
}

}  // namespace remount::testing
