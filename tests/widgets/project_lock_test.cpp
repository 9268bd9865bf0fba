// Two windows on one project: who has it, and what the other can do.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QFile>
#include <QMessageBox>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <fstream>

#include "app/gui/features/all_features.h"
#include "app/gui/shell/main_window.h"
#include "app/gui/workbench/wording.h"
#include "tests/widgets/support/sample_world.h"
#include "tests/widgets/support/window_fixture.h"

namespace remount::widgets {
namespace {

using testing::kPatience_ms;

/// A window on the sample world, with what it said to the user.
struct Window {
  Window() : workbench(testing::sample_engine()), window(workbench, gui::all_features()) {
    QObject::connect(
        &workbench.notices(), &gui::Notices::message,
        [this](drive::Severity, const QString& where, const QString& what) { said << where + ": " + what; });
  }
  bool settle() {
    return QTest::qWaitFor([&] { return !workbench.activity().opening() && !workbench.activity().calibrating(); },
                           kPatience_ms);
  }
  bool save(const QString& path) {
    bool saved = false;
    const qsizetype before = said.size();
    workbench.document().save(path, [&] { saved = true; });
    return QTest::qWaitFor([&] { return said.size() > before; }, kPatience_ms) && saved;
  }
  /// The question how to go on; null where none is asked.
  QMessageBox* question() const { return window.findChild<QMessageBox*>("held-project"); }
  void open(const QString& path) {
    window.open_paths({path});
    ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench.activity().opening(); }, kPatience_ms));
  }
  void answer(const QString& text) {
    ASSERT_TRUE(question());
    for (QAbstractButton* button : question()->buttons())
      if (QString(button->text()).remove('&') == text) {
        button->click();
        ASSERT_TRUE(settle());
        QTest::qWait(0);
        return;
      }
    FAIL() << "no button " << text.toStdString();
  }
  bool offers(const QString& text) const {
    for (const QAbstractButton* button : question()->buttons())
      if (QString(button->text()).remove('&') == text) return true;
    return false;
  }

  gui::Workbench workbench;
  gui::MainWindow window;
  QStringList said;
};

class project_lock : public ::testing::Test {
 protected:
  void SetUp() override {
    Window maker;
    maker.open("/data/drive1");
    ASSERT_TRUE(maker.save(project_));
  }
  QString lock_file() const { return QString::fromStdString(project::lock_path_of(project_.toStdString()).string()); }
  void write_lock(const project::LockHolder& holder) const {
    std::ofstream(lock_file().toStdString())
        << "format: remount-lock/1\nuser: " << holder.user << "\nhost: " << holder.host
        << "\nprocess: " << holder.process << "\nsince_s: " << holder.since_s << "\nmachine: \"" << holder.machine
        << "\"\nboot: \"" << holder.boot << "\"\n";
  }

  QTemporaryDir folder_;
  QString project_ = folder_.filePath("job.remount");
  project::LockHolder bob_{"bob", "ws7", "another-machine", "its-boot", 4711, 1795377600};
};

TEST_F(project_lock, goes_with_its_window_and_leaves_nothing) {
  EXPECT_FALSE(QFile::exists(lock_file())) << "its maker is gone";
  Window first;
  first.open(project_);
  EXPECT_EQ(first.workbench.document().path(), project_);
  EXPECT_TRUE(QFile::exists(lock_file()));
  EXPECT_FALSE(first.question());
  first.open(project_);  // again, in the window that has it
  EXPECT_FALSE(first.question());
  ASSERT_TRUE(first.save(folder_.filePath("other.remount")));
  EXPECT_TRUE(QTest::qWaitFor([&] { return !QFile::exists(lock_file()); }, kPatience_ms))
      << "given back with the project";
}

TEST_F(project_lock, names_its_holder_to_the_second_window_which_opens_read_only) {
  Window first, second;
  first.open(project_);
  second.open(project_);
  ASSERT_TRUE(second.question());
  const QString text = second.question()->text();
  const project::LockHolder self = project::this_holder();
  for (const QString& part :
       {project_, QString::fromStdString(self.user), QString::fromStdString(self.host), QString::number(self.process)})
    EXPECT_TRUE(text.contains(part)) << part.toStdString() << " is not in: " << text.toStdString();
  EXPECT_FALSE(second.offers("Take over")) << "the holder lives, on this computer";
  EXPECT_TRUE(second.workbench.sessions().all().empty()) << "nothing is opened before it is answered";
  if (const QString pictures = qEnvironmentVariable("REMOUNT_SCREENSHOT_DIR"); !pictures.isEmpty())
    second.question()->grab().save(QDir(pictures).filePath("16-held.png"));
  second.answer("Open read-only");
  EXPECT_EQ(second.workbench.sessions().all().size(), 1U);
  EXPECT_TRUE(second.workbench.document().read_only());
  EXPECT_TRUE(second.window.windowTitle().contains("read-only")) << second.window.windowTitle().toStdString();
  second.workbench.setup().edit_nominal(rigid_from_six({1, 0, 1, 0, 0, 0}));
  EXPECT_FALSE(second.save(project_)) << "the first window has it";
  EXPECT_TRUE(second.said.last().contains(QString::fromStdString(self.host))) << second.said.last().toStdString();
  EXPECT_FALSE(project::load_project(project_.toStdString()).nominal_ins_from_lidar) << "the file is as it was";
  EXPECT_TRUE(second.save(folder_.filePath("mine.remount"))) << second.said.last().toStdString();
  EXPECT_FALSE(second.workbench.document().read_only());
  EXPECT_FALSE(first.workbench.document().read_only());
  EXPECT_TRUE(first.save(project_));
}

TEST_F(project_lock, is_not_in_the_way_of_a_save_that_was_asked_for_during_the_first_one) {
  Window window;
  window.open("/data/drive1");
  int saved = 0;
  const qsizetype before = window.said.size();
  for (int i = 0; i < 2; ++i) window.workbench.document().save(folder_.filePath("new.remount"), [&] { ++saved; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.said.size() >= before + 2; }, kPatience_ms));
  EXPECT_EQ(saved, 2) << window.said.join("\n").toStdString();
}

TEST_F(project_lock, lets_the_second_window_open_a_copy) {
  Window first, second;
  first.open(project_);
  second.open(project_);
  second.answer("Open a copy");
  EXPECT_EQ(second.workbench.sessions().all().size(), 1U);
  EXPECT_EQ(second.workbench.document().path(), "");
  EXPECT_FALSE(second.workbench.document().read_only());
  EXPECT_TRUE(second.workbench.document().has_unsaved_work()) << "it has no file";
}

TEST_F(project_lock, of_a_window_that_is_gone_blocks_nobody) {
  project::LockHolder crashed = project::this_holder();
  crashed.boot = "an earlier start";
  write_lock(crashed);
  Window window;
  window.open(project_);
  EXPECT_FALSE(window.question());
  EXPECT_EQ(window.workbench.document().path(), project_);
  EXPECT_FALSE(window.workbench.document().read_only());
}

TEST_F(project_lock, of_another_computer_can_be_taken_over) {
  write_lock(bob_);
  Window window;
  window.open(project_);
  ASSERT_TRUE(window.question());
  EXPECT_TRUE(window.question()->text().contains("bob")) << window.question()->text().toStdString();
  EXPECT_TRUE(window.question()->text().contains("ws7"));
  window.answer("Take over");
  EXPECT_EQ(window.workbench.document().path(), project_);
  EXPECT_TRUE(window.save(project_)) << window.said.join("\n").toStdString();
}

TEST_F(project_lock, that_is_taken_over_makes_its_window_read_only_and_says_by_whom) {
  Window window;
  window.open(project_);
  QFile::remove(lock_file());
  write_lock(bob_);
  EXPECT_FALSE(window.save(project_)) << "bob works on it now";
  EXPECT_TRUE(window.said.last().contains("bob")) << window.said.last().toStdString();
  QSignalSpy lost(&window.workbench.document(), &gui::ProjectDocument::lost);
  window.workbench.document().show_life();
  ASSERT_TRUE(lost.count() > 0 || lost.wait(kPatience_ms));
  EXPECT_TRUE(window.workbench.document().read_only());
  EXPECT_TRUE(window.said.last().contains("bob on ws7")) << window.said.last().toStdString();
  EXPECT_TRUE(QFile::exists(lock_file())) << "it is bob's";
}

TEST_F(project_lock, that_cannot_be_made_does_not_keep_from_work) {
  ASSERT_TRUE(QDir().mkpath(lock_file() + "/in the way"));
  Window window;
  window.open(project_);
  EXPECT_FALSE(window.question());
  EXPECT_EQ(window.workbench.document().path(), project_);
  EXPECT_TRUE(window.save(project_)) << window.said.join("\n").toStdString();
}

TEST_F(project_lock, is_one_for_all_names_of_a_project) {
  ASSERT_TRUE(QFile::link(project_, folder_.filePath("link.remount")));
  Window first, second;
  first.open(project_);
  second.open(folder_.filePath("link.remount"));
  EXPECT_TRUE(second.question());
  for (const QString& name : {QString("x").repeated(247) + ".remount", QStringLiteral("标定项目 – größer.remount")}) {
    const QString path = folder_.filePath(name);
    ASSERT_TRUE(first.save(path)) << first.said.last().toStdString();
    Window third;
    third.open(path);
    EXPECT_TRUE(third.question()) << name.toStdString();
  }
}

}  // namespace
}  // namespace remount::widgets
