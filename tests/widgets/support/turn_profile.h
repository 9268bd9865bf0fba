// What the event loop spends its turns on: for tests that ask why the window stalled.
#pragma once

#include <QApplication>
#include <QString>
#include <QStringList>
#include <vector>

namespace remount::testing {

/// An application that notes how long each event took, in wall time and in time of this thread. Costs nothing while
/// switched off.
class ProfiledApplication : public QApplication {
 public:
  using QApplication::QApplication;
  bool notify(QObject* receiver, QEvent* event) override;

  static ProfiledApplication& instance() { return *static_cast<ProfiledApplication*>(QCoreApplication::instance()); }
  void start_profile();
  /// Everything since the start or the last call that took at least `least_ms` of this thread, in order; what an event
  /// caused within itself is indented below it.
  QStringList take_profile(double least_ms);

 private:
  struct Taken {
    QString what;
    int depth = 0;
    double cpu_ms = 0.0, wall_ms = 0.0;
  };
  std::vector<Taken> taken_;
  bool profiling_ = false;
  int depth_ = 0;
};

double thread_cpu_ms();

}  // namespace remount::testing
