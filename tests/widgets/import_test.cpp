// A table that no reader knows, made a session in the window.
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>
#include <QWheelEvent>
#include <cmath>
#include <fstream>

#include "app/gui/features/import_feature.h"
#include "messages/sessions.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/basics/theme.h"
#include "widgets/import/check_list.h"
#include "widgets/import/column_table.h"
#include "widgets/import/convention_form.h"
#include "widgets/import/found_files_tree.h"
#include "widgets/import/import_dialog.h"
#include "widgets/shell/message_banner.h"

namespace remount::widgets {
namespace {

using guesses::ColumnRole;
using testing::kPatience_ms;
using testing::WindowFixture;

constexpr std::int64_t kFirst_ns = 1'700'000'000'000'000'000;

/// A table of a vehicle that drives an S on a level road, with x to the east, and a few scans beside it.
void write_import_data(const QString& folder) {
  const std::filesystem::path root = folder.toStdString();
  std::ofstream table(root / "motion.csv");
  table.precision(12);
  table << "t,x,y,z,roll,pitch,yaw\n";
  double x_m = 0.0, y_m = 0.0;
  for (int i = 0; i <= 500; ++i) {
    const double time_s = 0.04 * i, yaw_rad = 1.4 * std::sin(0.5 * time_s);
    table << 1'700'000'000.0 + time_s << ',' << x_m << ',' << y_m << ',' << 0.4 * std::sin(0.3 * time_s) << ",0.1,0.2,"
          << yaw_rad * 180.0 / M_PI << '\n';
    x_m += 0.32 * std::cos(yaw_rad), y_m += 0.32 * std::sin(yaw_rad);
  }
  std::filesystem::create_directories(root / "scans");
  for (int scan = 0; scan < 4; ++scan) {
    std::ofstream cloud(root / "scans" / (std::to_string(kFirst_ns + scan * 1'000'000'000LL) + ".pcd"));
    cloud << "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 40\nHEIGHT 1\nPOINTS 40\nDATA "
             "ascii\n";
    for (int point = 0; point < 40; ++point) cloud << point << ' ' << 0.5 * point << " 1\n";
  }
}

/// Folders of tables are no session, and manifests are one.
gui::Engine engine_of_manifests(std::shared_ptr<const std::atomic<int>> hold_at) {
  gui::Engine engine = testing::sample_engine(10, std::move(hold_at));
  engine.open = [](const std::filesystem::path& path, const drive::TopicChoice&, Progress&) {
    if (path.extension() != ".yaml") throw Error(ErrorCode::Unsupported, path.string(), say::session_unknown({}));
    drive::Session session = testing::sample_session("imported");
    session.path = path;
    return session;
  };
  return engine;
}

class import_page : public WindowFixture {
 protected:
  import_page() : WindowFixture(&engine_of_manifests) {}
  void SetUp() override {
    show();
    write_import_data(folder_.path());
  }
  void open_page() {
    feature().import(folder_.path());
    ASSERT_TRUE(page());
    ASSERT_TRUE(checked());
  }
  gui::ImportFeature& feature() { return *window_.feature<gui::ImportFeature>(); }
  ImportDialog* page() { return window_.findChild<ImportDialog*>(); }
  bool checked() {
    return QTest::qWaitFor(
        [&] { return page()->choice().table && page()->checks().isEnabled() && !page()->checks().text().isEmpty(); },
        kPatience_ms);
  }
  void choose(std::size_t column, ColumnRole role) {
    QComboBox* list = page()->columns().roles_of(column);
    list->setCurrentIndex(list->findData(static_cast<int>(role)));
    emit list->activated(list->currentIndex());
  }
  static QPushButton& button(QWidget& parent, const QString& text) {
    for (QPushButton* one : parent.findChildren<QPushButton*>())
      if (one->text().remove('&') == text) return *one;
    throw std::logic_error("no button " + text.toStdString());
  }
  QString manifest() const { return folder_.filePath("session.yaml"); }
  std::string text_of(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
  }
  /// Answers the next question.
  void answer(QMessageBox::StandardButton with) {
    QTimer::singleShot(100, this_, [this, with] {
      if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
        ++asked_;
        box->button(with)->click();
      }
    });
  }
  QTemporaryDir folder_;
  QObject owner_;
  QObject* this_ = &owner_;
  int asked_ = 0;
};

TEST_F(import_page, is_offered_where_nothing_is_known) {
  window_.open_paths({folder_.path()});
  auto& banner = child<MessageBanner>();
  ASSERT_TRUE(QTest::qWaitFor([&] { return banner.isVisible(); }, kPatience_ms));
  QPushButton& offer = button(banner, "Import a table…");
  EXPECT_TRUE(offer.isVisible());
  photograph(window_, "70-import-offered");
  offer.click();
  ASSERT_TRUE(page());
  EXPECT_FALSE(banner.isVisible());
  EXPECT_TRUE(checked());
  banner.show_message(drive::Severity::Problem, "elsewhere", "something else");
  EXPECT_FALSE(offer.isVisible()) << "it was about another message";
}

TEST_F(import_page, presets_what_was_guessed_and_says_why) {
  open_page();
  photograph(*page(), "71-import");
  EXPECT_EQ(page()->columns().roles_of(0)->currentText(), "time");
  EXPECT_EQ(page()->columns().roles_of(1)->currentText(), "east (x)");
  EXPECT_EQ(page()->columns().roles_of(6)->currentText(), "heading, yaw");
  EXPECT_TRUE(texts_of(page()->conventions()).contains("OPEN")) << texts_of(page()->conventions()).toStdString();
  EXPECT_TRUE(page()->checks().text().contains("501 of 501 rows")) << page()->checks().text().toStdString();
  EXPECT_TRUE(button(*page(), "Save and open").isEnabled());
  EXPECT_FALSE(button(*page(), "As guessed").isEnabled());
  EXPECT_LE(page()->minimumSizeHint().width(), 1366);
  EXPECT_LE(page()->minimumSizeHint().height(), 720);
}

TEST_F(import_page, a_changed_role_changes_the_checks_at_once) {
  open_page();
  EXPECT_FALSE(page()->checks().text().contains("does not follow the drive"));
  choose(1, ColumnRole::North);
  EXPECT_EQ(page()->columns().roles_of(2)->currentText(), "east (x)") << "the roles are exchanged";
  ASSERT_TRUE(checked());
  EXPECT_TRUE(page()->checks().text().contains("does not follow the drive")) << page()->checks().text().toStdString();
  photograph(*page(), "72-import-wrong");
  choose(0, ColumnRole::Ignored);
  ASSERT_TRUE(checked());
  EXPECT_TRUE(page()->checks().text().contains("Choose a column for: time")) << page()->checks().text().toStdString();
  EXPECT_FALSE(button(*page(), "Save and open").isEnabled());
  button(*page(), "As guessed").click();
  ASSERT_TRUE(checked());
  EXPECT_TRUE(page()->checks().text().contains("501 of 501 rows"));
  EXPECT_TRUE(button(*page(), "Save and open").isEnabled());
}

TEST_F(import_page, scrolling_over_a_list_chooses_nothing) {
  open_page();
  const guesses::TableChoices before = page()->choice().choices;
  QWidgetList editors{page()->columns().roles_of(2)};
  for (QComboBox* list : page()->conventions().findChildren<QComboBox*>()) editors << list;
  editors << page()->conventions().findChild<QDoubleSpinBox*>();
  int scrolled = 0;
  for (QWidget* editor : editors) {
    if (!editor->isVisible()) continue;
    editor->setFocus();
    for (const int turn : {-120, 120, 120}) {
      const QPointF place = editor->rect().center();
      QWheelEvent wheel(place, editor->mapToGlobal(place), {}, {0, turn}, Qt::NoButton, Qt::NoModifier,
                        Qt::NoScrollPhase, false);
      QApplication::sendEvent(editor, &wheel);
      ++scrolled;
    }
  }
  EXPECT_GE(scrolled, 3 * 5);
  EXPECT_TRUE(page()->choice().choices == before);
  EXPECT_EQ(page()->columns().roles_of(2)->currentText(), "north (y)");
}

TEST_F(import_page, another_reading_that_fits_is_one_choice) {
  open_page();
  QComboBox* readings = nullptr;
  for (QComboBox* list : page()->conventions().findChildren<QComboBox*>())
    if (list->accessibleName() == "Other readings that fit" && list->isVisible()) readings = list;
  ASSERT_TRUE(readings);
  int row = 0;
  for (int i = 1; i < readings->count(); ++i)
    if (readings->itemText(i).startsWith("x: north (y), y: east (x)")) row = i;
  ASSERT_GT(row, 0) << readings->itemText(1).toStdString();
  emit readings->activated(row);
  ASSERT_TRUE(checked());
  EXPECT_EQ(page()->choice().choices.column(ColumnRole::East), 2U);
  EXPECT_FALSE(page()->checks().text().contains("does not follow the drive")) << page()->checks().text().toStdString();
}

TEST_F(import_page, dates_are_read_in_either_order_of_day_and_month) {
  std::ofstream table(folder_.filePath("motion.csv").toStdString());
  table << "date,x,y,z,roll,pitch,yaw\n";
  for (int i = 0; i < 200; ++i) {
    const double angle_rad = 0.02 * i;
    table << "11/12/2023 10:00:" << (i < 100 ? "0" : "") << 0.1 * i << ',' << 40.0 * std::cos(angle_rad) << ','
          << 40.0 * std::sin(angle_rad) << ",0,0,0," << (angle_rad * 180.0 / M_PI + 90.0) << '\n';
  }
  table.close();
  open_page();
  EXPECT_TRUE(page()->checks().text().contains("200 of 200 rows")) << page()->checks().text().toStdString();
  QComboBox* order = nullptr;
  for (QComboBox* list : page()->conventions().findChildren<QComboBox*>())
    if (list->isVisible() && list->findText("month, day, year") >= 0 && list->count() == 3) order = list;
  ASSERT_TRUE(order) << "nobody can say which is the day";
  EXPECT_EQ(order->currentText(), "day, month, year");
  EXPECT_TRUE(texts_of(page()->conventions()).contains("dates are written as day, month, year"))
      << texts_of(page()->conventions()).toStdString();
  order->setCurrentIndex(order->findText("month, day, year"));
  emit order->activated(order->currentIndex());
  ASSERT_TRUE(checked());
  EXPECT_TRUE(page()->checks().text().contains("200 of 200 rows")) << page()->checks().text().toStdString();
  EXPECT_EQ(page()->choice().choices.date_order, formats::DateOrder::MonthFirst);
}

TEST_F(import_page, saves_and_opens_and_replaces_nothing_without_asking) {
  open_page();
  button(*page(), "Save and open").click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench_.sessions().empty(); }, kPatience_ms));
  EXPECT_EQ(workbench_.sessions().all().front()->path, manifest().toStdString());
  const std::string first = text_of(manifest());
  EXPECT_NE(first.find("position: {east: x, north: y, up: z}"), std::string::npos) << first;
  ASSERT_TRUE(QTest::qWaitFor([&] { return !page(); }, kPatience_ms));

  open_page();
  choose(1, ColumnRole::North);
  ASSERT_TRUE(checked());
  feature().controller()->save(manifest());
  EXPECT_TRUE(texts_of(*page()).contains("is open. Close that session first")) << texts_of(*page()).toStdString();
  QTest::qWait(100);
  EXPECT_EQ(text_of(manifest()), first) << "the window would go on with the data of before";
  workbench_.history().stack().undo();
  ASSERT_TRUE(workbench_.sessions().empty());

  answer(QMessageBox::No);
  feature().controller()->save(manifest());
  EXPECT_EQ(asked_, 1);
  QTest::qWait(100);
  EXPECT_EQ(text_of(manifest()), first) << "nobody wanted it";
  answer(QMessageBox::Yes);
  feature().controller()->save(manifest());
  EXPECT_EQ(asked_, 2);
  ASSERT_TRUE(QTest::qWaitFor([&] { return text_of(manifest()) != first; }, kPatience_ms));
  EXPECT_NE(text_of(manifest()).find("east: y, north: x"), std::string::npos) << text_of(manifest());
  EXPECT_TRUE(page()) << "it stays open";
}

TEST_F(import_page, stays_until_it_has_saved_and_is_answered) {
  open_page();
  guesses::TableChoices changed = page()->choice().choices;
  changed.offset_ns = 5;
  button(*page(), "Save and open").click();
  EXPECT_FALSE(page()->isEnabled());
  page()->close();
  EXPECT_TRUE(page()->isVisible());
  EXPECT_FALSE(window_.close());
  EXPECT_TRUE(window_.isVisible());
  page()->choose(changed);  // a save goes on all the same
  ASSERT_TRUE(QTest::qWaitFor([&] { return QFile::exists(manifest()) && !window_.isVisible(); }, kPatience_ms))
      << "it closes once that is saved";
}

TEST_F(import_page, stays_under_its_questions) {
  open_page();
  const QString path = folder_.filePath("other");
  feature().controller()->save(path);
  ASSERT_TRUE(QTest::qWaitFor([&] { return page()->isEnabled() && QFile::exists(path + ".yaml"); }, kPatience_ms));
  EXPECT_TRUE(texts_of(*page()).contains("Saved as")) << texts_of(*page()).toStdString();
  const QPointer<ImportDialog> before = page();
  bool stays = false;
  QTimer::singleShot(100, this_, [&] {
    page()->close();
    feature().import(folder_.path());
    stays = before && before->isVisible() && page() == before;
    if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget()))
      box->button(QMessageBox::No)->click();
  });
  feature().controller()->save(path);
  EXPECT_TRUE(stays);
  page()->close();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !page(); }, kPatience_ms));
}

TEST_F(import_page, replaces_no_good_manifest_by_one_without_the_ins_and_no_other_file) {
  open_page();
  const QString path = folder_.filePath("other.yaml");
  feature().controller()->save(path);
  ASSERT_TRUE(QTest::qWaitFor([&] { return page()->isEnabled(); }, kPatience_ms));
  const std::string good = text_of(path);
  EXPECT_NE(good.find("ins_poses:"), std::string::npos);
  choose(0, ColumnRole::Ignored);
  EXPECT_FALSE(button(*page(), "Save manifest…").isEnabled()) << "not before it is checked";
  ASSERT_TRUE(checked());
  EXPECT_FALSE(button(*page(), "Save manifest…").isEnabled());
  answer(QMessageBox::Yes);
  feature().controller()->save(path);
  ASSERT_TRUE(QTest::qWaitFor([&] { return page()->isEnabled(); }, kPatience_ms));
  EXPECT_EQ(text_of(path), good);
  EXPECT_TRUE(texts_of(*page()).contains("nothing was saved")) << texts_of(*page()).toStdString();

  button(*page(), "As guessed").click();
  ASSERT_TRUE(checked());
  const QString table = folder_.filePath("of_others.yml");
  std::ofstream(table.toStdString()) << "version: 2\n";
  answer(QMessageBox::Yes);
  feature().controller()->save(table);
  ASSERT_TRUE(QTest::qWaitFor([&] { return page()->isEnabled(); }, kPatience_ms));
  EXPECT_EQ(text_of(table), "version: 2\n");
  EXPECT_EQ(asked_, 2);
}

TEST_F(import_page, goes_on_where_a_table_cannot_be_read) {
  open_page();
  emit page()->table_requested(folder_.filePath("nowhere.csv"));
  EXPECT_FALSE(page()->checks().isEnabled());
  ASSERT_TRUE(checked());
  EXPECT_TRUE(texts_of(*page()).contains("nowhere.csv")) << texts_of(*page()).toStdString();
  EXPECT_TRUE(button(*page(), "Save and open").isEnabled());
  choose(1, ColumnRole::North);
  feature().controller()->save(manifest());  // while the check is still to come
  ASSERT_TRUE(QTest::qWaitFor([&] { return page()->isEnabled(); }, kPatience_ms));
  ASSERT_TRUE(checked());
  EXPECT_TRUE(page()->checks().text().contains("does not follow the drive")) << page()->checks().text().toStdString();
}

TEST_F(import_page, keeps_what_was_chosen_where_more_is_added) {
  open_page();
  choose(1, ColumnRole::North);
  ASSERT_TRUE(checked());
  const guesses::TableChoices chosen = page()->choice().choices;
  const QString scans = folder_.filePath("scans");
  feature().controller()->look_at({folder_.path(), scans}, {scans});
  ASSERT_TRUE(checked());
  EXPECT_TRUE(page()->choice().choices == chosen);
  feature().controller()->look_at({folder_.path(), folder_.filePath("nowhere/at-all")}, {});
  EXPECT_FALSE(page()->choice().table);
  ASSERT_TRUE(checked());
  EXPECT_TRUE(page()->choice().choices == chosen);
  EXPECT_TRUE(texts_of(*page()).contains("nowhere")) << texts_of(*page()).toStdString();
  QFile::copy(folder_.filePath("motion.csv"), folder_.filePath("second.csv"));
  feature().controller()->look_at({folder_.path()}, {scans, folder_.filePath("second.csv")});
  ASSERT_TRUE(checked());
  EXPECT_EQ(page()->choice().table->file.filename(), "second.csv");
}

TEST_F(import_page, says_that_poses_are_those_of_a_lidar) {
  QDir(folder_.filePath("scans")).removeRecursively();
  QFile::remove(folder_.filePath("motion.csv"));
  std::ofstream out(folder_.filePath("odometry.tum").toStdString());
  out.precision(16);
  for (int i = 0; i < 300; ++i)
    out << 1'700'000'000.0 + 0.1 * i << ' ' << 0.5 * i << ' ' << 3.0 * std::sin(0.1 * i) << " 0 " << std::sin(0.37 * i)
        << " 0 0 " << std::cos(0.37 * i) << "\n";
  out.close();
  feature().import(folder_.path());
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return texts_of(*page()).contains("No motion of the INS was found"); }, kPatience_ms));
  EXPECT_FALSE(page()->choice().table);
  auto& files = *page()->findChild<FoundFilesTree*>();
  QTreeWidgetItem* item = files.topLevelItem(0)->child(0);
  EXPECT_EQ(item->text(0), "○ odometry.tum\nposes of a LiDAR");
  emit files.itemClicked(item, 0);
  ASSERT_TRUE(checked());
  EXPECT_TRUE(texts_of(*page()).contains("odometry.tum was taken for the poses of a LiDAR"))
      << texts_of(*page()).toStdString();
  EXPECT_EQ(files.topLevelItem(1)->child(0)->checkState(0), Qt::Unchecked);
  photograph(*page(), "74-import-poses");
}

TEST_F(import_page, says_what_is_wrong_with_a_place_that_cannot_be_looked_at) {
  feature().import(folder_.filePath("nowhere/at-all"));
  ASSERT_TRUE(page());
  const auto looks = [&] { return texts_of(*page()).contains("Looking at"); };
  ASSERT_TRUE(QTest::qWaitFor([&] { return !looks(); }, kPatience_ms));
  EXPECT_TRUE(texts_of(*page()).contains("nowhere: cannot be opened")) << texts_of(*page()).toStdString();
  EXPECT_TRUE(texts_of(*page()).contains(severity_sign(drive::Severity::Problem)));
  EXPECT_FALSE(button(*page(), "Save manifest…").isEnabled());
}

}  // namespace
}  // namespace remount::widgets
