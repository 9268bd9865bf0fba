// A table that no reader knows, made a session in the window.
#include <QDoubleSpinBox>
#include <QWheelEvent>

#include "tests/widgets/support/import_page.h"
#include "widgets/basics/theme.h"
#include "widgets/import/found_files_tree.h"
#include "widgets/shell/message_banner.h"

namespace remount::widgets {
namespace {

using guesses::ColumnRole;
using testing::kPatience_ms;
using import_page = testing::ImportPage;

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

TEST_F(import_page, is_offered_for_a_log_of_the_ins_that_is_opened_alone) {
  auto& banner = child<MessageBanner>();
  window_.open_paths({folder_.filePath("ins.log")});
  ASSERT_TRUE(QTest::qWaitFor([&] { return banner.isVisible(); }, kPatience_ms));
  EXPECT_TRUE(button(banner, "Import a table…").isVisible());
}

TEST_F(import_page, is_not_offered_for_a_capture_that_is_opened_alone) {
  auto& banner = child<MessageBanner>();
  window_.open_paths({folder_.filePath("lidar.pcap")});
  ASSERT_TRUE(QTest::qWaitFor([&] { return banner.isVisible(); }, kPatience_ms));
  EXPECT_EQ(offers_in(banner, "Import a table…"), 0);
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
  EXPECT_TRUE(texts_of(page()->conventions()).contains("a column is missing"))
      << texts_of(page()->conventions()).toStdString();
  EXPECT_FALSE(button(*page(), "Save and open").isEnabled());
  button(*page(), "As guessed").click();
  ASSERT_TRUE(checked());
  EXPECT_TRUE(page()->checks().text().contains("501 of 501 rows"));
  EXPECT_TRUE(button(*page(), "Save and open").isEnabled());
}

TEST_F(import_page, an_advised_difference_of_the_clocks_is_one_click) {
  testing::write_import_data(folder_.path(), 3600);
  open_page();
  EXPECT_TRUE(page()->checks().text().contains("-3600 s were added to the times of the INS"))
      << page()->checks().text().toStdString();
  button(page()->checks(), "Add -3600 s").click();
  EXPECT_EQ(page()->choice().choices.offset_ns, -3'600'000'000'000);
  ASSERT_TRUE(checked());
  EXPECT_TRUE(page()->checks().text().contains("4 of 4 scans lie within")) << page()->checks().text().toStdString();
  EXPECT_TRUE(page()->checks().findChildren<QPushButton*>().isEmpty());
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
