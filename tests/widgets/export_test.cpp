// What is copied, what is shown and what is saved are the same text, and its numbers are those of the result.
#include <gtest/gtest.h>

#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <QPushButton>
#include <QTemporaryDir>

#include "app/gui/document/result_files.h"
#include "model/results/exporters/exporter.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/result/export_dialog.h"

namespace remount::widgets {
namespace {

using export_window = testing::WindowFixture;

TEST_F(export_window, the_copied_matrix_is_the_exported_one_to_the_last_digit) {
  const QTemporaryDir folder;
  show();
  calibrate_drive();
  trigger("Ctrl+E");
  auto& dialog = child<ExportDialog>();
  dialog.choose("matrix");
  for (auto* button : dialog.findChildren<QPushButton*>())
    if (button->text() == ExportDialog::tr("Copy")) button->click();
  const QString copied = QGuiApplication::clipboard()->text();
  ASSERT_FALSE(copied.isEmpty());
  EXPECT_EQ(copied, dialog.current_text()) << "what is shown";
  const QString path = folder.filePath("matrix.txt");
  emit dialog.save_requested("matrix", path, dialog.current_text());
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_EQ(QString::fromUtf8(file.readAll()), copied) << "what is saved";
  EXPECT_TRUE(texts_of(dialog).contains(path)) << "the dialog says so itself, for it covers the window";
  const QString nowhere = folder.filePath("no/such/folder/matrix.txt");
  emit dialog.save_requested("matrix", nowhere, dialog.current_text());
  EXPECT_TRUE(texts_of(dialog).contains("✕")) << texts_of(dialog).toStdString();
  const int width = dialog.width();
  emit dialog.save_requested("matrix", folder.filePath(QString(250, 'x') + "/matrix.txt"), dialog.current_text());
  QCoreApplication::processEvents();  // a layout asked for now is done now
  EXPECT_EQ(dialog.width(), width) << "whatever the path";
  dialog.choose("yaml");
  EXPECT_FALSE(texts_of(dialog).contains("✕"));
  dialog.choose("matrix");
  const RigidTransform read = results::exporter("matrix").read(copied.toStdString(), "clipboard");
  EXPECT_EQ(read.matrix(), workbench_.outcome().output()->result.mounting.reference_from_sensor.matrix())
      << "not one bit is lost";
  dialog.close();
  trigger("Ctrl+Shift+C");
  EXPECT_TRUE(QGuiApplication::clipboard()->text().contains(gui::export_text(workbench_, "matrix").trimmed()))
      << "the copied result ends with the same matrix";
}

TEST_F(export_window, what_is_saved_is_the_result_of_then_however_long_the_dialog_was_open) {
  show();
  calibrate_drive();
  trigger("Ctrl+E");
  auto& dialog = child<ExportDialog>();
  dialog.choose("yaml");
  const QString before = dialog.current_text();
  workbench_.decisions().decide({motion::PairIndex{0}, motion::PairIndex{1}, motion::PairIndex{2}},
                                motion::PairState::Rejected);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench_.activity().solving(); }, testing::kPatience_ms));
  EXPECT_NE(dialog.current_text(), before);
  EXPECT_EQ(dialog.current_text(), gui::export_text(workbench_, dialog.current_id()));
  workbench_.session_edits().remove(motion::SessionIndex{0});
  EXPECT_FALSE(dialog.isVisible()) << "there is nothing to export any more";
}

}  // namespace
}  // namespace remount::widgets
