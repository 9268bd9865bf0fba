// Enter in a dialog is meant for the field that is being edited: no button that takes something away may hear it.
#include <gtest/gtest.h>

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>

#include "tests/widgets/support/window_fixture.h"
#include "widgets/project/options_dialog.h"
#include "widgets/project/recovery_dialog.h"
#include "widgets/quality/obstacle_dialog.h"
#include "widgets/sessions/missing_sessions_dialog.h"
#include "widgets/sessions/topics_dialog.h"
#include "widgets/shell/keys_dialog.h"

namespace remount::widgets {
namespace {

using testing::kPatience_ms;

class dialogs : public testing::WindowFixture {
 protected:
  OptionsDialog& shown_options() {
    trigger("Ctrl+,");
    auto& options = child<OptionsDialog>();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&options, kPatience_ms));
    return options;
  }
  QMessageBox* question() { return window_.findChild<QMessageBox*>("default-options"); }
  QPushButton& restore_defaults(OptionsDialog& options) {
    return *options.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::RestoreDefaults);
  }
};

TEST_F(dialogs, enter_in_an_option_ends_its_edit_and_nothing_else) {
  show();
  OptionsDialog& options = shown_options();
  auto& voxel = *options.findChild<QDoubleSpinBox*>("registration.voxel_m");
  const double changed = voxel.value() + 0.1;
  voxel.setValue(changed);
  QSignalSpy asked(&options, &OptionsDialog::defaults_requested);
  for (QWidget* field : options.findChildren<QAbstractSpinBox*>()) {
    field->setFocus();
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter}) QTest::keyClick(field, key);
  }
  QTest::keyClick(&options, Qt::Key_Return);
  EXPECT_EQ(asked.count(), 0);
  EXPECT_TRUE(options.isVisible());
  EXPECT_FALSE(question());
  EXPECT_EQ(workbench_.setup().settings().registration.voxel_m, changed);
}

TEST_F(dialogs, all_defaults_are_restored_after_a_question_whose_enter_says_no) {
  show();
  OptionsDialog& options = shown_options();
  EXPECT_FALSE(restore_defaults(options).isEnabled()) << "there is nothing to restore";
  options.findChild<QDoubleSpinBox*>("registration.voxel_m")->setValue(0.7);
  ASSERT_TRUE(restore_defaults(options).isEnabled());
  restore_defaults(options).click();
  ASSERT_TRUE(question());
  ASSERT_TRUE(QTest::qWaitForWindowActive(question(), kPatience_ms));
  EXPECT_TRUE(question()->informativeText().contains("now 0.7")) << question()->informativeText().toStdString();
  photograph(*question(), "43-restore-defaults");
  QTest::keyClick(question(), Qt::Key_Return);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !question(); }, kPatience_ms));
  EXPECT_EQ(workbench_.setup().settings().registration.voxel_m, 0.7);
  restore_defaults(options).click();
  ASSERT_TRUE(question());
  for (QAbstractButton* button : question()->buttons())
    if (question()->buttonRole(button) == QMessageBox::DestructiveRole) button->click();
  EXPECT_EQ(workbench_.setup().settings().registration.voxel_m, settings::Settings{}.registration.voxel_m);
  workbench_.history().stack().undo();
  EXPECT_EQ(workbench_.setup().settings().registration.voxel_m, 0.7);
}

TEST_F(dialogs, none_has_a_button_that_enter_takes_something_away_by) {
  RecoveryDialog recovery({{"calibration", "a session", {"now"}}, {"older", "a session", {"now"}}}, &window_);
  MissingSessionsDialog missing("/data/job.remount", {"/data/drive1"}, &window_);
  KeysDialog keys({}, &window_);
  TopicsDialog topics("drive.bag", {}, &window_);
  ObstacleDialog obstacles("scan 1", true, {}, &window_);
  OptionsDialog options(workbench_.setup().settings(), &window_);
  for (QDialog* dialog : std::initializer_list<QDialog*>{&recovery, &missing, &keys, &topics, &obstacles, &options}) {
    dialog->show();
    for (const QPushButton* button : dialog->findChildren<QPushButton*>()) {
      const auto* box = qobject_cast<QDialogButtonBox*>(button->parentWidget());
      const auto role = box ? box->buttonRole(const_cast<QPushButton*>(button)) : QDialogButtonBox::InvalidRole;
      const bool takes_away = role == QDialogButtonBox::ResetRole || role == QDialogButtonBox::DestructiveRole ||
                              button->text() == RecoveryDialog::tr("Discard") ||
                              button->text() == MissingSessionsDialog::tr("Open without them");
      if (!takes_away) continue;
      EXPECT_FALSE(button->isDefault() || button->autoDefault())
          << dialog->metaObject()->className() << ": " << button->text().toStdString();
    }
  }
}

}  // namespace
}  // namespace remount::widgets
