#include "widgets/panels/options_dialog.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>

#include "widgets/model_text.h"
#include "widgets/screen_room.h"
#include "widgets/theme.h"

namespace remount {
namespace {

QString title_of(const QString& section) {
  if (section == QLatin1String("run")) return OptionsDialog::tr("General");
  if (section == QLatin1String("keyframes")) return OptionsDialog::tr("Keyframes");
  if (section == QLatin1String("pairing")) return OptionsDialog::tr("Pairing");
  if (section == QLatin1String("objects")) return OptionsDialog::tr("Objects");
  if (section == QLatin1String("registration")) return OptionsDialog::tr("Alignment");
  if (section == QLatin1String("range")) return OptionsDialog::tr("Search range");
  if (section == QLatin1String("solve")) return OptionsDialog::tr("Solution");
  if (section == QLatin1String("measured")) return OptionsDialog::tr("Measured by hand");
  if (section == QLatin1String("lidar_odometry")) return OptionsDialog::tr("LiDAR odometry");
  if (section == QLatin1String("trajectory")) return OptionsDialog::tr("Trajectory alignment");
  if (section == QLatin1String("fusion")) return OptionsDialog::tr("Fusion odometry");
  if (section == QLatin1String("vehicle_frame")) return OptionsDialog::tr("Vehicle frame");
  if (section == QLatin1String("slew")) return OptionsDialog::tr("Slewing machine");
  return section;
}

}  // namespace

OptionsDialog::OptionsDialog(const Settings& settings, QWidget* parent) : QDialog(parent), problems_(new QLabel(this)) {
  setWindowTitle(tr("Options"));
  auto* sections = new QListWidget(this);
  sections->setAccessibleName(tr("Sections"));
  sections->setMaximumWidth(190);
  auto* pages = new QStackedWidget(this);
  QStringList seen;
  for (const OptionField& field : option_fields(settings)) {
    if (seen.contains(field.section)) continue;
    seen << field.section;
    sections->addItem(title_of(field.section));
    auto* form = new OptionForm(field.section, settings, this);
    connect(form, &OptionForm::edited, this, &OptionsDialog::edited);
    auto* scroll = new QScrollArea(this);
    scroll->setWidget(form);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    pages->addWidget(scroll);
    forms_.push_back(form);
  }
  connect(sections, &QListWidget::currentRowChanged, pages, &QStackedWidget::setCurrentIndex);
  sections->setCurrentRow(0);
  auto* note =
      new QLabel(tr("Search range and solution apply at once; the other options apply to the next calibration. "
                    "Every change can be undone (Ctrl+Z in the window)."),
                 this);
  note->setWordWrap(true);
  problems_->setWordWrap(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close | QDialogButtonBox::RestoreDefaults, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this,
          &OptionsDialog::defaults_requested);
  auto* grid = new QGridLayout(this);
  grid->addWidget(sections, 0, 0);
  grid->addWidget(pages, 0, 1);
  grid->addWidget(problems_, 1, 0, 1, 2);
  grid->addWidget(note, 2, 0, 1, 2);
  grid->addWidget(buttons, 3, 0, 1, 2);
  grid->setColumnStretch(1, 1);
  resize(within_screen(*this, {680, 580}));
  show_settings(settings);
}

void OptionsDialog::show_settings(const Settings& settings) {
  for (OptionForm* form : forms_) form->show_settings(settings);
  QStringList problems;
  for (const std::string& problem : settings.check()) problems << model_text(problem);
  problems_->setVisible(!problems.isEmpty());
  set_style(*problems_, "color: " + bad_color(palette()).name());
  problems_->setText(problems.join('\n'));
}

void OptionsDialog::set_angle_unit(AngleUnit unit, const Settings& settings) {
  for (OptionForm* form : forms_) form->set_angle_unit(unit, settings);
}

}  // namespace remount
