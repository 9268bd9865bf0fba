// Project files: sessions that were moved, work opened in part, saves in turn, recent paths.
#include "app/gui/document/project_keeper.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QMenu>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <fstream>

#include "algorithms/core/error.h"
#include "app/gui/features/all_features.h"
#include "app/gui/features/project_feature.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/project/recovery_dialog.h"
#include "widgets/sessions/missing_sessions_dialog.h"

namespace remount::widgets {
namespace {

using testing::kPatience_ms;

/// Sessions that exist only where a folder of that name does.
gui::Engine engine_of_folders() {
  gui::Engine engine = testing::sample_engine();
  engine.open = [](const std::filesystem::path& path, const drive::TopicChoice&, Progress&) {
    if (!std::filesystem::exists(path)) throw Error(ErrorCode::Io, path.string(), Message::verbatim("is not there"));
    drive::Session session = testing::sample_session(path.filename().string());
    session.path = path;
    return session;
  };
  return engine;
}

TEST(moved_sessions, are_asked_for_once_and_remembered) {
  const QTemporaryDir folder;
  QDir root(folder.path());
  root.mkpath("old/drive1");
  root.mkpath("old/drive2");
  const QString project = root.filePath("job.remount");
  gui::Workbench workbench(engine_of_folders());
  gui::MainWindow window(workbench, gui::all_features());
  const auto settled = [&] {
    return QTest::qWaitFor([&] { return !workbench.activity().opening() && !workbench.activity().calibrating(); },
                           kPatience_ms);
  };
  window.open_paths({root.filePath("old/drive1"), root.filePath("old/drive2")});
  ASSERT_TRUE(settled());
  workbench.calibrations().calibrate();
  ASSERT_TRUE(settled());
  workbench.document().save(project);
  ASSERT_TRUE(QTest::qWaitFor([&] { return workbench.document().path() == project; }, kPatience_ms));
  ASSERT_TRUE(root.rename("old", "new"));

  workbench.document().open(project);
  ASSERT_TRUE(settled());
  auto* dialog = window.findChild<MissingSessionsDialog*>();
  ASSERT_TRUE(dialog) << "it asks where they are";
  EXPECT_TRUE(workbench.outcome().output()) << "nothing is replaced while it is not known";
  if (const QString pictures = qEnvironmentVariable("REMOUNT_SCREENSHOT_DIR"); !pictures.isEmpty())
    dialog->grab().save(QDir(pictures).filePath("15-missing.png"));
  dialog->show_found(0, root.filePath("new/drive1"));
  dialog->show_found(1, QString::fromStdString(project::relocate(root.filePath("old/drive2").toStdString(),
                                                                 root.filePath("old/drive1").toStdString(),
                                                                 root.filePath("new/drive1").toStdString())
                                                   .string()));
  emit dialog->open_requested(false);
  ASSERT_TRUE(settled());
  ASSERT_EQ(workbench.sessions().all().size(), 2U);
  EXPECT_EQ(QString::fromStdString(workbench.sessions().all()[1]->path.string()), root.filePath("new/drive2"));
  EXPECT_TRUE(workbench.outcome().output()) << "the calibration belongs to the sessions, wherever they lie";
  EXPECT_TRUE(workbench.document().unsaved()) << "the new place is to be saved";
  bool saved = false;
  workbench.document().save(project, [&] { saved = true; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return saved; }, kPatience_ms));
  EXPECT_EQ(project::load_project(project.toStdString()).sessions.at(1), root.filePath("new/drive2").toStdString());
}

TEST(moved_sessions, left_out_they_do_not_cost_the_file) {
  const QTemporaryDir folder;
  QDir root(folder.path());
  root.mkpath("drive1");
  root.mkpath("drive2");
  const QString project = root.filePath("job.remount");
  gui::Workbench workbench(engine_of_folders());
  gui::MainWindow window(workbench, gui::all_features());
  const auto settled = [&] { return QTest::qWaitFor([&] { return !workbench.activity().opening(); }, kPatience_ms); };
  window.open_paths({root.filePath("drive1"), root.filePath("drive2")});
  ASSERT_TRUE(settled());
  workbench.document().save(project);
  ASSERT_TRUE(QTest::qWaitFor([&] { return workbench.document().path() == project; }, kPatience_ms));
  QDir(root.filePath("drive2")).removeRecursively();
  workbench.document().open(project);
  ASSERT_TRUE(settled());
  auto* dialog = window.findChild<MissingSessionsDialog*>();
  ASSERT_TRUE(dialog);
  emit dialog->open_requested(true);
  ASSERT_TRUE(settled());
  EXPECT_EQ(workbench.sessions().all().size(), 1U);
  EXPECT_EQ(workbench.document().path(), "") << "saving must ask for a name: the file still knows both sessions";
  EXPECT_EQ(project::load_project(project.toStdString()).sessions.size(), 2U);
}

TEST(recovery_in_part, keeps_what_holds_the_rest) {
  const QTemporaryDir folder;
  QDir root(folder.path());
  root.mkpath("drive1");
  root.mkpath("drive2");
  const auto safe = [](gui::Workbench& workbench, gui::MainWindow& window) {
    return QTest::qWaitFor(
        [&, autosave = window.findChild<gui::ProjectKeeper*>()->autosave()] {
          return !workbench.activity().opening() && !autosave->writing() &&
                 autosave->saved_revision() == workbench.document().revision();
        },
        kPatience_ms);
  };
  {  // ends without being closed
    gui::Workbench workbench(engine_of_folders());
    gui::MainWindow window(workbench, gui::all_features());
    window.feature<gui::ProjectFeature>()->keep_work_in(root.filePath("data"));
    window.open_paths({root.filePath("drive1"), root.filePath("drive2")});
    ASSERT_TRUE(QTest::qWaitFor([&] { return workbench.sessions().all().size() == 2; }, kPatience_ms));
    ASSERT_TRUE(safe(workbench, window));
  }
  ASSERT_TRUE(root.rename("drive2", "away"));
  gui::Workbench workbench(engine_of_folders());
  gui::MainWindow window(workbench, gui::all_features());
  window.feature<gui::ProjectFeature>()->keep_work_in(root.filePath("data"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.findChild<RecoveryDialog*>() != nullptr; }, kPatience_ms));
  auto* offers = window.findChild<RecoveryDialog*>();
  emit offers->restore_requested(0, 0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.findChild<MissingSessionsDialog*>() != nullptr; }, kPatience_ms));
  emit window.findChild<MissingSessionsDialog*>()->open_requested(true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return workbench.sessions().all().size() == 1; }, kPatience_ms));
  EXPECT_TRUE(workbench.document().has_unsaved_work()) << "what was recovered is asked about before it is closed";
  workbench.setup().edit_nominal(rigid_from_six({1, 0, 1, 0, 0, 0}));
  ASSERT_TRUE(safe(workbench, window));
  EXPECT_EQ(gui::find_recoveries(root.filePath("data")).size(), 1U) << "what has both sessions is still offered";
}

TEST(autosave, that_is_being_written_when_the_work_is_given_up_leaves_nothing) {
  const QTemporaryDir folder;
  gui::Workbench workbench(testing::sample_engine());
  for (int i = 0; i < 20; ++i) {
    gui::Autosave autosave(workbench, folder.path());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !autosave.writing(); }, kPatience_ms));
    workbench.setup().edit_nominal(rigid_from_six({1.0 + i, 0, 1, 0, 0, 0}));
    ASSERT_TRUE(QTest::qWaitFor([&] { return autosave.writing(); }, kPatience_ms));
    autosave.finish();
  }
  EXPECT_TRUE(gui::find_recoveries(folder.path()).empty());
}

TEST(autosave, that_is_given_up_before_it_began_leaves_nothing) {
  const QTemporaryDir folder;
  gui::Workbench workbench(testing::sample_engine());
  {
    gui::Autosave autosave(workbench, folder.path());
    autosave.finish();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !autosave.writing(); }, kPatience_ms));
    workbench.setup().edit_nominal(rigid_from_six({1, 0, 1, 0, 0, 0}));
    EXPECT_FALSE(autosave.writing());
  }
  EXPECT_TRUE(gui::find_recoveries(folder.path()).empty());
}

TEST(autosave, says_so_where_its_folder_cannot_be_made) {
  const QTemporaryDir folder;
  std::ofstream(folder.filePath("recovery").toStdString()) << "a file where the folder should be";
  gui::Workbench workbench(testing::sample_engine());
  gui::Autosave autosave(workbench, folder.path());
  QSignalSpy failed(&autosave, &gui::Autosave::failed);
  EXPECT_TRUE(failed.wait(kPatience_ms)) << "the user is told";
}

TEST(saving, several_times_leaves_the_newest_and_does_not_name_another_project) {
  const QTemporaryDir folder;
  QDir root(folder.path());
  root.mkpath("drive1");
  const QString first = root.filePath("first.remount"), second = root.filePath("second.remount");
  gui::Workbench workbench(engine_of_folders());
  workbench.sessions().open({root.filePath("drive1")});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench.activity().opening(); }, kPatience_ms));
  workbench.document().save(second);
  ASSERT_TRUE(QTest::qWaitFor([&] { return workbench.document().path() == second; }, kPatience_ms));
  constexpr int kSaves = 30;
  QSignalSpy saved(&workbench.document(), &gui::ProjectDocument::saved);
  for (int i = 1; i <= kSaves; ++i) {
    workbench.setup().edit_nominal(rigid_from_six({0.1 * i, 0, 1, 0, 0, 0}));
    workbench.document().save(first);
  }
  workbench.document().open(second);
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return saved.count() == kSaves && !workbench.activity().opening(); }, kPatience_ms));
  EXPECT_EQ(workbench.document().path(), second);
  EXPECT_FALSE(workbench.document().unsaved());
  const auto nominal = project::load_project(first.toStdString()).nominal_ins_from_lidar;
  ASSERT_TRUE(nominal);
  EXPECT_NEAR(nominal->translation().x(), 0.1 * kSaves, 1e-12);
}

TEST(recent_paths, are_offered_newest_first_without_repeats) {
  gui::Workbench workbench(testing::sample_engine());
  gui::MainWindow window(workbench, gui::all_features());
  for (const char* name : {"/data/drive1", "/data/drive2"}) {
    window.open_paths({name});
    ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench.activity().opening(); }, kPatience_ms));
  }
  QMenu menu;
  auto& keeper = *window.findChild<gui::ProjectKeeper*>();
  keeper.fill_recent_menu(menu);
  ASSERT_GE(menu.actions().size(), 2);
  EXPECT_TRUE(menu.actions().at(0)->text().startsWith("drive2"));
  EXPECT_TRUE(menu.actions().at(1)->text().startsWith("drive1"));
  QSignalSpy asked(&keeper, &gui::ProjectKeeper::open_requested);
  menu.actions().at(1)->trigger();
  ASSERT_EQ(asked.count(), 1);
  EXPECT_EQ(asked.at(0).at(0).toStringList(), QStringList{"/data/drive1"});
}

}  // namespace
}  // namespace remount::widgets
