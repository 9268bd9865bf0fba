// Nothing is lost: autosave, a process that is killed, recovery.
#include <gtest/gtest.h>
#include <signal.h>

#include <QCoreApplication>
#include <QDirIterator>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <fstream>

#include "app/gui/document/project_keeper.h"
#include "app/gui/features/project_feature.h"
#include "tests/support/child_process.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/project/recovery_dialog.h"
#include "widgets/shell/message_banner.h"

namespace remount::widgets {
namespace {

using testing::kPatience_ms;

constexpr const char* kChildFolder = "REMOUNT_RECOVERY_CHILD";

/// A base, so that it outlives the window that keeps its work there.
struct DataFolder {
  QTemporaryDir folder_;
};

class recovery : protected DataFolder, public testing::WindowFixture {
 protected:
  gui::Autosave& autosave() { return *window_.findChild<gui::ProjectKeeper*>()->autosave(); }
  bool safe() {
    return QTest::qWaitFor(
        [&] { return !autosave().writing() && autosave().saved_revision() == workbench_.document().revision(); },
        kPatience_ms);
  }
  /// And until what is kept there has been looked at.
  void keep_work_in(const QString& folder) {
    window_.feature<gui::ProjectFeature>()->keep_work_in(folder);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !autosave().writing(); }, kPatience_ms));
  }
  QStringList files_in(const QString& folder, const QString& pattern) const {
    QStringList files;
    QDirIterator found(folder, {pattern}, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (found.hasNext()) files << found.next();
    return files;
  }
  /// Runs recovery_child in a process of its own until it says that it is ready, and kills it.
  void kill_a_process_that_decides(const QString& project);
};

/// Not a test by itself: what the process does that the tests below kill.
TEST_F(recovery, child_decides_and_waits_to_be_killed) {
  const QString data = qEnvironmentVariable(kChildFolder);
  if (data.isEmpty()) GTEST_SKIP() << "started by the other tests";
  keep_work_in(data);
  show();
  calibrate_drive();
  if (const QString project = qEnvironmentVariable("REMOUNT_RECOVERY_PROJECT"); !project.isEmpty()) {
    workbench_.document().save(project);
    ASSERT_TRUE(QTest::qWaitFor([&] { return workbench_.document().path() == project; }, kPatience_ms));
  }
  workbench_.setup().edit_nominal(rigid_from_six({1, 0, 1, 0, 0, 0}));
  workbench_.decisions().decide({motion::PairIndex{5}, motion::PairIndex{6}}, motion::PairState::Rejected);
  ASSERT_TRUE(settle());
  ASSERT_TRUE(safe());
  std::fputs("ready\n", stdout);
  std::fflush(stdout);
  QTest::qWait(60000);
}

void recovery::kill_a_process_that_decides(const QString& project) {
  testing::ChildProcess child(QCoreApplication::applicationFilePath().toStdString(),
                              {"--gtest_filter=recovery.child_decides_and_waits_to_be_killed"},
                              {{kChildFolder, folder_.path().toStdString()},
                               {"REMOUNT_RECOVERY_PROJECT", project.toStdString()},
                               {"QT_QPA_PLATFORM", "offscreen"}});
  ASSERT_TRUE(child.says("ready\n", kPatience_ms * 3)) << child.said();
  EXPECT_TRUE(gui::find_recoveries(folder_.path()).empty()) << "its window is open";
  child.kill();
  EXPECT_EQ(child.ended(kPatience_ms), 128 + SIGKILL) << child.said();
}

TEST_F(recovery, a_killed_process_loses_nothing_that_was_never_saved) {
  kill_a_process_that_decides({});
  if (HasFatalFailure()) return;
  show();
  keep_work_in(folder_.path());
  auto* dialog = window_.findChild<RecoveryDialog*>();
  ASSERT_TRUE(dialog) << "the next start offers it";
  QString text;
  for (const QLabel* label : dialog->findChildren<QLabel*>()) text += label->text();
  EXPECT_TRUE(text.contains("drive1") && text.contains("50 pair") && text.contains("2 decision")) << text.toStdString();
  photograph(*dialog, "14-recovery");
  emit dialog->restore_requested(0, 0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return workbench_.outcome().output() != nullptr; }, kPatience_ms));
  ASSERT_TRUE(settle());
  for (int index : {5, 6}) {
    EXPECT_EQ(pair(index).state, motion::PairState::Rejected);
    EXPECT_EQ(pair(index).decided_by, motion::DecidedBy::User);
  }
  EXPECT_EQ(workbench_.outcome().output()->pairs.size(), 50U);
  ASSERT_TRUE(workbench_.setup().nominal_ins_from_lidar());
  EXPECT_EQ(workbench_.setup().nominal_ins_from_lidar()->translation().x(), 1.0);
  EXPECT_TRUE(workbench_.document().has_unsaved_work()) << "it is not saved as a project yet";
  ASSERT_TRUE(safe());
  EXPECT_TRUE(gui::find_recoveries(folder_.path()).empty()) << "taken over by this window";
  EXPECT_EQ(files_in(folder_.path(), "*.autosave-*").size(), 1) << "this window's own";
}

TEST_F(recovery, a_killed_process_loses_no_edit_of_a_saved_project) {
  const QString project = folder_.filePath("job.remount");
  kill_a_process_that_decides(project);
  if (HasFatalFailure()) return;
  EXPECT_EQ(files_in(folder_.path(), "job.remount.autosave-*").size(), 1) << "beside the project";
  show();
  keep_work_in(folder_.path());
  auto* dialog = window_.findChild<RecoveryDialog*>();
  ASSERT_TRUE(dialog);
  emit dialog->restore_requested(0, 0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return workbench_.outcome().output() != nullptr; }, kPatience_ms));
  ASSERT_TRUE(settle());
  EXPECT_EQ(workbench_.document().path(), project) << "saving replaces the project, not the autosave";
  EXPECT_TRUE(workbench_.document().unsaved());
  EXPECT_EQ(pair(5).state, motion::PairState::Rejected);
  ASSERT_TRUE(safe());
  bool saved = false;
  workbench_.document().save(project, [&] { saved = true; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return saved; }, kPatience_ms));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !autosave().writing(); }, kPatience_ms));
  EXPECT_TRUE(files_in(folder_.path(), "*.autosave-*").isEmpty()) << "what is saved needs no autosave";
  EXPECT_TRUE(gui::find_recoveries(folder_.path()).empty());
}

TEST_F(recovery, what_is_discarded_is_not_offered_again) {
  kill_a_process_that_decides({});
  if (HasFatalFailure()) return;
  ASSERT_EQ(gui::find_recoveries(folder_.path()).size(), 1U);
  show();
  keep_work_in(folder_.path());
  auto* dialog = window_.findChild<RecoveryDialog*>();
  ASSERT_TRUE(dialog);
  for (auto* button : dialog->findChildren<QPushButton*>())
    if (button->text() == RecoveryDialog::tr("Discard")) button->click();
  EXPECT_FALSE(dialog->isVisible()) << "nothing is left to decide";
  EXPECT_TRUE(gui::find_recoveries(folder_.path()).empty());
  EXPECT_TRUE(files_in(folder_.path(), "*.autosave-*").isEmpty());
}

TEST_F(recovery, every_edit_is_on_disk_at_once) {
  keep_work_in(folder_.path());
  show();
  calibrate_drive();
  ASSERT_TRUE(safe());
  QSignalSpy saved(&autosave(), &gui::Autosave::saved);
  workbench_.decisions().decide({motion::PairIndex{5}}, motion::PairState::Rejected);
  ASSERT_TRUE(settle());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench_.solutions().refining(); }, kPatience_ms));
  ASSERT_TRUE(safe());
  ASSERT_FALSE(saved.isEmpty());
  const project::Project kept = project::load_project(saved.last().at(0).toString().toStdString());
  ASSERT_TRUE(kept.output);
  EXPECT_EQ(kept.output->pairs.at(5).decided_by, motion::DecidedBy::User);
  EXPECT_EQ(kept.output->result.mounting.reference_from_sensor.matrix(),
            workbench_.outcome().output()->result.mounting.reference_from_sensor.matrix());
  const auto before = saved.count();
  workbench_.setup().edit_option("registration", "voxel_m", 0.5);
  ASSERT_TRUE(safe());
  EXPECT_GT(saved.count(), before);
}

TEST_F(recovery, a_window_that_is_closed_leaves_nothing_behind) {
  keep_work_in(folder_.path());
  show();
  window_.open_paths({"/data/drive1"});
  ASSERT_TRUE(settle());
  ASSERT_TRUE(safe());
  EXPECT_EQ(files_in(folder_.path(), "*.autosave-*").size(), 1);
  EXPECT_TRUE(window_.close());
  EXPECT_TRUE(files_in(folder_.path(), "*.autosave-*").isEmpty());
}

TEST_F(recovery, a_folder_that_cannot_be_written_is_said_and_the_work_kept_elsewhere) {
  const QString project = folder_.filePath("gone/job.remount");
  QDir(folder_.path()).mkdir("gone");
  keep_work_in(folder_.path());
  show();
  calibrate_drive();
  workbench_.document().save(project);
  ASSERT_TRUE(QTest::qWaitFor([&] { return workbench_.document().path() == project; }, kPatience_ms));
  ASSERT_TRUE(settle());
  // A disk that was taken out. The hashes of the input may arrive after saving and be kept beside the project.
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return !autosave().writing() && QDir(folder_.filePath("gone")).removeRecursively(); }, kPatience_ms));
  workbench_.decisions().decide({motion::PairIndex{5}}, motion::PairState::Rejected);
  ASSERT_TRUE(settle());
  ASSERT_TRUE(safe());
  EXPECT_EQ(files_in(folder_.filePath("recovery"), "*.autosave-*").size(), 1);
  const QString said = child<MessageBanner>().findChild<QLabel*>()->text();
  EXPECT_TRUE(child<MessageBanner>().isVisible());
  EXPECT_TRUE(said.contains("gone") && said.contains(folder_.filePath("recovery")) && said.contains("disk"))
      << said.toStdString();
  // The disk is back, and the project saved: autosaves lie beside it again.
  QDir(folder_.path()).mkdir("gone");
  workbench_.document().save(project);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench_.document().unsaved() && !autosave().writing(); }, kPatience_ms));
  workbench_.decisions().decide({motion::PairIndex{6}}, motion::PairState::Rejected);
  ASSERT_TRUE(settle());
  ASSERT_TRUE(safe());
  EXPECT_EQ(files_in(folder_.filePath("gone"), "*.autosave-*").size(), 1);
}

TEST_F(recovery, what_is_edited_before_the_notes_are_there_is_kept_too) {
  show();
  window_.feature<gui::ProjectFeature>()->keep_work_in(folder_.path());
  EXPECT_TRUE(autosave().writing()) << "the disk is looked at in the background";
  workbench_.setup().edit_nominal(rigid_from_six({1, 0, 1, 0, 0, 0}));
  ASSERT_TRUE(safe());
  const QStringList kept = files_in(folder_.path(), "*.autosave-*");
  ASSERT_EQ(kept.size(), 1);
  EXPECT_TRUE(project::load_project(kept[0].toStdString()).nominal_ins_from_lidar);
}

TEST(recovery_notes, keep_several_generations) {
  const QTemporaryDir folder;
  gui::RecoveryNotes notes(folder.path());
  for (int i = 0; i < 4; ++i) {
    const QString path = notes.next_path_in_notes();
    std::ofstream(path.toStdString()) << "state " << i;
    gui::write_note(notes.folder(), path, {{}, {"/data/one"}, 3, 1, "ok"});
    notes.adopt(path);
  }
  const QDir own(notes.folder());
  EXPECT_EQ(own.entryList({"*.autosave-*"}).size(), 1) << "within a minute the newest is replaced";
}

TEST(recovery_notes, damaged_notes_are_offered_with_what_is_there) {
  const QTemporaryDir folder;
  const QDir gone(folder.filePath("recovery/some-window"));
  gone.mkpath(".");
  std::ofstream(gone.filePath("note.yaml").toStdString()) << "format: [";
  std::ofstream(gone.filePath("work.autosave-1").toStdString()) << "newest";
  std::ofstream(gone.filePath("work.autosave-2").toStdString()) << "older";
  const auto offers = gui::find_recoveries(folder.path());
  ASSERT_EQ(offers.size(), 1U);
  EXPECT_EQ(offers[0].generations.size(), 2U);
  gui::discard(offers[0]);
  EXPECT_TRUE(gui::find_recoveries(folder.path()).empty());
}

TEST(recovery_notes, ages_are_in_words) {
  const QDateTime now = QDateTime::fromSecsSinceEpoch(1700000000);
  EXPECT_EQ(gui::age_text(now.addSecs(-5), now), "less than a minute ago");
  EXPECT_TRUE(gui::age_text(now.addSecs(-200), now).startsWith("3 minute"));
  EXPECT_TRUE(gui::age_text(now.addSecs(-7300), now).startsWith("2 hour"));
}

}  // namespace
}  // namespace remount::widgets
