// What was said of a table is saved, opened and kept.
#include "tests/widgets/support/import_page.h"

namespace remount::widgets {
namespace {

using guesses::ColumnRole;
using testing::kPatience_ms;
using import_saving = testing::ImportPage;

TEST_F(import_saving, saves_and_opens_and_replaces_nothing_without_asking) {
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

TEST_F(import_saving, stays_until_it_has_saved_and_is_answered) {
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

TEST_F(import_saving, stays_under_its_questions) {
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

TEST_F(import_saving, replaces_no_good_manifest_by_one_without_the_ins_and_no_other_file) {
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

TEST_F(import_saving, keeps_what_was_chosen_where_more_is_added) {
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

TEST_F(import_saving, stays_open_over_what_was_changed_since) {
  open_page();
  guesses::TableChoices changed = page()->choice().choices;
  changed.offset_ns = 5;
  QObject::connect(feature().controller(), &gui::ImportController::saved, this_, [&] { page()->choose(changed); });
  button(*page(), "Save and open").click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench_.sessions().empty(); }, kPatience_ms));
  QTest::qWait(100);
  ASSERT_TRUE(page());
  EXPECT_TRUE(page()->choice().choices == changed);
}

TEST_F(import_saving, keeps_what_was_chosen_of_a_table_while_a_log_is_looked_at) {
  open_page();
  choose(1, ColumnRole::North);
  ASSERT_TRUE(checked());
  const guesses::TableChoices chosen = page()->choice().choices;
  emit page()->log_chosen();
  EXPECT_FALSE(page()->choice().table);
  emit page()->table_requested(folder_.filePath("motion.csv"));
  ASSERT_TRUE(checked());
  EXPECT_TRUE(page()->choice().choices == chosen);
}

TEST_F(import_saving, of_a_table_that_was_written_anew_with_other_columns_nothing_is_kept) {
  open_page();
  choose(1, ColumnRole::North);
  ASSERT_TRUE(checked());
  const guesses::TableChoices chosen = page()->choice().choices;
  std::string text = text_of(folder_.filePath("motion.csv"));
  text.replace(0, text.find(','), "other");
  std::ofstream(folder_.filePath("motion.csv").toStdString()) << text;
  feature().controller()->look_at({folder_.path()}, {});
  ASSERT_TRUE(QTest::qWaitFor([&] { return page()->choice().table && page()->checks().isEnabled(); }, kPatience_ms));
  EXPECT_FALSE(page()->choice().choices == chosen);
}

}  // namespace
}  // namespace remount::widgets
