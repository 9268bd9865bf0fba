// The event loop never waits: a hundred scans are opened, five hundred pairs registered, and the window still answers.
#include <gtest/gtest.h>
#include <time.h>

#include <QElapsedTimer>
#include <QEventLoop>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <functional>

#include "app/gui/main_window.h"
#include "model/simulator/simulator.h"
#include "tests/widgets/support/turn_profile.h"
#include "widgets/forms/option_access.h"

namespace remount {
namespace {

using testing::ProfiledApplication;
using testing::thread_cpu_ms;

constexpr int kPatience_ms = 280000;
constexpr double kLongestStall_ms = 50.0;

/// How long this thread was ready to run and the machine's cores were taken by others, ms.
double waited_for_a_core_ms() {
  std::ifstream file("/proc/thread-self/schedstat");
  double running_ns = 0.0, waiting_ns = 0.0;
  file >> running_ns >> waiting_ns;
  return 1e-6 * waiting_ns;
}

/// Ticks every 5 ms and notes how long the loop took to come back, and how much of that it computed.
class Watchdog : public QObject {
 public:
  Watchdog() {
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, [this] {
      const double wall = 1e-6 * static_cast<double>(since_.nsecsElapsed()) - kTick_ms;
      const double cpu = thread_cpu_ms() - cpu_;
      wall_ = std::max(wall_, wall);
      const double own = wall - (waited_for_a_core_ms() - waited_);
      if (own > own_) own_ = own, at_ = what;
      cpu_longest_ = std::max(cpu_longest_, cpu);
      if (profiling_) tell_long_turn(wall, cpu);
      since_.start();
      cpu_ = thread_cpu_ms();
      waited_ = waited_for_a_core_ms();
    });
    if (profiling_) ProfiledApplication::instance().start_profile();
    since_.start();
    cpu_ = thread_cpu_ms();
    waited_ = waited_for_a_core_ms();
    timer_.start(kTick_ms);
  }
  double longest_ms() const { return wall_; }
  /// Without what other programs on the machine took: the window's own doing.
  double longest_own_ms() const { return own_; }
  double longest_computed_ms() const { return cpu_longest_; }
  QString at() const { return at_; }
  QString what;  ///< is under way

 private:
  static constexpr int kTick_ms = 5;
  static constexpr double kLongTurn_ms = 20.0, kLongEvent_ms = 2.0;

  void tell_long_turn(double wall_ms, double cpu_ms) const {
    const QStringList events = ProfiledApplication::instance().take_profile(kLongEvent_ms);
    if (cpu_ms > kLongTurn_ms)
      std::printf("TURN %s: computed %.1f ms of %.1f ms\n%s\n", qPrintable(what), cpu_ms, wall_ms,
                  qPrintable(events.join('\n')));
  }

  bool profiling_ = qEnvironmentVariableIsSet("REMOUNT_PROFILE");  // which events take long turns, and how long
  QTimer timer_;
  QElapsedTimer since_;
  double cpu_ = 0.0, cpu_longest_ = 0.0, wall_ = 0.0, own_ = 0.0, waited_ = 0.0;
  QString at_;
};

/// A loop of its own: QTest's waiting sleeps in between, which would pass for stalls.
bool run_until(const std::function<bool()>& done, int patience_ms) {
  QEventLoop loop;
  QTimer look, give_up;
  QObject::connect(&look, &QTimer::timeout, &loop, [&] {
    if (done()) loop.quit();
  });
  QObject::connect(&give_up, &QTimer::timeout, &loop, &QEventLoop::quit);
  give_up.setSingleShot(true);
  look.start(3);
  give_up.start(patience_ms);
  loop.exec();
  return done();
}

/// Without OpenGL, in a process of its own: drawing a frame in software is another matter.
TEST(watchdog, child_loads_and_registers) {
  if (qEnvironmentVariableIsEmpty("REMOUNT_WATCHDOG_CHILD")) GTEST_SKIP() << "started by the other test";
  const QTemporaryDir folder;
  SimulationOptions options;
  options.duration_s = 20.0;
  options.scan_rate_hz = 5.0;
  options.beams = 24;
  options.azimuth_steps = 360;
  options.scenario = ScenarioKind::FigureEight;
  const SimulatedDrive drive = simulate_drive(options);
  Progress progress;
  write_drive(drive, folder.filePath("drive").toStdString(), "native", 0, progress);

  Workbench workbench(model_engine());
  MainWindow window(workbench);
  window.show();
  window.keep_work_in(folder.path());
  QTest::qWait(300);
  Settings settings;
  settings.keyframes.distance_m = 0.01;
  settings.keyframes.minimum = 100;
  settings.pairing.max_partners = 6;
  settings.pairing.min_shared_objects = 0;
  for (const OptionField& field : option_fields(settings))
    if (field.section != "range") workbench.edit_option(field.section, field.name, field.value);
  workbench.edit_nominal(drive.ins_from_lidar);
  Watchdog watchdog;
  const auto settled = [&] { return !workbench.opening() && !workbench.calibrating() && !workbench.solving(); };
  watchdog.what = "opening";
  window.open_paths({folder.filePath("drive")});
  ASSERT_TRUE(run_until(settled, kPatience_ms));
  watchdog.what = "calibrating";
  workbench.calibrate();
  ASSERT_TRUE(run_until(settled, kPatience_ms));
  ASSERT_TRUE(workbench.output());
  run_until([] { return false; }, 500);  // the result is shown, its files are hashed, it is autosaved
  watchdog.what = "deciding";
  for (const int pause_ms : {0, 5, 40, 120, 300, 1000}) {
    // As fast as a key repeats, and slow enough for the first answer, or for the whole one, to come in between.
    for (int pair = 0; pair < 4; ++pair) {
      workbench.decide({10 * pair + pause_ms % 7}, PairState::Rejected);
      if (pause_ms > 0) run_until([] { return false; }, pause_ms);
    }
    workbench.undo_stack().undo();
  }
  ASSERT_TRUE(run_until(settled, kPatience_ms));
  run_until([] { return false; }, 500);
  std::printf(
      "WATCHDOG scans %zu pairs %zu longest stall %.1f ms (%s); with waiting for a core %.1f ms; computed %.1f ms\n",
      workbench.sessions().at(0)->scans->size(), workbench.output()->pairs.size(), watchdog.longest_own_ms(),
      qPrintable(watchdog.at()), watchdog.longest_ms(), watchdog.longest_computed_ms());
  EXPECT_GE(workbench.sessions().at(0)->scans->size(), 100U);
  EXPECT_GE(workbench.output()->pairs.size(), 500U);
  EXPECT_LT(watchdog.longest_computed_ms(), kLongestStall_ms) << "the loop computed";
  // On a machine whose cores are all taken a thread waits for its turn; that is no fault of the window.
  EXPECT_LT(watchdog.longest_own_ms(), kLongestStall_ms) << "the loop waited: " << watchdog.at().toStdString();
}

struct ChildRun {
  int exit_code = -1;
  QByteArray said;
};

ChildRun run_child() {
  QProcess child;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("REMOUNT_WATCHDOG_CHILD", "1");
  environment.insert("QT_QPA_PLATFORM", "offscreen");
  child.setProcessEnvironment(environment);
  child.setProcessChannelMode(QProcess::MergedChannels);
  child.start(QCoreApplication::applicationFilePath(), {"--gtest_filter=watchdog.child_loads_and_registers"});
  if (!child.waitForFinished(kPatience_ms)) return {-1, "not done in time"};
  const ChildRun run{child.exitCode(), child.readAll()};
  if (qEnvironmentVariableIsSet("REMOUNT_PROFILE")) std::printf("%s\n", run.said.constData());
  const qsizetype line = run.said.indexOf("WATCHDOG");
  if (line >= 0) std::printf("%s\n", run.said.mid(line, run.said.indexOf('\n', line) - line).constData());
  return run;
}

// What else the machine does makes stalls longer, never shorter: a stall of the window is there every time.
TEST(watchdog, nothing_stalls_while_scans_are_loaded_and_pairs_registered) {
  constexpr int kTries = 3;
  ChildRun run;
  for (int tries = 0; tries < kTries && run.exit_code != 0; ++tries) run = run_child();
  EXPECT_EQ(run.exit_code, 0) << run.said.toStdString();
  EXPECT_GE(run.said.indexOf("WATCHDOG"), 0) << run.said.toStdString();
}

}  // namespace
}  // namespace remount
