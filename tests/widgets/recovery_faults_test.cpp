// Autosaves while system calls fail, processes are killed and the clock is set.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <QFileInfo>
#include <QTemporaryDir>
#include <random>

#include "algorithms/core/error.h"
#include "app/gui/document/recovery.h"
#include "app/gui/workbench/workbench.h"
#include "tests/support/fault_law.h"

namespace remount::widgets {
namespace {

using testing::Fault;
using testing::TracedRun;

constexpr int kKills = 200;

/// A state of the work that its nominal mounting tells from others.
gui::ProjectSnapshot state(int number) {
  gui::ProjectSnapshot snapshot;
  snapshot.project.sessions = {"/data/drive1"};
  snapshot.project.nominal_ins_from_lidar = rigid_from_six({0.01 * number, 0, 1, 0, 0, 0});
  return snapshot;
}

/// Which state a file holds; throws where it is damaged.
int state_in(const QString& path) {
  const project::Project project = project::load_project(path.toStdString());
  return static_cast<int>(std::lround(100.0 * project.nominal_ins_from_lidar.value().translation().x()));
}

/// Steady time that a test sets.
struct Minutes {
  std::shared_ptr<int> minute = std::make_shared<int>(0);
  std::chrono::steady_clock::time_point operator()() const {
    return std::chrono::steady_clock::time_point(std::chrono::minutes(*minute));
  }
};

/// As Autosave does after an edit.
void keep(gui::RecoveryNotes& notes, const QString& project, int number) {
  const QString path = notes.next_path(project);
  gui::write_snapshot(state(number), path);
  gui::write_note(notes.folder(), path, {project, {"/data/drive1"}, 0, 0, {}});
  notes.adopt(path);
}

class recovery_faults : public ::testing::Test {
 protected:
  static constexpr int kBefore = 3;  // states that are safe before anything fails

  void SetUp() override {
    if (const std::string why = testing::why_tracing_is_impossible(); !why.empty()) GTEST_SKIP() << why;
  }
  /// A window that keeps `kBefore` states a minute apart, and then one more while `fault` happens, and ends.
  TracedRun window_with(const Fault& fault) {
    jobs_.removeRecursively();
    QDir().mkpath(data_);
    const Minutes clock;
    return testing::run_traced(
        folder_.path(),
        [&] {
          gui::RecoveryNotes notes(data_, clock);
          for (*clock.minute = 0; *clock.minute < 2 * kBefore; *clock.minute += 2)
            keep(notes, project_, *clock.minute / 2);
          testing::begin_faults();
          return attempt([&] { keep(notes, project_, kBefore); });
        },
        fault);
  }
  static std::string attempt(const std::function<void()>& action) {
    try {
      action();
    } catch (const std::exception& error) {
      return error.what();
    }
    return {};
  }
  /// Whatever happened: the next start offers whole states, newest first, none older than what was safe.
  void expect_recoverable(const std::string& what, bool must_be_new) {
    const auto offers = gui::find_recoveries(data_);
    ASSERT_EQ(offers.size(), 1U) << what;
    int last = kBefore + 1;
    for (const gui::AutosaveGeneration& generation : offers[0].generations) {
      const int found = state_in(generation.path);  // throws where it is not whole
      EXPECT_LT(found, last) << what;
      last = found;
    }
    const int newest = state_in(offers[0].generations.front().path);
    EXPECT_TRUE(newest == kBefore || (newest == kBefore - 1 && !must_be_new)) << newest << "\n" << what;
  }

  testing::QuickFolder folder_;
  QDir jobs_{QString::fromStdString((folder_.path() / "jobs").string())};
  QString data_ = jobs_.filePath("data"), project_;
};

TEST_F(recovery_faults, any_system_call_of_an_autosave_may_fail) {
  for (const char* name : {"", "job.remount"}) {
    project_ = *name == 0 ? QString() : jobs_.filePath(name);
    for (const int error : testing::kErrors) {
      const std::size_t calls = testing::for_every_call(
          {0, Fault::Kind::Error, error}, [&](const Fault& fault) { return window_with(fault); },
          [&](const TracedRun& run, const Fault& fault) {
            expect_recoverable(testing::told(run, fault), run.exit_code == 0);
            if (run.exit_code == 0) return;
            EXPECT_NE(error, EINTR) << "is tried again\n" << testing::told(run, fault);
            EXPECT_NE(run.said.find(std::strerror(error)), std::string::npos) << testing::told(run, fault);
          });
      EXPECT_GT(calls, 10U) << name;
      RecordProperty("calls", static_cast<int>(calls));
    }
  }
}

TEST_F(recovery_faults, a_process_killed_at_any_system_call_of_an_autosave_leaves_whole_generations) {
  std::mt19937 dice(20);
  project_ = jobs_.filePath("job.remount");
  const std::size_t calls = window_with({}).calls.size();
  ASSERT_GT(calls, 0U);
  for (int i = 0; i < kKills / 2 && !HasFailure(); ++i) {
    const Fault fault{1 + dice() % calls, dice() % 2 == 0 ? Fault::Kind::KillBefore : Fault::Kind::KillAfter, 0};
    const TracedRun run = window_with(fault);
    EXPECT_EQ(run.exit_code, 128 + SIGKILL);
    expect_recoverable(testing::told(run, fault), false);
  }
}

TEST_F(recovery_faults, a_process_killed_at_any_moment_leaves_whole_generations) {
  const Minutes clock;
  std::shared_ptr<gui::RecoveryNotes> notes;  // of the child
  const auto work = [&](int number) {
    if (!notes) notes = std::make_shared<gui::RecoveryNotes>(data_, clock);
    *clock.minute = 2 * number;
    keep(*notes, {}, number);
  };
  const auto longest_life_us = 2 * static_cast<unsigned>(testing::life_of_two_runs_us(work, 3000));
  std::mt19937 dice(20);
  int kept = 0;
  for (int i = 0; i < kKills / 2 && !HasFailure(); ++i) {
    jobs_.removeRecursively();
    QDir().mkpath(data_);
    const int runs = testing::run_and_kill(work, static_cast<int>(dice() % longest_life_us));
    kept += runs;
    const auto offers = gui::find_recoveries(data_);
    EXPECT_TRUE(offers.size() == 1 || runs == 0) << "killed after " << runs;
    for (const gui::RecoveryOffer& offer : offers) {
      int number = state_in(offer.generations.front().path);
      EXPECT_TRUE(number == runs || number == runs - 1) << number << " of " << runs;
      for (const gui::AutosaveGeneration& generation : offer.generations)
        EXPECT_EQ(state_in(generation.path), number--);
    }
  }
  EXPECT_GT(kept, kKills / 2) << "no process came far";
}

/// Time of the wall as a file has it.
void set_time(const QString& path, qint64 seconds) {
  const timespec times[2] = {{seconds, 0}, {seconds, 0}};
  ASSERT_EQ(::utimensat(AT_FDCWD, path.toUtf8().constData(), times, 0), 0);
}

TEST(recovery_clock, that_is_set_back_changes_neither_order_nor_number_of_generations) {
  const QTemporaryDir folder;
  const Minutes clock;
  {
    gui::RecoveryNotes notes(folder.path(), clock);
    for (int number = 0; number < 8; ++number) {
      *clock.minute = 2 * number;
      keep(notes, {}, number);
      // Each state is older than the one before, by the clock of the wall.
      set_time(notes.next_path_in_notes(), 1700000000 - 86400 * number);
    }
    keep(notes, {}, 8);  // within the minute
  }
  const auto offers = gui::find_recoveries(folder.path());
  ASSERT_EQ(offers.size(), 1U);
  const auto& generations = offers[0].generations;
  ASSERT_EQ(generations.size(), static_cast<std::size_t>(gui::RecoveryNotes::kGenerations));
  EXPECT_EQ(state_in(generations.front().path), 8);
  for (std::size_t i = 1; i < generations.size(); ++i)
    EXPECT_EQ(state_in(generations[i].path), 7 - static_cast<int>(i)) << "generation " << i;
}

TEST(recovery_clock, that_was_set_back_makes_no_age_of_what_is_in_the_future) {
  const QDateTime now = QDateTime::fromSecsSinceEpoch(1700000000);
  EXPECT_EQ(gui::age_text(now.addSecs(30), now), "less than a minute ago");
  const QString future = gui::age_text(now.addDays(2), now);
  EXPECT_EQ(future, QLocale().toString(now.addDays(2).toLocalTime(), QLocale::ShortFormat));
}

TEST(recovery_names, that_leave_no_room_for_autosaves_are_kept_elsewhere) {
  const QTemporaryDir folder;
  gui::RecoveryNotes notes(folder.filePath("data"));
  for (const QString& letter : {QStringLiteral("x"), QStringLiteral("标")}) {
    const QString name = letter.repeated(247 / static_cast<int>(letter.toUtf8().size())) + ".remount";
    ASSERT_LE(name.toUtf8().size(), 255);
    const QString project = folder.filePath(name);
    gui::write_snapshot(state(1), project);
    EXPECT_EQ(state_in(project), 1) << "the name itself is not too long";
    const QString kept = notes.next_path(project);
    EXPECT_TRUE(kept.startsWith(notes.folder())) << kept.toStdString();
    gui::write_snapshot(state(2), kept);
    EXPECT_EQ(state_in(kept), 2);
  }
}

}  // namespace
}  // namespace remount::widgets
