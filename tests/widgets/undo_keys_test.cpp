// Undo and redo by their keys, wherever the keyboard is.
#include <gtest/gtest.h>

#include <QApplication>
#include <QDoubleSpinBox>
#include <QLineEdit>

#include "tests/widgets/support/window_fixture.h"
#include "widgets/basics/gl_support.h"
#include "widgets/pairs/pairs_panel.h"
#include "widgets/project/options_dialog.h"
#include "widgets/result/export_dialog.h"
#include "widgets/result/range_panel.h"

namespace remount::widgets {
namespace {

using testing::kPatience_ms;

class undo_keys : public testing::WindowFixture {
 protected:
  void SetUp() override {
    if (!missing_gl_reason().isEmpty()) GTEST_SKIP() << "shortcuts need a window that can be active";
    show();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window_, kPatience_ms));
  }
  // Other tests are not to find Ctrl held down.
  void TearDown() override { QTest::keyClick(&window_, Qt::Key_Shift); }
  template <class Field>
  Field& field(const QString& name) {
    return *window_.findChild<Field*>(name);
  }
  static void type(QWidget& field, const QString& text) {
    field.setFocus();
    QTest::keyClick(&field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&field, text);
  }
  static void enter(QWidget& field, const QString& text) {
    type(field, text);
    QTest::keyClick(&field, Qt::Key_Return);
  }
  static void undo(QWidget& field) { QTest::keyClick(&field, Qt::Key_Z, Qt::ControlModifier); }
  static void redo(QWidget& field) { QTest::keyClick(&field, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier); }
  const calibration::SearchRange& range() const { return workbench_.setup().settings().range; }
};

TEST_F(undo_keys, take_the_edits_of_number_fields_back_while_one_has_the_keyboard) {
  auto& smallest = field<QDoubleSpinBox>("range.x_min_m");
  auto& largest = field<QDoubleSpinBox>("range.x_max_m");
  enter(smallest, "-1");
  enter(largest, "1.250");  // as it is shown afterwards: the field keeps its own steps of typing
  ASSERT_EQ(range().x_min_m, -1.0);
  ASSERT_EQ(range().x_max_m, 1.25);
  ASSERT_EQ(QApplication::focusWidget(), &largest);
  undo(largest);
  EXPECT_EQ(range().x_max_m, calibration::SearchRange{}.x_max_m);
  EXPECT_EQ(largest.value(), calibration::SearchRange{}.x_max_m);
  undo(largest);
  EXPECT_EQ(range().x_min_m, calibration::SearchRange{}.x_min_m);
  redo(largest);
  redo(largest);
  EXPECT_EQ(range().x_min_m, -1.0);
  EXPECT_EQ(range().x_max_m, 1.25);
}

TEST_F(undo_keys, export_opens_while_a_number_field_has_the_keyboard) {
  calibrate_drive();
  auto& largest = field<QDoubleSpinBox>("range.x_max_m");
  largest.setFocus();
  QTest::keyClick(&largest, Qt::Key_E, Qt::ControlModifier);
  auto* dialog = window_.findChild<ExportDialog*>();
  ASSERT_NE(dialog, nullptr);
  dialog->close();
}

TEST_F(undo_keys, take_back_what_is_typed_before_it_is_an_edit) {
  auto& largest = field<QDoubleSpinBox>("range.x_max_m");
  enter(field<QDoubleSpinBox>("range.x_min_m"), "-1");
  const QString shown = largest.text();
  type(largest, "2");
  ASSERT_NE(largest.text(), shown);
  for (int key = 0; key < 3 && largest.text() != shown; ++key) undo(largest);
  EXPECT_EQ(largest.text(), shown);
  EXPECT_EQ(range().x_min_m, -1.0) << "the work is taken back only when nothing typed is left";
  undo(largest);
  EXPECT_EQ(range().x_min_m, calibration::SearchRange{}.x_min_m);
}

TEST_F(undo_keys, take_decisions_back_while_the_filter_has_the_keyboard) {
  calibrate_drive();
  workbench_.decisions().decide({motion::PairIndex{5}}, motion::PairState::Rejected);
  workbench_.decisions().decide({motion::PairIndex{7}}, motion::PairState::Rejected);
  ASSERT_TRUE(settle());
  auto* filter = child<PairsPanel>().findChild<QLineEdit*>();
  filter->setFocus();
  undo(*filter);
  EXPECT_NE(pair(7).decided_by, motion::DecidedBy::User);
  EXPECT_EQ(pair(5).decided_by, motion::DecidedBy::User);
  QTest::keyClicks(filter, "x");
  undo(*filter);
  EXPECT_EQ(filter->text(), "");
  EXPECT_EQ(pair(5).decided_by, motion::DecidedBy::User) << "what was typed goes first";
  undo(*filter);
  EXPECT_NE(pair(5).decided_by, motion::DecidedBy::User);
  ASSERT_TRUE(settle());
}

TEST_F(undo_keys, work_in_the_window_of_the_options) {
  trigger("Ctrl+,");
  auto& options = child<OptionsDialog>();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&options, kPatience_ms));
  auto& voxel = *options.findChild<QDoubleSpinBox*>("registration.voxel_m");
  auto& gap = *options.findChild<QDoubleSpinBox*>("pairing.max_gap_s");
  const double voxel_before = voxel.value(), gap_before = gap.value();
  voxel.setValue(voxel_before + 0.1);
  gap.setValue(gap_before + 1.0);
  gap.setFocus();
  undo(gap);
  EXPECT_EQ(gap.value(), gap_before);
  EXPECT_NE(voxel.value(), voxel_before);
  undo(gap);
  EXPECT_EQ(voxel.value(), voxel_before);
}

}  // namespace
}  // namespace remount::widgets
