#include "app/gui/features/setup_feature.h"

#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

#include "app/gui/document/result_files.h"
#include "app/gui/features/method_chooser.h"
#include "app/gui/features/topic_controller.h"
#include "app/gui/jobs/error_words.h"
#include "app/gui/shell/main_window.h"
#include "app/gui/workbench/wording.h"
#include "widgets/basics/file_dialogs.h"
#include "widgets/basics/remembering.h"
#include "widgets/forms/option_changes.h"
#include "widgets/project/options_dialog.h"
#include "widgets/result/nominal_panel.h"
#include "widgets/result/range_panel.h"
#include "widgets/sessions/session_list_model.h"
#include "widgets/sessions/sessions_panel.h"

namespace remount::gui {

SetupFeature::SetupFeature(MainWindow& window)
    : Feature(window),
      model_(new widgets::SessionListModel(&window)),
      sessions_(new widgets::SessionsPanel(*model_)),
      nominal_(new widgets::NominalPanel),
      range_(new widgets::RangePanel) {
  window.add_dock({.title = tr("Set-up"),
                   .name = "setup",
                   .content = make_column(),
                   .area = Qt::LeftDockWidgetArea,
                   .help_page = "setup",
                   .width = 320});
  new TopicController(workbench_, window);
  window.menus().add(MenuPlace::EditOptions, tr("&Options…"), tr("Ctrl+,"), [this] { show_options(); });
  connect_sessions();
  connect_setup();
  if (widgets::remembers() && QSettings().value("angles/radians").toBool()) set_angle_unit(widgets::AngleUnit::Radians);
  show_sessions();
}

QWidget* SetupFeature::make_column() {
  auto* column_widget = new QWidget;
  auto* column = new QVBoxLayout(column_widget);
  column->setContentsMargins(6, 4, 6, 4);
  const auto add = [&](const QString& title, QWidget* content, int stretch) {
    auto* group = new QGroupBox(title);
    auto* layout = new QVBoxLayout(group);
    layout->setContentsMargins(6, 4, 6, 6);
    layout->addWidget(content);
    column->addWidget(group, stretch);
  };
  add(tr("Sessions"), sessions_, 1);
  add(tr("Nominal mounting (LiDAR in the INS frame)"), nominal_, 0);
  add_method(*column);
  add_run(*column);
  add(tr("Search range"), range_, 0);
  return column_widget;
}

void SetupFeature::add_method(QVBoxLayout& column) {
  auto* chooser = new MethodChooser(workbench_);
  auto* label = new QLabel(tr("&Method"));
  label->setBuddy(chooser);
  auto* row = new QHBoxLayout;
  row->addWidget(label);
  row->addWidget(chooser, 1);
  column.addLayout(row);
}

void SetupFeature::add_run(QVBoxLayout& column) {
  run_ = new QPushButton(tr("Calibrate (F5)"));
  run_->setMinimumHeight(34);
  QFont bold = run_->font();
  bold.setBold(true);
  run_->setFont(bold);
  column.addWidget(run_);
  connect(run_, &QPushButton::clicked, &workbench_.calibrations(), &Calibrations::calibrate);
}

void SetupFeature::connect_sessions() {
  sessions_->set_open_menu(window_.menus().open_menu());
  connect(sessions_, &widgets::SessionsPanel::remove_requested, &workbench_.session_edits(), &SessionEdits::remove);
  connect(sessions_, &widgets::SessionsPanel::topics_requested, &workbench_.session_edits(),
          &SessionEdits::list_topics);
  connect(&workbench_.sessions(), &SessionList::changed, this, &SetupFeature::show_sessions);
  connect(&workbench_.overviews(), &DriveOverviews::changed, this,
          [this] { model_->show_drives(workbench_.overviews().all()); });
}

void SetupFeature::connect_setup() {
  Setup& setup = workbench_.setup();
  connect(nominal_, &widgets::NominalPanel::nominal_edited, &setup, &Setup::edit_nominal);
  connect(nominal_, &widgets::NominalPanel::file_requested, this, &SetupFeature::ask_for_nominal);
  connect(range_, &widgets::RangePanel::edited, &setup, &Setup::edit_option);
  connect(range_, &widgets::RangePanel::angle_unit_chosen, this, &SetupFeature::set_angle_unit);
  connect(range_, &widgets::RangePanel::reset_requested, &setup, &Setup::reset_range);
  connect(&workbench_.document(), &ProjectDocument::replaced, nominal_, &widgets::NominalPanel::forget_numbers);
  connect(&setup, &Setup::settings_changed, this, [this, &setup] { range_->show_settings(setup.settings()); });
  connect(&setup, &Setup::nominal_changed, this, [this, &setup] {
    nominal_->show_nominal(setup.nominal_ins_from_lidar());
    range_->show_nominal(setup.nominal_ins_from_lidar());
  });
}

void SetupFeature::show_sessions() {
  model_->show_sessions(workbench_.sessions().all());
  model_->show_drives(workbench_.overviews().all());
  model_->show_use(workbench_.outcome().output(), workbench_.outcome().input().sessions.size());
}

std::vector<TurnQueue::Piece> SetupFeature::show_output_later() {
  return {[this] {
    const OutputPtr output = workbench_.outcome().output();
    model_->show_use(output, workbench_.outcome().input().sessions.size());
    range_->show_result(output && calibration::is_usable(output->result)
                            ? std::optional(output->result.mounting.reference_from_sensor)
                            : std::nullopt);
  }};
}

void SetupFeature::show_state() {
  const Activity& activity = workbench_.activity();
  run_->setEnabled(!activity.opening() && !activity.calibrating() && !workbench_.sessions().empty());
  run_->setText(activity.calibrating()          ? tr("Calibrating…")
                : workbench_.outcome().output() ? tr("Calibrate again (F5)")
                                                : tr("Calibrate (F5)"));
}

void SetupFeature::show_palette(const QPalette& palette) { model_->set_palette(palette); }

void SetupFeature::set_angle_unit(widgets::AngleUnit unit) {
  angle_unit_ = unit;
  range_->set_angle_unit(unit);
  if (options_) options_->set_angle_unit(unit, workbench_.setup().settings());
  if (widgets::remembers()) QSettings().setValue("angles/radians", unit == widgets::AngleUnit::Radians);
}

void SetupFeature::ask_for_nominal() {
  const QString path = widgets::ask_for_file(&window_, tr("Nominal mounting from a result or an exported file"),
                                             widgets::FileKind::Mountings);
  if (path.isEmpty()) return;
  try {
    QStringList doubts;
    if (const auto nominals = nominals_from_file(path, workbench_, doubts); !nominals.empty())
      workbench_.vehicle().edit_nominals(nominals);
    else
      workbench_.setup().edit_nominal(nominal_from_file(path, workbench_, doubts));
    if (!doubts.isEmpty()) workbench_.notices().say(drive::Severity::Warning, path, doubts.join('\n'));
  } catch (const Error& error) {
    const JobFailure failure = failure_of(error);
    workbench_.notices().say(drive::Severity::Problem, failure.where, failure.what);
  }
}

void SetupFeature::show_options() {
  if (!options_) make_options();
  options_->show();
  options_->raise();
  options_->activateWindow();
}

void SetupFeature::make_options() {
  Setup& setup = workbench_.setup();
  options_ = new widgets::OptionsDialog(setup.settings(), &window_);
  connect(options_, &widgets::OptionsDialog::edited, &setup, &Setup::edit_option);
  connect(options_, &widgets::OptionsDialog::defaults_requested, this, &SetupFeature::ask_for_default_options);
  connect(&setup, &Setup::settings_changed, this, [this, &setup] { options_->show_settings(setup.settings()); });
  options_->set_angle_unit(angle_unit_, setup.settings());
  options_->addActions(window_.undo_actions());  // keys reach no other window by themselves
}

void SetupFeature::ask_for_default_options() {
  const QStringList changes = widgets::setting_changes(settings::Settings{}, workbench_.setup().settings());
  auto* question = new QMessageBox(QMessageBox::Question, tr("Restore default options"),
                                   tr("Set every option back to its default, the search range as well?"),
                                   QMessageBox::Cancel, options_);
  question->setObjectName(QStringLiteral("default-options"));
  question->setAttribute(Qt::WA_DeleteOnClose);
  if (!changes.isEmpty())
    question->setInformativeText(tr("Defaults that are changed: %1.").arg(in_short(changes, QStringLiteral("; "))));
  const QPushButton* restore = question->addButton(tr("Restore defaults"), QMessageBox::DestructiveRole);
  question->setDefaultButton(QMessageBox::Cancel);
  connect(restore, &QPushButton::clicked, &workbench_.setup(), &Setup::reset_settings);
  question->open();
}

}  // namespace remount::gui
